"""Section 2.3: from the spin to the direction of travel, and back to the rim speeds."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from sympy import (
    Expr,
    ImmutableMatrix,
    Integer,
    Symbol,
    atan,
    cos,
    linsolve,
    pi,
    sin,
    sqrt,
    symbols,
)

from omniproof.kinematics import frames
from omniproof.papers.two_roller_sphere.arrangement import POLE, SPEED, travelling
from omniproof.papers.two_roller_sphere.derivations.quantities import (
    ANY_SPIN,
    FIRST,
    REGISTRY,
    ROLLER,
    SECOND,
    Vanishing,
    any_spin,
    by_both_rollers,
    columns,
    in_the_world,
    part_along,
    spin,
    spin_of_pair,
    vanishing,
    world_spin,
)
from omniproof.papers.two_roller_sphere.symbols import BETWEEN, RADIUS
from omniproof.papers.two_roller_sphere.symmetric import (
    ANGLE,
    ANGLES,
    HALF,
    TILT,
    frame,
    in_simulation,
)
from omniproof.registry import Family, Obligation, Relation
from omniproof.transcription.model import Form

TURNING = Symbol("omega_0", real=True)
"""Spin about the vertical, rad/s."""

DOUBLED = {sin(BETWEEN): 2 * sin(HALF) * cos(HALF), cos(BETWEEN): 1 - 2 * sin(HALF) ** 2}
"""The angle between the contacts, by its half."""


@REGISTRY.derives("eq:13")
def velocity_of_centre() -> ImmutableMatrix:
    """Velocity of the centre of a sphere that rolls on the ground."""
    return ImmutableMatrix(travelling(TURNING).velocity)


@REGISTRY.derives("sec:2.3.1/perpendicular")
def spin_along_velocity() -> Vanishing:
    """Inner product of spin and velocity of a sphere that rolls on the ground."""
    rolled = travelling(TURNING)
    return vanishing([rolled.rotation.dot(rolled.velocity)])


@REGISTRY.derives("sec:2.3.1/components", "eq:15", meanings=in_the_world)
def spin_in_world() -> ImmutableMatrix:
    """Spin of the sphere that rolls on the ground, by the angle of its axis."""
    return world_spin()


@REGISTRY.derives("eq:14/direction")
def direction_of_travel() -> Expr:
    """Tangent of the direction of travel."""
    velocity = travelling(TURNING).velocity
    return velocity[1] / velocity[0]


@REGISTRY.derives("eq:14/axis")
def tangent_of_axis() -> Expr:
    """Vertical over level part of the spin."""
    turning = world_spin()
    return turning[2] / sqrt(turning[0] ** 2 + turning[1] ** 2)


@REGISTRY.derives("eq:14/speed")
def speed() -> Expr:
    """Speed of the centre."""
    return SPEED


# The space of the spins that both rollers make


@REGISTRY.derives("eq:17/x")
def spin_for_second() -> ImmutableMatrix:
    """Spin for the rim speed 1 of roller 2."""
    return columns()[1]


@REGISTRY.derives("eq:17/y")
def spin_for_first() -> ImmutableMatrix:
    """Spin for the rim speed 1 of roller 1."""
    return columns()[0]


@cache
def normal() -> ImmutableMatrix:
    """Cross product of both columns, in the order of the paper: 3x1."""
    return ImmutableMatrix(columns()[1].cross(columns()[0]))


def squared_length() -> Expr:
    """Squared length of that cross product for r = 1 m."""
    return normal().dot(normal()).subs(RADIUS, 1)


@REGISTRY.derives("sec:2.3.2/two-dimensional")
def dimension() -> Relation:
    """Squared length where both axes point along the normal; elsewhere a sum of squares.

    Of its terms, the squared component along the normal is positive between -90 and 90 degrees.
    """
    upright = {FIRST.angle: pi / 2, SECOND.angle: pi / 2}
    sine = FIRST.direction.cross(SECOND.direction).dot(POLE)
    along = (normal().dot(POLE) * sine).subs(RADIUS, 1)
    level = pi / 2
    box = {roller.angle: (-level, level) for roller in (FIRST, SECOND)}
    return Relation(
        (squared_length().subs(upright),),
        condition=r"\alpha_1 \text{ and } \alpha_2 \text{ are not both } \pm 90^\circ",
        proof=(
            Obligation(Form.POSITIVE, Family(-along, box)),
            Obligation(Form.POSITIVE, (squared_length().subs(FIRST.angle, pi / 2)
                                       .subs(SECOND.angle, 0) * sine**2 * 4,)),
        ),
    )  # fmt: skip


def in_case_0(expression: Expr) -> Expr:
    """Put in the contacts of the simulation, with both axes in their plane."""
    level = expression.subs({FIRST.angle: 0, SECOND.angle: 0})
    return in_simulation(level.subs(DOUBLED))


# (18) has a quotient of two components: the length cancels.
@REGISTRY.derives("sec:2.3.2/unit-normal", idle=True)
def length_of_normal() -> Relation:
    """Squared length of the cross product in the simulation, and one."""
    products = [normal().dot(column) for column in columns()]
    return Relation(
        (Integer(1), in_case_0(squared_length())),
        correction=r"\text{the normal vector } \mathbf{X} \times \mathbf{Y}",
        proof=(Obligation(Form.EQUAL, vanishing(products)),),
    )


@REGISTRY.derives("sec:2.3.2/in-span", meanings=by_both_rollers)
def spin_along_normal() -> Expr:
    """Component of the spin along the normal of the space of spins."""
    return spin_of_pair().dot(normal())


@cache
def vertical_component() -> Expr:
    """Vertical component of the cross product in the symmetric arrangement, r = 1 m."""
    symmetric = {FIRST.angle: ANGLE, SECOND.angle: -ANGLE}
    first, second = (column.subs(symmetric).subs(RADIUS, 1) for column in columns())
    turned = frame() * _from_middle(second).cross(_from_middle(first))
    return turned[2]


def _from_middle(vector: ImmutableMatrix) -> ImmutableMatrix:
    """Turn the frame of the plane, so that its first axis points between the contacts."""
    return ImmutableMatrix(frames.axes(frames.rotation("z", -HALF)) * vector.subs(DOUBLED))


@REGISTRY.derives("sec:2.3.2/axis-obtained")
def determined_axis() -> Relation:
    """Squared vertical component at the angle where the space of spins stands upright."""
    upright = atan(cos(TILT) / (sin(TILT) * sin(HALF)))
    squared = vertical_component() ** 2
    printed = tuple(in_simulation(squared.subs(ANGLE, angle)) for angle in ANGLES)
    return Relation(
        (in_simulation(squared.subs(ANGLE, upright)),),
        condition=(
            r"(\mathbf{X} \times \mathbf{Y})_z \neq 0 \text{, in the arrangement of Section 3 }"
            r" \tan\alpha_1 \neq \frac{2}{\sqrt{3} \tan 55^\circ} \text{, that is, }"
            r" \alpha_1 \neq 38.96^\circ"
        ),
        proof=(Obligation(Form.POSITIVE, printed),),
    )


def _free_columns() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    return (
        ImmutableMatrix(symbols("x_1:4", real=True)),
        ImmutableMatrix(symbols("y_1:4", real=True)),
    )


@cache
def vertical_spin() -> Expr:
    """Spin about the vertical of a rolling sphere whose spin lies in the plane of two vectors."""
    first, second = _free_columns()
    rolled = travelling(TURNING).rotation
    ((solved,),) = linsolve([rolled.dot(first.cross(second))], [TURNING])
    return solved


def in_any_plane() -> Mapping[str, Any]:
    """Meanings for any two vectors that the spin is made of."""
    first, second = _free_columns()
    return {
        "X": first,
        "Y": second,
        "rho": atan(tangent_in_plane()),
        "omega": ImmutableMatrix(travelling(vertical_spin()).rotation),
    }


@REGISTRY.derives("eq:18", meanings=in_any_plane)
def tangent_in_plane() -> Expr:
    """Vertical over level part of the spin in the plane of two vectors."""
    return vertical_spin() / (SPEED / RADIUS)


@REGISTRY.derives("eq:19", meanings=in_any_plane)
def spin_in_plane() -> ImmutableMatrix:
    """Spin of the rolling sphere in the plane of two vectors."""
    return ImmutableMatrix(travelling(vertical_spin()).rotation)


# Back to the rim speeds


@REGISTRY.derives("eq:20")
def component_along_tangent() -> Expr:
    """Component of the spin along a tangent: that of the roller's line."""
    return part_along(ROLLER)


@REGISTRY.derives("eq:21", meanings=any_spin)
def component_of_any_spin() -> Expr:
    """Component of any spin along a tangent."""
    return ANY_SPIN.dot(ROLLER.tangent)


@REGISTRY.derives("eq:22")
def rim_speed() -> Expr:
    """Rim speed of a roller."""
    return ROLLER.speed


@REGISTRY.derives("sec:2.3.2/rim-speed-obtained")
def determined_speed() -> Relation:
    """Squared velocity of the sphere along the normal for the rim speed 1, at 90 degrees."""
    along = ROLLER.surface_velocity(spin()).dot(POLE).diff(ROLLER.speed)
    level = pi / 2
    return Relation(
        ((along**2).subs(ROLLER.angle, level),),
        condition=r"\alpha_i \neq \pm 90^\circ",
        proof=(Obligation(Form.POSITIVE, Family(along, {ROLLER.angle: (-level, level)})),),
    )
