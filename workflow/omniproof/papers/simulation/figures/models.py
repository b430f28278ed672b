"""Pictures of the models: what is simulated, drawn from what the engine was given."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

from omniproof.papers.simulation.figures.solids import Part, at_rest, platform, rims, solids
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import View, label, line
from omniproof.report.svg import INK, SMALL_SIZE, TYPE_COLORS, WIDTH, stage, styled
from omniproof.simulation import ballbot_model, omni_model, sphere_model, sphere_rollers

BODY, ROLLER, OTHER_ROLLER = "#93a1ae", TYPE_COLORS["X"], "#7db8e3"
"""Bodies hide what is behind them, on a light page and on a dark one; rollers in turn."""

ZENITH_DEG, TILT_DEG, PATTERN = 30.0, 30.0, (30.0, 17.0)
"""Which of the cases are drawn: the ballbot's wheels, two rollers, elevation and phase of three."""

LOOKS: Mapping[str, Mapping[str, Any]] = {
    "floor": {"facecolor": INK, "alpha": 0.08, "lw": 0},
    "platform": {"facecolor": (INK, 0.3), "edgecolor": INK, "lw": 0.9},
    "glass": {"facecolor": (BODY, 0.3), "edgecolor": INK, "lw": 0.9},
    "roller": {"facecolor": ROLLER, "edgecolor": INK, "lw": 0.9},
    "passive": {"facecolor": ROLLER, "edgecolor": INK, "lw": 0.5},
}
SOLID: Mapping[str, Any] = {"facecolor": BODY, "edgecolor": INK, "lw": 0.9}
THIN: Mapping[str, float] = {"rim": 0.8, "axle": 2.4}
"""Looks of parts by the first word of their names; widths of those that are lines."""

FROM_MODEL = (
    "Drawn from the model that is simulated, as the engine has it before the first step. The papers"
    " have no such figure."
)

# Data --------------------------------------------------------------------------------------------


def _painted(panel: str, parts: Iterable[Part]) -> Iterator[Row]:
    """Yield parts as series of a panel, in the order in which they are drawn: nearest last."""
    for part in sorted(parts, key=lambda part: part.depth):
        yield from rows(panel, part.name, part.points)


def _floor(half_side: float) -> Part:
    """Return a square of the floor, below all."""
    corners = half_side * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
    return Part("floor", corners, -np.inf)


def robot_data() -> pd.DataFrame:
    """Body, wheels and rollers of the robot on its floor; places in m."""
    found = at_rest(omni_model.mjcf(omni_model.Robot()))
    return long_form(_painted("robot", [_floor(0.13), *rims(*found), *solids(*found)]))


def ball_data() -> pd.DataFrame:
    """The platform inside the ball, and on top of it; places in m."""
    robots = {
        panel: ballbot_model.Ballbot(panel == "inside", ZENITH_DEG)
        for panel in ("inside", "on top")
    }
    return long_form(*(_painted(panel, _ball(robot)) for panel, robot in robots.items()))


def _ball(robot: ballbot_model.Ballbot) -> Iterator[Part]:
    found = at_rest(ballbot_model.mjcf(robot))
    yield _floor(0.1)
    for part in solids(*found):
        if part.name == "ball":
            # What is inside a ball of glass is drawn on top of it.
            yield Part("glass", part.points, -1.0) if robot.inside else part
        elif part.name != "surface":
            yield part
    yield from (*rims(*found), platform(*found))


def sphere_data() -> pd.DataFrame:
    """The sphere between two rollers and between three; places in m."""
    set_ups = {
        "two rollers": sphere_rollers.two_rollers(TILT_DEG),
        "three rollers": sphere_rollers.three_rollers(*PATTERN),
    }
    found = {
        panel: at_rest(sphere_model.xml(set_up.rollers, 1.0)) for panel, set_up in set_ups.items()
    }
    return long_form(*(_painted(panel, solids(*one)) for panel, one in found.items()))


# Pictures ----------------------------------------------------------------------------------------


@styled
def draw_robot(frame: pd.DataFrame) -> Figure:
    """Draw the robot, with a scale."""
    figure, ax = stage(2.75)
    view = View((WIDTH / 2, 1.2), 14.5)
    _draw_scene(ax, frame, "robot", view)
    _scale(ax, view, 0.05, (0.2, 0.2))
    return figure


@styled
def draw_ball(frame: pd.DataFrame) -> Figure:
    """Draw the ball with the platform inside, and with the platform on top."""
    figure, ax = stage(3.35)
    for panel, left in (("inside", 1.2), ("on top", 3.6)):
        view = View((left, 0.75), 9.6)
        _draw_scene(ax, frame, panel, view)
        label(ax, (left, 3.2), panel)
    _scale(ax, view, 0.05, (0.15, 0.15))
    return figure


@styled
def draw_sphere(frame: pd.DataFrame) -> Figure:
    """Draw the sphere between two rollers and between three."""
    figure, ax = stage(2.75)
    for panel, left in (("two rollers", 1.2), ("three rollers", 3.6)):
        view = View((left, 1.25), 0.82)
        _draw_scene(ax, frame, panel, view)
        label(ax, (left, 2.6), panel)
    _scale(ax, view, 0.5, (0.15, 0.15))
    return figure


def _draw_scene(ax: Axes, frame: pd.DataFrame, panel: str, view: View) -> None:
    """Draw the parts of a panel in their order."""
    for order, name in enumerate(frame[frame["panel"] == panel]["series"].drop_duplicates()):
        _draw_part(ax, name, view.place(points(frame, panel, name)), 2 + order / 1000)


def _draw_part(ax: Axes, name: str, outline: Floats, order: float) -> None:
    kind, *number = name.replace(",", "").split()
    if kind in THIN:
        line(ax, outline, lw=THIN[kind], zorder=order)
        return
    style = dict(LOOKS.get(kind, SOLID))
    if kind == "passive" and int(number[0]) % 2:
        style["facecolor"] = OTHER_ROLLER
    ax.add_patch(Polygon(outline, zorder=order, **style))


def _scale(ax: Axes, view: View, length: float, at: tuple[float, float]) -> None:
    """Draw a bar of a length (m) as it is across the view."""
    x, y = at
    end = x + length * view.scale
    line(ax, [(x, y), (end, y)], lw=2)
    label(ax, (end, y), f"{100 * length:g} cm", (0.08, 0), ha="left", size=SMALL_SIZE)


# Words -------------------------------------------------------------------------------------------


def _count(frame: pd.DataFrame, panel: str, kind: str) -> int:
    """Number of parts of a kind in a panel; the faces of cylinders do not count."""
    names = frame[frame["panel"] == panel]["series"].drop_duplicates()
    return sum(name.split()[0] == kind and "," not in name for name in names)


def describe_robot(frame: pd.DataFrame) -> str:
    """Count the parts."""
    wheels, rollers = (_count(frame, "robot", kind) for kind in ("rim", "passive"))
    return (
        f"A flat round body on a floor; {wheels} upright wheels stand at its edge, along the edge."
        f" Each wheel is a ring of {rollers // wheels} spindle-shaped rollers, strung on the rim"
        " like beads."
    )


def describe_ball(frame: pd.DataFrame) -> str:
    """Count the wheels of both pictures."""
    inside, on_top = (_count(frame, panel, "rim") for panel in ("inside", "on top"))
    return (
        f"Left, a ball of glass: {inside} wheels of small rollers stand low inside it on its"
        f" surface, joined by a triangle. Right, a solid ball: {on_top} wheels stand high on it"
        " from outside, joined by a triangle."
    )


def describe_sphere(frame: pd.DataFrame) -> str:
    """Count the rollers of both pictures."""
    two, three = (_count(frame, panel, "roller") for panel in ("two rollers", "three rollers"))
    return (
        f"Left, a sphere that {two} short cylinders touch on its upper half, with crossed axes."
        f" Right, a sphere that {three} short cylinders touch above its equator, evenly spread."
    )


MODELS = (
    Drawing(
        "robot",
        "The robot that is simulated",
        "Each passive roller (blue) is a body on a hinge; the rollers of a wheel overlap and touch"
        f" nothing but the floor. Thin: the line through the hinges, and the axles. {FROM_MODEL}",
        robot_data,
        draw_robot,
        describe_robot,
    ),
    Drawing(
        "ball",
        "The ball, with the platform inside and on top",
        f"Zenith angle {ZENITH_DEG:g}°. The platform has a mass and no shape; the triangle joins"
        f" its hubs. The tiles that line the ball are left out. {FROM_MODEL}",
        ball_data,
        draw_ball,
        describe_ball,
    ),
    Drawing(
        "sphere",
        "The sphere between rollers",
        f"Left with roller angles of ±{TILT_DEG:g}°, right at an elevation of {PATTERN[0]:g}°. Each"
        f" roller slides along the line through the centre, and a load presses it. {FROM_MODEL}",
        sphere_data,
        draw_sphere,
        describe_sphere,
    ),
)
"""One picture a model."""
