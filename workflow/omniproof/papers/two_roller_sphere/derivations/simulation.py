"""Section 3: the four cases of the simulation, from the motion of the symmetric arrangement."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise, product

from sympy import (
    Abs,
    Expr,
    Integer,
    Rational,
    Symbol,
    atan,
    pi,
    rad,
)

from omniproof.papers.two_roller_sphere.arrangement import SPEED
from omniproof.papers.two_roller_sphere.derivations.quantities import (
    REGISTRY,
    Vanishing,
    vanishing,
)
from omniproof.papers.two_roller_sphere.symbols import DIRECTION, RADIUS
from omniproof.papers.two_roller_sphere.symmetric import (
    ANGLE,
    ANGLES,
    CONTACTS,
    in_simulation,
    rim_speed,
    rollers,
    slip,
    solution,
    spin,
)
from omniproof.registry import Curve, Family, Obligation, Ordered, Relation
from omniproof.transcription.model import Form

CASES = range(len(ANGLES))
QUARTER = pi / 2
TURN = {DIRECTION: (Integer(0), 2 * pi)}
"""Directions of travel; where 0 degrees matter, the claim says that they belong to it."""


def at(value: Expr, degrees: int, case: int) -> Expr:
    """Evaluate a quantity of the simulation for one direction of travel."""
    return in_simulation(value.subs(DIRECTION, rad(degrees)), case)


ELEVATION = "sec:3/elevation"
"""Where the set-up is misprinted."""

# Set-up


@REGISTRY.derives(ELEVATION)
def elevation() -> Relation:
    """Azimuth that is printed twice, and the elevation that the printed rim speeds need.

    With both contacts at 60 degrees, the rim speeds 0.91 and 0.93 come out as printed.
    """
    given = {0: Rational(91, 100), 1: Rational(93, 100)}
    half = Rational(5, 1000)
    ends = [
        end
        for case, value in given.items()
        for found in (at(rim_speed(1), 90, case),)
        for end in (found - (value - half), value + half - found)
    ]
    return Relation(
        (rad(325), rad(60)),
        correction=r"\theta_{2,1}, \theta_{2,2} = 60^\circ",
        proof=(Obligation(Form.POSITIVE, tuple(ends)),),
    )


# Figure 3(a): the end point of the spin


@REGISTRY.derives("sec:3/ellipses")
def path_of_spin() -> Curve:
    """Spin by the direction of travel, its height in units of the greatest one."""
    turning = (RADIUS / SPEED) * spin()
    slope = Symbol("q", positive=True)
    lifted = turning[2] / turning[2].subs(DIRECTION, 0) * slope
    return Curve((turning[0], turning[1], lifted), TURN)


def slopes() -> tuple[Expr, ...]:
    """Height of the spin over its level part along y, for travel along x, by case."""
    ahead = spin()[2] / spin()[1]
    return tuple(-at(ahead, 0, case) for case in CASES)


@REGISTRY.derives("sec:3/steeper", rests_on=[ELEVATION])
def rising_slopes() -> tuple[Expr, ...]:
    """Slopes of the four planes."""
    return slopes()


@REGISTRY.derives("sec:3/common-line", rests_on=[ELEVATION])
def common_points() -> Vanishing:
    """Components of the spins at 90 and 270 degrees: all cases, less case 0; and across x."""
    found = []
    for degrees, case in product((90, 270), CASES):
        turning = [at(entry, degrees, case) for entry in spin()]
        found += [turning[0] - at(spin()[0], degrees, 0), *turning[1:]]
    return vanishing(found)


# Figure 3(b): the angle of the axis


def tangents() -> Mapping[str, Expr]:
    """Tangent of the angle in each case: it grows with the angle between -90 and 90 degrees."""
    return {f"rho_{case}": in_simulation(tangent_of_axis(), case) for case in CASES}


def tangent_of_axis() -> Expr:
    """Vertical over level part of the spin; the level part is V/r."""
    return spin()[2] * RADIUS / SPEED


@REGISTRY.derives("sec:3/axis-chain", meanings=tangents)
def angles_of_axis() -> Ordered:
    """Sizes of the tangents, over all directions of travel."""
    return Ordered(tuple(Abs(value) for value in tangents().values()), TURN)


@REGISTRY.derives("sec:3/pure-rotation", rests_on=[ELEVATION])
def level_axis() -> Vanishing:
    """Tangents of the angle at 90 and 270 degrees."""
    return vanishing(at(tangent_of_axis(), *place) for place in product((90, 270), CASES))


# Figure 3(c): the rim speeds


def rim_speeds(roller: int) -> dict[str, Expr]:
    """Rim speed of a roller in each case, m/s."""
    return {f"nu_i{case}": in_simulation(rim_speed(roller), case) for case in CASES}


def _ends(roller: int) -> list[tuple[Expr, Expr]]:
    """Tangents of the directions between which a link of the chain fails, from link to link.

    With nu = a sin + b cos the link from k to l fails where the difference of the squares, a
    product of two such forms, is not positive: between both their zeros.
    """
    forms = [(at(rim_speed(roller), 90, case), at(rim_speed(roller), 0, case)) for case in CASES]
    return [(-(b + d) / (a + c), -(d - b) / (c - a)) for (a, b), (c, d) in pairwise(forms)]


def _chain(roller: int, condition: str) -> Relation:
    """Order of the sizes of the rim speeds; it fails around the directions with no rim speed.

    Proved are: which link fails first and which last, that the fourth zero of sine and cosine lies
    outside, and that squares of both forms have positive factors.
    """
    ends = _ends(roller)
    side = 3 - 2 * roller
    first = {f"link {k}": -side * end for k, (end, _) in enumerate(ends, 1)}
    last = {f"link {k}": -side * end for k, (_, end) in enumerate(ends, 1)}
    speeds = [at(rim_speed(roller), 90, case) for case in CASES]
    return Relation(
        Ordered(tuple(Abs(value) for value in rim_speeds(roller).values()), TURN),
        condition=condition,
        proof=(
            Obligation(Form.INCREASING, speeds),
            Obligation(Form.SMALLEST, first, member="link 1"),
            Obligation(Form.LARGEST, last, member="link 3"),
            Obligation(Form.POSITIVE, tuple(last[k] - first[k] for k in first)),
        ),
    )


@REGISTRY.derives("sec:3/speed-chain-roller-1", meanings=lambda: rim_speeds(1))
def speeds_of_first() -> Relation:
    """Sizes of the rim speeds of roller 1."""
    return _chain(
        1,
        r"\tan\phi < -\frac{b_3 - b_2}{a_3 - a_2} \text{ or } "
        r"\tan\phi > -\frac{b_0 + b_1}{a_0 + a_1} \text{ with } "
        r"\nu_{1,k} = a_k \sin\phi + b_k \cos\phi \text{; it fails for } "
        r"91.73^\circ \leq \phi \leq 121.55^\circ \text{ and } "
        r"271.73^\circ \leq \phi \leq 301.55^\circ",
    )


@REGISTRY.derives("sec:3/speed-chain-roller-2", meanings=lambda: rim_speeds(2))
def speeds_of_second() -> Relation:
    """Sizes of the rim speeds of roller 2."""
    return _chain(
        2,
        r"\tan\phi > -\frac{b_3 - b_2}{a_3 - a_2} \text{ or } "
        r"\tan\phi < -\frac{b_0 + b_1}{a_0 + a_1} \text{ with } "
        r"\nu_{2,k} = a_k \sin\phi + b_k \cos\phi \text{; it fails for } "
        r"58.45^\circ \leq \phi \leq 88.27^\circ \text{ and } "
        r"238.45^\circ \leq \phi \leq 268.27^\circ",
    )


@REGISTRY.derives("sec:3/opposite-speeds", rests_on=[ELEVATION])
def sums_of_speeds() -> Vanishing:
    """Sum of both rim speeds at 0 and 180 degrees."""
    both = rim_speed(1) + rim_speed(2)
    return vanishing(at(both, *place) for place in product((0, 180), CASES))


@REGISTRY.derives("sec:3/equal-speeds", rests_on=[ELEVATION])
def differences_of_speeds() -> Vanishing:
    """Difference of both rim speeds at 90 and 270 degrees."""
    between = rim_speed(1) - rim_speed(2)
    return vanishing(at(between, *place) for place in product((90, 270), CASES))


for _case in CASES:
    REGISTRY.derives(f"sec:3/slip-{_case}", rests_on=[ELEVATION])(
        lambda case=_case: at(slip(1), 90, case)
    )
    REGISTRY.derives(f"sec:3/rim-speed-{_case}", rests_on=[ELEVATION])(
        lambda case=_case: at(rim_speed(1), 90, case)
    )
    REGISTRY.quantity(f"nu_i{_case}")(lambda case=_case: in_simulation(rim_speed(1), case))
    REGISTRY.quantity(f"S_i{_case}")(lambda case=_case: in_simulation(slip(1), case))
    REGISTRY.quantity(f"rho_{_case}")(
        lambda case=_case: atan(in_simulation(tangent_of_axis(), case))
    )


# Figure 3(d): the slip


def slips(roller: int) -> dict[str, Expr]:
    """Slip of a roller along its tangent in each case, m/s."""
    return {f"S_i{case}": in_simulation(slip(roller), case) for case in CASES}


def _slip_chain(roller: int) -> Ordered:
    return Ordered(tuple(Abs(value) for value in slips(roller).values()), TURN)


@REGISTRY.derives("sec:3/slip-chain-roller-1", meanings=lambda: slips(1))
def slips_of_first() -> Ordered:
    """Sizes of the slips of roller 1."""
    return _slip_chain(1)


@REGISTRY.derives("sec:3/slip-chain-roller-2", meanings=lambda: slips(2))
def slips_of_second() -> Ordered:
    """Sizes of the slips of roller 2."""
    return _slip_chain(2)


def slip_towards(roller: int) -> Expr:
    """Inner product of a roller's slip with the way to the other contact, m^2/s."""
    both = rollers(*solution()[:2])
    own, other = both[roller - 1], both[2 - roller]
    return slip(roller) * own.tangent.dot(other.contact - own.contact)


def _facing(degrees: int, sign: Form, side: tuple[Expr, Expr]) -> Relation:
    """Both inner products in all cases, at one direction; in case 0 nothing slips."""
    found = [at(slip_towards(roller), degrees, case) for case, roller in product(CASES, (1, 2))]
    families = [
        Family(in_simulation(slip_towards(roller), case), {DIRECTION: side})
        for case, roller in product(CASES[1:], (1, 2))
    ]
    return Relation(
        tuple(found),
        condition=r"k \neq 0",
        proof=tuple(Obligation(sign, family) for family in families),
    )


@REGISTRY.derives("sec:3/face-to-face", rests_on=[ELEVATION])
def towards_each_other() -> Relation:
    """Slips at 90 degrees; for k = 1, 2, 3 also between 0 and 180 degrees."""
    return _facing(90, Form.POSITIVE, (Integer(0), pi))


@REGISTRY.derives("sec:3/back-to-back", rests_on=[ELEVATION])
def away_from_each_other() -> Relation:
    """Slips at 270 degrees; for k = 1, 2, 3 also between 180 and 360 degrees."""
    return _facing(270, Form.NEGATIVE, (pi, 2 * pi))


@REGISTRY.derives("sec:3/no-slip-across", rests_on=[ELEVATION])
def slips_across() -> Vanishing:
    """Slips of both rollers at 0 and 180 degrees."""
    places = product((slip(1), slip(2)), (0, 180), CASES)
    return vanishing(at(*place) for place in places)


def _relative(roller: int) -> Expr:
    """Slip in units of its value at 90 degrees: the angle of the rollers cancels."""
    return slip(roller) / slip(roller).subs(DIRECTION, QUARTER)


@REGISTRY.derives("sec:3/slip-maxima")
def squared_slip() -> Family:
    """Product of the relative slips of both rollers; each is the other."""
    return Family(_relative(1) * _relative(2), TURN)


@REGISTRY.derives("sec:3/equal-slips")
def sum_of_slips() -> Vanishing:
    """Sum of both slips: they are opposite."""
    return vanishing([slip(1) + slip(2)])


@REGISTRY.derives("sec:3/no-slip")
def slips_with_level_axes() -> Vanishing:
    """Slips of both rollers for alpha_1 = 0, for every direction."""
    return vanishing(slip(roller).subs(ANGLE, 0) for roller in (1, 2))


@REGISTRY.derives("sec:3/omnidirectional", rests_on=[ELEVATION])
def squared_vertical() -> tuple[Expr, ...]:
    """Squared vertical component of the normal of the contacts' plane."""
    return (CONTACTS[0].cross(CONTACTS[1])[2] ** 2,)
