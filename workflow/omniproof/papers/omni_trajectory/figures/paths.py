"""What Figures 3 and 5 share: paths by the closed form, and the simulated ones laid over them.

Theory and simulation are nearer to each other than a line is wide. So the theory is a line and the
simulation marks on top of it, and a panel of its own shows their distance in millimetres.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from sympy import MatrixBase, Symbol, lambdify

from omniproof.papers.omni_trajectory.setup import CIRCLES, DURATION, RADII, Case
from omniproof.report.figure import Floats, Row, rows
from omniproof.report.sketch import label, line
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE

TIME = Symbol("t", nonnegative=True)
STEPS = 60
MARK_EVERY = 10
TIMES: Floats = np.arange(STEPS + 1) * float(DURATION) / STEPS
"""Samples of a path every 0.05 s; a mark every 0.5 s."""

STARTS: Mapping[str, str] = {"flying": "-", "standing": ":"}
"""Starts of the simulated robot, and how their distances from the theory are drawn."""

DASHES: Mapping[str, str] = dict(zip(RADII, ("-", "--"), strict=True))
BODIES: Mapping[str, str] = dict(zip(RADII, ("", "-body-86-mm"), strict=True))
"""What the names of the simulated cases have for each body radius."""

LAID_OVER = (
    "Lines: theory. Marks: our simulation from a flying start, in the place of the paper's, whose"
    " curves cannot be had."
)


def recorded(case: Case, start: str, place: str) -> str:
    """Path of the recording of a case with the body radius that stands at `place`."""
    shape = "circle" if case in CIRCLES else "line"
    name = f"{shape}-{case.name.removesuffix('°')}-{start}{BODIES[place]}"
    return f"simulation/omni-robot/{name}.csv"


def sampled(place: MatrixBase) -> Floats:
    """Values of an exact place (2x1, of `TIME`) at `TIMES`: M x 2."""
    at_times = (lambdify(TIME, entry, "numpy")(TIMES) for entry in place)
    return np.column_stack([np.broadcast_to(values, TIMES.shape) for values in at_times])


def simulated(recording: pd.DataFrame) -> Floats:
    """Places (m) of a recording at `TIMES`: M x 2. Raises `ValueError` for other times."""
    chosen = recording.iloc[:: max(1, len(recording) // STEPS)]
    if len(chosen) != len(TIMES) or not np.allclose(chosen["time"], TIMES):
        raise ValueError(f"expected a recording of {DURATION} s that has every 0.05 s")
    return chosen[["x", "y"]].to_numpy(dtype=np.float64)


def over_time(values: Floats) -> Floats:
    """Pair values with the time of their samples: M x 2."""
    return np.column_stack([TIMES, values])


def distances(series: str, one: Floats, other: Floats) -> Iterator[Row]:
    """Yield the distance of two paths over time, in mm, as a series of the panel `distance`."""
    apart = 1000 * np.linalg.norm(one - other, axis=1)
    return rows("distance", series, over_time(apart))


def marked(ax: Axes, path: Floats) -> None:
    """Draw marks of the simulation on top of a line: rings, so that the line shows inside."""
    marks = path[::MARK_EVERY]
    line(ax, marks, marker="o", ms=5, mew=1.1, mfc="none", lw=0, color=INK, zorder=5)


def distance_panel(ax: Axes, curves: Iterable[tuple[str, Floats]], letter: str) -> None:
    """Draw distances over time, each with its start; a name stands above either bundle."""
    tops: dict[str, float] = {}
    for start, curve in curves:
        line(ax, curve, ls=STARTS[start], color=ACCENT, lw=1.6)
        # Names stand over the second half of the time.
        tops[start] = max(tops.get(start, 0), float(curve[STEPS // 2 :, 1].max()))
    highest = max(tops.values())
    for start, top in tops.items():
        label(ax, [2.25, top + 0.06 * highest], f"{start} start", size=SMALL_SIZE, va="bottom")
    ax.set(xlim=(0, float(DURATION)), ylim=(0, 1.4 * highest), xlabel="$t$ [s]", ylabel="[mm]")
    ax.locator_params(axis="y", nbins=3)
    ax.set_title(f"({letter}) distance of simulation from theory", pad=4)
    ax.grid(visible=True)


def handles() -> list[Line2D]:
    """Entries of a legend: theory for each body radius, and the simulation."""
    lines = [
        Line2D([], [], color=INK, ls=DASHES[place], label=f"theory, {body_radius(place)}")
        for place in RADII
    ]
    ring = Line2D([], [], color=INK, marker="o", ms=5, mfc="none", lw=0, label="simulation")
    return [*lines, ring]


def body_radius(place: str) -> str:
    """Write the body radius and the place that prints it."""
    return f"$L = {float(RADII[place]):.3f}$ m ({place})"
