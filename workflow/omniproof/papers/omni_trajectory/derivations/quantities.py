"""The quantities of the paper from first principles, and the symbols they are written in.

Twists come from the rolling constraint by `trajectory.body_twist`. The paper has three of them: of
any velocity (Eqs. (6) and (10)), of constant wheel speeds a, b, c, and of wheel speeds that are
unknown functions of time (Eqs. (8) and (9)).
"""

from __future__ import annotations

from functools import cache

from sympy import (
    Expr,
    Function,
    ImmutableMatrix,
    Integer,
    Integral,
    pi,
    sqrt,
)

from omniproof.kinematics import omni, trajectory
from omniproof.papers.omni_trajectory.setup import ANGLES
from omniproof.papers.omni_trajectory.symbols import (
    BODY_RADIUS,
    CONSTANT_SPEEDS,
    DURATION,
    HEADING,
    SPEEDS,
    SYMBOLS,
    TIME,
    VELOCITY,
    WHEEL_RADIUS,
    YAW_RATE,
)
from omniproof.registry import Registry

REGISTRY = Registry("omni-trajectory", symbols=SYMBOLS)


def function_of_time(name: str) -> Expr:
    """Any function of time; real."""
    return Function(name, real=True)(TIME)


CHANGING_SPEEDS = tuple(function_of_time(symbol.name) for symbol in SPEEDS)
"""Wheel speeds that change with time, m/s."""


@cache
def matrix() -> ImmutableMatrix:
    """Wheel matrix of the equilateral arrangement on (V_x, V_y, yaw rate): 3x3."""
    return omni.wheel_matrix(ANGLES, BODY_RADIUS)


@cache
def twist(speeds: tuple[Expr, ...]) -> ImmutableMatrix:
    """Twist of the equilateral arrangement for wheel speeds (m/s): 3x1."""
    return trajectory.body_twist(ANGLES, BODY_RADIUS, speeds)


def constant_twist() -> ImmutableMatrix:
    """Twist for the constant speeds a, b, c: 3x1."""
    return twist(CONSTANT_SPEEDS)


@REGISTRY.quantity("P_m")
def body_velocity() -> ImmutableMatrix:
    """Any velocity and yaw rate, in the robot frame: 3x1."""
    return ImmutableMatrix([*VELOCITY, YAW_RATE])


@REGISTRY.quantity("P_W")
def world_velocity() -> ImmutableMatrix:
    """The same velocity and yaw rate in the world: 3x1."""
    return trajectory.world_velocity(body_velocity(), HEADING)


@REGISTRY.quantity("T_Wm")
def transformation() -> ImmutableMatrix:
    """Transformation from the robot frame to the world: 3x3."""
    return trajectory.world_from_body(HEADING)


@REGISTRY.quantity("X_W")
def first_velocity() -> Expr:
    """Velocity along the first axis of the world, m/s."""
    return world_velocity()[0]


@REGISTRY.quantity("Y_W")
def second_velocity() -> Expr:
    """Velocity along the second axis of the world, m/s."""
    return world_velocity()[1]


@REGISTRY.quantity("velocity")
def plane_velocity() -> ImmutableMatrix:
    """Velocity in the world: 2x1, m/s."""
    return ImmutableMatrix(world_velocity()[:2, :])


REGISTRY.quantity("nabla_W")(plane_velocity)


@REGISTRY.quantity("orbit_radius")
def orbit_radius() -> Expr:
    """Radius of the circle that a constant twist runs through, m."""
    return trajectory.circle_radius(body_velocity())


@REGISTRY.quantity("C_90")
def quarter_turn() -> ImmutableMatrix:
    """Rotation by a right angle, counter-clockwise: 2x2."""
    return trajectory.rotation(pi / 2)


@REGISTRY.quantity("psi")
def initial_direction() -> Expr:
    """Direction of the velocity at time 0, for constant speeds, rad."""
    return trajectory.direction_angle(constant_twist())


@REGISTRY.quantity("start")
def start() -> Expr:
    """Time at which the motion starts."""
    return Integer(0)


for _k in range(3):
    REGISTRY.quantity(f"nu_{_k + 1}")(lambda k=_k: SPEEDS[k])
    REGISTRY.quantity(f"omega_{_k + 1}")(lambda k=_k: SPEEDS[k] / WHEEL_RADIUS)
for _k, _name in enumerate(("V_x", "V_y")):
    REGISTRY.quantity(_name)(lambda k=_k: VELOCITY[k])
for _name in ("X_model", "Y_model", "X_experiment", "Y_experiment"):
    REGISTRY.quantity(_name, of=[TIME])(lambda name=_name: coordinate(name))


def coordinate(name: str) -> Expr:
    """Coordinate of any path, by axis and source."""
    axis, source = name.split("_")
    return function_of_time(f"{axis}_w^{source[0]}")


@REGISTRY.quantity("r_t", of=[TIME])
def place_by_theory() -> ImmutableMatrix:
    """Place of the robot by theory, any path: 2x1, m."""
    return ImmutableMatrix([coordinate("X_model"), coordinate("Y_model")])


@REGISTRY.quantity("r_e", of=[TIME])
def place_by_experiment() -> ImmutableMatrix:
    """Place of the robot in the simulation, any path: 2x1, m."""
    return ImmutableMatrix([coordinate("X_experiment"), coordinate("Y_experiment")])


@REGISTRY.quantity("error", of=[TIME])
def mean_relative_distance() -> Expr:
    """Mean over [0, T] of the distance of both places over that from the origin."""
    theory, experiment = place_by_theory(), place_by_experiment()
    relative = _length(theory - experiment) / _length(theory)
    return Integral(relative, (TIME, 0, DURATION)) / DURATION


def _length(vector: ImmutableMatrix) -> Expr:
    return sqrt(sum(entry**2 for entry in vector))


REGISTRY.abbreviations[r"\dot{X}_{\mathcal{W}}"] = first_velocity
REGISTRY.abbreviations[r"\dot{Y}_{\mathcal{W}}"] = second_velocity
