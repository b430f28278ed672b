"""Figures 3 and 4: one motion in two frames, and the frames of the ballbot."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import ImmutableMatrix, MatrixBase, Rational, pi

from omniproof.kinematics.frames import (
    axes,
    change_frame,
    components,
    differential_motion,
    origin,
    rotation,
    translation,
)
from omniproof.papers.ballbot.figures.scene import (
    CHOICES,
    WHEELS,
    ZENITH_ANGLE,
    ball_rows,
    contacts,
    draw_axes,
    draw_ball,
    draw_plate,
    draw_wheels,
    platform_rows,
    wheel_rows,
)
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.globe import dot
from omniproof.report.sketch import (
    REDRAWN,
    View,
    arrow,
    floats,
    label,
    line,
    shown,
)
from omniproof.report.svg import ACCENT, TYPE_COLORS, stage, styled

TRANSFORM = (
    translation("x", Rational(19, 10))
    * translation("z", Rational(3, 5))
    * rotation("z", -pi / 5)
    * rotation("y", -pi / 4)
)
"""T_B^C of Figure 3, and below the motion in B: free choices (m, rad)."""

TURN = ImmutableMatrix([0, 0, Rational(2, 5)])
SHIFT = ImmutableMatrix([Rational(3, 20), 0, Rational(1, 2)])
ARC = np.linspace(0, float(ZENITH_ANGLE), 13)
AXIS, LONG_AXIS = 0.34, 0.45


def triad_rows(panel: str, name: str, frame: Floats, length: float) -> Iterator[Row]:
    """Origin and axis ends of a frame: the rows `name`, `name x`, `name y`, `name z`."""
    start = frame[:3, 3]
    yield from rows(panel, name, start)
    for k, axis in enumerate("xyz"):
        yield from rows(panel, f"{name} {axis}", start + length * frame[:3, k])


def triad(
    frame: pd.DataFrame, panel: str, name: str, view: View
) -> tuple[Floats, Mapping[str, Floats]]:
    """Origin and axis ends of a frame on the stage."""
    ends = {axis: view.place(points(frame, panel, f"{name} {axis}"))[0] for axis in "xyz"}
    return view.place(points(frame, panel, name))[0], ends


def motion_data() -> pd.DataFrame:
    """Frames B and C on one body, with the motion of its points there, in axes of B."""
    turn, shift = components(change_frame(differential_motion(TURN, SHIFT), TRANSFORM))
    there = origin(TRANSFORM)
    vectors = {
        "d B": (ImmutableMatrix([0, 0, 0]), SHIFT),
        "delta B": (ImmutableMatrix([0, 0, 0]), TURN),
        "d C": (there, axes(TRANSFORM) * shift),
        "delta C": (there, axes(TRANSFORM) * turn),
        "d B at C": (there, SHIFT),
    }
    return long_form(
        triad_rows("frames", "B", np.eye(4), 0.75),
        triad_rows("frames", "C", floats(TRANSFORM), 0.8),
        *(_vector(name, *ends) for name, ends in vectors.items()),
    )


def _vector(name: str, start: MatrixBase, along: MatrixBase) -> Iterator[Row]:
    return rows("frames", name, [floats(start).ravel(), floats(start + along).ravel()])


@styled
def draw_motion(frame: pd.DataFrame) -> Figure:
    """Draw both frames, the transform between them and the motion at each."""
    figure, ax = stage(2.2)
    view = View((0.7, 0.55), 1.35)
    _body(ax, frame, view)
    for name in "BC":
        start, ends = triad(frame, "frames", name, view)
        draw_axes(ax, start, ends)
        label(ax, start, f"$\\mathbf{{{name}}}$", (-0.13, -0.13))
        for kind, symbol, color, side in (
            ("d", rf"\bar{{d}}^{name}", ACCENT, (0.16, 0.06)),
            ("delta", rf"\bar{{\delta}}^{name}", TYPE_COLORS["Z"], (-0.17, 0.1)),
        ):
            vector = view.place(points(frame, "frames", f"{kind} {name}"))
            arrow(ax, *vector, color=color, lw=2.4)
            label(ax, vector[1], f"${symbol}$", side)
    shifted = view.place(points(frame, "frames", "d B at C"))[1]
    moved = view.place(points(frame, "frames", "d C"))[1]
    line(ax, view.place(points(frame, "frames", "d B at C")), ls="--")
    line(ax, [shifted, moved], ls=":", lw=1.4)
    return figure


def _body(ax: Axes, frame: pd.DataFrame, view: View) -> None:
    """Draw the transform as an arrow between the origins."""
    start, end = (view.place(points(frame, "frames", name))[0] for name in "BC")
    arrow(ax, start, end, lw=1.0, ls="--")
    label(ax, (start + end) / 2, "$T_B^C$", (0.0, 0.17))


def describe_motion(frame: pd.DataFrame) -> str:
    """Say how much faster the second point is."""
    speeds = [
        float(np.linalg.norm(np.diff(points(frame, "frames", name), axis=0)))
        for name in ("d B", "d C")
    ]
    return (
        "Two frames B and C fixed to one rigid body, joined by the transform T. Both turn by one"
        f" rotation; the origin of B moves by {shown(speeds[0])}, that of C by {shown(speeds[1])}:"
        " the difference is the rotation times the distance."
    )


def structure_data() -> pd.DataFrame:
    """The ballbot, and its frames with the angle phi and the radius L of wheel 1."""
    first = contacts()[0]
    out = first[:3, 3] * np.array([1, 1, 0])
    running = float(np.linalg.norm(first[:3, 3]))
    outward = out / np.linalg.norm(out)
    arc = [0.45 * running * (np.sin(a) * outward - np.cos(a) * np.array([0, 0, 1])) for a in ARC]
    return long_form(
        ball_rows("structure"),
        wheel_rows("structure", contacts()),
        platform_rows("structure", contacts()),
        ball_rows("frames"),
        triad_rows("frames", "B", np.eye(4), LONG_AXIS),
        *(triad_rows("frames", f"C {k}", c, AXIS) for k, c in zip(WHEELS, contacts(), strict=True)),
        rows("frames", "phi", arc),
        rows("frames", "L", [np.zeros(3), first[:3, 3]]),
    )


@styled
def draw_structure(frame: pd.DataFrame) -> Figure:
    """Draw (a) the structure and (b) the frames."""
    figure, ax = stage(6.15)
    label(ax, [0.1, 6.0], "(a) structure", ha="left")
    above = View((2.4, 5.0), 0.95)
    draw_ball(ax, frame, "structure", above)
    draw_plate(ax, frame, "structure", above)
    draw_wheels(ax, frame, "structure", above)
    for k in WHEELS:
        dot(ax, above.place(points(frame, "structure", f"C {k}")))
    label(ax, [0.1, 3.7], "(b) frames", ha="left")
    _frames(ax, frame, View((2.4, 2.0), 1.55))
    return figure


def _frames(ax: Axes, frame: pd.DataFrame, view: View) -> None:
    draw_ball(ax, frame, "frames", view)
    start, ends = triad(frame, "frames", "B", view)
    draw_axes(ax, start, ends, "^B")
    label(ax, start, r"$\mathbf{B}$", (0.13, -0.13))
    for k in WHEELS:
        place, tips = triad(frame, "frames", f"C {k}", view)
        draw_axes(ax, place, tips, accent="y")
        dot(ax, place[None])
        away = place - np.mean(list(tips.values()), axis=0)
        label(ax, place + 0.2 * away / np.linalg.norm(away), f"$C_{k}$")
    radius = view.place(points(frame, "frames", "L"))
    line(ax, radius, ls="--")
    label(ax, radius.mean(axis=0), "$L$", (-0.12, 0.12))
    bottom = view.place(points(frame, "frames", "G"))[0]
    line(ax, [start, bottom], ls=":")
    arc = view.place(points(frame, "frames", "phi"))
    line(ax, arc)
    label(ax, arc[len(arc) // 2], r"$\phi$", (-0.05, -0.14))


def describe_structure(frame: pd.DataFrame) -> str:
    """Say where the frames stand."""
    x, y, z = points(frame, "frames", "C 1")[0]
    degrees = float(np.degrees(np.arctan2(np.hypot(x, y), -z)))
    return (
        "Above, a ball with a level plate and three wheels inside. Below, its frames: B at the"
        " centre with z upwards, and C_1, C_2, C_3 at the contacts, 120 degrees apart and"
        f" {degrees:.0f} degrees from the lowest point; each z-axis points to the centre, each"
        " y-axis, the driven direction, is level."
    )


ASSIGNMENT = (
    Drawing(
        3,
        "One differential motion in two frames",
        "Eq. (1): B and C are fixed to one body. Dashed beside the motion at C: the motion at B;"
        f" dotted: δ × p. {REDRAWN} Transform and motion are free choices of the drawing.",
        motion_data,
        draw_motion,
        describe_motion,
    ),
    Drawing(
        4,
        "Structure and coordinate frames",
        "Drawn from the products of rotations and translations in Eqs. (5-1) to (5-3), not from the"
        f" matrices printed for them. {REDRAWN} {CHOICES}",
        structure_data,
        draw_structure,
        describe_structure,
    ),
)
