"""Figure 4: the robot for the simulation, built from its parameters L, r and n, in four views.

A passive roller is a spindle about its axis, a chord of the rim, with an arc of the rim as its
profile: so the rollers of a wheel together are round, but for the gaps that a single row needs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from omniproof.kinematics.omni import contact_position, tangential_direction
from omniproof.papers.omni_trajectory.setup import ANGLES, PASSIVE_ROLLERS, RADII, ROLLER_RADIUS
from omniproof.report.figure import Drawing, Floats, Row, long_form, points, rows
from omniproof.report.sketch import MUTED, REDRAWN, arrow, floats, label, line, outlined, tinted
from omniproof.report.svg import ACCENT, SMALL_SIZE, TYPE_COLORS, stage, styled

WHEEL_RADIUS = float(ROLLER_RADIUS)
WHEELS = (1, 2, 3)
THICKNESS, FILLED = 0.0026, 0.78
HUB_RADIUS, HUB_HALF = 0.0175, 0.0035
PLATE_RADIUS, PLATE_HEIGHT, PLATE_HALF = 0.09, 0.027, 0.008
"""Free choices: half thickness of a roller (m) and its share of the rim; hub and plate (m)."""

Drum: TypeAlias = tuple[Floats, Floats]
"""A cylinder as its two rims, M x 3 each, closed, point for point beside each other."""

UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Camera:
    """An orthographic view: its axes in space, and where and how large it is on the stage."""

    right: Floats
    up: Floats
    origin: Floats
    scale: float

    def place(self, space: Floats) -> Floats:
        """Points in space (M x 3) on the stage: M x 2, in inches."""
        flat = np.atleast_2d(space) @ np.array([self.right, self.up]).T
        return np.asarray(self.origin + self.scale * flat, dtype=np.float64)

    @property
    def toward(self) -> Floats:
        """Unit vector to the viewer."""
        return np.cross(self.right, self.up)


def camera(
    azimuth_deg: float, elevation_deg: float, origin: Sequence[float], scale: float
) -> Camera:
    """Look at the origin from a direction: azimuth from X_m, elevation above the floor."""
    azimuth, elevation = np.radians([azimuth_deg, elevation_deg])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    forward = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
    up = np.cos(elevation) * UP - np.sin(elevation) * forward
    return Camera(right, up, np.asarray(origin), scale)


# The robot in numbers ----------------------------------------------------------------------------


def design_data() -> pd.DataFrame:
    """Robot in m: axes of the rollers, their profile, rims of hubs and plate, contacts."""
    reach = float(RADII["Table 1"])
    parts = [rows("roller", "profile", _profile())]
    for k, angle in zip(WHEELS, ANGLES, strict=True):
        out = np.append(floats(contact_position(angle, 1)).ravel(), 0.0)
        along = np.append(floats(tangential_direction(angle)).ravel(), 0.0)
        hub = reach * out + WHEEL_RADIUS * UP
        parts.append(rows("robot", f"P {k}", reach * out))
        parts.append(rows("robot", f"hub {k}", hub))
        parts += _rollers(k, hub, along)
        parts += _drum(f"hub {k}", hub, (along, UP), (HUB_RADIUS, HUB_HALF))
    plate = (np.array([1.0, 0, 0]), np.array([0, 1.0, 0]))
    parts += _drum("plate", PLATE_HEIGHT * UP, plate, (PLATE_RADIUS, PLATE_HALF))
    for place, radius in RADII.items():
        parts.append(rows("robot", f"floor, L of {place}", _ring(0 * UP, plate, float(radius))))
    return long_form(*parts)


def _profile() -> Floats:
    """Profile of a roller: distance along its axis from the middle, half thickness (m)."""
    angles = np.linspace(-1, 1, 3) * FILLED * np.pi / PASSIVE_ROLLERS
    axis = WHEEL_RADIUS - THICKNESS
    return WHEEL_RADIUS * np.column_stack([np.sin(angles), np.cos(angles)]) - [0, axis]


def _rollers(k: int, hub: Floats, along: Floats) -> Iterator[Iterator[Row]]:
    """Axes of the rollers of wheel k (start, end); the first one stands on the floor."""
    half = float(_profile()[-1, 0])
    for j in range(PASSIVE_ROLLERS):
        angle = 2 * np.pi * j / PASSIVE_ROLLERS
        out = np.sin(angle) * along - np.cos(angle) * UP
        axis = np.cos(angle) * along + np.sin(angle) * UP
        middle = hub + (WHEEL_RADIUS - THICKNESS) * out
        yield rows(
            "robot", f"wheel {k} roller {j + 1}", [middle - half * axis, middle + half * axis]
        )


def _drum(
    name: str, middle: Floats, plane: tuple[Floats, Floats], size: tuple[float, float]
) -> Iterator[Iterator[Row]]:
    """Both rims of a cylinder of `size` = (radius, half width) whose rims span `plane`."""
    normal = np.cross(*plane)
    for side, word in ((-1, "near"), (1, "far")):
        yield rows(
            "robot", f"{name} {word}", _ring(middle + side * size[1] * normal, plane, size[0])
        )


def _ring(middle: Floats, plane: tuple[Floats, Floats], radius: float) -> Floats:
    around = np.linspace(0, 2 * np.pi, 33)
    turned = np.outer(np.cos(around), plane[0]) + np.outer(np.sin(around), plane[1])
    return np.asarray(middle + radius * turned, dtype=np.float64)


# The drawing -------------------------------------------------------------------------------------


@styled
def draw_design(frame: pd.DataFrame) -> Figure:
    """Draw (a) isometric, (b) front and (c) side view, (d) one wheel."""
    figure, ax = stage(6.3)
    isometric = camera(-45, 35.264, (2.4, 4.6), 15.5)
    for name, dashes in (("Table 1", "-"), ("Section 3.1", "--")):
        ring = isometric.place(points(frame, "robot", f"floor, L of {name}"))
        line(ax, ring, lw=0.8, ls=dashes, alpha=MUTED, zorder=0.5)
    views = {
        "(a) isometric": isometric,
        "(b) front": camera(0, 0, (1.2, 2.6), 8.8),
        "(c) side": camera(-90, 0, (3.6, 2.6), 8.8),
    }
    for view in views.values():
        _robot(ax, frame, view)
    for view in list(views.values())[1:]:
        line(ax, view.place(0.125 * np.outer([-1, 1], view.right)), lw=0.8)
    for name, at in zip((*views, "(d) wheel"), ((0.1, 6.1), (0.1, 3.2), (2.5, 3.2), (0.1, 2.1)),
                        strict=True):  # fmt: skip
        label(ax, at, name, ha="left")
    start, end = isometric.place(np.array([0 * UP, points(frame, "robot", "P 3")[0]]))
    arrow(ax, start, end, color=ACCENT, lw=1.4, zorder=6)
    label(ax, (start + end) / 2, "$L$", (-0.05, -0.16), color=ACCENT)
    _one_wheel(ax, frame, np.array([2.4, 1.05]))
    return figure


def _robot(ax: Axes, frame: pd.DataFrame, view: Camera) -> None:
    """Draw wheels and plate, the wheels in front of the plate after it."""
    for k in WHEELS:
        depth = float(points(frame, "robot", f"P {k}")[0] @ view.toward)
        _wheel(ax, frame, view, k, 3 + depth if depth > 0 else 1 + depth)
    _draw_drum(ax, _drum_of(frame, "plate"), view, TYPE_COLORS["Y"], 2)


def _drum_of(frame: pd.DataFrame, name: str) -> Drum:
    return points(frame, "robot", f"{name} near"), points(frame, "robot", f"{name} far")


def _wheel(ax: Axes, frame: pd.DataFrame, view: Camera, k: int, zorder: float) -> None:
    """Draw a wheel: its rollers as one path, and its hub."""
    profile = points(frame, "roller", "profile")
    shapes = [
        _spindle(points(frame, "robot", f"wheel {k} roller {j}"), profile, view)
        for j in range(1, PASSIVE_ROLLERS + 1)
    ]
    closed = (Path(np.vstack([shape, shape[:1]]), closed=True) for shape in shapes)
    path = Path.make_compound_path(*closed)
    color = TYPE_COLORS["X"]
    ax.add_patch(PathPatch(path, fc=to_rgba(color, 0.4), ec=color, lw=0.8, zorder=zorder))
    _draw_drum(ax, _drum_of(frame, f"hub {k}"), view, color, zorder + 0.01)


def _spindle(ends: Floats, profile: Floats, view: Camera) -> Floats:
    """Outline of a roller on the stage; seen along its axis it is its thickest circle."""
    middle, axis = ends.mean(axis=0), ends[1] - ends[0]
    axis = axis / np.linalg.norm(axis)
    aside = np.cross(axis, view.toward)
    if np.linalg.norm(aside) < 1e-6:
        return view.place(_ring(middle, (view.right, view.up), float(profile[:, 1].max())))[::3]
    aside = aside / np.linalg.norm(aside)
    along, thick = (np.outer(column, way) for column, way in zip(profile.T, (axis, aside),
                                                                 strict=True))  # fmt: skip
    return view.place(np.vstack([middle + along + thick, (middle + along - thick)[::-1]]))


def _draw_drum(ax: Axes, drum: Drum, view: Camera, color: str, zorder: float) -> None:
    """Draw a cylinder: its outline, its visible face, and the hidden rim dotted."""
    visible, hidden = drum if (drum[0] - drum[1])[0] @ view.toward > 0 else drum[::-1]
    outline = view.place(_outline(visible, hidden, view))
    tinted(ax, outline, color, alpha=0.25, zorder=zorder)
    tinted(ax, view.place(visible), color, alpha=0.12, zorder=zorder)
    for shape in (outline, view.place(visible)):
        outlined(ax, shape, color, lw=1.0, zorder=zorder + 0.01)
    line(ax, view.place(hidden), color=color, lw=0.6, ls=":", zorder=zorder)


def _outline(visible: Floats, hidden: Floats, view: Camera) -> Floats:
    """Outline of a cylinder in space: half of either rim, from one silhouette line to the other."""
    axis = (visible - hidden)[0]
    aside = np.cross(axis, view.toward)
    first, last = sorted(int(np.argmax(side * (visible[:-1] @ aside))) for side in (1, -1))
    inner = np.arange(first, last + 1)
    outer = np.append(np.arange(last, len(visible) - 1), np.arange(first + 1))
    shift = axis - (axis @ view.toward) * view.toward
    if np.mean(visible[inner] @ shift) < np.mean(visible[outer] @ shift):
        inner, outer = outer, inner
    return np.vstack([visible[inner], hidden[outer]])


def _one_wheel(ax: Axes, frame: pd.DataFrame, center: Floats) -> None:
    """Draw the third wheel along its axis, with its radius and the number of its rollers."""
    scale, right = 38.0, np.array([1.0, 0, 0])
    hub = points(frame, "robot", "hub 3")[0]
    flat = np.array([hub @ right, hub @ UP])
    view = Camera(right, UP, center - scale * flat, scale)
    _wheel(ax, frame, view, 3, 2)
    reach = scale * float(hub[2])
    tip = center + reach * np.array([np.cos(0.7), np.sin(0.7)])
    arrow(ax, center, tip, color=ACCENT, lw=1.4)
    label(ax, (center + tip) / 2, "$r$", (-0.06, 0.13), color=ACCENT)
    line(ax, center + np.array([[-1.25, -reach], [1.25, -reach]]), lw=0.8)
    label(ax, center, f"$n = {PASSIVE_ROLLERS}$", (0, -0.25), size=SMALL_SIZE)


def describe_design(frame: pd.DataFrame) -> str:
    """Say the measures that are drawn."""
    reach = float(np.linalg.norm(points(frame, "robot", "P 1")[0]))
    rim = float(points(frame, "robot", "hub 1")[0, 2])
    count = frame["series"].str.startswith("wheel 1 roller").sum() // 2
    return (
        "A round robot on three omni wheels at equal distances, from above at a slant, from the"
        f" front and from the side; the wheels touch the floor {reach:.3f} m from the centre."
        f" Below, one wheel of radius {rim:.3f} m with {count} barrel-shaped passive rollers around"
        " its rim. A dashed circle on the floor is the smaller body radius that the text states."
    )


DESIGN: Sequence[Drawing] = (
    Drawing(
        4,
        "Robot for the simulation",
        "Drawn to scale from L = 0.108 m, r = 0.023 m and n = 18; dashed: L = 0.086 m, which the"
        f" text states. {REDRAWN} Body, hubs, and the rollers' thickness and single row are free"
        " choices; front and side are seen along the axes X and Y of the robot.",
        design_data,
        draw_design,
        describe_design,
    ),
)
