"""Where a function of one variable is positive, as intervals with closed-form end points.

Zeros are looked for on a grid and by bisection, which proves nothing; each is then recognised as a
rational multiple of pi or a rational number and confirmed by the exact zero test. What is proved
afterwards is the chart itself: on each interval between neighbouring zeros the function keeps its
sign (`positivity`). A zero that was missed makes that proof fail, it never makes it wrong.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

import sympy as sp
from flint import arb, ctx

from omniproof.decide.balls import Program, as_float, compile_balls
from omniproof.decide.exact import sign
from omniproof.decide.in_sympy.balls import evaluate
from omniproof.decide.order.box import Box
from omniproof.decide.order.positivity import Positive, prove_positive
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Term, negative, substitute

GRID = 240
BISECTIONS = 60
FINEST_TURN = 360  # largest N for which multiples of pi/N are recognised
LARGEST_DENOMINATOR = 12
CLOSE = 1e-9


@dataclass(frozen=True)
class Chart:
    """Signs of a function on the intervals between its `points` (ends of the box included)."""

    points: tuple[Any, ...]
    signs: tuple[int, ...]


def sign_chart(function: Term, box: Box) -> Chart:
    """Prove where a function of one variable is positive and where it is negative.

    Raises `UnsupportedError` when a zero has no closed form that is recognised, or when a sign
    between zeros could not be proved.
    """
    (symbol,) = box.symbols
    lower, upper = box.sides[0]
    zeros = [_recognise(function, symbol, place) for place in _zeros(function, box)]
    inner = [zero for zero in dict.fromkeys(zeros) if box.contains((zero,))]
    points = (lower, *inner, upper)
    signs = tuple(_sign_between(function, symbol, *pair) for pair in pairwise(points))
    return Chart(points, signs)


def recognise(
    value: float, tolerance: float = CLOSE, finest_turn: int = FINEST_TURN
) -> Iterator[Any]:
    """Yield numbers of closed form close to a decimal: multiples of pi/N, rationals."""
    turn = Fraction(value / math.pi).limit_denominator(finest_turn)
    if abs(float(turn) * math.pi - value) < tolerance:
        yield sp.Rational(turn.numerator, turn.denominator) * sp.pi
    plain = Fraction(value).limit_denominator(LARGEST_DENOMINATOR)
    if abs(float(plain) - value) < tolerance:
        yield sp.Rational(plain.numerator, plain.denominator)


def _recognise(function: Term, symbol: sp.Symbol, place: float) -> Any:
    for closed in recognise(place):
        if _vanishes_at(function, symbol, closed):
            return closed
    raise UnsupportedError(f"its zero {symbol} = {place:.6f} has no closed form that is known here")


def _vanishes_at(function: Term, symbol: sp.Symbol, place: Any) -> bool:
    return sign(substitute(function, {symbol.name: term_of(place)})) == 0


def _zeros(function: Term, box: Box) -> list[float]:
    """Approximate the zeros inside: changes of sign, and places where |f| is nearly zero."""
    program = compile_balls([function], [symbol.name for symbol in box.symbols])
    lower, upper = (as_float(evaluate(end)) for end in box.sides[0])
    places = [lower + (upper - lower) * (k + 0.382) / GRID for k in range(GRID)]
    values = [_value(program, place) for place in places]
    zeros = []
    for (a, fa), (b, fb) in pairwise(zip(places, values, strict=True)):
        if fa * fb < 0:
            zeros.append(_bisect(program, a, b, fa))
    for (a, fa), (_, fb), (c, fc) in _triples(list(zip(places, values, strict=True))):
        if abs(fb) <= min(abs(fa), abs(fc)) and fa * fb > 0 and fb * fc > 0:
            touching = _flattest(program, a, c)
            if abs(_value(program, touching)) < CLOSE:
                zeros.append(touching)
    return sorted(zeros)


def _triples(items: list[tuple[float, float]]) -> Iterator[tuple[tuple[float, float], ...]]:
    yield from zip(items, items[1:], items[2:], strict=False)


def _bisect(program: Program, a: float, b: float, fa: float) -> float:
    for _ in range(BISECTIONS):
        c = (a + b) / 2
        fc = _value(program, c)
        if fc == 0:
            return c
        a, b, fa = (c, b, fc) if fa * fc > 0 else (a, c, fa)
    return (a + b) / 2


def _flattest(program: Program, a: float, c: float) -> float:
    """Minimise |f| by ternary search; a double root is found to about eight digits only."""
    for _ in range(BISECTIONS):
        left, right = a + (c - a) / 3, c - (c - a) / 3
        smaller = abs(_value(program, left)) < abs(_value(program, right))
        a, c = (a, right) if smaller else (left, c)
    return (a + c) / 2


def _value(program: Program, place: float) -> float:
    with ctx.workprec(160):
        return float(program.run([arb(place)])[0].mid())


def _sign_between(function: Term, symbol: sp.Symbol, lower: Any, upper: Any) -> int:
    """Prove the sign of a function that has no zero strictly between two points."""
    box = Box.of({symbol: (lower, upper)})
    ends = [(end,) for end in (lower, upper) if _is_zero(function, symbol, end)]
    for wanted, signed in ((1, function), (-1, negative(function))):
        if isinstance(prove_positive(signed, box, ends), Positive):
            return wanted
    raise UnsupportedError(f"its sign between {symbol} = {lower} and {upper} was not proved")


def _is_zero(function: Term, symbol: sp.Symbol, end: Any) -> bool:
    try:
        return _vanishes_at(function, symbol, end)
    except UnsupportedError:
        return False
