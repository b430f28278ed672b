"""Figures 3, 4 and 7: the cube of wheel speeds, its images, and the volume of one."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from omniproof.kinematics.zonotope import faces
from omniproof.papers.omni_arrangement.figures.parts import (
    TWIST_AXES,
    TYPES,
    body_faces,
    draw_body,
    generators,
)
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import (
    REDRAWN,
    View,
    arrow,
    draw_axes,
    draw_triad,
    label,
    line,
    shown,
    tinted,
)
from omniproof.report.svg import ACCENT, TYPE_COLORS, stage, styled

SHOWN_TYPE = "X"
VOLUME_TYPE = "Y"
"""The types of Figures 3 and 7, where any would do; with (Y) the height is plainly no edge."""

WHEEL_AXES = ("$v_1$ [m/s]", "$v_2$ [m/s]", "$v_3$ [m/s]")


def body(panel: str, columns: Floats) -> Iterator[Row]:
    """Rows of the faces of the image of the cube under `columns` (3 x 3)."""
    for number, face in enumerate(faces(columns), 1):
        yield from rows(panel, f"face {number}", face)


def map_data() -> pd.DataFrame:
    """Cube W and its image for type (X), with the unit wheel speeds and their images a_k."""
    parts = []
    for panel, columns in (("wheel speeds", np.eye(3)), ("twists", generators(SHOWN_TYPE))):
        parts.append(body(panel, columns))
        parts += [rows(panel, f"a {k}", column) for k, column in enumerate(columns.T, 1)]
    return long_form(*parts)


@styled
def draw_map(frame: pd.DataFrame) -> Figure:
    """Draw the cube and the parallelepiped with the map between them."""
    figure, ax = stage(5.6)
    color = TYPE_COLORS[SHOWN_TYPE]
    for panel, view, names, letter in (
        ("wheel speeds", View((2.55, 4.25), 0.66), WHEEL_AXES, "e"),
        ("twists", View((2.55, 1.3), 0.85), TWIST_AXES, "a"),
    ):
        draw_body(ax, body_faces(frame, panel), view, color)
        draw_axes(ax, view, (1, 1, 1))
        draw_triad(ax, View((0.3, view.origin[1] - 0.9), view.scale), names)
        _vectors(ax, frame, panel, view, letter)
    label(ax, [0.1, 5.42], "cube $W$", ha="left")
    label(ax, [0.1, 2.6], "image $f_{A^{-1}}(W)$", ha="left")
    arrow(ax, [4.15, 3.2], [4.15, 2.4], lw=1.2)
    arrow(ax, [4.0, 2.4], [4.0, 3.2], lw=1.2)
    label(ax, [4.22, 2.8], "$f_{A^{-1}}$", ha="left")
    label(ax, [3.93, 2.8], "$f_A$", ha="right")
    return figure


def _vectors(ax: Axes, frame: pd.DataFrame, panel: str, view: View, letter: str = "a") -> None:
    """Draw the three vectors of a panel with their names."""
    start = view.place([0, 0, 0])[0]
    for k in range(1, 4):
        tip = view.place(points(frame, panel, f"a {k}"))[0]
        arrow(ax, start, tip, color=ACCENT)
        aside = (0.13, 0.04) if letter == "e" else (0.0, 0.0)  # the unit vectors lie on the axes
        beyond = 0.13 * (tip - start) / np.linalg.norm(tip - start)
        label(ax, tip + beyond, f"${letter}_{k}$", aside)


def describe_map(frame: pd.DataFrame) -> str:
    """Say how far the image reaches along each axis."""
    reach = frame[frame["panel"] == "twists"][["x", "y", "z"]].max()
    return (
        "Above, the cube of wheel speeds between -1 and 1 m/s; below, its image under the inverse"
        f" of A for type ({SHOWN_TYPE}), a parallelepiped that reaches"
        f" {shown(reach['x'])} m/s along V_x, {shown(reach['y'])} m/s along V_y and"
        f" {shown(reach['z'])} m/s along L times the yaw rate."
    ).replace("-1", "\N{MINUS SIGN}1")


def shapes_data() -> pd.DataFrame:
    """Faces of the image of W for each type."""
    return long_form(*(body(kind, generators(kind)) for kind in TYPES))


@styled
def draw_shapes(frame: pd.DataFrame) -> Figure:
    """Draw the three bodies at one scale."""
    figure, ax = stage(5.7)
    scale = 0.5
    for kind, title, origin, reach in (
        ("X", (0.1, 5.52), (1.0, 4.6), (1, 1, 1)),
        ("Y", (2.3, 5.52), (3.4, 4.6), (2, 1, 1)),
        ("Z", (0.1, 3.55), (2.4, 1.8), (4, 1, 3)),
    ):
        label(ax, title, f"Type ({kind})", ha="left")
        view = View(origin, scale)
        draw_body(ax, body_faces(frame, kind), view, TYPE_COLORS[kind])
        draw_axes(ax, view, reach)
    draw_triad(ax, View((0.35, 0.45), scale), TWIST_AXES)
    return figure


def describe_shapes(frame: pd.DataFrame) -> str:
    """Say the reach of each body."""
    said = [
        f"type ({kind}) {shown(part['x'].max())}, {shown(part['y'].max())} and"
        f" {shown(part['z'].max())} m/s"
        for kind, part in frame.groupby("panel", sort=True)
    ]
    return (
        "Three parallelepipeds at one scale, reaching along V_x, V_y and L times the yaw rate: "
        + "; ".join(said)
        + ". Type (Z) is the longest, along V_x and the rotation at once."
    )


def volume_data() -> pd.DataFrame:
    """Parallelepiped on a_1, a_2, a_3 from O, with the foot H of its height."""
    columns = _level(generators(VOLUME_TYPE))
    first, second, third = columns.T
    normal = np.cross(first, second) / np.linalg.norm(np.cross(first, second))
    corner = first + second + third
    shifted = [face / 2 + corner / 2 for face in faces(columns)]
    parts = [rows("volume", f"face {k}", face) for k, face in enumerate(shifted, 1)]
    parts += [rows("volume", f"a {k}", column) for k, column in enumerate(columns.T, 1)]
    base = [np.zeros(3), first, first + second, second]
    return long_form(
        *parts, rows("volume", "base", base), rows("volume", "H", normal * (normal @ third))
    )


def _level(columns: Floats) -> Floats:
    """Turn three vectors (columns) so that the first two lie in the horizontal plane."""
    first, second, _ = columns.T
    forward = first / np.linalg.norm(first)
    up = np.cross(first, second) / np.linalg.norm(np.cross(first, second))
    return np.array([forward, np.cross(up, forward), up]) @ columns


@styled
def draw_volume(frame: pd.DataFrame) -> Figure:
    """Draw base, height and body."""
    figure, ax = stage(2.75)
    view = View((1.9, 0.6), 1.9)
    draw_body(ax, body_faces(frame, "volume"), view, TYPE_COLORS[VOLUME_TYPE])
    tinted(ax, view.place(points(frame, "volume", "base")), ACCENT, alpha=0.3, zorder=2.2)
    _vectors(ax, frame, "volume", view)
    start, foot, tip = (
        view.place(points(frame, "volume", name))[0] for name in ("base", "H", "a 3")
    )
    line(ax, [start, foot], lw=1.6)
    line(ax, [foot, tip], ls=":")
    label(ax, foot, "$H$", (0.1, 0.12))
    label(ax, start, "$O$", (-0.05, -0.15))
    return figure


def describe_volume(frame: pd.DataFrame) -> str:
    """Say base, height and volume."""
    first, second = (points(frame, "volume", f"a {k}")[0] for k in (1, 2))
    base = float(np.linalg.norm(np.cross(first, second)))
    height = float(np.linalg.norm(points(frame, "volume", "H")))
    return (
        f"A parallelepiped on a_1, a_2 and a_3 of type ({VOLUME_TYPE}): its base, spanned by a_1"
        f" and a_2, has the area {shown(base, 3)} (m/s)², its height OH is {shown(height, 3)} m/s,"
        f" and their product is the volume {shown(base * height, 3)} (m/s)³."
    )


BODIES = (
    Drawing(
        3,
        "The linear map between wheel speeds and twists",
        f"The cube W of Eq. (8) and its inverse image, here for type ({SHOWN_TYPE}); hidden edges"
        f" are dotted. {REDRAWN}",
        map_data,
        draw_map,
        describe_map,
    ),
    Drawing(
        4,
        "Inverse image of W for the three types",
        "All three at one scale, a dot on an axis every 1 m/s; hidden edges are dotted. Type (Z)"
        f" with its corrected angles. {REDRAWN}",
        shapes_data,
        draw_shapes,
        describe_shapes,
    ),
    Drawing(
        7,
        "Volume of a parallelepiped",
        "Base spanned by the first two columns of the inverse, height OH along its normal; drawn"
        f" for type ({VOLUME_TYPE}), turned so that the base is level. The image of W has eight"
        f" times this volume. {REDRAWN}",
        volume_data,
        draw_volume,
        describe_volume,
    ),
)
