"""Exact intervals: what a printed decimal stands for, and the arithmetic of such intervals.

End points stay exact SymPy numbers (20.75 pi / 30, not 2.17), and whether an end belongs to the
interval is kept: cut-off decimals stand for half-open intervals, and whether two of them touch or
miss is what a proof of contradiction hangs on. Order is decided by `ordering.compare`, never by a
tolerance.
"""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from fractions import Fraction
from typing import Any, TypeAlias

import sympy as sp

from omniproof.audit.decimals import read_decimal
from omniproof.audit.evidence import Range
from omniproof.decide.balls import format_ball
from omniproof.decide.in_sympy.balls import evaluate
from omniproof.decide.in_sympy.exact import sign
from omniproof.decide.order.intervals import Piece
from omniproof.decide.order.ordering import compare

Pieces: TypeAlias = tuple[Piece, ...]
"""Disjoint intervals in ascending order."""

REAL_LINE = Piece(-sp.oo, sp.oo)
POSITIVE = Piece(sp.Integer(0), sp.oo)


class Reading(StrEnum):
    """How the last digit of a printed decimal is taken."""

    ROUNDED = "rounded"  # to the nearest decimal; a tie may have gone either way
    TRUNCATED = "truncated"  # digits cut off, towards zero
    EITHER = "either"  # rounded or truncated, one does not know


def stands_for(printed: str, reading: Reading) -> Piece:
    """Return the numbers that a decimal stands for: 20.8 -> [20.75, 20.85], [20.8, 20.9) or both.

    A cut-off zero stands for both signs, (-unit, unit). Raises `ValueError` for no decimal.
    """
    decimal = read_decimal(printed)
    value, unit = decimal.value, decimal.unit
    rounded = Piece(_exact(value - unit / 2), _exact(value + unit / 2), True, True)
    inner, outer = _exact(value), _exact(value + (unit if value >= 0 else -unit))
    if value == 0:
        cut = Piece(-outer, outer)
    else:
        cut = Piece(inner, outer, True) if value > 0 else Piece(outer, inner, False, True)
    match reading:
        case Reading.ROUNDED:
            return rounded
        case Reading.TRUNCATED:
            return cut
        case Reading.EITHER:
            return _span(rounded, cut)


def order(left: Any, right: Any) -> int:
    """Compare two ends, infinite ones included; raises `UnsupportedError` as `compare` does."""
    if left == right:
        return 0
    if left.is_infinite or right.is_infinite:
        return -1 if left == -sp.oo or right == sp.oo else 1
    return compare(left, right)


def contains(piece: Piece, value: sp.Expr) -> bool:
    """Decide whether an exact number lies in an interval."""
    return meet(piece, Piece(value, value, True, True)) is not None


def meet(left: Piece, right: Piece) -> Piece | None:
    """Return the common part of two intervals, None when there is none."""
    low, high = order(left.lower, right.lower), order(left.upper, right.upper)
    inner_low, inner_high = left if low >= 0 else right, left if high <= 0 else right
    # Where two ends coincide, the point has to belong to both.
    lower_closed = left.lower_closed and right.lower_closed if not low else inner_low.lower_closed
    upper_closed = left.upper_closed and right.upper_closed if not high else inner_high.upper_closed
    length = order(inner_high.upper, inner_low.lower)
    if length < 0 or (length == 0 and not (lower_closed and upper_closed)):
        return None
    return Piece(inner_low.lower, inner_high.upper, lower_closed, upper_closed)


def meet_all(left: Pieces, right: Pieces) -> Pieces:
    """Return the common part of two unions of intervals."""
    parts = (meet(a, b) for a in left for b in right)
    return tuple(part for part in parts if part is not None)


def scale(piece: Piece, factor: sp.Expr, shift: sp.Expr = sp.S.Zero) -> Piece:
    """Return {factor x + shift : x in the interval}; the factor is not zero."""
    lower, upper = (
        sign(factor) * end if end.is_infinite else factor * end + shift
        for end in (piece.lower, piece.upper)
    )
    if sign(factor) > 0:
        return Piece(lower, upper, piece.lower_closed, piece.upper_closed)
    return Piece(upper, lower, piece.upper_closed, piece.lower_closed)


def add(left: Piece, right: Piece) -> Piece:
    """Return {x + y : x, y in the intervals}; an end is reached when both of its parts are."""
    return Piece(
        left.lower + right.lower,
        left.upper + right.upper,
        left.lower_closed and right.lower_closed,
        left.upper_closed and right.upper_closed,
    )


def root(piece: Piece, power: sp.Rational) -> Piece | None:
    """Return {x >= 0 : x^power in the interval}, power not zero; None when there is none."""
    # 0 has a root, but no inverse: with a negative power it is left out.
    part = meet(piece, replace(POSITIVE, lower_closed=bool(power > 0)))
    if part is None:
        return None
    lower, upper = (_end_root(end, power) for end in (part.lower, part.upper))
    if power > 0:
        return Piece(lower, upper, part.lower_closed, part.upper_closed)
    return Piece(upper, lower, part.upper_closed, part.lower_closed)


def show(pieces: Pieces, name: str, digits: int = 6) -> str:
    """Write a union of intervals with decimals: `0.0499777 ≤ V < 0.0500621`."""
    return " or ".join(decimal_range(piece, digits).around(name) for piece in pieces)


def decimal_range(piece: Piece, digits: int = 6) -> Range:
    """Return an interval with decimals for its ends."""
    lower, upper = (_digits(end, digits) for end in (piece.lower, piece.upper))
    return Range(
        lower=lower,
        upper=upper,
        lower_closed=piece.lower_closed,
        upper_closed=piece.upper_closed,
    )


def _digits(end: sp.Expr, digits: int) -> str:
    if end.is_infinite:
        return "∞" if end == sp.oo else "-∞"
    return format_ball(evaluate(end), digits)


def _end_root(end: sp.Expr, power: sp.Rational) -> sp.Expr:
    if end == 0 or end.is_infinite:
        return sp.Integer(0) if (end == 0) == (power > 0) else sp.oo
    return end ** (1 / power)


def _span(left: Piece, right: Piece) -> Piece:
    """Return the smallest interval around two that meet."""
    first = left if order(left.lower, right.lower) <= 0 else right
    last = left if order(left.upper, right.upper) >= 0 else right
    return Piece(first.lower, last.upper, first.lower_closed, last.upper_closed)


def _exact(value: Fraction) -> sp.Rational:
    return sp.Rational(value.numerator, value.denominator)
