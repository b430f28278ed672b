"""Roots over roots: factors that depend on each other, and signs that follow from sizes."""

import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st
from identity_table import RADIUS, a, x, y

from omniproof.decide.answer import OnBranch, Proved, Refuted, Undecided
from omniproof.decide.in_sympy.equality import decide_equal
from omniproof.decide.normal_form.survey import survey
from omniproof.formula.sympy_terms import term_of

SMALL = st.integers(-3, 3)


@settings(max_examples=30, deadline=None)
@given(*[SMALL] * 5)
@example(0, 1, 1, 0, 0)
def test_conjugates_multiply_to_their_norm(k, m, n, u, v):
    """|A + B w| |A - B w| = |A^2 - B^2 w^2|, and not that plus one."""
    left, right, square = k + m * x + n * y, u + v * y, a**2 + x**2 + 1
    root = sp.sqrt(square)
    product = sp.Abs(left + right * root) * sp.Abs(left - right * root)
    norm = sp.Abs(left**2 - right**2 * square)
    assert isinstance(decide_equal(product, norm), Proved)
    assert isinstance(decide_equal(product, norm + 1), Refuted)


@settings(max_examples=30, deadline=None)
@given(SMALL, SMALL)
@example(1, 1)
@example(-3, 3)
def test_the_larger_part_has_the_sign(m, n):
    """As x^2 <= x^2 + y^2, the sign of m x + n sqrt(x^2 + y^2) is that of n where |n| >= |m|."""
    total = m * x + n * RADIUS
    found = decide_equal(sp.Abs(total), total)
    assert isinstance(found, Proved) == (n >= abs(m))
    assert isinstance(found, Refuted) == (n < 0 and -n >= abs(m))


@pytest.mark.parametrize(
    ("left", "right", "condition"),
    [
        pytest.param(
            sp.sqrt((RADIUS - x) / (RADIUS + x)), (RADIUS - x) / y, "y > 0", id="sign of a symbol"
        ),
        pytest.param(
            sp.sqrt((RADIUS - x) * (RADIUS + x)), -y, r"- y \geq 0", id="the other sign of it"
        ),
        pytest.param(
            sp.sqrt(RADIUS - x) * sp.sqrt(RADIUS + x) * sp.Abs(x),
            x * y,
            r"x y \geq 0",
            id="sign of a product",
        ),
        pytest.param(
            sp.sqrt(sp.sqrt(a + x**2) - sp.sqrt(a)) * sp.sqrt(sp.sqrt(a + x**2) + sp.sqrt(a)),
            x,
            r"x \geq 0",
            id="conjugates over two roots",
        ),
    ],
)
def test_conditions_are_found_through_nested_roots(left, right, condition):
    found = decide_equal(left, right)
    assert isinstance(found, OnBranch)
    assert found.condition == condition


@pytest.mark.parametrize(
    ("expression", "independent"),
    [
        pytest.param(x + sp.pi * sp.sin(2 * x), True, id="a symbol as an angle and as a number"),
        pytest.param(sp.sin(x * y) + sp.cos(x**2 / y), True, id="angles that are monomials"),
        pytest.param(sp.sin(sp.pi * x / 180), True, id="degrees"),
        pytest.param(sp.sin(sp.Abs(x)) - sp.sin(x), False, id="equal for positive x"),
        pytest.param(sp.sin(2 * sp.atan(x)), False, id="an angle that has its sine elsewhere"),
        pytest.param(sp.exp(x) + sp.exp(2 * x), False, id="functions that are read as symbols"),
        pytest.param(a + a ** sp.Rational(1, 3), False, id="a cube root"),
        pytest.param(sp.sin(1) * x, False, id="the sine of a number"),
    ],
)
def test_who_is_algebraically_independent(expression, independent):
    assert survey([term_of(expression)]).is_independent is independent


@pytest.mark.parametrize(
    ("side", "kind"),
    [
        pytest.param(a, Proved, id="a symbol"),
        pytest.param(a ** sp.Rational(1, 3), Undecided, id="what may depend on a symbol"),
    ],
)
def test_only_independent_factors_are_divided_by(side, kind):
    """A factor that vanishes for some values of another one is no divisor."""
    hypotenuse = sp.sqrt(side**2 + y**2)
    product = sp.sqrt(hypotenuse - side) * sp.sqrt(hypotenuse + side)
    assert isinstance(decide_equal(product, sp.Abs(y)), kind)
