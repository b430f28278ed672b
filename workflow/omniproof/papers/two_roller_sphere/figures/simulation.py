"""Figure 3: the simulation with roller angles of 0, 10, 20 and 30 degrees, from closed forms."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from sympy import Expr, atan, lambdify

from omniproof.papers.two_roller_sphere import closed_forms
from omniproof.papers.two_roller_sphere.symbols import DIRECTION
from omniproof.papers.two_roller_sphere.symmetric import ANGLES, in_simulation
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import MUTED, REDRAWN, Style, View, arrow, label, line, shown
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, WIDTH, styled

STEP_DEG = 5
DIRECTIONS_DEG: Floats = np.arange(0.0, 361.0, STEP_DEG)
CASES = tuple(range(len(ANGLES)))
NAMES = tuple(f"{round(float(angle) * 180 / np.pi)}°" for angle in ANGLES)
"""The cases of the paper, by k and by the angle of roller 1."""

COLORS = (INK, TYPE_COLORS["X"], TYPE_COLORS["Z"], TYPE_COLORS["Y"])
DASHES = ("-", "--", "-.", ":")
ROLLERS = (1, 2)
FLATTENED = 0.25
"""Share of their true height that the ellipses have in panel (a)."""

PANELS: Mapping[str, tuple[str, float, Sequence[float]]] = {
    "rho": (r"(b) angle $\rho$ of the axis [degrees]", 95, (-90, 0, 90)),
    "nu": (r"(c) rim speeds $\nu_1$, thin $\nu_2$ [m/s]", 6, (-5, 0, 5)),
    "S": (r"(d) slips $S_1$, thin $S_2$ [m/s]", 0.6, (-0.5, 0, 0.5)),
}
"""Title of each panel, the end of its axis and the ticks there."""

OF_ROLLER: Mapping[str, Callable[[int], Expr]] = {
    "nu": closed_forms.rim_speed,
    "S": closed_forms.slip,
}


def simulation_data() -> pd.DataFrame:
    """Spins (x, y, z in rad/s), and angle, rim speeds and slips over the direction (degrees)."""
    return long_form(*(part for k in CASES for part in _case(k)))


def _case(k: int) -> Iterator[Iterator[Row]]:
    spin = [_values(entry, k) for entry in closed_forms.spin()]
    yield rows("omega", f"k {k}", np.column_stack(spin))
    axis = np.degrees(_values(atan(closed_forms.tangent_of_axis()), k))
    yield rows("rho", f"k {k}", np.column_stack([DIRECTIONS_DEG, axis]))
    for panel, of_roller in OF_ROLLER.items():
        for i in ROLLERS:
            values = _values(of_roller(i), k)
            yield rows(panel, f"roller {i}, k {k}", np.column_stack([DIRECTIONS_DEG, values]))


def _values(expression: Expr, case: int) -> Floats:
    """Values of an expression of one case over the directions of travel."""
    value = lambdify(DIRECTION, in_simulation(expression, case), "numpy")
    return np.broadcast_to(value(np.radians(DIRECTIONS_DEG)), DIRECTIONS_DEG.shape)


@styled
def draw_simulation(frame: pd.DataFrame) -> Figure:
    """Draw (a) the ellipses in space and (b) to (d) what goes with them over the direction."""
    height = 11.6
    figure = Figure(figsize=(WIDTH, height))
    scene = figure.add_axes((0, 6.9 / height, 1, 4.7 / height))
    scene.set(xlim=(0, WIDTH), ylim=(0, 4.7))
    scene.set_axis_off()
    _ellipses(scene, frame)
    for row, panel in enumerate(PANELS):
        ax = figure.add_axes((0.12, (5.0 - 2.2 * row) / height, 0.85, 1.55 / height))
        _over_direction(ax, frame, panel)
        ax.tick_params(labelbottom=row == 2)
    ax.set_xlabel(r"direction of travel $\phi$ [degrees]")
    return figure


def _style(k: int) -> Style:
    return {"color": COLORS[k], "ls": DASHES[k]}


def _ellipses(ax: Axes, frame: pd.DataFrame) -> None:
    """Panel (a): ellipses through two common points on the x-axis."""
    label(ax, [0.1, 4.55], r"(a) end points of $\omega$, height at one quarter", ha="left")
    view = View((1.9, 2.2), 0.72)
    flat = np.array([1, 1, FLATTENED])
    for k in CASES:
        path = points(frame, "omega", f"k {k}") * flat
        line(ax, view.place(path), lw=1.8, **_style(k))
    for unit, name in zip(np.diag([1.7, 1.7, 1.9]), "xyz", strict=True):
        arrow(ax, *view.place([-0.6 * unit, unit]), lw=0.9, alpha=MUTED)
        label(ax, view.place(1.12 * unit)[0], rf"$\omega_{name}$", size=SMALL_SIZE)
    common = points(frame, "omega", "k 0")[np.isin(DIRECTIONS_DEG, (90, 270))] * flat
    line(ax, view.place(common), lw=1.2, color=ACCENT, marker="o", ms=5, zorder=5)
    handles = [
        Line2D([], [], label=rf"$\alpha_1 = {NAMES[k]}$".replace("°", r"^\circ"), **_style(k))
        for k in CASES
    ]
    ax.legend(handles=handles, loc="upper right", bbox_to_anchor=(1.0, 0.9), handlelength=2.6)


def _over_direction(ax: Axes, frame: pd.DataFrame, panel: str) -> None:
    """Panels (b) to (d)."""
    title, end, ticks = PANELS[panel]
    ax.set_title(title)
    ax.set(xlim=(0, 360), ylim=(-end, end), xticks=range(0, 361, 90), yticks=ticks)
    ax.grid(visible=True)
    ax.axhline(0, color=INK, lw=0.8)
    for k in CASES:
        if panel == "rho":
            ax.plot(*points(frame, panel, f"k {k}").T, **_style(k))
            continue
        for i in ROLLERS:
            curve = points(frame, panel, f"roller {i}, k {k}")
            ax.plot(*curve.T, lw=2.2 if i == 1 else 1.0, **_style(k))


def describe_simulation(frame: pd.DataFrame) -> str:
    """Say the greatest angle, speed and slip of each case."""
    told = []
    for k, name in zip(CASES, NAMES, strict=True):
        angle = _greatest(points(frame, "rho", f"k {k}"))
        speed, slip = (_greatest(points(frame, panel, f"roller 1, k {k}")) for panel in OF_ROLLER)
        told.append(f"{shown(angle, 1)} degrees, {shown(speed)} and {shown(slip)} m/s at {name}")
    return (
        "Four ellipses in space through two common points on the x-axis, each steeper than the one"
        " before; below them angle of the axis, rim speeds and slips over the direction of travel."
        f" Greatest angle, rim speed and slip of the points drawn: {'; '.join(told)}. The slip is"
        " zero for travel along x, the angle for travel along y."
    )


def _greatest(curve: Floats) -> float:
    return float(np.abs(curve[:, 1]).max())


SIMULATION = (
    Drawing(
        3,
        "The simulation, for four angles of the rollers",
        "Contacts at the azimuths 215° and 325° and the elevation 60°, r = 1 m, 1 m/s,"
        r" $\alpha_2 = -\alpha_1$. Computed from the closed forms of this chapter. Thin in (c) and"
        f" (d): roller 2. The paper tells its curves by red, blue, green and pink. {REDRAWN}",
        simulation_data,
        draw_simulation,
        describe_simulation,
    ),
)
