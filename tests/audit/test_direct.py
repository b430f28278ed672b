"""Direct evaluation of the printed tree stops an engine that is wrong, and mends a witness."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
import tiny_paper

from omniproof.audit import check as checking
from omniproof.audit import confirm_decimals, identities, judge, run
from omniproof.audit.check import Finding, check
from omniproof.audit.decimals import Rounding
from omniproof.audit.readings import load_readings
from omniproof.audit.setting import Assumptions
from omniproof.decide.answer import DisagreementError, OnBranch, Proved, Refuted, Undecided, Witness
from omniproof.decide.digits import UndefinedError, value
from omniproof.decide.order import comparison
from omniproof.registry import Relation, load_registry
from omniproof.transcription.reader import read

PROVED = Proved(("broken",))
AT_1 = Witness({"x": "1"}, "1", "2")


def plant(monkeypatch: pytest.MonkeyPatch, answer: Any) -> None:
    monkeypatch.setattr(checking, "confirmed_equal", lambda *_, **__: answer)
    monkeypatch.setattr(comparison, "compare", lambda *_: answer)


@pytest.mark.parametrize(
    ("statement", "answer", "message"),
    [
        pytest.param("x = 2x", PROVED,
                     "left = right with left = -2.4, right = -4.8 at x = -12/5: ",
                     id="proved, and false"),
        pytest.param("x + 1 < x", PROVED,
                     "left < right with left = -1.4, right = -2.4 at x = -12/5: ",
                     id="a false order"),
        pytest.param(r"\sin^2 x + \cos^2 x \neq 1", PROVED,
                     r"left \neq right with left = 1, right = 1 at x = -12/5: ",
                     id="never unequal"),
        pytest.param("(x, 1) = (x, 2)", PROVED, "left = right with left = 1, right = 2 at x = ",
                     id="an entry"),
        pytest.param("x + x = 2x", Refuted(("broken",), AT_1),
                     "left = right with left = 2, right = 2 at x = 1: ", id="refuted, and true"),
        pytest.param("x < x + 1", Refuted(("broken",), AT_1),
                     "left < right with left = 1, right = 2 at x = 1: ", id="a true order"),
        pytest.param("x = 2x", OnBranch(("broken",), "", AT_1, relations=()),
                     "left = right with left = -2.4, right = -4.8 at x = -12/5: ",
                     id="a condition that does not suffice"),
    ],
)  # fmt: skip
def test_a_broken_engine_is_stopped_with_both_shown(
    monkeypatch: pytest.MonkeyPatch, statement: str, answer: Any, message: str
) -> None:
    plant(monkeypatch, answer)
    with pytest.raises(DisagreementError) as caught:
        check(statement)
    told = str(caught.value)
    assert told.startswith(f"direct evaluation contradicts broken on {message}")
    assert type(answer).__name__ in told


@pytest.mark.parametrize("answer", [PROVED, Refuted(("broken",), Witness({"x": "1"}, "", ""))])
def test_a_broken_engine_stops_an_audit(
    monkeypatch: pytest.MonkeyPatch, tiny_folder: Path, answer: Any
) -> None:
    monkeypatch.setattr(identities, "equal_to_derived", lambda *_, **__: answer)
    with pytest.raises(DisagreementError, match="direct evaluation contradicts broken"):
        run.audit_paper(tiny_folder)


AT_36_DEGREES = Witness({"phi": "pi/5"}, "", "", exact={"phi": sp.pi / 5})
AT_1_1 = Refuted(("broken",), Witness({"x": "1", "y": "1"}, "", ""))


@pytest.mark.parametrize(
    ("engine", "answer", "claim", "message"),
    [
        pytest.param("relations._confirmed", PROVED, "sec:1/shrinks",
                     "left < right with left = 2, right = 1: ", id="no order"),
        pytest.param("relations._confirmed", AT_1_1, "sec:1/grows",
                     "left > right with left = 2, right = 1: ", id="an order"),
        pytest.param("relations._confirmed", AT_1_1, "sec:1/best",
                     "left > right with left = 2, right = 1: ", id="the largest"),
        pytest.param("relations.all_equal", PROVED, "sec:1/same",
                     "left = right with left = -2.4, right = -2.143 at ", id="unequal"),
        pytest.param("relations.all_equal", AT_1_1, "sec:1/same",
                     "left = right with left = 1, right = 1 at x = 1, y = 1: ", id="equal"),
        pytest.param("judge.equivalent", AT_1_1, "eq:12",
                     "left = right with left = 1, right = 1 at x = 1, y = 1: ",
                     id="a printed condition"),
        pytest.param("judge.instance", AT_1_1, "sec:1/angles",
                     "left = right with left = 3, right = 3: ", id="printed angles"),
    ],
)  # fmt: skip
def test_a_broken_engine_is_stopped_at_a_relation(
    monkeypatch: pytest.MonkeyPatch, tiny_folder: Path, engine: str, answer: Any, claim: str,
    message: str,
) -> None:  # fmt: skip
    monkeypatch.setattr(f"omniproof.audit.{engine}", lambda *_, **__: answer)
    told = judged_wrongly(tiny_folder, claim)
    assert told.startswith(f"direct evaluation contradicts broken on {message}")


def judged_wrongly(folder: Path, claim: str) -> str:
    context = run.prepare_to_judge(folder)
    with pytest.raises(DisagreementError) as caught:
        judge.judge_claim(context.claims[claim], context)
    return str(caught.value)


@pytest.mark.parametrize(
    ("engine", "claim", "derived", "message"),
    [
        pytest.param("instance", "sec:1/angles", (tiny_paper.t, tiny_paper.t, sp.S.Zero),
                     "left = right with left = 1, right = 3: ", id="angles of no parameter"),
        pytest.param("equivalent", "eq:12", tiny_paper.x > 0,
                     "left = right with left = 1, right = 0 at x = -12/5, y = -15/7: ",
                     id="another condition"),
    ],
)  # fmt: skip
def test_what_a_broken_engine_proves_is_held_against_print(
    monkeypatch: pytest.MonkeyPatch, tiny_folder: Path, engine: str, claim: str, derived: Any,
    message: str,
) -> None:  # fmt: skip
    relations = {**tiny_paper._relations(), claim: Relation(derived)}
    monkeypatch.setattr(tiny_paper, "_relations", lambda: relations)
    monkeypatch.setattr(judge, engine, lambda *_: PROVED)
    told = judged_wrongly(tiny_folder, claim)
    assert told.startswith(f"direct evaluation contradicts broken on {message}")


@pytest.mark.parametrize(
    ("answer", "at"),
    [
        pytest.param(PROVED, r"phi = \d+/\d+", id="proved, and false"),
        pytest.param(Refuted(("broken",), Witness({"phi": "3/5"}, "", "")), "phi = 3/5",
                     id="refuted, and true"),
        pytest.param(Refuted(("broken",), AT_36_DEGREES), "phi = pi/5", id="at no rational number"),
    ],
)  # fmt: skip
def test_a_printed_chain_is_evaluated_as_it_is_printed(
    monkeypatch: pytest.MonkeyPatch, answer: Any, at: str
) -> None:
    monkeypatch.setattr(run, "load_registry", load_registry)
    monkeypatch.setattr(run, "load_readings", load_readings)
    monkeypatch.setattr(judge, "judge", lambda *_: answer)
    told = judged_wrongly(Path("paper_data/two-roller-sphere"), "sec:3/speed-chain-roller-1")
    assert re.match(f"direct evaluation contradicts broken on left < right with .* at {at}: ", told)


@pytest.mark.parametrize(
    ("value", "printed", "wrong", "message"),
    [
        pytest.param(sp.sqrt(2), "1.41", Rounding.WRONG, "rounded, 1.41 is not wrong, 1.41",
                     id="right, and called wrong"),
        pytest.param(sp.sqrt(3), "1.72", Rounding.ROUNDED, "off by one, 1.73 is not rounded, 1.73",
                     id="wrong, and called right"),
        pytest.param(sp.Integer(4), "4.1", Rounding.TIE, "off by one, 4.0 is not tie, 4.0",
                     id="no tie"),
    ],
)  # fmt: skip
def test_a_class_that_all_engines_have_wrong_is_stopped(
    monkeypatch: pytest.MonkeyPatch, value: Any, printed: str, wrong: Rounding, message: str
) -> None:
    classify = confirm_decimals.classify
    monkeypatch.setattr(
        confirm_decimals, "classify", lambda *given: replace(classify(*given), rounding=wrong)
    )
    monkeypatch.setattr(confirm_decimals, "_confirmed", lambda finding, *_: finding)
    with pytest.raises(DisagreementError, match=f"^direct evaluation contradicts.*{message}$"):
        confirm_decimals.confirmed_class(value, printed)


def test_a_witness_where_a_part_is_undefined_is_replaced(monkeypatch: pytest.MonkeyPatch) -> None:
    plant(monkeypatch, Refuted(("broken",), Witness({"x": "0"}, "0", "1")))
    found = check(r"\frac{x^2}{x} = 2x")
    assert found.verdict is Finding.ERRATUM
    assert found.witness is not None
    assert (found.witness.point, found.witness.printed) == ({"x": "-12/5"}, "-2.4")


def test_what_fails_only_where_it_is_undefined_is_not_false(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    plant(monkeypatch, Refuted(("broken",), Witness({"x": "0"}, "0", "0")))
    found = check(r"\frac{x^2}{x} \neq 0")
    message = "not decided: it was found to fail only where a printed part is not defined"
    assert (found.verdict, found.message) == (Finding.UNDECIDED, message)


@pytest.mark.parametrize(
    "statement",
    [
        pytest.param(r"\tan 90^\circ = x^2", id="a pole"),
        pytest.param(r"\arccos(x^2 + 2) = \arccos(x^2 + 2)", id="an inverse function"),
        pytest.param(r"\frac{x}{\sin^2 x + \cos^2 x - 1} = 1", id="a denominator that is 0"),
        pytest.param(r"\frac{0}{\sqrt{2} + \sqrt{3} - \sqrt{5 + 2\sqrt{6}}} = 0", id="of numbers"),
        pytest.param(r"\frac{0}{(\sqrt{x})^2 - x} = 0", id="of a root that cancels"),
        pytest.param(r"(\sqrt{x})^0 = \frac{|0|}{|0|}", id="beside a root that cancels"),
    ],
)
def test_what_is_defined_nowhere_is_not_verified(statement: str) -> None:
    assert check(statement).verdict is Finding.UNDECIDED


@pytest.mark.parametrize(
    ("statement", "verdict"),
    [
        pytest.param(r"\sin(\arccos(1 - \frac{\sqrt2}{10000000})) = 0", "erratum", id="arc cosine"),
        pytest.param(r"\tan(\arccos(1 - \frac{\sqrt3}{10^{20}})) = 0", "erratum", id="its tangent"),
        pytest.param(r"\sin(2\arccos(1 - \frac{1}{10^{12}})) = 0", "erratum", id="of the double"),
        pytest.param(r"|\arccos(1 - \frac{\sqrt2}{10000000})| = 0", "erratum", id="its size"),
        pytest.param(r"|\cot\frac{103993}{33102}| = -\cot\frac{103993}{33102}", "verified",
                     id="the sign of a cotangent near a pole"),
        pytest.param(r"|\cot(-\frac{103993}{33102})| = \cot\frac{103993}{33102}", "erratum",
                     id="of the opposite angle"),
        pytest.param(r"\sqrt{(\csc\frac{103993}{33102})^2} = \csc\frac{103993}{33102}",
                     "verified", id="the root of a square"),
        pytest.param(r"|\sec\frac{103993}{66204}| = \sec\frac{103993}{66204}", "verified",
                     id="a secant"),
        pytest.param(r"x < x + 10^{-300}", "verified", id="a tiny difference"),
        pytest.param(r"\frac{1}{10^{-50}} = 10^{50}", "verified", id="a tiny denominator"),
        pytest.param(r"\sqrt{\sin^2 x + \cos^2 x - 1} = 0", "verified", id="the root of 0"),
    ],
)  # fmt: skip
def test_what_simplification_gets_wrong(statement: str, verdict: str) -> None:
    assert check(statement).verdict == verdict


def test_the_domain_is_where_it_looks() -> None:
    found = check("x > 10^{-9}", Assumptions(between=(r"\frac{1}{100} < x < \frac{1}{50}",)))
    assert found.verdict is Finding.VERIFIED


@pytest.mark.parametrize(
    "text",
    [
        pytest.param(r"\frac{1}{\sin 180^\circ}", id="division"),
        pytest.param(r"(\sin 180^\circ)^{-2}", id="power"),
        pytest.param(r"\tan 90^\circ", id="tangent"),
        pytest.param(r"\cot 360^\circ", id="cotangent"),
        pytest.param(r"\sec 270^\circ", id="secant"),
        pytest.param(r"\csc 180^\circ", id="cosecant"),
        pytest.param(r"\sqrt{-10^{-9}}", id="root"),
        pytest.param(r"\arccos(1 + 10^{-9})", id="arc cosine"),
        pytest.param(r"\begin{pmatrix}1 & 2\\2 & 4\end{pmatrix}^{-1}", id="singular matrix"),
    ],
)
def test_digits_know_where_nothing_is_defined(text: str) -> None:
    with pytest.raises(UndefinedError):
        value(read(text), lambda *_: 0)


def test_an_answer_that_is_undecided_stays_so(monkeypatch: pytest.MonkeyPatch) -> None:
    plant(monkeypatch, Undecided("no proof", ("broken",)))
    assert check("x = 2x").message == "not decided: no proof"
