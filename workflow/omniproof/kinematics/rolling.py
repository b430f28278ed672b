"""The rolling constraint, in space: the one place where mechanics enters.

A wheel, roller or ball that rolls without slip has, along each direction in which it grips, no
velocity at its contact other than the one that its own turning makes up for. `rolling_speed` says
so for one direction; planar platforms, platforms inside a ball and the ball on the ground are three
uses of that one line. Change it and everything that rests on mechanics changes with it.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Expr, ImmutableMatrix, MatrixBase


@dataclass(frozen=True)
class Twist:
    """Motion of a rigid body: `velocity` of its origin (3x1, m/s), `rotation` (3x1, rad/s)."""

    velocity: MatrixBase
    rotation: MatrixBase

    def at(self, position: MatrixBase) -> ImmutableMatrix:
        """Velocity V + W x q of the body's point at `position` q from the origin: 3x1, in m/s."""
        return ImmutableMatrix(self.velocity + self.rotation.cross(position))


REST = Twist(ImmutableMatrix([0, 0, 0]), ImmutableMatrix([0, 0, 0]))
"""The ground."""


def rolling_speed(
    direction: MatrixBase, position: MatrixBase, body: Twist, surface: Twist = REST
) -> Expr:
    """Speed of `body` over `surface` at their contact, along a gripping direction, in m/s.

    `direction` n (3x1, unit) and `position` q (3x1, m) of the contact; both twists refer to the
    same origin. A driven wheel on the body has this rim speed; where nothing turns in between, as
    for a ball on the ground, it is zero. Source: Siegwart, Nourbakhsh, Scaramuzza, Autonomous
    Mobile Robots, 3.2.3, there for a surface at rest.
    """
    return direction.dot(body.at(position) - surface.at(position))
