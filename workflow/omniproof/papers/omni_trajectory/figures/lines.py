"""Figure 5: the lines of Table 4, by the closed form and in simulation."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from omniproof.kinematics.trajectory import rotation
from omniproof.papers.omni_trajectory.figures.circles import apart
from omniproof.papers.omni_trajectory.figures.paths import (
    DASHES,
    LAID_OVER,
    STARTS,
    TIME,
    distance_panel,
    distances,
    handles,
    marked,
    over_time,
    recorded,
    sampled,
    simulated,
)
from omniproof.papers.omni_trajectory.setup import (
    DURATION,
    LINES,
    RADII,
    Case,
    lengthwise_and_across,
    path,
)
from omniproof.report.figure import Drawing, Row, long_form, points, rows
from omniproof.report.sketch import REDRAWN, floats, label, line, shown
from omniproof.report.svg import ACCENT, SMALL_SIZE, TYPE_COLORS, WIDTH, styled

RUN_RADIUS = next(iter(RADII))
RUNS = tuple(product(LINES, STARTS))
"""All that is simulated, with the body radius `RUN_RADIUS`: case and start."""


def _data(*recordings: pd.DataFrame) -> pd.DataFrame:
    """Paths of Table 4 with both body radii, and the place across the intended line in mm."""
    parts: list[Iterator[Row]] = [_theory(case) for case in LINES]
    for (case, start), recording in zip(RUNS, recordings, strict=True):
        found = simulated(recording)
        parts.append(
            distances(f"{case.name}, {start}", sampled(path(case, RADII[RUN_RADIUS], TIME)), found)
        )
        if start == "flying":
            aside = 1000 * (found @ floats(rotation(-case.direction)).T)[:, 1]
            parts.append(rows(case.name, "simulated", found))
            parts.append(rows("across", f"{case.name}, simulated", over_time(aside)))
    return long_form(*parts)


def _theory(case: Case) -> Iterator[Row]:
    angle = float(case.direction)
    yield from rows(case.name, "intended", [[0, 0], [0.155 * np.cos(angle), 0.155 * np.sin(angle)]])
    for place, radius in RADII.items():
        places = sampled(path(case, radius, TIME))
        yield from rows(case.name, f"path, L of {place}", places)
        for axis, values in zip("XY", places.T, strict=True):
            yield from rows(case.name, f"{axis} over time, {place}", over_time(values))
        across = 1000 * sampled(lengthwise_and_across(case, radius, TIME))[:, 1]
        yield from rows("across", f"{case.name}, L of {place}", over_time(across))


@styled
def draw_lines(frame: pd.DataFrame) -> Figure:
    """Draw (a)-(d) the four paths, (e) the places beside the intended line, (f) distances."""
    height = 9.9
    figure = Figure(figsize=(WIDTH, height))
    for k, (case, letter) in enumerate(zip(LINES, "abcd", strict=True)):
        left, low = (0.15, 0.57)[k % 2], (0.7, 0.465)[k // 2]
        ax = figure.add_axes((left, low, 0.4, 0.4 * WIDTH / height))
        _line_panel(ax, frame, case)
        ax.set_title(rf"({letter}) $\varphi$ = {case.name}", pad=3)
        ax.tick_params(labelbottom=k >= 2, labelleft=k % 2 == 0)
        if k >= 2:
            ax.set_xlabel("$X_W$ [m]")
        if k % 2 == 0:
            ax.set_ylabel("$Y_W$ [m]", labelpad=2)
    _across_panel(figure.add_axes((0.15, 0.225, 0.82, 0.155)), frame)
    names = [(start, f"{case.name}, {start}") for case, start in RUNS]
    curves = ((start, points(frame, "distance", name)) for start, name in names)
    distance_panel(figure.add_axes((0.15, 0.06, 0.82, 0.1)), curves, "f")
    figure.legend(handles=handles(), loc="upper left", bbox_to_anchor=(0.12, 1.0), handlelength=2.4)
    return figure


def _line_panel(ax: Axes, frame: pd.DataFrame, case: Case) -> None:
    """Draw one path on its intended line; both body radii give one line at this scale."""
    ax.set(xlim=(-0.012, 0.165), ylim=(-0.012, 0.165))
    ticks, names = [0, 0.05, 0.1, 0.15], ["0", "0.05", "0.1", "0.15"]
    ax.set_xticks(ticks, labels=names)
    ax.set_yticks(ticks, labels=names)
    ax.grid(visible=True)
    line(ax, points(frame, case.name, "intended"), color=ACCENT, lw=5, alpha=0.35)
    theory = points(frame, case.name, f"path, L of {RUN_RADIUS}")
    line(ax, theory, lw=1.6, color=TYPE_COLORS["X"])
    marked(ax, points(frame, case.name, "simulated"))


def _across_panel(ax: Axes, frame: pd.DataFrame) -> None:
    """Draw the place across the line over time; a name stands beside each curve."""
    for case in LINES:
        for place in RADII:
            aside = points(frame, "across", f"{case.name}, L of {place}")
            line(ax, aside, ls=DASHES[place], color=TYPE_COLORS["X"], lw=1.6)
        marked(ax, points(frame, "across", f"{case.name}, simulated"))
    for at, name in (([2.1, 0.62], "0°"), ([2.3, 0.2], "30° and 90°"), ([2.1, -0.62], "60°")):
        label(ax, at, name, size=SMALL_SIZE)
    ax.set(xlim=(0, float(DURATION)), ylim=(-0.8, 0.8), ylabel="[mm]")
    ax.set_title("(e) beside the line, positive to the left", pad=3)
    ax.grid(visible=True)


def describe_lines(frame: pd.DataFrame) -> str:
    """Say the length of the paths, how far they end beside the lines, and from the simulation."""
    ends = {case.name: points(frame, case.name, f"path, L of {RUN_RADIUS}")[-1] for case in LINES}
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
        " taken from Table 1 or Section 3.1. Rings of the simulation lie on the paths;"
        f" {apart(frame)}."
    )


LINES_FIGURE = Drawing(
    5,
    "Straight paths of Table 4",
    "Computed from the printed rates with r = 0.023 m in T = 3 s; wide: the intended line."
    f" {LAID_OVER} Its body radius is that of {RUN_RADIUS}. {REDRAWN}",
    _data,
    draw_lines,
    describe_lines,
    tuple(recorded(case, start, RUN_RADIUS) for case, start in RUNS),
)
