"""Figure 6: both evaluation functions over the family of isosceles arrangements."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import Expr, Symbol, lambdify

from omniproof.kinematics.omni import twist_matrix, velocity_matrix
from omniproof.kinematics.zonotope import projection, volume
from omniproof.papers.omni_arrangement.arrangements import PARAMETER, SWEEP, isosceles
from omniproof.report.figure import Drawing, long_form, points, rows
from omniproof.report.sketch import REDRAWN, label, shown
from omniproof.report.svg import (
    ACCENT,
    INK,
    SMALL_SIZE,
    TYPE_COLORS,
    TYPE_MARKERS,
    WIDTH,
    styled,
)

STEP_DEG = 0.5
THETA = Symbol("theta", real=True)
PANELS: Mapping[str, str] = {
    "D_V": r"$D_V = 8/|\det A|$ [(m/s)³]",
    "D_A": r"$D_A = 12/|\det A|$ [(m/s)²]",
}
LIMITS: Mapping[str, tuple[float, float]] = {"D_V": (0, 20), "D_A": (0, 30)}


@cache
def functions() -> Mapping[str, Expr]:
    """Volume and projected area of the image of W, in theta."""
    columns = twist_matrix(velocity_matrix(isosceles(THETA)))
    return {"D_V": volume(columns), "D_A": volume(projection(columns))}


def curves_data() -> pd.DataFrame:
    """Both functions over the open sweep (x in degrees), at the types, and the least sample."""
    low, high = (float(np.degrees(float(end))) for end in SWEEP)
    theta_deg = np.arange(low + STEP_DEG, high, STEP_DEG)
    parts = []
    for panel, expression in functions().items():
        value = lambdify(THETA, expression, "numpy")
        values = np.asarray(value(np.radians(theta_deg)), dtype=np.float64)
        parts.append(rows(panel, "curve", np.column_stack([theta_deg, values])))
        for kind, parameter in PARAMETER.items():
            at = [np.degrees(float(parameter)), float(expression.subs(THETA, parameter))]
            parts.append(rows(panel, f"type {kind}", at))
        best = int(np.argmin(values))
        parts.append(rows(panel, "minimum", [theta_deg[best], values[best]]))
    return long_form(*parts)


@styled
def draw_curves(frame: pd.DataFrame) -> Figure:
    """Draw one panel a function, with the types and the minimum."""
    figure = Figure(figsize=(WIDTH, 5.4))
    axes = figure.subplots(2, 1, sharex=True)
    for ax, (panel, name), letter in zip(axes, PANELS.items(), "ab", strict=True):
        _curve(ax, frame, panel)
        ax.set_title(f"({letter}) {name}")
    axes[-1].set_xlabel(r"$\theta$ [degrees]")
    figure.subplots_adjust(left=0.1, right=0.97, bottom=0.1, top=0.94, hspace=0.22)
    return figure


def _curve(ax: Axes, frame: pd.DataFrame, panel: str) -> None:
    theta_deg, values = points(frame, panel, "curve").T
    ax.plot(theta_deg, values, color=INK, linewidth=1.6)
    ax.grid(visible=True)
    ax.set(xlim=(-90, 90), ylim=LIMITS[panel], xticks=range(-90, 91, 30))
    ((best, least),) = points(frame, panel, "minimum")
    ax.axvline(best, color=ACCENT, linewidth=1.0, linestyle=":")
    ax.axhline(least, color=ACCENT, linewidth=1.0, linestyle=":")
    text = f"minimum {least:.2f} at {best:.0f}°"
    label(ax, [best - 3, 0.5 * least], text, size=SMALL_SIZE, ha="right")
    for kind in PARAMETER:
        ((at, value),) = points(frame, panel, f"type {kind}")
        ax.plot(at, value, TYPE_MARKERS[kind], color=TYPE_COLORS[kind], ms=8, zorder=5)
        lift = 0.1 * LIMITS[panel][1]
        label(ax, [at + 3, value + lift], f"({kind}) {value:.2f}", size=SMALL_SIZE, ha="left")


def describe_curves(frame: pd.DataFrame) -> str:
    """Say where both are least, and what the types have."""
    said = []
    for panel in PANELS:
        ((best, least),) = points(frame, panel, "minimum")
        types = [
            f"{shown(float(points(frame, panel, f'type {kind}')[0, 1]))} for type ({kind})"
            for kind in PARAMETER
        ]
        said.append(
            f"{panel} is least, {shown(least)}, at theta = {best:.0f} degrees: {', '.join(types)}"
        )
    return (
        "Two curves over theta between \N{MINUS SIGN}90 and 90 degrees, of one shape, growing"
        f" without bound towards both ends. {'; '.join(said)}."
    )


CURVES = (
    Drawing(
        6,
        "Both evaluation functions over the isosceles family",
        "Arrangements (θ, 180° − θ, 270°). The two curves differ by the factor 3/2 only: the second"
        f" function says nothing that the first does not. Cut off above. {REDRAWN}",
        curves_data,
        draw_curves,
        describe_curves,
    ),
)
