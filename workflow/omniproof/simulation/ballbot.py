"""Which law holds between the wheels and a ball that rolls: the printed one or that of rolling.

Two set-ups: a platform inside a ball, as in Yi, and one on top of it (Yi, Fig. 1a). The wheels are
set to speeds that favour no law; the ball's velocity is read off and compared with what either law
makes of the speeds that the wheels really had. In favour of Eq. (10), its yaw rate is taken
relative to the ball, and for wheels on top its direction of travel is reversed, as the mechanics
asks. What is left between the laws is the factor cos(phi).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from functools import cache, partial
from math import radians, sin, tan
from types import MappingProxyType
from typing import Any, TypeAlias

import mujoco
import numpy as np
from numpy.typing import NDArray
from sympy import ImmutableMatrix, diag

from omniproof.kinematics.ballbot import law_over_surface_at_rest, relative_law
from omniproof.kinematics.omni import twist_matrix
from omniproof.simulation.ballbot_model import BALL_RADIUS, WHEEL_RADIUS, WHEELS, Ballbot, mjcf
from omniproof.simulation.case import Case, Model
from omniproof.simulation.engine import Limits, Recording, run

Floats: TypeAlias = NDArray[np.float64]
Speeds: TypeAlias = tuple[float, float, float]
Law: TypeAlias = Callable[[Ballbot], ImmutableMatrix]

ANGLES_DEG = (30, 45, 60)
SIDES = ("inside", "on-top")
INPUTS: Mapping[str, Speeds] = {
    "along-x": (0.0, 0.04, -0.04),
    "along-y": (-0.05, 0.025, 0.025),
    "turning": (0.03, 0.03, 0.03),
    "mixed": (0.03, 0.01, -0.02),
}
"""Speeds of the wheels (m/s), numbered as in Yi: platform over surface, counter-clockwise."""

FIRM_GRIP = 0.1
"""Torsional friction (m) that lets the ball not spin on the floor."""

SETTLING, SPEEDING_UP, CALMING = 0.1, 0.3, 0.1
"""Before the recording: come to rest on the contacts, gather speed, let the start ring out (s)."""

TINY_SPEED = 1e-9
"""Below, a sum of speeds (m/s) is zero but for rounding."""

LIMITS = Limits(speed=1.0, penetration=2e-4, energy=0.5, spin=250.0)
"""Some ten times what the fastest of the inputs makes of the bodies, and 1/100 of a wheel's radius.

At 60 degrees they send the ball off at 0.14 m/s, with 0.06 J, and rollers of 4 mm at 26 rad/s.
"""

START = -(SETTLING + SPEEDING_UP + CALMING)
DURATION = 1.0
EVERY = 0.01
"""Time recorded, and between two rows (s). A roller takes over every 0.14 s from the last one at
0.05 m/s, so the mean is over seven of them or more."""

UNITS: Mapping[str, str] = MappingProxyType(
    {
        "v_x": "m/s",
        "v_y": "m/s",
        "yaw_rate": "rad/s",
        "spin": "rad/s",
        "sinking": "m",
        "rolling_v_x": "m/s",
        "rolling_v_y": "m/s",
        "printed_v_x": "m/s",
        "printed_v_y": "m/s",
        "law_yaw_rate": "rad/s",
        "share": "1",
        "rolling_error": "1",
        "printed_error": "1",
        "margin": "1",
        "allowance": "1",
        "yaw_error": "1",
    }
)


def rolling_law(robot: Ballbot) -> ImmutableMatrix:
    """Law of the ball that rolls, on (v_x, v_y, yaw rate relative to the ball): 3x3."""
    return relative_law(robot.zenith_angle, BALL_RADIUS, BALL_RADIUS)


def printed_law(robot: Ballbot) -> ImmutableMatrix:
    """Eq. (10) of Yi, in the reading that comes closest: 3x3, on the same motions."""
    direction = 1 if robot.inside else -1
    law = law_over_surface_at_rest(robot.zenith_angle, BALL_RADIUS)
    return ImmutableMatrix(law * diag(direction, direction, 1))


@cache
def motion_matrix(law: Law, robot: Ballbot) -> Floats:
    """Matrix from the wheel speeds to the motion that a law says: 3x3."""
    return np.array(twist_matrix(law(robot)), dtype=np.float64)


def simulate(case: Case) -> Recording:
    """Run a case. Columns, in the platform's frame: see `observe`."""
    robot = robot_of(case)
    return run(
        mjcf(robot),
        start=START,
        duration=DURATION,
        step=robot.step,
        every=EVERY,
        control=partial(drive, np.array(speeds_of(case)) / WHEEL_RADIUS),
        observe=observe,
        limits=LIMITS,
        parameters=case.parameters,
    )


def drive(rates: Floats, model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Bring the wheels from rest to their `rates` (rad/s), smoothly, and hold them."""
    share = np.clip((data.time - START - SETTLING) / SPEEDING_UP, 0.0, 1.0)
    data.ctrl[:] = rates * share**2 * (3 - 2 * share)


def observe(model: mujoco.MjModel, data: mujoco.MjData) -> dict[str, float]:
    """Read the ball's velocity in the platform's frame (m/s) and both turns about the vertical.

    These are `yaw_rate` of the platform and `spin` of the ball (rad/s), beside the speeds of the
    wheels (m/s) and how far the platform sits below the middle of the undeformed ball (m).
    """
    read = {name: data.sensor(name).data for name in ("ball-velocity", "platform-heading")}
    (v_x, v_y, _), (cosine, sine, _) = read["ball-velocity"], read["platform-heading"]
    return {
        "v_x": cosine * v_x + sine * v_y,
        "v_y": cosine * v_y - sine * v_x,
        "yaw_rate": float(data.sensor("platform-spin").data[2]),
        "spin": float(data.sensor("ball-spin").data[2]),
        **{_column(name): WHEEL_RADIUS * data.sensor(name).data[0] for name in WHEELS},
        "sinking": BALL_RADIUS - float(data.sensor("platform-position").data[2]),
    }


def _column(name: str) -> str:
    return name.replace("-", "_")


def summarise(case: Case, recording: Recording) -> dict[str, float]:
    """Compare the mean motion with both laws; units in `UNITS`.

    `law_yaw_rate` is relative to the ball and of both laws, whose rows for the turn are one.
    `share` is the speed by Eq. (10) over that of the ball; errors are relative to what was
    measured, `margin` is the printed law's over that of the law of rolling, and `allowance` what
    soft contacts excuse. A case without a translation, or without a turn, has no errors of it.
    """
    mean = {name: float(column.mean()) for name, column in recording.columns.items()}
    robot = robot_of(case)
    wheels = np.array([mean[_column(name)] for name in WHEELS])
    rolling, printed = (motion_matrix(law, robot) @ wheels for law in (rolling_law, printed_law))
    said = {"rolling": rolling, "printed": printed}
    return {
        **{name: mean[name] for name in ("v_x", "v_y", "yaw_rate", "spin", "sinking")},
        **{f"{law}_v_{x}": float(v[k]) for law, v in said.items() for k, x in enumerate("xy")},
        "law_yaw_rate": float(rolling[2]),
        "allowance": allowance(robot, mean["sinking"]),
        **_errors(speeds_of(case), mean, rolling, printed),
    }


def _errors(
    speeds: Speeds, mean: Mapping[str, float], rolling: Floats, printed: Floats
) -> dict[str, float]:
    errors = {}
    if len(set(speeds)) > 1:
        velocity = np.array([mean["v_x"], mean["v_y"]])
        right, wrong = (relative_error(velocity, law[:2]) for law in (rolling, printed))
        errors["share"] = float(np.linalg.norm(printed[:2]) / np.linalg.norm(velocity))
        errors |= {"rolling_error": right, "printed_error": wrong, "margin": wrong / right}
    if abs(sum(speeds)) > TINY_SPEED:
        turn = np.array([mean["yaw_rate"] - mean["spin"]])
        errors["yaw_error"] = relative_error(turn, rolling[2:])
    return errors


def allowance(robot: Ballbot, sinking: float) -> float:
    """Relative error that a law may have because contacts give way by up to `sinking` (m).

    The rim of a wheel, the surface it runs on and the ball on the floor each have a radius that is
    off by at most that; and a platform that sits deeper has another zenith angle, whose cosine
    changes by tan(phi) sin(phi) over the distance of the hubs from the centre.
    """
    angle = radians(robot.zenith_angle_deg)
    hub = BALL_RADIUS - WHEEL_RADIUS if robot.inside else BALL_RADIUS + WHEEL_RADIUS
    return sinking * (1 / WHEEL_RADIUS + 2 / BALL_RADIUS + tan(angle) * sin(angle) / hub)


def relative_error(measured: Floats, said: Floats) -> float:
    """How far off a law is, relative to what was measured."""
    return float(np.linalg.norm(measured - said) / np.linalg.norm(measured))


def robot_of(case: Case) -> Ballbot:
    """The robot that a case's parameters describe; `ValueError` for a side that it has not."""
    given: dict[str, Any] = dict(case.parameters)
    if given["side"] not in SIDES:
        raise ValueError(f"expected side {' or '.join(SIDES)}, found {given['side']!r}")
    numbers = {field.name: given[field.name] for field in fields(Ballbot) if field.name in given}
    return Ballbot(inside=given["side"] == SIDES[0], **numbers)


def speeds_of(case: Case) -> Speeds:
    """The speeds (m/s) that a case's wheels are set to."""
    first, second, third = (float(case.parameters[f"speed_{k}"]) for k in (1, 2, 3))
    return first, second, third


def case_of(side: str, angle_deg: float, input_name: str, **more: float) -> Case:
    """Name a case: `inside-45-along-x`, with the words of unusual parameters behind."""
    name = "-".join([side, f"{angle_deg:g}", input_name, *(one.replace("_", "-") for one in more)])
    speeds = {f"speed_{k}": speed for k, speed in enumerate(INPUTS[input_name], start=1)}
    usual = {field.name: getattr(Ballbot, field.name) for field in fields(Ballbot)[2:]}
    angle = {"zenith_angle_deg": float(angle_deg)}
    return Case("ballbot", name, {"side": side, **angle, **speeds, **usual, **more})


def _cases() -> Iterable[Case]:
    for side in SIDES:
        for angle in ANGLES_DEG:
            yield from (case_of(side, angle, name) for name in INPUTS)
    # The floor decides which of the two bodies turns, and not the wheels.
    yield case_of("on-top", 45, "turning", floor_torsion=FIRM_GRIP)


MODEL = Model(tuple(_cases()), simulate, summarise, UNITS)
