"""Frames in space: homogeneous transforms, and what one small motion is in each frame.

A transform `T` of a frame C in a frame B is a 4x4 matrix whose columns are the axes of C and its
origin, in coordinates of B; it turns coordinates in C into coordinates in B, and chains multiply
from left to right: `rotation("z", a) * translation("x", d)` moves along the turned x-axis. All is
exact SymPy. Lengths in metres, angles in radians, turns counter-clockwise about the axis.

Source: Paul, Robot Manipulators: Mathematics, Programming, and Control (1981), chapters 1 and 4.
"""

from __future__ import annotations

from sympy import ImmutableMatrix, MatrixBase, cos, eye, sin, trigsimp, zeros

from omniproof.kinematics.scalars import Scalar, exact

UNIT = {axis: ImmutableMatrix(eye(3)[:, k]) for k, axis in enumerate("xyz")}
"""Unit vectors (3x1) by the name of the axis."""


def rotation(axis: str, angle: Scalar) -> ImmutableMatrix:
    """Turn by `angle` (rad) about an axis of the frame: 4x4.

    Raises `ValueError` for another axis.
    """
    unit, turn = _unit(axis), exact(angle)
    along, across = unit * unit.T, skew(unit)
    # Rodrigues; written so that a coordinate axis gives bare cosines, sines, zeros and ones.
    block = along + cos(turn) * (eye(3) - along) + sin(turn) * across
    return _homogeneous(block, zeros(3, 1))


def translation(axis: str, distance: Scalar) -> ImmutableMatrix:
    """Move by `distance` (m) along an axis of the frame: 4x4.

    Raises `ValueError` for another axis.
    """
    return _homogeneous(eye(3), exact(distance) * _unit(axis))


def axes(transform: MatrixBase) -> ImmutableMatrix:
    """Rotation block [n o a] of a transform, the axes of its frame as columns: 3x3."""
    return ImmutableMatrix(transform[:3, :3])


def origin(transform: MatrixBase) -> ImmutableMatrix:
    """Origin p of a transform's frame: 3x1, in m."""
    return ImmutableMatrix(transform[:3, 3])


def inverse(transform: MatrixBase) -> ImmutableMatrix:
    """Inverse of a rigid transform, by transposing its rotation block: 4x4."""
    turned = axes(transform).T
    return _homogeneous(turned, -turned * origin(transform))


def is_rigid(transform: MatrixBase) -> bool:
    """Whether the axes are orthonormal and right-handed, and the last row is (0, 0, 0, 1)."""
    block = axes(transform)
    gram = (block.T * block).applyfunc(trigsimp)
    right_handed = trigsimp(block.det(method="berkowitz")) == 1
    last_row = transform[3, :] == ImmutableMatrix([[0, 0, 0, 1]])
    return bool(gram == eye(3) and right_handed and last_row)


def skew(vector: MatrixBase) -> ImmutableMatrix:
    """Matrix of the cross product by a 3x1 `vector`: 3x3."""
    x, y, z = vector
    return ImmutableMatrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def differential_motion(turn: MatrixBase, shift: MatrixBase) -> ImmutableMatrix:
    """Matrix of a small motion in a frame, or of its rate: 4x4.

    `turn` (3x1, rad or rad/s) about the frame's axes, `shift` (3x1, m or m/s) of the body's point
    at the frame's origin. Source: Paul (1981), 4.2.
    """
    return ImmutableMatrix(ImmutableMatrix.hstack(skew(turn), shift).col_join(zeros(1, 4)))


def change_frame(motion: MatrixBase, transform: MatrixBase) -> ImmutableMatrix:
    """Matrix of a `motion` (4x4, in B) in the frame C that has the `transform` T in B: 4x4.

    The motion of one rigid body, T^-1 motion T: both frames have to be fixed to the same body.
    Source: Paul (1981), 4.3.
    """
    return ImmutableMatrix(inverse(transform) * motion * transform)


def components(motion: MatrixBase) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Turn and shift (3x1 each) of the matrix of a small motion; undoes `differential_motion`."""
    turn = ImmutableMatrix([motion[2, 1], motion[0, 2], motion[1, 0]])
    return turn, ImmutableMatrix(motion[:3, 3])


def _unit(axis: str) -> ImmutableMatrix:
    if axis not in UNIT:
        raise ValueError(f"expected an axis x, y or z, got {axis!r}")
    return UNIT[axis]


def _homogeneous(block: MatrixBase, position: MatrixBase) -> ImmutableMatrix:
    last_row = ImmutableMatrix([[0, 0, 0, 1]])
    return ImmutableMatrix(ImmutableMatrix.hstack(block, position).col_join(last_row))
