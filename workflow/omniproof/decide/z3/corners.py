"""Points of the unit circle at rational multiples of pi, in square roots.

The multiples of 15 and of 18 degrees in the first quadrant stand in a table (Euclid, Elements, IV
and XIII); the addition formula gives the multiples of 3 degrees, and the formula for half an angle
what is a power of two finer. No other rational angle has a cosine in square roots, but for those of
polygons with 17, 257 or 65537 corners (Gauss), which nobody prints.
"""

from __future__ import annotations

from fractions import Fraction

from omniproof.formula.term import (
    ONE,
    ZERO,
    Sum,
    Term,
    divide,
    multiply,
    negative,
    number,
    root,
    subtract,
)

FINEST = 64
"""Halved so often at most, down to 2.8 degrees by 64: each time takes a root of roots."""
_TWO, _THREE, _FIVE, _SIX = (root(number(value)) for value in (2, 3, 5, 6))


def _part(above: Term, below: int) -> Term:
    return divide(above, number(below))


_TWELFTHS = (
    ONE,
    _part(Sum((_SIX, _TWO)), 4),
    _part(_THREE, 2),
    _part(_TWO, 2),
    _part(ONE, 2),
    _part(subtract(_SIX, _TWO), 4),
    ZERO,
)
"""Cosines of 0, 15, …, 90 degrees."""
_TENTHS = (
    ONE,
    _part(root(Sum((number(10), multiply(number(2), _FIVE)))), 4),
    _part(Sum((ONE, _FIVE)), 4),
    _part(root(subtract(number(10), multiply(number(2), _FIVE))), 4),
    _part(subtract(_FIVE, ONE), 4),
    ZERO,
)
"""Cosines of 0, 18, …, 90 degrees."""


def corner(turns: Fraction) -> tuple[Term, Term] | None:
    """Return cosine and sine of `turns` times pi; None where square roots do not reach."""
    cosine, sine = _cosine(turns), _cosine(turns - Fraction(1, 2))
    return None if cosine is None or sine is None else (cosine, sine)


def _cosine(turns: Fraction) -> Term | None:
    turns = abs((turns + 1) % 2 - 1)  # the cosine is even, with the period 2
    if turns > Fraction(1, 2):
        opposite = _cosine(1 - turns)
        return None if opposite is None else negative(opposite)
    for steps, table in ((12, _TWELFTHS), (10, _TENTHS)):
        if (turns * steps).denominator == 1:
            return table[int(turns * steps)]
    if (turns * 60).denominator == 1:
        return _cosine_of_sum(turns)
    if turns.denominator % 2 == 0 and turns.denominator <= FINEST:
        double = _cosine(2 * turns)
        return None if double is None else root(_part(Sum((ONE, double)), 2))
    return None


def _cosine_of_sum(turns: Fraction) -> Term | None:
    """Write an angle as a multiple of 15 degrees and one of 18 degrees."""
    first = next(k for k in range(6) if (turns - Fraction(k, 12)) * 10 % 1 == 0)
    one, other = corner(Fraction(first, 12)), corner(turns - Fraction(first, 12))
    if one is None or other is None:
        return None
    return subtract(multiply(one[0], other[0]), multiply(one[1], other[1]))
