"""Figure 3: the circles of Table 3, by the closed form and in simulation."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

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
from omniproof.papers.omni_trajectory.setup import CIRCLES, DURATION, RADII, Case, path
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import REDRAWN, label, line, shown
from omniproof.report.svg import ACCENT, SMALL_SIZE, TYPE_COLORS, WIDTH, styled

COLORS: Mapping[str, str] = dict(
    zip((case.name for case in CIRCLES), (TYPE_COLORS["X"], TYPE_COLORS["Y"]), strict=True)
)
RUNS = tuple(product(CIRCLES, RADII, STARTS))
"""All that is simulated: case, place that prints the body radius, start."""


def _data(*recordings: pd.DataFrame) -> pd.DataFrame:
    """Paths of Table 3 and their coordinates over time (x in s), for both body radii."""
    parts: list[Iterator[Row]] = []
    for (case, place, start), recording in zip(RUNS, recordings, strict=True):
        theory, name = sampled(path(case, RADII[place], TIME)), f"{case.name}, L of {place}"
        found = simulated(recording)
        parts.append(distances(f"{name}, {start}", theory, found))
        if start == "flying":
            parts += [_path(name, theory), _path(f"simulated {name}", found)]
    parts += [rows(f"heading {case.name}", "start", _unit(case)) for case in CIRCLES]
    return long_form(*parts)


def _path(name: str, places: Floats) -> Iterator[Row]:
    """Yield a path, and each of its coordinates over time."""
    yield from rows("path", name, places)
    for axis, values in zip("XY", places.T, strict=True):
        yield from rows("over time", f"{axis}, {name}", over_time(values))


def _unit(case: Case) -> Floats:
    angle = float(case.direction)
    return np.array([[np.cos(angle), np.sin(angle)]])


@styled
def draw_circles(frame: pd.DataFrame) -> Figure:
    """Draw (a) the paths, (b) the coordinates over time, (c) how far theory and simulation part."""
    figure = Figure(figsize=(WIDTH, 9.6))
    above = figure.add_axes((0.17, 0.63, 0.8, 0.255))
    middle, below = (figure.add_axes((0.17, low, 0.8, 0.125)) for low in (0.405, 0.255))
    for case, place in product(CIRCLES, RADII):
        style = {"color": COLORS[case.name], "ls": DASHES[place], "lw": 2.2}
        name = f"{case.name}, L of {place}"
        panels = (("path", "", above), ("over time", "X, ", middle), ("over time", "Y, ", below))
        for panel, axis, ax in panels:
            line(ax, points(frame, panel, f"{axis}{name}"), **style)
            marked(ax, points(frame, panel, f"{axis}simulated {name}"))
    _name_paths(above, frame)
    _over_time_panels(middle, below)
    names = [(start, f"{case.name}, L of {place}, {start}") for case, place, start in RUNS]
    curves = ((start, points(frame, "distance", name)) for start, name in names)
    distance_panel(figure.add_axes((0.17, 0.06, 0.8, 0.11)), curves, "c")
    figure.legend(handles=handles(), loc="upper left", bbox_to_anchor=(0.14, 1.0), handlelength=2.4)
    return figure


def _over_time_panels(middle: Axes, below: Axes) -> None:
    for ax, axis in ((middle, "X"), (below, "Y")):
        ax.set(xlim=(0, float(DURATION)), ylabel=f"${axis}_W$ [m]", ylim=(-0.07, 0.15))
        ax.set_yticks([-0.05, 0, 0.05, 0.1, 0.15])
        ax.grid(visible=True)
    middle.set_title("(b) coordinates over time")
    middle.tick_params(labelbottom=False)


def _name_paths(ax: Axes, frame: pd.DataFrame) -> None:
    """Name the paths, and show their common direction at the start."""
    ax.set_aspect("equal")
    ax.set(xlim=(-0.09, 0.15), ylim=(-0.012, 0.15), xlabel="$X_W$ [m]", ylabel="$Y_W$ [m]")
    ax.set_xticks([-0.05, 0, 0.05, 0.1, 0.15])
    ax.set_yticks([0, 0.05, 0.1, 0.15])
    ax.set_title("(a) paths, a mark every 0.5 s")
    ax.grid(visible=True)
    ((x, y),) = points(frame, f"heading {CIRCLES[0].name}", "start")
    line(ax, [[0, 0], [0.14 * x, 0.14 * y]], ls=":", color=ACCENT)
    label(ax, [0.14 * x, 0.14 * y], "60°", (0.013, 0.005), color=ACCENT, size=SMALL_SIZE)
    for case, at, name in zip(CIRCLES, ([-0.045, 0.06], [0.12, 0.065]),
                              ("left rotation", "clockwise"), strict=True):  # fmt: skip
        label(ax, at, name, size=SMALL_SIZE, color=COLORS[case.name])


def describe_circles(frame: pd.DataFrame) -> str:
    """Say where each path ends, and how far theory and simulation are apart."""
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
        f" {float(DURATION):g} seconds. They end: {'; '.join(ends)}. Rings of the simulation lie on"
        f" all of them; {apart(frame)}."
    )


def apart(frame: pd.DataFrame) -> str:
    """Say the greatest distance between theory and simulation for each start."""
    distance = frame[frame["panel"] == "distance"]
    most = {
        start: float(distance[distance["series"].str.endswith(start)]["y"].max())
        for start in STARTS
    }
    return (
        f"the last panel has their distance from the theory, up to {shown(most['flying'])} mm from"
        f" a flying start and {shown(most['standing'])} mm from a standing one"
    )


CIRCLES_FIGURE = Drawing(
    3,
    "Circular paths of Table 3",
    "Computed from the printed rates of the wheels with r = 0.023 m in T = 3 s, by the closed form."
    f" The paper prints two body radii L, and the arcs differ. {LAID_OVER} {REDRAWN}",
    _data,
    draw_circles,
    describe_circles,
    tuple(recorded(case, start, place) for case, place, start in RUNS),
)
