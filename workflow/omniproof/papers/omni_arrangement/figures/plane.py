"""Figures 5 and 8: the hexagons of velocities, with and without rotation, and how one arises."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from omniproof.kinematics.omni import velocity_matrix
from omniproof.kinematics.zonotope import section, vertices
from omniproof.papers.omni_arrangement.arrangements import CORRECTED
from omniproof.papers.omni_arrangement.figures.parts import TYPES, generators
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.sketch import (
    MUTED,
    REDRAWN,
    area,
    arrow,
    floats,
    label,
    line,
    outlined,
    shown,
    tinted,
)
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, WIDTH, stage, styled

SWEPT_TYPE = "X"


def hexagons_data() -> pd.DataFrame:
    """For each type the projection of the image of W, and its section without rotation."""
    parts = []
    for kind in TYPES:
        still = section(velocity_matrix(CORRECTED[kind]))
        parts.append(rows(kind, "projection", vertices(generators(kind)[:2])))
        parts.append(rows(kind, "section", [floats(corner).ravel() for corner in still]))
    return long_form(*parts)


@styled
def draw_hexagons(frame: pd.DataFrame) -> Figure:
    """Draw the three hexagons at one scale, one above the other."""
    reach = frame[["x", "y"]].abs().max()
    half_x, half_y = 1.08 * reach["x"], 1.35 * reach["y"]
    left, bottom, right, gap = 0.72, 0.62, 0.08, 0.34
    scale = (WIDTH - left - right) / (2 * half_x)
    height = 2 * half_y * scale
    total = bottom + len(TYPES) * (height + gap)
    figure = Figure(figsize=(WIDTH, total))
    for row, kind in enumerate(TYPES):
        low = bottom + (len(TYPES) - 1 - row) * (height + gap)
        box = (left / WIDTH, low / total, 1 - (left + right) / WIDTH, height / total)
        ax = figure.add_axes(box)
        ax.set(xlim=(-half_x, half_x), ylim=(-half_y, half_y), yticks=[-1, 0, 1])
        ax.set_xticks(range(-4, 5), labels=None if row == len(TYPES) - 1 else [""] * 9)
        ax.set_ylabel("$V_y$ [m/s]")
        _hexagon(ax, frame, kind)
    ax.set_xlabel("$V_x$ [m/s]")
    return figure


def _hexagon(ax: Axes, frame: pd.DataFrame, kind: str) -> None:
    """Draw one type: tinted projection, outlined section, and what they are."""
    whole, still = points(frame, kind, "projection"), points(frame, kind, "section")
    ax.grid(visible=True)
    ax.set_axisbelow(True)
    tinted(ax, whole, TYPE_COLORS[kind])
    outlined(ax, whole, TYPE_COLORS[kind])
    outlined(ax, still, INK, lw=1.6, ls=(0, (4, 2)), zorder=4)
    ax.set_title(
        f"Type ({kind}): {area(whole):.2f}, without rotation {area(still):.2f} (m/s)²",
        fontsize=SMALL_SIZE,
        pad=4,
    )


def describe_hexagons(frame: pd.DataFrame) -> str:
    """Say both areas of each type."""
    said = [
        f"type ({kind}) {shown(area(points(frame, kind, 'projection')))} and"
        f" {shown(area(points(frame, kind, 'section')))}"
        for kind in TYPES
    ]
    return (
        "Velocities of the three types at one scale: a tinted hexagon for any rotation, and inside"
        f" it a dashed polygon for none. Areas in (m/s)²: {'; '.join(said)}. The dashed polygons of"
        " types (X) and (Z) are the same."
    )


def sweep_data() -> pd.DataFrame:
    """Projected columns of type (X), the ghost of Case 2, and the corners of the swept U."""
    flat = generators(SWEPT_TYPE)[:2]
    first, second, third = flat.T
    parts = [rows("case 1", f"a {k}", column) for k, column in enumerate(flat.T, 1)]
    parts += [rows("case 2", f"a {k}", column) for k, column in enumerate((first, second), 1)]
    parts.append(rows("case 2", "a 3", (first - second) / 2))
    parts.append(rows("sweep", "hexagon", vertices(flat)))
    corners = {
        "P": first - second,
        "Q": -(first + second),
        "R": second - first,
        "S": first + second,
    }
    for name, corner in corners.items():
        parts.append(rows("sweep", name, corner))
        parts.append(rows("sweep", f"{name}+", corner + third))
        parts.append(rows("sweep", f"{name}-", corner - third))
    return long_form(*parts)


@styled
def draw_sweep(frame: pd.DataFrame) -> Figure:
    """Draw (a) both cases and (b) the parallelogram swept along a_3."""
    figure, ax = stage(5.45)
    label(ax, [0.1, 5.27], "(a)", ha="left")
    label(ax, [1.3, 5.27], "Case 1: always")
    label(ax, [3.55, 5.27], "Case 2: never")
    _layout(ax, frame, "case 1", np.array([1.25, 4.15]), 1.15)
    _layout(ax, frame, "case 2", np.array([3.55, 4.15]), 1.15)
    label(ax, [0.1, 2.95], "(b)", ha="left")
    _swept(ax, frame, np.array([2.4, 1.57]), 1.03)
    return figure


def _layout(ax: Axes, frame: pd.DataFrame, panel: str, center: Floats, scale: float) -> None:
    """Draw a_1, a_2, the two sectors in which the case places a_3, and a_3."""
    first, second, third = (scale * points(frame, panel, f"a {k}")[0] for k in (1, 2, 3))
    occurs = panel == "case 1"
    for sign in (1, -1):
        other = second if occurs else -second
        tinted(ax, [center, center + sign * first, center + sign * other], ACCENT)
    for vector in (first, second):
        line(ax, [center, center - vector], ls=":", alpha=MUTED)
        arrow(ax, center, center + vector)
    style = {"color": ACCENT, "lw": 2.4} if occurs else {"ls": "--", "lw": 1.2, "alpha": MUTED}
    arrow(ax, center, center + third, **style)
    for k, vector in enumerate((first, second, third), 1):
        label(ax, center + vector + 0.18 * vector / np.linalg.norm(vector), f"$\\hat{{a}}_{k}$")


def _swept(ax: Axes, frame: pd.DataFrame, center: Floats, scale: float) -> None:
    """Draw U, its places at both ends of the sweep, and the hexagon around them."""
    at = {
        name: center + scale * points(frame, "sweep", name)[0]
        for letter in "PQRS"
        for name in (letter, f"{letter}+", f"{letter}-")
    }
    hexagon = center + scale * points(frame, "sweep", "hexagon")
    tinted(ax, hexagon, TYPE_COLORS[SWEPT_TYPE], alpha=0.15)
    outlined(ax, hexagon, TYPE_COLORS[SWEPT_TYPE])
    for end in ("+", "-"):
        outlined(ax, [at[f"{letter}{end}"] for letter in "PQRS"], INK, lw=1.0, ls="--", zorder=2)
    middle = [at[letter] for letter in "PQRS"]
    tinted(ax, middle, ACCENT, zorder=2)
    outlined(ax, middle, INK, lw=1.5)
    line(ax, [at["P"], at["R"]], ls=":")
    line(ax, [at["P+"], at["R+"]], ls=":")
    for letter in "PR":
        arrow(ax, at[letter], at[f"{letter}+"], color=ACCENT)
    for name, point in at.items():
        distance = float(np.linalg.norm(point - center))
        if distance < 0.1:
            continue
        out = (point - center) / distance
        label(ax, point + 0.19 * out, f"${name[0]}_{name[1:]}$" if name[1:] else f"${name}$")
    label(ax, center, "$U$", (0.14, 0.42))


def describe_sweep(frame: pd.DataFrame) -> str:
    """Say the two areas that make up half of the hexagon."""
    at = {name: points(frame, "sweep", name)[0] for name in ("P", "R", "P+", "Q+", "R+")}
    band = area(np.array([at[name] for name in ("R+", "P+", "P", "R")]))
    tip = area(np.array([at[name] for name in ("Q+", "P+", "R+")]))
    whole = area(points(frame, "sweep", "hexagon"))
    return (
        "Above, the third projected column lies opposite the first two, as it always does, and"
        " beside it the layout that never occurs. Below, a parallelogram U swept along the third"
        f" column covers a hexagon: a parallelogram of {shown(band)} and a triangle of {shown(tip)}"
        f" make half of its area of {shown(whole)} (m/s)²."
    )


PLANE = (
    Drawing(
        5,
        "Velocities with and without rotation",
        "Tinted: projection of the image of W, velocities reached with some rotation. Dashed:"
        " section without rotation, which the paper does not draw. Types (X) and (Z) have the same"
        f" section. Type (Z) with its corrected angles. {REDRAWN}",
        hexagons_data,
        draw_hexagons,
        describe_hexagons,
    ),
    Drawing(
        8,
        "Layout of the projected columns, and the swept hexagon",
        "(a) Since the three projected columns add up to zero, the third always lies between the"
        " opposites of the first two: Case 1; Case 2 cannot occur. (b) The parallelogram U swept"
        f" along the third column, for type ({SWEPT_TYPE}). {REDRAWN}",
        sweep_data,
        draw_sweep,
        describe_sweep,
    ),
)
