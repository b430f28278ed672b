"""Section 3: spins and slips of the four patterns in closed form, against the printed numbers.

The slip of a roller runs round an ellipse: its level and its upright part are a quarter turn apart,
so that the least and the greatest slip are the greatest values of both parts.
"""

from __future__ import annotations

from functools import cache

from sympy import Expr, ImmutableMatrix, Integer, Symbol, cancel, cos, expand, pi, sin, sqrt

from omniproof.papers.three_roller_sphere.derivations.premises import vanishing
from omniproof.papers.three_roller_sphere.derivations.quantities import REGISTRY
from omniproof.papers.three_roller_sphere.rollers import (
    AZIMUTHS,
    ELEVATION,
    ELEVATIONS,
    LEVEL,
    ROLLERS,
    Roller,
    input_speed,
    pattern,
    pattern_slips,
    pattern_spin,
)
from omniproof.papers.three_roller_sphere.symbols import PHI
from omniproof.registry import Curve, Obligation, Relation
from omniproof.transcription.model import Form

TURN = {PHI: (Integer(0), 2 * pi)}
SLIPPING = (2, 3, 4)
"""Patterns above the equator."""


def slip_along(direction: int) -> Expr:
    """Greatest part (m/s) of a roller's slip along a tangent (1 level, 2 upright), any elevation.

    The level part is greatest a quarter turn after the upright one, which is greatest where the
    parameter is the azimuth of the roller.
    """
    chosen = pattern()[-1]
    place = chosen.azimuth + (2 - direction) * pi / 2
    slip = pattern_slips()[-1].subs(PHI, place)
    part = slip.dot(ImmutableMatrix(chosen.frame[:, direction]))
    return cancel(expand(part).subs(cos(ELEVATION) ** 2, 1 - sin(ELEVATION) ** 2))


@cache
def extrema() -> tuple[Expr, Expr]:
    """Least and greatest slip (m/s) of each roller, for elevations from 0 to a right angle."""
    return slip_along(2), slip_along(1)


def at_pattern(k: int, value: Expr) -> Expr:
    """Value at the elevation of the k-th pattern."""
    return value.subs(ELEVATION, ELEVATIONS[k - 1])


def _size(vector: ImmutableMatrix) -> Expr:
    return sqrt(vector.dot(vector))


for _k in (1, 2, 3):
    REGISTRY.quantity(f"v_{_k}", of=[PHI])(lambda k=_k: input_speed(AZIMUTHS[k - 1]))
    REGISTRY.derives(f"sec:3/input-{_k}")(lambda k=_k: input_speed(AZIMUTHS[k - 1]))
    REGISTRY.quantity(f"zeta_{_k}")(lambda k=_k: pattern_slips(ELEVATIONS[0])[k - 1])
    REGISTRY.derives(f"sec:3/nonslip-{_k}")(lambda: Integer(0))


@REGISTRY.derives("sec:3/number-of-patterns")
def number_of_patterns() -> Expr:
    """Count the elevations."""
    return Integer(len(ELEVATIONS))


@REGISTRY.derives("sec:3/rollers-of-psi")
def number_of_rollers() -> Expr:
    """Count the rollers of a pattern."""
    return Integer(len(pattern()))


@REGISTRY.derives("sec:3/rollers-of-theta", rests_on=["sec:3/rollers-of-psi"])
def number_of_rollers_again() -> Expr:
    """As for the angles of the axes."""
    return number_of_rollers()


@REGISTRY.derives("sec:3/regular-triangle")
def regular_triangles() -> Relation:
    """Azimuths of all regular triangles: the three sides are equally long."""
    first = Symbol("theta_1_1", real=True)
    azimuths = tuple(first + 2 * pi * k / 3 for k in range(len(ROLLERS)))
    corners = [Roller(a, LEVEL, LEVEL, LEVEL).contact for a in azimuths]
    sides = (corners[k] - corners[k - 1] for k in range(3))
    return Relation(
        azimuths,
        correction=r"(\theta_{1,1}, \theta_{1,1} + 120^\circ, \theta_{1,1} + 240^\circ)",
        proof=(Obligation(Form.EQUAL, tuple(side.dot(side) for side in sides)),),
    )


def _set_up(name: str, value: Expr, *claims: str) -> None:
    """Bind what the simulation takes for a symbol that is free elsewhere."""
    REGISTRY.derives(*claims, meanings=lambda: {name: value})(lambda: value)


_set_up("psi_i", LEVEL, "sec:3/psi")
for _k, _elevation in enumerate(ELEVATIONS, 1):
    _set_up("theta_2_i", _elevation, f"sec:3/elevation-{_k}")


def path_of_spin(elevation: Expr) -> Curve:
    """Spin of a pattern."""
    return Curve(tuple(pattern_spin(elevation)), TURN)


for _k, _elevation in enumerate(ELEVATIONS, 1):
    REGISTRY.derives(f"sec:3/circle-{_k}")(lambda e=_elevation: path_of_spin(e))


@REGISTRY.derives("sec:3/smaller-in-turn")
def radii() -> tuple[Expr, ...]:
    """Radii of the four circles, in units of 1/r."""
    spins = (pattern_spin(elevation, Integer(1)).subs(PHI, 0) for elevation in ELEVATIONS)
    return tuple(_size(spin) for spin in spins)


@REGISTRY.derives("sec:3/nonslip-case")
def slips_on_equator() -> tuple[Expr, ...]:
    """Slips of all rollers of Pattern I."""
    return vanishing(entry for slip in pattern_slips(ELEVATIONS[0]) for entry in slip)


for _k in SLIPPING:
    for _place, _name in enumerate(("minimum", "maximum")):
        REGISTRY.derives(f"sec:3/{_name}-{_k}")(
            lambda k=_k, place=_place: at_pattern(k, extrema()[place])
        )


@REGISTRY.derives("sec:3/extrema-of-all-rollers")
def slips_by_parts() -> tuple[Expr, ...]:
    """Squared slips less those of one motion to and fro along each tangent, for all rollers.

    The parts are a quarter turn apart, and the level one is the larger one: its square exceeds the
    other by the square of its product with the cosine of the elevation.
    """
    least, greatest = extrema()
    differences = [greatest**2 - least**2 - (greatest * cos(ELEVATION)) ** 2]
    for slip, roller in zip(pattern_slips(), pattern(), strict=True):
        turn = PHI - roller.azimuth
        parts = (least * cos(turn)) ** 2 + (greatest * sin(turn)) ** 2
        differences.append(slip.dot(slip) - parts)
    return vanishing(differences)


@REGISTRY.derives("sec:abstract/allows-for-slipping", "sec:4/allows-for-slipping")
def least_slips() -> tuple[Expr, ...]:
    """Least slips in Patterns II to IV."""
    return tuple(at_pattern(k, extrema()[0]) for k in SLIPPING)
