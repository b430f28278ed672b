"""Section 2: one small motion in two frames."""

from __future__ import annotations

from collections.abc import Iterable

from sympy import Expr, ImmutableMatrix, Integer, Symbol, eye

from omniproof.kinematics import frames
from omniproof.papers.ballbot.derivations.quantities import (
    AXES,
    REGISTRY,
    any_pose,
    free_meanings,
    in_c,
)
from omniproof.papers.ballbot.symbols import ROTATION, ROTATION_B, TRANSLATION, TRANSLATION_B

Vanishing = tuple[Expr, ...]


def vanishing(entries: Iterable[Expr]) -> Vanishing:
    """Expressions that are all to be zero."""
    return (Integer(0), *entries)


def rate_of_moving_frame() -> ImmutableMatrix:
    """Derivative of a frame that turns and moves at constant rates, when it coincides with B."""
    time = Symbol("t", real=True)
    pose = eye(4)
    for axis, turn, shift in zip(AXES, ROTATION, TRANSLATION, strict=True):
        pose = pose * frames.translation(axis, shift * time) * frames.rotation(axis, turn * time)
    return ImmutableMatrix(pose.diff(time).subs(time, 0))


@REGISTRY.derives("eq:1")
def motion_in_c() -> ImmutableMatrix:
    """Motion of one body, seen from its frame C: velocity of C's origin, along C's axes."""
    return frames.differential_motion(*in_c())


@REGISTRY.derives("sec:2/small-time")
def rates() -> Vanishing:
    """Derivative of a moving frame, less the matrix of its rates."""
    motion = frames.differential_motion(ROTATION, TRANSLATION)
    return vanishing(rate_of_moving_frame() - motion)


@REGISTRY.derives("eq:2")
def differential_motion() -> ImmutableMatrix:
    """Derivative of a moving frame."""
    return rate_of_moving_frame()


@REGISTRY.derives("sec:2/rotational")
def rotational_part() -> ImmutableMatrix:
    """Rotation that the derivative of a moving frame holds."""
    return frames.components(rate_of_moving_frame())[0]


@REGISTRY.derives("sec:2/translational")
def translational_part() -> ImmutableMatrix:
    """Translation that the derivative of a moving frame holds."""
    return frames.components(rate_of_moving_frame())[1]


@REGISTRY.derives("eq:3")
def columns_of_pose() -> Vanishing:
    """Images of the unit vectors and of the origin under a pose, less its columns."""
    pose = any_pose()
    place = pose * ImmutableMatrix([0, 0, 0, 1])
    axes = [pose * ImmutableMatrix([*frames.UNIT[axis], 0]) for axis in AXES]
    columns = [frames.axes(pose)[:, k] for k in range(3)]
    ends = [
        ImmutableMatrix([*column, last])
        for column, last in (*((c, 0) for c in columns), (frames.origin(pose), 1))
    ]
    differences = (a - b for a, b in zip([*axes, place], ends, strict=True))
    return vanishing(entry for column in differences for entry in column)


@REGISTRY.derives("sec:2/components-follow")
def components_of_transformed_motion() -> Vanishing:
    """Components of T^-1 Delta T, less what is seen from the frame C."""
    motion = frames.differential_motion(ROTATION_B, TRANSLATION_B)
    found = frames.components(frames.change_frame(motion, any_pose()))
    parts = zip(found, in_c(), strict=True)
    return vanishing(entry for a, b in parts for entry in a - b)


@REGISTRY.derives("eq:4-1/components", "eq:4-1", meanings=free_meanings)
def rotational_part_in_c() -> ImmutableMatrix:
    """Rotation along the axes of any frame."""
    return ImmutableMatrix(free_meanings()["rotation_C"])


@REGISTRY.derives("eq:4-2/components", "eq:4-2", meanings=free_meanings)
def translational_part_in_c() -> ImmutableMatrix:
    """Velocity of the origin of any frame, along its axes."""
    return ImmutableMatrix(free_meanings()["translation_C"])
