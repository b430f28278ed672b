"""Figures 1 and 2: robots on and in a ball, and a ball driven by a pendulum."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import pi

from omniproof.kinematics.frames import origin, rotation, translation
from omniproof.papers.ballbot.figures.scene import (
    BALL_RADIUS,
    BODY,
    CHOICES,
    ball_rows,
    contacts,
    contacts_on_top,
    draw_ball,
    draw_plate,
    draw_wheels,
    level_ring,
    platform_rows,
    wheel_rows,
)
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.globe import dot
from omniproof.report.sketch import (
    REDRAWN,
    View,
    arrow,
    floats,
    label,
    line,
    outlined,
    shown,
    tinted,
)
from omniproof.report.svg import ACCENT, stage, styled

CYLINDER_RADIUS = 0.85
CYLINDER = {"bottom": 1.0, "top": 1.8}
"""Radius of the body, and the heights of its rims (m): free choices."""

SWING, TILT, ROD = pi / 5, pi / 9, 0.6
"""Angles of the pendulum about its two axes (rad) and its length (m): free choices."""


def types_data() -> pd.DataFrame:
    """Wheels on top of a ball, with a cylinder on them, and inside it, with a plate."""
    rims = [
        rows("cylinder", name, level_ring(CYLINDER_RADIUS, height))
        for name, height in CYLINDER.items()
    ]
    return long_form(
        ball_rows("cylinder"),
        wheel_rows("cylinder", contacts_on_top(), -1),
        *rims,
        ball_rows("sphere"),
        wheel_rows("sphere", contacts()),
        platform_rows("sphere", contacts()),
    )


@styled
def draw_types(frame: pd.DataFrame) -> Figure:
    """Draw both robots side by side, at one scale."""
    figure, ax = stage(3.1)
    left, right = View((1.2, 1.15), 0.85), View((3.6, 1.15), 0.85)
    label(ax, [0.1, 2.95], "(a) wheels outside", ha="left")
    label(ax, [2.5, 2.95], "(b) wheels inside", ha="left")
    draw_ball(ax, frame, "cylinder", left)
    draw_wheels(ax, frame, "cylinder", left)
    _cylinder(ax, frame, left)
    draw_ball(ax, frame, "sphere", right)
    draw_plate(ax, frame, "sphere", right)
    draw_wheels(ax, frame, "sphere", right)
    return figure


def _cylinder(ax: Axes, frame: pd.DataFrame, view: View) -> None:
    """Outline of the body: both rims and the two sides that one sees."""
    bottom, top = (view.place(points(frame, "cylinder", name)) for name in ("bottom", "top"))
    left, right = int(np.argmin(top[:, 0])), int(np.argmax(top[:, 0]))
    shell = np.vstack([top[[left, right]], bottom[[right, left]]])
    tinted(ax, shell, BODY, zorder=2)
    tinted(ax, top, BODY, zorder=2.1)
    outlined(ax, top, BODY, zorder=2.2)
    outlined(ax, bottom, BODY, lw=0.9, ls=":", zorder=2.2)
    for side in (left, right):
        line(ax, [top[side], bottom[side]], color=BODY, lw=1.8, zorder=2.2)


def describe_types(frame: pd.DataFrame) -> str:
    """Say where the wheels touch."""
    heights = [float(points(frame, panel, "C 1")[0, 2]) for panel in ("cylinder", "sphere")]
    return (
        "Left, a ball on the ground with a cylinder on top of it: three wheels between them touch"
        f" the ball from outside, {shown(heights[0])} m above its centre for a radius of 1 m."
        " Right, a ball with a level plate inside it: three wheels under the plate touch the inner"
        f" surface {shown(abs(heights[1]))} m below the centre."
    )


def pendulum_data() -> pd.DataFrame:
    """Axle, rod and bob, by two turns about the centre; `rest` is the bob hanging still."""
    turned = rotation("x", TILT) * rotation("y", -SWING) * translation("z", -ROD)
    swung = rotation("y", -SWING) * translation("z", -ROD)
    half = np.array([0, BALL_RADIUS, 0])
    return long_form(
        ball_rows("pendulum"),
        rows("pendulum", "axle", [-half, half]),
        rows("pendulum", "rod", [np.zeros(3), floats(origin(turned)).ravel()]),
        rows("pendulum", "swung", [np.zeros(3), floats(origin(swung)).ravel()]),
        rows("pendulum", "rest", [(0, 0, 0), (0, 0, -ROD)]),
    )


@styled
def draw_pendulum(frame: pd.DataFrame) -> Figure:
    """Draw the ball with axle and pendulum."""
    figure, ax = stage(2.75)
    view = View((2.4, 1.45), 1.15)
    draw_ball(ax, frame, "pendulum", view)
    axle, rod, swung, rest = (
        view.place(points(frame, "pendulum", name)) for name in ("axle", "rod", "swung", "rest")
    )
    line(ax, axle, color=BODY, lw=3)
    line(ax, rest, ls=":")
    line(ax, swung, ls="--")
    line(ax, rod, color=BODY, lw=3, zorder=3)
    _bob(ax, rod[1])
    dot(ax, axle[:1])
    return figure


def _bob(ax: Axes, place: Floats) -> None:
    line(ax, [place], marker="o", ms=17, lw=0, color=BODY, zorder=3)
    arrow(ax, place, place - np.array([0, 0.5]), color=ACCENT)
    label(ax, place, "$mg$", (-0.22, -0.4))


def describe_pendulum(frame: pd.DataFrame) -> str:
    """Say where the weight hangs."""
    forward, sideways, _ = points(frame, "pendulum", "rod")[1]
    return (
        "A ball on the ground with an axle through its centre and a pendulum on the axle. The"
        f" weight hangs {shown(abs(forward))} m ahead of the centre, which makes the ball roll, and"
        f" {shown(abs(sideways))} m beside it, which makes it turn; dotted, the pendulum at rest."
    )


TYPES = (
    Drawing(
        1,
        "Two types of ballbot",
        f"(a) Cylindrical body on a ball, (b) platform in a ball. {REDRAWN} {CHOICES}",
        types_data,
        draw_types,
        describe_types,
    ),
    Drawing(
        2,
        "Pendulum-type driving mechanism",
        "A weight that swings about the axle and tilts with it. The text says no more of it than"
        f" the caption. {REDRAWN}",
        pendulum_data,
        draw_pendulum,
        describe_pendulum,
    ),
)
