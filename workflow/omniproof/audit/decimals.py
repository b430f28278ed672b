"""Printed decimals against exact values.

A decimal with k digits after the point stands for the numbers that round to it. Whether the exact
value is one of them is decided by signs of (value - bound), certain at rising precision, and exact
ties by the zero test: no tolerance, so 0.125 printed as 0.13 is a tie and never an accident.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction

import sympy as sp

from omniproof.audit.evidence import Interval
from omniproof.audit.preimage import solve_for
from omniproof.decide.answer import Undecided
from omniproof.decide.balls import format_ball
from omniproof.decide.in_sympy.balls import evaluate
from omniproof.decide.in_sympy.exact import sign, subtract
from omniproof.formula.errors import UnsupportedError

__all__ = ["Decimal", "DecimalFinding", "Rounding", "classify", "read_decimal", "solve_for"]

ENGINE = ("flint",)
MOST_PLACES = 60
DECIMAL = re.compile(r"([+-]?)([0-9]+)(?:\.([0-9]*))?")


class Rounding(StrEnum):
    """How a printed decimal comes from the exact value."""

    EXACT = "exact"
    ROUNDED = "rounded"  # the nearest decimal of this length
    TIE = "tie"  # exactly half-way: two decimals are nearest, and this is one
    TRUNCATED = "truncated"  # digits cut off, not rounded
    OFF_BY_ONE = "off by one"  # neighbour of the nearest decimal in the last place
    WRONG = "wrong"

    @property
    def is_right(self) -> bool:
        """Whether a careful author may print this decimal."""
        return self in {Rounding.EXACT, Rounding.ROUNDED, Rounding.TIE}


@dataclass(frozen=True)
class Decimal:
    """A printed decimal: its value, and the unit of its last place."""

    value: Fraction
    unit: Fraction

    @property
    def interval(self) -> tuple[Fraction, Fraction]:
        """Return the closed interval of the numbers that round to it."""
        return self.value - self.unit / 2, self.value + self.unit / 2


@dataclass(frozen=True)
class DecimalFinding:
    """A printed decimal beside the exact value.

    `digits` shows the exact value to six significant digits; `relative_error` is
    (printed - exact) / |exact| to two digits, empty when the exact value is zero; `correction` is
    the decimal of the same length that should stand there (of two in a tie, the one further from
    zero). `engines` are those that came to this class.
    """

    rounding: Rounding
    interval: tuple[Fraction, Fraction]
    digits: str
    relative_error: str
    correction: str
    engines: tuple[str, ...] = ENGINE

    @property
    def record(self) -> Interval:
        """Return where the exact value lies, and the interval that the decimal stands for."""
        lower, upper = map(format_fraction, self.interval)
        return Interval(value=self.digits, lower=lower, upper=upper)


def read_decimal(text: str) -> Decimal:
    """Read a decimal such as `-4.00`; raises `ValueError` for anything else."""
    match = DECIMAL.fullmatch(text.strip().replace("\N{MINUS SIGN}", "-"))
    if not match:
        raise ValueError(f"expected a decimal such as 4.00, found {text!r}")
    minus, whole, places = match.groups(default="")
    unit = Fraction(1, 10 ** len(places))
    return Decimal(int(minus + whole + places) * unit, unit)


def classify(value: sp.Expr, printed: str) -> DecimalFinding | Undecided:
    """Compare a printed decimal with the exact value that it should show.

    Raises `ValueError` when `printed` is no decimal.
    """
    decimal = read_decimal(printed)
    try:
        return DecimalFinding(
            rounding=_rounding(value, decimal),
            interval=decimal.interval,
            digits=format_ball(evaluate(value, precision=256), 6),
            relative_error=_relative_error(value, decimal),
            correction=format_fraction(_rounded(value, decimal.unit), decimal.unit),
        )
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)


def format_fraction(value: Fraction, unit: Fraction | None = None) -> str:
    """Write a decimal fraction in full, with the places of `unit` (as many as needed by default).

    Raises `ValueError` for a fraction that has no finite decimal of these places.
    """
    places = 0
    while (10**places * value).denominator != 1 or (unit and unit * 10**places < 1):
        places += 1
        if places > MOST_PLACES:
            raise ValueError(f"{value} has no decimal of at most {MOST_PLACES} places")
    digits = str(abs(int(10**places * value))).rjust(places + 1, "0")
    minus = "-" if value < 0 else ""
    return minus + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)


def compare_with(value: sp.Expr, bound: Fraction) -> int:
    """Return the certain sign of value - bound; raises `UnsupportedError` as `exact.sign` does."""
    return sign(subtract(value, sp.Rational(bound.numerator, bound.denominator)))


def _rounded(value: sp.Expr, unit: Fraction) -> Fraction:
    """Round an exact number to a multiple of `unit`, ties away from zero."""
    middle = evaluate(value, precision=256).mid().fmpq()
    # The midpoint of a ball proves nothing: its neighbours are asked as well.
    steps = round(Fraction(int(middle.p), int(middle.q)) / unit)
    for candidate in (steps - 1, steps, steps + 1):
        below = compare_with(value, (candidate - Fraction(1, 2)) * unit)
        above = compare_with(value, (candidate + Fraction(1, 2)) * unit)
        tie = (below == 0 and candidate > 0) or (above == 0 and candidate < 0)
        if tie or (below > 0 and above < 0):
            return candidate * unit
    raise UnsupportedError(f"{value} is too large to be rounded")


def _rounding(value: sp.Expr, decimal: Decimal) -> Rounding:
    side = compare_with(value, decimal.value)
    if side == 0:
        return Rounding.EXACT
    # Away from the printed decimal: less than half a unit, exactly half, or more.
    beyond_half = side * compare_with(value, decimal.value + side * decimal.unit / 2)
    if beyond_half < 0:
        return Rounding.ROUNDED
    if beyond_half == 0:
        return Rounding.TIE
    if _is_cut_off(value, decimal, side):
        return Rounding.TRUNCATED
    if side * compare_with(value, decimal.value + 3 * side * decimal.unit / 2) < 0:
        return Rounding.OFF_BY_ONE
    return Rounding.WRONG


def _is_cut_off(value: sp.Expr, decimal: Decimal, side: int) -> bool:
    """Whether the value lies within one unit from the decimal, and further from zero."""
    away_from_zero = decimal.value * side >= 0 and compare_with(value, Fraction(0)) == side
    return away_from_zero and side * compare_with(value, decimal.value + side * decimal.unit) < 0


def _relative_error(value: sp.Expr, decimal: Decimal) -> str:
    exact = evaluate(value, precision=256)
    if exact.contains(0):
        return ""
    printed = sp.Rational(decimal.value.numerator, decimal.value.denominator)
    error = evaluate(subtract(printed, value) / sp.Abs(value), precision=256)
    return "0" if error.contains(0) else format_ball(error, 2)
