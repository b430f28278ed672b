"""The question put to z3: encoded rightly, and asked only where it applies."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Abs, Rational, cos, cot, csc, pi, sec, sin, sqrt, tan

from omniproof.decide.balls import enclose
from omniproof.decide.z3 import equation
from omniproof.decide.z3.corners import corner
from omniproof.decide.z3.equation import STEPS, Different, Equal, NoAnswer, SmtAnswer
from omniproof.formula.sympy_terms import assumed_signs, term_of
from omniproof.formula.term import PI, Call, Symbol, Term, multiply, number
from omniproof.formula.unfold import unfold
from omniproof.transcription.reader import read

x, y, z = sp.symbols("x y z", real=True)
a, b, c = sp.symbols("a b c", positive=True)
WHEELS = sp.Matrix([[-sin(angle), cos(angle), 1] for angle in (x, y, z)]).det()


def differ_somewhere(left: sp.Expr, right: sp.Expr, steps: int = STEPS) -> SmtAnswer:
    """Ask about what a derivation gives."""
    assumed = assumed_signs(left, right)
    return equation.differ_somewhere(term_of(left), term_of(right), assumed, steps)


def printed(text: str) -> Term:
    """Read a formula; nothing in it is simplified."""
    names = {name: Symbol(name) for name in "xyz"}
    found = unfold(read(text), names, text)
    assert isinstance(found, Term)
    return found


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
        pytest.param(Abs(x), x, "abs is no rational function", id="absolute value"),
        pytest.param(sqrt(x), x, "sqrt is no rational function", id="root"),
        pytest.param(pi * x, x, "Pi is no rational formula", id="pi"),
        pytest.param(x**9, x, "the power 9 is not small", id="large power"),
        pytest.param(sin(7 * x), x, "7 times an angle is too often", id="large multiple"),
        pytest.param(sin(x * y), x, "a part of an angle is no symbol", id="product in an angle"),
        pytest.param(x + cos(pi / 7), x, "the cosine of 1/7 pi is no expression in square roots",
                     id="a heptagon"),
        pytest.param(cos(x + pi / 7), x, "the cosine of 1/7 pi is no expression in square roots",
                     id="turned"),
        pytest.param(sin(x), x, "a symbol is both angle and number: its point may not exist",
                     id="angle and number"),
        pytest.param(sp.Add(*sp.symbols("p:10")), x, "more than 9 variables", id="variables"),
        pytest.param(sp.Add(*(x**(k % 8) * y for k in range(40)), evaluate=False), x,
                     "it has more than 127 operations", id="operations"),
    ],
)  # fmt: skip
def test_not_asked(left: sp.Expr, right: sp.Expr, reason: str) -> None:
    found = differ_somewhere(left, right)
    assert isinstance(found, NoAnswer)
    assert reason in found.reason


@pytest.mark.parametrize(
    ("left", "right", "kind"),
    [
        pytest.param(r"\frac{x^4}{x^2}", "x^2", Equal, id="a quotient that cancels"),
        pytest.param("x - x + y", "y", Equal, id="terms that cancel"),
        pytest.param(r"\frac{1}{\sqrt{4} - 2}", "y", NoAnswer, id="defined nowhere"),
        pytest.param(r"\frac{1}{\sin^2 x + \cos^2 x - 1}", "y", NoAnswer,
                     id="nowhere, by Pythagoras"),
        pytest.param(r"\frac{x}{x}", "1", Equal, id="where it is defined"),
        pytest.param(r"\frac{x}{x} + \frac{1}{x - y}", r"\frac{1}{x - y} + x", Different,
                     id="false where it is defined"),
        pytest.param(r"\frac{0}{\sqrt{x}} + y", "y", Equal, id="a root times 0"),
        pytest.param(r"2\pi - (x + 2\pi)", "-x", Equal, id="a pi that cancels"),
        pytest.param(r"0\sqrt{x} + y", "z", NoAnswer, id="where a root is defined is forgotten"),
        pytest.param(r"\sin\left(x + \frac{y}{y} - 1\right)", r"\sin x", Equal,
                     id="what cancels in an angle"),
        pytest.param(r"x^0 + \left(\frac{1}{y}\right)^0", "2", Equal, id="the power 0"),
        pytest.param(r"\sqrt{12}", r"2\sqrt{3}", Equal, id="roots of numbers"),
        pytest.param(r"\sin 75^\circ", r"\frac{\sqrt{6} + \sqrt{2}}{4}", Equal, id="75 degrees"),
        pytest.param(r"\cos 555^\circ", r"-\sin 105^\circ", Equal, id="more than a turn"),
    ],
)  # fmt: skip
def test_print_is_taken_as_it_is(left: str, right: str, kind: type) -> None:
    assert isinstance(equation.differ_somewhere(printed(left), printed(right)), kind)


@pytest.mark.parametrize("steps", [12, 10, 60, 32, 48, 40])
def test_corners_of_the_circle_lie_where_they_should(steps: int) -> None:
    for k in range(-steps, 3 * steps):
        found = corner(Fraction(k, steps))
        assert found is not None
        for value, function in zip(found, ("cos", "sin"), strict=True):
            angle = Call(function, (multiply(number(Fraction(k, steps)), PI),))
            assert enclose(value).overlaps(enclose(angle))
            assert enclose(value).rad() < 1e-30


@pytest.mark.parametrize("steps", [7, 9, 11, 13, 17, 128])
def test_other_angles_have_no_corner(steps: int) -> None:
    assert corner(Fraction(1, steps)) is None


def test_the_limit_is_on_steps_and_ends_in_no_answer() -> None:
    half = 4 * sp.Mul(*(sin((p - q) / 2) for p, q in ((y, x), (z, y), (z, x))))
    assert differ_somewhere(WHEELS, half, 500) == NoAnswer("no answer within 500 steps")
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
