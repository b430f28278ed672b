"""Balls of SymPy's expressions, for what still has them: by way of terms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from omniproof.decide import balls
from omniproof.decide.balls import Ball, Program, as_float, format_ball, rational_ball, sign_of
from omniproof.decide.errors import UnsupportedError, WorkLimitError
from omniproof.formula.sympy_terms import NotATermError, term_of
from omniproof.formula.term import Term

__all__ = [
    "Ball", "Program", "UnsupportedError", "WorkLimitError", "as_float", "as_term", "compile_balls",
    "evaluate", "exact_number", "format_ball", "rational_ball", "sign_of",
]  # fmt: skip


def exact_number(number: Any) -> sp.Expr:
    """Turn an int into a SymPy number; leave an expression as it is, unevaluated parts included."""
    return sp.Integer(number) if isinstance(number, int) else number


def as_term(expression: Any) -> Term:
    """Return an expression as a term; raises `UnsupportedError` for what is none."""
    try:
        return term_of(sp.sympify(expression))
    except NotATermError as reason:
        raise UnsupportedError(str(reason)) from None


def compile_balls(expressions: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]) -> Program:
    """Compile expressions to one program with shared steps.

    Raises `UnsupportedError` for what has no enclosure: floats, complex numbers, unknown functions.
    """
    terms = [as_term(expression) for expression in expressions]
    return balls.compile_balls(terms, [symbol.name for symbol in symbols])


def evaluate(
    expression: sp.Expr, point: Mapping[sp.Symbol, Any] | None = None, precision: int = 128
) -> Ball:
    """Enclose an expression at a point of rational numbers, working with `precision` bits."""
    named = {symbol.name: value for symbol, value in (point or {}).items()}
    return balls.enclose(as_term(expression), named, precision)
