"""Figures 4 and 5: the point nearest to both lines, and its shadow in the plane of the contacts."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import Integer, MatrixBase, Rational, rad

from omniproof.papers.two_roller_sphere.arrangement import Roller, spin_of
from omniproof.papers.two_roller_sphere.figures.lines import (
    CHOICES,
    COLORS,
    ROLLERS,
    distance,
    draw_pair,
    pair_rows,
)
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.globe import dot, ring
from omniproof.report.sketch import REDRAWN, View, arrow, floats, label, line, shown, tinted
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, stage, styled

PANEL = "skew"
BESIDE = (-0.95, 0.12, 0.02)
"""Some point Q of the drawing, from Q_o along P_1, P_2 and their normal (rad/s): a free choice."""

KEY = {"-": "$d_1+d_2=k_0$", "--": "$d_1^2+d_2^2=k_0^2/2$"}
ANY = TYPE_COLORS["Z"]
QUARTER = np.linspace(0, np.pi / 2, 25)
REACH = 1.6
"""Greatest distance in panel (b), in units of the least sum of distances."""


def minimum_data() -> pd.DataFrame:
    """Figure 2(b) with a point Q and its feet on the lines, and the plane of both distances."""
    pair = long_form(*pair_rows(PANEL))
    first, second = (points(pair, PANEL, f"P {k}")[0] for k in ROLLERS)
    normal = np.cross(first, second) / np.linalg.norm(np.cross(first, second))
    place = points(pair, PANEL, "omega")[0] + BESIDE @ np.array([first, second, normal])
    feet = [_foot(pair, k, place) for k in ROLLERS]
    distances = [float(np.linalg.norm(place - foot)) for foot in feet]
    least = distance(pair, PANEL)
    arc = least / np.sqrt(2) * np.column_stack([np.cos(QUARTER), np.sin(QUARTER)])
    far = REACH * least
    region = [(0, least), (least, 0), (far, 0), (far, far), (0, far)]
    return pd.concat(
        [
            pair,
            long_form(
                rows(PANEL, "Q", place),
                *(rows(PANEL, f"foot {k}", foot) for k, foot in zip(ROLLERS, feet, strict=True)),
                rows("distances", "tangent", [(0, least), (least, 0)]),
                rows("distances", "circle", arc),
                rows("distances", "region", region),
                rows("distances", "least", (least / 2, least / 2)),
                rows("distances", "Q", distances),
            ),
        ],
        ignore_index=True,
    )


def _foot(pair: pd.DataFrame, k: int, place: Floats) -> Floats:
    """Foot of the perpendicular from Q to a line."""
    start, end = points(pair, PANEL, f"line {k}")
    along = (end - start) / np.linalg.norm(end - start)
    return np.asarray(start + ((place - start) @ along) * along)


@styled
def draw_minimum(frame: pd.DataFrame) -> Figure:
    """Draw (a) both lines and two points, (b) the distances of points from the lines."""
    figure, ax = stage(5.9)
    label(ax, [0.1, 5.72], "(a) distances to both lines", ha="left")
    view = View((2.3, 4.95), 1.15)
    draw_pair(ax, frame, PANEL, view)
    place = view.place(points(frame, PANEL, "Q"))[0]
    for k in ROLLERS:
        foot = view.place(points(frame, PANEL, f"foot {k}"))[0]
        line(ax, [place, foot], color=ANY, lw=1.4, ls="--")
        dot(ax, foot[None])
        label(ax, foot, f"$Q_{k}$", (0.2, 0.12 if k == 1 else -0.06))
        label(ax, (place + foot) / 2, f"$d_{k}$", (0.14, 0.06 if k == 1 else -0.1), color=ANY)
    line(ax, [place], marker="o", ms=6, color=ANY, zorder=5)
    label(ax, place, "$Q$", (0.18, 0.0), color=ANY)
    label(ax, [0.1, 2.8], "(b) the plane of both distances", ha="left")
    _plane(ax, frame, np.array([0.8, 0.4]), 1.4)
    return figure


def _plane(ax: Axes, frame: pd.DataFrame, corner: Floats, scale: float) -> None:
    """Draw the distances that are possible, and those of Q_o and Q."""
    seen = {
        name: corner + scale * points(frame, "distances", name)
        for name in ("tangent", "circle", "region", "least", "Q")
    }
    tinted(ax, seen["region"], INK, alpha=0.1, zorder=0)
    for end, name, shift in (
        ([seen["region"][2][0], corner[1]], "$d_1$", (0.15, 0.0)),
        ([corner[0], seen["region"][4][1]], "$d_2$", (-0.05, 0.13)),
    ):
        arrow(ax, corner, end, lw=1.0)
        label(ax, end, name, shift)
    line(ax, seen["tangent"], lw=1.8)
    line(ax, seen["circle"], color=ACCENT, lw=1.8, ls="--")
    for place, color, name, shift in (
        (seen["least"][0], ACCENT, "$Q_o$", (0.17, 0.12)),
        (seen["Q"][0], ANY, "$Q$", (0.17, 0.0)),
    ):
        line(ax, [place], marker="o", ms=6, color=color, zorder=5)
        label(ax, place, name, shift, color=color)
    label(ax, seen["tangent"][0], "$k_0$", (-0.17, 0.0))
    label(ax, seen["tangent"][1], "$k_0$", (0.0, -0.17))
    for row, (style, text) in enumerate(KEY.items()):
        y, color = corner[1] + 1.2 - 0.35 * row, ACCENT if row else INK
        line(ax, [[3.0, y], [3.4, y]], lw=1.8, ls=style, color=color)
        label(ax, [3.5, y], text, ha="left", size=SMALL_SIZE)


def describe_minimum(frame: pd.DataFrame) -> str:
    """Say the least sum of distances, and the squares at both points."""
    least = distance(frame, PANEL)
    first, second = points(frame, "distances", "Q")[0]
    return (
        f"Above, two lines at the distance k_0 = {shown(least)} rad/s and a point Q, which is"
        f" {shown(float(first))} from one and {shown(float(second))} from the other. Below, these"
        " two distances as coordinates: points of space fill all beyond the line d_1 + d_2 = k_0,"
        " and a circle about the origin touches this line in its middle: there the sum of the"
        f" squares is {shown(least**2 / 2)}, at Q it is {shown(float(first**2 + second**2))}."
    )


# Figure 5 ----------------------------------------------------------------------------------------

FLAT = (
    Roller(rad(20), rad(30), Rational(-3, 4), Integer(1)),
    Roller(rad(130), rad(-30), Rational(3, 5), Integer(1)),
)
"""Rollers of the drawing, in the frame of their own plane: free choices."""


def shadow_data() -> pd.DataFrame:
    """Contacts, tangents, projected lines and the projected spin, in the plane of the contacts."""
    return long_form(*_shadow_rows())


def _shadow_rows() -> Iterator[Iterator[Row]]:
    spin = _flat(spin_of(FLAT))
    yield rows("plane", "circle", ring(np.zeros(3), *np.eye(3)[:2])[:, :2])
    yield rows("plane", "omega t", spin)
    for k, roller in zip(ROLLERS, FLAT, strict=True):
        contact = _flat(roller.direction)
        ends = [t * contact for t in (-0.85, 0.85)]
        yield rows("plane", f"P {k}", contact)
        yield rows("plane", f"X {k}", [contact, contact + 0.5 * _flat(roller.tangent)])
        yield rows("plane", f"line {k}", spin + np.array(ends))
        foot = _flat(roller.line[0])
        yield rows("plane", f"foot {k}", foot)


def _flat(vector: MatrixBase) -> Floats:
    """The two components of a vector in the plane of the contacts."""
    return floats(vector).ravel()[:2]


@styled
def draw_shadow(frame: pd.DataFrame) -> Figure:
    """Draw the plane of the contacts from its pole e."""
    figure, ax = stage(3.7)
    center, scale = np.array([2.4, 1.5]), 1.25

    def seen(name: str) -> Floats:
        return np.asarray(center + scale * points(frame, "plane", name))

    line(ax, seen("circle"), lw=1.2)
    for k, sides in ((1, (0.18, -0.08)), (2, (-0.2, 0.05))):
        contact = seen(f"P {k}")[0]
        arrow(ax, center, contact, lw=1.0)
        arrow(ax, *seen(f"X {k}"), lw=1.2)
        label(ax, contact, f"$P_{k}$", sides)
        label(ax, seen(f"X {k}")[1], f"$X_{k}$", (0.2, 0.05) if k == 1 else (-0.18, -0.05))
        line(ax, seen(f"line {k}"), color=COLORS[k], lw=2.2, zorder=3)
        label(ax, seen(f"line {k}")[1], rf"$l'_{k}(\nu_{k})$", (0.35, 0.08), color=COLORS[k])
        foot = seen(f"foot {k}")[0]
        line(ax, [center, foot], ls=":", color=COLORS[k], lw=1.4)
    spin = seen("omega t")[0]
    arrow(ax, center, spin, color=ACCENT, lw=2.4, zorder=5)
    label(ax, spin, r"$\omega^t$", (0.28, -0.03), color=ACCENT)
    dot(ax, np.array([center]))
    label(ax, center, "$O$", (-0.03, -0.18))
    return figure


def describe_shadow(frame: pd.DataFrame) -> str:
    """Say where the common point lies, and how far the lines are from the centre."""
    x, y = points(frame, "plane", "omega t")[0]
    feet = [float(np.linalg.norm(points(frame, "plane", f"foot {k}")[0])) for k in ROLLERS]
    return (
        "The plane of both contacts seen along its normal, with the contacts P_1 and P_2 on the"
        " circle of the sphere and their tangents X_1 and X_2. One line parallel to each radius"
        f" passes the centre at {shown(feet[0])} and {shown(feet[1])} rad/s. The arrow to their"
        f" common point ({shown(x)}, {shown(y)}) is the projected angular velocity."
    )


MINIMUM = (
    Drawing(
        4,
        "The least sum of squared distances",
        "(a) The lines of Figure 2(b). (b) No point has a sum of distances below the distance of"
        f" the lines, $k_0$. {REDRAWN} {CHOICES}",
        minimum_data,
        draw_minimum,
        describe_minimum,
    ),
    Drawing(
        5,
        "The projected angular velocity as a common point",
        r"By Eqs. (B.6)–(B.10). Dotted: $-(\nu_i\cos\alpha_i/r)\,X_i$, from which each line is"
        f" drawn. {REDRAWN} {CHOICES}",
        shadow_data,
        draw_shadow,
        describe_shadow,
    ),
)
