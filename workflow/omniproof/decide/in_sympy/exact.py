"""Signs and differences of exact numbers in SymPy."""

from __future__ import annotations

from typing import Any

import sympy as sp

from omniproof.decide import exact
from omniproof.decide.in_sympy.balls import exact_number
from omniproof.formula.sympy_terms import term_of


def sign(number: sp.Expr) -> int:
    """Return the certain sign -1, 0 or 1 of an exact real number.

    Raises `UnsupportedError` when it is not finite, or when its being zero cannot be proved.
    """
    return exact.sign(term_of(number))


def vanishes(number: sp.Expr) -> bool:
    """Decide whether an exact real number is zero; raises `UnsupportedError` as `sign` does."""
    return sign(number) == 0


def subtract(left: Any, right: Any) -> sp.Expr:
    """Subtract without evaluation, so that nothing cancels before it has been looked at."""
    left, right = exact_number(left), exact_number(right)
    if right == 0:
        return left
    return sp.Add(left, sp.Mul(-1, right, evaluate=False), evaluate=False)
