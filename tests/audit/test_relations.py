"""Every form of a statement, once true and once false, each decided by hand."""

from __future__ import annotations

from typing import Any

import pytest
from sympy import Abs, Integer, Rational, cos, pi, sin, sqrt, symbols

from omniproof.audit.relations import judge, merge
from omniproof.decide.answer import OnBranch, Proved, Refuted, Undecided
from omniproof.registry import Curve, Family, Obligation, Ordered
from omniproof.transcription.model import Form

x, y, t = symbols("x y t", real=True)
TURN = {t: (Integer(0), 2 * pi)}
SQUARE = {x: (-Integer(1), Integer(2)), y: (-Integer(1), Integer(2))}
HALF = {t: (Integer(0), pi)}
ROOTS = {"one": Integer(1), "two": sqrt(2), "three": sqrt(3)}


def true(form: str, subject: Any, why: str, **more: Any) -> Any:
    return pytest.param(Obligation(Form(form), subject, **more), Proved, id=f"{form}: {why}")


def false(form: str, subject: Any, why: str, **more: Any) -> Any:
    return pytest.param(Obligation(Form(form), subject, **more), Refuted, id=f"not {form}: {why}")


STATEMENTS = [
    true("increasing", (Integer(1), sqrt(2), Rational(3, 2)), "1 < 1.414 < 1.5"),
    false("increasing", (Integer(1), sqrt(2), Rational(7, 5)), "1.414 > 1.4"),
    false("increasing", (sqrt(8), 2 * sqrt(2)), "both are one number"),
    true("decreasing", (pi, Rational(22, 7) - Rational(1, 100)), "3.1416 > 3.1329"),
    false("decreasing", (pi, Rational(22, 7)), "pi < 22/7"),
    true("equal", (sin(2 * x), 2 * sin(x) * cos(x)), "double angle"),
    false("equal", (sin(2 * x), 2 * sin(x)), "for x = pi/2 it is 0 and 2"),
    false("equal", (x, x, x + y), "only the last one differs"),
    true("largest", ROOTS, "sqrt 3 is", member="three"),
    false("largest", ROOTS, "sqrt 2 is not", member="two"),
    false("largest", {"a": sqrt(12), "b": 2 * sqrt(3)}, "a tie has no largest", member="a"),
    true("smallest", ROOTS, "1 is", member="one"),
    false("smallest", ROOTS, "sqrt 3 is not", member="three"),
    true("positive", (pi - 3, sqrt(2) - Rational(7, 5)), "3.14 - 3 and 1.414 - 1.4"),
    false("positive", (Integer(1), Integer(0)), "zero has no sign"),
    true("negative", (3 - pi,), "3 - 3.14"),
    false("negative", (Integer(-1), Integer(1)), "one is positive"),
    true("positive", Family(2 + sin(t), TURN), "2 + sin is at least 1"),
    false("positive", Family(-2 - cos(t), TURN), "-2 - cos is at most -1"),
    true("negative", Family(-2 - cos(t), TURN), "-2 - cos is at most -1"),
    false("negative", Family(2 + sin(t), TURN), "2 + sin is at least 1"),
    true("minimum", Family(cos(t), TURN), "cos is least at pi", at=((pi,),)),
    false("minimum", Family(cos(t), TURN), "cos is not least at pi/2", at=((pi / 2,),)),
    false("minimum", Family(sin(t) ** 2 + t * 0, {t: (-pi / 2, 3 * pi / 2)}),
          "sin^2 vanishes at 0 and at pi", at=((Integer(0),),)),
    true("maximum", Family(sin(t), TURN), "sin is largest at pi/2", at=((pi / 2,),)),
    false("maximum", Family(sin(t), TURN), "sin is not largest at 120 degrees",
          at=((2 * pi / 3,),)),
    true("concave", Family(sin(t), HALF), "-sin t is negative on 0 ... pi"),
    false("concave", Family(t**2, HALF), "the second derivative is 2"),
    true("line", Curve((t, 2 * t), TURN), "y = 2x"),
    false("line", Curve((t, t**2), TURN), "a parabola"),
    true("circle", Curve((cos(t), sin(t)), TURN), "by definition"),
    false("circle", Curve((cos(t), 2 * sin(t)), TURN), "an ellipse"),
    true("ellipse", Curve((cos(t), 2 * sin(t)), TURN), "by definition"),
    false("ellipse", Curve((t, t**2), TURN), "a parabola"),
    true("chain", Ordered((sin(t), t), HALF), "sin t < t"),
    false("chain", Ordered((t, sin(t)), HALF), "t > sin t"),
    true("chain", Ordered((-x * x - 1, y * y), SQUARE), "of two variables"),
    false("chain", Ordered((-x * x, y * y), SQUARE), "equal at the origin"),
    true("chain", Ordered((Integer(0), Abs(sin(t)) / 2, Abs(sin(t))), HALF), "absolute values"),
    false("chain", Ordered((2 * cos(t), sin(t)), HALF), "from arctan 2 on, of no known form"),
]  # fmt: skip


@pytest.mark.parametrize(("obligation", "expected"), STATEMENTS)
def test_judge(obligation: Obligation, expected: type) -> None:
    answer = judge(obligation)
    assert isinstance(answer, expected), answer
    assert answer.engines


@pytest.mark.parametrize(
    ("form", "condition"),
    [
        pytest.param(Form.POSITIVE, r"0 < t < \pi", id="the sine is positive before pi"),
        pytest.param(Form.NEGATIVE, r"\pi < t < 2 \pi", id="and negative beyond"),
        pytest.param(Form.CONCAVE, r"0 < t \leq \pi", id="and concave before pi"),
    ],
)
def test_what_holds_on_a_part_of_the_box_says_where(form: Form, condition: str) -> None:
    answer = judge(Obligation(form, Family(sin(t), TURN)))
    assert isinstance(answer, OnBranch)
    assert answer.condition == condition


@pytest.mark.parametrize("form", Form)
def test_every_form_is_judged_true_and_false(form: Form) -> None:
    if form in {Form.EQUIVALENT, Form.INSTANCE}:  # conditions and angles: below
        return
    seen = {p.values[1] for p in STATEMENTS if p.values[0].form is form}
    assert seen == {Proved, Refuted}


def test_a_false_sequence_names_the_neighbours_and_a_false_member_all_values() -> None:
    sequence = judge(Obligation(Form.INCREASING, (Integer(1), Integer(3), Integer(2))))
    member = judge(Obligation(Form.LARGEST, ROOTS, member="two"))
    assert isinstance(sequence, Refuted)
    assert str(sequence.witness) == "first=2; second=3; printed=3.00000; derived=2.00000"
    assert isinstance(member, Refuted)
    assert str(member.witness) == (
        "one=1.00000; two=1.41421; three=1.73205; printed=1.41421; derived=1.73205"
    )


@pytest.mark.parametrize(
    ("obligation", "reason"),
    [
        pytest.param(Obligation(Form.CONCAVE, (x,)), "the form concave is not judged on a sequence",
                     id="a sequence is not concave"),
        pytest.param(Obligation(Form.EQUAL, Family(t, HALF)),
                     "the form equal is not judged on a family", id="a family is not equal"),
        pytest.param(Obligation(Form.LARGEST, {"a": Integer(1)}, member="b"),
                     "the form largest with the member b is not judged on {'a'}",
                     id="no such member"),
        pytest.param(Obligation(Form.EQUAL, (x,)), "one value is compared with nothing",
                     id="one value"),
        pytest.param(Obligation(Form.EQUAL, 7), "the form equal is not judged on a int",
                     id="a bare number"),
    ],
)  # fmt: skip
def test_a_form_on_the_wrong_subject_is_undecided(obligation: Obligation, reason: str) -> None:
    assert judge(obligation) == Undecided(reason)


def test_a_sequence_that_is_no_number_is_undecided() -> None:
    assert isinstance(judge(Obligation(Form.POSITIVE, (x,))), Undecided)


def test_merge_names_the_engines_in_the_order_of_the_ledger():
    assert merge(("signs", "z3"), ("flint",), ("modular", "flint")) == (
        "flint", "modular", "z3", "signs",
    )  # fmt: skip


def test_absolute_values_are_compared_on_all_branches() -> None:
    assert not isinstance(judge(Obligation(Form.EQUAL, (Abs(x), x))), Proved)
    assert isinstance(judge(Obligation(Form.EQUAL, (Abs(x) ** 2, x**2))), Proved)
