"""The quantities of the paper, and the symbols they are written in.

Frames come from geometry: a wheel's frame stands at its contact, its z-axis points to the centre of
the ball, its y-axis along the level tangent. What moves comes from `rolling.Twist`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from sympy import (
    Expr,
    ImmutableMatrix,
    Rational,
    cos,
    eye,
    pi,
    symbols,
)

from omniproof.kinematics import frames, omni, rolling
from omniproof.papers.ballbot.symbols import (
    PHI,
    ROTATION,
    ROTATION_B,
    RUNNING_RADIUS,
    SYMBOLS,
    TRANSLATION,
    TRANSLATION_B,
    V_X,
    V_Y,
    YAW_RATE,
)
from omniproof.registry import Registry

REGISTRY = Registry("ballbot", symbols=SYMBOLS)
AXES = "xyz"
WHEELS = (1, 2, 3)

LEVEL_MOTION = rolling.Twist(
    ImmutableMatrix([*TRANSLATION_B[:2], 0]), ImmutableMatrix([0, 0, ROTATION_B[2]])
)
"""Differential motion of a platform that stays level at one height."""

MOTION = ImmutableMatrix([V_X, V_Y, YAW_RATE])
"""Motion of the platform (m/s, m/s, rad/s)."""


@cache
def any_pose() -> ImmutableMatrix:
    """Pose of a frame C in B: any orientation, by three angles, and any origin (4x4)."""
    yaw, pitch, roll = symbols("psi theta chi", real=True)
    turned = frames.rotation("z", yaw) * frames.rotation("y", pitch) * frames.rotation("x", roll)
    place = symbols("p_x p_y p_z", real=True)
    moved = eye(4)
    for axis, distance in zip(AXES, place, strict=True):
        moved = moved * frames.translation(axis, distance)
    return ImmutableMatrix(moved * turned)


def free_frame() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Axes (3x3) and origin (3x1) of a frame by their coordinates, for lemmas on any frame."""
    names = [[f"{column}_{axis}" for axis in AXES] for column in "noap"]
    columns = [ImmutableMatrix(symbols(entries, real=True)) for entries in names]
    return ImmutableMatrix.hstack(*columns[:3]), columns[3]


def azimuth(wheel: int) -> Expr:
    """Direction of a wheel from above (rad): wheel 1 on the negative x-axis, 120 degrees apart."""
    return pi + 2 * pi * Rational(wheel - 1, 3)


@cache
def wheel_frame(wheel: int) -> ImmutableMatrix:
    """Frame at the contact of a wheel, in B: 4x4."""
    lever = RUNNING_RADIUS * omni.contact_position(PHI, 1)[1]
    across = omni.contact_position(azimuth(wheel), lever)
    contact = ImmutableMatrix([*across, -RUNNING_RADIUS * cos(PHI)])
    inward = -contact / RUNNING_RADIUS
    driven = ImmutableMatrix([*omni.tangential_direction(azimuth(wheel)), 0])
    columns = [driven.cross(inward), driven, inward, contact]
    last_row = ImmutableMatrix([[0, 0, 0, 1]])
    return ImmutableMatrix(ImmutableMatrix.hstack(*columns).col_join(last_row))


def seen_from(
    motion: rolling.Twist, axes: ImmutableMatrix, origin: ImmutableMatrix
) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Rotation and translation of a moving body, along the axes of a frame that is fixed to it."""
    return axes.T * motion.rotation, axes.T * motion.at(origin)


def at_pose(
    motion: rolling.Twist, pose: ImmutableMatrix
) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """`seen_from` the frame that has a pose (4x4)."""
    return seen_from(motion, frames.axes(pose), frames.origin(pose))


@cache
def in_c() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Any motion of B, seen from a frame C fixed to it."""
    return at_pose(rolling.Twist(TRANSLATION_B, ROTATION_B), any_pose())


@cache
def at_wheel_1() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Motion of a level platform, seen from the frame of wheel 1."""
    return at_pose(LEVEL_MOTION, wheel_frame(1))


def free_meanings() -> Mapping[str, Any]:
    """Columns of a frame as free vectors, with what is seen from that frame."""
    axes, origin = free_frame()
    seen = seen_from(rolling.Twist(TRANSLATION_B, ROTATION_B), axes, origin)
    found: dict[str, Any] = {"p": origin}
    found |= {name: axes[:, k] for k, name in enumerate("noa")}
    for part, letter, vector in zip(("rotation", "translation"), ("delta", "d"), seen, strict=True):
        found[f"{part}_C"] = vector
        found |= {f"{letter}_{axis}_C": vector[k] for k, axis in enumerate(AXES)}
    return found


def _means(name: str, value: Callable[..., Any]) -> None:
    REGISTRY.quantity(name)(value)


_means("delta", lambda: ROTATION)
_means("d", lambda: TRANSLATION)
_means("Delta", lambda: frames.differential_motion(ROTATION, TRANSLATION))
_means("Delta_B", lambda: frames.differential_motion(ROTATION_B, TRANSLATION_B))
_means("Delta_C", lambda: frames.differential_motion(*in_c()))
_means("rotation_B", lambda: ROTATION_B)
_means("translation_B", lambda: TRANSLATION_B)
_means("T", any_pose)
_means("T_inverse", lambda: frames.inverse(any_pose()))
_means("p", lambda: frames.origin(any_pose()))
_means("Rot", lambda: lambda axis, angle: frames.rotation(_name(axis), angle))
_means("Trans", lambda: lambda axis, distance: frames.translation(_name(axis), distance))
for _k, _column in enumerate("noa"):
    _means(_column, lambda k=_k: frames.axes(any_pose())[:, k])
for _axis in ("y", "z"):
    _means(f"axis_{_axis}", lambda axis=_axis: frames.UNIT[axis])
for _place, _seen in (("C", in_c), ("C1", at_wheel_1)):
    for _part, (_vector, _letter) in enumerate((("rotation", "delta"), ("translation", "d"))):
        _means(f"{_vector}_{_place}", lambda seen=_seen, part=_part: seen()[part])
        for _k, _axis in enumerate(AXES):
            _means(
                f"{_letter}_{_axis}_{_place}",
                lambda seen=_seen, part=_part, k=_k: seen()[part][k],
            )
for _wheel in WHEELS:
    _means(f"T_{_wheel}", lambda wheel=_wheel: wheel_frame(wheel))


def _name(unit: ImmutableMatrix) -> str:
    """Name of a coordinate axis by its unit vector; raises `TypeError` for anything else."""
    for axis in AXES:
        if frames.UNIT[axis] == unit:
            return axis
    raise TypeError(f"expected an axis, found {unit}")
