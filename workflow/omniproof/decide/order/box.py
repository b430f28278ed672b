"""Boxes with exact, possibly transcendental sides, cut into cells with exact rational corners.

A cell lives in the unit cube; x = lower + (upper - lower) s maps it to the box. So halving stays
exact although pi/2 is no rational number.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

import sympy as sp
from flint import arb, fmpq

from omniproof.decide.balls import Ball, as_float, rational_ball
from omniproof.decide.in_sympy.balls import evaluate, exact_number
from omniproof.decide.in_sympy.exact import sign, subtract
from omniproof.formula.errors import UnsupportedError

Side: TypeAlias = tuple[fmpq, fmpq]
Cell: TypeAlias = tuple[Side, ...]


@dataclass(frozen=True)
class Box:
    """Open intervals with exact end points, one for each symbol."""

    symbols: tuple[sp.Symbol, ...]
    sides: tuple[tuple[Any, Any], ...]

    @staticmethod
    def of(intervals: Mapping[sp.Symbol, tuple[Any, Any]]) -> Box:
        """Make a box; raises `UnsupportedError` for a side that is empty or not finite."""
        sides = tuple(
            (exact_number(lower), exact_number(upper)) for lower, upper in intervals.values()
        )
        for symbol, (lower, upper) in zip(intervals, sides, strict=True):
            if not (lower.is_finite and upper.is_finite):
                raise UnsupportedError(f"the range of {symbol} is not bounded")
            if sign(subtract(upper, lower)) <= 0:
                raise UnsupportedError(f"the range of {symbol} is empty")
        return Box(tuple(intervals), sides)

    @property
    def unit_cell(self) -> Cell:
        """The whole box as a cell."""
        return tuple((fmpq(0), fmpq(1)) for _ in self.symbols)

    def enclosed_sides(self) -> list[tuple[Ball, Ball]]:
        """Enclose lower end and length of each side at the current precision."""
        ends = [[evaluate(end) for end in side] for side in self.sides]
        return [(lower, upper - lower) for lower, upper in ends]

    def contains(self, point: tuple[Any, ...], closed: Sequence[tuple[bool, bool]] = ()) -> bool:
        """Decide whether an exact point lies inside, or on an end that is `closed`."""
        belongs = closed or ((False, False),) * len(self.sides)
        return all(
            sign(subtract(x, lower)) >= (not at_lower)
            and sign(subtract(upper, x)) >= (not at_upper)
            for x, (lower, upper), (at_lower, at_upper) in zip(
                point, self.sides, belongs, strict=True
            )
        )

    def rational_near(self, middle: list[Ball], closeness: float = 1e-3) -> tuple[fmpq, ...] | None:
        """Return a short rational point near a place inside, None at the very border.

        `closeness` is measured by the length of each side.
        """
        point = []
        for ball, (lower, length) in zip(middle, self.enclosed_sides(), strict=True):
            value = _short(as_float(ball), as_float(length) * closeness)
            if not lower < rational_ball(value) < lower + length:
                return None
            point.append(value)
        return tuple(point)


def hull(cell: Cell, sides: list[tuple[Ball, Ball]]) -> list[Ball]:
    """Enclose the points of a cell."""
    pairs = zip(cell, sides, strict=True)
    return [lower + length * arb(a).union(arb(b)) for (a, b), (lower, length) in pairs]


def middle(cell: Cell, sides: list[tuple[Ball, Ball]]) -> list[Ball]:
    """Enclose the centre of a cell."""
    pairs = zip(cell, sides, strict=True)
    return [lower + length * arb((a + b) / 2) for (a, b), (lower, length) in pairs]


def halves(cell: Cell, sides: list[tuple[Ball, Ball]]) -> tuple[Cell, Cell]:
    """Cut a cell across its longest side."""
    lengths = [(b - a) * _rational(length) for (a, b), (_, length) in zip(cell, sides, strict=True)]
    k = lengths.index(max(lengths))
    a, b = cell[k]
    cut = (a + b) / 2
    before, after = cell[:k], cell[k + 1 :]
    return (*before, (a, cut), *after), (*before, (cut, b), *after)


def _rational(ball: Ball) -> fmpq:
    return fmpq(*as_float(ball).as_integer_ratio())


def _short(value: float, tolerance: float) -> fmpq:
    """Return the rational with the smallest denominator (by tens) within a tolerance."""
    exact = Fraction(value)
    for bound in (10, 100, 1_000, 10_000, 10**6):
        short = exact.limit_denominator(bound)
        if abs(short - exact) <= tolerance:
            return fmpq(short.numerator, short.denominator)
    return fmpq(exact.numerator, exact.denominator)
