"""What is said of order is asked of z3, too; each engine broken on purpose is caught."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from sympy import Abs, Integer, Rational, Symbol, cos, pi, sin, sqrt, symbols

from omniproof.audit.relations import judge
from omniproof.decide.answer import (
    Answer,
    DisagreementError,
    OnBranch,
    Proved,
    Refuted,
    Undecided,
    Witness,
)
from omniproof.decide.in_sympy.domain import REALS, Domain
from omniproof.decide.order import extrema, sign_chart, signs
from omniproof.decide.order.comparison import compare
from omniproof.decide.order.confirm_order import confirmed_order, region_of
from omniproof.decide.order.positivity import Positive
from omniproof.decide.z3 import order
from omniproof.decide.z3.translation import Translation
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import ZERO
from omniproof.formula.value import Comparison
from omniproof.registry import Family, Obligation, Ordered
from omniproof.transcription.model import Form

A, B, t, x, y = symbols("A B t x y", real=True)
HALF = {t: (Integer(0), pi)}
TURN = {t: (Integer(0), 2 * pi)}
TORUS = {A: (Integer(0), 2 * pi), B: (Integer(0), 2 * pi)}
SINES = sin(A) + sin(B) - sin(A + B)
THIRD = (2 * pi / 3, 2 * pi / 3)
ROOTS = {"two": sqrt(2), "three": sqrt(3)}
CORNER = {x: (Integer(0), Integer(1)), y: (Integer(0), Integer(1))}
SQUARE = {x: (Integer(-1), Integer(2)), y: (Integer(-1), Integer(2))}


def claim(form: str, subject: Any, engines: str, kind: type, why: str, **more: Any) -> Any:
    return pytest.param(Obligation(Form(form), subject, **more), engines, kind, id=f"{form}: {why}")


BOTH = "flint+z3"
CLAIMS = [
    claim("positive", Family(sin(t), HALF), BOTH, Proved, "half a turn"),
    claim("positive", Family(sin(t), TURN), BOTH, OnBranch, "a part of a turn"),
    claim("positive", Family(-sin(t), HALF), BOTH, Refuted, "nowhere"),
    claim("positive", Family(x**2 + y**2, SQUARE), BOTH, OnBranch, "but at one point"),
    claim("negative", Family(cos(t) - 2, TURN), BOTH, Proved, "bounded away"),
    claim("positive", Family(sp.exp(t), TURN), "flint", Proved, "not algebraic"),
    claim("positive", Family(t - sin(t), TURN), "flint", Proved, "angle and number"),
    claim("positive", Family(x + y, CORNER), "z3", Proved, "a slope at a corner: z3 alone"),
    claim("chain", Ordered((-x, y), CORNER), "z3", Proved, "a slope at a corner: z3 alone"),
    claim("concave", Family(sin(t), HALF), BOTH, Proved, "half a turn"),
    claim("concave", Family(t**3, {t: (Integer(-1), Integer(1))}), BOTH, OnBranch, "a cube"),
    claim("maximum", Family(SINES, TORUS), BOTH, Proved, "three wheels", at=(THIRD,)),
    claim("maximum", Family(SINES, TORUS), BOTH, Refuted, "not here", at=((pi / 2, pi / 2),)),
    claim("minimum", Family(Abs(x) + Abs(y), SQUARE), "flint", Undecided, "a kink",
          at=((Integer(0), Integer(0)),)),
    claim("minimum", Family(cos(t), TURN), BOTH, Proved, "at half a turn", at=((pi,),)),
    claim("minimum", Family(cos(t), {t: (Integer(0), 4 * pi)}), "flint", Proved,
          "a place stands for two angles", at=((pi,), (3 * pi,))),
    claim("minimum", Family(cos(t), HALF), "flint", Refuted, "the point is outside", at=((pi,),)),
    claim("chain", Ordered((sin(t) - 1, cos(t) + 2), HALF), BOTH, Proved, "apart"),
    claim("chain", Ordered((Integer(0), cos(t), Integer(2)), HALF), BOTH, OnBranch, "in a part"),
    claim("largest", ROOTS, BOTH, Proved, "numbers", member="three"),
    claim("smallest", ROOTS, BOTH, Refuted, "numbers", member="three"),
    claim("increasing", (Integer(1), sqrt(2), Rational(3, 2)), BOTH, Proved, "numbers"),
    claim("decreasing", (pi, Integer(3)), "flint", Proved, "transcendental numbers"),
    claim("positive", (sqrt(2) - 1, Integer(0)), BOTH, Refuted, "zero is not positive"),
]  # fmt: skip


@pytest.mark.parametrize(("obligation", "engines", "kind"), CLAIMS)
def test_who_decided_is_named(obligation: Obligation, engines: str, kind: type) -> None:
    answer = judge(obligation)
    assert isinstance(answer, kind)
    assert "+".join(answer.engines) == engines


@pytest.mark.parametrize(
    ("left", "sign", "right", "engines"),
    [
        pytest.param(x**2 + 1, ">", x, BOTH, id="proved"),
        pytest.param(x**2, ">", x, BOTH, id="refuted"),
        pytest.param(cos(x), "\\leq", Integer(1), BOTH, id="periodic"),
        pytest.param(sp.exp(x**2), ">", x - 9, "flint", id="no algebra"),
        pytest.param(x**4 * y**2 + x**2 * y**4 + 1, "\\geq", 3 * x**2 * y**2, "z3", id="z3 alone"),
    ],
)
def test_comparisons_are_confirmed(left: Any, sign: str, right: Any, engines: str) -> None:
    domain = Domain({"x": (-Integer(2), Integer(2))}) if left.has(sp.exp) else REALS
    assert "+".join(compare(left, sign, right, domain).engines) == engines


WITNESS = Witness({}, "", "")
FALSE_ANSWERS = [
    pytest.param(Proved(("flint",)), cos(t), id="true, they say, of what is false"),
    pytest.param(Refuted(("flint",), WITNESS), sin(t), id="false of what is true"),
    pytest.param(OnBranch(("flint",), "", WITNESS, relations=(t < 1,)), sin(t),
                 id="a condition that is not needed"),
    pytest.param(OnBranch(("flint",), "", WITNESS, relations=(t < 2 * pi / 3,)), cos(t),
                 id="a condition that does not suffice"),
]  # fmt: skip


def asked(answer: Answer, formula: sp.Expr) -> Answer:
    """Ask z3 about an answer on a formula that is to be positive within half a turn."""
    failure = Comparison(term_of(formula), "\\leq", ZERO)
    return confirmed_order(answer, [failure], region_of(HALF, {}, (), (formula,)))


@pytest.mark.parametrize(("answer", "formula"), FALSE_ANSWERS)
def test_a_wrong_answer_is_a_disagreement(answer: Answer, formula: sp.Expr) -> None:
    with pytest.raises(DisagreementError, match=r"^z3 contradicts flint on a point with (sin|cos)"):
        asked(answer, formula)


def test_a_condition_that_suffices_is_confirmed() -> None:
    answer = OnBranch(("flint",), "", WITNESS, relations=(t < pi / 2,))
    assert asked(answer, cos(t)).engines == ("flint", "z3")


def test_a_candidate_contradicts_nothing() -> None:
    """Where an angle is also a number, the point that z3 finds may be none."""
    proved = Proved(("flint",))
    assert asked(proved, t - sin(t)) == proved


@pytest.mark.parametrize(
    ("owner", "name", "broken"),
    [
        pytest.param(sign_chart, "_sign_between", lambda *_: 1, id="signs of a chart"),
        pytest.param(signs, "prove_positive", lambda *_: Positive(), id="all is positive"),
        pytest.param(extrema, "prove_positive", lambda *_: Positive(), id="all is best"),
        pytest.param(extrema, "denominator_sign", lambda *_: -1, id="sign of the denominator"),
    ],
)
def test_broken_balls_are_caught(
    monkeypatch: pytest.MonkeyPatch, owner: Any, name: str, broken: Any
) -> None:
    monkeypatch.setattr(owner, name, broken)
    monkeypatch.setattr(extrema.Quotient, "find", lambda *_: None)
    false = [
        Obligation(Form.POSITIVE, Family(cos(t), HALF)),
        Obligation(Form.POSITIVE, Family(x * y - 5, SQUARE)),
        Obligation(Form.MINIMUM, Family(t - t**2, {t: (Integer(0), Integer(1))}),
                   ((Rational(1, 2),),)),
    ]  # fmt: skip
    with pytest.raises(DisagreementError, match=r"^z3 contradicts flint on "):
        [judge(obligation) for obligation in false]


@pytest.mark.parametrize(
    ("owner", "name", "broken"),
    [
        pytest.param(order, "_cross", lambda u, v: u[0] * v[1] + u[1] * v[0], id="arcs"),
        pytest.param(order._Search, "_turned", lambda _, angle, turn: turn, id="sums"),
        pytest.param(Translation, "_product", lambda _, *parts: parts[0], id="products"),
        pytest.param(order._Search, "_root", lambda q, *_: q._whole(q.one), id="roots"),
        pytest.param(order._Search, "_absolute", lambda q, inside: q.fraction(inside),
                     id="absolute values"),
        pytest.param(order._Search, "_bound", lambda *_: None, id="ranges"),
    ],
)  # fmt: skip
def test_a_broken_z3_is_caught(
    monkeypatch: pytest.MonkeyPatch, owner: Any, name: str, broken: Any
) -> None:
    monkeypatch.setattr(owner, name, broken)
    u = Symbol("u", real=True)
    true = [
        Obligation(Form.POSITIVE, Family(sin(t) - Rational(4, 5), {t: (pi / 3, 2 * pi / 3)})),
        Obligation(Form.POSITIVE, Family(3 - 2 * sqrt(2) * sin(A + B), TORUS)),
        Obligation(
            Form.POSITIVE, Family(1 + sin(A + B) - sin(A) * cos(B) - cos(A) * sin(B), TORUS)
        ),
        Obligation(Form.MAXIMUM, Family(SINES, TORUS), (THIRD,)),
        Obligation(Form.INCREASING, (sqrt(2), Rational(3, 2), sqrt(3))),
        Obligation(Form.POSITIVE, Family(Abs(u) + 1, {u: (Integer(-3), Integer(3))})),
        Obligation(Form.POSITIVE, Family(u, {u: (Integer(1), Integer(3))})),
        Obligation(Form.NEGATIVE, Family(2 * u * t - 2, {u: (Integer(0), Rational(1, 2)),
                                                      t: (Integer(0), Integer(1))})),
    ]  # fmt: skip
    with pytest.raises(DisagreementError, match=r"^z3 contradicts flint on "):
        [judge(obligation) for obligation in true]
