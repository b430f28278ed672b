"""Printed decimals: rounding classes, ties, signs, and the parameters that a decimal allows."""

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.audit.decimals import (
    Rounding,
    classify,
    format_fraction,
    read_decimal,
    solve_for,
)
from omniproof.decide.answer import Undecided

t = sp.Symbol("t", real=True)
pi, sqrt, cos, sin = sp.pi, sp.sqrt, sp.cos, sp.sin
MORRIE = cos(pi / 9) * cos(2 * pi / 9) * cos(4 * pi / 9)  # 1/8 exactly
VOLUME = 8 / (2 * cos(t) + sin(2 * t))


@pytest.mark.parametrize(
    ("value", "printed", "rounding", "correction"),
    [
        pytest.param(sqrt(2), "1.41", Rounding.ROUNDED, "1.41", id="rounded down"),
        pytest.param(sqrt(2), "1.414214", Rounding.ROUNDED, "1.414214", id="rounded up"),
        pytest.param(-sqrt(3), "-1.73", Rounding.ROUNDED, "-1.73", id="negative rounded"),
        pytest.param(-sqrt(3), "-1.7320", Rounding.TRUNCATED, "-1.7321", id="negative cut off"),
        pytest.param(-sqrt(3), "-1.74", Rounding.OFF_BY_ONE, "-1.73", id="negative off by one"),
        pytest.param(8 * sqrt(3) / 3, "4.61", Rounding.TRUNCATED, "4.62", id="cut off"),
        pytest.param(8 * sqrt(3) / 3, "4.63", Rounding.OFF_BY_ONE, "4.62", id="one too many"),
        pytest.param(8 * sqrt(3) / 3, "4.60", Rounding.WRONG, "4.62", id="wrong"),
        pytest.param(8 * sqrt(3) / 3, "-4.62", Rounding.WRONG, "4.62", id="wrong sign"),
        pytest.param(sp.Integer(4), "4.00", Rounding.EXACT, "4.00", id="exact with zeros"),
        pytest.param(sp.Integer(0), "0.0", Rounding.EXACT, "0.0", id="zero"),
        pytest.param(MORRIE, "0.125", Rounding.EXACT, "0.125", id="exact, trigonometric"),
        pytest.param(MORRIE, "0.13", Rounding.TIE, "0.13", id="tie rounded up"),
        pytest.param(MORRIE, "0.12", Rounding.TIE, "0.13", id="tie rounded down"),
        pytest.param(-MORRIE, "-0.12", Rounding.TIE, "-0.13", id="negative tie"),
        pytest.param(
            MORRIE + sp.Rational(1, 10**50),
            "0.12",
            Rounding.TRUNCATED,
            "0.13",
            id="just beyond a tie",
        ),
        pytest.param(sp.Rational(1, 200), "0.00", Rounding.TIE, "0.01", id="tie at zero"),
        pytest.param(
            sp.Rational(7, 1000), "0.00", Rounding.TRUNCATED, "0.01", id="cut off to zero"
        ),
        pytest.param(sp.Integer(17), "17", Rounding.EXACT, "17", id="integer"),
        pytest.param(sp.Rational(35, 2), "17.", Rounding.TIE, "18", id="trailing point"),
        pytest.param(100 * pi, "314", Rounding.ROUNDED, "314", id="large"),
    ],
)
def test_classes(value, printed, rounding, correction):
    finding = classify(value, printed)
    assert (finding.rounding, finding.correction) == (rounding, correction)


@pytest.mark.parametrize(
    ("value", "printed", "error"),
    [
        pytest.param(sp.Integer(4), "5", "0.25", id="a quarter too large"),
        pytest.param(sp.Integer(-4), "-5", "-0.25", id="sign of the difference"),
        pytest.param(sp.Integer(0), "0.1", "", id="no relative error of zero"),
        pytest.param(sp.Rational(1, 8), "0.125", "0", id="exact"),
    ],
)
def test_relative_errors(value, printed, error):
    assert classify(value, printed).relative_error == error


def test_the_finding_shows_value_and_interval():
    finding = classify(16 * sqrt(3) / 9, "3.08")
    assert finding.interval == (Fraction("3.075"), Fraction("3.085"))
    assert str(finding.record) == "3.07920; [3.075, 3.085]"


@pytest.mark.parametrize("text", ["", "1,5", "1e3", "4.0.0", "abc", "--1", ".5", "٣.٥", "1 2"])
def test_no_decimal(text):
    with pytest.raises(ValueError, match=r"expected a decimal such as 4\.00, found"):
        read_decimal(text)


def test_a_typographic_minus_is_a_minus():
    assert read_decimal("\N{MINUS SIGN}1.50").value == Fraction(-3, 2)


@pytest.mark.parametrize("value", [t, sp.zoo, sp.nan, sp.I, sp.gamma(3 * sqrt(2)), sp.Float(2)])
def test_a_value_that_is_no_exact_number_is_undecided(value):
    assert isinstance(classify(value, "1.0"), Undecided)


@settings(max_examples=80, deadline=None)
@given(st.fractions(-50, 50, max_denominator=300), st.integers(0, 4))
def test_the_correction_is_half_away_from_zero(value, places):
    """Against Python's decimal module, on rational values."""
    from decimal import ROUND_HALF_UP, Decimal, getcontext

    getcontext().prec = 60
    exact = Decimal(value.numerator) / Decimal(value.denominator)
    wanted = exact.quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP)
    found = classify(sp.Rational(value.numerator, value.denominator), format(wanted, "f"))
    assert Fraction(found.correction) == Fraction(str(wanted))
    assert found.rounding.is_right


@settings(max_examples=80, deadline=None)
@given(st.integers(-(10**6), 10**6), st.integers(0, 6))
def test_decimals_are_read_and_written(digits, places):
    text = format_fraction(Fraction(digits, 10**places), Fraction(1, 10**places))
    assert read_decimal(text).value == Fraction(digits, 10**places)
    assert read_decimal(text).unit == Fraction(1, 10**places)


def _volume(theta: str) -> mpmath.mpf:
    theta = mpmath.mpf(theta)
    return 8 / (2 * mpmath.cos(theta) + mpmath.sin(2 * theta))


@pytest.mark.parametrize(
    ("printed", "count"),
    [
        pytest.param("3.08", 1, id="around the minimum"),
        pytest.param("4.00", 2, id="on both sides of it"),
        pytest.param("9.24", 2, id="towards the poles"),
        pytest.param("3.07", 0, id="below the minimum"),
    ],
)
def test_parameters_of_a_decimal(printed, count):
    """End points carry the bounds of the interval, outside it is missed, inside it is met."""
    lower, upper = read_decimal(printed).interval
    found = solve_for(VOLUME, t, (lower, upper), (-pi / 2, pi / 2))
    assert len(found) == count
    for left, right in found:
        for end in (left, right):
            value = _volume(end)
            nearest = min(abs(value - float(lower)), abs(value - float(upper)))
            assert nearest < abs(_volume_slope(end)) * 6e-6 * max(abs(float(end)), 1e-3)
        middle = str((float(left) + float(right)) / 2)
        assert float(lower) <= _volume(middle) <= float(upper)


def _volume_slope(theta: str) -> mpmath.mpf:
    return mpmath.diff(lambda x: _volume(str(x)), float(theta))


def test_a_touching_point_is_kept():
    assert solve_for(sin(t), t, (Fraction(1), Fraction(2)), (0, 3)) == (("1.57080", "1.57080"),)


def test_a_whole_range_can_be_the_solution():
    assert solve_for(cos(t), t, (Fraction(-2), Fraction(2)), (0, 3)) == (("0", "3.00000"),)


@pytest.mark.parametrize(
    ("expression", "box"),
    [
        pytest.param(sp.gamma(t), (0, 1), id="unknown function"),
        pytest.param(t, (0, sp.oo), id="unbounded"),
        pytest.param(t, (1, 0), id="empty"),
        pytest.param(1 / t, (-1, 1), id="pole inside"),
        pytest.param(t * sp.Symbol("u"), (0, 1), id="another symbol"),
    ],
)
def test_what_cannot_be_solved_is_undecided(expression, box):
    assert isinstance(solve_for(expression, t, (Fraction(0), Fraction(1)), box), Undecided)
