"""Numbers and symbols as the functions of this package take them."""

from __future__ import annotations

from typing import TypeAlias

from sympy import Expr, Integer, cos, expand, sin

Scalar: TypeAlias = Expr | int | float


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
