"""Where an exact number lies, by the interval arithmetic of mpmath: rigorous, and without FLINT.

The first engine encloses numbers by balls of Arb, and everything it says of a decimal or of an
order hangs on them. These intervals are computed from the same expression by other code (mpmath's
own, on Python's integers), so that a fault of either side shows as two enclosures that exclude each
other. Ends are handed out as fractions: what is concluded from them needs no rounding.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, TypeAlias

import sympy as sp
from mpmath import iv, libmp

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
    if type(node) not in _FUNCTIONS or not parts:
        raise NotEnclosedError(str(node))
    return _FUNCTIONS[type(node)](*parts)


def _power(exponent: Any, base: Interval, power: Interval) -> Interval:
    if exponent.is_Integer:
        return base ** int(exponent)
    if exponent.is_Rational and exponent.q == 2:
        return iv.sqrt(base) ** int(exponent.p)
    return iv.exp(iv.log(base) * power)


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

_FUNCTIONS: dict[Any, Callable[..., Interval]] = {
    sp.Add: _sum, sp.Mul: _product, sp.Abs: abs,
    sp.sin: iv.sin, sp.cos: iv.cos, sp.tan: iv.tan, sp.cot: iv.cot, sp.sec: iv.sec, sp.csc: iv.csc,
    sp.exp: iv.exp, sp.log: iv.log, sp.atan2: iv.atan2,
    # mpmath has intervals of the angle of a point only; the inverse functions are such angles.
    sp.atan: lambda x: iv.atan2(x, iv.mpf(1)),
    sp.asin: lambda x: iv.atan2(x, iv.sqrt(1 - x**2)),
    sp.acos: lambda x: iv.atan2(iv.sqrt(1 - x**2), x),
}  # fmt: skip
