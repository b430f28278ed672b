"""Rollers on the sphere by their three angles, and the set-ups of the paper's simulation.

Contacts and axes come from rotations of one roller on the x-axis, and not from the printed base
(4): turn it about the x-axis by its own angle, lift it by the elevation, carry it round by the
azimuth.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property

from sympy import Expr, ImmutableMatrix, Integer, Rational, Symbol, factor, pi, symbols

from omniproof.kinematics import frames, sphere
from omniproof.papers.three_roller_sphere.symbols import PHI, RADIUS


@dataclass(frozen=True)
class Roller:
    """Azimuth and elevation of a contact, angle of the axis there (rad), rim speed (m/s)."""

    azimuth: Expr
    elevation: Expr
    angle: Expr
    speed: Expr

    @cached_property
    def frame(self) -> ImmutableMatrix:
        """Outer normal, level tangent and tangent towards the pole as columns: 3x3."""
        raised = frames.rotation("z", self.azimuth) * frames.rotation("y", -self.elevation)
        return frames.axes(raised)

    @cached_property
    def contact(self) -> ImmutableMatrix:
        """Direction from the centre of the sphere to the contact: 3x1, unit."""
        return ImmutableMatrix(self.frame[:, 0])

    @cached_property
    def axis(self) -> ImmutableMatrix:
        """Axis: the level tangent, turned about the outer normal by the angle: 3x1, unit."""
        turned = frames.axes(frames.rotation("x", self.angle))
        return ImmutableMatrix(self.frame * turned[:, 1])

    def line(self, radius: Expr = RADIUS) -> tuple[ImmutableMatrix, ImmutableMatrix]:
        """Spins without slip on a sphere of this radius: a point and the direction, 3x1 each."""
        return _line(self, radius)

    def slip(self, spin: ImmutableMatrix, radius: Expr = RADIUS) -> ImmutableMatrix:
        """Velocity (3x1, m/s) of the sphere over the roller at a spin (3x1, rad/s)."""
        return sphere.slip_velocity(spin, self.contact, self.axis, self.speed, radius)


@cache
def _line(roller: Roller, radius: Expr) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    return sphere.constraint_line(roller.contact, roller.axis, roller.speed, radius)


def any_roller(name: str) -> Roller:
    """Roller of any placement, orientation and speed; `name` is its index."""
    names = (f"theta_1_{name}", f"theta_2_{name}", f"psi_{name}", f"v_{name}")
    return Roller(*symbols(" ".join(names), real=True))


ROLLERS = tuple(any_roller(name) for name in "123")
"""Three rollers of any placement, orientation and speed."""


@cache
def optimum(rollers: tuple[Roller, ...], radius: Expr = RADIUS) -> ImmutableMatrix:
    """Spin (rad/s) with the least sum of squared slips: 3x1."""
    return sphere.least_squares_spin(
        [roller.contact for roller in rollers],
        [roller.axis for roller in rollers],
        [roller.speed for roller in rollers],
        radius,
    )


# The simulation

ELEVATION = Symbol("beta", real=True)
"""Common elevation of the contacts, of any pattern (rad)."""

AZIMUTHS = tuple(pi / 6 + 2 * pi * Rational(k, 3) for k in range(3))
ELEVATIONS: tuple[Expr, ...] = (Integer(0), pi / 18, pi / 9, pi / 6)
"""Elevations of the contacts in Patterns I to IV (rad)."""

LEVEL = Integer(0)
"""Angle of all axes in the simulation (rad)."""


def input_speed(azimuth: Expr) -> Expr:
    """Rim speed that turns a sphere on the equator about a horizontal axis, without slip.

    The axis has the azimuth phi + 90 degrees, and the surface of the sphere moves at most at 1 m/s.
    """
    roller = Roller(azimuth, Integer(0), LEVEL, Integer(0))
    spin = frames.axes(frames.rotation("z", PHI))[:, 1]
    velocity = sphere.surface_map(roller.contact) * spin
    return sphere.driven_direction(roller.contact, roller.axis).dot(velocity)


@cache
def pattern(elevation: Expr = ELEVATION) -> tuple[Roller, ...]:
    """Three rollers of the simulation at one elevation (rad)."""
    return tuple(Roller(a, elevation, LEVEL, input_speed(a)) for a in AZIMUTHS)


@cache
def _any_pattern_spin() -> ImmutableMatrix:
    return ImmutableMatrix(optimum(pattern()).applyfunc(factor))


def pattern_spin(elevation: Expr = ELEVATION, radius: Expr = RADIUS) -> ImmutableMatrix:
    """Spin (3x1, rad/s) of the pattern at one elevation (rad), short of the pole."""
    return ImmutableMatrix(_any_pattern_spin().subs({ELEVATION: elevation, RADIUS: radius}))


def pattern_slips(
    elevation: Expr = ELEVATION, radius: Expr = RADIUS
) -> tuple[ImmutableMatrix, ...]:
    """Slip velocities (3x1 each, m/s) at the three rollers of a pattern."""
    spin = pattern_spin(elevation, radius)
    return tuple(roller.slip(spin, radius) for roller in pattern(elevation))
