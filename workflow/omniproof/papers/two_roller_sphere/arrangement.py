"""Two rollers on a sphere: the frame of their plane, and the arrangement of the simulation.

Spin and slip do not depend on how the sphere is turned, so that any two rollers are dealt with in
the frame of their own plane: contacts on its equator, e its pole. Only what the paper says about
the direction of travel needs the world, whose xy-plane is the ground. The symmetric arrangement has
mirrored contacts and opposite roller angles; its motion has closed forms, which follow from the
spin of the rollers and from the one of a ball that rolls on the ground.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from sympy import (
    Expr,
    ImmutableMatrix,
    Symbol,
    cancel,
    cos,
    expand,
    fraction,
    sin,
    together,
)

from omniproof.kinematics import ballbot, frames, rolling, sphere
from omniproof.papers.two_roller_sphere.symbols import DIRECTION, RADIUS

SPEED = Symbol("V", positive=True)
"""Speed of the centre of the sphere (m/s)."""

POLE = frames.UNIT["z"]
"""The normal e of the rollers' plane, in the frame of that plane."""


@dataclass(frozen=True)
class Roller:
    """A roller in the frame of the rollers' plane: azimuth and angle (rad), rim speed (m/s)."""

    azimuth: Expr
    angle: Expr
    speed: Expr
    radius: Expr = RADIUS

    @cached_property
    def direction(self) -> ImmutableMatrix:
        """Unit vector to the contact: 3x1."""
        return sphere.contact_direction(self.azimuth, 0)

    @property
    def contact(self) -> ImmutableMatrix:
        """Contact P: 3x1, in m."""
        return ImmutableMatrix(self.radius * self.direction)

    @cached_property
    def tangent(self) -> ImmutableMatrix:
        """Tangent X in the plane of the rollers: 3x1, unit."""
        return sphere.tangent_base(self.azimuth, 0)[0]

    @cached_property
    def axis(self) -> ImmutableMatrix:
        """Axis eta: 3x1, unit."""
        return sphere.roller_axis(*sphere.tangent_base(self.azimuth, 0), self.angle)

    @property
    def driven(self) -> ImmutableMatrix:
        """Driven direction: 3x1, unit."""
        return sphere.driven_direction(self.direction, self.axis)

    @property
    def velocity(self) -> ImmutableMatrix:
        """Velocity of the roller's rim at the contact: 3x1, in m/s."""
        return ImmutableMatrix(self.speed * self.driven)

    @property
    def line(self) -> tuple[ImmutableMatrix, ImmutableMatrix]:
        """Foot (rad/s) and direction of the line of spins without slip: 3x1 each."""
        return sphere.constraint_line(self.direction, self.axis, self.speed, self.radius)

    def surface_velocity(self, spin: ImmutableMatrix) -> ImmutableMatrix:
        """Velocity of the sphere at the contact, for a spin (rad/s): 3x1, in m/s."""
        return ImmutableMatrix(self.radius * sphere.surface_map(self.direction) * spin)

    def slip(self, spin: ImmutableMatrix) -> ImmutableMatrix:
        """Velocity of the sphere over the roller: 3x1, in m/s."""
        return sphere.slip_velocity(spin, self.direction, self.axis, self.speed, self.radius)


def tidied(vector: ImmutableMatrix) -> ImmutableMatrix:
    """Write the entries as short quotients, by Pythagoras and common factors."""
    return ImmutableMatrix(vector.applyfunc(_reduced))


def _reduced(entry: Expr) -> Expr:
    above, below = fraction(together(entry))
    return cancel(_without_powers(above) / _without_powers(below))


def _without_powers(expression: Expr) -> Expr:
    """Write powers of sines by cosines."""
    return expand(
        expand(expression).replace(
            lambda part: part.is_Pow and isinstance(part.base, sin) and part.exp.is_Integer,
            lambda part: (
                part.base ** (part.exp % 2) * (1 - cos(part.base.args[0]) ** 2) ** (part.exp // 2)
            ),
        )
    )


def spin_of(rollers: Sequence[Roller]) -> ImmutableMatrix:
    """Least-squares spin of some rollers: 3x1, in rad/s."""
    solved = sphere.least_squares_spin(
        [roller.direction for roller in rollers],
        [roller.axis for roller in rollers],
        [roller.speed for roller in rollers],
        rollers[0].radius,
    )
    return tidied(solved)


def travelling(spin: Expr) -> rolling.Twist:
    """Motion of the sphere that rolls on the ground along `DIRECTION`, with a spin about z."""
    ahead = SPEED * cos(DIRECTION), SPEED * sin(DIRECTION)
    return ballbot.ball_twist(*ahead, spin, RADIUS)
