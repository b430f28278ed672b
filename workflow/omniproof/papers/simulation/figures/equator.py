"""Level rollers on the equator: the triangle of steady spins, and where spins come to rest."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from omniproof.papers.one_mechanics.simulated import ON_EQUATOR
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.sketch import arrow, label, line, outlined, shown, tinted
from omniproof.report.svg import ACCENT, SMALL_SIZE, TYPE_COLORS, WIDTH, styled
from omniproof.simulation.sphere import EQUATOR_SPEEDS
from omniproof.simulation.sphere_rollers import equator_rollers

PANEL = "level"
VISCOUS, *DRY = ON_EQUATOR
REACH = 1.5
"""Half the side of the picture, rad/s; what starts farther out comes in from the rim."""


def _data(*recordings: pd.DataFrame) -> pd.DataFrame:
    """Corners of the triangle by theory, and level spins of each run over time, in rad/s."""
    corners = np.array(equator_rollers(EQUATOR_SPEEDS).dry_corners)[:, :2]
    paths = zip(ON_EQUATOR, recordings, strict=True)
    return long_form(
        rows(PANEL, "triangle", corners),
        # The first row is before the sphere is let go.
        *(rows(PANEL, case, table[["spin_x", "spin_y"]].iloc[1:]) for case, table in paths),
    )


@styled
def draw_equator(frame: pd.DataFrame) -> Figure:
    """Draw the triangle, the way of each spin under dry friction, and where all of them end."""
    figure = Figure(figsize=(WIDTH, 4.6))
    ax = figure.add_axes((0.15, 0.13, 0.82, 0.82 * WIDTH / 4.6))
    triangle = points(frame, PANEL, "triangle")
    tinted(ax, triangle, ACCENT)
    outlined(ax, triangle, ACCENT)
    for case in DRY:
        path = points(frame, PANEL, case)
        line(ax, path, color=TYPE_COLORS["X"], lw=1.4)
        if np.linalg.norm(path[1] - path[0]) > 0.1:
            arrow(ax, *_inside(path), lw=1.4, color=TYPE_COLORS["X"])
        line(ax, path[-1:], marker="s", ms=7, mew=1.4, mfc="none", lw=0, zorder=5)
    line(ax, points(frame, PANEL, VISCOUS)[-1:], marker="o", ms=7, mew=1.4, mfc="none", zorder=5)
    middle, rest = (points(frame, PANEL, case)[-1] for case in (VISCOUS, DRY[0]))
    label(ax, middle, "viscous", (0.1, 0), ha="left", size=SMALL_SIZE)
    label(ax, rest, "dry, from rest", (0.05, -0.14), ha="right", size=SMALL_SIZE)
    ticks = (-1, 0, 1)
    ax.set(xlim=(-REACH, REACH), ylim=(-REACH, REACH), xticks=ticks, yticks=ticks)
    ax.set(xlabel=r"$\omega_x$ [rad/s]", ylabel=r"$\omega_y$ [rad/s]", aspect="equal")
    ax.grid(visible=True)
    return figure


def _inside(path: Floats) -> tuple[Floats, Floats]:
    """Return two neighbouring points of a path where it has come into the picture."""
    first = int(np.argmax((np.abs(path) < 0.95 * REACH).all(axis=1)))
    return path[first], path[first + 1]


def describe_equator(frame: pd.DataFrame) -> str:
    """Say the side of the triangle, and how far the viscous end is from its middle."""
    triangle = points(frame, PANEL, "triangle")
    side = float(np.linalg.norm(triangle[1] - triangle[0]))
    off = float(np.linalg.norm(points(frame, PANEL, VISCOUS)[-1] - triangle.mean(axis=0)))
    return (
        f"A tinted equilateral triangle with sides of {shown(side)} rad/s. A ring stands in its"
        f" middle, {shown(off, 4)} off: the steady spin of viscous contacts. Squares are those of"
        f" {len(DRY)} runs with dry contacts, inside it or on its rim (at most"
        f" {shown(_outside(frame), 4)} rad/s outside); lines lead there from where each started."
    )


def _outside(frame: pd.DataFrame) -> float:
    """How far the dry ends are beyond a side of the triangle at most, in rad/s; inside is 0."""
    triangle = points(frame, PANEL, "triangle")
    ends = np.array([points(frame, PANEL, case)[-1] for case in DRY])
    inward = triangle.mean(axis=0) - (triangle + np.roll(triangle, 1, axis=0)) / 2
    inward /= np.linalg.norm(inward, axis=1)[:, None]
    depths = np.einsum("sx,esx->es", inward, ends[:, None] - triangle)
    return float(max(0.0, -depths.min()))


EQUATOR_FIGURE = Drawing(
    "equator",
    "A whole triangle of steady spins",
    "Three level rollers on the equator, at speeds that do not add up to zero. Tinted: the steady"
    " spins of dry friction by theory. Lines: spins in simulation from where they were let go."
    " Squares: where they came to rest. The papers have no such figure.",
    _data,
    draw_equator,
    describe_equator,
    tuple(f"simulation/sphere/three-equator-{case}.csv" for case in ON_EQUATOR),
)
