"""The value of what a derivation gives in SymPy, to 60 digits: by mpmath, and by no engine.

A function that nobody knows (a wheel speed over time) is given a polynomial all its own: what holds
for every function holds for that one. Its slopes are small, so that roots of what it is a part of
stay smooth about the range of an integral and the quadrature of Gauss and Legendre converges.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple, TypeAlias

import sympy
from mpmath import mp
from sympy import Add, Integral, MatrixBase, Mul, S, Symbol, sympify
from sympy.core.function import AppliedUndef

from omniproof.decide.digits import (
    DIGITS,
    FUNCTIONS,
    NotEvaluatedError,
    UndefinedError,
    Value,
    integral,
    number,
    precision,
    real,
)
from omniproof.decide.direct import Place, Side, places, stands
from omniproof.decide.in_sympy.domain import Domain, in_terms
from omniproof.formula.functions import FUNCTIONS as TABLE

Found: TypeAlias = dict[tuple[Any, int], Value]


class _At(NamedTuple):
    """Where an expression is evaluated, and what has been `found` there, to how many digits."""

    point: Mapping[str, Any]
    seed: int
    found: Found


def known_value(
    known: Any, point: Mapping[str, Any], seed: int = 0, found: Found | None = None
) -> Value:
    """Evaluate what a symbol stands for, an expression or a matrix, at a point.

    The point has real numbers by name. The polynomials of unknown functions are those of a seed.
    `found` keeps, from call to call, the parts that have been evaluated at this point.
    """
    at = _At(point, seed, {} if found is None else found)
    with mp.workdps(precision()):
        if isinstance(known, MatrixBase):
            return mp.matrix([[_digits(entry, at) for entry in row] for row in known.tolist()])
        return _digits(sympify(known), at)


def _digits(node: Any, at: _At) -> Value:
    """Evaluate from the inside out, each part once."""
    key = node, mp.dps
    if key not in at.found:
        at.found[key] = _evaluated(node, at)
    return at.found[key]


def _evaluated(node: Any, at: _At) -> Value:
    """Evaluate the parts, and put them together; what mpmath has no rule for is left to SymPy."""
    if isinstance(node, Symbol) and node.name in at.point:
        return number(at.point[node.name])
    if isinstance(node, Integral):
        return _quadrature(node, at)
    rule = _DERIVED.get(type(node))
    if rule is None and not isinstance(node, AppliedUndef):
        return number(node) if node.is_Number else _by_sympy(node, at.point)
    parts = [_digits(part, at) for part in node.args]
    if rule is None:
        return mp.polyval(_polynomial(str(node.func), at.seed), *parts)
    return real(rule(*parts))


def _by_sympy(node: Any, point: Mapping[str, Any]) -> Value:
    values = {symbol: point[symbol.name] for symbol in node.free_symbols if symbol.name in point}
    found = node.evalf(precision(), subs=values, maxn=400 + precision())
    if found.is_Float or found.is_Rational:
        return number(found)
    # Where SymPy gives up at `maxn` digits, it returns an expression: that may well be a number.
    undefined = found.is_real is False or found is S.NaN
    kind = UndefinedError if undefined else NotEvaluatedError
    raise kind(f"no real value of {node}")


def _quadrature(outer: Integral, at: _At) -> Value:
    *inside, (variable, lower, upper) = outer.limits
    integrand = Integral(outer.function, *inside) if inside else outer.function

    def moved(x: Value) -> Value:
        return _digits(integrand, _At({**at.point, variable.name: x}, at.seed, {}))

    return integral(moved, *(_digits(end, at) for end in (lower, upper)))


@cache
def _polynomial(name: str, seed: int) -> tuple[Value, ...]:
    """Coefficients of a quadratic that belongs to a name, the highest first; all are positive."""
    generator = random.Random(f"{name}() {seed}")  # noqa: S311 - not secret
    with mp.workdps(DIGITS):
        parts = [mp.mpf(generator.randint(100, 2_900)) / generator.randint(1_001, 1_099)
                 for _ in range(3)]  # fmt: skip
        return parts[0] / 64, parts[1] / 8, parts[2]


_DERIVED: dict[Any, Callable[..., Value]] = {
    Add: lambda *parts: mp.fsum(parts),
    Mul: lambda *parts: mp.fprod(parts),
    type(sympy.pi): lambda: +mp.pi,
    **{getattr(sympy, TABLE[name].sympy): function for name, function in FUNCTIONS.items()},
}
"""What derived expressions are made of."""


def known_side(known: Any) -> Side:
    """Return what evaluates an expression or a matrix at a place, each part once."""
    return lambda place: known_value(known, place, found=place.found)


def is_met(condition: Any, place: Place) -> bool:
    """Whether a SymPy condition holds at a place; raises `UndefinedError` where a side has none."""
    if isinstance(condition, sympy.And | sympy.Or):
        parts = [is_met(part, place) for part in condition.args]
        return all(parts) if isinstance(condition, sympy.And) else any(parts)
    if condition in (sympy.true, sympy.false):
        return bool(condition)
    left, right = map(known_side, condition.args)
    return stands((left, _SIGNS[condition.rel_op], right), place)


_SIGNS = {"==": "=", "!=": "\\neq", "<=": "\\leq", ">=": "\\geq", "<": "<", ">": ">"}


def places_in(domain: Domain, symbols: Iterable[Symbol]) -> Iterator[Place]:
    """Yield points of a domain with a number for each symbol, as `places` does."""
    found = set(symbols)
    return places({symbol.name for symbol in found}, in_terms(domain, found))
