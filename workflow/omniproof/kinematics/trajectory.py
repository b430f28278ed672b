"""Paths of a planar platform: from wheel speeds over the body's twist to the world, in closed form.

The twist comes from the rolling constraint (`omni.twist_matrix`); the frames add one rotation. A
body with the yaw rate w sees its own velocity turn, so the path is the integral of R(phi(t)) V(t),
and it has a closed form where that integral has one. All of them are built from one 2x2 matrix,

    G(k, n, t) = integral of e^(k s) R(n s) over 0 <= s <= t = (k + n J)^-1 (e^(k t) R(n t) - 1),

J a quarter turn: that is complex exponentials written with real matrices, so that every entry stays
a real formula that the exact zero test decides. Constant, exponential and sinusoidal speeds are
sums of G; speeds that grow linearly turn ever faster and lead to Fresnel's integrals. Where no
closed form is known, see `quadrature`.

Conventions: those of `omni`; body and world coincide at time 0. Twists are 3x1, (V_x, V_y, w) in
the body's frame, in m/s and rad/s; paths are 2x1, (X, Y) in the world's frame, in m.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from sympy import (
    Abs,
    Dummy,
    Expr,
    ImmutableMatrix,
    MatrixBase,
    Symbol,
    atan2,
    exp,
    expand,
    eye,
    fresnelc,
    fresnels,
    integrate,
    pi,
    sign,
    sqrt,
)

from omniproof.kinematics import frames
from omniproof.kinematics.omni import twist_matrix, wheel_matrix
from omniproof.kinematics.scalars import Scalar, exact

QUARTER_TURN = ImmutableMatrix([[0, -1], [1, 0]])
"""J: turns a vector counter-clockwise by 90 degrees."""


def body_twist(
    angles: Sequence[Scalar], body_radius: Scalar, speeds: Sequence[Scalar]
) -> ImmutableMatrix:
    """Twist (V_x, V_y, w) of a platform with tangential wheels: 3x1, exact.

    `angles` of the wheels (rad), `body_radius` L (m), `speeds` of the wheels (m/s, positive
    counter-clockwise; expressions in time are fine). Errors as in `omni.twist_matrix`.
    """
    inverse = twist_matrix(wheel_matrix(angles, body_radius))
    return ImmutableMatrix(inverse * ImmutableMatrix(speeds)).applyfunc(expand)


# Frames ------------------------------------------------------------------------------------------


def rotation(angle: Scalar) -> ImmutableMatrix:
    """Rotation of the plane by `angle` (rad, counter-clockwise): 2x2."""
    return frames.rotation("z", angle)[:2, :2]


def world_from_body(heading: Scalar) -> ImmutableMatrix:
    """Matrix from the body's twist to (X', Y', phi') in the world: 3x3, for a `heading` phi (rad).

    Source: Siegwart, Nourbakhsh, Scaramuzza, Autonomous Mobile Robots, Eq. (3.2), inverted.
    """
    return frames.axes(frames.rotation("z", heading))


def world_velocity(twist: MatrixBase, heading: Scalar) -> ImmutableMatrix:
    """(X', Y', phi') of the body's origin in the world: 3x1, in m/s and rad/s."""
    return ImmutableMatrix(world_from_body(heading) * twist)


@cache
def heading(yaw_rate: Scalar, time: Symbol) -> Expr:
    """Heading (rad) at `time`, from 0 at time 0: the integral of `yaw_rate` (rad/s).

    Stays an `Integral` where SymPy finds no antiderivative.
    """
    passing = Dummy("s", nonnegative=True)
    return integrate(exact(yaw_rate).subs(time, passing), (passing, 0, time))


def path_integrands(twist: MatrixBase, time: Symbol) -> ImmutableMatrix:
    """(X', Y') as functions of `time`: 2x1; their integrals from 0 are the path."""
    return ImmutableMatrix(world_velocity(twist, heading(twist[2], time))[:2, :])


# Constant speeds ---------------------------------------------------------------------------------


def constant_speed_path(twist: MatrixBase, time: Scalar) -> ImmutableMatrix:
    """Path of a constant `twist`, a circle or, without rotation, a line: 2x1, in m.

    The line is the circle's limit for w -> 0; a yaw rate that is not known to be zero gives the
    circle. Source: integral of R(w t) V; exact arc of Lynch, Park, Modern Robotics, 13.4.
    """
    return ImmutableMatrix(turning_integral(twist[2], time) * twist[:2, :])


def circle_radius(twist: MatrixBase) -> Expr:
    """Radius |V| / |w| (m) of the path of a constant `twist`; `ValueError` without rotation."""
    return speed(twist) / Abs(_turning(twist))


def circle_centre(twist: MatrixBase) -> ImmutableMatrix:
    """Centre J V / w (2x1, m) of the path of a constant `twist`; `ValueError` without rotation."""
    return ImmutableMatrix(QUARTER_TURN * twist[:2, :] / _turning(twist))


def speed(twist: MatrixBase) -> Expr:
    """Speed |V| (m/s) of the body's origin; the same in both frames."""
    return sqrt(twist[0] ** 2 + twist[1] ** 2)


def direction(twist: MatrixBase) -> ImmutableMatrix:
    """Unit vector (cos psi, sin psi) along the velocity: 2x1; undefined at rest."""
    return ImmutableMatrix(twist[:2, :] / speed(twist))


def direction_angle(twist: MatrixBase) -> Expr:
    """Angle psi (rad, in (-pi, pi]) of the velocity; from V_y / V_x alone its side is lost."""
    return atan2(twist[1], twist[0])


def sense(twist: MatrixBase) -> Expr:
    """Sense of rotation: 1 counter-clockwise, -1 clockwise, 0 for a translation."""
    return sign(twist[2])


# Speeds that change ------------------------------------------------------------------------------


def turning_integral(frequency: Scalar, time: Scalar, growth: Scalar = 0) -> ImmutableMatrix:
    """G of the module's head: integral of e^(k s) R(n s) over [0, time], 2x2, in s.

    `frequency` n (rad/s), `growth` k (1/s); where both are known to vanish, G = time.
    """
    growth, frequency = (expand(exact(number)) for number in (growth, frequency))
    square = growth**2 + frequency**2
    if square == 0:
        return ImmutableMatrix(time * eye(2))
    inverse = (growth * eye(2) - frequency * QUARTER_TURN) / square
    return ImmutableMatrix(inverse * (exp(growth * time) * rotation(frequency * time) - eye(2)))


def common_profile_path(twist: MatrixBase, profile: Expr, time: Symbol) -> ImmutableMatrix:
    """Path of the twist f(t) * `twist`, f a common `profile` of all wheel speeds: 2x1, in m.

    The circle of the constant twist, run through by the clock F(t) = integral of f.
    """
    return constant_speed_path(twist, heading(profile, time))


def exponential_path(
    constant: MatrixBase, decaying: MatrixBase, growth: Scalar, time: Scalar
) -> ImmutableMatrix:
    """Path of the twist `constant` + `decaying` e^(k t): 2x1, in m; `growth` k in 1/s.

    Raises `ValueError` when `decaying` rotates (the sum of the wheel speeds is to be constant).
    """
    _check_translations(decaying)
    turned = turning_integral(constant[2], time, growth) * decaying[:2, :]
    return ImmutableMatrix(constant_speed_path(constant, time) + turned)


def sinusoidal_path(
    constant: MatrixBase, cosine: MatrixBase, sine: MatrixBase, frequency: Scalar, time: Scalar
) -> ImmutableMatrix:
    """Path of the twist `constant` + `cosine` cos(n t) + `sine` sin(n t): 2x1, in m.

    `frequency` n (rad/s); in resonance, n = w or n = -w, the body drifts. Raises `ValueError` when
    `cosine` or `sine` rotates (the sum of the wheel speeds is to be constant).
    """
    _check_translations(cosine, sine)
    faster = turning_integral(constant[2] + frequency, time)
    slower = turning_integral(constant[2] - frequency, time)
    even, odd = (faster + slower) / 2, QUARTER_TURN * (slower - faster) / 2
    oscillating = even * cosine[:2, :] + odd * sine[:2, :]
    return ImmutableMatrix(constant_speed_path(constant, time) + oscillating)


def linear_path(start: MatrixBase, growth: MatrixBase, time: Scalar) -> ImmutableMatrix:
    """Path of the twist `start` + `growth` t, in Fresnel's integrals: 2x1, in m.

    With the clock s = t + w0/w1 the heading is w1 s^2 / 2 - w0^2 / (2 w1). Raises `ValueError` when
    the yaw rate does not grow.
    """
    _turning(growth)
    shift = start[2] / growth[2]
    fixed = ImmutableMatrix(start[:2, :] - shift * growth[:2, :])
    turned_back = rotation(-start[2] * shift / 2)
    ends = (_chirp(fixed, growth, clock) for clock in (time + shift, shift))
    last, first = ends
    return ImmutableMatrix(turned_back * (last - first))


def _chirp(fixed: MatrixBase, growth: MatrixBase, clock: Expr) -> MatrixBase:
    """Antiderivative of R(w1 s^2 / 2) (fixed + growth s) at s = `clock`."""
    rate = growth[2]
    unit = sqrt(Abs(rate) / pi)
    even, odd = fresnelc(clock * unit) / unit, sign(rate) * fresnels(clock * unit) / unit
    swung = (even * eye(2) + odd * QUARTER_TURN) * fixed
    return swung - QUARTER_TURN * rotation(rate * clock**2 / 2) * growth[:2, :] / rate


def _turning(twist: MatrixBase) -> Expr:
    """Yaw rate of a twist; `ValueError` where it is known to be zero."""
    if twist[2] == 0:
        raise ValueError("expected a twist that rotates, got a translation: its path is a line")
    return twist[2]


def _check_translations(*twists: MatrixBase) -> None:
    for twist in twists:
        if twist[2] != 0:
            raise ValueError(f"expected a twist that does not rotate, got the yaw rate {twist[2]}")
