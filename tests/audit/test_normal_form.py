"""The parts of the normal form: number fields, charts of the circle, radicals, nested constants."""

from fractions import Fraction
from math import isqrt, prod

import mpmath
import pytest
import sympy as sp
from flint import arb, ctx, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.decide.in_sympy.exact import sign, vanishes
from omniproof.decide.normal_form.angles import CircleChart, TangentChart, read_angle
from omniproof.decide.normal_form.constant_field import (
    ConstantField,
    field_order,
    generator_names,
    square_free_part,
)
from omniproof.decide.normal_form.conversion import Converter
from omniproof.decide.normal_form.form import NormalForm, normal_form
from omniproof.decide.normal_form.quotient_ring import QuotientRing
from omniproof.decide.normal_form.survey import survey
from omniproof.formula.errors import UnsupportedError, WorkLimitError
from omniproof.formula.monomials import expand
from omniproof.formula.sympy_terms import positive_names, term_of

x, y = sp.symbols("x y", real=True)
a = sp.Symbol("a", positive=True)
sqrt, Abs, sin, cos, pi = sp.sqrt, sp.Abs, sp.sin, sp.cos, sp.pi


def form_of(formula: sp.Expr) -> NormalForm:
    """Bring an expression of SymPy into normal form, with what it assumes of its symbols."""
    return normal_form(term_of(formula), positive=positive_names(formula))


def field(order: int, primes: set[int]) -> ConstantField:
    order = field_order(order, primes)
    return ConstantField(QuotientRing([*generator_names(order, primes), "x"]), order, primes)


def numeric(constants: ConstantField, polynomial) -> float:
    with ctx.workprec(120):
        balls = constants.balls() | {"x": arb(0)}
        names = list(constants.ring.place)
        total = arb(0)
        for exponents, coefficient in polynomial.terms():
            term = arb(fmpq(coefficient))
            for name, exponent in zip(names, exponents, strict=True):
                term *= balls[name] ** int(exponent) if exponent else 1
            total += term
        return float(total.mid())


@pytest.mark.parametrize("order", [1, 2, 3, 4, 5, 7, 9, 12, 15, 17, 180])
def test_cosines_of_rational_angles(order):
    constants = field(order, set())
    for k in range(-order, 2 * order + 1, max(1, order // 6)):
        turns = Fraction(k, order)
        assert numeric(constants, constants.cosine(turns)) == pytest.approx(
            mpmath.cospi(k / order), abs=1e-14
        )
        assert numeric(constants, constants.sine(turns)) == pytest.approx(
            mpmath.sinpi(k / order), abs=1e-14
        )


@pytest.mark.parametrize(
    ("order", "prime"),
    [(1, 2), (1, 3), (3, 3), (5, 5), (7, 7), (11, 11), (13, 13), (15, 2), (21, 3), (17, 19)],
)
def test_roots_of_primes_by_gauss_sums(order, prime):
    constants = field(order, {prime})
    root = constants.root_of_prime(prime)
    assert constants.ring.reduce(root * root) == prime
    assert numeric(constants, root) == pytest.approx(prime**0.5)


@pytest.mark.parametrize("primes", [{2}, {3}, {2, 3}, {5, 7}, {2, 3, 5, 7}])
@pytest.mark.parametrize("order", [1, 5, 7, 9, 15])
def test_generators_are_independent(order, primes):
    """The degree of the field is the product of the degrees of its relations."""
    order = field_order(order, primes)
    free = [name for name in generator_names(order, primes) if name != "g"]
    cosine = 2 * cos(pi / order)
    generators = [cosine, *(sqrt(int(name[1:])) for name in free)]
    if order <= 20 and len(free) < 2:
        primitive = sum(k * g for k, g in enumerate(generators, 1))
        degree = sp.degree(sp.minimal_polynomial(primitive, x), x)
        assert degree == sp.totient(2 * order) // 2 * 2 ** len(free)
    assert all((2 * order) % int(name[1:]) for name in free)


@given(st.integers(1, 10**6), st.integers(1, 10**4))
@settings(max_examples=60, deadline=None)
def test_square_free_parts(above, below):
    value = Fraction(above, below)
    scale, primes = square_free_part(value)
    rest = prod(primes)
    assert scale**2 * rest == value
    assert all(rest % k**2 for k in range(2, isqrt(int(rest)) + 1) if k < 50)


@pytest.mark.parametrize(
    ("argument", "multiples", "turns"),
    [
        pytest.param(
            2 * x - y / 3 + pi / 4, {x: 2, y: sp.Rational(-1, 3)}, sp.Rational(1, 4), id="mixed"
        ),
        pytest.param(2 * (x + y) - 2 * y, {x: 2}, 0, id="cancelled"),
        pytest.param(
            pi * (x + 90) / 180, {pi * x: sp.Rational(1, 180)}, sp.Rational(1, 2), id="degrees"
        ),
        pytest.param(sp.Mul(2, x + pi, evaluate=False), {x: 2}, 2, id="not multiplied out"),
        pytest.param(sp.Add(x, pi, x, evaluate=False), {x: 2}, 1, id="not collected"),
        pytest.param((1 + sqrt(2)) * pi, {sqrt(2) * pi: 1}, 1, id="irrational multiple of pi"),
        pytest.param(a * x + 1, {a * x: 1, sp.S.One: 1}, 0, id="products and numbers"),
    ],
)
def test_angles_are_linear_forms(argument, multiples, turns):
    angle = read_angle(term_of(argument))
    atoms = {next(iter(expand(term_of(atom)))): factor for atom, factor in multiples.items()}
    assert (dict(angle.multiples), angle.turns) == (atoms, turns)


@pytest.mark.parametrize("chart", [CircleChart, TangentChart])
@pytest.mark.parametrize("argument", [x, 3 * x, -2 * x + pi / 6, x / 2 + 3 * y, pi / 5 - y])
def test_both_charts_give_points_of_the_circle(chart, argument):
    converter = Converter(survey([term_of(sin(argument))]), chart)
    cosine, sine, common = converter.chart.cosine_sine(read_angle(term_of(argument)))
    ring = converter.ring
    assert ring.reduce(cosine**2 + sine**2 - common**2) == 0
    double, _, square = converter.chart.cosine_sine(read_angle(term_of(2 * argument)))
    assert ring.reduce(double * common**2 - (cosine**2 - sine**2) * square) == 0


@pytest.mark.parametrize(
    ("number", "zero"),
    [
        pytest.param(sqrt(5 + 2 * sqrt(6)) - sqrt(2) - sqrt(3), True, id="denested"),
        pytest.param(sqrt(5 + 2 * sqrt(6)) + sqrt(2) - sqrt(3), False, id="conjugate"),
        pytest.param(
            sqrt(2 + sqrt(2 + sqrt(2 + sqrt(2)))) - 2 * cos(pi / 32), True, id="three levels"
        ),
        pytest.param(
            sqrt(16 - 2 * sqrt(29) + 2 * sqrt(55 - 10 * sqrt(29)))
            - sqrt(5)
            - sqrt(11 - 2 * sqrt(29)),
            None,
            id="two nested",
        ),
        pytest.param(sqrt(sqrt(2) - 1) * sqrt(sqrt(2) + 1) - 1, True, id="dependent roots"),
        pytest.param(1 / (sqrt(2) + sqrt(3)) + sqrt(2) - sqrt(3), True, id="denominator"),
        pytest.param(1 / sqrt(3 - 2 * sqrt(2)) - sqrt(2) - 1, True, id="nested denominator"),
        pytest.param(Abs(sqrt(2) - sqrt(3)) + sqrt(2) - sqrt(3), True, id="absolute value"),
        pytest.param(sqrt(pi**2 + 2 * pi + 1) - pi - 1, True, id="pi as a symbol"),
    ],
)
def test_nested_constants(number, zero):
    with mpmath.workdps(60):
        near = abs(sp.lambdify((), number, "mpmath")()) < mpmath.mpf(10) ** -50
    assert near is (zero if zero is not None else near)
    assert vanishes(number) is near


@settings(max_examples=40, deadline=None)
@given(st.integers(1, 60), st.integers(1, 60), st.sampled_from([0, sp.Rational(1, 10**70)]))
def test_denested_pairs_vanish_and_near_misses_do_not(m, n, error):
    """sqrt(m + n + 2 sqrt(mn)) = sqrt(m) + sqrt(n)."""
    nested = sp.Pow(m + n + 2 * sqrt(m * n), sp.Rational(1, 2), evaluate=False)
    number = nested - sqrt(m) - sqrt(n) + error
    assert vanishes(number) is (error == 0)
    assert sign(number) == (1 if error else 0)


@pytest.mark.parametrize(
    ("formula", "patterns"),
    [
        pytest.param(sqrt(x**2) - x, {True, False}, id="sign of x"),
        pytest.param(sqrt(x) * sqrt(x) - x, {True}, id="root requires the sign"),
        pytest.param(Abs(x) + x + 1, {False}, id="never"),
        pytest.param(Abs(a) - a, {True}, id="positive symbol"),
        pytest.param(Abs(x**2 + 1) - x**2 - 1, {True}, id="sum of squares"),
        pytest.param(Abs(1 + sqrt(y)) - 1 - sqrt(y), {True}, id="one plus a root"),
    ],
)
def test_patterns_of_signs(formula, patterns):
    assert {truth for _, truth in form_of(formula).patterns()} == patterns


def test_a_pattern_without_a_value_is_left_out():
    """1/(x + |x|) has no value for negative x."""
    form = form_of(1 / (x + Abs(x)) - 1 / (2 * x))
    assert [truth for _, truth in form.patterns()] == [True]


@pytest.mark.parametrize(
    ("formula", "error", "reason"),
    [
        pytest.param(sqrt(-1 - x**2), UnsupportedError, "not real", id="no real point"),
        pytest.param(sqrt(x) + sqrt(-x), UnsupportedError, "not real", id="contradicting roots"),
        pytest.param(
            1 / (sin(x) ** 2 + cos(x) ** 2 - 1),
            UnsupportedError,
            "identically zero",
            id="division by zero",
        ),
        pytest.param((x + y + a + 1) ** 80, WorkLimitError, "large|grew", id="too many terms"),
        pytest.param(sin(1000 * x), WorkLimitError, "times an angle", id="multiple angle"),
        pytest.param(cos(pi / 1_000_003), WorkLimitError, "finer", id="fine angle"),
        pytest.param(
            sum(Abs(x + k) for k in range(30)), WorkLimitError, "factors", id="many signs"
        ),
        pytest.param(
            sp.Symbol("A", commutative=False), UnsupportedError, "not among", id="matrix symbol"
        ),
    ],
)
def test_limits_and_refusals(formula, error, reason):
    with pytest.raises(error, match=reason):
        form_of(formula)


def test_many_open_signs_are_a_limit():
    formula = sum(Abs(x + k) for k in range(12)) - 1
    with pytest.raises(WorkLimitError, match="signs"):
        list(form_of(formula).patterns())
