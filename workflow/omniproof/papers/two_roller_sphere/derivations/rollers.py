"""Sections 2.1 and 2.2: the spins that one roller allows, and the one that two rollers make."""

from __future__ import annotations

from sympy import Expr, ImmutableMatrix, Integer, Symbol, linsolve, pi, sin, symbols

from omniproof.kinematics import frames, sphere
from omniproof.papers.two_roller_sphere.arrangement import POLE, tidied
from omniproof.papers.two_roller_sphere.derivations.quantities import (
    ANY_SPIN,
    FIRST,
    OTHER,
    PAIR,
    REGISTRY,
    ROLLER,
    SECOND,
    Vanishing,
    allowed_spin,
    any_spin,
    by_both_rollers,
    common_point,
    height,
    on_one_roller,
    part_along,
    spin,
    spin_of_pair,
    vanishing,
)
from omniproof.papers.two_roller_sphere.symbols import ALONG, PLACE, RADIUS
from omniproof.registry import Curve, Family, Obligation, Relation
from omniproof.transcription.model import Form

APART = Symbol("epsilon", real=True)
ROUND = {APART: (Integer(0), 2 * pi)}
"""From contact 1 to any other one, along a great circle or a circle of latitude (rad)."""
WITH_NORMAL = {APART: (Integer(0), pi)}
"""Angles (rad) between contacts for which (6) has a normal, and Section 2.2 a meaning."""

# One roller


@REGISTRY.derives("eq:1", meanings=any_spin)
def velocity_of_sphere() -> ImmutableMatrix:
    """Velocity of the sphere at the contact, for any spin."""
    return ROLLER.surface_velocity(ANY_SPIN)


@REGISTRY.derives("sec:2.1/direction-of-e")
def driven_out_of_plane() -> Relation:
    """Volume spanned by contact, axis and driven direction: zero if they lay in one plane."""
    volume = ImmutableMatrix.hstack(ROLLER.direction, ROLLER.axis, ROLLER.driven).det()
    products = (ROLLER.driven.dot(ROLLER.contact), ROLLER.driven.dot(ROLLER.axis))
    return Relation(
        (Integer(0), volume),
        correction=(r"\mathbf{e}_i \in \mathrm{span}\{\mathbf{P}_i, \boldsymbol{\eta}_i\}^{\perp}"),
        proof=(Obligation(Form.EQUAL, vanishing(products)),),
    )


@REGISTRY.derives("sec:2.1/peripheral-speed")
def rim_speed() -> Expr:
    """Rim speed along the driven direction."""
    return ROLLER.speed * ROLLER.driven.dot(ROLLER.driven)


@REGISTRY.derives("sec:2.1/non-slip", meanings=on_one_roller)
def velocity_without_slip() -> ImmutableMatrix:
    """Velocity of the sphere for a spin that its only roller allows."""
    return ROLLER.surface_velocity(allowed_spin())


@REGISTRY.derives("eq:2", meanings=on_one_roller)
def driven_speed() -> Expr:
    """Component of that velocity along the driven direction."""
    return velocity_without_slip().dot(ROLLER.driven)


@REGISTRY.derives("eq:3", "sec:2.1/sum", meanings=on_one_roller)
def spin_about_axis() -> Expr:
    """Component of an allowed spin along the roller's axis."""
    return tidied(ImmutableMatrix([allowed_spin().dot(ROLLER.axis)]))[0]


@REGISTRY.derives("sec:2.1/no-side-slip")
def slip_along_axis() -> Relation:
    """Slip along the axis of a roller, where two rollers make the spin."""
    met = {ROLLER.speed: sin(OTHER.angle), OTHER.speed: sin(ROLLER.angle)}
    return Relation(
        (Integer(0), ROLLER.slip(spin()).dot(ROLLER.axis)),
        condition=(
            r"\text{there is one roller, or } \nu_1 \sin\alpha_1 = \nu_2 \sin\alpha_2"
            r" \text{, or } \alpha_i = \pm 90^\circ"
        ),
        proof=(
            Obligation(Form.EQUAL, vanishing([ROLLER.slip(allowed_spin()).dot(ROLLER.axis)])),
            Obligation(Form.EQUAL, vanishing([ROLLER.slip(spin()).dot(ROLLER.axis).subs(met)])),
            Obligation(
                Form.EQUAL,
                vanishing([ROLLER.slip(spin()).dot(ROLLER.axis).subs(ROLLER.angle, pi / 2)]),
            ),
        ),
    )


@REGISTRY.derives("sec:2.1/spin-in-plane")
def spin_across_plane() -> Vanishing:
    """Component of an allowed spin along the driven direction, across axis and contact."""
    return vanishing([allowed_spin().dot(ROLLER.driven)])


@REGISTRY.derives("sec:2.1/not-unique")
def determinant_of_one() -> Vanishing:
    """Determinant of the normal equations of one roller."""
    return vanishing([sphere.normal_matrix([ROLLER.direction]).det()])


@REGISTRY.derives("sec:2.1/line-set")
def line_of_spins() -> Curve:
    """Allowed spins, one for each place on the line."""
    return Curve(tuple(allowed_spin()), {ALONG: (-Integer(1), Integer(1))})


@REGISTRY.derives("eq:4")
def point_of_line() -> ImmutableMatrix:
    """Any allowed spin."""
    return allowed_spin()


# Two rollers: how they stand


@REGISTRY.derives("sec:2.2/orthonormal-base", "tab:1/orthonormal-base")
def orthonormality() -> Vanishing:
    """Lengths of tangent and normal less one, and their inner products, at any azimuth."""
    azimuth = Symbol("beta", real=True)
    tangent, normal = sphere.tangent_base(azimuth, 0)
    contact = sphere.contact_direction(azimuth, 0)
    lengths = (tangent.dot(tangent) - 1, normal.dot(normal) - 1, (normal - POLE).norm())
    return vanishing([*lengths, tangent.dot(normal), tangent.dot(contact), normal.dot(contact)])


@REGISTRY.derives("eq:5")
def turned_axis() -> ImmutableMatrix:
    """Tangent, turned about the contact by the angle of the roller."""
    turned = frames.rotation("z", ROLLER.azimuth) * frames.rotation("x", ROLLER.angle)
    return ImmutableMatrix(frames.axes(turned)[:, 1])


@REGISTRY.derives("eq:6/tangent")
def tangent() -> ImmutableMatrix:
    """Tangent towards growing azimuth."""
    return ROLLER.tangent


@REGISTRY.derives("eq:6/normal")
def normal() -> ImmutableMatrix:
    """Pole of the plane of the rollers."""
    return POLE


def on_great_circle() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Directions of two contacts on the equator of their plane: 3x1 each."""
    return sphere.contact_direction(0, 0), sphere.contact_direction(APART, 0)


@REGISTRY.derives("sec:2.2/unique-end-point")
def squared_sine() -> Family:
    """Squared cross product of the directions of two lines: zero for parallel ones."""
    first, second = on_great_circle()
    return Family(first.cross(second).dot(first.cross(second)), WITH_NORMAL)


def meeting(turning: ImmutableMatrix) -> ImmutableMatrix:
    """Put rim speeds for which both lines have the same height."""
    return turning.subs({FIRST.speed: sin(SECOND.angle), SECOND.speed: sin(FIRST.angle)})


@REGISTRY.derives("sec:2.2/intersection-of-planes")
def common_spin_across_planes() -> Vanishing:
    """Components of a common point of both lines across both planes."""
    return vanishing([meeting(spin_of_pair()).dot(roller.driven) for roller in PAIR])


@REGISTRY.derives("sec:2.2/slip-without-common-point")
def slip_and_gap() -> tuple[Expr, Expr]:
    """Slip of roller 1, and half the gap between the lines in m/s."""
    slip = FIRST.slip(spin_of_pair()).dot(FIRST.tangent)
    return slip, RADIUS * (height(SECOND) - height(FIRST)) / 2


# Table 1


@REGISTRY.derives("tab:1/projection-on-plane")
def spin_less_its_projection() -> Vanishing:
    """What is left of the spin, along both contacts; and the projection along the normal."""
    left = spin_of_pair() - common_point()
    return vanishing([left.dot(r.contact) for r in PAIR] + [common_point().dot(POLE)])


@REGISTRY.derives("tab:1/projection-on-normal")
def heights_of_both() -> Vanishing:
    """Spin less its part in the plane, less the mean height along the normal."""
    mean = (height(FIRST) + height(SECOND)) / 2
    return vanishing(spin_of_pair() - common_point() - mean * POLE)


@REGISTRY.derives("tab:1/unit-along-roller")
def driven_along_velocity() -> Vanishing:
    """Squared length of the driven direction less one; its cross product with the velocity."""
    across = ROLLER.driven.cross(ROLLER.velocity)
    return vanishing([ROLLER.driven.dot(ROLLER.driven) - 1, *across])


def vertical_normal() -> Expr:
    """Vertical component of P_1 x P_2 for contacts at 45 degrees of elevation, times two."""
    places = [sphere.contact_direction(azimuth, pi / 4) for azimuth in (0, APART)]
    return 2 * places[0].cross(places[1])[2]


@REGISTRY.derives("tab:1/upper-normal")
def upward() -> Family:
    """Vertical component of the normal, by the azimuth from contact 1 to contact 2."""
    return Family(vertical_normal(), ROUND)


@REGISTRY.derives("tab:1/angle-of-roller")
def sine_of_angle() -> tuple[Expr, Expr]:
    """Component of the axis along the normal, and the sine of the angle."""
    return turned_axis().dot(POLE), sin(ROLLER.angle)


# Two rollers: the spin that they make


@REGISTRY.derives("sec:2.2/minimum")
def determinant_of_two() -> Family:
    """Determinant of the normal equations of two rollers."""
    matrix = sphere.normal_matrix(on_great_circle())
    return Family(matrix.det(method="berkowitz"), WITH_NORMAL)


def feet() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Points of both lines with the common perpendicular between them: 3x1 each, rad/s."""
    places = symbols("s_1 s_2", real=True)
    points = [r.line[0] + s * r.direction for r, s in zip(PAIR, places, strict=True)]
    between = points[0] - points[1]
    ((*solved,),) = linsolve([between.dot(roller.direction) for roller in PAIR], places)
    found = dict(zip(places, solved, strict=True))
    return ImmutableMatrix(points[0].subs(found)), ImmutableMatrix(points[1].subs(found))


@REGISTRY.derives("sec:2.2/midpoint", "app:A/midpoint")
def spin_less_midpoint() -> Vanishing:
    """Least-squares spin less the middle between the feet of the common perpendicular."""
    first, second = feet()
    return vanishing(spin_of_pair() - (first + second) / 2)


@REGISTRY.derives("eq:7")
def point_of_projection() -> ImmutableMatrix:
    """Any allowed spin without its component along the normal."""
    return ImmutableMatrix(allowed_spin() - allowed_spin().dot(POLE) * POLE)


@REGISTRY.derives("sec:2.2/common-point")
def projection_and_lines() -> Vanishing:
    """Components of the spin along both tangents, less those of the lines."""
    return vanishing([spin_of_pair().dot(r.tangent) - part_along(r) for r in PAIR])


@REGISTRY.derives("eq:8", "eq:B.6", "eq:B.11")
def part_in_plane() -> ImmutableMatrix:
    """Least-squares spin without its component along the normal."""
    return ImmutableMatrix(spin_of_pair() - spin_of_pair().dot(POLE) * POLE)


@REGISTRY.derives("eq:9")
def height_of_line() -> Expr:
    """Component of all allowed spins along the normal."""
    return allowed_spin().dot(POLE)


@REGISTRY.derives("sec:2.2/mean-of-heights")
def mean_of_heights() -> tuple[Expr, Expr]:
    """Component of the spin along the normal, and the mean of both heights."""
    return spin_of_pair().dot(POLE), (height(FIRST) + height(SECOND)) / 2


@REGISTRY.derives("eq:10")
def part_along_normal() -> ImmutableMatrix:
    """Part of the least-squares spin along the normal."""
    return ImmutableMatrix(spin_of_pair().dot(POLE) * POLE)


@REGISTRY.derives("eq:11", "eq:16", meanings=by_both_rollers)
def spin_by_speeds() -> ImmutableMatrix:
    """Least-squares spin of rollers 1 and 2."""
    return spin_of_pair()


def raised_and_turned() -> ImmutableMatrix:
    """Point on the x-axis, raised by an elevation and turned by an azimuth: 3x1, in m."""
    azimuth, elevation = PLACE
    turned = frames.rotation("z", azimuth) * frames.rotation("y", -elevation)
    return ImmutableMatrix(RADIUS * frames.axes(turned)[:, 0])


@REGISTRY.derives("eq:12", meanings=lambda: {"P_i": raised_and_turned()})
def contact_in_world() -> ImmutableMatrix:
    """Contact at an azimuth and an elevation."""
    return raised_and_turned()


def with_level_axes(turning: ImmutableMatrix) -> ImmutableMatrix:
    """Put both axes into the plane of the rollers."""
    return turning.subs({FIRST.angle: 0, SECOND.angle: 0})


@REGISTRY.derives("sec:2.2/second-term", "sec:2.2/spin-in-plane")
def normal_part_with_level_axes() -> Vanishing:
    """Component of the spin along the normal where both axes lie in the plane."""
    return vanishing([with_level_axes(spin_of_pair()).dot(POLE)])


@REGISTRY.derives("sec:2.2/without-slip")
def slips_with_level_axes() -> Vanishing:
    """Slips of both rollers where both axes lie in the plane."""
    slips = (with_level_axes(roller.slip(spin_of_pair())) for roller in PAIR)
    return vanishing([entry for slip in slips for entry in slip])


@REGISTRY.derives("sec:2.2/omnidirectional")
def squared_vertical_normal() -> Family:
    """Squared vertical component: the spins fill a plane, and an upright one has no free angle."""
    return Family(vertical_normal() ** 2, ROUND)
