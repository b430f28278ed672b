"""Figures 1 and 2: arrangements of rollers, one roller on the sphere, and the lines of three."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import Expr, Integer, Rational, rad

from omniproof.papers.three_roller_sphere.rollers import Roller, optimum
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.globe import dot, draw_globe, ring
from omniproof.report.sketch import (
    REDRAWN,
    View,
    arrow,
    draw_triad,
    floats,
    label,
    line,
    shown,
    tinted,
    toward_viewer,
)
from omniproof.report.svg import ACCENT, SMALL_SIZE, TYPE_COLORS, stage, styled

RADIUS, REST = Integer(1), Integer(0)
COLORS = {1: TYPE_COLORS["X"], 2: TYPE_COLORS["Y"], 3: TYPE_COLORS["Z"]}
ROLLER, ANY = TYPE_COLORS["X"], TYPE_COLORS["Z"]
HALF_LENGTH, GAP, REACH = 0.24, 1.07, 0.42
"""Of a drawn roller: half its length, its distance from the centre, its arrow (m)."""

TYPES: Mapping[str, tuple[str, Sequence[int], int]] = {
    "equator": ("(a), (b) two, on the equator", (-150, -30), 0),
    "upper": ("(c) two, on the upper half", (-150, -30), 45),
    "constraint": ("(d) three that hold", (-150, -30, 90), 0),
    "free": ("(d) three that let go", (-150, -30, 90), 45),
}
"""Panels with azimuths and elevation of the contacts (degrees): free choices beyond the text."""

CHOICES = "Angles and speeds of the rollers are free choices of the drawing."


def _at(azimuth_deg: int, elevation_deg: int, angle_deg: int, speed: Expr = REST) -> Roller:
    return Roller(rad(azimuth_deg), rad(elevation_deg), rad(angle_deg), speed)


def _equator() -> Floats:
    return ring(np.zeros(3), *np.eye(3)[:2])


# Figure 1 ----------------------------------------------------------------------------------------


def types_data() -> pd.DataFrame:
    """Contacts, axes and driven directions of each arrangement."""
    return long_form(*(part for panel in TYPES for part in _type_rows(panel)))


def _type_rows(panel: str) -> Iterator[Iterator[Row]]:
    _, azimuths, elevation = TYPES[panel]
    yield rows(panel, "equator", _equator())
    for k, azimuth in enumerate(azimuths, 1):
        roller = _at(azimuth, elevation, 0)
        p, eta = (floats(vector).ravel() for vector in (roller.contact, roller.axis))
        place = GAP * p
        yield rows(panel, f"P {k}", p)
        yield rows(panel, f"axis {k}", [place - HALF_LENGTH * eta, place + HALF_LENGTH * eta])
        yield rows(panel, f"driven {k}", [place, place + REACH * np.cross(p, eta)])


@styled
def draw_types(frame: pd.DataFrame) -> Figure:
    """Draw the four arrangements."""
    figure, ax = stage(5.5)
    for k, (panel, (title, azimuths, _)) in enumerate(TYPES.items()):
        left, top = 2.4 * (k % 2), 5.35 - 2.75 * (k // 2)
        label(ax, [left + 0.1, top], title, ha="left", size=SMALL_SIZE)
        view = View((left + 1.2, top - 1.35), 0.85)
        draw_globe(ax, view, points(frame, panel, "equator"))
        for roller in range(1, len(azimuths) + 1):
            _roller(ax, frame, panel, roller, view)
    return figure


def _roller(ax: Axes, frame: pd.DataFrame, panel: str, k: int, view: View) -> None:
    """Draw a roller with the direction that it drives, paler behind the sphere."""
    near = points(frame, panel, f"P {k}")[0] @ toward_viewer() > 0
    pale = 1.0 if near else 0.35
    axis = view.place(points(frame, panel, f"axis {k}"))
    line(ax, axis, color=ROLLER, lw=6, alpha=pale, solid_capstyle="round", zorder=3)
    arrow(ax, *view.place(points(frame, panel, f"driven {k}")), color=ACCENT, lw=1.8, alpha=pale)
    if panel == "free":
        middle = axis.mean(axis=0)
        for end in axis:
            arrow(ax, end, middle + 1.9 * (end - middle), lw=1.0, alpha=pale)


def describe_types(frame: pd.DataFrame) -> str:
    """Say how many rollers there are and how high."""
    told = []
    for panel, (_, azimuths, _) in TYPES.items():
        height = float(points(frame, panel, "P 1")[0, 2])
        place = f"{shown(height)} above the centre" if height else "on the equator"
        told.append(f"{len(azimuths)} rollers {place}")
    return (
        f"Four spheres of radius 1: {'; '.join(told)}. Each roller has an arrow in the direction"
        " in which it drives; those of the last sphere also let it slide along their axes."
    )


# Figure 2 ----------------------------------------------------------------------------------------

ONE = _at(-30, 32, 40)
PLATE = 1.3
"""Distance of the plane of eta from the centre (m)."""

THREE = (
    _at(0, 20, 20, Rational(-4, 5)),
    _at(110, 20, 20, Rational(1, 2)),
    _at(-130, 20, -20, Rational(3, 5)),
)
BESIDE = np.array([0.95, -0.1, -0.4])
"""Rollers of panel (b) with their speeds (m/s), and Q from Q_o (rad/s)."""


def sphere_data() -> pd.DataFrame:
    """Contact, base and axis of one roller; three lines, the point Q and the optimal point."""
    return long_form(*_axis_rows(), *_line_rows())


def _axis_rows() -> Iterator[Iterator[Row]]:
    p, east, north = (floats(ONE.frame[:, k]).ravel() for k in range(3))
    eta, place = floats(ONE.axis).ravel(), PLATE * p
    corners = [
        place + 0.62 * (a * east + b * north) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    level = np.array([p[0], p[1], 0]) / np.hypot(p[0], p[1])
    turns = np.linspace(0, 1, 13)[:, None]
    azimuth, elevation = (float(angle) for angle in (ONE.azimuth, ONE.elevation))
    around = 0.45 * np.hstack([np.cos(azimuth * turns), np.sin(azimuth * turns), 0 * turns])
    rising = 0.6 * (np.cos(elevation * turns) * level + np.sin(elevation * turns) * np.eye(3)[2])
    yield rows("axis", "equator", _equator())
    yield rows("axis", "plate", corners)
    yield rows("axis", "P", p)
    yield rows("axis", "foot", level)
    for name, vector in (("X", east), ("Y", north), ("eta", eta)):
        yield rows("axis", name, [place, place + 0.55 * vector])
    yield rows("axis", "theta 1", around)
    yield rows("axis", "theta 2", rising)


def _line_rows() -> Iterator[Iterator[Row]]:
    best = floats(optimum(THREE, RADIUS)).ravel()
    place = best + BESIDE
    yield rows("lines", "Q_o", best)
    yield rows("lines", "Q", place)
    for k, roller in enumerate(THREE, 1):
        foot, along = (floats(part).ravel() for part in roller.line(RADIUS))
        near = foot + ((place - foot) @ along) * along
        middle = foot + ((best - foot) @ along) * along
        yield rows("lines", f"line {k}", [middle - 0.9 * along, middle + 0.9 * along])
        yield rows("lines", f"foot {k}", near)


@styled
def draw_sphere(frame: pd.DataFrame) -> Figure:
    """Draw (a) one roller on the sphere and (b) three lines."""
    figure, ax = stage(5.9)
    label(ax, [0.1, 5.75], "(a) a roller's axis", ha="left")
    _axis(ax, frame, View((1.9, 4.2), 1.15))
    label(ax, [0.1, 2.65], "(b) distances to three lines", ha="left")
    _lines(ax, frame, View((2.1, 0.75), 1.3))
    return figure


def _axis(ax: Axes, frame: pd.DataFrame, view: View) -> None:
    draw_globe(ax, view, points(frame, "axis", "equator"))
    draw_triad(ax, View(view.origin, 0.75 * view.scale), ("$x$", "$y$", "$z$"))
    center = view.place([0, 0, 0])[0]
    contact, below = (view.place(points(frame, "axis", name))[0] for name in ("P", "foot"))
    tinted(ax, view.place(points(frame, "axis", "plate")), ROLLER, alpha=0.2, zorder=3)
    start = view.place(points(frame, "axis", "X"))[0]
    line(ax, [center, start], lw=1.2)
    line(ax, [center, below], ls=":", lw=1.2)
    for name, symbol, color in (("X", "$X_i$", ROLLER), ("Y", "$Y_i$", ROLLER),
                                ("eta", r"$\eta_i$", ACCENT)):  # fmt: skip
        ends = view.place(points(frame, "axis", name))
        arrow(ax, *ends, color=color, lw=1.8, zorder=5)
        label(ax, ends[1] + 0.28 * (ends[1] - ends[0]), symbol, color=color)
    for name, symbol, shift in (("theta 1", r"$\theta_{1,i}$", (0.0, -0.14)),
                                ("theta 2", r"$\theta_{2,i}$", (0.2, 0.0))):  # fmt: skip
        arc = view.place(points(frame, "axis", name))
        line(ax, arc, color=ANY, lw=1.6)
        label(ax, arc[len(arc) // 2], symbol, shift, color=ANY, size=SMALL_SIZE)
    dot(ax, np.array([center, contact, start]))
    label(ax, contact, "$P_i$", (-0.15, 0.13))
    label(ax, start, "$R_i$", (-0.05, -0.2))
    label(ax, center, "$O$", (-0.14, -0.1))


def _lines(ax: Axes, frame: pd.DataFrame, view: View) -> None:
    center = view.place([0, 0, 0])[0]
    place, best = (view.place(points(frame, "lines", name))[0] for name in ("Q", "Q_o"))
    for k, color in COLORS.items():
        ends = view.place(points(frame, "lines", f"line {k}"))
        line(ax, ends, color=color, lw=2.2, zorder=3)
        out = ends[1] - ends[0]
        label(ax, ends[1] + 0.2 * out / np.linalg.norm(out), f"$l_{k}$", color=color)
        foot = view.place(points(frame, "lines", f"foot {k}"))[0]
        line(ax, [place, foot], ls="--", lw=1.2)
        label(ax, (place + foot) / 2, f"$d_{k}$", (0.12, 0.08), size=SMALL_SIZE)
        dot(ax, foot[None])
    arrow(ax, center, best, color=ACCENT, lw=2.4, zorder=5)
    label(ax, best, "$Q_o$", (0.05, 0.18), color=ACCENT)
    label(ax, place, "$Q$", (0.05, -0.18))
    dot(ax, np.array([center, place]))
    label(ax, center, "$O$", (-0.15, -0.08))


def describe_sphere(frame: pd.DataFrame) -> str:
    """Say the sums of squares at both points."""
    place, best = (points(frame, "lines", name)[0] for name in ("Q", "Q_o"))
    return (
        "Above, a sphere with the contact P at an azimuth and an elevation; over it a plane with"
        " the level vector X, the vector Y towards the pole, and the axis eta between them. Below,"
        " three lines that do not meet, one parallel to each contact's radius: the sum of the"
        f" squared distances is {shown(_squares(frame, place))} at a point Q and"
        f" {shown(_squares(frame, best))} at the best one, where the angular velocity ends."
    )


def _squares(frame: pd.DataFrame, place: Floats) -> float:
    """Sum of the squared distances of a point to the three lines."""
    total = 0.0
    for k in COLORS:
        start, end = points(frame, "lines", f"line {k}")
        along = (end - start) / np.linalg.norm(end - start)
        total += float(np.linalg.norm(np.cross(place - start, along))) ** 2
    return total


SKETCHES = (
    Drawing(
        1,
        "Arrangements of rollers",
        "Short bars: rollers with their axes, paler behind the sphere; arrows: where they drive,"
        f" and where they let go. {REDRAWN} {CHOICES}",
        types_data,
        draw_types,
        describe_types,
    ),
    Drawing(
        2,
        "A roller's axis, and the lines of three rollers",
        f"(a) The base of Eq. (4). (b) The distances of Eq. (6), r = 1 m. {REDRAWN} {CHOICES}",
        sphere_data,
        draw_sphere,
        describe_sphere,
    ),
)
