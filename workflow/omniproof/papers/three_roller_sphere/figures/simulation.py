"""Figure 3: spins and slips of the four patterns, from the least-squares spin."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import Integer, MatrixBase, lambdify

from omniproof.papers.three_roller_sphere.rollers import ELEVATIONS, pattern_slips, pattern_spin
from omniproof.papers.three_roller_sphere.symbols import PHI, RADIUS
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import REDRAWN, shown
from omniproof.report.svg import INK, TYPE_COLORS, WIDTH, styled

STEP_DEG = 5
PARAMETER_DEG: Floats = np.arange(0.0, 361.0, STEP_DEG)
UNIT = {RADIUS: Integer(1)}
"""Radius of the sphere, m: the paper prints none."""

ROLLERS = (1, 2, 3)
PATTERNS: Mapping[int, str] = {
    k: f"{numeral} ({round(float(elevation) * 180 / np.pi)}°)"
    for k, (numeral, elevation) in enumerate(
        zip(("I", "II", "III", "IV"), ELEVATIONS, strict=True), 1
    )
}
COLORS = {1: INK, 2: TYPE_COLORS["X"], 3: TYPE_COLORS["Z"], 4: TYPE_COLORS["Y"]}
DASHES = {1: "-", 2: "--", 3: "-.", 4: ":"}


def simulation_data() -> pd.DataFrame:
    """Spins (x, y, z in rad/s), and sizes of the slips (m/s) over the parameter (degrees)."""
    return long_form(*(part for k in PATTERNS for part in _pattern(k)))


def _pattern(k: int) -> Iterator[Iterator[Row]]:
    elevation = ELEVATIONS[k - 1]
    yield rows("omega", f"k {k}", _values(pattern_spin(elevation).subs(UNIT)))
    for i, slip in zip(ROLLERS, pattern_slips(elevation), strict=True):
        sizes = np.linalg.norm(_values(slip.subs(UNIT)), axis=1)
        yield rows("slip", f"roller {i}, k {k}", np.column_stack([PARAMETER_DEG, sizes]))


def _values(vector: MatrixBase) -> Floats:
    """Values of a vector over the parameter: M x 3."""
    angles = np.radians(PARAMETER_DEG)
    entries = (lambdify(PHI, entry, "numpy")(angles) for entry in vector)
    return np.column_stack([np.broadcast_to(entry, angles.shape) for entry in entries])


@styled
def draw_simulation(frame: pd.DataFrame) -> Figure:
    """Draw (a) the circles and (b) the slips of each roller."""
    height = 9.4
    figure = Figure(figsize=(WIDTH, height))
    above = figure.add_axes((0.17, 5.7 / height, 0.68, 0.68 * WIDTH / height))
    _circles(above, frame)
    for row, i in enumerate(ROLLERS):
        ax = figure.add_axes((0.12, (3.5 - 1.5 * row) / height, 0.85, 1.1 / height))
        _slips(ax, frame, i)
        ax.tick_params(labelbottom=row == 2)
    ax.set_xlabel(r"parameter $\varphi$ of the inputs [degrees]")
    return figure


def _circles(ax: Axes, frame: pd.DataFrame) -> None:
    for k, name in PATTERNS.items():
        x, y, _ = points(frame, "omega", f"k {k}").T
        ax.plot(x, y, color=COLORS[k], ls=DASHES[k], lw=1.8, label=f"Pattern {name}")
    ax.set_aspect("equal")
    ax.set(xlim=(-1.1, 1.1), ylim=(-1.1, 1.1), xticks=(-1, 0, 1), yticks=(-1, 0, 1))
    ax.set(xlabel=r"$\omega_x$ [rad/s]", ylabel=r"$\omega_y$ [rad/s]")
    ax.set_title(r"(a) end points of $\omega$, at $\omega_z = 0$")
    ax.grid(visible=True)
    ax.legend(loc="center", handlelength=2.6)


def _slips(ax: Axes, frame: pd.DataFrame, i: int) -> None:
    """One panel of (b)."""
    for k in PATTERNS:
        curve = points(frame, "slip", f"roller {i}, k {k}")
        ax.plot(*curve.T, color=COLORS[k], ls=DASHES[k], lw=1.8)
    ax.set(xlim=(0, 360), ylim=(-0.02, 0.44), xticks=range(0, 361, 60), yticks=(0, 0.2, 0.4))
    ax.set_title(f"(b) slip of roller {i} [m/s]")
    ax.grid(visible=True)


def describe_simulation(frame: pd.DataFrame) -> str:
    """Say the radius of each circle and the range of each slip."""
    told = []
    for k, name in PATTERNS.items():
        radius = float(np.linalg.norm(points(frame, "omega", f"k {k}"), axis=1).max())
        slips = points(frame, "slip", f"roller 1, k {k}")[:, 1]
        least, most = shown(float(slips.min()), 3), shown(float(slips.max()), 3)
        told.append(f"{name}: radius {shown(radius, 3)} rad/s, slip {least} to {most} m/s")
    return (
        "Above, four circles about the origin, each smaller than the one before. Below, one panel"
        " a roller: the size of its slip over the parameter, two waves a turn, from roller to"
        f" roller shifted by 60 degrees. Pattern {'; '.join(told)}."
    )


SIMULATION = (
    Drawing(
        3,
        "The four patterns of the simulation",
        "Computed from the least-squares spin, for r = 1 m; slips do not depend on r. The paper"
        f" tells its curves by green, red, blue and violet. {REDRAWN}",
        simulation_data,
        draw_simulation,
        describe_simulation,
    ),
)
