"""Derived expressions at random exact points."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from random import Random
from typing import Any

from mpmath import matrix, mp, mpf
from sympy import Basic, Expr, MatrixBase, Rational

from omniproof.registry import Registry

CLOSE = mpf(10) ** -25
Point = dict[str, Any]


def random_point(seed: int) -> Point:
    """Draw an exact value for whatever symbol is asked for, in -3 ... 3, positive for L."""
    random = Random(seed)

    class Drawn(dict[str, Any]):
        def __missing__(self, name: str) -> Any:
            number = mpf(random.randrange(-299, 300) or 1) / 100
            self[name] = abs(number) if name in {"L", "p", "q", "s"} else number
            return self[name]

    point = Drawn()
    for name in ("alpha_1", "alpha_2", "alpha_3", "alpha_k", "theta", "L", "V_x", "V_y", "phi_dot"):
        point[name]
    return point


def number(value: Any, point: Point) -> mpf:
    """Evaluate a derived expression at a point."""
    if not isinstance(value, Basic):
        return mpf(value)
    return mpf(at(value, point).evalf(35))


def at(value: Basic, point: Point) -> Basic:
    """Put exact numbers for all symbols."""
    symbols = sorted(value.free_symbols, key=str)
    return value.xreplace({symbol: _rational(point[symbol.name]) for symbol in symbols})


def _rational(value: mpf) -> Rational:
    fraction = Fraction(str(mp.nstr(value, 6)))
    return Rational(fraction.numerator, fraction.denominator)


def entries(value: Any) -> list[Any]:
    return list(value) if isinstance(value, (MatrixBase, matrix, list, tuple)) else [value]


def same(found: Any, expected: Any, point: Point) -> bool:
    sides = [number(entry, point) for entry in entries(found)], entries(expected)
    return len(sides[0]) == len(sides[1]) and all(
        abs(a - b) < CLOSE * (1 + abs(b)) for a, b in zip(*sides, strict=True)
    )


def digits(value: Expr, point: Point) -> str:
    """Fifteen digits of a derived expression at a point."""
    return mp.nstr(mp.mpmathify(at(value, point).evalf(20)), 15)


def uncompared(registry: Registry, claims: Iterable[str], compared: Iterable[str]) -> set[str]:
    """Claims that no compared claim shares its derivation with."""
    builds = {registry.derivations[claim].build for claim in compared}
    return {claim for claim in claims if registry.derivations[claim].build not in builds}
