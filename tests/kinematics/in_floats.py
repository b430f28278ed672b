"""Exact matrices as floats."""

from __future__ import annotations

from typing import Any

import numpy as np
from sympy import Expr, Matrix

DIGITS = 50


def floats(matrix: Any) -> Any:
    """Return an exact matrix of numbers as an array of doubles of the same shape.

    An adjugate repeats its parts many times over, and `evalf` of the whole computes each of them
    anew: that took most of the time of these tests. Here equal parts are computed once.
    """
    exact = Matrix(matrix)
    known: dict[Expr, Expr] = {}
    return np.array([float(_value(entry, known)) for entry in exact]).reshape(exact.shape)


def _value(part: Expr, known: dict[Expr, Expr]) -> Expr:
    if part.is_Rational:  # stays exact: exponents are counted, not measured
        return part
    if part not in known:
        parts = [_value(each, known) for each in part.args]
        known[part] = (part.func(*parts) if parts else part).evalf(DIGITS)
    return known[part]
