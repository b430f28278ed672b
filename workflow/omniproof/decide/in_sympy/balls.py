"""Balls of SymPy's expressions, for what still has them: by way of terms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp
from flint import fmpq

from omniproof.decide import balls
from omniproof.decide.balls import Ball, Program
from omniproof.formula.sympy_terms import term_of


def exact_number(number: Any) -> sp.Expr:
    """Turn an int or a fraction of FLINT into a SymPy number; leave an expression as it is."""
    if isinstance(number, fmpq):
        return sp.Rational(int(number.numerator), int(number.denominator))
    return sp.Integer(number) if isinstance(number, int) else number


def compile_balls(expressions: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]) -> Program:
    """Compile expressions to one program with shared steps.

    Raises `UnsupportedError` for what has no enclosure: floats, complex numbers, unknown functions.
    """
    return balls.compile_balls(list(map(term_of, expressions)), [s.name for s in symbols])


def evaluate(
    expression: sp.Expr, point: Mapping[sp.Symbol, Any] | None = None, precision: int = 128
) -> Ball:
    """Enclose an expression at a point of rational numbers, working with `precision` bits."""
    named = {symbol.name: value for symbol, value in (point or {}).items()}
    return balls.enclose(term_of(expression), named, precision)
