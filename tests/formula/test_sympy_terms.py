"""SymPy to terms and back: the same expression, with the assumptions of its symbols."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from omniproof.formula.sympy_terms import Converter, UnsupportedError, positive_names, term_of
from omniproof.formula.term import Call, Power, Symbol, number, root

x, y = sp.symbols("x y", real=True)
r = sp.Symbol("r", positive=True)
speed = sp.Function("omega", real=True)

LEAVES = [x, y, r, x / 2, r - sp.pi, 2 * y, sp.Rational(-3, 7) * r]
FUNCTIONS = [sp.sin, sp.cos, sp.tan, sp.atan, sp.Abs, sp.sign, speed]
EXPRESSIONS = st.recursive(
    st.sampled_from(LEAVES),
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda pair: pair[0] + pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] * pair[1]),
        inner.map(lambda e: e**2),
        inner.map(lambda e: sp.sqrt(1 + e**2)),
        st.tuples(st.sampled_from(FUNCTIONS), inner).map(lambda pair: pair[0](pair[1])),
    ),
    max_leaves=8,
)


@given(EXPRESSIONS)
def test_an_expression_comes_back(expression: sp.Expr) -> None:
    fresh = Converter()
    fresh.term(sp.Add(*expression.free_symbols))  # what else tells it the assumptions
    assert fresh.expression(term_of(expression)) == expression


@pytest.mark.parametrize(
    ("expression", "term"),
    [
        pytest.param(sp.sqrt(x), root(Symbol("x")), id="a root"),
        pytest.param(x ** sp.Rational(3, 4), Power(root(root(Symbol("x"))), 3), id="nested roots"),
        pytest.param(1 / x, Power(Symbol("x"), -1), id="an inverse"),
        pytest.param(
            sp.cbrt(x), Call("power", (Symbol("x"), term_of(sp.Rational(1, 3)))), id="a cube root"
        ),
        pytest.param(speed(x), Call("omega", (Symbol("x"),)), id="an unknown function"),
    ],
)
def test_what_a_term_is(expression: sp.Expr, term: object) -> None:
    assert term_of(expression) == term


@pytest.mark.parametrize(
    "expression", [sp.Float(0.5) * x, sp.I * x, x / 0, sp.oo, sp.Dummy() + sp.nan, sp.gamma(x)]
)
def test_what_is_no_exact_real_number_is_refused(expression: sp.Expr) -> None:
    with pytest.raises(UnsupportedError):
        term_of(expression)


def test_assumptions_stand_beside_the_terms() -> None:
    assert term_of(r) == term_of(sp.Symbol("r", real=True)) == Symbol("r")
    assert positive_names(r * x) == {"r"}


def test_what_sympy_would_cancel_is_kept() -> None:
    kept = sp.Add(x, sp.Mul(-1, x, evaluate=False), evaluate=False)
    assert term_of(kept) != term_of(sp.Integer(0))
    assert Converter().expression(term_of(kept)) == 0


def test_where_sympy_stumbles_nothing_is_evaluated() -> None:
    """The arc sine of the sine of a number of hundreds of digits is an internal error of SymPy."""
    term = Call("arcsin", (Call("sin", (number(10**400 - 1),)),))
    assert isinstance(Converter().expression(term), sp.asin)
