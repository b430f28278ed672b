"""Figure 2: the lines of two rollers, with and without a common point."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import Integer, Rational, rad

from omniproof.kinematics.frames import axes, rotation
from omniproof.papers.two_roller_sphere.arrangement import Roller, spin_of
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
    tinted,
)
from omniproof.report.svg import ACCENT, TYPE_COLORS, stage, styled

AZIMUTHS_DEG = (-160, -40)
SPEEDS = (Integer(-1), Rational(4, 5))
ANGLES_DEG = {"meeting": (0, 0), "skew": (25, 30)}
"""Free choices of the drawings: contacts, rim speeds (m/s), angles of the rollers by panel."""

TURN = floats(axes(rotation("z", rad(16)) * rotation("x", rad(20)) * rotation("z", rad(-16))))
"""How the plane of the contacts is tipped towards the viewer."""

PLANE = ((-0.6, -0.6), (1.4, -0.6), (1.4, 1.8), (-0.6, 1.8))
"""Corners of the piece of span{P1, P2} that is drawn, in P1 and P2."""

ROLLERS = (1, 2)
COLORS = {1: TYPE_COLORS["X"], 2: TYPE_COLORS["Y"]}
CHOICES = "Contacts, angles and speeds of the rollers are free choices of the drawing."
TITLES = {"meeting": "(a) lines that meet", "skew": "(b) lines that do not meet"}


def pair(panel: str) -> tuple[Roller, Roller]:
    """Rollers of a panel, with the radius 1 m."""
    first, second = (
        Roller(rad(azimuth), rad(angle), speed, Integer(1))
        for azimuth, angle, speed in zip(AZIMUTHS_DEG, ANGLES_DEG[panel], SPEEDS, strict=True)
    )
    return first, second


def lines_data() -> pd.DataFrame:
    """Both pairs of lines, the plane of the contacts, the least-squares spin and what it spans."""
    return long_form(*(part for panel in ANGLES_DEG for part in pair_rows(panel)))


def pair_rows(panel: str) -> Iterator[Iterator[Row]]:
    """Plane, contacts, lines, the points of the lines next to each other, and the spin."""
    rollers = pair(panel)
    spin = floats(spin_of(rollers)).ravel()
    sides = [floats(roller.direction).ravel() for roller in rollers]
    corners = [a * sides[0] + b * sides[1] for a, b in PLANE]
    yield _tipped(panel, "plane", np.array(corners))
    yield _tipped(panel, "omega", spin)
    for k, roller in zip(ROLLERS, rollers, strict=True):
        foot, direction = (floats(part).ravel() for part in roller.line)
        near = foot + ((spin - foot) @ direction) * direction
        along = [t * direction for t in (-1.0, 1.0)]
        yield _tipped(panel, f"P {k}", direction)
        yield _tipped(panel, f"line {k}", near + np.array(along))
        yield _tipped(panel, f"near {k}", near)


def _tipped(panel: str, series: str, space: Floats) -> Iterator[Row]:
    return rows(panel, series, space @ TURN.T)


@styled
def draw_lines(frame: pd.DataFrame) -> Figure:
    """Draw both pairs, one above the other."""
    figure, ax = stage(5.25)
    for panel, center, top in (("meeting", 4.35, 5.08), ("skew", 1.95, 2.73)):
        label(ax, [0.1, top], TITLES[panel], ha="left")
        draw_pair(ax, frame, panel, View((2.3, center), 1.15))
    return figure


def draw_pair(ax: Axes, frame: pd.DataFrame, panel: str, view: View) -> None:
    """Draw the plane of the contacts, both lines and the spin half-way between them."""
    center = view.place([0, 0, 0])[0]
    tinted(ax, view.place(points(frame, panel, "plane")), "#808080", alpha=0.14, zorder=0)
    near = []
    for k in ROLLERS:
        contact = view.place(points(frame, panel, f"P {k}"))[0]
        arrow(ax, center, contact, lw=1.0)
        label(ax, contact, f"$P_{k}$", (-0.12, -0.12) if k == 1 else (-0.02, -0.2))
        ends = view.place(points(frame, panel, f"line {k}"))
        line(ax, ends, color=COLORS[k], lw=2.2, zorder=3)
        label(ax, ends[1], rf"$l_{k}(\nu_{k})$", (-0.3 if k == 1 else 0.38, -0.08))
        near.append(points(frame, panel, f"near {k}")[0])
    spin = view.place(points(frame, panel, "omega"))[0]
    arrow(ax, center, spin, color=ACCENT, lw=2.4, zorder=5)
    label(ax, spin, r"$\omega$", (-0.2, 0.1), color=ACCENT)
    places = view.place(near)
    line(ax, places, ls=":", lw=1.4)
    dot(ax, np.vstack([places, center]))
    label(ax, center, "$O$", (0.05, 0.16))


def distance(frame: pd.DataFrame, panel: str) -> float:
    """Distance of the two lines, rad/s."""
    first, second = (points(frame, panel, f"near {k}")[0] for k in ROLLERS)
    return float(np.linalg.norm(second - first))


def describe_lines(frame: pd.DataFrame) -> str:
    """Say the distances of the lines."""
    meeting, skew = (distance(frame, panel) for panel in ANGLES_DEG)
    return (
        "Two pictures of two lines over the plane of both contacts, each line parallel to the"
        f" radius of its contact. Above, the lines lie in that plane and meet, at the distance"
        f" {shown(meeting)}; the angular velocity ends there. Below, they pass each other at"
        f" {shown(skew)} rad/s, and it ends half-way between them."
    )


LINES = (
    Drawing(
        2,
        "The lines of two rollers",
        "(a) Both roller angles are 0: the lines meet for any speeds. (b) Angles of"
        f" {ANGLES_DEG['skew'][0]}° and {ANGLES_DEG['skew'][1]}°: the angular"
        f" velocity with the least slip ends half-way between. {REDRAWN} {CHOICES}",
        lines_data,
        draw_lines,
        describe_lines,
    ),
)
