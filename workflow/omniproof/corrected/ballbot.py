"""Corrected formulas of the paper on a ballbot, for NumPy.

A platform with three wheels inside a ball that rolls: angle phi of the wheels in rad, distance L of
their contacts from the centre in m; arrays are broadcast.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from omniproof.corrected.answer import Answer, Answers, Line
from omniproof.corrected.formula import Array, Formula, Functions


def body_from_wheel_1(phi: ArrayLike, L: ArrayLike) -> Array:
    """Return the homogeneous transform of Eq. (5-1), `(..., 4, 4)`."""
    return _TRANSFORM_1(phi=phi, L=L)


def body_from_wheel_2(phi: ArrayLike, L: ArrayLike) -> Array:
    """Return the homogeneous transform of Eq. (5-2), `(..., 4, 4)`."""
    return _TRANSFORM_2(phi=phi, L=L)


def wheel_1_displacement(
    d_x: ArrayLike, d_y: ArrayLike, delta_z: ArrayLike, phi: ArrayLike, L: ArrayLike
) -> Array:
    """Return a small displacement of wheel 1 in its own frame, m, `(..., 3)`: Eq. (6-2).

    d_x, d_y: that of the platform, m; delta_z: its turn about the vertical, rad.
    """
    return _DISPLACEMENT(d_x_B=d_x, d_y_B=d_y, delta_z_B=delta_z, phi=phi, L=L)


def wheel_1_speed(v_y: ArrayLike, omega_z: ArrayLike, phi: ArrayLike, L: ArrayLike) -> Array:
    """Return the speed of wheel 1 over the inner surface of the rolling ball, m/s: Eq. (7).

    v_y: velocity of the platform, m/s; omega_z: its yaw rate, rad/s.
    """
    return _WHEEL_1(v_y=v_y, omega_z=omega_z, phi=phi, L=L)


def wheel_2_speed(
    v_x: ArrayLike, v_y: ArrayLike, omega_z: ArrayLike, phi: ArrayLike, L: ArrayLike
) -> Array:
    """Return the speed of wheel 2, m/s: Eq. (8). Arguments as in `wheel_1_speed`."""
    return _WHEEL_2(v_x=v_x, v_y=v_y, omega_z=omega_z, phi=phi, L=L)


def wheel_3_speed(
    v_x: ArrayLike, v_y: ArrayLike, omega_z: ArrayLike, phi: ArrayLike, L: ArrayLike
) -> Array:
    """Return the speed of wheel 3, m/s: Eq. (9). Arguments as in `wheel_1_speed`."""
    return _WHEEL_3(v_x=v_x, v_y=v_y, omega_z=omega_z, phi=phi, L=L)


def wheel_matrix(phi: ArrayLike, L: ArrayLike) -> Array:
    """Return the matrix from (v_x, v_y, omega_z) to the wheel speeds, `(..., 3, 3)`: Eq. (10)."""
    return _MATRIX(phi=phi, L=L)


def body_matrix(phi: ArrayLike, L: ArrayLike) -> Array:
    """Return the matrix from wheel speeds to (v_x, v_y, omega_z), `(..., 3, 3)`: Eq. (10)."""
    return _INVERSE(phi=phi, L=L)


_PAPER = "ballbot"
_TRANSFORM_1 = Formula(_PAPER, "eq:5-1")
_TRANSFORM_2 = Formula(_PAPER, "eq:5-2")
_DISPLACEMENT = Formula(_PAPER, "eq:6-2")
_WHEEL_1 = Formula(_PAPER, "eq:7")
_WHEEL_2 = Formula(_PAPER, "eq:8")
_WHEEL_3 = Formula(_PAPER, "eq:9")
_MATRIX = Formula(_PAPER, "eq:10")
_INVERSE = Formula(_PAPER, "eq:10/inverse")

FUNCTIONS: Functions = {
    "eq:5-1": body_from_wheel_1,
    "eq:5-2": body_from_wheel_2,
    "eq:6-2": wheel_1_displacement,
    "eq:7": wheel_1_speed,
    "eq:8": wheel_2_speed,
    "eq:9": wheel_3_speed,
    "eq:10": wheel_matrix,
    "eq:10/inverse": body_matrix,
}

_SPEED = (
    "The wheel runs over the inner surface of the ball, which moves along with the platform, more "
    "slowly. The paper takes that surface for at rest."
)
_FRAME = "With the printed sign the columns are not perpendicular: no rigid frame looks like this."
_AT = "phi=0.7, L=0.1"
_TWIST = f"v_x=0.3, v_y=0.1, omega_z=0.5, {_AT}"


def _parts(place: str) -> Line:
    """A vector by its components, and by what they are."""
    return Line(f"<{place}/components> = <{place}>", (place,))


ANSWERS: Answers = {
    "eq:4-1": Answer("turn, seen by another frame", (_parts("eq:4-1"),)),
    "eq:4-2": Answer("displacement, seen by another frame", (_parts("eq:4-2"),)),
    "eq:5-1": Answer(
        "frame of wheel 1",
        (Line("<eq:5-1>", function=body_from_wheel_1, call=f"body_from_wheel_1({_AT})"),),
        _FRAME,
    ),
    "eq:5-2": Answer(
        "frame of wheel 2",
        (Line("<eq:5-2>", function=body_from_wheel_2, call=f"body_from_wheel_2({_AT})"),),
        _FRAME,
    ),
    "eq:5-3": Answer("frame of wheel 3", (Line("<eq:5-3>", name="body_from_wheel_3"),)),
    "eq:6-1": Answer("turn, seen by wheel 1", (_parts("eq:6-1"),)),
    "eq:6-2": Answer(
        "displacement, seen by wheel 1",
        (
            Line(
                "<eq:6-2/components> = <eq:6-2>",
                ("eq:6-2",),
                function=wheel_1_displacement,
                call=f"wheel_1_displacement(d_x=0.01, d_y=0.02, delta_z=0.03, {_AT})",
            ),
        ),
        "It follows from the sign in Eq. (5-1).",
    ),
    "eq:7": Answer(
        "speed of wheel 1",
        (
            Line(
                "<eq:7>",
                function=wheel_1_speed,
                call=f"wheel_1_speed(v_y=0.1, omega_z=0.5, {_AT})",
            ),
        ),
        _SPEED,
    ),
    "eq:8": Answer(
        "speed of wheel 2",
        (Line("<eq:8>", function=wheel_2_speed, call=f"wheel_2_speed({_TWIST})"),),
        _SPEED,
    ),
    "eq:9": Answer(
        "speed of wheel 3",
        (Line("<eq:9>", function=wheel_3_speed, call=f"wheel_3_speed({_TWIST})"),),
        _SPEED,
    ),
    "eq:10": Answer(
        "law of the ballbot",
        (
            Line(
                "<eq:10/wheel-speeds> = <eq:10> <eq:10/twist>",
                ("eq:10",),
                function=wheel_matrix,
                call=f"wheel_matrix({_AT})",
            ),
            Line(
                "<eq:10/solved-twist> = <eq:10/inverse> <eq:10/solved-wheel-speeds>",
                ("eq:10/inverse",),
                function=body_matrix,
                call=f"body_matrix({_AT})",
            ),
        ),
        _SPEED,
    ),
}
