"""Figures 3 and 5: paths that the rates of Tables 3 and 4 give, by the closed form."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from sympy import MatrixBase, Symbol, lambdify

from omniproof.papers.omni_trajectory.setup import (
    CIRCLES,
    DURATION,
    LINES,
    RADII,
    Case,
    lengthwise_and_across,
    path,
)
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import REDRAWN, label, line, shown
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, WIDTH, styled

TIME = Symbol("t", nonnegative=True)
MARK_EVERY = 10
TIMES: Floats = np.arange(61) * float(DURATION) / 60
"""Samples of a path every 0.05 s; a dot every 0.5 s."""

COLORS: Mapping[str, str] = dict(
    zip((case.name for case in CIRCLES), (TYPE_COLORS["X"], TYPE_COLORS["Y"]), strict=True)
)
DASHES: Mapping[str, str] = dict(zip(RADII, ("-", "--"), strict=True))
NO_CURVES = "The curves that the paper took from 3D CAD cannot be had, and are not drawn."


def _sampled(place: MatrixBase) -> Floats:
    """Values of an exact place (2x1, of `TIME`) at `TIMES`: M x 2."""
    at_times = (lambdify(TIME, entry, "numpy")(TIMES) for entry in place)
    return np.column_stack([np.broadcast_to(values, TIMES.shape) for values in at_times])


def _over_time(values: Floats) -> Floats:
    """Pair values with the time of their samples: M x 2."""
    return np.column_stack([TIMES, values])


def circles_data() -> pd.DataFrame:
    """Paths of Table 3 and their coordinates over time (x in s), for both body radii."""
    parts: list[Iterator[Row]] = []
    for case in CIRCLES:
        for place, radius in RADII.items():
            sampled = _sampled(path(case, radius, TIME))
            parts.append(rows("path", f"{case.name}, L of {place}", sampled))
            for axis, values in zip("XY", sampled.T, strict=True):
                name = f"{axis}, {case.name}, L of {place}"
                parts.append(rows("over time", name, _over_time(values)))
        parts.append(rows(f"heading {case.name}", "start", _unit(case)))
    return long_form(*parts)


def _unit(case: Case) -> Floats:
    angle = float(case.direction)
    return np.array([[np.cos(angle), np.sin(angle)]])


@styled
def draw_circles(frame: pd.DataFrame) -> Figure:
    """Draw (a) the paths and (b) the coordinates over time."""
    figure = Figure(figsize=(WIDTH, 7.3))
    above = figure.add_axes((0.17, 0.56, 0.8, 0.33))
    middle, below = (figure.add_axes((0.17, low, 0.8, 0.17)) for low in (0.29, 0.08))
    for case in CIRCLES:
        for place in RADII:
            style = {"color": COLORS[case.name], "ls": DASHES[place], "lw": 1.8}
            sampled = points(frame, "path", f"{case.name}, L of {place}")
            line(above, sampled, **style)
            dots = sampled[::MARK_EVERY]
            line(above, dots, marker="o", ms=3.5, lw=0, color=COLORS[case.name])
            for ax, axis in ((middle, "X"), (below, "Y")):
                name = f"{axis}, {case.name}, L of {place}"
                line(ax, points(frame, "over time", name), **style)
    _name_paths(above, frame)
    for ax, axis in ((middle, "X"), (below, "Y")):
        ax.set(xlim=(0, float(DURATION)), ylabel=f"${axis}_W$ [m]", ylim=(-0.07, 0.15))
        ax.set_yticks([-0.05, 0, 0.05, 0.1, 0.15])
        ax.grid(visible=True)
    middle.set_title("(b) coordinates over time")
    middle.tick_params(labelbottom=False)
    below.set_xlabel("$t$ [s]")
    handles = [Line2D([], [], color=INK, ls=DASHES[place], label=_body_radius(place))
               for place in RADII]  # fmt: skip
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.14, 1.0), handlelength=2.4)
    return figure


def _body_radius(place: str) -> str:
    return f"$L = {float(RADII[place]):.3f}$ m ({place})"


def _name_paths(ax: Axes, frame: pd.DataFrame) -> None:
    """Name the paths, and show their common direction at the start."""
    ax.set_aspect("equal")
    ax.set(xlim=(-0.09, 0.15), ylim=(-0.012, 0.15), xlabel="$X_W$ [m]", ylabel="$Y_W$ [m]")
    ax.set_xticks([-0.05, 0, 0.05, 0.1, 0.15])
    ax.set_yticks([0, 0.05, 0.1, 0.15])
    ax.set_title("(a) paths, a dot every 0.5 s")
    ax.grid(visible=True)
    ((x, y),) = points(frame, f"heading {CIRCLES[0].name}", "start")
    line(ax, [[0, 0], [0.14 * x, 0.14 * y]], ls=":", color=ACCENT)
    label(ax, [0.14 * x, 0.14 * y], "60°", (0.013, 0.005), color=ACCENT, size=SMALL_SIZE)
    for case, at, name in zip(CIRCLES, ([-0.045, 0.06], [0.12, 0.065]),
                              ("left rotation", "clockwise"), strict=True):  # fmt: skip
        label(ax, at, name, size=SMALL_SIZE, color=COLORS[case.name])


def describe_circles(frame: pd.DataFrame) -> str:
    """Say where each path ends."""
    ends = []
    for case in CIRCLES:
        said = []
        for place, radius in RADII.items():
            x, y = points(frame, "path", f"{case.name}, L of {place}")[-1]
            said.append(f"({shown(x, 3)}, {shown(y, 3)}) m for L = {float(radius):.3f} m")
        ends.append(f"{case.name} at {' or '.join(said)}")
    return (
        "Four arcs that leave the origin at 60 degrees, two to the left and two clockwise, one for"
        f" each body radius that the paper prints, and below them both coordinates over"
        f" {float(DURATION):g} seconds. They end: {'; '.join(ends)}."
    )


def lines_data() -> pd.DataFrame:
    """Paths of Table 4 with both body radii, and the place across the intended line in mm."""
    parts: list[Iterator[Row]] = []
    for case in LINES:
        ends = 0.155 * np.vstack([np.zeros((1, 2)), _unit(case)])
        parts.append(rows(case.name, "intended", ends))
        for place, radius in RADII.items():
            sampled = _sampled(path(case, radius, TIME))
            parts.append(rows(case.name, f"path, L of {place}", sampled))
            for axis, values in zip("XY", sampled.T, strict=True):
                parts.append(rows(case.name, f"{axis} over time, {place}", _over_time(values)))
            across = 1000 * _sampled(lengthwise_and_across(case, radius, TIME))[:, 1]
            parts.append(rows("across", f"{case.name}, L of {place}", _over_time(across)))
    return long_form(*parts)


@styled
def draw_lines(frame: pd.DataFrame) -> Figure:
    """Draw (a)-(d) the four paths, and below them how far they are beside the intended line."""
    height = 7.6
    figure = Figure(figsize=(WIDTH, height))
    for k, (case, letter) in enumerate(zip(LINES, "abcd", strict=True)):
        left, low = (0.15, 0.57)[k % 2], (0.71, 0.4)[k // 2]
        ax = figure.add_axes((left, low, 0.4, 0.4 * WIDTH / height))
        _line_panel(ax, frame, case)
        ax.set_title(rf"({letter}) $\varphi$ = {case.name}", pad=3)
        ax.tick_params(labelbottom=k >= 2, labelleft=k % 2 == 0)
        if k >= 2:
            ax.set_xlabel("$X_W$ [m]")
        if k % 2 == 0:
            ax.set_ylabel("$Y_W$ [m]", labelpad=2)
    _across_panel(figure.add_axes((0.15, 0.08, 0.82, 0.2)), frame)
    return figure


def _line_panel(ax: Axes, frame: pd.DataFrame, case: Case) -> None:
    """Draw one path on its intended line; both body radii give one line at this scale."""
    ax.set(xlim=(-0.012, 0.165), ylim=(-0.012, 0.165))
    ticks, names = [0, 0.05, 0.1, 0.15], ["0", "0.05", "0.1", "0.15"]
    ax.set_xticks(ticks, labels=names)
    ax.set_yticks(ticks, labels=names)
    ax.grid(visible=True)
    line(ax, points(frame, case.name, "intended"), color=ACCENT, lw=5, alpha=0.35)
    first = next(iter(RADII))
    sampled = points(frame, case.name, f"path, L of {first}")
    line(ax, sampled, lw=1.6, color=TYPE_COLORS["X"])
    line(ax, sampled[::MARK_EVERY], marker="o", ms=3.5, lw=0, color=TYPE_COLORS["X"])


def _across_panel(ax: Axes, frame: pd.DataFrame) -> None:
    """Draw the place across the line over time; a name stands beside each curve."""
    for case in LINES:
        for place in RADII:
            aside = points(frame, "across", f"{case.name}, L of {place}")
            line(ax, aside, ls=DASHES[place], color=TYPE_COLORS["X"], lw=1.6)
    for at, name in (([2.3, 0.58], "0°"), ([2.3, 0.12], "30° and 90°"), ([2.3, -0.58], "60°")):
        label(ax, at, name, size=SMALL_SIZE)
    ax.set(xlim=(0, float(DURATION)), ylim=(-0.8, 0.8), xlabel="$t$ [s]", ylabel="[mm]")
    ax.set_title("(e) beside the line, positive to the left", pad=3)
    ax.grid(visible=True)
    for place, radius in RADII.items():
        ax.plot([], [], color=INK, ls=DASHES[place], label=f"$L = {float(radius):.3f}$ m")
    ax.legend(loc="upper left", handlelength=2.4, borderaxespad=0.1)


def describe_lines(frame: pd.DataFrame) -> str:
    """Say the length of the paths, and how far they end beside the lines."""
    first = next(iter(RADII))
    ends = {case.name: points(frame, case.name, f"path, L of {first}")[-1] for case in LINES}
    lengths = [float(np.linalg.norm(end)) for end in ends.values()]
    aside = [
        shown(abs(points(frame, "across", f"{LINES[0].name}, L of {place}")[-1, 1]))
        for place in RADII
    ]
    return (
        "Four paths from the origin in the directions 0, 30, 60 and 90 degrees, each about"
        f" {shown(float(np.mean(lengths)), 3)} m long. A panel below shows how far they are beside"
        " the intended line: nothing for 30 and 90 degrees; for 0 degrees to the left and for 60"
        f" degrees to the right, growing to {aside[0]} or {aside[1]} mm, as the body radius is"
        " taken from Table 1 or Section 3.1."
    )


PATHS = (
    Drawing(
        3,
        "Circular paths of Table 3",
        "Computed from the printed rates of the wheels with r = 0.023 m in T = 3 s, by the closed"
        f" form. The paper prints two body radii L, and the arcs differ. {REDRAWN} {NO_CURVES}",
        circles_data,
        draw_circles,
        describe_circles,
    ),
    Drawing(
        5,
        "Straight paths of Table 4",
        "Computed from the printed rates with r = 0.023 m in T = 3 s; wide: the intended line. A"
        f" dot every 0.5 s. {REDRAWN} {NO_CURVES}",
        lines_data,
        draw_lines,
        describe_lines,
    ),
)
