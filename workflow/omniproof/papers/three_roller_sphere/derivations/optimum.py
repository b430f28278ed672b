"""Section 2.2, by mechanics: the sum of the squared distances, its coefficients, its one minimum.

What is derived comes from the normal equations of the slips; what is printed, from distances to
lines. The elimination that leads from the coefficients to the optimum has a module of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import combinations
from typing import TypeAlias

from sympy import Expr, ImmutableMatrix, Integer, diff, pi, sqrt, zeros

from omniproof.kinematics import sphere
from omniproof.papers.three_roller_sphere.derivations.premises import vanishing
from omniproof.papers.three_roller_sphere.derivations.quantities import (
    REGISTRY,
    ROLLER,
    sum_at,
)
from omniproof.papers.three_roller_sphere.rollers import ROLLERS, Roller
from omniproof.papers.three_roller_sphere.symbols import POINT, RADIUS
from omniproof.registry import Obligation, Relation
from omniproof.transcription.model import Form

Equations: TypeAlias = tuple[ImmutableMatrix, ImmutableMatrix]
"""Matrix (3x3) and right side (3x1, rad/s) of normal equations."""


def equations_of(rollers: Sequence[Roller]) -> Equations:
    """Normal equations of the squared slips of rollers, over the squared radius."""
    contacts, axes, speeds = zip(*((r.contact, r.axis, r.speed) for r in rollers), strict=True)
    return sphere.normal_matrix(contacts), sphere.right_side(contacts, axes, speeds, RADIUS)


@cache
def normal_equations() -> Equations:
    """Those of three rollers."""
    return equations_of(ROLLERS)


def excess_slope(squares: Expr, equations: Equations) -> tuple[Expr, ...]:
    """Slope of a sum of squares at any spin, less that of normal equations: all zero."""
    matrix, feet = equations
    rates = ImmutableMatrix([diff(squares, coordinate) for coordinate in POINT])
    return vanishing(rates - 2 * (matrix * POINT - feet))


@REGISTRY.derives("sec:2.2/lines")
def number_of_lines() -> Expr:
    """Count the rollers: each has a line."""
    return Integer(len([roller.line() for roller in ROLLERS]))


def sum_of_slips(spin: ImmutableMatrix) -> Expr:
    """Sum of the squared slips (over the squared radius) at a spin (3x1, rad/s)."""
    slips = [roller.slip(spin) for roller in ROLLERS]
    return sum((slip.dot(slip) for slip in slips), Integer(0)) / RADIUS**2


@REGISTRY.derives("eq:5")
def sum_of_squares() -> Expr:
    """Sum of the squared slips at any spin."""
    return sum_of_slips(POINT)


@REGISTRY.derives("eq:6")
def distance() -> Expr:
    """Slip of one roller at any spin, over the radius."""
    slip = ROLLER.slip(POINT)
    return sqrt(slip.dot(slip)) / RADIUS


@REGISTRY.derives("sec:2.2/least-value")
def slope_of_sum() -> tuple[Expr, ...]:
    """Slope of the sum of the squared distances of three rollers."""
    return excess_slope(sum_at(*POINT), normal_equations())


@REGISTRY.derives("sec:1/arbitrary-arrangement")
def slope_of_slip() -> tuple[Expr, ...]:
    """Slope of the squared slip of one roller anywhere: those of several add up."""
    slip = ROLLER.slip(POINT)
    return excess_slope(slip.dot(slip) / RADIUS**2, equations_of([ROLLER]))


_MIXED = {4: (0, 1), 5: (1, 2), 6: (0, 2)}
"""Row and column of the mixed coefficients, in the paper's order."""


def coefficient(k: int) -> Expr:
    """Coefficient of the sum of the squared distances, in the paper's order from 1 to 10."""
    matrix, feet = normal_equations()
    if k == 10:
        return sum_of_slips(zeros(3, 1))
    if k in _MIXED:
        return 2 * matrix[_MIXED[k]]
    return matrix[k - 1, k - 1] if k < 4 else -2 * feet[k - 7]


for _k in range(1, 11):
    REGISTRY.quantity(f"C_{_k}")(lambda k=_k: coefficient(k))
    REGISTRY.derives(f"eq:10/c-{_k}")(lambda k=_k: coefficient(k))


def determinant(rollers: Sequence[Roller]) -> Expr:
    """Determinant of the normal equations."""
    return sphere.normal_matrix([r.contact for r in rollers]).det(method="berkowitz")


def _as_sum_of_squares() -> Expr:
    """Twice the squared sines between contacts, and what is zero only where all are on one line.

    No cosine exceeds one, so that no term is negative, and the sines vanish together only if every
    two contacts lie on one line through the centre.
    """
    pairs = list(combinations((roller.contact for roller in ROLLERS), 2))
    sines = (a.cross(b) for a, b in pairs)
    product = Integer(1)
    for a, b in pairs:
        product *= a.dot(b)
    return 2 * sum((s.dot(s) for s in sines), Integer(0)) + 2 * (1 - product)


@REGISTRY.derives("sec:2.2/optimal-point")
def uniqueness() -> Relation:
    """Determinants for contacts on the equator: a third of a turn apart, and at one place."""
    level = Integer(0)
    spread, gathered = (
        [Roller(k * apart, level, level, level) for k in range(3)] for apart in (2 * pi / 3, level)
    )
    return Relation(
        (determinant(spread), determinant(gathered)),
        condition=r"\text{the contacts do not all lie on one line through the centre}",
        proof=(Obligation(Form.EQUAL, (determinant(ROLLERS), _as_sum_of_squares())),),
    )
