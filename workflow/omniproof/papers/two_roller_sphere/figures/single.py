"""Figure 1: one roller leaves the sphere the spins on a line."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import Rational, rad

from omniproof.kinematics import sphere
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.globe import dot, draw_globe, ring
from omniproof.report.sketch import (
    REDRAWN,
    View,
    arrow,
    floats,
    label,
    line,
    outlined,
    shown,
    tinted,
)
from omniproof.report.svg import ACCENT, TYPE_COLORS, stage, styled

AZIMUTH_DEG, ELEVATION_DEG, ANGLE_DEG = -15, 30, 260
RADIUS, SPEED = 1, Rational(4, 5)
ROLLER_SIZE = (0.22, 0.32)
PLACES = (-0.6, 0.0, 0.6)
"""Free choices of the drawing (m, m/s): half the roller's length and its diameter (m), and three
spins on the line (rad/s from its foot)."""

ROLLER = TYPE_COLORS["X"]
CHOICES = "Place, axis and speed of the roller are free choices of the drawing."


def single_data() -> pd.DataFrame:
    """Sphere, roller, the plane of its axis and contact, and the line of spins in that plane."""
    place = rad(AZIMUTH_DEG), rad(ELEVATION_DEG)
    contact = sphere.contact_direction(*place)
    axis = sphere.roller_axis(*sphere.tangent_base(*place), rad(ANGLE_DEG))
    p, eta = floats(contact).ravel(), floats(axis).ravel()
    found = sphere.constraint_line(contact, axis, SPEED, RADIUS)
    foot, direction = (floats(part).ravel() for part in found)
    half, outer = ROLLER_SIZE[0], RADIUS + ROLLER_SIZE[1]
    roller = [
        h * eta + d * p for h, d in ((-half, RADIUS), (half, RADIUS), (half, outer), (-half, outer))
    ]
    corners = [a * eta + b * p for a, b in ((-1.1, -0.9), (-1.1, 1.4), (1, 1.4), (1, -0.9))]
    spins = (
        rows("sphere", f"omega {k}", foot + shift * direction) for k, shift in enumerate(PLACES, 1)
    )
    return long_form(
        rows("sphere", "equator", ring(np.zeros(3), *np.eye(3)[:2])),
        rows("sphere", "plane", corners),
        rows("sphere", "P", RADIUS * p),
        rows("sphere", "eta", eta),
        rows("sphere", "roller", roller),
        rows("sphere", "foot", foot),
        rows("sphere", "line", [foot - 0.85 * direction, foot + 1.3 * direction]),
        *spins,
    )


@styled
def draw_single(frame: pd.DataFrame) -> Figure:
    """Draw the sphere with its roller, and spins that end on one line."""
    figure, ax = stage(4.1)
    view = View((2.25, 1.85), 1.3)
    draw_globe(ax, view, points(frame, "sphere", "equator"))
    seen = {
        name: view.place(points(frame, "sphere", name))
        for name in ("plane", "P", "eta", "roller", "foot", "line")
    }
    center = view.place([0, 0, 0])[0]
    tinted(ax, seen["plane"], ROLLER, alpha=0.13)
    tinted(ax, seen["roller"], ROLLER, alpha=0.35, zorder=2.4)
    outlined(ax, seen["roller"], ROLLER, zorder=2.6)
    line(ax, seen["line"], color=ROLLER, lw=2.2)
    for k in range(1, len(PLACES) + 1):
        spin = view.place(points(frame, "sphere", f"omega {k}"))[0]
        arrow(ax, center, spin, color=ACCENT, lw=2.0)
    _names(ax, center, seen)
    return figure


def _names(ax: Axes, center: Floats, seen: dict[str, Floats]) -> None:
    """Draw contact, axis and foot with their names."""
    contact, axis = seen["P"][0], seen["eta"][0]
    arrow(ax, center, contact, lw=1.2)
    arrow(ax, center, axis, lw=1.2)
    dot(ax, np.array([center, contact, seen["foot"][0]]))
    label(ax, center, "$O$", (-0.17, -0.05))
    label(ax, contact, "$P_i$", (-0.12, -0.2))
    label(ax, axis, r"$\eta_i$", (0.17, -0.02))
    label(ax, seen["foot"][0], r"$-(\nu_i/r)\,\eta_i$", (-0.5, 0.1))
    label(ax, seen["line"][1], r"$l_i(\nu_i)$", (0.05, 0.16))
    label(ax, seen["line"].mean(axis=0), r"$\omega$", (-0.62, -0.72), color=ACCENT)
    label(ax, seen["plane"][3], r"span$\{\eta_i, P_i\}$", (0.3, -0.14))


def describe_single(frame: pd.DataFrame) -> str:
    """Say how far the line is from the centre."""
    foot = points(frame, "sphere", "foot")[0]
    return (
        f"A sphere that one roller touches at P. In the plane of P and the roller's axis, a line"
        f" parallel to P passes the centre at the distance {shown(float(np.linalg.norm(foot)))}"
        f" rad/s. {len(PLACES)} arrows from the centre end on it: all are angular velocities that"
        " this roller allows."
    )


SINGLE = (
    Drawing(
        1,
        "Angular velocities that one roller allows",
        "The line of end points, by Eq. (3). Positions and angular velocities are drawn in one"
        f" picture, r = 1 m. {REDRAWN} {CHOICES}",
        single_data,
        draw_single,
        describe_single,
    ),
)
