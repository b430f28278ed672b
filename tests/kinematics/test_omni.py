"""The wheel matrix against hand-derived cases and numeric mechanics that share no code with it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from in_floats import floats
from sympy import Expr, Integer, Matrix, Rational, cos, eye, pi, sin, sqrt, symbols

from omniproof.kinematics import omni

QUICK = settings(deadline=None, max_examples=20)
ANGLE = st.fractions(min_value=-4, max_value=4, max_denominator=12).map(Rational)
LENGTH = st.fractions(min_value=Rational(1, 8), max_value=4, max_denominator=8).map(Rational)
L = symbols("L", positive=True)
ROOT3 = sqrt(3)


HAND_DERIVED = [
    pytest.param([0, pi / 2], [[0, 1, L], [-1, 0, L]], id="two wheels on the axes"),
    pytest.param(
        [pi / 6, 5 * pi / 6, 3 * pi / 2],
        [
            [-Rational(1, 2), ROOT3 / 2, L],
            [-Rational(1, 2), -ROOT3 / 2, L],
            [1, 0, L],
        ],
        id="equilateral triangle",
    ),
    pytest.param(
        [0, pi / 2, pi, 3 * pi / 2], [[0, 1, L], [-1, 0, L], [0, -1, L], [1, 0, L]], id="square"
    ),
]


@pytest.mark.parametrize(("angles", "rows"), HAND_DERIVED)
def test_wheel_matrix_by_hand(angles: Any, rows: Any) -> None:
    assert omni.wheel_matrix(angles, L) == Matrix(rows)


def test_symbolic_rows_are_those_of_the_contract() -> None:
    a, b = symbols("alpha_1 alpha_2", real=True)
    expected = Matrix([[-sin(a), cos(a), L], [-sin(b), cos(b), L]])
    assert omni.wheel_matrix([a, b], L) == expected
    assert omni.velocity_matrix([a, b]) == expected.subs(L, 1)


@QUICK
@given(
    angles=st.lists(ANGLE, min_size=2, max_size=4),
    data=st.data(),
    radius=LENGTH,
    twist=st.tuples(ANGLE, ANGLE, ANGLE),
)
def test_rows_are_the_numeric_contact_speed_along_the_direction(
    angles: Any, data: Any, radius: Any, twist: Any
) -> None:
    directions = data.draw(st.lists(ANGLE, min_size=len(angles), max_size=len(angles)))
    speeds = floats(omni.wheel_matrix(angles, radius, directions=directions)) @ [
        float(component) for component in twist
    ]
    v_x, v_y, w = (float(component) for component in twist)
    for angle, direction, speed in zip(angles, directions, speeds, strict=True):
        arm = float(radius) * np.array([math.cos(angle), math.sin(angle), 0])
        contact_velocity = np.array([v_x, v_y, 0]) + np.cross([0, 0, w], arm)
        driven = [math.cos(direction), math.sin(direction), 0]
        assert speed == pytest.approx(float(contact_velocity @ driven), abs=1e-12)


@QUICK
@given(st.lists(st.tuples(ANGLE, ANGLE, ANGLE), min_size=3, max_size=6))
def test_twist_matrix_is_the_least_squares_inverse(rows: Any) -> None:
    """Moore and Penrose: T A = 1, and A T is symmetric; for three wheels that is the inverse."""
    matrix = Matrix(rows)
    assume(matrix.rank() == 3)
    inverse = omni.twist_matrix(matrix)
    assert inverse * matrix == eye(3)
    assert (matrix * inverse).is_symmetric()


@settings(QUICK, max_examples=8)
@given(angles=st.lists(ANGLE, min_size=3, max_size=3, unique=True), radius=LENGTH)
def test_twist_matrix_inverts_three_wheels(angles: Any, radius: Any) -> None:
    matrix = omni.wheel_matrix(angles, radius)
    product = floats(omni.twist_matrix(matrix)) @ floats(matrix)
    np.testing.assert_allclose(product, np.eye(3), atol=1e-9)


def test_twist_matrix_inverts_the_equilateral_triangle_exactly() -> None:
    matrix = omni.wheel_matrix([pi / 6, 5 * pi / 6, 3 * pi / 2], L)
    assert (omni.twist_matrix(matrix) * matrix).expand() == eye(3)
    assert omni.twist_matrix(matrix)[2, :] == Matrix([[1, 1, 1]]) / (3 * L)


X, Y = symbols("x y", real=True)
SINGULAR = [
    pytest.param([0, 0, 1], id="two wheels at one place"),
    pytest.param([X, X, Y], id="two wheels at one symbolic place"),
    pytest.param([0, 2 * pi, 1], id="one place after a full turn"),
]


@pytest.mark.parametrize("angles", SINGULAR)
def test_singular_arrangement_has_no_inverse(angles: Any) -> None:
    assert omni.singular(angles).expand() == 0
    with pytest.raises(ValueError, match="singular"):
        omni.twist_matrix(omni.wheel_matrix(angles, L))


def test_parallel_directions_have_no_inverse() -> None:
    matrix = omni.wheel_matrix([0, 1, 2, 3], L, directions=[Rational(1, 3)] * 4)
    with pytest.raises(ValueError, match="singular"):
        omni.twist_matrix(matrix)


def test_determinant_of_the_equilateral_triangle() -> None:
    """Twice the area of the inscribed triangle: 2 * 3 * (1/2) sin 120 = 3 sqrt(3) / 2."""
    assert omni.singular([pi / 6, 5 * pi / 6, 3 * pi / 2]) == 3 * ROOT3 / 2


REFUSED = [
    pytest.param(lambda: omni.wheel_matrix([0], 1), "at least 2 wheels, got 1", id="one wheel"),
    pytest.param(
        lambda: omni.wheel_matrix([0, 1], 1, directions=[0]),
        "expected 2 directions, one a wheel, got 1",
        id="a direction is missing",
    ),
    pytest.param(
        lambda: omni.twist_matrix(omni.wheel_matrix([0, 1], 1)),
        "expected a matrix N x 3 with N >= 3, got 2 x 3",
        id="two wheels do not determine a twist",
    ),
    pytest.param(lambda: omni.singular([0, 1]), "expected 3 wheels, got 2", id="no determinant"),
]


@pytest.mark.parametrize(("call", "message"), REFUSED)
def test_wrong_input_is_refused(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


def test_text_is_never_parsed_as_an_angle() -> None:
    with pytest.raises(TypeError):
        omni.wheel_matrix(["pi", "0"], 1)


def test_everything_rests_on_the_rolling_constraint(monkeypatch: pytest.MonkeyPatch) -> None:
    """Turn the sign of the rotation: only the third column may turn, and it must."""

    def reversed_yaw(n: Any, q: Any, v: Any, w: Any) -> Expr:
        return n.dot(v) - w * (q[0] * n[1] - q[1] * n[0])

    before = omni.wheel_matrix([0, 1, 2], L)
    monkeypatch.setattr(omni, "rolling_speed", reversed_yaw)
    after = omni.wheel_matrix([0, 1, 2], L)
    assert after[:, :2] == before[:, :2]
    assert list(after[:, 2]) == [-L] * 3
    assert list(omni.velocity_matrix([0, 1, 2])[:, 2]) == [Integer(-1)] * 3
