"""Section 2.1: velocities at one contact, the line of spins without slip, the axis of a roller."""

from __future__ import annotations

from collections.abc import Iterable

from sympy import Expr, ImmutableMatrix, Integer

from omniproof.papers.three_roller_sphere.derivations.quantities import (
    REGISTRY,
    ROLLER,
    driven_direction,
    spin_without_slip,
    squared_distance,
    velocity_of_roller,
    velocity_of_sphere,
)
from omniproof.papers.three_roller_sphere.symbols import POINT, RADIUS
from omniproof.registry import Obligation, Relation
from omniproof.transcription.model import Form

DRIVEN = "sec:2.1/driven-direction"


def vanishing(entries: Iterable[Expr]) -> tuple[Expr, ...]:
    """Expressions that are all to be zero."""
    return (Integer(0), *entries)


def volume(*vectors: ImmutableMatrix) -> Expr:
    """Determinant of three vectors: zero where they lie in one plane."""
    first, second, third = vectors
    return first.dot(second.cross(third))


def differences_of_unit_normal() -> tuple[Expr, ...]:
    """What a unit vector along the roller's velocity, normal to contact and axis, makes vanish."""
    e = driven_direction()
    along = velocity_of_roller() - ROLLER.speed * e
    return vanishing([*along, e.dot(e) - 1, e.dot(ROLLER.contact), e.dot(ROLLER.axis)])


@REGISTRY.derives("sec:2.1/velocity-of-sphere")
def velocity_at_contact() -> ImmutableMatrix:
    """Velocity of the sphere at the contact, by the rolling constraint."""
    return velocity_of_sphere(spin_without_slip())


@REGISTRY.derives(DRIVEN)
def plane_of_driven_direction() -> Relation:
    """Volume of driven direction, contact and axis: they are orthogonal."""
    return Relation(
        (Integer(0), volume(driven_direction(), ROLLER.contact, ROLLER.axis)),
        correction=r"\mathbf{e}_i = \frac{1}{r} P_i \times \eta_i,"
        r" \text{ orthogonal to } \operatorname{span}\{P_i, \eta_i\}",
        proof=(
            Obligation(Form.EQUAL, differences_of_unit_normal()),
            Obligation(
                Form.EQUAL,
                vanishing(driven_direction() - ROLLER.contact.cross(ROLLER.axis)),
            ),
        ),
    )


@REGISTRY.derives("sec:2.1/unit-normal")
def unit_normal() -> tuple[Expr, ...]:
    """The driven direction is that unit normal."""
    return differences_of_unit_normal()


@REGISTRY.derives("sec:2.1/rim-speed", rests_on=[DRIVEN])
def rim_speed() -> Expr:
    """Rim speed of the roller."""
    return ROLLER.speed


@REGISTRY.derives("sec:2.1/nonslip")
def common_velocity() -> ImmutableMatrix:
    """Velocity of the rim, which the sphere has at every spin without slip."""
    return velocity_of_roller()


@REGISTRY.derives("eq:1", rests_on=[DRIVEN])
def spin_along_axis() -> Expr:
    """Component along the axis of the least spin without slip."""
    foot, _ = ROLLER.line()
    return foot.dot(ROLLER.axis)


@REGISTRY.derives("sec:2.1/in-span")
def spin_out_of_plane() -> tuple[Expr, ...]:
    """Volume of a spin without slip, axis and contact."""
    return vanishing([volume(spin_without_slip(), ROLLER.axis, ROLLER.contact)])


@REGISTRY.derives("sec:2.1/line-parallel-to-contact")
def direction_across_contact() -> tuple[Expr, ...]:
    """Cross product of the line's direction with the contact."""
    _, direction = ROLLER.line()
    return vanishing(direction.cross(ROLLER.contact))


@REGISTRY.derives("sec:2.1/line-through-end")
def foot_of_line() -> tuple[Expr, ...]:
    """Slip at the spin that is -(v/r) times the axis."""
    return vanishing(ROLLER.slip(ImmutableMatrix(-ROLLER.speed / RADIUS * ROLLER.axis)))


@REGISTRY.derives("eq:2")
def line() -> ImmutableMatrix:
    """Any spin without slip, by its place on the line."""
    return spin_without_slip()


@REGISTRY.derives("eq:2/all-spins")
def slip_and_distance() -> tuple[Expr, ...]:
    """Squared slip at any spin, over the squared radius, and squared distance from the line."""
    slip = ROLLER.slip(POINT)
    return slip.dot(slip) / RADIUS**2, squared_distance(ROLLER, POINT)


@REGISTRY.derives("sec:4/existence")
def slip_on_line() -> tuple[Expr, ...]:
    """Slip at a point of the line."""
    return vanishing(ROLLER.slip(spin_without_slip()))


@REGISTRY.derives("sec:2.1/tangent-plane")
def tangents_along_normal() -> tuple[Expr, ...]:
    """Components of both tangents along the normal of the sphere."""
    tangents = ROLLER.frame[:, 1:].T
    return vanishing(tangents * ROLLER.contact)


@REGISTRY.derives("sec:2.1/orthonormal")
def products_of_tangents() -> tuple[Expr, ...]:
    """Products of the tangents, less those of orthogonal unit vectors."""
    east, north = ROLLER.frame[:, 1], ROLLER.frame[:, 2]
    return vanishing([east.dot(east) - 1, east.dot(north), north.dot(north) - 1])


@REGISTRY.derives("sec:2.1/counterclockwise")
def handedness() -> tuple[Expr, ...]:
    """Volume of tangents and outer normal, and the axis' rate of turn about that normal: both 1."""
    east, north = (ImmutableMatrix(ROLLER.frame[:, k]) for k in (1, 2))
    turning = ROLLER.axis.cross(ROLLER.axis.diff(ROLLER.angle)).dot(ROLLER.contact)
    return Integer(1), volume(east, north, ROLLER.contact), turning


@REGISTRY.derives("eq:3")
def axis() -> ImmutableMatrix:
    """Level tangent, turned about the outer normal."""
    return ROLLER.axis


@REGISTRY.derives("eq:4/x")
def level_tangent() -> ImmutableMatrix:
    """Image of the unit vector along y."""
    return ImmutableMatrix(ROLLER.frame[:, 1])


@REGISTRY.derives("eq:4/y")
def tangent_towards_pole() -> ImmutableMatrix:
    """Image of the unit vector along z."""
    return ImmutableMatrix(ROLLER.frame[:, 2])
