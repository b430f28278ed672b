"""One contact: twist, contact, axis and driven direction, and the line of spins without slip."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import ImmutableMatrix, Rational, pi

from omniproof.kinematics import sphere
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.globe import dot, draw_globe, ring
from omniproof.report.sketch import View, arrow, floats, label, line, outlined, shown, tinted
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, stage, styled

AZIMUTH, ELEVATION, TILT = -pi / 5, pi / 7, pi / 7
SPEED = Rational(9, 10)
SHARE = Rational(11, 20)
"""Free choices: where the roller is, how it turns, and which spin of its line is drawn."""

PATCH, ARROW = 0.42, 0.62
HEIGHT = 3.5
SPACE = View((2.25, 1.75), 1.6)
DRIVEN, AXLE, SPUN = TYPE_COLORS["Y"], TYPE_COLORS["X"], ACCENT
PANEL = "contact"


def contact_data() -> pd.DataFrame:
    """A roller on a sphere of radius 1, and the spins that its rim asks for."""
    base = sphere.tangent_base(AZIMUTH, ELEVATION)
    contact = sphere.contact_direction(AZIMUTH, ELEVATION)
    axis = sphere.roller_axis(*base, TILT)
    driven = sphere.driven_direction(contact, axis)
    foot, along = sphere.constraint_line(contact, axis, SPEED, 1)
    spin = foot + SHARE * along
    p, eta, e, a, w = (_vector(v) for v in (contact, axis, driven, foot, spin))
    corners = [p + PATCH * (i * eta + k * e) for i, k in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    return long_form(
        rows(PANEL, "equator", ring(np.zeros(3), np.array([1.0, 0, 0]), np.array([0, 1.0, 0]))),
        rows(PANEL, "tangent plane", corners),
        rows(PANEL, "p", p),
        rows(PANEL, "eta", p + ARROW * eta),
        rows(PANEL, "e", p + ARROW * e),
        rows(PANEL, "foot", a),
        rows(PANEL, "omega", w),
        rows(PANEL, "line", [a - 0.45 * p, a + 1.15 * p]),
    )


def _vector(matrix: ImmutableMatrix) -> Floats:
    return np.asarray(floats(matrix).ravel(), dtype=np.float64)


@styled
def draw_contact(frame: pd.DataFrame) -> Figure:
    """Draw the sphere, the roller's directions at the contact, and its line of spins."""
    figure, ax = stage(HEIGHT)
    placed = {
        name: SPACE.place(points(frame, PANEL, name))
        for name in ("tangent plane", "p", "eta", "e", "foot", "omega", "line")
    }
    center = SPACE.place([0, 0, 0])[0]
    draw_globe(ax, SPACE, points(frame, PANEL, "equator"))
    tinted(ax, placed["tangent plane"], INK, alpha=0.12, zorder=3)
    outlined(ax, placed["tangent plane"], INK, lw=0.8)
    _directions(ax, placed, center)
    line(ax, placed["line"], color=SPUN, lw=1.4, ls="--")
    arrow(ax, center, placed["omega"][0], color=SPUN, lw=2.2)
    dot(ax, np.vstack([placed["foot"], placed["p"], center[None]]))
    _names(ax, placed, center)
    return figure


def _directions(ax: Axes, placed: dict[str, Floats], center: Floats) -> None:
    contact = placed["p"][0]
    line(ax, [center, contact], lw=0.9)
    arrow(ax, contact, placed["e"][0], color=DRIVEN, lw=2.2)
    arrow(ax, contact, placed["eta"][0], color=AXLE, lw=2.2)


def _names(ax: Axes, placed: dict[str, Floats], center: Floats) -> None:
    label(ax, placed["e"][0], r"$\mathbf{e}$ driven", (-0.06, 0.14), color=DRIVEN, ha="right")
    label(ax, placed["eta"][0], r"$\boldsymbol{\eta}$ axis", (0.08, 0.06), color=AXLE, ha="left")
    label(ax, placed["p"][0], r"$\mathbf{p}$", (0.02, -0.2))
    label(ax, placed["omega"][0], r"$\boldsymbol{\omega}$", (-0.16, 0.1), color=SPUN)
    label(ax, placed["foot"][0], r"$-\frac{\nu}{r}\,\boldsymbol{\eta}$", (-0.02, -0.28))
    end = placed["line"][-1]
    text = "line $l$: spins\nwithout slip"
    label(ax, end, text, (0.05, -0.3), color=SPUN, size=SMALL_SIZE)
    label(ax, center, "$O$", (-0.14, -0.14))


def describe_contact(frame: pd.DataFrame) -> str:
    """Say what is seen, with the numbers drawn."""
    contact, foot, spin = (points(frame, PANEL, name)[0] for name in ("p", "foot", "omega"))
    parallel = float(np.linalg.norm(np.cross(spin - foot, contact)))
    return (
        "A sphere with one roller: at the contact p a tangent plane with two arrows, the roller's "
        "axis and, across it, the driven direction. A dashed line parallel to the radius of the "
        "contact passes through the end of minus nu over r times the axis; an arrow from the "
        f"centre, the spin, of length {shown(float(np.linalg.norm(spin)))}, ends on it "
        f"({shown(parallel)} off)."
    )


CONTACT = Drawing(
    "contact",
    "One contact",
    "Contact, axis and driven direction of a roller, and the line on which a spin has to end so "
    "that neither direction slips. An omni wheel asks for one plane of spins instead, the one "
    "through the line that is perpendicular to the axis. Place and speed are free choices. The "
    "papers have no such figure.",
    contact_data,
    draw_contact,
    describe_contact,
)
