"""Derived expressions in the paper's own symbols."""

from __future__ import annotations

from typing import Any

import pytest
from sympy import (
    Abs,
    Expr,
    Function,
    ImmutableMatrix,
    Integer,
    Integral,
    Symbol,
    cos,
    sin,
    symbols,
)

from omniproof.audit.printing import LONGEST, Spelling

alpha, speed = Symbol("alpha_1", real=True), Symbol("v_x", real=True)
TIME = Symbol("t", real=True)
FUNCTION = Function("X_w^m", real=True)(TIME)
LONG = sin(alpha) + cos(alpha)
SPELLING = Spelling({alpha: r"\alpha_1", speed: r"\dot{x}"}, {LONG: r"\det \mathbf{A}"})


@pytest.mark.parametrize(
    ("value", "latex"),
    [
        pytest.param(speed**2, r"\dot{x}^{2}", id="a symbol as the paper prints it"),
        pytest.param(Symbol("z"), "z", id="a symbol that the paper has not"),
        pytest.param(1 / LONG, r"\frac{1}{\det \mathbf{A}}", id="a long part by its name"),
        pytest.param(8 / Abs(LONG), r"\frac{8}{\left|{\det \mathbf{A}}\right|}", id="in bars"),
        pytest.param(LONG, r"\sin {\alpha_1} + \cos {\alpha_1}", id="the long one itself in full"),
        pytest.param(
            Integral(FUNCTION, (TIME, 0, TIME)),
            r"\int\limits_{0}^{t} X^{m}_{w}(t)\, dt",
            id="an unknown function",
        ),
        pytest.param(
            sum(Function(f"v_{k}", real=True)(TIME) for k in (3, 1, 2)),
            "v_{1}(t) + v_{2}(t) + v_{3}(t)",
            id="unknown functions in the order of their names",
        ),
        pytest.param((speed, Integer(2)), r"\dot{x},\; 2", id="several values"),
        pytest.param(
            ImmutableMatrix([[speed], [1]]),
            r"\left(\begin{matrix}\dot{x}\\1\end{matrix}\right)",
            id="a column",
        ),
    ],
)
def test_latex(value: Any, latex: str) -> None:
    assert SPELLING.latex(value) == latex


def test_what_nobody_would_read_is_not_shown() -> None:
    names = symbols(f"a_1:{LONGEST}")
    short: Expr = sum(names[:10])
    assert SPELLING.latex(short).count(" + ") == 9
    assert SPELLING.latex(sum(names)) == ""
