"""Enclosures against mpmath: values, derivatives, points of a domain, digits for a witness."""

import mpmath
import pytest
import sympy as sp
from flint import arb, ctx, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.decide.balls import format_ball, rational_ball, sign_of
from omniproof.decide.in_sympy.balls import compile_balls, evaluate
from omniproof.decide.in_sympy.domain import Domain
from omniproof.decide.in_sympy.sampling import sample_points
from omniproof.formula.errors import UnsupportedError

x, y = sp.symbols("x y", real=True)
p = sp.Symbol("p", positive=True)
FORMULAS = [
    pytest.param(sp.sin(x) * sp.cos(y) - sp.tan(x * y), id="trigonometric"),
    pytest.param(sp.cot(x) + sp.sec(y) - sp.csc(x + y), id="reciprocal"),
    pytest.param(sp.sqrt(x**2 + 1) / (y - 5) ** 3, id="algebraic"),
    pytest.param(sp.Abs(x) ** sp.Rational(1, 3) + sp.Abs(y) ** -2, id="powers"),
    pytest.param(sp.exp(x) + sp.log(sp.Abs(y)) + sp.E**y, id="exponential"),
    pytest.param(sp.atan(x) + sp.atan2(y, x) + sp.asin(sp.sin(y)), id="inverse"),
    pytest.param(sp.sinh(x) - sp.cosh(y) * sp.tanh(x), id="hyperbolic"),
    pytest.param(sp.pi * x + sp.Rational(22, 7) * sp.sign(y), id="constants"),
]
RATIONALS = st.fractions(-4, 4, max_denominator=40).filter(lambda q: q != 0)


def mpmath_value(expression, *values):
    with mpmath.workdps(60):
        numbers = [mpmath.mpf(v.numerator) / v.denominator for v in values]
        return mpmath.re(sp.lambdify((x, y), expression, "mpmath")(*numbers))


def contains(ball, value) -> bool:
    with ctx.workprec(240):
        return bool(ball.contains(arb(mpmath.nstr(value, 55)) + arb(0, 1e-50)))


@pytest.mark.parametrize("formula", FORMULAS)
@settings(max_examples=25, deadline=None)
@given(a=RATIONALS, b=RATIONALS)
def test_balls_enclose_values(formula, a, b):
    ball = evaluate(
        formula, {x: fmpq(a.numerator, a.denominator), y: fmpq(b.numerator, b.denominator)}
    )
    if ball.is_finite():
        assert ball.overlaps(arb(mpmath.nstr(mpmath_value(formula, a, b), 50)))
        assert ball.rad() < 1e-25 * (1 + abs(ball))


@pytest.mark.parametrize("formula", FORMULAS)
def test_wide_balls_enclose_all_their_points(formula):
    program = compile_balls([formula], (x, y))
    wide = program.run([arb(fmpq(1, 2)).union(arb(1)), arb(2).union(arb(fmpq(9, 4)))])[0]
    for a in (fmpq(1, 2), fmpq(2, 3), fmpq(1)):
        for b in (fmpq(2), fmpq(17, 8), fmpq(9, 4)):
            inside = program.run([arb(a), arb(b)])[0]
            assert not wide.is_finite() or wide.contains(inside.mid())


@pytest.mark.parametrize("formula", FORMULAS[:3])
def test_taylor_coefficients_are_derivatives(formula):
    program = compile_balls([formula], (x, y))
    point = [fmpq(1, 3), fmpq(-2, 5)]
    with ctx.workprec(160):
        found = program.taylor([arb(value) for value in point], [1, 2], 2)[0]
    along = sp.Symbol("t")
    line = formula.subs({x: sp.Rational(1, 3) + along, y: sp.Rational(-2, 5) + 2 * along})
    for order in range(3):
        exact = sp.diff(line, along, order).subs(along, 0) / sp.factorial(order)
        assert found[order].overlaps(arb(str(sp.N(exact, 40))))


def test_the_precision_is_restored():
    before = ctx.prec, ctx.cap
    evaluate(sp.sin(x), {x: fmpq(1)}, precision=500)
    compile_balls([sp.sin(x)], (x,)).taylor([arb(1)], [1], 4)
    assert (ctx.prec, ctx.cap) == before


def test_an_undefined_value_is_not_finite():
    for expression in (1 / x, sp.log(x), sp.sqrt(x - 1), sp.cot(x)):
        assert not evaluate(expression, {x: fmpq(0)}).is_finite()
    assert not compile_balls([1 / x], (x,)).taylor([arb(0, 1)], [1], 2)[0][0].is_finite()


@pytest.mark.parametrize(
    ("expression", "reason"),
    [
        pytest.param(sp.Symbol("z"), "the symbol z has no value", id="free symbol"),
        pytest.param(sp.Float(0.5), "not an exact one", id="float"),
        pytest.param(sp.zoo, "undefined value", id="complex infinity"),
        pytest.param(sp.I, "imaginary unit", id="imaginary unit"),
        pytest.param(sp.gamma(x), "gamma is not among", id="unknown function"),
        pytest.param(sp.Piecewise((x, x > 0), (0, True)), "Piecewise is not among", id="cases"),
    ],
)
def test_refusals_say_why(expression, reason):
    with pytest.raises(UnsupportedError, match=reason):
        evaluate(expression, {x: fmpq(1)})


@pytest.mark.parametrize(
    ("ball", "text"),
    [
        pytest.param(arb(2).sqrt(), "1.414", id="four digits"),
        pytest.param(-arb(2).sqrt() / 1000, "-0.001414", id="small"),
        pytest.param(arb(0), "0", id="zero"),
        pytest.param(arb.nan(), "undefined", id="not finite"),
    ],
)
def test_digits_of_a_witness(ball, text):
    assert format_ball(ball) == text


@pytest.mark.parametrize(
    ("ball", "sign"),
    [
        pytest.param(arb(1, 0.5), 1, id="positive"),
        pytest.param(arb(-1, 0.5), -1, id="negative"),
        pytest.param(arb(0), 0, id="exact zero"),
        pytest.param(arb(0, 0.5), None, id="open"),
        pytest.param(arb.nan(), None, id="undefined"),
    ],
)
def test_signs_are_certain(ball, sign):
    assert sign_of(ball) == sign


def test_points_lie_in_the_domain_and_repeat():
    domain = Domain({"x": (sp.pi / 2, sp.pi), "p": (0, sp.Rational(1, 1000))})
    points = list(sample_points([x, y, p], domain))
    assert points == list(sample_points([p, y, x], domain))
    for point in points:
        with ctx.workprec(100):
            assert arb.pi() / 2 < rational_ball(point[x]) < arb.pi()
        assert 0 < point[p] < fmpq(1, 1000)
        assert -3 <= point[y] <= 3
    assert len({str(point[x]) for point in points}) > 5


def test_points_have_small_denominators_and_no_zero():
    for point in sample_points([x, y], Domain()):
        assert all(value.q <= 20 and value != 0 for value in point.values())


@pytest.mark.parametrize(
    ("symbol", "interval", "inside"),
    [
        pytest.param(p, None, (0, 6), id="positive"),
        pytest.param(sp.Symbol("m", negative=True), None, (-6, 0), id="negative"),
        pytest.param(x, (2, sp.oo), (2, 8), id="bounded below"),
        pytest.param(x, (-sp.oo, -2), (-8, -2), id="bounded above"),
        pytest.param(p, (-1, 1), (0, 1), id="positive in an interval"),
    ],
)
def test_unbounded_symbols(symbol, interval, inside):
    domain = Domain({symbol.name: interval} if interval else {})
    for point in sample_points([symbol], domain):
        assert inside[0] < point[symbol] < inside[1]


def test_an_empty_interval_is_refused():
    with pytest.raises(UnsupportedError, match="empty"):
        next(sample_points([x], Domain({"x": (1, 1)})))


def test_without_symbols_there_is_one_point():
    assert list(sample_points([], Domain())) == [{}]
