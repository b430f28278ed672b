"""Platform on omni wheels inside a rolling ball: wheel speeds against the ball's motion.

Three bodies move: the ground rests, the ball rolls on it, the platform stays level at the ball's
centre and goes along with it. Each contact is one use of `rolling.rolling_speed`: the ball over the
ground gives the ball's rotation, the platform over the *moving* inner surface gives the wheel
speeds. The ball's spin about the vertical and the platform's yaw are two unknowns; the wheels feel
their difference only.

`law_over_surface_at_rest` drops the ball's motion from the second use. That is the law of a
platform on a ball that is held fast, and with it of a planar robot; a ball that rolls has another.

Conventions: SI units and radians; x, y level, z up, in the platform's frame B at the ball's centre.
Zenith angles are counted from the downward vertical, so that 0 is the lowest point of the inner
surface; beyond pi/2 the wheels stand on the upper half. A wheel speed is the speed of the platform
over the surface along the y-axis of the contact frame, which points counter-clockwise as seen from
above. The speed of the surface over the platform has the opposite sign.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

from sympy import Dummy, Expr, ImmutableMatrix, MatrixBase, linsolve, pi

from omniproof.kinematics import rolling
from omniproof.kinematics.frames import UNIT, axes, origin, rotation, translation
from omniproof.kinematics.rolling import REST, Twist
from omniproof.kinematics.scalars import Scalar, exact, tidy

AZIMUTHS = (pi, -pi / 3, pi / 3)
"""Azimuths of three wheels 120 degrees apart, numbered as in Yi, Eqs. (5-1) to (5-3)."""

Motion: TypeAlias = tuple[Expr, Expr, Expr, Expr]
"""Velocity of the centre along x and y (m/s), platform's yaw rate and ball's spin (rad/s)."""


def contact_frame(azimuth: Scalar, zenith_angle: Scalar, running_radius: Scalar) -> ImmutableMatrix:
    """Transform of the frame C at a wheel's contact, in the platform's frame B: 4x4.

    The z-axis points from the contact at `running_radius` (m) to the centre, the y-axis along the
    driven direction, which is level. Source: Yi, Eqs. (5-1) to (5-3), first lines.
    """
    turned = rotation("z", azimuth) * rotation("y", -exact(zenith_angle))
    return ImmutableMatrix(turned * translation("z", -exact(running_radius)))


def ball_twist(v_x: Scalar, v_y: Scalar, spin: Scalar, ball_radius: Scalar) -> Twist:
    """Motion of a ball that rolls on level ground without slip, about its centre.

    `v_x`, `v_y` (m/s) of the centre, `spin` (rad/s) about the vertical, `ball_radius` (m). Without
    slip the lowest point has no speed along x and y, and that fixes the level rotation.
    """
    w_x, w_y = unknown = Dummy("w_x"), Dummy("w_y")
    ball = Twist(ImmutableMatrix([v_x, v_y, 0]), ImmutableMatrix([w_x, w_y, exact(spin)]))
    lowest = -exact(ball_radius) * UNIT["z"]
    slip = [rolling.rolling_speed(UNIT[axis], lowest, ball) for axis in "xy"]
    ((rolled_x, rolled_y),) = linsolve(slip, unknown)
    return Twist(ball.velocity, ImmutableMatrix([rolled_x, rolled_y, exact(spin)]))


def platform_twist(v_x: Scalar, v_y: Scalar, yaw_rate: Scalar) -> Twist:
    """Motion of the level platform about the ball's centre (m/s, rad/s)."""
    return Twist(ImmutableMatrix([v_x, v_y, 0]), exact(yaw_rate) * UNIT["z"])


def wheel_speed(frame: MatrixBase, platform: Twist, surface: Twist) -> Expr:
    """Speed (m/s) of the wheel whose contact has this `frame`: platform over `surface`."""
    return rolling.rolling_speed(axes(frame)[:, 1], origin(frame), platform, surface)


def wheel_law(
    zenith_angle: Scalar,
    running_radius: Scalar,
    ball_radius: Scalar,
    *,
    azimuths: Sequence[Scalar] = AZIMUTHS,
) -> ImmutableMatrix:
    """Law of a rolling ball on (v_x, v_y, platform's yaw rate, ball's spin): N x 4, exact.

    `zenith_angle` (rad), `running_radius` L of the inner surface and `ball_radius` rho (m),
    `azimuths` of the N contacts (rad). With tangents e_k at the azimuths the rows are
    (L/rho cos(phi) e_k, L sin(phi), -L sin(phi)). Raises `ValueError` without wheels.
    """

    def motions(motion: Motion) -> tuple[Twist, Twist]:
        v_x, v_y, yaw_rate, spin = motion
        return platform_twist(v_x, v_y, yaw_rate), ball_twist(v_x, v_y, spin, ball_radius)

    return _law([contact_frame(a, zenith_angle, running_radius) for a in azimuths], motions)


def relative_law(
    zenith_angle: Scalar,
    running_radius: Scalar,
    ball_radius: Scalar,
    *,
    azimuths: Sequence[Scalar] = AZIMUTHS,
) -> ImmutableMatrix:
    """`wheel_law` on (v_x, v_y, yaw rate of the platform relative to the ball): N x 3, exact.

    What the wheels feel: the spin of the ball's own is left out, since its column is minus that of
    the platform's yaw rate. `omni.twist_matrix` inverts it. Errors as in `wheel_law`.
    """
    law = wheel_law(zenith_angle, running_radius, ball_radius, azimuths=azimuths)
    return ImmutableMatrix(law[:, :3])


def law_over_surface_at_rest(
    zenith_angle: Scalar, running_radius: Scalar, *, azimuths: Sequence[Scalar] = AZIMUTHS
) -> ImmutableMatrix:
    """Law of the same platform over a surface at rest, on (v_x, v_y, yaw rate): N x 3, exact.

    It holds while the wheels do not turn the surface: for a ball held fast, or for the planar robot
    with the body radius L sin(phi). A ball that rolls does turn. Errors as in `wheel_law`.
    """

    def motions(motion: Motion) -> tuple[Twist, Twist]:
        return platform_twist(*motion[:3]), REST

    frames = [contact_frame(azimuth, zenith_angle, running_radius) for azimuth in azimuths]
    return ImmutableMatrix(_law(frames, motions)[:, :3])


def _law(
    frames: Sequence[MatrixBase], motions: Callable[[Motion], tuple[Twist, Twist]]
) -> ImmutableMatrix:
    """Jacobian of the wheel speeds by the motion: one row a contact frame, four columns."""
    if not frames:
        raise ValueError("expected at least 1 wheel, got 0")
    motion = (Dummy("v_x"), Dummy("v_y"), Dummy("yaw_rate"), Dummy("spin"))
    platform, surface = motions(motion)
    speeds = [tidy(wheel_speed(frame, platform, surface)) for frame in frames]
    return ImmutableMatrix(speeds).jacobian(motion)
