"""What sketches are made of: arrows, names and shapes on a stage in inches, and a view of space.

One set of pieces for the figures of all papers, so that an arrow, a wheel or an axis looks the same
everywhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, FancyArrowPatch, Polygon, Rectangle
from numpy.typing import ArrayLike
from sympy import MatrixBase

from omniproof.report.figure import Floats
from omniproof.report.svg import INK, SMALL_SIZE

REDRAWN = "Redrawn from the text and the equations; the paper's figure was not seen."
MUTED = 0.75
Style: TypeAlias = dict[str, Any]
AZIMUTH, ELEVATION = np.radians(-74.0), np.radians(22.0)
NAME_PLACES: Sequence[tuple[tuple[float, float], str, str]] = (
    ((0.05, -0.02), "left", "center"),
    ((0.05, 0.04), "left", "center"),
    ((0.0, 0.05), "center", "bottom"),
)
"""Where the names of three axes stand from their tips: shift, and the side that touches."""


@dataclass(frozen=True)
class View:
    """Where a scene in space stands on the stage: place of its origin, inches a unit."""

    origin: tuple[float, float]
    scale: float

    def place(self, space: ArrayLike) -> Floats:
        """Points of the scene (M x 3) on the stage: M x 2, in inches."""
        return np.asarray(self.origin) + self.scale * projected(space)


def floats(matrix: MatrixBase) -> Floats:
    """Return an exact matrix as doubles."""
    return np.array(matrix.evalf(30).tolist(), dtype=np.float64)


def shown(number: float, decimals: int = 2) -> str:
    """Return a number for running text, with a true minus sign."""
    return f"{number:.{decimals}f}".replace("-", "\N{MINUS SIGN}")


def area(polygon: Floats) -> float:
    """Area of a polygon, M x 2 (shoelace)."""
    x, y = polygon[:, 0], polygon[:, 1]
    return float(abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2)


def arrow(ax: Axes, start: ArrayLike, end: ArrayLike, **style: Any) -> None:
    """Draw an arrow between two points of the stage; `style` as for Matplotlib's patches."""
    width = style.setdefault("lw", 1.6)
    defaults: Style = {
        "color": INK,
        "arrowstyle": "-|>",
        "mutation_scale": 7 + 2.5 * width,
        "zorder": 4,
    }
    ends = [tuple(np.asarray(point, dtype=float)) for point in (start, end)]
    ax.add_patch(FancyArrowPatch(*ends, shrinkA=0, shrinkB=0, **(defaults | style)))


def label(
    ax: Axes, at: ArrayLike, text: str, shift: tuple[float, float] = (0, 0), **style: Any
) -> None:
    """Write text at a point of the stage, moved by `shift` (inches there)."""
    x, y = np.asarray(at, dtype=float) + shift
    defaults: Style = {"ha": "center", "va": "center", "zorder": 6}
    ax.text(x, y, text, **(defaults | style))


def line(ax: Axes, path: ArrayLike, **style: Any) -> None:
    """Draw an open line through points (M x 2) of the stage."""
    x, y = np.asarray(path, dtype=float).T
    defaults: Style = {"color": INK, "lw": 1.0, "zorder": 2}
    ax.plot(x, y, **(defaults | style))


def tinted(ax: Axes, polygon: ArrayLike, color: str, **style: Any) -> None:
    """Fill a polygon (M x 2) with a tint."""
    defaults: Style = {"color": color, "alpha": 0.22, "lw": 0, "zorder": 1}
    ax.add_patch(Polygon(np.asarray(polygon, dtype=float), **(defaults | style)))


def outlined(ax: Axes, polygon: ArrayLike, color: str, **style: Any) -> None:
    """Draw the outline of a polygon (M x 2)."""
    defaults: Style = {"fill": False, "edgecolor": color, "lw": 1.8, "zorder": 3}
    ax.add_patch(Polygon(np.asarray(polygon, dtype=float), **(defaults | style)))


def wheel(ax: Axes, center: Floats, angle: float, size: tuple[float, float], **style: Any) -> None:
    """Draw a wheel from above, `size` = (length along the tangent at `angle` (rad), breadth)."""
    length, breadth = size
    corner = (center[0] - breadth / 2, center[1] - length / 2)
    turn: Style = {"angle": float(np.degrees(angle)), "rotation_point": "center", "zorder": 3}
    ax.add_patch(Rectangle(corner, breadth, length, **(turn | style)))


def circle(ax: Axes, center: ArrayLike, radius: float) -> None:
    """Draw the outline of a circle on the stage."""
    x, y = np.asarray(center, dtype=float)
    ax.add_patch(Circle((x, y), radius, fill=False, edgecolor=INK, lw=1.2, zorder=1))


def projected(space: ArrayLike) -> Floats:
    """Orthographic view of points in space (M x 3): M x 2."""
    right = np.array([-np.sin(AZIMUTH), np.cos(AZIMUTH), 0.0])
    up = np.cross(toward_viewer(), right)
    return np.atleast_2d(np.asarray(space, dtype=np.float64)) @ np.array([right, up]).T


def toward_viewer() -> Floats:
    """Unit vector from the scene to the viewer."""
    level = np.cos(ELEVATION)
    return np.array([level * np.cos(AZIMUTH), level * np.sin(AZIMUTH), np.sin(ELEVATION)])


def draw_axes(ax: Axes, view: View, reach: Sequence[int]) -> None:
    """Draw three thin axes through the origin, each to its `reach`, with a dot every unit."""
    for unit, length in zip(np.eye(3), reach, strict=True):
        line(ax, view.place([-(length + 0.4) * unit, (length + 0.4) * unit]), lw=0.8, alpha=MUTED)
        ticks = np.array([k * unit for k in range(-length, length + 1) if k])
        line(ax, view.place(ticks), marker=".", ms=4, lw=0, alpha=MUTED, zorder=2.6)


def draw_triad(ax: Axes, view: View, names: Sequence[str]) -> None:
    """Draw the directions and the unit of a scene: three arrows, each one unit long."""
    start = view.place([0, 0, 0])[0]
    for unit, name, (shift, ha, va) in zip(np.eye(3), names, NAME_PLACES, strict=True):
        end = view.place(unit)[0]
        arrow(ax, start, end, lw=1.1)
        label(ax, end, name, shift, ha=ha, va=va, size=SMALL_SIZE)
