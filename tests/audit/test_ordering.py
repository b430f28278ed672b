"""Exact order of numbers, with ties that no number of digits would show."""

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.decide.answer import Proved, Refuted, Undecided
from omniproof.decide.order.ordering import compare, extreme_members, is_extreme, monotone
from omniproof.formula.errors import UnsupportedError

sqrt, pi = sp.sqrt, sp.pi
NESTED = sqrt(5 + 2 * sqrt(6))  # sqrt(2) + sqrt(3)
TYPES = {"X": 16 * sqrt(3) / 9, "Y": sp.Integer(4), "Z": 16 * sqrt(3) / 3}
TIED = {"first": NESTED, "second": sqrt(2) + sqrt(3), "third": sp.Integer(1)}


@pytest.mark.parametrize(
    ("left", "right", "order"),
    [
        pytest.param(sqrt(2), sqrt(3), -1, id="less"),
        pytest.param(pi, sp.Rational(355, 113), -1, id="close"),
        pytest.param(NESTED, sqrt(2) + sqrt(3), 0, id="tie of nested roots"),
        pytest.param(NESTED + sp.Rational(1, 10**60), sqrt(2) + sqrt(3), 1, id="nearly a tie"),
        pytest.param(sp.Integer(1), sp.Integer(1), 0, id="the same"),
    ],
)
def test_compare(left, right, order):
    assert compare(left, right) == order
    assert compare(right, left) == -order


@pytest.mark.parametrize("number", [sp.Symbol("x"), sp.zoo, sp.nan, sp.I, sp.oo])
def test_what_is_no_number_cannot_be_compared(number):
    with pytest.raises(UnsupportedError):
        compare(number, sp.Integer(1))


def test_monotone_sequences():
    assert isinstance(monotone([sp.Integer(1), sqrt(2), sqrt(3)], 1), Proved)
    assert isinstance(monotone([sqrt(3), sqrt(2)], -1), Proved)
    refuted = monotone([sp.Integer(1), NESTED, sqrt(2) + sqrt(3)], 1)
    assert isinstance(refuted, Refuted)
    assert refuted.witness.point == {"first": "2", "second": "3"}
    assert isinstance(monotone([sp.Integer(1), sp.Symbol("x")], 1), Undecided)


def test_extreme_members():
    assert extreme_members(TYPES, 1) == ("Z",)
    assert extreme_members(TYPES, -1) == ("X",)
    assert extreme_members(TIED, 1) == ("first", "second")
    assert isinstance(extreme_members({"a": sp.nan, "b": pi}, 1), Undecided)


def test_a_tie_is_no_only_extreme():
    assert isinstance(is_extreme(TYPES, "Z", 1), Proved)
    assert isinstance(is_extreme(TIED, "third", -1), Proved)
    refuted = is_extreme(TIED, "first", 1)
    assert isinstance(refuted, Refuted)
    assert refuted.witness.point == {"member": "second"}
    with pytest.raises(KeyError):
        is_extreme(TYPES, "W", 1)


def test_the_witness_is_the_best_of_the_others():
    assert is_extreme(TYPES, "X", 1).witness.point == {"member": "Z"}
    assert is_extreme(TYPES, "Z", -1).witness.point == {"member": "X"}
    assert isinstance(is_extreme({"alone": sp.Integer(1)}, "alone", 1), Proved)


@settings(max_examples=60, deadline=None)
@given(*[st.tuples(st.integers(-9, 9), st.integers(1, 40), st.integers(1, 9))] * 2)
def test_order_agrees_with_mpmath(left, right):
    numbers = [a * sqrt(b) / c for a, b, c in (left, right)]
    with mpmath.workdps(60):
        floats = [a * mpmath.sqrt(b) / c for a, b, c in (left, right)]
        gap = floats[0] - floats[1]
    assert compare(*numbers) == (0 if abs(gap) < 1e-50 else 1 if gap > 0 else -1)
