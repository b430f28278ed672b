"""The quantities of the paper, and the symbols they are written in.

Rollers stand in the frame of their plane: spin and slip know no other. "The i-th roller" is one of
two whose order is free, so that what is derived for it holds for both; rollers 1 and 2 have the
angle from one contact to the other between 0 and 180 degrees, as the normal e asks for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cache
from typing import Any, TypeAlias

from sympy import Expr, ImmutableMatrix, Integer, acos, linsolve, symbols, tan

from omniproof.kinematics import sphere
from omniproof.papers.two_roller_sphere.arrangement import (
    POLE,
    SPEED,
    Roller,
    spin_of,
    tidied,
    travelling,
)
from omniproof.papers.two_roller_sphere.symbols import (
    ALONG,
    ANGLES,
    AXIS_ANGLE,
    BETWEEN,
    RADIUS,
    RIM_SPEEDS,
    SYMBOLS,
)
from omniproof.registry import Registry

REGISTRY = Registry("two-roller-sphere", symbols=SYMBOLS)
Vanishing: TypeAlias = tuple[Expr, ...]


def vanishing(entries: Iterable[Expr]) -> Vanishing:
    """Expressions that are all to be zero."""
    return (Integer(0), *entries)


ROLLER, FIRST, SECOND = (
    Roller(azimuth, angle, speed)
    for azimuth, angle, speed in zip(
        (Integer(0), Integer(0), BETWEEN), ANGLES, RIM_SPEEDS, strict=True
    )
)
OTHER = Roller(*symbols("gamma alpha_j nu_j", real=True))
PAIR = (FIRST, SECOND)

ANY_SPIN = ImmutableMatrix(symbols("w_1:4", real=True))
"""Any spin, rad/s."""


@cache
def spin() -> ImmutableMatrix:
    """Spin by the rim speeds of the i-th and the other roller: 3x1, rad/s."""
    return spin_of([ROLLER, OTHER])


@cache
def spin_of_pair() -> ImmutableMatrix:
    """Spin by the rim speeds of rollers 1 and 2: 3x1, rad/s."""
    return spin_of(PAIR)


@cache
def allowed_spin() -> ImmutableMatrix:
    """Any spin that does not slip on the i-th roller alone: 3x1, rad/s."""
    foot, _ = ROLLER.line
    return ImmutableMatrix(foot + ALONG * ROLLER.contact)


def height(roller: Roller) -> Expr:
    """Height of a roller's line over the plane of the rollers, rad/s."""
    return roller.line[0].dot(POLE)


def part_along(roller: Roller) -> Expr:
    """Component along the tangent of all spins on a roller's line, rad/s."""
    return roller.line[0].dot(roller.tangent)


@cache
def coefficients() -> tuple[Expr, Expr]:
    """Multiples of both contacts in the common point of the projected lines, rad/(m s)."""
    unknown = symbols("C_1 C_2", real=True)
    point = unknown[0] * FIRST.contact + unknown[1] * SECOND.contact
    equations = [point.dot(roller.tangent) - part_along(roller) for roller in PAIR]
    ((first, second),) = linsolve(equations, unknown)
    found = tidied(ImmutableMatrix([first, second]))
    return found[0], found[1]


@cache
def common_point() -> ImmutableMatrix:
    """Common point of the projected lines of rollers 1 and 2: 3x1, rad/s."""
    first, second = coefficients()
    return tidied(first * FIRST.contact + second * SECOND.contact)


@cache
def columns() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Spins for the rim speed 1 of roller 1, and of roller 2: 3x1 each, rad/m."""
    matrix = sphere.spin_map([r.direction for r in PAIR], [r.axis for r in PAIR], RADIUS)
    return tidied(matrix[:, 0]), tidied(matrix[:, 1])


def world_spin() -> ImmutableMatrix:
    """Spin of the sphere that rolls on the ground, by the angle of its axis: 3x1, rad/s."""
    return ImmutableMatrix(travelling(SPEED / RADIUS * tan(AXIS_ANGLE)).rotation)


def with_spin(turning: ImmutableMatrix) -> Mapping[str, Any]:
    """What the spin gives at the i-th roller."""
    slip = ROLLER.slip(turning)
    return {
        "omega": turning,
        "m_S": ROLLER.surface_velocity(turning),
        "psi_i": slip,
        "S_i": slip.dot(ROLLER.tangent),
    }


def any_spin() -> Mapping[str, Any]:
    """Meanings for a spin that nothing restricts."""
    return with_spin(ANY_SPIN)


def on_one_roller() -> Mapping[str, Any]:
    """Meanings for a spin that does not slip on a single roller."""
    return with_spin(allowed_spin())


def by_both_rollers() -> Mapping[str, Any]:
    """Meanings for the spin that rollers 1 and 2 make."""
    return {"omega": spin_of_pair()}


def in_the_world() -> Mapping[str, Any]:
    """Meanings for the spin of the sphere that rolls on the ground."""
    return {"omega": world_spin()}


def _means(name: str, value: Callable[..., Any]) -> None:
    REGISTRY.quantity(name)(value)


for _name in ("omega", "m_S", "psi_i", "S_i"):
    _means(_name, lambda name=_name: with_spin(spin())[name])
for _k, _axis in enumerate("xyz"):
    _means(f"omega_{_axis}", lambda k=_k: world_spin()[k])
_means("omega_t", common_point)
_means("omega_s", lambda: spin_of_pair().dot(POLE) * POLE)
_means("m_R", lambda: ROLLER.velocity)
_means("eta_i", lambda: ROLLER.axis)
_means("e_i", lambda: ROLLER.driven)
_means("e", lambda: POLE)
for _index, _roller in (("i", ROLLER), ("1", FIRST), ("2", SECOND)):
    _means(f"P_{_index}", lambda roller=_roller: roller.contact)
    _means(f"X_{_index}", lambda roller=_roller: roller.tangent)
_means("V", lambda: travelling(AXIS_ANGLE).velocity)
_means("X", lambda: columns()[1])
_means("Y", lambda: columns()[0])
_means("C_1", lambda: coefficients()[0])
_means("C_2", lambda: coefficients()[1])
_means("angle_12", lambda: acos(FIRST.tangent.dot(SECOND.direction)))
_means("angle_21", lambda: acos(SECOND.tangent.dot(FIRST.direction)))
