"""What the figures of this paper share: ball, ground, platform and wheels, placed by their frames.

Everything is computed in metres in the platform's frame B for a ball of radius 1 m, from the
contact frames of `omniproof.kinematics.ballbot`; a scene is rows of a data frame, and drawing reads
these rows only.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from sympy import MatrixBase, Rational, pi

from omniproof.kinematics import ballbot
from omniproof.report.figure import Floats, Row, points, rows
from omniproof.report.globe import dot, draw_globe, ring
from omniproof.report.sketch import (
    View,
    arrow,
    floats,
    label,
    outlined,
    tinted,
)
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS

BALL_RADIUS = 1
RUNNING_RADIUS = Rational(9, 10)
ZENITH_ANGLE = pi / 4
WHEEL_RADIUS = 0.17
"""Free choices of the drawings (m, rad): the paper gives no numbers."""

WHEEL = TYPE_COLORS["X"]
BODY = TYPE_COLORS["Y"]
WHEELS = (1, 2, 3)
CHOICES = "Radii and zenith angle are free choices of the drawing."


def contacts() -> list[Floats]:
    """Frames C_1, C_2, C_3 of wheels inside the ball: 4x4 each."""
    return _placed(ballbot.contact_frame(a, ZENITH_ANGLE, RUNNING_RADIUS) for a in ballbot.AZIMUTHS)


def contacts_on_top() -> list[Floats]:
    """The same for wheels on the outside, as far from the upper pole: 4x4 each."""
    above = pi - ZENITH_ANGLE
    return _placed(ballbot.contact_frame(a, above, BALL_RADIUS) for a in ballbot.AZIMUTHS)


def _placed(frames: Iterable[MatrixBase]) -> list[Floats]:
    return [floats(frame) for frame in frames]


def wheel_rim(frame: Floats, inward: int = 1) -> Floats:
    """Rim of the wheel that touches at a contact frame, on its inner (1) or outer (-1) side."""
    along, out = WHEEL_RADIUS * frame[:3, 1], WHEEL_RADIUS * frame[:3, 2]
    return ring(frame[:3, 3] + inward * out, along, out)


def level_ring(radius: float, height: float) -> Floats:
    """Level circle about the vertical through the centre: 49 x 3."""
    return ring(np.array([0, 0, height]), np.array([radius, 0, 0]), np.array([0, radius, 0]))


def ball_rows(panel: str) -> Iterator[Row]:
    """Equator and ground contact of the ball, and a piece of the ground."""
    yield from rows(panel, "equator", level_ring(BALL_RADIUS, 0))
    yield from rows(panel, "G", [0, 0, -BALL_RADIUS])
    corners = [(-0.9, -0.7), (0.9, -0.7), (0.9, 0.7), (-0.9, 0.7)]
    yield from rows(panel, "ground", [(x, y, -BALL_RADIUS) for x, y in corners])


def wheel_rows(panel: str, frames: Sequence[Floats], inward: int = 1) -> Iterator[Row]:
    """Rims and contacts of the wheels."""
    for k, frame in zip(WHEELS, frames, strict=True):
        yield from rows(panel, f"wheel {k}", wheel_rim(frame, inward))
        yield from rows(panel, f"C {k}", frame[:3, 3])


def platform_rows(panel: str, frames: Sequence[Floats]) -> Iterator[Row]:
    """Corners of a level plate on the centres of the wheels."""
    corners = [frame[:3, 3] + WHEEL_RADIUS * frame[:3, 2] for frame in frames]
    yield from rows(panel, "platform", corners)


def draw_ball(ax: Axes, frame: pd.DataFrame, panel: str, view: View) -> None:
    """Draw silhouette, equator (dotted behind), ground and its contact G."""
    equator = points(frame, panel, "equator")
    tinted(ax, view.place(points(frame, panel, "ground")), INK, alpha=0.07, zorder=0)
    draw_globe(ax, view, equator)
    dot(ax, view.place(points(frame, panel, "G")))


def draw_wheels(ax: Axes, frame: pd.DataFrame, panel: str, view: View) -> None:
    """Draw the wheels as discs, seen at their slant."""
    for k in WHEELS:
        rim = view.place(points(frame, panel, f"wheel {k}"))
        tinted(ax, rim, WHEEL, alpha=0.3, zorder=2.4)
        outlined(ax, rim, WHEEL, zorder=2.6)


def draw_plate(ax: Axes, frame: pd.DataFrame, panel: str, view: View) -> None:
    """Draw the platform."""
    plate = view.place(points(frame, panel, "platform"))
    tinted(ax, plate, BODY, alpha=0.25, zorder=2)
    outlined(ax, plate, BODY, zorder=2.2)


def draw_axes(
    ax: Axes, origin: Floats, ends: Mapping[str, Floats], index: str = "", accent: str = ""
) -> None:
    """Draw the named axes of a frame between points of the stage, one of them in the accent."""
    for name, end in ends.items():
        arrow(ax, origin, end, lw=1.2, color=ACCENT if name == accent else INK)
        along = end - origin
        beyond = 0.13 * along / max(float(np.linalg.norm(along)), 0.2)
        label(ax, end + beyond, f"${name}{index}$", size=SMALL_SIZE)
