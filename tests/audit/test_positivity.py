"""Branch and bound: proofs hold, refutations have a point, and giving up is said."""

import mpmath
import pytest
import sympy as sp
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.decide.order.box import Box, halves, hull
from omniproof.decide.order.intervals import condition_latex, in_degrees, pieces_of
from omniproof.decide.order.positivity import Negative, Open, Positive, prove_positive
from omniproof.decide.order.sign_chart import Chart, recognise, sign_chart
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of

x, y = sp.symbols("x y", real=True)
sin, cos, pi = sp.sin, sp.cos, sp.pi


def box(**sides) -> Box:
    return Box.of({sp.Symbol(name, real=True): side for name, side in sides.items()})


@pytest.mark.parametrize(
    ("function", "where", "zeros"),
    [
        pytest.param(2 - sin(x), box(x=(0, 7)), [], id="bounded away"),
        pytest.param(1 - sin(x), box(x=(0, 7)), [(pi / 2,)], id="zero of order two"),
        pytest.param(x - sin(x), box(x=(0, 1)), [(sp.S.Zero,)], id="zero of order three at an end"),
        pytest.param(sin(x) - x, box(x=(-1, 0)), [(sp.S.Zero,)], id="at the upper end"),
        pytest.param(sin(x) ** 4, box(x=(-1, 1)), [(sp.S.Zero,)], id="zero of order four"),
        pytest.param(x**2 - x * y + y**2, box(x=(-1, 1), y=(-1, 1)), [(0, 0)], id="quadratic form"),
        pytest.param(sp.exp(x) - x - 1, box(x=(-2, 2)), [(sp.S.Zero,)], id="tangent line"),
        pytest.param(sp.Abs(x) + 1 - cos(x), box(x=(1, 2)), [], id="kink outside"),
    ],
)
def test_positive(function, where, zeros):
    points = [tuple(sp.S.Zero + c for c in zero) for zero in zeros]
    assert isinstance(prove_positive(term_of(function), where, points), Positive)


@pytest.mark.parametrize(
    ("function", "where", "zeros"),
    [
        pytest.param(sin(x), box(x=(0, 7)), [(pi,)], id="simple zero inside"),
        pytest.param(x**3, box(x=(-1, 1)), [(sp.S.Zero,)], id="odd zero inside"),
        pytest.param(
            x**2 - 4 * x * y + y**2, box(x=(-1, 1), y=(-1, 1)), [(sp.S.Zero,) * 2], id="saddle"
        ),
        pytest.param(1 - sin(x) - sp.Rational(1, 10**9), box(x=(1, 2)), [], id="slightly negative"),
    ],
)
def test_negative_points_are_negative(function, where, zeros):
    found = prove_positive(term_of(function), where, zeros)
    assert isinstance(found, Negative)
    values = [sp.Rational(int(v.p), int(v.q)) for v in found.point]
    assert sp.N(function.subs(dict(zip(where.symbols, values, strict=True))), 30) < 0


@pytest.mark.parametrize(
    ("function", "where", "zeros"),
    [
        pytest.param(1 - sin(x), box(x=(0, 7)), [], id="zero not named"),
        pytest.param(1 - sin(x), box(x=(0, 7)), [(pi / 3,)], id="another point named"),
        pytest.param(sp.Abs(x), box(x=(-1, 1)), [(sp.S.Zero,)], id="kink at the zero"),
        pytest.param(1 / x, box(x=(-1, 1)), [], id="pole inside"),
        pytest.param((x - y) ** 2, box(x=(0, 1), y=(0, 1)), [], id="line of zeros"),
    ],
)
def test_what_is_not_proved_is_open(function, where, zeros):
    assert isinstance(prove_positive(term_of(function), where, zeros), (Open, Negative))
    assert not isinstance(prove_positive(term_of(function), where, zeros), Positive)


@settings(max_examples=40, deadline=None)
@given(*[st.integers(-3, 3)] * 4, st.integers(1, 6))
def test_agrees_with_a_fine_grid(a, b, c, d, margin):
    """Random trigonometric polynomials: the verdict is the sign of their minimum on a grid."""
    function = a * sin(x) + b * cos(x) + c * sin(2 * x) + d * cos(3 * x) + margin
    at = sp.lambdify(x, function, "math")
    lowest = min(at(k * 6.2831 / 4000 + 1e-4) for k in range(4000))
    found = prove_positive(term_of(function), box(x=(0, 2 * pi)))
    if lowest > 1e-3:
        assert isinstance(found, Positive)
    if lowest < -1e-3:
        assert isinstance(found, Negative)


def test_cells_cover_the_box():
    where = box(x=(0, pi), y=(-1, 1))
    sides = where.enclosed_sides()
    first, second = halves(where.unit_cell, sides)
    assert first[0] == (fmpq(0), fmpq(1, 2))  # pi is longer than 2
    assert second[0] == (fmpq(1, 2), fmpq(1))
    assert hull(first, sides)[0].contains(arb(1))
    assert not hull(first, sides)[0].contains(arb(2))


@pytest.mark.parametrize("sides", [(0, sp.oo), (1, 1), (2, 1), (0, sp.nan), (0, y)])
def test_no_box(sides):
    with pytest.raises(UnsupportedError):
        Box.of({x: sides})


@pytest.mark.parametrize(
    ("value", "closed"),
    [
        pytest.param(mpmath.pi / 3, pi / 3, id="angle"),
        pytest.param(-7 * mpmath.pi / 180, -7 * pi / 180, id="degrees"),
        pytest.param(0.75, sp.Rational(3, 4), id="rational"),
    ],
)
def test_closed_forms_are_recognised(value, closed):
    assert closed in list(recognise(float(value)))


def test_a_chart_of_signs():
    chart = sign_chart(term_of(sin(2 * x) * (1 - cos(x))), box(x=(-1, 4)))
    assert chart.points == (-1, 0, pi / 2, pi, 4)
    assert chart.signs == (-1, 1, -1, 1)


@pytest.mark.parametrize(
    ("function", "reason"),
    [
        pytest.param(cos(x) - x, "no closed form", id="transcendental zero"),
        pytest.param(sp.Abs(sin(x)) * 0 + x * 0, "not proved", id="zero everywhere"),
    ],
)
def test_no_chart(function, reason):
    with pytest.raises(UnsupportedError, match=reason):
        sign_chart(term_of(function), box(x=(0, 1)))


def test_pieces_join_where_they_may():
    chart = Chart((sp.S.Zero, pi / 2, pi, 2 * pi), (1, 1, -1))
    apart = pieces_of(chart, 1, lambda _: False)
    joined = pieces_of(chart, 1, lambda _: True)
    assert condition_latex(x, apart) == r"0 < x < \frac{\pi}{2} \text{ or } \frac{\pi}{2} < x < \pi"
    assert condition_latex(x, joined) == r"0 < x \leq \pi"
    assert in_degrees(x, joined) == "0° < x ≤ 180°"
    assert in_degrees(x, pieces_of(Chart((0, sp.Integer(1)), (1,)), 1, lambda _: False)) == ""
    assert joined[0].relation(x) == sp.And(sp.Lt(0, x), sp.Le(x, pi))
