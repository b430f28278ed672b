"""Signs of exact numbers: balls at rising precision, and the normal form where they meet zero."""

from __future__ import annotations

from typing import Any

import sympy as sp

from omniproof.audit.balls import evaluate, exact_number
from omniproof.decide.balls import sign_of
from omniproof.decide.normal_form.form import normal_form
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of

PRECISIONS = (64, 256, 1_024, 4_096)


def sign(number: sp.Expr) -> int:
    """Return the certain sign -1, 0 or 1 of an exact real number.

    Raises `UnsupportedError` when it is not finite, or when its being zero cannot be proved.
    """
    for precision in PRECISIONS:
        ball = evaluate(number, precision=precision)
        certain = sign_of(ball)
        if certain is not None:
            return certain
        if precision == PRECISIONS[1]:
            if not ball.is_finite():
                raise UnsupportedError(f"{number} is not a finite real number")
            if normal_form(term_of(number)).is_zero:
                return 0
    raise UnsupportedError(f"{number} is too small for its sign to be told")


def vanishes(number: sp.Expr) -> bool:
    """Decide whether an exact real number is zero; raises `UnsupportedError` as `sign` does."""
    return sign(number) == 0


def subtract(left: Any, right: Any) -> sp.Expr:
    """Subtract without evaluation, so that nothing cancels before it has been looked at."""
    left, right = exact_number(left), exact_number(right)
    if right == 0:
        return left
    return sp.Add(left, sp.Mul(-1, right, evaluate=False), evaluate=False)
