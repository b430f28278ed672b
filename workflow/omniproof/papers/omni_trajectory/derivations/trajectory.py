"""Section 2.2 (B): speed, radius, direction and centre for constant speeds; the kinds of paths."""

from __future__ import annotations

from sympy import Expr, ImmutableMatrix, Integer, Symbol, cancel, cos, pi, sin

from omniproof.kinematics import trajectory
from omniproof.papers.omni_trajectory.derivations.quantities import (
    REGISTRY,
    body_velocity,
    constant_twist,
    mean_relative_distance,
    orbit_radius,
    place_by_experiment,
    place_by_theory,
    plane_velocity,
    world_velocity,
)
from omniproof.papers.omni_trajectory.symbols import BODY_RADIUS, CONSTANT_SPEEDS, TIME
from omniproof.registry import Curve, Family, Obligation, Relation
from omniproof.transcription.model import Form

SPEED = Symbol("V", positive=True)
TURNING = Symbol("omega", real=True, nonzero=True)


@REGISTRY.derives("eq:10")
def speed_in_any_frame() -> Expr:
    """Speed of the robot, by its velocity in the robot frame."""
    return trajectory.speed(body_velocity())


@REGISTRY.derives("eq:11", "eq:12")
def speed_by_wheel_speeds() -> Expr:
    """Speed of the robot for the constant speeds a, b, c."""
    return trajectory.speed(constant_twist())


@REGISTRY.derives("sec:2.2/radius")
def radius() -> Expr:
    """Radius of the circle for any constant twist."""
    return orbit_radius()


@REGISTRY.derives("eq:13")
def radius_by_wheel_speeds() -> Expr:
    """Radius of the circle for the constant speeds a, b, c."""
    return trajectory.circle_radius(constant_twist())


@REGISTRY.derives("sec:2.2/velocity")
def velocity() -> ImmutableMatrix:
    """Velocity in the world."""
    return plane_velocity()


@REGISTRY.derives("eq:14/velocities")
def direction_by_velocity() -> Expr:
    """Direction of the velocity in the world."""
    return trajectory.direction_angle(world_velocity())


@REGISTRY.derives("eq:14/speeds")
def direction_by_wheel_speeds() -> Expr:
    """Direction of the velocity at time 0, for the constant speeds a, b, c."""
    return trajectory.direction_angle(constant_twist())


@REGISTRY.derives("eq:15")
def centre() -> ImmutableMatrix:
    """Centre of the circle, from the robot, in the world."""
    return trajectory.circle_centre(world_velocity())


@REGISTRY.derives("eq:16/factor")
def factor_of_the_centre() -> Expr:
    """What the velocity, turned and times 3, has to be multiplied by: 1 / (3 phi-dot)."""
    return 1 / (3 * constant_twist()[2])


@REGISTRY.derives("eq:16/line-1")
def vector_of_the_centre() -> ImmutableMatrix:
    """The centre over that factor."""
    vector = trajectory.circle_centre(constant_twist()) / factor_of_the_centre()
    return ImmutableMatrix(vector.applyfunc(cancel))


@REGISTRY.derives("eq:16/line-2", rests_on=["eq:14/velocities"])
def centre_by_wheel_speeds() -> ImmutableMatrix:
    """Centre of the circle for the constant speeds a, b, c."""
    return trajectory.circle_centre(constant_twist())


def yaw_rate() -> Expr:
    """Yaw rate for the constant speeds a, b, c."""
    return constant_twist()[2]


@REGISTRY.derives("sec:2.2/no-rotation")
def yaw_rate_without_sum() -> tuple[Expr, ...]:
    """Yaw rate for speeds whose sum is zero."""
    a, b, c = CONSTANT_SPEEDS
    return yaw_rate().subs(c, -a - b), Integer(0)


@REGISTRY.derives("sec:2.2/linear", "sec:3.2/straight")
def path_without_rotation() -> Curve:
    """Path of a constant velocity in any direction, without rotation."""
    angle = Symbol("psi", real=True)
    moving = ImmutableMatrix([SPEED * cos(angle), SPEED * sin(angle), 0])
    return Curve(tuple(trajectory.constant_speed_path(moving, TIME)), _unit_time())


@REGISTRY.derives("sec:2.2/circular")
def path_with_rotation() -> Curve:
    """Path of a constant twist; the first axis lies along the velocity at time 0."""
    moving = ImmutableMatrix([SPEED, 0, TURNING])
    return Curve(tuple(trajectory.constant_speed_path(moving, TIME)), _unit_time())


def _unit_time() -> dict[Symbol, tuple[Expr, Expr]]:
    return {TIME: (Integer(0), Integer(1))}


@REGISTRY.derives("sec:2.2/counterclockwise", "sec:2.2/clockwise")
def sense_of_rotation() -> Family:
    """Yaw rate; the signs of speeds up to 1 m/s, and of L = 1 m, are those of all."""
    box = dict.fromkeys(CONSTANT_SPEEDS, (Integer(-1), Integer(1)))
    return Family(yaw_rate().subs(BODY_RADIUS, 1), box)


@REGISTRY.derives("sec:3.1/theoretical-vector")
def theoretical_place() -> ImmutableMatrix:
    """Place by theory."""
    return place_by_theory()


@REGISTRY.derives("sec:3.1/experimental-vector")
def experimental_place() -> ImmutableMatrix:
    """Place in the simulation."""
    return place_by_experiment()


@REGISTRY.derives("eq:17")
def error() -> Expr:
    """Mean of the relative distance."""
    return mean_relative_distance()


@REGISTRY.derives("sec:3.1/interval")
def distance_from_the_origin() -> Relation:
    """Squared distance from the origin at time 0; later it is positive, for a full turn.

    In units of the radius and of the time for one radian.
    """
    path = trajectory.constant_speed_path(ImmutableMatrix([1, 0, 1]), TIME)
    square = path.dot(path)
    turn = (Integer(0), 2 * pi)
    return Relation(
        (square.subs(TIME, 0),),
        condition=r"0 < t, \text{ and } t < 2\pi / |\dot{\phi}| \text{ on a circle}",
        proof=(Obligation(Form.POSITIVE, Family(square, {TIME: turn})),),
    )
