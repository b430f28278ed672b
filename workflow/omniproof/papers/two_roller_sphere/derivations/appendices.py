"""Appendices A and B: the point nearest to two lines, and the part of the spin in the plane."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from sympy import Expr, ImmutableMatrix, Integer, Symbol, acos, cos, linsolve, pi, symbols

from omniproof.kinematics import sphere
from omniproof.papers.two_roller_sphere.arrangement import POLE, tidied
from omniproof.papers.two_roller_sphere.derivations.quantities import (
    ANY_SPIN,
    FIRST,
    PAIR,
    REGISTRY,
    ROLLER,
    SECOND,
    Vanishing,
    coefficients,
    height,
    part_along,
    spin,
    spin_of_pair,
    vanishing,
)
from omniproof.papers.two_roller_sphere.derivations.rollers import feet, part_in_plane
from omniproof.papers.two_roller_sphere.symbols import ALONG, BETWEEN, DISTANCES, LEAST, RADIUS
from omniproof.registry import Family, Obligation, Relation
from omniproof.transcription.model import Form

SUM = ALONG
"""Sum of both distances (rad/s): the paper has one letter for it and the place on a line."""


def squared_distances(point: ImmutableMatrix) -> tuple[Expr, ...]:
    """Squared distances of a point to the lines of rollers 1 and 2."""
    return sphere.squared_distances(
        point,
        [roller.direction for roller in PAIR],
        [roller.axis for roller in PAIR],
        [roller.speed for roller in PAIR],
        RADIUS,
    )


@REGISTRY.derives("app:A/feet")
def way_between_feet() -> Vanishing:
    """Way between the feet and the least-squares spin, along both lines."""
    ways = [foot - spin_of_pair() for foot in feet()]
    return vanishing(way.dot(roller.direction) for way in ways for roller in PAIR)


@REGISTRY.derives("app:A/lemma-1")
def point_of_every_set() -> Vanishing:
    """Squared distances of a point below line 1 on the common perpendicular, less the expected.

    With line 2 higher by k_0, the point at (k - k_0)/2 below has the distances (k - k_0)/2 and
    (k + k_0)/2. So for every k >= k_0 some point has d_1 + d_2 = k; and a point has one such sum.
    """
    least = height(SECOND) - height(FIRST)
    below = (SUM - least) / 2
    first, second = squared_distances(ImmutableMatrix(feet()[0] - below * POLE))
    return vanishing([first - below**2, second - (below + least) ** 2])


@REGISTRY.derives("app:A/lemma-2")
def distances_of_any_point() -> Vanishing:
    """Squared distances of any point, less squared heights over the lines and distances in plane.

    So no distance is less than the difference of heights, and the triangle inequality gives the
    sum of both as at least the difference of the heights of the lines, k_0.
    """
    found = squared_distances(ANY_SPIN)
    parts = (
        (ANY_SPIN.dot(POLE) - height(roller)) ** 2
        + (ANY_SPIN.dot(roller.tangent) - part_along(roller)) ** 2
        for roller in PAIR
    )
    return vanishing(a - b for a, b in zip(found, parts, strict=True))


@REGISTRY.derives("app:A/equivalent")
def free_distances() -> Vanishing:
    """Squared distances of the point with any height and distances in the plane, less these.

    Three numbers z, u_1, u_2 are free. For d_1 + d_2 >= k_0 there is a height with |z - h_i| <= d_i
    for both lines, and u_i makes up for the rest: every pair of distances of (B) occurs in (A).
    """
    level = symbols("u_1 u_2", real=True)
    top = Symbol("z", real=True)
    unknown = symbols("a_1 a_2", real=True)
    point = unknown[0] * FIRST.direction + unknown[1] * SECOND.direction
    rows = [
        point.dot(roller.tangent) - part_along(roller) - u
        for roller, u in zip(PAIR, level, strict=True)
    ]
    ((*solved,),) = linsolve(rows, unknown)
    chosen = ImmutableMatrix(point.subs(dict(zip(unknown, solved, strict=True))) + top * POLE)
    expected = [(top - height(roller)) ** 2 + u**2 for roller, u in zip(PAIR, level, strict=True)]
    return vanishing(a - b for a, b in zip(squared_distances(chosen), expected, strict=True))


@REGISTRY.derives("app:A/tangent")
def sum_on_line() -> Family:
    """Sum of the squared distances where they add up to one, by the first of them."""
    first = DISTANCES[0]
    return Family(first**2 + (1 - first) ** 2, {first: (Integer(0), Integer(1))})


def at_the_midpoint() -> Mapping[str, Any]:
    """Both distances at the point of contact."""
    return {"d_1": LEAST / 2, "d_2": LEAST / 2}


@REGISTRY.derives("app:A/circle", meanings=at_the_midpoint)
def squared_radius() -> Expr:
    """Sum of the squared distances of the midpoint, which is in proportion to the squared gap."""
    gap = height(SECOND) - height(FIRST)
    total = sum(squared_distances(spin_of_pair()), Integer(0))
    return tidied(ImmutableMatrix([total / gap**2]))[0] * LEAST**2


@REGISTRY.derives("app:A/sum-of-squares")
def sum_of_squares() -> Expr:
    """Sum over both distances."""
    return sum((distance**2 for distance in DISTANCES), Integer(0))


# Appendix B


# (B.4) and (B.5) take cosines of it, which do not see the sign.
@REGISTRY.derives("eq:B.1", idle=True)
def angle_to_tangent() -> Relation:
    """Angle between tangent 1 and contact 2, and the angle between the contacts less 90 degrees."""
    cosine = FIRST.tangent.dot(SECOND.direction)
    less = BETWEEN - pi / 2
    return Relation(
        (less, acos(cosine)),
        condition=r"\angle P_1OP_2 \geq 90^\circ",
        proof=(
            Obligation(Form.EQUAL, (cosine, cos(less))),
            Obligation(Form.POSITIVE, Family(less, {BETWEEN: (pi / 2, pi)})),
        ),
    )


@REGISTRY.derives("eq:B.2", rests_on=["eq:B.1"])
def cosines_of_tangents() -> tuple[Expr, Expr]:
    """Cosine of the angle between tangent 2 and contact 1, and minus that of the other angle."""
    return SECOND.tangent.dot(FIRST.direction), -FIRST.tangent.dot(SECOND.direction)


@REGISTRY.derives("eq:B.3")
def sine_between() -> Expr:
    """Component along the normal of the cross product of both directions."""
    return FIRST.direction.cross(SECOND.direction).dot(POLE)


@REGISTRY.derives("eq:B.4", rests_on=["eq:B.1"])
def second_along_first() -> Expr:
    """Contact 2 along tangent 1."""
    return SECOND.contact.dot(FIRST.tangent)


@REGISTRY.derives("eq:B.5")
def first_along_second() -> Expr:
    """Contact 1 along tangent 2."""
    return FIRST.contact.dot(SECOND.tangent)


@cache
def any_tangent() -> ImmutableMatrix:
    """Tangent at any azimuth, for what holds at both rollers."""
    return sphere.tangent_base(Symbol("beta", real=True), 0)[0]


@REGISTRY.derives("eq:B.7", meanings=lambda: {"X_i": any_tangent()})
def part_along_any_tangent() -> Expr:
    """Part of the spin in the plane, along any tangent."""
    return part_in_plane().dot(any_tangent())


def of_either_roller() -> Mapping[str, Any]:
    """Meanings for the i-th roller and the other one."""
    return {"omega_t": spin() - spin().dot(POLE) * POLE}


@REGISTRY.derives("eq:B.8", meanings=of_either_roller)
def part_along_tangent() -> Expr:
    """Component of all spins on the roller's line along its tangent."""
    return part_along(ROLLER)


@REGISTRY.derives("app:B/perpendicular")
def contact_along_tangent() -> Expr:
    """A contact along its own tangent, at any azimuth."""
    direction = sphere.contact_direction(Symbol("beta", real=True), 0)
    return RADIUS * direction.dot(any_tangent())


@REGISTRY.derives("eq:B.9/first")
def part_along_second() -> Expr:
    """Component along tangent 2."""
    return part_in_plane().dot(SECOND.tangent)


@REGISTRY.derives("eq:B.9/second")
def part_along_first() -> Expr:
    """Component along tangent 1."""
    return part_in_plane().dot(FIRST.tangent)


@REGISTRY.derives("eq:B.10/first")
def multiple_of_first() -> Expr:
    """Multiple of contact 1."""
    return coefficients()[0]


@REGISTRY.derives("eq:B.10/second")
def multiple_of_second() -> Expr:
    """Multiple of contact 2."""
    return coefficients()[1]
