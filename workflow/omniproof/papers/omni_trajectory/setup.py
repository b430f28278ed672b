"""The printed set-ups of the simulations, once: angles, radii, rates of the wheels, exact.

The body radius is printed twice, and differently (Section 3.1 and Table 1): what depends on it is
computed for both. The printed speed (0.022 m/s) plays no part here: the rates of the wheels give
0.050 m/s, and the paths are theirs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

from sympy import Expr, ImmutableMatrix, Rational, pi

from omniproof.kinematics import trajectory

ANGLES: tuple[Expr, Expr, Expr] = (pi / 6, 5 * pi / 6, 3 * pi / 2)
"""Angles of the rollers (rad), Section 2.2 and Table 2."""

RADII: Mapping[str, Expr] = MappingProxyType(
    {"Table 1": Rational("0.108"), "Section 3.1": Rational("0.086")}
)
"""The body radius L (m) by the place that prints it."""

ROLLER_RADIUS = Rational("0.023")
"""Radius of an omni roller (m), Section 3.1; Table 1 calls it R."""

PASSIVE_ROLLERS = 18
"""Passive rollers on the rim of an omni roller, Section 3.1 and Table 1."""

DURATION = Rational(3)
"""T (s), Section 3.2 (A)."""


@dataclass(frozen=True)
class Case:
    """One line of Table 3 or 4: name, intended direction (degrees), rates of the wheels (rpm)."""

    name: str
    direction_deg: int
    rates_rpm: tuple[str, str, str]

    @property
    def direction(self) -> Expr:
        """The intended direction in rad."""
        return Rational(self.direction_deg, 180) * pi

    @property
    def speeds(self) -> tuple[Expr, ...]:
        """Speeds of the wheels in m/s: r omega, with omega = 2 pi N / 60."""
        return tuple(ROLLER_RADIUS * pi / 30 * Rational(rate) for rate in self.rates_rpm)


CIRCLES = (
    Case("left", 60, ("32.9", "1.84", "32.9")),
    Case("clockwise", 60, ("-12.2", "-43.3", "-12.2")),
)
"""Table 3."""

LINES = (
    Case("0°", 0, ("-10.3", "-10.4", "20.8")),
    Case("30°", 30, ("0", "-17.9", "17.9")),
    Case("60°", 60, ("10.3", "-20.8", "10.4")),
    Case("90°", 90, ("17.9", "-17.9", "0")),
)
"""Table 4."""


@cache
def twist(case: Case, body_radius: Expr) -> ImmutableMatrix:
    """Twist (3x1, m/s and rad/s) that the printed rates of a case give."""
    return trajectory.body_twist(ANGLES, body_radius, case.speeds)


@cache
def path(case: Case, body_radius: Expr, time: Expr) -> ImmutableMatrix:
    """Path (2x1, m) that the printed rates of a case give, at `time` (s)."""
    return trajectory.constant_speed_path(twist(case, body_radius), time)


def lengthwise_and_across(case: Case, body_radius: Expr, time: Expr = DURATION) -> ImmutableMatrix:
    """Place at `time` along the intended direction and to the left of it: 2x1, in m."""
    return ImmutableMatrix(trajectory.rotation(-case.direction) * path(case, body_radius, time))
