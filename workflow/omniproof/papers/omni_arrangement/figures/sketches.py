"""Figures 1 and 2: the three types, and the parameters of the robot and of one wheel."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc
from sympy import ImmutableMatrix, MatrixBase, Rational, cos, pi, sin

from omniproof.kinematics.omni import contact_position, rolling_speed, tangential_direction
from omniproof.papers.omni_arrangement.arrangements import CORRECTED, PRINTED
from omniproof.papers.omni_arrangement.figures.parts import TYPES
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import MUTED, REDRAWN, arrow, circle, floats, label, line, shown, wheel
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, WIDTH, stage, styled

HEADING = pi / 9
ROLLER_RADIUS = Rational(1, 5)
VELOCITY = ImmutableMatrix([Rational(1, 5), Rational(9, 10)])
YAW_RATE = Rational(2, 5)
WHEEL = 0
"""Free choices of Figure 2 (rad, m, m/s, rad/s), and the wheel that panel (b) shows."""


def types_data() -> pd.DataFrame:
    """Contacts of the wheels for L = 1 m; `printed wheel` where the paper prints another place."""
    parts = []
    for kind in TYPES:
        for k, (angle, printed) in enumerate(zip(CORRECTED[kind], PRINTED[kind], strict=True), 1):
            parts.append(rows(kind, f"wheel {k}", floats(contact_position(angle, 1)).T))
            if angle != printed:
                contact = floats(contact_position(printed, 1)).T
                parts.append(rows(kind, f"printed wheel {k}", contact))
    return long_form(*parts)


@styled
def draw_types(frame: pd.DataFrame) -> Figure:
    """Draw three robots from above, side by side."""
    figure, ax = stage(1.85)
    for column, kind in enumerate(TYPES):
        center = np.array([WIDTH / 2 + 1.55 * (column - 1), 0.85])
        label(ax, center, f"Type ({kind})", (0, 0.82))
        _robot(ax, frame[frame["panel"] == kind], center, TYPE_COLORS[kind])
    return figure


def _robot(ax: Axes, part: pd.DataFrame, center: Floats, color: str) -> None:
    """Draw one robot: body, triangle of the contacts, wheels with their angles."""
    radius, size = 0.42, (0.28, 0.11)
    circle(ax, center, radius)
    for row in part.itertuples():
        contact = np.array([row.x, row.y], dtype=np.float64)
        angle = float(np.arctan2(contact[1], contact[0]))
        text = f"{round(np.degrees(angle)) % 360}°"
        if str(row.series).startswith("printed"):
            dashes = {"fill": False, "edgecolor": INK, "ls": (0, (2, 1)), "lw": 1.1}
            wheel(ax, center + radius * contact, angle, size, **dashes)
            _struck(ax, center + 0.74 * contact + np.array([0.2, 0]), text)
        else:
            wheel(ax, center + radius * contact, angle, size, color=color)
            label(ax, center + 0.7 * contact, text, size=SMALL_SIZE)
    real = part[~part["series"].str.startswith("printed")][["x", "y"]].to_numpy(dtype=np.float64)
    line(ax, center + radius * np.vstack([real, real[:1]]), ls="--", lw=0.9, alpha=MUTED)


def _struck(ax: Axes, at: Floats, text: str) -> None:
    label(ax, at, text, size=SMALL_SIZE, alpha=MUTED)
    half = np.array([0.18, 0])
    line(ax, [at - half, at + half], zorder=7)


def describe_types(frame: pd.DataFrame) -> str:
    """Name the angles of each type."""
    said = []
    for kind in TYPES:
        part = frame[(frame["panel"] == kind) & ~frame["series"].str.startswith("printed")]
        said.append(f"type ({kind}) at {', '.join(_angles(part))} degrees")
    ghost = _angles(frame[frame["series"].str.startswith("printed")])
    return (
        f"Three round robots seen from above, each with three wheels on its rim: {'; '.join(said)}."
        f" The wheel printed at {ghost[0]} degrees is shown as a dashed ghost."
    )


def _angles(part: pd.DataFrame) -> list[str]:
    turned = np.degrees(np.arctan2(part["y"], part["x"])) % 360
    return [str(round(angle)) for angle in turned]


def parameters_data() -> pd.DataFrame:
    """Directions and speeds of Figure 2 as segments (start, end), in m and m/s, in world axes."""
    turn = ImmutableMatrix([[cos(HEADING), -sin(HEADING)], [sin(HEADING), cos(HEADING)]])
    parts = []
    for k, angle in enumerate(CORRECTED["X"], 1):
        contact, direction = contact_position(angle, 1), tangential_direction(angle)
        segment = [turn * contact, turn * (contact + direction * Rational(11, 20))]
        parts.append(_segment("robot", f"n {k}", *segment))
    origin = ImmutableMatrix([0, 0])
    for name, unit in (("X' axis", [1, 0]), ("Y' axis", [0, 1])):
        parts.append(_segment("robot", name, origin, turn * ImmutableMatrix(unit)))
    angle = CORRECTED["X"][WHEEL]
    contact, direction = contact_position(angle, 1), tangential_direction(angle)
    still = ImmutableMatrix([0, 0])
    translation = rolling_speed(direction, contact, VELOCITY, 0)
    rotation = rolling_speed(direction, contact, still, YAW_RATE)
    middle = contact + direction * translation
    parts.append(_segment("wheel", "q", origin, contact))
    parts.append(_segment("wheel", "V", contact, contact + VELOCITY))
    parts.append(_segment("wheel", "n", contact, contact + direction))
    parts.append(_segment("wheel", "v^T", contact, middle))
    parts.append(_segment("wheel", "v^R", middle, middle + direction * rotation))
    total = rolling_speed(direction, contact, VELOCITY, YAW_RATE)
    parts.append(_segment("wheel", "v", contact, contact + direction * total))
    parts.append(_segment("wheel", "R", contact, contact - direction * ROLLER_RADIUS))
    return long_form(*parts)


def _segment(panel: str, series: str, start: MatrixBase, end: MatrixBase) -> Iterator[Row]:
    return rows(panel, series, [floats(start).ravel(), floats(end).ravel()])


@styled
def draw_parameters(frame: pd.DataFrame) -> Figure:
    """Draw (a) the robot in the world and (b) the speeds at one wheel."""
    figure, ax = stage(5.8)
    label(ax, [0.1, 5.62], "(a) robot", ha="left")
    _whole(ax, frame, np.array([2.5, 4.3]), 0.9)
    label(ax, [0.1, 2.8], f"(b) one wheel, $k = {WHEEL + 1}$", ha="left")
    _neighbourhood(ax, frame, np.array([0.75, 0.25]), 1.5)
    return figure


def _whole(ax: Axes, frame: pd.DataFrame, center: Floats, scale: float) -> None:
    """Panel (a): world axes, body axes turned by phi, wheels with q and n."""
    corner = np.array([0.4, 3.3])
    for unit, name in ((np.array([1, 0]), "$X$"), (np.array([0, 1]), "$Y$")):
        arrow(ax, corner, corner + 0.5 * unit, lw=1.0)
        label(ax, corner + 0.63 * unit, name)
    label(ax, corner, "$O$", (-0.13, -0.11))
    circle(ax, center, scale)
    line(ax, [center, center + np.array([0.85, 0])], lw=0.8, ls=":")
    for name in ("X'", "Y'"):
        _, end = points(frame, "robot", f"{name} axis")
        arrow(ax, center, center + 1.5 * scale * end, lw=1.0)
        label(ax, center + 1.65 * scale * end, f"${name}$")
    label(ax, center, "$O'$", (-0.17, -0.06))
    for k in range(1, 4):
        contact, tip = (center + scale * point for point in points(frame, "robot", f"n {k}"))
        out, along = (contact - center) / scale, (tip - contact) / np.linalg.norm(tip - contact)
        wheel(ax, contact, float(np.arctan2(out[1], out[0])), (0.36, 0.14), color=TYPE_COLORS["X"])
        arrow(ax, center, contact, lw=1.0, alpha=MUTED)
        arrow(ax, contact, tip, color=ACCENT)
        label(ax, tip + 0.17 * along, f"$n_{k}$")
        label(ax, contact + 0.25 * out, f"$q_{k}$")
    label(ax, center + scale * points(frame, "robot", "n 2")[0] / 2, "$L$", (0.0, 0.15))
    _angles_of(ax, frame, center)


def _angles_of(ax: Axes, frame: pd.DataFrame, center: Floats) -> None:
    """Mark phi from X to X' and alpha_1 from X' to q_1."""
    heading, position = (
        float(np.arctan2(point[1], point[0]))
        for point in (points(frame, "robot", "X' axis")[1], points(frame, "robot", "n 1")[0])
    )
    for low, high, radius, name in (
        (0.0, heading, 0.62, r"$\phi$"),
        (heading, position, 0.4, r"$\alpha_1$"),
    ):
        ends = {"theta1": np.degrees(low), "theta2": np.degrees(high)}
        ax.add_patch(Arc(tuple(center), 2 * radius, 2 * radius, lw=0.9, color=INK, **ends))
        middle = (low + high) / 2
        label(ax, center + (radius + 0.15) * np.array([np.cos(middle), np.sin(middle)]), name)


def _neighbourhood(ax: Axes, frame: pd.DataFrame, origin: Floats, scale: float) -> None:
    """Panel (b): v is the projection of V on n plus the share of the rotation."""
    names = ("q", "V", "n", "v^T", "v^R", "v", "R")
    ends = {name: origin + scale * points(frame, "wheel", name) for name in names}
    contact = ends["q"][1]
    out, along = (contact - origin) / scale, (ends["n"][1] - contact) / scale
    angle = float(np.arctan2(out[1], out[0]))
    rim = {"theta1": np.degrees(angle) - 38, "theta2": np.degrees(angle) + 55}
    ax.add_patch(Arc(tuple(origin), 2 * scale, 2 * scale, color=INK, lw=1.2, **rim))
    length = 2 * float(np.linalg.norm(ends["R"][1] - contact))
    wheel(ax, contact, angle, (length, 0.22), color=TYPE_COLORS["X"], alpha=0.35, lw=0)
    arrow(ax, origin, contact, lw=1.0, alpha=MUTED)
    label(ax, origin, "$O'$", (-0.15, -0.05))
    label(ax, (origin + contact) / 2, "$q$", (-0.08, 0.12))
    label(ax, (origin + contact) / 2, "$|q| = L$", (0.3, -0.15))
    arrow(ax, *(ends["R"] + 0.2 * out), lw=1.0, arrowstyle="|-|", mutation_scale=3)
    label(ax, ends["R"].mean(axis=0) + 0.36 * out, "$R$")
    line(ax, [ends["V"][1], ends["v^T"][1]], ls=":")
    arrow(ax, *ends["V"])
    label(ax, ends["V"][1], "$V$", (0.12, 0.08))
    inner = -0.2 * out
    arrow(ax, *(ends["n"] + 2.2 * inner), lw=1.2)
    label(ax, ends["n"].mean(axis=0) + 3.0 * inner, "$n$")
    arrow(ax, *ends["v^T"], color=TYPE_COLORS["Y"], lw=2.4)
    label(ax, ends["v^T"].mean(axis=0) - 0.95 * inner + 0.12 * along, "$v^T$")
    arrow(ax, *ends["v^R"], color=TYPE_COLORS["Z"], lw=2.4)
    label(ax, ends["v^R"][1], r"$v^R = L\dot{\phi}$", (0.1, 0.08), ha="left")
    arrow(ax, *(ends["v"] + inner), color=ACCENT, lw=2.4)
    label(ax, ends["v"].mean(axis=0) + 1.7 * inner + 0.5 * along, "$v$")


def describe_parameters(frame: pd.DataFrame) -> str:
    """Say the sum of the two shares with the drawn numbers."""
    share, rotation, total = (
        float(np.linalg.norm(np.diff(points(frame, "wheel", name), axis=0)))
        for name in ("v^T", "v^R", "v")
    )
    return (
        "Above, a round robot of radius L turned by the angle phi, with contacts q and driven"
        " directions n tangent to its rim. Below, one wheel: the projection of the velocity V on n,"
        f" {shown(share)} m/s, and the share of the rotation, {shown(rotation)} m/s, add up to the"
        f" wheel speed {shown(total)} m/s."
    )


SKETCHES = (
    Drawing(
        1,
        "Three arrangements of three wheels",
        f"Types (X), (Y) and (Z) with the angles of Section 4; lengths in units of L. {REDRAWN}"
        " The printed angles of type (Z) give no isosceles triangle; the corrected type is drawn,"
        " and the printed wheel is struck out.",
        types_data,
        draw_types,
        describe_types,
    ),
    Drawing(
        2,
        "Parameters of the robot and of one wheel",
        "Contacts q, driven directions n, body radius L, roller radius R, orientation φ, and the"
        f" decomposition of a wheel speed in Eq. (3). {REDRAWN} Velocity, yaw rate, orientation and"
        " R are free choices of the drawing.",
        parameters_data,
        draw_parameters,
        describe_parameters,
    ),
)
