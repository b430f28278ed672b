"""The question put to z3: encoded rightly, and asked only where it applies."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from identity_table import WHEELS, a, b, c, x, y, z
from sympy import Abs, Rational, cos, cot, csc, pi, sec, sin, sqrt, tan

from omniproof.audit.smt import Different, Equal, NoAnswer, differ_somewhere


@pytest.mark.parametrize(
    ("left", "right", "kind"),
    [
        pytest.param(sin(x + y), sin(x) * cos(y) + cos(x) * sin(y), Equal, id="addition"),
        pytest.param(sin(x - y), sin(x) * cos(y) - cos(x) * sin(y), Equal, id="subtraction"),
        pytest.param(tan(x) * cot(x), sp.S.One, Equal, id="undefined points do not count"),
        pytest.param(sec(x) / csc(x), tan(x), Equal, id="secant and cosecant"),
        pytest.param(cos(x / 2) ** 2 - sin(x / 2) ** 2, cos(x), Equal, id="half angles"),
        pytest.param(cos(x + pi / 4), (cos(x) - sin(x)) / sqrt(2), Equal, id="sqrt 2"),
        pytest.param(cos(x - pi / 6), (sqrt(3) * cos(x) + sin(x)) / 2, Equal, id="sqrt 3"),
        pytest.param(1 / (x / y), y / x, Equal, id="inverse of a fraction"),
        pytest.param((x + y) ** -2, 1 / (x**2 + 2 * x * y + y**2), Equal, id="inverse power"),
        pytest.param(sin(x), cos(x), Different, id="sine is not cosine"),
        pytest.param(sin(x), -sin(x), Different, id="sign"),
        pytest.param(a * cos(x), b * cos(x), Different, id="index"),
        pytest.param(x**2 + y**2, (x + y) ** 2, Different, id="the freshman's dream"),
        pytest.param(cos(x + pi / 3), cos(x) / 2 - sin(x) / 2, Different, id="a root is missing"),
    ],
)
def test_decided(left: sp.Expr, right: sp.Expr, kind: type) -> None:
    assert isinstance(differ_somewhere(left, right), kind)
    assert isinstance(differ_somewhere(right, left), kind)


@pytest.mark.parametrize(
    ("left", "right", "reason"),
    [
        pytest.param(Abs(x), x, "Abs(x) is no rational formula", id="absolute value"),
        pytest.param(sqrt(x), x, "sqrt(x) is not a small integer power", id="root"),
        pytest.param(x**9, x, "x**9 is not a small integer power", id="large power"),
        pytest.param(sin(7 * x), x, "7 times an angle is too often", id="large multiple"),
        pytest.param(sin(x * y), x, "x*y in an angle is no symbol", id="product in an angle"),
        pytest.param(x + cos(pi / 7), x, "cos(pi/7) is no expression", id="a heptagon"),
        pytest.param(cos(x + pi / 7), x, "cos(pi/7) is no expression in square roots", id="turned"),
        pytest.param(x / 0, x, "zoo", id="division by zero"),
        pytest.param(sin(x), x, "a symbol is both angle and number: its point may not exist",
                     id="angle and number"),
        pytest.param(sp.Add(*sp.symbols("p:10")), x, "more than 9 variables", id="variables"),
        pytest.param(sp.Add(*(x**k * y for k in range(30))), x,
                     "it has more than 80 operations", id="operations"),
    ],
)  # fmt: skip
def test_not_asked(left: sp.Expr, right: sp.Expr, reason: str) -> None:
    found = differ_somewhere(left, right)
    assert isinstance(found, NoAnswer)
    assert reason in found.reason


def test_the_limit_is_on_steps_and_ends_in_no_answer() -> None:
    half = 4 * sp.Mul(*(sin((p - q) / 2) for p, q in ((y, x), (z, y), (z, x))))
    wheels = WHEELS.subs(dict(zip(sorted(WHEELS.free_symbols, key=str), (x, y, z), strict=True)))
    assert differ_somewhere(wheels, half, 500) == NoAnswer("no answer within 500 steps")
    assert isinstance(differ_somewhere(sin(x) ** 2, 1 - cos(x) ** 2), Equal)


def test_positive_symbols_are_positive() -> None:
    found = differ_somewhere(a * b, -a * b)
    assert isinstance(found, Different)
    values = {name.split()[0]: Fraction(value) for name, value in found.model.items()}
    assert min(values.values()) > 0


def test_a_model_is_a_counterexample() -> None:
    found = differ_somewhere(sin(2 * x), sin(x))
    assert isinstance(found, Different)
    cosine, sine = (mpmath.mpf(eval_algebraic(found.model[f"{f} x/1 (0)"])) for f in ("cos", "sin"))
    assert abs(cosine**2 + sine**2 - 1) < 1e-8
    assert abs(2 * sine * cosine - sine) > 1e-8


def eval_algebraic(shown: str) -> mpmath.mpf:
    """Read a rational number, or an algebraic one of which z3 shows ten digits."""
    above, _, below = shown.rstrip("?").partition("/")
    return mpmath.mpf(above) / mpmath.mpf(below or 1)


FUNCTIONS = [sin(x), cos(x), sin(y), cos(x + y), a, b, c * sin(x - y), Rational(1, 2), cos(2 * x)]


@st.composite
def formulas(draw: st.DrawFn) -> sp.Expr:
    """A sum of two products of functions with small coefficients."""
    pair = st.tuples(st.integers(-3, 3), *[st.integers(0, len(FUNCTIONS) - 1)] * 2)
    terms = draw(st.lists(pair, min_size=1, max_size=2))
    return sp.Add(*(n * FUNCTIONS[i] * FUNCTIONS[j] for n, i, j in terms))


def vanishes_numerically(formula: sp.Expr) -> bool:
    """Whether a formula is zero at two points, to 40 of 50 digits."""
    names = {s: sp.Symbol(s.name) for s in formula.free_symbols}
    function = sp.lambdify(sp.symbols("x y a b c"), formula.xreplace(names), "mpmath")
    with mpmath.workdps(50):
        points = [("0.7", "1.9", "2.3", "0.4", "1.1"), ("-1.3", "0.4", "0.9", "1.7", "3.1")]
        return all(abs(function(*map(mpmath.mpf, point))) < 1e-40 for point in points)


@settings(max_examples=60, deadline=None)
@given(formulas(), formulas())
def test_answers_agree_with_50_digits(p: sp.Expr, q: sp.Expr) -> None:
    found = differ_somewhere(p, q)
    if not isinstance(found, NoAnswer):
        assert isinstance(found, Equal) == vanishes_numerically(p - q)


@settings(max_examples=40, deadline=None)
@given(formulas())
def test_expanded_formulas_are_not_different(p: sp.Expr) -> None:
    assert not isinstance(differ_somewhere(p, sp.expand(sp.expand_trig(p))), Different)
