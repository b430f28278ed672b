r"""Two mirrored rollers with opposite angles, driven so that the sphere rolls along a direction.

The plane of the rollers contains the x-axis and is tilted: its normal e leans by tau from the
vertical towards y. The contacts lie h to either side of the middle between them. Rolling fixes the
level part of the spin, the rollers allow two dimensions of spins: the rim speeds and the spin about
the vertical follow from three linear equations.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from sympy import (
    Expr,
    ImmutableMatrix,
    Integer,
    Symbol,
    cancel,
    construct_domain,
    cos,
    linear_eq_to_matrix,
    pi,
    rad,
    sin,
    sqrt,
    symbols,
)
from sympy.polys.matrices import DomainMatrix

from omniproof.kinematics import frames, sphere
from omniproof.papers.two_roller_sphere.arrangement import (
    SPEED,
    Roller,
    spin_of,
    tidied,
    travelling,
)
from omniproof.papers.two_roller_sphere.symbols import DIRECTION, RADIUS

HALF, TILT, ANGLE = symbols("h tau alpha_1", real=True)
"""Half the angle between the contacts, tilt of their plane, angle of roller 1 (rad)."""

ANGLES = tuple(rad(degrees) for degrees in (0, 10, 20, 30))
"""The four angles of roller 1 in the simulation."""

CONTACTS = tuple(sphere.contact_direction(rad(azimuth), rad(60)) for azimuth in (215, 325))
"""The contacts of the simulation, both at the elevation 60 degrees: 3x1 each."""


def frame() -> ImmutableMatrix:
    """Frame of the rollers' plane in the world, columns middle, x and e: 3x3."""
    middle = ImmutableMatrix([0, -cos(TILT), sin(TILT)])
    return ImmutableMatrix.hstack(middle, frames.UNIT["x"], middle.cross(frames.UNIT["x"]))


def rollers(first: Expr, second: Expr) -> tuple[Roller, Roller]:
    """Both rollers with their rim speeds (m/s)."""
    return Roller(-HALF, ANGLE, first), Roller(HALF, -ANGLE, second)


@cache
def solution() -> tuple[Expr, Expr, Expr]:
    """Rim speeds (m/s) and spin about the vertical (rad/s) with which the sphere travels."""
    first, second, vertical = unknown = symbols("nu_1 nu_2 omega_z", real=True)
    allowed = frame() * spin_of(rollers(first, second))
    rolled = travelling(vertical).rotation
    return tuple(_by_direction(value) for value in _solved(list(allowed - rolled), unknown))


def _solved(zeros: Sequence[Expr], unknown: Sequence[Symbol]) -> list[Expr]:
    """Solve linear equations for as many unknowns, sines and cosines taken as independent.

    SymPy's `linsolve` expects relations between a sine and its cosine, so it cancels expressions
    after each step: of an altered mechanics that takes a hundred times as long.
    """
    count = len(unknown)
    left, right = linear_eq_to_matrix(zeros, unknown)
    field, entries = construct_domain([*left, *right], field=True, composite=True)
    matrix = DomainMatrix.from_list_flat(entries[: count**2], (count, count), field)
    column = DomainMatrix.from_list_flat(entries[count**2 :], (count, 1), field)
    return list(matrix.lu_solve(column).to_Matrix())


def _by_direction(value: Expr) -> Expr:
    """Write what is linear in the velocity by its values for travel along x and along y."""
    along_x, along_y = (value.subs(DIRECTION, turn) for turn in (0, pi / 2))
    return cancel(along_x) * cos(DIRECTION) + cancel(along_y) * sin(DIRECTION)


def rim_speed(roller: int) -> Expr:
    """Rim speed of roller 1 or 2, m/s."""
    return solution()[roller - 1]


def spin() -> ImmutableMatrix:
    """Spin of the sphere in the world: 3x1, rad/s."""
    return ImmutableMatrix(travelling(solution()[2]).rotation)


@cache
def slip(roller: int) -> Expr:
    """Component of the slip of roller 1 or 2 along its X, m/s."""
    both = rollers(*solution()[:2])
    chosen = both[roller - 1]
    along = chosen.slip(spin_of(both)).dot(chosen.tangent)
    return tidied(ImmutableMatrix([along]))[0]


@cache
def in_simulation(expression: Expr, case: int | None = None) -> Expr:
    """Put in the contacts, the radius and the speed of the simulation, and the angle of a case."""
    first, second = CONTACTS
    normal = first.cross(second)  # of length 2 sin(h) cos(h)
    sine = (second - first)[0] / 2
    half = {sin(HALF): sine, cos(HALF): sqrt(1 - sine**2), RADIUS: Integer(1), SPEED: Integer(1)}
    tilt = {sin(TILT): normal[1], cos(TILT): normal[2]}
    length = 2 * sine * cos(HALF)
    placed = cancel(expression.subs({key: entry / length for key, entry in tilt.items()}))
    angle = {} if case is None else {ANGLE: ANGLES[case]}
    return placed.subs(half).subs(angle)
