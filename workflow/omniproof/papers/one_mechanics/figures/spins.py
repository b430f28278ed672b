"""Where the spin goes in the three-roller simulation: viscous and dry friction, from above."""

from __future__ import annotations

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
from omniproof.papers.one_mechanics.statements import RADIUS, REGULAR
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.sketch import shown
from omniproof.report.svg import ACCENT, INK, TYPE_COLORS, TYPE_DASHES, WIDTH, styled

PATTERNS_DEG = {"I": 0, "II": 10, "III": 20, "IV": 30}
HUES = {"I": INK, "II": TYPE_COLORS["X"], "III": TYPE_COLORS["Z"], "IV": TYPE_COLORS["Y"]}
PHASES = np.radians(np.arange(0, 361, 3))
RAISED = "IV"


def spins_data() -> pd.DataFrame:
    """Ends of the spin over a period: level components, and height over phase (degrees)."""
    parts = []
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
        f"a wave with three peaks up to {shown(top)} rad/s under dry friction."
    )


SPINS = Drawing(
    "spins",
    "Viscous or dry friction",
    "End of the spin over one period of the three-roller simulation, for r = 1 m: the "
    "least-squares point, which is the steady state of viscous friction, and the steady state of "
    "dry friction with equal loads. Both from the closed forms. The papers have no such figure.",
    spins_data,
    draw_spins,
    describe_spins,
)
