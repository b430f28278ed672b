from __future__ import annotations

import csv
import io
import json
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from omniproof.audit.ledger import COLUMNS, Consequence, Ledger, Row, Verdict, read_json
from omniproof.report.findings import (
    consequential,
    findings_csv,
    findings_json,
    findings_schema,
    sentence,
)

FAULT = {"paper": "p", "kind": "identity", "verdict": "erratum", "where": "Eq. (1)"}


def fault(**fields: Any) -> Row:
    return Row.model_validate(FAULT | {"id": "eq:1", "consequence": "motion"} | fields)


def test_findings_are_the_faults_with_every_column(ledger: Ledger) -> None:
    lines = list(csv.DictReader(io.StringIO(findings_csv([ledger]))))
    assert tuple(lines[0]) == COLUMNS
    assert [line["id"] for line in json.loads(findings_json([ledger]))] == [
        line["id"] for line in lines
    ]
    assert [line["id"] for line in lines] == [
        "eq:6[1,2]",
        "eq:10/a3[2]",
        "tab:1[8]",
        "tab:2[Z,D_A]",
        "eq:A.2/a13",
        "eq:C.6",
        "xref:app-d-cites-eq-12",
        "sec:2/curvic",
    ]


def test_order_of_consequence() -> None:
    """Reach first, false before conditional, then what follows, then gravity, then place."""
    rows = [
        fault(id="eq:1", consequence=Consequence.NUMBER),
        fault(id="eq:2", verdict=Verdict.CONDITIONAL),
        fault(id="eq:3"),
        fault(id="eq:4"),
        fault(id="eq:5", follows="eq:4"),
        fault(id="eq:6", consequence=Consequence.TEXT),
        fault(id="eq:7", source="doubtful"),
        fault(id="eq:8", verdict=Verdict.MODEL_GAP),
        *(fault(id=f"eq:9[{k}]", follows="eq:8") for k in (1, 2)),
    ]
    ledger = Ledger(paper="p", claims=9, rows=tuple(rows))
    found = [row.id for row in consequential([ledger], 10)]
    assert found == ["eq:8", "eq:4", "eq:3", "eq:2", "eq:1"]
    assert [row.id for row in consequential([ledger], 2)] == found[:2]


def test_papers_take_turns() -> None:
    """A paper with many faults does not hide those of another; reach still comes first."""
    many = [fault(id=f"eq:{k}") for k in (1, 2, 3)]
    few = [
        fault(paper="q", id="eq:1", verdict=Verdict.CONDITIONAL),
        fault(paper="q", id="eq:2"),
        fault(paper="q", id="eq:3", consequence=Consequence.NUMBER),
    ]
    ledgers = [Ledger(paper=rows[0].paper, claims=3, rows=tuple(rows)) for rows in (many, few)]
    found = [f"{row.paper}/{row.id}" for row in consequential(ledgers, 10)]
    assert found == ["p/eq:1", "q/eq:2", "p/eq:2", "p/eq:3", "q/eq:1", "q/eq:3"]


@pytest.mark.parametrize(
    ("fields", "short", "expected"),
    [
        pytest.param(
            {"printed": "x + 1", "correction": "x - 1"},
            False,
            "$x + 1$ should read $x - 1$",
            id="formula",
        ),
        pytest.param(
            {"printed": "y = x + 1", "correction": "y = x - 1"},
            True,
            "$x + 1$ should read $x - 1$",
            id="common left side is left out",
        ),
        pytest.param(
            {"printed": "the sine is largest", "correction": "x - 1"},
            True,
            "should read $x - 1$",
            id="printed words are left out",
        ),
        pytest.param(
            {"printed": "the sine is largest", "assumption": "x > 0"},
            False,
            "the sine is largest: only when $x > 0$",
            id="condition",
        ),
        pytest.param(
            {"printed": "x", "note": "differs from eq:2."},
            True,
            "differs from eq:2.",
            id="note",
        ),
        pytest.param({"printed": "y = 1"}, True, "y = 1", id="nothing but the printed form"),
    ],
)
def test_sentence(fields: dict[str, str], short: bool, expected: str) -> None:
    assert sentence(fault(**fields), short=short) == expected


def test_the_schema_of_findings_in_the_repository_is_that_of_the_model() -> None:
    stored = files("omniproof.report").joinpath("findings.schema.json").read_text(encoding="utf-8")
    assert stored == findings_schema(), "write `findings_schema()` to findings.schema.json"


def test_findings_are_valid_by_their_schema_and_others_are_not(results: Path) -> None:
    validator = Draft202012Validator(json.loads(findings_schema()))
    ledger = read_json(results / "ledger" / "omni-arrangement.json")
    found = json.loads(findings_json([ledger]))
    assert found
    assert list(validator.iter_errors(found)) == []
    for wrong in ({"verdict": "wrong"}, {"printed": 4.61}, {"time": "now"}):
        assert list(validator.iter_errors([found[0] | wrong]))
