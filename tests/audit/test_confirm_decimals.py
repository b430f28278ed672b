"""The class of a decimal, twice; and either computation broken on purpose."""

from fractions import Fraction
from math import ceil

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.audit import confirm_decimals, decimals
from omniproof.audit.confirm_decimals import confirmed_class
from omniproof.audit.decimals import Rounding, format_fraction
from omniproof.decide import balls
from omniproof.decide.answer import DisagreementError, Undecided
from omniproof.decide.order import enclosure
from omniproof.decide.prime_fields.zero import NonZero

pi, sqrt, cos, sin = sp.pi, sp.sqrt, sp.cos, sp.sin
MORRIE = cos(pi / 9) * cos(2 * pi / 9) * cos(4 * pi / 9)  # 1/8 exactly
SEVENTH = sp.Rational(1, 7)


@pytest.mark.parametrize(
    ("value", "printed", "rounding", "engines"),
    [
        pytest.param(sqrt(2), "1.41", Rounding.ROUNDED, "flint+mpmath", id="rounded"),
        pytest.param(-sqrt(3), "-1.7320", Rounding.TRUNCATED, "flint+mpmath", id="cut off"),
        pytest.param(-sqrt(3), "-1.74", Rounding.OFF_BY_ONE, "flint+mpmath", id="off by one"),
        pytest.param(sqrt(3), "-1.73", Rounding.WRONG, "flint+mpmath", id="wrong"),
        pytest.param(sp.Integer(4), "4.00", Rounding.EXACT, "flint+mpmath", id="plain number"),
        pytest.param(sp.Integer(5), "4", Rounding.OFF_BY_ONE, "flint+mpmath", id="whole step"),
        pytest.param(sp.Rational(9, 2), "3", Rounding.WRONG, "flint+mpmath", id="step and half"),
        pytest.param(sp.Rational(7, 1000), "0.00", Rounding.TRUNCATED, "flint+mpmath", id="to 0"),
        pytest.param(-SEVENTH, "-0.1", Rounding.ROUNDED, "flint+mpmath", id="negative fraction"),
        pytest.param(sp.Rational(1, 8), "0.12", Rounding.TIE, "flint+mpmath", id="plain tie"),
        pytest.param(MORRIE, "0.125", Rounding.EXACT, "flint+modular", id="exact, not plain"),
        pytest.param(MORRIE, "0.12", Rounding.TIE, "flint+modular", id="tie, not plain"),
        pytest.param(-MORRIE, "-0.13", Rounding.TIE, "flint+modular", id="negative tie"),
        pytest.param(
            MORRIE + sp.Rational(1, 10**50), "0.12", Rounding.TRUNCATED, "flint+mpmath",
            id="just beyond a tie",
        ),
        pytest.param(
            MORRIE + sp.Rational(1, 10**90), "0.12", Rounding.TRUNCATED, "flint",
            id="beyond 60 digits: the first engine alone",
        ),
    ],
)  # fmt: skip
def test_who_decided_is_named(value, printed, rounding, engines):
    finding = confirmed_class(value, printed)
    assert (finding.rounding, "+".join(finding.engines)) == (rounding, engines)


def test_what_is_undecided_stays_so():
    assert isinstance(confirmed_class(sp.zoo, "1.0"), Undecided)


@settings(max_examples=150)
@given(
    st.fractions(-9, 9, max_denominator=40), st.integers(0, 2), st.integers(-3, 3), st.booleans()
)
def test_both_computations_agree(value, places, off, is_root):
    """Fractions and roots beside decimals that are right, neighbours of right ones, or wrong."""
    unit = Fraction(1, 10**places)
    printed = format_fraction((round(value / unit) + off) * unit, unit)
    number = sp.Rational(value.numerator, value.denominator)
    number = sp.sign(number) * sqrt(number**2 + sp.Rational(1, 90)) if is_root else number
    assert confirmed_class(number, printed).engines == ("flint", "mpmath")


FLINT = [
    pytest.param(decimals, "_is_cut_off", lambda *_: False, sqrt(3), "1.7320", id="never cut off"),
    pytest.param(decimals, "_rounded", lambda v, u: 3 * u, sqrt(2), "1.4", id="correction"),
    pytest.param(
        balls.FUNCTIONS, "sqrt", lambda v: -v.sqrt(), sqrt(2), "1.41", id="the other root"
    ),
    pytest.param(decimals, "sign", lambda _: 0, sqrt(2), "1.41", id="all is exact"),
]
MPMATH = [
    pytest.param(enclosure.iv, "sqrt", lambda v: -(v**0.5), sqrt(2), "1.41", id="other root"),
    pytest.param(enclosure, "_power", lambda e, b, p: b, sqrt(2), "1.41", id="no root"),
    pytest.param(confirm_decimals, "floor", ceil, sqrt(2), "1.41", id="floor"),
    pytest.param(confirm_decimals, "trunc", round, sqrt(3), "1.7320", id="cut off"),
]


@pytest.mark.parametrize(("owner", "name", "broken", "value", "printed"), [*FLINT, *MPMATH])
def test_a_broken_side_is_caught_by_the_other(monkeypatch, owner, name, broken, value, printed):
    change = monkeypatch.setitem if isinstance(owner, dict) else monkeypatch.setattr
    change(owner, name, broken)
    with pytest.raises(DisagreementError, match=r"^mpmath contradicts flint on sqrt"):
        confirmed_class(value, printed)


def test_both_sides_are_shown(monkeypatch):
    monkeypatch.setattr(decimals, "_is_cut_off", lambda *_: False)
    with pytest.raises(DisagreementError) as caught:
        confirmed_class(sqrt(3), "1.7320")
    assert str(caught.value) == (
        "mpmath contradicts flint on sqrt(3) = 1.7320: truncated, 1.7321 is not off by one, 1.7321"
    )


def test_a_tie_that_is_none_is_caught(monkeypatch):
    monkeypatch.setattr(confirm_decimals, "vanishes", lambda _: NonZero(101, {}))
    with pytest.raises(DisagreementError, match=r"^modular contradicts flint on .*: neither is"):
        confirmed_class(MORRIE, "0.12")


def test_a_disagreement_stops_the_audit(monkeypatch, tiny_folder, capsys):
    from omniproof.cli import INTERNAL, main

    monkeypatch.setattr(confirm_decimals, "_class_of", lambda *_: Rounding.WRONG)
    assert main(["audit", str(tiny_folder)]) == INTERNAL == 4
    assert "mpmath contradicts flint" in capsys.readouterr().err
