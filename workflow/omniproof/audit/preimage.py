"""For which parameters does a value lie in an interval?  Enclosures, by bisection with balls.

With N/D the value, D > 0, the condition lower <= N/D <= upper is N - lower D >= 0 and
upper D - N >= 0: two functions without poles. A cell is in when both are certainly positive, out
when one is certainly negative, and halved otherwise, down to 2^-40 of the box.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any, TypeAlias

import sympy as sp
from flint import arb, ctx, fmpq

from omniproof.decide.answer import Undecided
from omniproof.decide.balls import Ball, Program, format_ball
from omniproof.decide.in_sympy.balls import compile_balls
from omniproof.decide.order.box import halves, hull, middle
from omniproof.decide.order.quotient import OnBox, Quotient
from omniproof.decide.order.signs import denominator_sign
from omniproof.formula.errors import UnsupportedError

ENGINE = ("flint",)
PRECISION = 96
SMALLEST = fmpq(1, 2**40)
MOST_CELLS = 20_000

Solutions: TypeAlias = tuple[tuple[str, str], ...]
Edge: TypeAlias = tuple[fmpq, fmpq, bool]


def solve_for(
    expression: sp.Expr,
    symbol: sp.Symbol,
    interval: tuple[Fraction, Fraction],
    box: tuple[Any, Any],
    digits: int = 6,
) -> Solutions | Undecided:
    """Find the values of a symbol in an open range for which an expression lies in an interval.

    Each solution is an interval (lower, upper) of decimals with `digits` significant digits. To
    these digits nothing else is a solution; an interval of length zero may be a point that just
    reaches a bound, or just fails to. Never raises for an expression: `Undecided` gives the reason.
    """
    try:
        function = Quotient.of(OnBox(expression, {symbol: box}))
        return _solve(function, interval, digits)
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)


def _solve(function: Quotient, interval: tuple[Fraction, Fraction], digits: int) -> Solutions:
    sign = denominator_sign(function)
    above, below = (sp.Rational(end.numerator, end.denominator) for end in interval)
    excess = sign * (function.numerator - above * function.denominator)
    reserve = sign * (below * function.denominator - function.numerator)
    program = compile_balls([excess, reserve], function.box.symbols)
    with ctx.workprec(PRECISION):
        cells = sorted(_cells(program, function), key=lambda cell: cell[0])
        ((lower, length),) = function.box.enclosed_sides()
        return tuple(
            (format_ball(lower + length * start, digits), format_ball(lower + length * end, digits))
            for start, end in _runs(cells)
        )


def _cells(program: Program, function: Quotient) -> Iterator[Edge]:
    """Yield the cells that are in (True), and the smallest ones that were not settled (False)."""
    sides = function.box.enclosed_sides()
    cells = [function.box.unit_cell]
    for _ in range(MOST_CELLS):
        if not cells:
            return
        cell = cells.pop()
        ranges = _ranges(program, hull(cell, sides)[0], middle(cell, sides)[0])
        ((start, end),) = cell
        if all(value > 0 for value in ranges):
            yield start, end, True
        elif not any(value < 0 for value in ranges):
            if end - start < SMALLEST:
                yield start, end, False
            else:
                cells.extend(halves(cell, sides))
    raise UnsupportedError(f"more than {MOST_CELLS} cells were needed")


def _ranges(program: Program, cell: Ball, centre: Ball) -> list[Ball]:
    """Enclose the functions on a cell, by the better of natural range and mean-value form."""
    slopes = [coefficients[1] for coefficients in program.taylor([cell], [1], 1)]
    values = zip(program.run([cell]), program.run([centre]), slopes, strict=True)
    return [_narrower(wide, at + slope * (cell - centre)) for wide, at, slope in values]


def _narrower(first: Ball, second: Ball) -> Ball:
    if not second.is_finite():
        return first
    return second if not first.is_finite() or second.rad() < first.rad() else first


def _runs(cells: list[Edge]) -> Iterator[tuple[Ball, Ball]]:
    """Join neighbouring cells; an unsettled end of a run is narrowed to its middle."""
    breaks = [k for k, (left, right) in enumerate(pairwise(cells), 1) if left[1] != right[0]]
    for first, last in pairwise([0, *breaks, len(cells)]):
        run = cells[first:last]
        if not run:
            return
        inner = [cell for cell in run if cell[2]]
        if inner:
            yield arb((run[0][0] + inner[0][0]) / 2), arb((inner[-1][1] + run[-1][1]) / 2)
        else:
            yield arb(run[0][0]), arb(run[-1][1])
