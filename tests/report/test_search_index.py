"""What the search looks through: each claim once, as a reader would type it, in little room."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from omniproof.audit.ledger import Ledger
from omniproof.report.search_index import claims_script, places_script, text_of

PAPERS = Path(__file__).parents[2] / "paper_data"


def data(script: str) -> dict[str, Any]:
    head, _, body = script.rstrip(";\n").partition(" = ")
    assert head == "window.CLAIMS"
    return dict(json.loads(body))


def test_every_claim_is_there_once(ledger: Ledger) -> None:
    (paper,) = data(claims_script([ledger], PAPERS))["papers"]
    assert [row[0] for row in paper["rows"]] == [row.id for row in ledger.rows]


def test_a_claim_brings_the_meanings_of_its_symbols(ledger: Ledger) -> None:
    (paper,) = data(claims_script([ledger], PAPERS))["papers"]
    (row,) = (row for row in paper["rows"] if row[0] == "eq:6[1,2]")
    assert {paper["symbols"][i] for i in row[-1]} == {
        "position angle of wheel 1",
        "position angle of wheel 2",
    }


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        pytest.param(r"\cos {\alpha_2} - L", "cos α₂ - L", id="functions and Greek letters"),
        pytest.param(r"\dot{\phi}", "φ̇", id="a rate keeps its dot"),
        pytest.param(
            r"\begin{bmatrix} 0 & -1 \\ 1 & 0 \end{bmatrix}",
            "[ 0 , -1 ; 1 , 0 ]",
            id="matrix by rows",
        ),
        pytest.param(r"\frac{\sqrt{3} \cos {\phi}}{2}", "(√3 cos φ)/2", id="fraction of a product"),
    ],
)
def test_formulas_are_kept_as_they_are_typed(latex: str, text: str) -> None:
    assert text_of(latex) == text


def test_no_text_ends_the_script() -> None:
    assert "</script" not in places_script([("section", "a.html", "</script><b>", "")])
