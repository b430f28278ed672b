"""The wrong sign of Eq. (6), and where it sends a robot: one path, read back by both matrices."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import Matrix, symbols

import omniproof
from omniproof.audit.context import Context
from omniproof.kinematics.omni import twist_matrix, velocity_matrix
from omniproof.papers.omni_arrangement.arrangements import CORRECTED
from omniproof.papers.omni_arrangement.derivations import REGISTRY
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.sketch import floats, label, shown
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, WIDTH, styled
from omniproof.transcription.loader import load_paper

PAPER = Path(omniproof.__file__).parents[2] / "paper_data" / "omni-arrangement"
ANGLES = CORRECTED["X"]
RADIUS = 1.0
STEPS, MARKS = 144, 12
"""Points of the circle, and of them those that a line joins to where the print has them."""


def sign_data() -> pd.DataFrame:
    """Path of the robot and path by Eq. (6) as printed (x and y in m), with the marks of both."""
    turn = np.linspace(0, 2 * np.pi, STEPS + 1)
    path = RADIUS * np.column_stack([np.sin(turn), 1 - np.cos(turn)])
    wrong = path @ misreading()[:2, :2].T
    every = slice(0, STEPS, STEPS // MARKS)
    ahead = np.array([[RADIUS, 0.0]])
    return long_form(
        rows("path", "corrected", path),
        rows("path", "printed", wrong),
        rows("marks", "corrected", path[every]),
        rows("marks", "printed", wrong[every]),
        rows("ahead", "printed", ahead @ misreading()[:2, :2].T),
    )


def misreading() -> Floats:
    """Matrix from a twist (V_x, V_y, L yaw rate) to what Eq. (6) as printed makes of it: 3 x 3."""
    forward = velocity_matrix(ANGLES)
    known = dict(zip(symbols("alpha_1:4", real=True), ANGLES, strict=True))
    times_determinant = Matrix(Context(load_paper(PAPER), REGISTRY, {}).evaluate("eq:6"))
    printed = times_determinant.subs(known) / Matrix(forward).det()
    if printed == twist_matrix(forward):
        raise ValueError("Eq. (6) as printed is right for this arrangement: nothing to draw")
    return floats(printed * forward)


@styled
def draw_sign(frame: pd.DataFrame) -> Figure:
    """Draw the entry above, and below it both paths from one start."""
    figure = Figure(figsize=(WIDTH, 5.3))
    _entry(figure)
    ax = figure.add_axes((0.03, 0.02, 0.94, 0.74))
    ax.set_aspect("equal")
    ax.set_axis_off()
    for start, end in zip(*(points(frame, "marks", s) for s in ("corrected", "printed")),
                          strict=True):  # fmt: skip
        ax.plot(*np.column_stack([start, end]), color=INK, lw=0.7, alpha=0.6)
    _path(ax, frame, "corrected", TYPE_COLORS["Z"], "-")
    _path(ax, frame, "printed", TYPE_COLORS["Y"], "--")
    ax.plot(0, 0, "o", color=INK, ms=7)
    label(ax, [0, -0.13], "start", size=SMALL_SIZE)
    label(ax, [-0.45, 1.0], "corrected:\nas it drives", size=SMALL_SIZE, color=TYPE_COLORS["Z"])
    label(ax, [0.7, 2.13], "printed", size=SMALL_SIZE, color=TYPE_COLORS["Y"], ha="left")
    return figure


def _entry(figure: Figure) -> None:
    """Write the printed entry and the right one."""
    texts = (
        (0.86, "printed", r"$\sin\alpha_1$", r"$+$", r"$\sin\alpha_2$", TYPE_COLORS["Y"]),
        (0.95, "corrected", r"$\sin\alpha_1$", r"$-$", r"$\sin\alpha_2$", TYPE_COLORS["Z"]),
    )
    for height, word, left, sign, right, color in texts:
        figure.text(0.1, height, word, color=color, size=SMALL_SIZE, va="center")
        for place, part in ((0.43, left), (0.64, right)):
            figure.text(place, height, part, size=17, va="center")
        figure.text(0.59, height, sign, size=19, color=color, va="center", ha="center")
    figure.text(0.59, 0.86, r"$\bigcirc$", size=24, color=ACCENT, va="center", ha="center")


def _path(ax: Axes, frame: pd.DataFrame, name: str, color: str, dashes: str) -> None:
    ax.plot(*points(frame, "path", name).T, color=color, ls=dashes, lw=2.4)
    ax.plot(*points(frame, "marks", name).T, "o", color=color, ms=4)


def describe_sign(frame: pd.DataFrame) -> str:
    """Say how far both paths are apart."""
    path, wrong = (points(frame, "path", name) for name in ("corrected", "printed"))
    apart = float(np.linalg.norm(path - wrong, axis=1).max())
    ((ahead, aside),) = points(frame, "ahead", "printed")
    return (
        "Above, entry (2, 3) of Eq. (6): sin α₁ + sin α₂ as printed, the plus circled, and"
        f" sin α₁ − sin α₂. Below, a circle of radius {shown(RADIUS, 0)} m, and the slanted oval"
        f" that the printed matrix makes of the same wheel speeds: up to {shown(apart)} m apart."
        f" A robot that drives {shown(RADIUS, 0)} m straight ahead it puts at"
        f" ({shown(ahead)}, {shown(aside)}) m."
    )


SIGN = Drawing(
    "sign",
    "One sign, and where it sends the robot",
    "A robot of Type (X) drives round a circle without turning. From the same speeds of its wheels,"
    " Eq. (6) with the printed plus makes the dashed path; thin lines join what belongs together."
    " The paper has no such figure.",
    sign_data,
    draw_sign,
    describe_sign,
)
