"""Where an exact number lies, by the interval arithmetic of mpmath: rigorous, and without FLINT.

The first engine encloses numbers by balls of Arb, and everything it says of a decimal or of an
order hangs on them. These intervals are computed from the same expression by other code (mpmath's
own, on Python's integers), so that a fault of either side shows as two enclosures that exclude each
other. Ends are handed out as fractions: what is concluded from them needs no rounding.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import reduce
from typing import Any, TypeAlias

import sympy as sp
from mpmath import iv, libmp

from omniproof.formula.sympy_terms import SYMPY_FUNCTIONS

Interval: TypeAlias = Any
"""An interval of mpmath's context `iv` (mpmath publishes no types)."""

DIGITS = 60


class NotEnclosedError(ValueError):
    """A part of an expression has no enclosure here: a free symbol, an unknown function, a pole."""


def enclose(number: sp.Expr, digits: int = DIGITS) -> tuple[Fraction, Fraction] | None:
    """Return two fractions between which a real number lies, or `None` where this cannot say."""
    if number.is_Rational:
        return (Fraction(int(number.p), int(number.q)),) * 2
    before = iv.dps
    iv.dps = digits
    try:
        lower, upper = _enclosed(number)._mpi_
        return _fraction(lower), _fraction(upper)
    except (NotEnclosedError, ValueError, ZeroDivisionError, NotImplementedError):
        return None
    finally:
        iv.dps = before


def _fraction(end: Any) -> Fraction:
    # A pole or the root of an interval around 0 has an infinite end, and then says nothing.
    if end in (libmp.fnan, libmp.finf, libmp.fninf):
        raise NotEnclosedError("not finite")
    return Fraction(*map(int, libmp.to_rational(end)))


def _enclosed(node: Any) -> Interval:
    if node.is_Rational:
        return iv.mpf(int(node.p)) / int(node.q)
    if node in _CONSTANTS:
        return _CONSTANTS[node]()
    parts = [_enclosed(part) for part in node.args]
    if node.is_Pow:
        return _power(node.exp, *parts)
    if type(node) not in _RULES or not parts:
        raise NotEnclosedError(str(node))
    return _RULES[type(node)](*parts)


def _power(exponent: Any, base: Interval, power: Interval) -> Interval:
    if exponent.is_Integer:
        return base ** int(exponent)
    if exponent.is_Rational and exponent.q == 2:
        return iv.sqrt(base) ** int(exponent.p)
    return FUNCTIONS["power"](base, power)


def _sum(*terms: Interval) -> Interval:
    total = iv.mpf(0)
    for term in terms:
        total += term
    return total


def _product(*factors: Interval) -> Interval:
    total = iv.mpf(1)
    for factor in factors:
        total *= factor
    return total


_CONSTANTS: dict[Any, Callable[[], Interval]] = {
    sp.pi: lambda: +iv.pi,
    sp.E: lambda: iv.exp(iv.mpf(1)),
}


def _hyperbolic(sign: int) -> Callable[[Interval], Interval]:
    return lambda x: (iv.exp(x) + sign * iv.exp(-x)) / 2


def _sign(x: Interval) -> Interval:
    if x.a > 0 or x.b < 0:
        return iv.mpf(1 if x.a > 0 else -1)
    raise NotEnclosedError("the sign of what may be 0")


FUNCTIONS: dict[str, Callable[..., Interval]] = {
    "sin": iv.sin, "cos": iv.cos, "tan": iv.tan, "cot": iv.cot, "sec": iv.sec, "csc": iv.csc,
    # mpmath has intervals of the angle of a point only; the inverse functions are such angles.
    "arcsin": lambda x: iv.atan2(x, iv.sqrt(1 - x**2)),
    "arccos": lambda x: iv.atan2(iv.sqrt(1 - x**2), x),
    "arctan": lambda x: iv.atan2(x, iv.mpf(1)), "atan2": iv.atan2,
    "sqrt": iv.sqrt, "abs": abs, "sign": _sign, "exp": iv.exp, "log": iv.log,
    "sinh": _hyperbolic(-1), "cosh": _hyperbolic(1),
    "tanh": lambda x: _hyperbolic(-1)(x) / _hyperbolic(1)(x),
    "max": lambda *x: reduce(lambda a, b: (a + b + abs(a - b)) / 2, x),
    "min": lambda *x: reduce(lambda a, b: (a + b - abs(a - b)) / 2, x),
    "power": lambda base, exponent: iv.exp(iv.log(base) * exponent),
}  # fmt: skip
"""Every function of the table."""
_RULES: dict[Any, Callable[..., Interval]] = {
    sp.Add: _sum, sp.Mul: _product,
    **{SYMPY_FUNCTIONS[name]: function for name, function in FUNCTIONS.items()},
}  # fmt: skip
