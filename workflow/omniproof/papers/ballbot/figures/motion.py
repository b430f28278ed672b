"""Figure 5: the motion at the ground, at the centre and at the wheels.

Panel (a) shows what the laws differ in: the surface that the wheels stand on moves as well.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc
from numpy.typing import ArrayLike
from sympy import ImmutableMatrix, Rational, pi

from omniproof.kinematics.ballbot import (
    AZIMUTHS,
    ball_twist,
    contact_frame,
    law_over_surface_at_rest,
    platform_twist,
    relative_law,
)
from omniproof.kinematics.frames import origin
from omniproof.papers.ballbot.figures.scene import (
    BALL_RADIUS,
    BODY,
    CHOICES,
    RUNNING_RADIUS,
    WHEEL,
    WHEELS,
    ZENITH_ANGLE,
    contacts,
)
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.globe import dot
from omniproof.report.sketch import (
    MUTED,
    REDRAWN,
    arrow,
    circle,
    floats,
    label,
    line,
    outlined,
    shown,
    tinted,
    wheel,
)
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, stage, styled

SPEED = Rational(3, 5)
YAW_RATE = Rational(1, 4)
"""Motion of the drawing: along x in (a); along x and turning in (b) (m/s, rad/s)."""

HEIGHTS = (1, Rational(1, 2), 0, -1)
CENTER = 2
"""Heights over the centre at which panel (a) shows velocities of the ball (m)."""


def motion_data() -> pd.DataFrame:
    """Side view: velocities of ball and platform (x, z); top view: wheel speeds of both laws."""
    ball = ball_twist(SPEED, 0, 0, BALL_RADIUS)
    platform = platform_twist(SPEED, 0, 0)
    places = {f"ball {k}": (ball, (0, 0, height)) for k, height in enumerate(HEIGHTS, 1)}
    # A wheel that drives along x stands beside the plane of travel, so y is not seen here.
    contact = origin(contact_frame(-pi / 2, ZENITH_ANGLE, RUNNING_RADIUS))
    places |= {"surface": (ball, contact), "platform": (platform, contact)}
    arrows = (
        _vector("side", name, place, twist.at(ImmutableMatrix(place)))
        for name, (twist, place) in places.items()
    )
    return long_form(*arrows, rows("side", "radius", [BALL_RADIUS, RUNNING_RADIUS]), *_from_above())


def _from_above() -> Iterator[Iterator[Row]]:
    motion = ImmutableMatrix([SPEED, 0, YAW_RATE])
    yield _vector("above", "v", (0, 0, 0), (SPEED, 0, 0))
    laws = {
        "printed": law_over_surface_at_rest(ZENITH_ANGLE, RUNNING_RADIUS),
        "rolling": relative_law(ZENITH_ANGLE, RUNNING_RADIUS, BALL_RADIUS),
    }
    for name, law in laws.items():
        speeds = floats(law * motion).ravel()
        for k, frame, speed in zip(WHEELS, contacts(), speeds, strict=True):
            yield _vector("above", f"{name} {k}", frame[:3, 3], speed * frame[:3, 1])


def _vector(panel: str, series: str, start: ArrayLike, along: ArrayLike) -> Iterator[Row]:
    """Two points in space as the plane of the panel sees them."""
    seen = [0, 2] if panel == "side" else [0, 1]
    first, shift = (np.array(part, dtype=np.float64).ravel() for part in (start, along))
    return rows(panel, series, [first[seen], (first + shift)[seen]])


@dataclass(frozen=True)
class Sheet:
    """Where a flat drawing stands on the stage: place of its origin, inches a metre."""

    origin: tuple[float, float]
    scale: float

    def place(self, plane: Floats) -> Floats:
        """Points of the drawing (M x 2) on the stage."""
        return np.asarray(self.origin) + self.scale * plane


@styled
def draw_motion(frame: pd.DataFrame) -> Figure:
    """Draw (a) the ball from the side and (b) the platform from above."""
    figure, ax = stage(5.95)
    label(ax, [0.1, 5.8], "(a) at the ground and at the centre, from the side", ha="left")
    _side(ax, frame, Sheet((1.75, 4.3), 1.2))
    label(ax, [0.1, 2.6], "(b) at the centre and at the wheels, from above", ha="left")
    _above(ax, frame, Sheet((1.75, 1.25), 1.5))
    return figure


def _side(ax: Axes, frame: pd.DataFrame, sheet: Sheet) -> None:
    """Panel (a): the velocities of the ball grow from the ground upwards."""
    for radius in points(frame, "side", "radius")[0]:
        circle(ax, sheet.origin, sheet.scale * radius)
    ball = [sheet.place(points(frame, "side", f"ball {k}")) for k in range(1, len(HEIGHTS) + 1)]
    ground = ball[-1][0]
    line(ax, [[0.2, ground[1]], [4.6, ground[1]]], lw=1.2)
    line(ax, [ball[0][1], ground], ls=":", alpha=MUTED)
    line(ax, [ball[0][0], ground], lw=0.8, alpha=MUTED)
    for ends in ball[:-1]:
        arrow(ax, *ends, lw=1.2, alpha=MUTED)
    _turns(ax, ball[CENTER][0], ground)
    arrow(ax, *ball[CENTER], lw=2.4, color=BODY)
    beside = sheet.origin[0] + 1.12 * sheet.scale
    label(ax, [beside, ball[CENTER][0][1]], "$v_{xy}^B = v_{xy}^G$", ha="left")
    _at_contact(ax, frame, sheet, beside)


def _turns(ax: Axes, center: Floats, ground: Floats) -> None:
    """Name B and G, with the turns about the vertical there."""
    dot(ax, np.array([center, ground]))
    label(ax, center, r"$\mathbf{B}$", (-0.14, 0.0))
    label(ax, ground, r"$\mathbf{G}$", (0.0, -0.17))
    for place, name in ((center, r"$\omega_z^B$"), (ground, r"$\omega_z^G$")):
        middle = place + np.array([0, 0.2])
        ax.add_patch(Arc(tuple(middle), 0.34, 0.12, theta1=130, theta2=410, lw=1.1, color=INK))
        label(ax, middle, name, (-0.34, 0.03), size=SMALL_SIZE)


def _at_contact(ax: Axes, frame: pd.DataFrame, sheet: Sheet, beside: float) -> None:
    """Draw a wheel's contact: the platform moves over a surface that moves too."""
    lift = np.array([0, 0.05])
    for name, side, color in (("platform", lift, BODY), ("surface", -lift, ACCENT)):
        ends = sheet.place(points(frame, "side", name))
        arrow(ax, *(ends + side), color=color, lw=2.4)
        label(ax, [beside, ends[0][1]], f"{name} at a wheel", (0, 2 * side[1]), ha="left")
    dot(ax, ends[:1])


def _above(ax: Axes, frame: pd.DataFrame, sheet: Sheet) -> None:
    """Panel (b): one motion of the platform, and its wheel speeds by both laws."""
    corners = [sheet.place(points(frame, "above", f"printed {k}"))[0] for k in WHEELS]
    tinted(ax, corners, BODY)
    outlined(ax, corners, BODY, lw=1.2)
    center, tip = sheet.place(points(frame, "above", "v"))
    dot(ax, center[None])
    arrow(ax, center, tip, color=BODY, lw=2.4)
    label(ax, center, r"$\mathbf{B}$", (-0.14, 0.12))
    label(ax, tip, "$v_{xy}^B$", (0.08, 0.1), ha="left")
    ax.add_patch(Arc(tuple(center), 0.5, 0.5, theta1=200, theta2=330, lw=1.1, color=INK))
    label(ax, center, r"$\omega_z^B$", (0.08, -0.4), size=SMALL_SIZE)
    for k in WHEELS:
        _wheel_from_above(ax, frame, sheet, k)
    _key(ax)


def _wheel_from_above(ax: Axes, frame: pd.DataFrame, sheet: Sheet, k: int) -> None:
    right, printed = (
        sheet.place(points(frame, "above", f"{law} {k}")) for law in ("rolling", "printed")
    )
    angle = float(AZIMUTHS[k - 1])
    out = np.array([np.cos(angle), np.sin(angle)])
    wheel(ax, right[0], angle, (0.4, 0.14), color=WHEEL, alpha=0.35, lw=0)
    arrow(ax, *(right + 0.07 * out), color=ACCENT, lw=2.4)
    arrow(ax, *(printed - 0.07 * out), color=INK, lw=1.2, ls="--")
    label(ax, right[0] + 0.28 * out, f"$C_{k}$")


def _key(ax: Axes) -> None:
    arrow(ax, [3.3, 1.5], [3.65, 1.5], color=ACCENT, lw=2.4)
    label(ax, [3.75, 1.5], "rolling ball", ha="left", size=SMALL_SIZE)
    arrow(ax, [3.3, 1.2], [3.65, 1.2], lw=1.2, ls="--")
    label(ax, [3.75, 1.2], "Eq. (10)", ha="left", size=SMALL_SIZE)


def describe_motion(frame: pd.DataFrame) -> str:
    """Say the speeds at the contact and at the wheels."""
    surface, wheel_ = (
        float(np.diff(points(frame, "side", name)[:, 0])[0]) for name in ("surface", "platform")
    )
    speeds = {
        law: ", ".join(_length(points(frame, "above", f"{law} {k}")) for k in WHEELS)
        for law in ("printed", "rolling")
    }
    return (
        "Above, a rolling ball from the side: it rests at the ground contact G, its centre B moves"
        f" with the platform, and where a wheel touches, the platform moves at {shown(wheel_)} m/s"
        f" and the surface at {shown(surface)} m/s the same way. Below, the platform from above:"
        f" the three wheels run at {speeds['rolling']} m/s, and at {speeds['printed']} m/s"
        " by Eq. (10)."
    )


def _length(ends: Floats) -> str:
    return shown(float(np.linalg.norm(ends[1] - ends[0])))


MOTION = (
    Drawing(
        5,
        "Motion at the ground, at the centre and at the wheels",
        "(a) Thin arrows: velocities of the ball, which turns about G. A wheel that drives along"
        " the travel touches beside the plane of the drawing. (b) Wheel speeds of one motion by"
        " both laws, with the yaw rate relative to the ball."
        f" {REDRAWN} {CHOICES} The velocities of the surface and the speeds by the second law are"
        " additions.",
        motion_data,
        draw_motion,
        describe_motion,
    ),
)
