"""Outlines of what a MuJoCo model consists of, as one sees them: no renderer, no display.

Nothing is drawn by hand here: places, sizes and directions are those of the compiled model after
`mj_forward`. The view is orthographic, so an ellipsoid has the outline of an ellipse and a cylinder
two half circles; both are known in closed form. What is nearer to the viewer is drawn later
(painter's order), which is right for bodies that do not interlock.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TypeAlias

import mujoco
import numpy as np

from omniproof.report.figure import Floats
from omniproof.report.sketch import toward_viewer

Shape: TypeAlias = Callable[[Floats, Floats], Floats]
"""Takes the size of a geom and how it is turned (3x3); returns points about its place."""

FINE, COARSE = 64, 20
"""Corners of large outlines, and of the many small ones of rollers."""


@dataclass(frozen=True)
class Part:
    """One thing to draw: its `name`, the points of its outline or line (M x 3, in m), its depth.

    Depth (m) is that of its middle towards the viewer.
    """

    name: str
    points: Floats
    depth: float


def at_rest(xml: str) -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Return a compiled model and its state before the first step."""
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def solids(model: mujoco.MjModel, data: mujoco.MjData) -> Iterator[Part]:
    """Yield the outline of each ellipsoid, cylinder and sphere, and of a cylinder's near face.

    Passive rollers have no names in the models: they are `passive 1` and so on. Any other solid
    without one is a `body`.
    """
    rollers = 0
    for index in range(model.ngeom):
        shapes = _SHAPES.get(mujoco.mjtGeom(model.geom_type[index]))
        if shapes is None:
            continue
        name = model.geom(index).name
        if not name:
            passive = model.geom_type[index] == mujoco.mjtGeom.mjGEOM_ELLIPSOID
            rollers += passive
            name = f"passive {rollers}" if passive else "body"
        place, turn = data.geom_xpos[index], data.geom_xmat[index].reshape(3, 3)
        for suffix, shape in shapes.items():
            outline = place + shape(model.geom_size[index], turn)
            yield Part(f"{name}{suffix}", outline, float(place @ toward_viewer()))


def rims(model: mujoco.MjModel, data: mujoco.MjData) -> Iterator[Part]:
    """Yield of each wheel the closed line through the hinges of its rollers, and its axle."""
    for joint in map(model.joint, range(model.njnt)):
        if joint.name.startswith("wheel"):
            (wheel,) = joint.bodyid
            hinges = data.xpos[model.body_parentid == wheel]
            depth = float(data.xpos[wheel] @ toward_viewer())
            yield Part(f"rim of {joint.name}", np.vstack([hinges, hinges[:1]]), depth)
            reach = 0.35 * np.linalg.norm(hinges[0] - data.xpos[wheel]) * data.xaxis[joint.id]
            axle = data.xanchor[joint.id] + np.outer([-1, 1], reach)
            yield Part(f"axle of {joint.name}", axle, depth)


def platform(model: mujoco.MjModel, data: mujoco.MjData) -> Part:
    """Return the polygon through the hubs of all wheels, for a platform that has no shape."""
    joints = map(model.joint, range(model.njnt))
    hubs = np.array([data.xanchor[one.id] for one in joints if one.name.startswith("wheel")])
    return Part("platform", hubs, float(hubs.mean(axis=0) @ toward_viewer()))


# Shapes ------------------------------------------------------------------------------------------


def _ellipsoid(size: Floats, turn: Floats, corners: int = COARSE) -> Floats:
    """Outline about the origin: where the normal, turn (u / size), is across the view."""
    unit = _ring(*_across(turn.T @ toward_viewer() / size), corners)
    return np.asarray((unit * size) @ turn.T)


def _sphere(size: Floats, turn: Floats) -> Floats:
    return _ellipsoid(np.full(3, size[0]), turn, FINE)


def _cylinder(size: Floats, turn: Floats) -> Floats:
    """Outline about the origin: the outer half of either rim."""
    radius, half_length, _ = size
    axis = turn[:, 2]
    side = np.cross(axis, toward_viewer())
    side /= np.linalg.norm(side)
    # On the picture the other direction of the rim points where the axis does.
    out = np.cross(axis, side)
    out *= -np.sign((out @ toward_viewer()) * (axis @ toward_viewer()))
    half = np.linspace(0, np.pi, FINE // 2)
    arc = radius * (np.outer(np.cos(half), side) + np.outer(np.sin(half), out))
    return np.vstack([arc + half_length * axis, -arc - half_length * axis])


def _near_face(size: Floats, turn: Floats) -> Floats:
    """Rim of a cylinder's face that one sees, about the origin."""
    radius, half_length, _ = size
    axis = turn[:, 2] * np.sign(turn[:, 2] @ toward_viewer())
    return np.asarray(radius * _ring(turn[:, 0], turn[:, 1], FINE) + half_length * axis)


def _ring(first: Floats, second: Floats, corners: int) -> Floats:
    """Circle of radius 1 about the origin in the plane of two unit vectors: corners x 3."""
    angle = np.linspace(0, 2 * np.pi, corners, endpoint=False)
    return np.asarray(np.outer(np.cos(angle), first) + np.outer(np.sin(angle), second))


def _across(direction: Floats) -> tuple[Floats, Floats]:
    """Return two unit vectors across a direction and each other."""
    least = np.eye(3)[np.argmin(np.abs(direction))]
    first = np.cross(direction, least)
    first /= np.linalg.norm(first)
    second = np.cross(direction, first)
    return first, second / np.linalg.norm(second)


_SHAPES: Mapping[mujoco.mjtGeom, Mapping[str, Shape]] = {
    mujoco.mjtGeom.mjGEOM_ELLIPSOID: {"": _ellipsoid},
    mujoco.mjtGeom.mjGEOM_SPHERE: {"": _sphere},
    mujoco.mjtGeom.mjGEOM_CYLINDER: {"": _cylinder, ", face": _near_face},
}
"""Shapes of what is drawn; floors are drawn for themselves, and boxes line the ball."""
