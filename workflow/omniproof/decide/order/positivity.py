"""Prove that a function is positive on an open box, except for zeros that are known exactly.

Branch and bound in ball arithmetic. A cell is settled by its natural range, by the mean-value form,
or, close to a known zero c, by Taylor's theorem: with one variable and a zero of order m, the sign
of f(x) = f^(m)(xi) (x - c)^m / m! is plain (also at an end of the interval, and for odd m there);
with several, the gradient vanishes and the Hessian is positive definite between x and c. Orders are
exact: derivatives at c are zero by the zero test, not by their size. Derivatives come from power
series with ball coefficients, on the same compiled program.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any, TypeAlias

from flint import arb, ctx, fmpq

from omniproof.decide.balls import Ball, Program, compile_balls, sign_of
from omniproof.decide.exact import sign
from omniproof.decide.in_sympy.balls import evaluate
from omniproof.decide.in_sympy.exact import subtract, vanishes
from omniproof.decide.order.box import Box, Cell, halves, hull, middle
from omniproof.formula.derivative import derivative
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Term, substitute

PRECISION = 96
MOST_CELLS = 6_000
SMALLEST = fmpq(1, 2**24)
MOST_RESISTING = 12
LARGEST_ORDER = 8


@dataclass(frozen=True)
class Positive:
    """The function is positive on the box, known zeros apart."""


@dataclass(frozen=True)
class Negative:
    """The function is negative at a rational point of the box."""

    point: tuple[fmpq, ...]


@dataclass(frozen=True)
class Open:
    """Neither was shown; the places (centres of cells) where the proof got stuck."""

    reason: str
    places: tuple[tuple[float, ...], ...]


Outcome: TypeAlias = Positive | Negative | Open


@dataclass(frozen=True)
class Zero:
    """A zero of the function and its order (2 with several variables).

    `side` is 1 for the lower end of an interval, -1 for the upper end, 0 anywhere else.
    """

    point: tuple[Ball, ...]
    order: int
    side: int = 0


def prove_positive(function: Term, box: Box, zeros: Sequence[tuple[Any, ...]] = ()) -> Outcome:
    """Prove function > 0 on the box except at `zeros`, exact points of the closed box.

    Points where the function is undefined prove nothing, so it should be defined inside. Raises
    `UnsupportedError` for a function that cannot be enclosed.
    """
    with ctx.workprec(PRECISION):
        return _Search(function, box, zeros).run()


@dataclass
class _Search:
    function: Term
    box: Box
    exact_zeros: Sequence[tuple[Any, ...]]
    resisting: list[tuple[float, ...]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.names = [symbol.name for symbol in self.box.symbols]
        self.program: Program = compile_balls([self.function], self.names)
        self.sides = self.box.enclosed_sides()
        zeros = (self._zero(zero) for zero in self.exact_zeros)
        self.zeros = [zero for zero in zeros if zero is not None]

    def run(self) -> Outcome:
        cells = [self.box.unit_cell]
        for _ in range(MOST_CELLS):
            if not cells:
                return Positive() if not self.resisting else self._stuck("it is nearly zero")
            cell = cells.pop()
            if self._is_positive(cell):
                continue
            point = self._negative_point(cell)
            if point is not None:
                return Negative(point)
            if max(b - a for a, b in cell) > SMALLEST:
                cells.extend(halves(cell, self.sides))
                continue
            self.resisting.append(tuple(float(x.mid()) for x in middle(cell, self.sides)))
            if len(self.resisting) >= MOST_RESISTING:
                return self._stuck("it is nearly zero")
        return self._stuck(f"more than {MOST_CELLS} cells were needed")

    def _stuck(self, reason: str) -> Open:
        return Open(reason, tuple(self.resisting))

    def _is_positive(self, cell: Cell) -> bool:
        ranges = hull(cell, self.sides)
        if self._value(ranges) > 0:
            return True
        slopes = self._slopes(ranges)
        centre = middle(cell, self.sides)
        linear = self._value(centre)
        for slope, x, c in zip(slopes, ranges, centre, strict=True):
            linear = linear + slope * (x - c)
        return bool(linear > 0) or any(self._is_positive_near(zero, ranges) for zero in self.zeros)

    def _is_positive_near(self, zero: Zero, ranges: list[Ball]) -> bool:
        between = [x.union(c) for x, c in zip(ranges, zero.point, strict=True)]
        if len(ranges) > 1:
            return self._is_convex(between)
        sign = sign_of(self._series(between, [1], zero.order)[zero.order])
        if zero.order % 2 == 0:
            return sign == 1
        side = zero.side or sign_of(ranges[0] - zero.point[0])
        return sign is not None and sign == side

    def _negative_point(self, cell: Cell) -> tuple[fmpq, ...] | None:
        centre = middle(cell, self.sides)
        if not self._value(centre) < 0:
            return None
        for closeness in (1e-3, 1e-6, 1e-9, 0.0):
            point = self.box.rational_near(centre, closeness)
            if point is not None and self._value([arb(x) for x in point]) < 0:
                return point
        return None

    def _zero(self, exact: tuple[Any, ...]) -> Zero | None:
        """Find the order of a zero; None for a point that is none, or where f is not smooth."""
        point = [evaluate(x, precision=2 * PRECISION) for x in exact]
        try:
            return self._zero_on_line(exact, point) if len(exact) == 1 else self._flat(exact, point)
        except UnsupportedError:
            return None

    def _flat(self, exact: tuple[Any, ...], point: list[Ball]) -> Zero | None:
        slopes = (derivative(self.function, name) for name in self.names)
        flat = all(self._vanishes(part, exact) for part in (self.function, *slopes))
        return Zero(tuple(point), 2) if flat else None

    def _vanishes(self, part: Term, exact: tuple[Any, ...]) -> bool:
        values = dict(zip(self.names, map(term_of, exact), strict=True))
        return sign(substitute(part, values)) == 0

    def _zero_on_line(self, exact: tuple[Any, ...], point: list[Ball]) -> Zero | None:
        part = self.function
        coefficients = self._series(point, [1], LARGEST_ORDER)
        for order in range(LARGEST_ORDER + 1):
            coefficient = coefficients[order]
            if coefficient.is_finite() and not coefficient.contains(0):
                return Zero(tuple(point), order, self._side(exact[0])) if order else None
            if not self._vanishes(part, exact):
                return None
            part = derivative(part, self.names[0])
        return None

    def _side(self, end: Any) -> int:
        (lower, upper) = self.box.sides[0]
        return int(vanishes(subtract(end, lower))) - int(vanishes(subtract(end, upper)))

    def _value(self, point: Sequence[Ball]) -> Ball:
        return self.program.run(point)[0]

    def _slopes(self, ranges: list[Ball]) -> list[Ball]:
        size = len(ranges)
        return [self._series(ranges, _axis(size, k), 1)[1] for k in range(size)]

    def _is_convex(self, ranges: list[Ball]) -> bool:
        """Whether the Hessian is positive definite, by Sylvester's leading minors."""
        size = len(ranges)
        curvature = {k: self._series(ranges, _axis(size, k), 2)[2] for k in range(size)}
        hessian = [[2 * curvature[k] if k == i else None for k in range(size)] for i in range(size)]
        for i, k in combinations(range(size), 2):
            mixed = self._series(ranges, _axis(size, i, k), 2)[2] - curvature[i] - curvature[k]
            hessian[i][k] = hessian[k][i] = mixed
        return all(_determinant([row[:n] for row in hessian[:n]]) > 0 for n in range(1, size + 1))

    def _series(self, point: Sequence[Ball], direction: Sequence[int], order: int) -> list[Ball]:
        return self.program.taylor(point, direction, order)[0]


def _axis(size: int, *places: int) -> list[int]:
    return [int(k in places) for k in range(size)]


def _determinant(rows: list[list[Ball]]) -> Ball:
    if len(rows) == 1:
        return rows[0][0]
    total = arb(0)
    for k, entry in enumerate(rows[0]):
        minor = [row[:k] + row[k + 1 :] for row in rows[1:]]
        total = total + (-1) ** k * entry * _determinant(minor)
    return total
