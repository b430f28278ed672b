"""Unions of intervals with exact end points: made from a sign chart, written for a reader."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import sympy as sp

from omniproof.decide.order.sign_chart import Chart


@dataclass(frozen=True)
class Piece:
    """An interval; an end that belongs to it is closed. One point is an interval, too."""

    lower: Any
    upper: Any
    lower_closed: bool = False
    upper_closed: bool = False

    def relation(self, symbol: sp.Symbol) -> sp.Basic:
        """Write the interval as a SymPy condition on a symbol."""
        left = sp.Le if self.lower_closed else sp.Lt
        right = sp.Le if self.upper_closed else sp.Lt
        return sp.And(left(self.lower, symbol), right(symbol, self.upper))

    def show(self, name: str, end: Callable[[Any], str], less: str, at_most: str) -> str:
        """Write `lower < name < upper` with the given spellings; `name = end` for one point."""
        if self.lower == self.upper:
            return f"{name} = {end(self.lower)}"
        left = at_most if self.lower_closed else less
        right = at_most if self.upper_closed else less
        return f"{end(self.lower)} {left} {name} {right} {end(self.upper)}"


def pieces_of(chart: Chart, sign: int, joins: Callable[[Any], bool]) -> tuple[Piece, ...]:
    """Collect the intervals of one sign; neighbours grow together at points where `joins` says so.

    Such a point belongs to the set also where it ends there, except at the ends of the chart.
    """
    inner = {point for point in chart.points[1:-1] if joins(point)}
    pieces: list[Piece] = []
    for (lower, upper), own in zip(pairwise(chart.points), chart.signs, strict=True):
        if own != sign:
            continue
        if pieces and pieces[-1].upper == lower and lower in inner:
            pieces[-1] = replace(pieces[-1], upper=upper, upper_closed=upper in inner)
        else:
            pieces.append(Piece(lower, upper, lower in inner, upper in inner))
    return tuple(pieces)


def condition_latex(symbol: sp.Symbol, pieces: Sequence[Piece]) -> str:
    r"""Write a union of intervals as LaTeX: `0 < t \leq \pi`, parts joined by "or"."""
    name = sp.latex(symbol)
    return r" \text{ or } ".join(piece.show(name, sp.latex, "<", r"\leq") for piece in pieces)


def in_degrees(symbol: sp.Symbol, pieces: Iterable[Piece]) -> str:
    """Write a union of intervals in degrees, empty when an end is no rational multiple of pi."""
    pieces = tuple(pieces)
    ends = [end / sp.pi for piece in pieces for end in (piece.lower, piece.upper)]
    if not all(end.is_Rational for end in ends):
        return ""
    letter = sp.pretty(symbol)
    return " or ".join(piece.show(letter, _degrees, "<", "≤") for piece in pieces)


def _degrees(end: Any) -> str:
    return f"{end * 180 / sp.pi}°"
