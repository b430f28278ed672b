"""Figures 1 and 2: the robot in both frames, and the construction of its circular orbit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc
from numpy.typing import ArrayLike
from sympy import ImmutableMatrix, MatrixBase, Rational, pi

from omniproof.kinematics import trajectory
from omniproof.kinematics.omni import contact_position, tangential_direction, wheel_matrix
from omniproof.papers.omni_trajectory.setup import ANGLES
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import (
    MUTED,
    REDRAWN,
    arrow,
    circle,
    floats,
    label,
    line,
    shown,
    wheel,
)
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, stage, styled

WHEEL_COLOR = TYPE_COLORS["X"]
HEADING = pi / 9
TWIST = ImmutableMatrix([Rational(13, 20), Rational(1, 5), Rational(-2, 5)])
"""Free choices of Figure 1 (rad; m/s and rad/s, with L = 1 m)."""

SPEEDS = (Rational(5, 6), Rational(-2, 3), Rational(5, 6))
BODY_RADIUS = Rational(1, 2)
LATER = Rational(33, 10)
"""Free choices of Figure 2: wheel speeds a, b, c (m/s), L (m), time of the second robot (s)."""


def _flat(matrix: MatrixBase) -> Floats:
    return floats(matrix).ravel()


def _segment(panel: str, series: str, start: ArrayLike, end: ArrayLike) -> Iterator[Row]:
    return rows(panel, series, np.stack([np.asarray(start), np.asarray(end)]))


def frames_data() -> pd.DataFrame:
    """Figure 1 in m about the robot's centre, in world axes; arrows are segments (start, end)."""
    turn = floats(trajectory.rotation(HEADING))
    speeds = wheel_matrix(ANGLES, 1) * TWIST
    parts = []
    for k, (angle, speed) in enumerate(zip(ANGLES, speeds, strict=True), 1):
        contact = turn @ _flat(contact_position(angle, 1))
        drive = turn @ _flat(tangential_direction(angle)) * float(speed)
        parts.append(_segment("robot", f"v {k}", contact, contact + drive))
    velocity = _flat(trajectory.world_velocity(TWIST, HEADING)[:2, :])
    parts.append(_segment("robot", "V", [0, 0], velocity))
    for name, axes, components in (("m", turn.T, _flat(TWIST[:2, :])), ("W", np.eye(2), velocity)):
        for axis, unit, component in zip("XY", axes, components, strict=True):
            parts.append(_segment("robot", f"{axis}_{name}", [0, 0], unit))
            parts.append(_segment("robot", f"V_{axis}_{name}", [0, 0], component * unit))
    return long_form(*parts)


@styled
def draw_frames(frame: pd.DataFrame) -> Figure:
    """Draw the robot with its wheel speeds, and its velocity in both frames."""
    figure, ax = stage(4.1)
    center, scale = np.array([2.75, 2.1]), 1.05
    _world_axes(ax, np.array([0.45, 0.55]), 0.75)
    circle(ax, center, scale)
    for axis in "XY":
        tip = points(frame, "robot", f"{axis}_m")[1]
        arrow(ax, center, center + 1.5 * scale * tip, lw=1.0)
        label(ax, center + 1.64 * scale * tip, f"${axis}_m$")
        level = points(frame, "robot", f"{axis}_W")[1]
        line(ax, [center, center + 1.15 * scale * level], lw=0.8, ls=":")
    for k in range(1, 4):
        _driven_wheel(ax, frame, k, center, scale)
    _velocity(ax, frame, center, scale)
    heading, position = (_angle(points(frame, "robot", name)[row]) for name, row in
                         (("X_m", 1), ("v 1", 0)))  # fmt: skip
    _arc(ax, center, (0.0, heading), 0.8, r"$\phi$")
    line(ax, [center, center + scale * points(frame, "robot", "v 1")[0]], lw=0.8, alpha=MUTED)
    _arc(ax, center, (heading, position), 0.8, r"$\alpha_1$")
    return figure


def _world_axes(ax: Axes, corner: Floats, length: float) -> None:
    for unit, name in (([1, 0], "$X_W$"), ([0, 1], "$Y_W$")):
        tip = corner + length * np.array(unit)
        arrow(ax, corner, tip, lw=1.0)
        label(ax, tip + 0.17 * np.array(unit), name)
    label(ax, corner, "$0$", (-0.13, -0.13))


def _driven_wheel(ax: Axes, frame: pd.DataFrame, k: int, center: Floats, scale: float) -> None:
    """Draw wheel k with its contact and its speed; a backward speed points clockwise."""
    contact, tip = points(frame, "robot", f"v {k}")
    place = center + scale * contact
    wheel(ax, place, _angle(contact), (0.36, 0.14), color=WHEEL_COLOR)
    arrow(ax, place, center + scale * tip, color=ACCENT)
    out, along = contact, (tip - contact) / np.linalg.norm(tip - contact)
    label(ax, center + scale * tip + 0.17 * along, f"$v_{k}$")
    label(ax, place + 0.26 * out, f"$P_{k}$")


def _velocity(ax: Axes, frame: pd.DataFrame, center: Floats, scale: float) -> None:
    """Draw V with its components along both pairs of axes."""
    tip = center + scale * points(frame, "robot", "V")[1]
    for name, color in (("m", TYPE_COLORS["Z"]), ("W", TYPE_COLORS["Y"])):
        for axis in "XY":
            foot = center + scale * points(frame, "robot", f"V_{axis}_{name}")[1]
            line(ax, [foot, tip], lw=0.8, ls="--", color=color)
            arrow(ax, center, foot, color=color, lw=1.4)
    arrow(ax, center, tip, lw=2.2)
    label(ax, (center + tip) / 2, "$V$", (-0.09, 0.11))
    label(ax, [0.1, 3.9], r"in $\Sigma_m$: $\dot{X}_m, \dot{Y}_m$", ha="left",
          color=TYPE_COLORS["Z"])  # fmt: skip
    label(ax, [0.1, 3.62], r"in $\Sigma_W$: $\dot{X}_W, \dot{Y}_W$", ha="left",
          color=TYPE_COLORS["Y"])  # fmt: skip


def _angle(point: Floats) -> float:
    return float(np.arctan2(point[1], point[0]))


def _arc(ax: Axes, center: Floats, ends: tuple[float, float], radius: float, name: str) -> None:
    """Mark an angle from ends[0] to ends[1] (rad) with its name."""
    sides = {"theta1": np.degrees(ends[0]), "theta2": np.degrees(ends[1])}
    ax.add_patch(Arc(tuple(center), 2 * radius, 2 * radius, lw=0.9, color=INK, **sides))
    middle = (ends[0] + ends[1]) / 2
    label(ax, center + (radius + 0.17) * np.array([np.cos(middle), np.sin(middle)]), name)


def describe_frames(frame: pd.DataFrame) -> str:
    """Say the components that are drawn."""
    said = []
    for name, words in (("m", "the robot's"), ("W", "the world's")):
        parts = [points(frame, "robot", f"{axis}_{name}")[1]
                 @ points(frame, "robot", f"V_{axis}_{name}")[1] for axis in "XY"]  # fmt: skip
        said.append(f"{words} axes it is ({shown(parts[0])}, {shown(parts[1])}) m/s")
    return (
        "A round robot with three wheels on its rim, at 30, 150 and 270 degrees from its own axis"
        " X_m, which is turned by phi from the world's axis X_W. Arrows along the rim are the wheel"
        f" speeds; one arrow is the velocity V: in {', and in '.join(said)}."
    )


def orbit_data() -> pd.DataFrame:
    """Orbit of constant wheel speeds, in m: path, whole circle, centre, both robots, velocity."""
    twist = trajectory.body_twist(ANGLES, BODY_RADIUS, SPEEDS)
    center = _flat(trajectory.circle_centre(twist))
    radius = float(trajectory.circle_radius(twist))
    moments = [LATER * Rational(k, 40) for k in range(41)]
    path = [_flat(trajectory.constant_speed_path(twist, moment)) for moment in moments]
    around = np.linspace(0, 2 * np.pi, 121)
    ring = center + radius * np.column_stack([np.cos(around), np.sin(around)])
    parts = [rows("orbit", "path", path), rows("orbit", "circle", ring), rows("orbit", "O", center)]
    for moment, place in ((0, path[0]), (LATER, path[-1])):
        heading = twist[2] * moment
        turn = trajectory.rotation(heading)
        name = f"robot at {float(moment):g} s"
        wheels = [place + _flat(turn * contact_position(a, BODY_RADIUS)) for a in ANGLES]
        parts.append(rows("orbit", name, [place, *wheels]))
        velocity = _flat(trajectory.world_velocity(twist, heading)[:2, :])
        parts.append(_segment("orbit", f"V at {float(moment):g} s", place, place + velocity))
        forward = _flat(turn * ImmutableMatrix([1, 0]))
        parts.append(_segment("orbit", f"X_m at {float(moment):g} s", place, place + forward))
    return long_form(*parts)


@styled
def draw_orbit(frame: pd.DataFrame) -> Figure:
    """Draw the construction: the centre lies across the velocity, at the distance |V| / |w|."""
    figure, ax = stage(3.9)
    origin, scale = np.array([3.1, 0.85]), 1.0
    at = {name: origin + scale * points(frame, "orbit", name)
          for name in ("path", "circle", "O")}  # fmt: skip
    line(ax, at["circle"], ls=":", alpha=MUTED)
    line(ax, at["path"], lw=2.4, color=WHEEL_COLOR)
    later = f"{float(LATER):g}"
    for moment in ("0", later):
        _small_robot(ax, frame, moment, origin, scale)
    start, end = origin + scale * points(frame, "orbit", "V at 0 s")
    center = at["O"][0]
    line(ax, [start, center], lw=1.2)
    line(ax, [center, at["path"][-1]], lw=1.2, ls="--")
    for axis, unit in (("$X_W$", np.array([1.0, 0])), ("$Y_W$", np.array([0, 1.0]))):
        line(ax, [start, start + 1.3 * unit], lw=0.8, ls=":")
        label(ax, start + 1.3 * unit, axis, (0.16 * unit[0] - 0.17 * unit[1], 0))
    _arc(ax, start, (0.0, _angle(end - start)), 0.72, r"$\psi$")
    spoke = _angle(start - center)
    turned = (spoke, spoke + float(trajectory.body_twist(ANGLES, BODY_RADIUS, SPEEDS)[2] * LATER))
    _arc(ax, center, turned, 0.36, r"$\dot{\phi}\,t$")
    _right_angle(ax, start, end - start, center - start)
    label(ax, center, "$\\mathbb{O}_R$", (-0.2, -0.12))
    label(ax, (start + center) / 2, r"$\mathcal{R}$", (-0.08, -0.17))
    return figure


def _small_robot(ax: Axes, frame: pd.DataFrame, moment: str, origin: Floats, scale: float) -> None:
    """Draw the robot at a moment: body, wheels, own axis, velocity."""
    place, *wheels = origin + scale * points(frame, "orbit", f"robot at {moment} s")
    size = float(np.linalg.norm(wheels[0] - place))
    circle(ax, place, size)
    for contact in wheels:
        wheel(ax, contact, _angle(contact - place), (0.26, 0.1), color=WHEEL_COLOR, alpha=0.7)
    ahead = (origin + scale * points(frame, "orbit", f"X_m at {moment} s")[1] - place) / scale
    arrow(ax, place, place + 1.35 * size * ahead, lw=1.0)
    to_the_right = np.array([ahead[1], -ahead[0]])
    label(ax, place + 1.35 * size * ahead + 0.17 * to_the_right, "$X_m$", size=SMALL_SIZE)
    tip = origin + scale * points(frame, "orbit", f"V at {moment} s")[1]
    arrow(ax, place, tip, color=ACCENT, lw=2.2)
    beyond = 0.2 * (tip - place) / np.linalg.norm(tip - place)
    label(ax, tip + beyond, r"$\mathbb{V}_W$" if moment == "0" else "$\\mathbb{V}_W(t)$")


def _right_angle(ax: Axes, corner: Floats, *sides: Floats) -> None:
    """Mark a right angle by a small square."""
    first, second = (0.13 * side / np.linalg.norm(side) for side in sides)
    line(ax, [corner + first, corner + first + second, corner + second], lw=0.9)


def describe_orbit(frame: pd.DataFrame) -> str:
    """Say centre, radius and direction."""
    x, y = points(frame, "orbit", "O")[0]
    start, end = points(frame, "orbit", "V at 0 s")
    speed, psi = float(np.linalg.norm(end - start)), np.degrees(_angle(end - start))
    return (
        f"A robot starts at the origin with {shown(speed)} m/s towards {shown(psi, 0)} degrees and"
        f" runs along a circle. Its centre lies at a right angle to the velocity, on the left, at"
        f" ({shown(x)}, {shown(y)}) m; the radius is {shown(float(np.hypot(x, y)))} m. A second"
        " robot further along the circle has turned by the same angle as the radius."
    )


ROBOT: Sequence[Drawing] = (
    Drawing(
        1,
        "Wheel speeds, and the velocity in both frames",
        "Velocity V with its components along the robot's axes and along the world's; wheel speeds"
        f" from Eq. (1). {REDRAWN} Velocity, yaw rate and orientation are free choices.",
        frames_data,
        draw_frames,
        describe_frames,
    ),
    Drawing(
        2,
        "Circular orbit of constant wheel speeds",
        "The centre lies across the velocity, on its left for a counter-clockwise rotation, at the"
        f" distance |V|/|φ̇|. {REDRAWN} Here a = c = 5/6 m/s, b = −2/3 m/s and L = 1/2 m.",
        orbit_data,
        draw_orbit,
        describe_orbit,
    ),
)
