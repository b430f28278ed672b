"""The five papers side by side: the same three things at each contact."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import ImmutableMatrix, MatrixBase, pi

from omniproof.kinematics import ballbot, omni, sphere
from omniproof.kinematics.frames import axes, origin
from omniproof.papers.one_mechanics.statements import REGULAR
from omniproof.report.figure import Drawing, Row, long_form, points, rows
from omniproof.report.globe import dot, draw_globe, ring
from omniproof.report.sketch import View, arrow, floats, label, line
from omniproof.report.svg import SMALL_SIZE, TYPE_COLORS, stage, styled

Contact = tuple[MatrixBase, MatrixBase, MatrixBase]
"""Place, driven direction and axis, for radius 1."""

DRIVEN, AXLE = TYPE_COLORS["Y"], TYPE_COLORS["X"]
HEIGHT, SCALE, ARROW = 5.9, 0.82, 0.5
FLAT = ImmutableMatrix([[1, 0], [0, 1], [0, 0]])


def _platform() -> Iterator[Contact]:
    for angle in REGULAR:
        place, driven = omni.contact_position(angle, 1), omni.tangential_direction(angle)
        yield FLAT * place, FLAT * driven, FLAT * place


def _ball() -> Iterator[Contact]:
    for azimuth in ballbot.AZIMUTHS:
        frame = ballbot.contact_frame(azimuth, pi / 4, 1)
        yield origin(frame), axes(frame)[:, 1], axes(frame)[:, 0]


def _two() -> Iterator[Contact]:
    """As in its simulation, with the angles 20 and -20 degrees."""
    contacts = [sphere.contact_direction(azimuth * pi / 180, pi / 3) for azimuth in (215, 325)]
    normal = contacts[0].cross(contacts[1])
    normal = normal / normal.norm()
    for contact, tilt in zip(contacts, (pi / 9, -pi / 9), strict=True):
        axis = sphere.roller_axis(normal.cross(contact), normal, tilt)
        yield contact, sphere.driven_direction(contact, axis), axis


def _three() -> Iterator[Contact]:
    """Pattern IV of its simulation."""
    for azimuth in REGULAR:
        contact = sphere.contact_direction(azimuth, pi / 6)
        axis = sphere.roller_axis(*sphere.tangent_base(azimuth, pi / 6), 0)
        yield contact, sphere.driven_direction(contact, axis), axis


PANELS: dict[str, tuple[str, tuple[float, float], Callable[[], Iterator[Contact]]]] = {
    "platform": ("arrangement, trajectory", (1.2, 4.45), _platform),
    "ball": ("ballbot", (3.6, 4.45), _ball),
    "two": ("two rollers", (1.2, 1.5), _two),
    "three": ("three rollers", (3.6, 1.5), _three),
}
HELD = ("two", "three")
"""Panels whose rollers hold their axis too."""


def cases_data() -> pd.DataFrame:
    """Contacts, and the ends of both arrows at each."""
    around = ring(np.zeros(3), np.array([1.0, 0, 0]), np.array([0, 1.0, 0]))
    parts = []
    for panel, (_, _, contacts) in PANELS.items():
        parts.append(rows(panel, "equator", around))
        for k, found in enumerate(contacts(), start=1):
            parts.append(_arrows(panel, k, found))
    return long_form(*parts)


def _arrows(panel: str, number: int, contact: Contact) -> Iterator[Row]:
    place, driven, axis = (floats(vector).ravel() for vector in contact)
    yield from rows(panel, f"driven {number}", [place, place + ARROW * driven])
    yield from rows(panel, f"axis {number}", [place - ARROW / 2 * axis, place + ARROW / 2 * axis])


@styled
def draw_cases(frame: pd.DataFrame) -> Figure:
    """Draw the four set-ups."""
    figure, ax = stage(HEIGHT)
    for panel, (title, place, _) in PANELS.items():
        view = View(place, SCALE)
        _draw_body(ax, frame, panel, view)
        for k in range(1, 2 if panel == "two" else 3):
            _draw_contact(ax, frame, (panel, k), view)
        _draw_contact(ax, frame, (panel, 2 if panel == "two" else 3), view)
        label(ax, place, title, (0, 1.12), size=SMALL_SIZE)
        held = "axis held" if panel in HELD else "axis free"
        label(ax, place, held, (0, -1.15), size=SMALL_SIZE, color=AXLE)
    return figure


def _draw_body(ax: Axes, frame: pd.DataFrame, panel: str, view: View) -> None:
    equator = points(frame, panel, "equator")
    if panel == "platform":
        line(ax, view.place(equator), lw=1.2)
    else:
        draw_globe(ax, view, equator)


def _draw_contact(ax: Axes, frame: pd.DataFrame, which: tuple[str, int], view: View) -> None:
    panel, number = which
    axis = view.place(points(frame, panel, f"axis {number}"))
    driven = view.place(points(frame, panel, f"driven {number}"))
    line(ax, axis, color=AXLE, lw=2.2, ls="-" if panel in HELD else ":")
    arrow(ax, *driven, color=DRIVEN, lw=1.8)
    dot(ax, driven[:1])


def describe_cases(frame: pd.DataFrame) -> str:
    """Count the contacts of each panel."""
    counts = {
        panel: frame[(frame["panel"] == panel)]["series"].str.startswith("driven").sum() // 2
        for panel in PANELS
    }
    return (
        f"Four small scenes: a circle with {counts['platform']} contacts on its rim, and spheres "
        f"with {counts['ball']} contacts on the lower half, {counts['two']} on the upper half and "
        f"{counts['three']} above the equator. At every contact an arrow along the driven "
        "direction and, across it, the axis: dotted for the platform and the ballbot, where it is "
        "free to slide, drawn through for the rollers, which hold it."
    )


CASES = Drawing(
    "cases",
    "Five papers, one constraint",
    "At each contact the driven direction (arrow) and the axis. Wheels of the platforms and of the "
    "ballbot slide along their axes, so three contacts fix a motion; constraint rollers hold both "
    "directions, so that two are one equation too many. Set-ups of the papers; zenith angle 45° "
    "and roller angles ±20° are free choices. The papers have no such figure.",
    cases_data,
    draw_cases,
    describe_cases,
)
