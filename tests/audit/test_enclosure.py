"""Intervals of mpmath: what they enclose, and what they leave open."""

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.decide.order.enclosure import enclose

x = sp.Symbol("x", real=True)
half = sp.Rational(1, 2)


@pytest.mark.parametrize(
    ("number", "known"),
    [
        pytest.param(sp.Integer(-4), "-4", id="integer"),
        pytest.param(sp.Rational(1, 3), mpmath.mpf(1) / 3, id="fraction"),
        pytest.param(sp.sqrt(2), mpmath.sqrt(2), id="root"),
        pytest.param(sp.Integer(2) ** sp.Rational(-3, 2), mpmath.mpf(8) ** -0.5, id="odd power"),
        pytest.param(sp.Integer(5) ** sp.Rational(1, 3), mpmath.cbrt(5), id="cube root"),
        pytest.param(3 * sp.pi - sp.E, 3 * mpmath.pi - mpmath.e, id="constants"),
        pytest.param(sp.tan(1) + sp.cot(1), mpmath.tan(1) + 1 / mpmath.tan(1), id="tangents"),
        pytest.param(sp.sec(1) * sp.csc(2), mpmath.sec(1) * mpmath.csc(2), id="secants"),
        pytest.param(sp.Abs(sp.sin(4)), -mpmath.sin(4), id="size"),
        pytest.param(sp.atan(-half), mpmath.atan(-0.5), id="arc tangent"),
        pytest.param(sp.asin(-half / 3), mpmath.asin(-mpmath.mpf(1) / 6), id="arc sine"),
        pytest.param(sp.acos(-half / 3), mpmath.acos(-mpmath.mpf(1) / 6), id="arc cosine"),
        pytest.param(sp.atan2(-1, sp.Integer(-2)), mpmath.atan2(-1, -2), id="third quadrant"),
        pytest.param(sp.exp(half) + sp.log(7), mpmath.exp(0.5) + mpmath.log(7), id="exponential"),
    ],
)
def test_a_number_is_enclosed_narrowly(number, known):
    lower, upper = enclose(number)
    assert abs(float(lower) - float(known)) < 1e-14
    assert lower <= upper < lower + Fraction(1, 10**55)


@pytest.mark.parametrize(
    "number",
    [x, sp.zoo, sp.nan, sp.oo, sp.I, sp.gamma(sp.sqrt(2)), sp.Float(2), sp.sqrt(-sp.pi),
     sp.log(-sp.pi), sp.tan(sp.pi / 2, evaluate=False), 1 / sp.Integer(0)],
    ids=str,
)  # fmt: skip
def test_what_is_no_real_number_has_no_enclosure(number):
    assert enclose(number) is None


@settings(max_examples=100)
@given(st.fractions(-9, 9, max_denominator=50), st.fractions(-9, 9, max_denominator=50))
def test_fractions_lie_in_their_enclosure(one, other):
    left, right = (sp.Rational(f.numerator, f.denominator) for f in (one, other))
    lower, upper = enclose(sp.Add(left, sp.Mul(-2, right, evaluate=False), evaluate=False))
    assert lower <= one - 2 * other <= upper
