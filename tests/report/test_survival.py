from __future__ import annotations

from typing import Any

import pytest
from sympy import sympify

from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.corrected.formula import Formula
from omniproof.report.derived import Derived
from omniproof.report.survival import Fate, conclusions, fate, faults, replaced
from omniproof.transcription.model import Kind


def row(claim: str, verdict: Verdict = Verdict.VERIFIED, follows: str = "", **more: Any) -> Row:
    kind = more.pop("kind", Kind.IDENTITY if claim.startswith("eq") else Kind.RELATION)
    fields = {"paper": "p", "where": claim, "kind": kind, "follows": follows}
    return Row(id=claim, verdict=verdict, **fields, **more)


def ledger(*rows: Row) -> Ledger:
    return Ledger(paper="p", claims=len(rows), rows=rows)


@pytest.mark.parametrize(
    ("found", "expected"),
    [
        pytest.param(row("eq:1"), Fate.STANDS, id="verified"),
        pytest.param(row("eq:1", follows="eq:0"), Fate.MENDED, id="right once a fault is mended"),
        pytest.param(row("eq:1", Verdict.CONDITIONAL), Fate.LIMITED, id="conditional"),
        pytest.param(row("eq:1", Verdict.MODEL_GAP), Fate.FALLS, id="model gap"),
        pytest.param(row("eq:1", Verdict.UNCHECKABLE), Fate.OPEN, id="uncheckable"),
    ],
)
def test_fate_of_a_row(found: Row, expected: Fate) -> None:
    assert fate(found) is expected


def test_conclusions_are_abstract_and_last_section() -> None:
    rows = [
        row("sec:abstract/moves"),
        row("sec:abstract/typo", kind=Kind.EDITORIAL),
        row("sec:4/simulated"),
        row("sec:4#2/moves"),
        row("app:A/lemma"),
    ]
    assert [r.id for r in conclusions(ledger(*rows))] == ["sec:abstract/moves", "sec:4#2/moves"]


def test_a_fault_has_all_that_rests_on_it_through_others() -> None:
    (found,) = faults(
        ledger(
            row("eq:1", Verdict.ERRATUM),
            row("eq:2", Verdict.ERRATUM, "eq:1"),
            row("eq:3", follows="eq:2"),
            row("eq:4"),
        )
    )
    assert found.row.id == "eq:1"
    assert [r.id for r in found.falling] == ["eq:2"]
    assert [r.id for r in found.standing] == ["eq:3"]


def test_faults_that_name_each_other_end() -> None:
    one = row("eq:1", Verdict.ERRATUM, "eq:2")
    assert faults(ledger(one, row("eq:2", Verdict.ERRATUM, "eq:1"))) == ()


def test_formulas_to_replace_bring_all_entries_and_come_once() -> None:
    rows = [
        row("eq:1[1]", Verdict.ERRATUM, correction="a"),
        row("eq:1[2]"),
        row("eq:2", Verdict.ERRATUM, "eq:1[1]", correction="a"),
        row("eq:3"),
        row("sec:1/law", Verdict.ERRATUM, correction="e = p + q"),
        row("sec:1/words", Verdict.ERRATUM, correction="other words than these"),
    ]
    found = [[r.id for r in group] for group in replaced(ledger(*rows))]
    assert found == [["eq:1[1]", "eq:1[2]"], ["sec:1/law"]]


def test_a_misprint_once_more_needs_no_formula_of_its_own() -> None:
    misprint = {"verdict": Verdict.ERRATUM, "printed": "-x", "correction": "x"}
    rows = [
        row("eq:1", **misprint),
        row("eq:2", follows="eq:1", **misprint),
        row("eq:3", follows="eq:1", **misprint | {"printed": "-x y", "correction": "x y"}),
    ]
    assert [group[0].id for group in replaced(ledger(*rows))] == ["eq:1", "eq:3"]


def test_a_paper_that_nobody_derived_has_no_code_behind_it() -> None:
    derived = Derived(ledger(row("eq:1")))
    assert (derived.sympy("eq:1"), derived.source("eq:1")) == ("", "")


@pytest.mark.parametrize(
    ("claim", "entry"), [("eq:6[2,3]", (1, 2)), ("eq:10/a3[2]", (1,)), ("eq:12", ())]
)
def test_sympy_text_reads_back_as_the_derivation(claim: str, entry: tuple[int, ...]) -> None:
    found = Ledger(paper="omni-arrangement", claims=0, rows=())
    text = Derived(found).sympy(claim)
    formula = Formula("omni-arrangement", claim.partition("[")[0])
    names = {str(symbol): symbol for symbol in formula.symbols}
    expected = formula.expression[entry] if len(entry) > 1 else formula.expression
    expected = formula.expression[entry[0]] if len(entry) == 1 else expected
    assert sympify(text, locals=names) == expected


def test_source_names_the_file_of_a_derivation() -> None:
    found = Derived(Ledger(paper="omni-arrangement", claims=0, rows=())).source("eq:6[1,1]")
    file, line = found.split(":")
    assert file == "omniproof/papers/omni_arrangement/derivations/kinematics.py"
    assert int(line) > 1
