"""Numbers and symbols as the functions of this package take them."""

from __future__ import annotations

from typing import TypeAlias

from sympy import Expr, Integer, Rational, cos, expand, primerange, sin, trigsimp

Scalar: TypeAlias = Expr | int | float

DIGITS = 60
"""Working precision of the test for zero; below 10^-40 counts as zero."""


def exact(number: Scalar) -> Expr:
    """Turn a number into SymPy's; a string is a `TypeError` here and is never parsed."""
    return Integer(0) + number


def tidy(expression: Expr) -> Expr:
    """Expand, and write sin^2 as 1 - cos^2: that gathers what Pythagoras gathers, and is fast."""
    expanded = expand(expression)
    if not expanded.is_Add:
        return expanded
    squared = expanded.replace(
        lambda part: part.is_Pow and part.exp == 2 and isinstance(part.base, sin),
        lambda part: 1 - cos(part.base.args[0]) ** 2,
    )
    return expand(squared)


def vanishes(expression: Expr) -> bool:
    """Whether an expression is zero, as far as a guard needs it: no proof, that is the audit's.

    One point in general position settles what is not zero; the rest is left to expansion. SymPy's
    own `equals` takes minutes on numbers like sin(1/3), which no minimal polynomial has.
    """
    symbols = sorted(expression.free_symbols, key=str)
    primes = primerange(5, 10**4)
    point = {symbol: Rational(1, prime) for symbol, prime in zip(symbols, primes, strict=False)}
    if abs(expression.evalf(DIGITS, subs=point)) > Rational(1, 10**40):
        return False
    return not symbols or bool(trigsimp(expand(expression, trig=True)) == 0)
