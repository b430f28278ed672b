"""Order between formulas: proved, refuted at a point, or true on an exact set."""

from __future__ import annotations

import operator

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.decide.answer import OnBranch, Proved, Refuted, Undecided
from omniproof.decide.in_sympy.domain import REALS, Domain
from omniproof.decide.order.comparison import compare

x, y, A, B = sp.symbols("x y A B", real=True)
p, q = sp.symbols("p q", positive=True)
sin, cos, tan, pi, sqrt = sp.sin, sp.cos, sp.tan, sp.pi, sp.sqrt


def between(lower, upper, name="x"):
    return Domain({name: (sp.sympify(lower), sp.sympify(upper))})


POSITIVE = Domain({"p": (sp.S.Zero, sp.oo)})
TRIANGLE = Domain({"A": (sp.S.Zero, pi), "B": (sp.S.Zero, pi)})
SUM = cos(A) + cos(B) - cos(A + B)
MOTZKIN = x**4 * y**2 + x**2 * y**4 + 1
SQUARE = Domain({"x": (sp.S.Zero, sp.S.One), "y": (sp.Integer(2), sp.Integer(3))})


@pytest.mark.parametrize(
    ("left", "sign", "right", "domain"),
    [
        pytest.param(pi, "<", sp.Rational(22, 7), REALS, id="numbers"),
        pytest.param(sqrt(8), "\\leq", 2 * sqrt(2), REALS, id="equal numbers"),
        pytest.param(pi, "\\neq", sp.Rational(22, 7), REALS, id="different numbers"),
        pytest.param(sin(x), ">", sp.S.Zero, between(0, pi), id="on a range"),
        pytest.param(tan(x), ">", x, between(0, pi / 2), id="zero at an end, pole at the other"),
        pytest.param(x, "<", y, SQUARE, id="two variables"),
        pytest.param(x**2, "\\geq", sp.S.Zero, between(-1, 1), id="touching zero"),
        pytest.param(cos(x), "\\leq", sp.S.One, REALS, id="periodic, all angles"),
        pytest.param(sin(x / 2), "\\geq", -sp.S.One, REALS, id="period 4 pi"),
        pytest.param(sin(x) + cos(x), "<", sp.Rational(3, 2), REALS, id="amplitude"),
        pytest.param(x**2 + 1, ">", x, REALS, id="polynomial, all numbers"),
        pytest.param(x**2, "\\geq", 2 * x - 1, REALS, id="a square"),
        pytest.param(x**2 + y**2, "\\geq", 2 * x * y, REALS, id="a square of two variables"),
        pytest.param(p + 1 / p, "\\geq", sp.Integer(2), POSITIVE, id="half line"),
        pytest.param(1 / x, "<", sp.S.One, between(1, sp.oo), id="above 1"),
        pytest.param(x**3, "<", sp.S.Zero, between(-sp.oo, 0), id="below 0"),
        pytest.param(cos(x), "\\neq", sp.Integer(2), between(0, 1), id="never equal"),
        pytest.param(1 / x, "\\neq", sp.S.Zero, between(-1, 1), id="both signs, no zero"),
        pytest.param(x**2 + y**2, "\\neq", x * y - 1, REALS, id="never equal, two variables"),
        pytest.param(SUM, "\\leq", sp.Rational(3, 2), TRIANGLE, id="equality inside of a box"),
        pytest.param(sin(x) * sin(y), "\\leq", sp.S.One, REALS, id="two free angles"),
        pytest.param(p / 2 + q / 2, "\\geq", sqrt(p * q), POSITIVE, id="two means"),
        pytest.param(MOTZKIN, "\\geq", 3 * x**2 * y**2, REALS, id="no sum of squares"),
    ],
)
def test_true(left, sign, right, domain):
    assert isinstance(compare(left, sign, right, domain), Proved)


@pytest.mark.parametrize(
    ("left", "sign", "right", "domain", "witness"),
    [
        pytest.param(
            sqrt(2), ">", sqrt(3), REALS, "printed=1.414; derived=1.732", id="numbers"
        ),
        pytest.param(
            pi, "<", sp.Rational(31415926, 10**7), REALS,
            "printed=3.1415927; derived=3.1415926", id="digits that tell the sides apart"),
        pytest.param(
            sp.S.One, "\\neq", sp.S.One, REALS, "printed=1.000; derived=1.000", id="equal numbers"
        ),
        pytest.param(x**2, ">", sp.S.Zero, REALS, "x=0; printed=0; derived=0", id="at zero only"),
        pytest.param(
            x**2 + y**2, ">", 2 * x * y, REALS, "x=0; y=0; printed=0; derived=0", id="at the origin"
        ),
        pytest.param(
            sin(x) * sin(y), "<", sp.S.One, REALS,
            "x=-pi/2; y=-pi/2; printed=1.000; derived=1.000", id="equality at two angles"),
        pytest.param(
            (x - sp.Rational(1, 3)) ** 2 + (y - sqrt(2)) ** 2, ">", sp.S.Zero, REALS,
            "x=1/3; y=sqrt(2); printed=0; derived=0", id="equality at a root"),
        pytest.param(
            (x - sp.Rational(1, 7)) ** 2 + (y - 50) ** 2, ">", sp.Rational(1, 100), REALS,
            "x=1/7; y=50; printed=0; derived=0.01000", id="false where no sample is"),
    ],
)  # fmt: skip
def test_false(left, sign, right, domain, witness):
    found = compare(left, sign, right, domain)
    assert isinstance(found, Refuted)
    assert str(found.witness) == witness


def test_a_witness_lies_in_the_range():
    found = compare(sin(x), ">", sp.S.Zero, between(pi, 4))
    assert isinstance(found, Refuted)
    place = sp.Rational(found.witness.point["x"])
    assert pi < place < 4
    assert sin(place) < 0


def closed(lower, upper):
    ends = (True, upper != sp.oo)
    return Domain({"x": (sp.sympify(lower), sp.sympify(upper))}, closed={"x": ends})


@pytest.mark.parametrize(
    ("left", "sign", "right", "domain", "answer"),
    [
        pytest.param(x**2, "\\geq", sp.S.Zero, closed(0, sp.oo), Proved, id="half line"),
        pytest.param(x**2, ">", sp.S.Zero, between(0, sp.oo), Proved, id="open half line"),
        pytest.param(x**2, ">", sp.S.Zero, closed(0, sp.oo), Refuted, id="false at its end"),
        pytest.param(sin(x), "\\geq", sp.S.Zero, closed(0, pi), Proved, id="not strict"),
        pytest.param(sin(x), ">", sp.S.Zero, between(0, pi), Proved, id="strict on an open one"),
        pytest.param(sin(x), ">", sp.S.Zero, closed(0, pi), OnBranch, id="strict on a closed one"),
        pytest.param(cos(x), "\\neq", sp.S.Zero, between(0, pi / 2), Proved, id="no zero inside"),
        pytest.param(cos(x), "\\neq", sp.S.Zero, closed(0, pi / 2), OnBranch, id="zero at an end"),
        pytest.param(1 / x, ">", sp.S.Zero, closed(0, 1), Proved, id="undefined at an end"),
    ],
)
def test_closed_ends_belong_to_a_range(left, sign, right, domain, answer):
    assert isinstance(compare(left, sign, right, domain), answer)


@pytest.mark.parametrize(
    ("left", "sign", "right", "domain", "condition"),
    [
        pytest.param(sin(x), ">", sp.S.Zero, between(0, 2 * pi), r"0 < x < \pi", id="half circle"),
        pytest.param(
            sin(x), "\\geq", sp.S.Zero, between(0, 3 * pi), r"0 < x \leq \pi \text{ or } "
            r"2 \pi \leq x < 3 \pi", id="ends belong to it"),
        pytest.param(
            cos(x), "\\geq", sp.S.One, between(-1, 7), r"x = 0 \text{ or } x = 2 \pi", id="points"
        ),
        pytest.param(
            sin(x), "\\neq", cos(x), between(0, pi), r"x \neq \frac{\pi}{4}", id="but one point"
        ),
        pytest.param(
            sin(x) ** 2, "\\neq", sp.S.Zero, between(-1, 4), r"x \neq 0,\; x \neq \pi", id="but two"
        ),
        pytest.param(
            SUM, "<", sp.Rational(3, 2), TRIANGLE,
            r"A \neq \frac{\pi}{3} \text{ or } B \neq \frac{\pi}{3}", id="but one of a box"),
    ],
)  # fmt: skip
def test_true_on_a_set(left, sign, right, domain, condition):
    found = compare(left, sign, right, domain)
    assert isinstance(found, OnBranch)
    assert found.condition == condition
    named = {symbol.name: symbol for symbol in (left - right).free_symbols}
    place = {named[name]: sp.sympify(value) for name, value in found.witness.point.items()}
    assert sp.And(*found.relations).subs(place) == sp.false


@pytest.mark.parametrize(
    ("left", "sign", "right", "domain", "reason"),
    [
        pytest.param(
            p, ">", sin(p), POSITIVE, "no proof was found without a bounded range for each symbol",
            id="angle and number"),
        pytest.param(
            sp.exp(x + y), ">", x + y, REALS,
            "no proof was found without a bounded range for each symbol", id="no algebra"),
    ],
)  # fmt: skip
def test_undecided(left, sign, right, domain, reason):
    found = compare(left, sign, right, domain)
    assert isinstance(found, Undecided)
    assert found.reason == reason


SIGNS = {"<": operator.lt, "\\leq": operator.le, ">": operator.gt, "\\geq": operator.ge}
small = st.integers(-3, 3)


@settings(deadline=None, max_examples=60)
@given(small, small, small, st.sampled_from(sorted(SIGNS)), st.booleans())
def test_no_answer_contradicts_the_values(a, b, c, sign, bounded):
    left, right = a * x**2 + b * x, sp.Integer(c)
    domain = between(-2, 2) if bounded else REALS
    found = compare(left, sign, right, domain)
    places = [sp.Rational(k, 6) for k in range(-11, 12)]
    holds = [bool(SIGNS[sign](left.subs(x, place), right)) for place in places]
    if isinstance(found, Proved):
        assert all(holds)
    if isinstance(found, Refuted):
        point = {x: sp.Rational(found.witness.point.get("x", "0"))}
        assert not SIGNS[sign](left.subs(point), right)
    if isinstance(found, OnBranch):
        truth = [bool(sp.And(*found.relations).subs(x, place)) for place in places]
        assert truth == holds
