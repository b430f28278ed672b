"""Sections 2.1 and 2.2 (A): wheel matrix, its inverse, the world, the path for any speeds."""

from __future__ import annotations

from collections.abc import Mapping

from sympy import Expr, ImmutableMatrix, Integer, Integral, trigsimp

from omniproof.kinematics import omni, trajectory
from omniproof.papers.omni_trajectory.derivations.quantities import (
    CHANGING_SPEEDS,
    REGISTRY,
    body_velocity,
    matrix,
    transformation,
    twist,
    world_velocity,
)
from omniproof.papers.omni_trajectory.setup import ANGLES
from omniproof.papers.omni_trajectory.symbols import (
    BODY_RADIUS,
    FREE_ANGLES,
    SPEEDS,
    TIME,
    VELOCITY,
    YAW_RATE,
)


@REGISTRY.derives("eq:1")
def general_matrix() -> ImmutableMatrix:
    """Wheel matrix on (V_x, V_y, L phi-dot)."""
    return omni.velocity_matrix(FREE_ANGLES)


@REGISTRY.derives("eq:1/twist")
def general_twist() -> ImmutableMatrix:
    """Unknowns of Eq. (1)."""
    return _unknowns(FREE_ANGLES[0], general_matrix())


@REGISTRY.derives("eq:3/twist")
def equilateral_twist() -> ImmutableMatrix:
    """Unknowns of Eq. (3)."""
    return _unknowns(ANGLES[0], matrix())


def _unknowns(angle: Expr, of: ImmutableMatrix) -> ImmutableMatrix:
    """Each part of the first wheel's speed over its entry in a wheel matrix: 3x1."""
    direction = omni.tangential_direction(angle)
    contact = omni.contact_position(angle, BODY_RADIUS)
    speed = omni.rolling_speed(direction, contact, ImmutableMatrix(VELOCITY), YAW_RATE)
    motions = [*VELOCITY, YAW_RATE]
    parts = (speed.subs({other: 0 for other in motions if other != own}) for own in motions)
    ratios = (part / entry for part, entry in zip(parts, of[0, :], strict=True))
    return ImmutableMatrix([trigsimp(ratio) for ratio in ratios])


@REGISTRY.derives("eq:2")
def rim_speeds() -> ImmutableMatrix:
    """Speed at the rim of each roller, which turns at that speed over its radius."""
    return ImmutableMatrix(SPEEDS)


@REGISTRY.derives("sec:2.2/equilateral", "sec:3.1/equilateral")
def sides() -> tuple[Expr, ...]:
    """Squared distances between the rollers, for L = 1."""
    first, second, third = (omni.contact_position(angle, 1) for angle in ANGLES)
    return tuple((p - q).dot(p - q) for p, q in ((first, second), (second, third), (third, first)))


@REGISTRY.derives("sec:3.1/tangential")
def across_radius() -> tuple[Expr, ...]:
    """Inner products of driven directions and radii."""
    products = (
        omni.tangential_direction(angle).dot(omni.contact_position(angle, 1)) for angle in ANGLES
    )
    return (*products, Integer(0))


@REGISTRY.derives("eq:3")
def equilateral_matrix() -> ImmutableMatrix:
    """Wheel matrix on (V_x, V_y, phi-dot)."""
    return matrix()


@REGISTRY.derives("eq:4")
def inverse_matrix() -> ImmutableMatrix:
    """Inverse of the wheel matrix."""
    return omni.twist_matrix(matrix())


@REGISTRY.derives("eq:5")
def yaw_rate() -> Expr:
    """Yaw rate by the wheel speeds."""
    return twist(SPEEDS)[2]


@REGISTRY.derives("eq:6", "eq:7/world")
def velocity_in_the_world() -> ImmutableMatrix:
    """Velocity and yaw rate in the world."""
    return world_velocity()


@REGISTRY.derives("eq:7/body")
def velocity_in_the_body() -> ImmutableMatrix:
    """Velocity and yaw rate in the robot frame."""
    return body_velocity()


@REGISTRY.derives("eq:7")
def to_the_world() -> ImmutableMatrix:
    """Transformation from the robot frame to the world."""
    return transformation()


def _over_time() -> Mapping[str, Expr]:
    """Take the wheel speeds as functions of time."""
    return {f"nu_{k}": speed for k, speed in enumerate(CHANGING_SPEEDS, 1)}


def _coordinate(axis: int) -> Expr:
    """Coordinate of the path in the world, from the origin and heading 0 at time 0."""
    integrand = trajectory.path_integrands(twist(CHANGING_SPEEDS), TIME)[axis]
    return Integral(integrand, (TIME, 0, TIME))


@REGISTRY.derives("eq:8", meanings=_over_time)
def first_coordinate() -> Expr:
    """First coordinate of the path."""
    return _coordinate(0)


@REGISTRY.derives("eq:9", meanings=_over_time)
def second_coordinate() -> Expr:
    """Second coordinate of the path."""
    return _coordinate(1)


@REGISTRY.derives("eq:8/orientation", "eq:9/orientation", meanings=_over_time)
def orientation() -> Expr:
    """Heading at time t, from 0 at time 0."""
    return trajectory.heading(twist(CHANGING_SPEEDS)[2], TIME)
