"""The arrangements of the paper, once: angles of the wheels (rad, exact) and the sweep of Figure 6.

Type (Z) is printed as {210, 270, 300} degrees. Its triangle is then not isosceles, and it does not
give the row of Table 2; {210, 270, 330} does both. Drawings use the corrected type and mark the
printed wheel.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TypeAlias

from sympy import Expr, Rational, pi

Angles: TypeAlias = tuple[Expr, Expr, Expr]


def _degrees(*angles_deg: int) -> Angles:
    first, second, third = (Rational(angle, 180) * pi for angle in angles_deg)
    return first, second, third


PRINTED: Mapping[str, Angles] = MappingProxyType(
    {"X": _degrees(30, 150, 270), "Y": _degrees(0, 180, 270), "Z": _degrees(210, 270, 300)}
)
"""Types (X)-(Z) as Section 4 prints them."""

CORRECTED: Mapping[str, Angles] = MappingProxyType({**PRINTED, "Z": _degrees(210, 270, 330)})
"""Types (X)-(Z) with the misprint of type (Z) mended."""

PARAMETER: Mapping[str, Expr] = MappingProxyType({"X": pi / 6, "Y": pi * 0, "Z": -pi / 6})
"""Each type's theta: the type is `isosceles(theta)`, up to the order of the wheels."""

SWEEP: tuple[Expr, Expr] = (-pi / 2, pi / 2)
"""Open range of theta of Figure 6; at both ends two wheels coincide."""


def isosceles(theta: Expr) -> Angles:
    """Angles of the family of Eq. (12), (theta, 180 degrees - theta, 270 degrees)."""
    return theta, pi - theta, 3 * pi / 2
