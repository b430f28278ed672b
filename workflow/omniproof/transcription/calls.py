"""Elementary functions in SymPy, without its wrong ideas of the signs of numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy
from sympy import Expr

FUNCTIONS: dict[str, Callable[..., Any]] = {
    "sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "cot": sympy.cot, "sec": sympy.sec,
    "csc": sympy.csc, "arcsin": sympy.asin, "arccos": sympy.acos, "arctan": sympy.atan,
    "sqrt": sympy.sqrt,
}  # fmt: skip


def _one(_argument: Expr) -> Expr:
    return sympy.S.One


_QUOTIENTS: dict[str, tuple[Callable[..., Expr], Callable[..., Expr]]] = {
    "tan": (sympy.sin, sympy.cos), "cot": (sympy.cos, sympy.sin),
    "sec": (_one, sympy.cos), "csc": (_one, sympy.sin),
}  # fmt: skip


def call(function: str, argument: Expr) -> Expr:
    """Apply a function, and keep SymPy from a wrong idea of its sign where that is a number.

    SymPy tells the signs of most functions from two digits: an arc cosine near 0 is 0 for it, and a
    cotangent near a pole may be on the wrong side. Sine, cosine and arc sine are told to the end.
    """
    value = FUNCTIONS[function](argument)
    if argument.free_symbols:
        return value
    if isinstance(value, sympy.acos) and value.is_zero:
        return sympy.pi / 2 - sympy.asin(argument)
    if function in _QUOTIENTS and value.has(FUNCTIONS[function]):
        above, below = _QUOTIENTS[function]
        return above(argument) / below(argument)
    return value
