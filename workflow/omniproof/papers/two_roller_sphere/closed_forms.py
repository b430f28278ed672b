r"""Motion of the symmetric arrangement in closed form, with the angle of the rollers free.

The rollers allow the spins of one plane. It contains the x-axis, and it leans by tau + delta from
the ground, where tau is the lean of the rollers' own plane and tan(delta) = sin(h) tan(alpha_1):
the angle of the rollers turns it further. Everything in the simulation follows from that lean.

Solving for the motion is left to `symmetric`; here the solution is written down, short enough to
be drawn and discussed, and `theorems` proves that it is the same. Lengths in m, angles in rad.
"""

from __future__ import annotations

from sympy import Expr, ImmutableMatrix, atan, cos, sin, tan

from omniproof.papers.two_roller_sphere.arrangement import SPEED
from omniproof.papers.two_roller_sphere.symbols import DIRECTION, RADIUS
from omniproof.papers.two_roller_sphere.symmetric import ANGLE, HALF, TILT

UPRIGHT = cos(ANGLE) * cos(TILT) - sin(ANGLE) * sin(TILT) * sin(HALF)
"""cos(tau + delta) times cos(alpha_1) / cos(delta): zero where the plane of spins is upright."""

LYING = cos(ANGLE) * sin(TILT) + sin(ANGLE) * cos(TILT) * sin(HALF)
"""sin(tau + delta) times the same."""

LEAN = LYING / UPRIGHT
"""Tangent of the lean tau + delta of the plane of spins."""

SINGULAR_ANGLE = atan(cos(TILT) / (sin(TILT) * sin(HALF)))
"""Angle of roller 1 at which the plane of spins is upright: the sphere cannot travel along x."""

AHEAD = cos(HALF) / cos(ANGLE)
"""Rim speed over V for travel along y, both rollers alike."""

ASIDE = sin(HALF) / UPRIGHT
"""Rim speed over V for travel along x: that of roller 1, and minus that of roller 2."""


def spin() -> ImmutableMatrix:
    """Spin of the sphere in the world: 3x1, rad/s."""
    turn = ImmutableMatrix([-sin(DIRECTION), cos(DIRECTION), -LEAN * cos(DIRECTION)])
    return ImmutableMatrix(SPEED / RADIUS * turn)


def tangent_of_axis() -> Expr:
    """Tangent of rho, the angle between the axis of rotation and the ground."""
    return -LEAN * cos(DIRECTION)


def rim_speed(roller: int) -> Expr:
    """Rim speed of roller 1 or 2, m/s."""
    side = 3 - 2 * roller
    return SPEED * (AHEAD * sin(DIRECTION) + side * ASIDE * cos(DIRECTION))


def slip(roller: int) -> Expr:
    """Component of the slip of roller 1 or 2 along its X, m/s."""
    side = 3 - 2 * roller
    return side * SPEED * cos(HALF) * tan(ANGLE) * sin(DIRECTION)
