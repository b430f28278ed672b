"""A sphere seen from outside, for sketches: circles on it, their far sides dotted, and points."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from omniproof.report.figure import Floats
from omniproof.report.sketch import MUTED, View, circle, line, toward_viewer

AROUND = np.linspace(0, 2 * np.pi, 49)


def ring(center: Floats, first: Floats, second: Floats) -> Floats:
    """Closed circle (ellipse) about `center` through center + `first`, + `second`: 49 x 3."""
    turned = np.outer(np.cos(AROUND), first) + np.outer(np.sin(AROUND), second)
    return np.asarray(center + turned, dtype=np.float64)


def draw_globe(ax: Axes, view: View, great_circle: Floats) -> None:
    """Draw the silhouette of the sphere about the origin, and a great circle on it (M x 3)."""
    circle(ax, view.place([0, 0, 0])[0], view.scale * float(np.linalg.norm(great_circle[0])))
    depth = great_circle @ toward_viewer()
    for side, style in ((depth >= 0, "-"), (depth <= 0, ":")):
        seen = np.where(side, 1.0, np.nan)[:, None]
        line(ax, view.place(great_circle * seen), lw=0.7, ls=style, alpha=MUTED)


def dot(ax: Axes, places: Floats) -> None:
    """Mark points (M x 2) of the stage."""
    line(ax, places, marker="o", ms=4, lw=0, zorder=5)
