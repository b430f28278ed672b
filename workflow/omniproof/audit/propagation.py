"""Whether a printed number follows from other printed numbers, known to their last digits only.

Inputs range over the intervals that their decimals stand for. Where the slope of the function has
one sign in every input, its range ends at two corners and is compared exactly, so that an output
that just reaches a bound is told from one that just misses it. Elsewhere four questions of sign
settle it, each proved by balls: is the function always, or somewhere, beyond either bound?
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum

import sympy as sp
from flint import ctx

from omniproof.audit.answer import Undecided
from omniproof.audit.balls import compile_balls
from omniproof.audit.box import Box, hull
from omniproof.audit.exact import subtract
from omniproof.audit.intervals import Piece
from omniproof.audit.positivity import Negative, Open, Positive, prove_positive
from omniproof.audit.ranges import includes, meet
from omniproof.decide.balls import sign_of
from omniproof.formula.errors import UnsupportedError

ENGINE = ("flint",)
PRECISION = 96


class Reach(StrEnum):
    """Whether a function of uncertain inputs meets an interval."""

    CERTAIN = "certain"  # for all inputs
    POSSIBLE = "possible"  # for some inputs, but not for all
    EXCLUDED = "excluded"  # for none


def propagate(
    value: sp.Expr, inputs: Mapping[sp.Symbol, Piece], target: Piece
) -> Reach | Undecided:
    """Decide whether a function of inputs in bounded intervals lies in a target interval.

    The intervals come from `ranges.stands_for`. Never raises for an expression: `Undecided` gives
    the reason.
    """
    try:
        slopes = _slopes(value, inputs)
        if all(slope is not None for slope in slopes.values()):
            return _compare(_range(value, inputs, slopes), target)
        return _search(value, Box.of({x: (p.lower, p.upper) for x, p in inputs.items()}), target)
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)


def _slopes(value: sp.Expr, inputs: Mapping[sp.Symbol, Piece]) -> dict[sp.Symbol, int | None]:
    """Find the certain signs of all slopes; raises `UnsupportedError` where there are none."""
    box = Box.of({symbol: (piece.lower, piece.upper) for symbol, piece in inputs.items()})
    program = compile_balls([value], box.symbols)
    signs: dict[sp.Symbol, int | None] = {}
    with ctx.workprec(PRECISION):
        everywhere = hull(box.unit_cell, box.enclosed_sides())
        for place, symbol in enumerate(box.symbols):
            direction = [int(k == place) for k in range(len(everywhere))]
            ((_, slope),) = program.taylor(everywhere, direction, 1)
            if not slope.is_finite():
                raise UnsupportedError(f"it may have a pole or a kink in the range of {symbol}")
            signs[symbol] = sign_of(slope)
    return signs


def _range(
    value: sp.Expr, inputs: Mapping[sp.Symbol, Piece], slopes: Mapping[sp.Symbol, int | None]
) -> Piece:
    """Return the range of a monotone function, from its lowest to its highest corner."""
    low: dict[sp.Symbol, sp.Expr] = {}
    high: dict[sp.Symbol, sp.Expr] = {}
    reached = [True, True]
    for symbol, piece in inputs.items():
        ends = [(piece.lower, piece.lower_closed), (piece.upper, piece.upper_closed)]
        # A falling function is lowest at the upper end.
        (low[symbol], at_low), (high[symbol], at_high) = ends[:: slopes[symbol] or 1]
        # An input on which nothing depends need not reach its end.
        if slopes[symbol]:
            reached = [reached[0] and at_low, reached[1] and at_high]
    return Piece(value.xreplace(low), value.xreplace(high), *reached)


def _compare(reached: Piece, target: Piece) -> Reach:
    if includes(target, reached):
        return Reach.CERTAIN
    return Reach.POSSIBLE if meet(target, reached) else Reach.EXCLUDED


def _search(value: sp.Expr, box: Box, target: Piece) -> Reach:
    """Decide by signs; a continuous function that is somewhere not above and not below, is in."""
    under, over = subtract(target.upper, value), subtract(value, target.lower)
    always_under, always_over = prove_positive(under, box), prove_positive(over, box)
    if isinstance(always_under, Positive) and isinstance(always_over, Positive):
        return Reach.CERTAIN
    for beyond in (subtract(value, target.upper), subtract(target.lower, value)):
        outcome = prove_positive(beyond, box)
        if isinstance(outcome, Positive):
            return Reach.EXCLUDED
        if isinstance(outcome, Open):
            raise UnsupportedError(outcome.reason)
    if isinstance(always_under, Negative) or isinstance(always_over, Negative):
        return Reach.POSSIBLE
    raise UnsupportedError("it reaches a bound without passing it")
