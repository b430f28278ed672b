"""The importable formulas say the same as the corrections of the ledger, and none is missing."""

from __future__ import annotations

from pathlib import Path
from random import Random
from typing import Any

import pytest
from audited import audited_once
from numpy.testing import assert_allclose

from omniproof.audit.ledger import Ledger, Row
from omniproof.audit.run import prepare
from omniproof.corrected import FUNCTIONS
from omniproof.corrected.formula import Formula
from omniproof.report.anchors import index
from omniproof.transcription.model import Kind, Source

PARTS = {"eq:A.2/a22", "eq:A.2/a13", "eq:A.3", "eq:6-2"}
"""Entries and determinant of a matrix that has a function, times L; a product with one."""


def faulty(ledger: Ledger) -> list[Row]:
    """Formulas that are not right as printed, where the source is clear."""
    return [
        row
        for row in ledger.rows
        if row.kind is Kind.IDENTITY and row.verdict.is_fault and row.source is Source.CLEAR
    ]


@pytest.fixture(scope="module", params=["ballbot", "omni-arrangement"])
def ledger(request: pytest.FixtureRequest, root: Path) -> Ledger:
    return audited_once(root / "paper_data" / request.param)


def test_every_false_formula_has_a_function(ledger: Ledger) -> None:
    claims = {
        row.id.partition("[")[0] for row in faulty(ledger) if not row.follows.startswith("eq:6[")
    }
    assert claims - PARTS <= FUNCTIONS[ledger.paper].keys()


def test_functions_equal_the_corrections_of_the_ledger(ledger: Ledger, root: Path) -> None:
    context = prepare(root / "paper_data" / ledger.paper)
    random, compared = Random(7), 0
    for row in faulty(ledger):
        claim = row.id.partition("[")[0]
        if claim not in FUNCTIONS[ledger.paper] or not row.correction:
            continue
        formula = Formula(ledger.paper, claim)
        point = {str(symbol): random.uniform(0.2, 1.2) for symbol in formula.symbols}
        place = tuple(int(part) - 1 for part in index(row.id))
        corrected: Any = context.value(row.correction, claim)
        found = formula(**point)[place]
        values = {symbol: point[str(symbol)] for symbol in corrected.free_symbols}
        assert_allclose(found, float(corrected.subs(values)), err_msg=row.id)
        compared += 1
    assert compared >= 1
