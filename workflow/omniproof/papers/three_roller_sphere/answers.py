"""Tables that answer the questions of the chapter: exact radii and slips, and what would fit."""

from __future__ import annotations

import math
from collections.abc import Mapping

from sympy import Expr, pi, sqrt

from omniproof.audit.decimals import read_decimal
from omniproof.audit.preimage import solve_for
from omniproof.decide.answer import Undecided
from omniproof.papers.three_roller_sphere.derivations.simulation import at_pattern, extrema
from omniproof.papers.three_roller_sphere.rollers import (
    AZIMUTHS,
    ELEVATION,
    ELEVATIONS,
    pattern_spin,
)
from omniproof.papers.three_roller_sphere.symbols import PHI, RADIUS

NUMERALS = ("I", "II", "III", "IV")
UPPER_HALF = (pi * 0, pi / 2)
EXTREMA = ("least", "greatest")


def radius() -> Expr:
    """Radius of the circle at any elevation, in units of 1/r."""
    spin = RADIUS * pattern_spin().subs(PHI, 0)
    return sqrt(spin.dot(spin))


def patterns() -> list[list[str]]:
    """Exact values of each pattern: elevation, radius of the circle, least and greatest slip.

    Slips in m/s, the radius in units of 1/r m/s.
    """
    found = (radius(), *extrema())
    return [
        [
            f"{numeral} ({_degrees(elevation):.0f}°)",
            *(f"{float(at_pattern(k, value)):.4f}" for value in found),
        ]
        for k, (numeral, elevation) in enumerate(zip(NUMERALS, ELEVATIONS, strict=True), 1)
    ]


def places() -> list[list[str]]:
    """Parameters (degrees) at which each roller slips least and most, for every elevation."""
    rows = []
    for i, azimuth in enumerate(AZIMUTHS, 1):
        least = round(_degrees(azimuth)) % 180
        rows.append([f"roller {i}", _with_opposite(least), _with_opposite((least + 90) % 180)])
    return rows


def _with_opposite(angle: int) -> str:
    return f"{angle}° and {angle + 180}°"


def elevations_of_printed(
    printed: Mapping[str, Mapping[int, str]],
) -> list[list[str]]:
    """Elevations (degrees) whose exact slip rounds to the printed one, by extremum and pattern.

    `printed` has the decimals of the least and of the greatest slip by k. Each row: pattern,
    extremum, printed, exact, the range of elevations.
    """
    forms = dict(zip(EXTREMA, extrema(), strict=True))
    return [
        [
            f"{NUMERALS[k - 1]} ({_degrees(ELEVATIONS[k - 1]):.0f}°)",
            name,
            decimal,
            f"{float(at_pattern(k, forms[name])):.4f}",
            _range(forms[name], decimal),
        ]
        for name, decimals in printed.items()
        for k, decimal in decimals.items()
    ]


def shift_that_serves_all(printed: Mapping[str, Mapping[int, str]]) -> str:
    """By how much (degrees) smaller elevations would give all printed slips, if one shift does.

    `printed` as for `elevations_of_printed`; each number has to have one range of elevations.
    Raises `ValueError` where it has not, or where no shift serves all numbers.
    """
    forms = dict(zip(EXTREMA, extrema(), strict=True))
    shifts = []
    for name, decimals in printed.items():
        for k, decimal in decimals.items():
            ((low, high),) = _ranges(forms[name], decimal)
            stated = _degrees(ELEVATIONS[k - 1])
            shifts.append((stated - high, stated - low))
    least, most = max(low for low, _ in shifts), min(high for _, high in shifts)
    if least > most:
        raise ValueError("no shift serves all numbers")
    return f"{least:.2f}° to {most:.2f}°"


def _range(value: Expr, decimal: str) -> str:
    ends = _ranges(value, decimal)
    return " or ".join(f"{low:.2f}° … {high:.2f}°" for low, high in ends) or "none"


def _ranges(value: Expr, decimal: str) -> list[tuple[float, float]]:
    """Elevations (degrees) at which a slip rounds to a decimal; `ValueError` if undecided."""
    pieces = solve_for(value, ELEVATION, read_decimal(decimal).interval, UPPER_HALF)
    if isinstance(pieces, Undecided):
        raise ValueError(f"undecided: {pieces.reason}")
    return [(_degrees(low), _degrees(high)) for low, high in pieces]


def _degrees(angle: Expr | str) -> float:
    return math.degrees(float(angle))
