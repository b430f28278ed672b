"""Where the spin goes in the three-roller simulation: viscous and dry friction, from above.

Lines are the closed forms; marks on top are what the physics engine came to.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import cos, lambdify, rad, sin

from omniproof.papers.one_mechanics.friction import dry_spin
from omniproof.papers.one_mechanics.platforms import (
    ELEVATION,
    VELOCITY,
    raised_spin,
)
from omniproof.papers.one_mechanics.simulated import ELEVATIONS_DEG, PHASES_DEG
from omniproof.papers.one_mechanics.statements import RADIUS, REGULAR
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import line, shown
from omniproof.report.svg import ACCENT, INK, TYPE_COLORS, TYPE_DASHES, WIDTH, styled

PATTERNS_DEG = {"I": 0, "II": 10, "III": 20, "IV": 30}
HUES = {"I": INK, "II": TYPE_COLORS["X"], "III": TYPE_COLORS["Z"], "IV": TYPE_COLORS["Y"]}
PHASES = np.radians(np.arange(0, 361, 3))
RAISED = "IV"
MARKS = {"viscous": "o", "dry": "s"}
RUNS = tuple(product(ELEVATIONS_DEG, PHASES_DEG, MARKS))
"""All that is simulated: elevation and phase in degrees, kind of friction."""


def _data(*recordings: pd.DataFrame) -> pd.DataFrame:
    """Ends of the spin over a period: level components, and height over phase (degrees)."""
    parts = list(_simulated(recordings))
    for name, degrees in PATTERNS_DEG.items():
        parts.append(rows("level", f"viscous {name}", _viscous(degrees)[:, :2]))
    dry = _dry(PATTERNS_DEG[RAISED])
    phases = np.degrees(PHASES)
    return long_form(
        *parts,
        rows("level", "dry", dry[:, :2]),
        rows("height", "dry", np.column_stack([phases, dry[:, 2]])),
        rows("height", "viscous", np.column_stack([phases, _viscous(PATTERNS_DEG[RAISED])[:, 2]])),
    )


def _simulated(recordings: Sequence[pd.DataFrame]) -> Iterator[Iterator[Row]]:
    """Yield the last spin of each run, and its height for the Pattern `RAISED`."""
    for (elevation, phase, law), recording in zip(RUNS, recordings, strict=True):
        x, y, z = recording[["spin_x", "spin_y", "spin_z"]].to_numpy(dtype=np.float64)[-1]
        yield rows("level", f"simulated {law}", [x, y])
        if elevation == PATTERNS_DEG[RAISED]:
            yield rows("height", f"simulated {law}", [phase, z])


def _velocities() -> Floats:
    return np.column_stack([np.sin(PHASES), -np.cos(PHASES)])


def _viscous(degrees: int) -> Floats:
    """Least-squares spins over the phases, radius 1 m: M x 3."""
    spin = raised_spin().subs({ELEVATION: rad(degrees), RADIUS: 1})
    value = lambdify(VELOCITY[:2], list(spin), "numpy")
    return np.array([value(*velocity) for velocity in _velocities()], dtype=np.float64)


def _dry(degrees: int) -> Floats:
    """Spins under dry friction: the roller with the middle value of V.h sticks."""
    spins = [dry_spin(k).subs({ELEVATION: rad(degrees), RADIUS: 1}) for k in range(3)]
    values = [lambdify(VELOCITY[:2], list(spin), "numpy") for spin in spins]
    outward = np.array([[float(cos(a)), float(sin(a))] for a in REGULAR])
    middle = np.argsort(_velocities() @ outward.T, axis=1)[:, 1]
    found = [values[k](*v) for k, v in zip(middle, _velocities(), strict=True)]
    return np.array(found, dtype=np.float64)


@styled
def draw_spins(frame: pd.DataFrame) -> Figure:
    """Draw the circles from above, and the height of the spin over the phase."""
    figure = Figure(figsize=(WIDTH, 7.4))
    level, height = figure.subplots(2, 1, height_ratios=[4.4, 1.7])
    _draw_level(level, frame)
    for series, style in (
        ("viscous", {"color": HUES[RAISED], "ls": "-"}),
        ("dry", {"color": ACCENT, "ls": TYPE_DASHES["Y"]}),
    ):
        height.plot(*points(frame, "height", series).T, **style)
    for law, mark in MARKS.items():
        for panel, ax in (("level", level), ("height", height)):
            found = points(frame, panel, f"simulated {law}")
            line(ax, found, marker=mark, ms=6, mfc="none", mew=1.2, lw=0, zorder=5)
    height.set(xlim=(0, 360), xticks=range(0, 361, 90), xlabel=r"phase $\varphi$ [degrees]")
    height.set_title(rf"(b) Pattern {RAISED}: $\omega_z$ [rad/s]")
    height.grid(visible=True)
    figure.subplots_adjust(left=0.14, right=0.96, bottom=0.08, top=0.95, hspace=0.3)
    return figure


def _draw_level(ax: Axes, frame: pd.DataFrame) -> None:
    for name in PATTERNS_DEG:
        curve = points(frame, "level", f"viscous {name}")
        radius = shown(float(np.hypot(*curve[0])))
        ax.plot(*curve.T, color=HUES[name], label=f"viscous, Pattern {name}: {radius}")
    x, y = points(frame, "level", "dry").T
    ax.plot(x, y, label="dry, all patterns", color=ACCENT, ls=TYPE_DASHES["Y"], lw=2.6)
    for law, mark in MARKS.items():
        label = f"{law}, simulated"
        ax.plot([], [], marker=mark, ms=6, mfc="none", mew=1.2, lw=0, color=INK, label=label)
    ax.legend(loc="center")
    ax.set(xlim=(-1.1, 1.1), ylim=(-1.1, 1.1), xticks=[-1, 0, 1], yticks=[-1, 0, 1])
    ax.set_aspect("equal")
    ax.set_title(r"(a) $(\omega_x, \omega_y)$ [rad/s], seen from above")


def describe_spins(frame: pd.DataFrame) -> str:
    """Say the radii and the greatest height."""
    radii = ", ".join(
        shown(float(np.hypot(*points(frame, "level", f"viscous {name}")[0])))
        for name in PATTERNS_DEG
    )
    dry = np.hypot(*points(frame, "level", "dry").T)
    top = float(np.abs(points(frame, "height", "dry")[:, 1]).max())
    return (
        f"Above, concentric circles of radius {radii} rad/s for the Patterns I to IV under viscous "
        f"friction, and a dashed circle of radius {shown(float(dry.max()))} for dry friction. "
        "Below, the vertical component for Pattern IV over the phase: zero under viscous friction, "
        f"a wave with three peaks up to {shown(top)} rad/s under dry friction. Marks of the "
        f"simulation lie on the circles, at most {shown(_off(frame), 4)} rad/s off."
    )


def _off(frame: pd.DataFrame) -> float:
    """Greatest distance (rad/s) of a mark from the nearest circle of its kind of friction."""
    level = frame[frame["panel"] == "level"]
    distances = []
    for law in MARKS:
        circles = level[level["series"].str.startswith(law)]
        radii = np.linalg.norm(circles[["x", "y"]].to_numpy(dtype=np.float64), axis=1)
        found = np.hypot(*points(frame, "level", f"simulated {law}").T)
        distances.append(np.abs(found[:, None] - radii).min(axis=1).max())
    return float(max(distances))


SPINS = Drawing(
    "spins",
    "Viscous or dry friction",
    "End of the spin over one period of the three-roller simulation, for r = 1 m: the "
    "least-squares point, which is the steady state of viscous friction, and the steady state of "
    "dry friction with equal loads. Both from the closed forms; marks: steady spins in simulation, "
    "of Patterns II to IV at two phases. The papers have no such figure.",
    _data,
    draw_spins,
    describe_spins,
    tuple(f"simulation/sphere/three-{place}-{phase}-{law}.csv" for place, phase, law in RUNS),
)
