"""The robot on three omni wheels: every line of Tables 3 and 4 of omni-trajectory, run anew.

Each case has two starts. *Flying*: the wheels gather speed before time 0, so that what is compared
is the motion at constant speeds, which is what the formulas describe. *Standing*: the wheels are
told their speeds at time 0 and the robot has to be pulled along; what friction and inertia cost is
in the path for good. The paper does not say which one it has.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from math import atan2, degrees, pi
from types import MappingProxyType

import mujoco
import numpy as np
import sympy
from sympy import Expr, ImmutableMatrix, Rational, Symbol, rad

from omniproof.kinematics import trajectory
from omniproof.papers.omni_trajectory import setup
from omniproof.simulation import omni_controls
from omniproof.simulation.case import Case, Model
from omniproof.simulation.engine import NO_PARAMETERS, Limits, Parameters, Recording, run
from omniproof.simulation.engines import USUAL
from omniproof.simulation.measures import (
    angle_between,
    circle,
    first_direction,
    length_error,
    mean_error,
    path_length,
    seen_from_start,
)
from omniproof.simulation.omni_controls import circle_controls, path_at, path_controls
from omniproof.simulation.omni_model import Robot, mjcf, robot_from

NAME = "omni-robot"
STARTS = ("flying", "standing")
EVERY = 0.01
"""Seconds from one recorded instant to the next."""
SETTLING = 0.3
"""Seconds in which the robot comes to rest on its wheels."""
RAMP = 0.2
"""Seconds in which a flying start gathers speed; as many follow until time 0."""

LIMITS = Limits(speed=0.5, penetration=4e-4, energy=1.0, spin=60.0)
"""Ten times the robot's speed; a tenth of a roller's radius; three times what the motors turn; five
times the spin of a roller that rolls at the robot's speed (0.05 m/s over 4 mm).
"""

VARIED = setup.CIRCLES[1]
"""The case with the largest errors is the one that is varied."""
VARIATIONS: Mapping[str, Parameters] = {
    "half-step": {"step": 2.5e-4},
    "harder": {"contact_time": 2e-3},
    "softer": {"contact_time": 8e-3},
    "slippery": {"friction": 0.1},
    "rough": {"friction": 1.0},
    "two-rows": {"rows": 2},
    "36-rollers": {"rollers": 36},
    "heavy": {"mass": 5.0},
}
"""What the paper does not say, changed one at a time."""

OTHER_BODY = "body-86-mm"
"""Robot with the body radius of Section 3.1 for that of Table 1: matters where the path turns."""
TABLE_SPEED, AT_TABLE_SPEED = Rational("0.022"), "speed-22-mm"
"""The speed of Table 2 (m/s), which the printed rates do not give; and all rates cut to it."""

OTHER, OTHER_STEP = "drake", 1e-3
"""The engine that runs the first circle too; at half that step it gives the same within 1/10000."""

# Cases -------------------------------------------------------------------------------------------


def _cases() -> Iterator[Case]:
    yield from (
        _case(printed, start) for start in STARTS for printed in (*setup.CIRCLES, *setup.LINES)
    )
    for variation, changed in VARIATIONS.items():
        yield from (_case(VARIED, start, variation, changed) for start in STARTS)
    other = {"body_radius": float(setup.RADII["Section 3.1"])}
    for start in STARTS:
        yield from (_case(printed, start, OTHER_BODY, other) for printed in setup.CIRCLES)
        for printed in (*setup.CIRCLES, *setup.LINES):
            yield _case(printed, start, AT_TABLE_SPEED, {"rates_rpm": _slower_rates(printed)})
    elsewhere: Parameters = {"engine": OTHER, "step": OTHER_STEP}
    yield from (_case(setup.CIRCLES[0], start, OTHER, elsewhere) for start in STARTS)


def _case(
    printed: setup.Case, start: str, variation: str = "", changed: Parameters = NO_PARAMETERS
) -> Case:
    shape = "circle" if printed in setup.CIRCLES else "line"
    parts = (shape, printed.name.removesuffix("°"), start, variation)
    parameters: Parameters = {
        "start": start,
        "rates_rpm": " ".join(printed.rates_rpm),
        "duration": 3.0,
        "step": 5e-4,
        "engine": USUAL,
        **Robot().parameters,
        **changed,
    }
    return Case(NAME, "-".join(filter(None, parts)), MappingProxyType(parameters))


def _slower_rates(printed: setup.Case) -> str:
    """Rates (rpm) in the printed proportion that give the speed of Table 2: the path, slower."""
    moving = setup.twist(printed, setup.RADII["Table 1"])
    factor = TABLE_SPEED / sympy.sqrt(moving[0] ** 2 + moving[1] ** 2)
    return " ".join(f"{float(factor * Rational(rate)):.6f}" for rate in printed.rates_rpm)


# Runs --------------------------------------------------------------------------------------------


def simulate(case: Case) -> Recording:
    """Run a case; columns x, y (m), heading (rad) from the pose at time 0, height (m).

    Raises `ImplausibleRunError`.
    """
    parameters, step = case.parameters, float(case.parameters["step"])
    flying = parameters["start"] == "flying"
    rates = np.array([float(rate) for rate in str(parameters["rates_rpm"]).split()]) * pi / 30

    def drive(model: mujoco.MjModel, data: mujoco.MjData) -> None:
        data.ctrl[:] = rates * (_ramp(data.time) if flying else data.time >= -step / 2)

    raw = run(
        mjcf(robot_from(parameters)),
        duration=float(parameters["duration"]),
        step=step,
        control=drive,
        observe=_pose,
        every=EVERY,
        start=-SETTLING - 2 * RAMP * flying,
        limits=LIMITS,
        parameters={"case": case.name, **parameters},
        engine=str(parameters["engine"]),
    )
    poses = seen_from_start(*(raw.columns[name] for name in ("x", "y", "heading")))
    columns = dict(zip(("x", "y", "heading"), poses.T, strict=True))
    return Recording(raw.time, MappingProxyType({**columns, "height": raw.columns["height"]}))


def _ramp(time: float) -> float:
    """Share of the full speed: smooth from -2 RAMP to -RAMP, so that no wheel slips."""
    passed = min(1.0, max(0.0, time / RAMP + 2))
    return passed * passed * (3 - 2 * passed)


def _pose(model: mujoco.MjModel, data: mujoco.MjData) -> Mapping[str, float]:
    body = data.body("robot")
    x, y, height = body.xpos
    return {"x": x, "y": y, "height": height, "heading": atan2(body.xmat[3], body.xmat[0])}


# Numbers -----------------------------------------------------------------------------------------

UNITS: Mapping[str, str] = MappingProxyType(
    {
        "speed": "m/s",
        "length": "m",
        "length_theory": "m",
        "length_error": "1",
        "mean_error": "1",
        "direction_error": "deg",
        "turn": "deg",
        "turn_theory": "deg",
        "radius": "m",
        "radius_theory": "m",
        "radius_error": "1",
        "centre_error": "1",
        "mean_error_other_body": "1",
        "height_range": "m",
        **omni_controls.UNITS,
    }
)


def summarise(case: Case, recording: Recording) -> dict[str, float]:
    """Return the numbers of a run beside the theory's, and how far the printed formulas are off.

    `length_error` is |1 - L_e/L_m| and `mean_error` Eq. (17) of omni-trajectory; `radius_error` is
    relative to the theory's radius, `centre_error` to the run's; `mean_error_other_body` compares
    with the path that the other printed body radius would give. A large `height_range` would show
    a robot that jumps.
    """
    angles, speeds = str(case.parameters["wheel_angles_deg"]), _wheel_speeds(case)
    body_radius = Rational(str(case.parameters["body_radius"]))
    moving = _twist(angles, speeds, body_radius)
    places = np.column_stack([recording.columns["x"], recording.columns["y"]])
    numbers = _path_numbers(recording, places, moving)
    numbers |= path_controls(recording.time, places, speeds, moving, body_radius)
    if case.name.startswith("circle"):
        numbers |= _circle_numbers(places, moving) | circle_controls(places, speeds, body_radius)
        # The paper may have built its robot with one radius and computed with the other.
        other = max(setup.RADII.values(), key=lambda printed: abs(printed - body_radius))
        elsewhere = theory_path(recording.time, _twist(angles, speeds, other))
        numbers["mean_error_other_body"] = mean_error(recording.time, elsewhere, places)
    return numbers


def _path_numbers(
    recording: Recording, places: np.ndarray, moving: ImmutableMatrix
) -> dict[str, float]:
    theory = theory_path(recording.time, moving)
    turn, turn_theory = recording.columns["heading"][-1], float(moving[2]) * recording.time[-1]
    begun = first_direction(places, turn)
    return {
        "speed": path_length(places) / recording.time[-1],
        "length": path_length(places),
        "length_theory": path_length(theory),
        "length_error": length_error(theory, places),
        "mean_error": mean_error(recording.time, theory, places),
        "direction_error": degrees(angle_between(begun, float(trajectory.direction_angle(moving)))),
        "turn": degrees(turn),
        "turn_theory": degrees(turn_theory),
        "height_range": float(np.ptp(recording.columns["height"])),
    }


def _circle_numbers(places: np.ndarray, moving: ImmutableMatrix) -> dict[str, float]:
    centre, radius = circle(places)
    expected = float(trajectory.circle_radius(moving))
    off = centre - np.array(trajectory.circle_centre(moving), dtype=float).ravel()
    return {
        "radius": radius,
        "radius_theory": expected,
        "radius_error": abs(1 - radius / expected),
        "centre_error": float(np.hypot(*off)) / radius,
    }


def theory_path(time: np.ndarray, moving: ImmutableMatrix) -> np.ndarray:
    """Return the path (n, 2) in m that mechanics gives for a constant twist (3x1)."""
    passing = Symbol("t", real=True)
    return path_at(time, passing, trajectory.constant_speed_path(moving, passing))


def _wheel_speeds(case: Case) -> tuple[Expr, ...]:
    radius = Rational(str(case.parameters["radius"]))
    rates = str(case.parameters["rates_rpm"]).split()
    return tuple(radius * sympy.pi / 30 * Rational(rate) for rate in rates)


# Many cases differ in what theory does not know, so that its part is worth keeping.
@cache
def _twist(angles_deg: str, speeds: tuple[Expr, ...], body_radius: Expr) -> ImmutableMatrix:
    angles = [rad(Rational(angle)) for angle in angles_deg.split()]
    return trajectory.body_twist(angles, body_radius, speeds)


MODEL = Model(tuple(_cases()), simulate, summarise, UNITS)
