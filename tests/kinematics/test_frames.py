"""Transforms against cases by hand and numeric rigid motion that shares no code with them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from in_floats import floats
from sympy import Matrix, Rational, cos, eye, pi, sin, symbols, zeros

from omniproof.kinematics import frames

QUICK = settings(deadline=None, max_examples=15)
NUMBER = st.fractions(min_value=-3, max_value=3, max_denominator=8).map(Rational)
VECTOR = st.tuples(NUMBER, NUMBER, NUMBER)
A, D = symbols("a d", real=True)


def pose(angles: Any, shift: Any) -> Matrix:
    """Any transform: three turns and three moves."""
    found = eye(4)
    for axis, angle, distance in zip("zyx", angles, shift, strict=True):
        found = found * frames.rotation(axis, angle) * frames.translation(axis, distance)
    return found


BY_HAND = [
    pytest.param(
        frames.rotation("x", A),
        [[1, 0, 0, 0], [0, cos(A), -sin(A), 0], [0, sin(A), cos(A), 0], [0, 0, 0, 1]],
        id="about x",
    ),
    pytest.param(
        frames.rotation("y", A),
        [[cos(A), 0, sin(A), 0], [0, 1, 0, 0], [-sin(A), 0, cos(A), 0], [0, 0, 0, 1]],
        id="about y",
    ),
    pytest.param(
        frames.rotation("z", A),
        [[cos(A), -sin(A), 0, 0], [sin(A), cos(A), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
        id="about z",
    ),
    pytest.param(
        frames.translation("y", D),
        [[1, 0, 0, 0], [0, 1, 0, D], [0, 0, 1, 0], [0, 0, 0, 1]],
        id="along y",
    ),
    pytest.param(
        frames.rotation("z", pi / 2) * frames.translation("x", D),
        [[0, -1, 0, 0], [1, 0, 0, D], [0, 0, 1, 0], [0, 0, 0, 1]],
        id="a chain moves along the turned axis",
    ),
]


@pytest.mark.parametrize(("found", "expected"), BY_HAND)
def test_elementary_transforms_by_hand(found: Any, expected: Any) -> None:
    assert found == Matrix(expected)


@pytest.mark.parametrize("make", [frames.rotation, frames.translation])
def test_another_axis_is_refused(make: Any) -> None:
    with pytest.raises(ValueError, match="expected an axis x, y or z, got 'w'"):
        make("w", 1)


def test_text_is_never_parsed_as_an_angle() -> None:
    with pytest.raises(TypeError):
        frames.rotation("x", "pi")  # type: ignore[arg-type]


@QUICK
@given(angles=VECTOR, shift=VECTOR)
def test_inverse_undoes_a_transform(angles: Any, shift: Any) -> None:
    found = pose(angles, shift)
    np.testing.assert_allclose(floats(found * frames.inverse(found)), np.eye(4), atol=1e-12)
    np.testing.assert_allclose(
        floats(frames.inverse(found)), np.linalg.inv(floats(found)), atol=1e-9
    )


MIRROR = Matrix([[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
RIGID = [
    pytest.param(frames.rotation("y", A) * frames.translation("x", D), True, id="a chain"),
    pytest.param(MIRROR, False, id="a mirror image"),
    pytest.param(2 * eye(4), False, id="scaled"),
    pytest.param(
        Matrix([[-cos(A), 0, -sin(A), 0], [0, -1, 0, 0], [sin(A), 0, cos(A), 0], [0, 0, 0, 1]]),
        False,
        id="Yi, Eq. (5-1), as printed",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("transform", "rigid"), RIGID)
def test_rigid_transforms_are_told_from_others(transform: Any, rigid: bool) -> None:
    assert frames.is_rigid(transform) is rigid


@QUICK
@given(turn=VECTOR, point=VECTOR)
def test_skew_is_the_cross_product(turn: Any, point: Any) -> None:
    expected = np.cross([float(x) for x in turn], [float(x) for x in point])
    np.testing.assert_allclose(floats(frames.skew(turn) * Matrix(point)).ravel(), expected)


def test_components_undo_differential_motion() -> None:
    turn, shift = Matrix(symbols("a:3")), Matrix(symbols("b:3"))
    motion = frames.differential_motion(turn, shift)
    assert frames.components(motion) == (turn, shift)
    assert motion[3, :] == zeros(1, 4)


def moved(turn: Any, shift: Any, time: float) -> Any:
    """Transform of a body after `time` at a constant twist, by a power series of the matrix."""
    x, y, z = turn
    rate = np.array([[0, -z, y, shift[0]], [z, 0, -x, shift[1]], [-y, x, 0, shift[2]], [0] * 4])
    power, total = np.eye(4), np.eye(4)
    for k in range(1, 20):
        power = power @ rate * time / k
        total = total + power
    return total


@QUICK
@given(angles=VECTOR, place=VECTOR, turn=VECTOR, shift=VECTOR)
def test_change_of_frame_is_what_a_moving_body_shows(
    angles: Any, place: Any, turn: Any, shift: Any
) -> None:
    """Finite differences: the frame C is carried along, and its motion is seen from where it was.

    In C: T^-1 B(h) T, with B(h) the body's motion; its rate at h = 0 is the motion in C.
    """
    transform = pose(angles, place)
    numeric, step = floats(transform), 1e-4
    twist = [float(x) for x in turn], [float(x) for x in shift]
    there = np.linalg.inv(numeric)
    ahead, behind = (there @ moved(*twist, h) @ numeric for h in (step, -step))
    motion = frames.differential_motion(Matrix(turn), Matrix(shift))
    found = floats(frames.change_frame(motion, transform))
    np.testing.assert_allclose(found, (ahead - behind) / (2 * step), atol=1e-5)


def test_motion_seen_from_a_lever_by_hand() -> None:
    """A turn about z moves the point d on the x-axis along y by d times the rate."""
    motion = frames.differential_motion(Matrix([0, 0, A]), zeros(3, 1))
    turn, shift = frames.components(frames.change_frame(motion, frames.translation("x", D)))
    assert (turn, shift) == (Matrix([0, 0, A]), Matrix([0, A * D, 0]))
    assert math.isclose(float(shift[1].subs({A: 2, D: 3})), 6)
