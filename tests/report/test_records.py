"""No page reads its facts out of sentences: records reach the last writer as records."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from omniproof.audit.ledger import Ledger, Row
from omniproof.report.corrigendum import corrigendum
from omniproof.report.fragments import Overview
from omniproof.report.tables import NUMBERS, table_csv
from omniproof.transcription.model import Edition, Kind

SENTENCES = frozenset({"note", "remark", "where", "witness", "interval", "reason", "assumption"})
"""Attributes of a row that are words, or records that are written as words."""
READERS = frozenset(
    ("findall", "finditer", "fullmatch", "match", "search", "sub", "partition", "rpartition",
     "split", "rsplit", "splitlines", "removeprefix", "removesuffix", "startswith", "endswith",
     "index", "find")
)  # fmt: skip
EDITION = Edition(title="t", authors=("a",), year=2023, venue="v", source="s.txt", sha256="0" * 64)


def taken_apart(tree: ast.AST) -> Iterator[str]:
    """Calls that take a sentence of a row apart."""
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute):
            parts = [part for side in (call.func.value, *call.args) for part in ast.walk(side)]
            names = {part.attr for part in parts if isinstance(part, ast.Attribute)}
            if call.func.attr in READERS and names & SENTENCES:
                yield ast.unparse(call)


def test_no_sentence_of_a_row_is_taken_apart(root: Path) -> None:
    files = (root / "workflow" / "omniproof").rglob("*.py")
    found = {file.name: [*taken_apart(ast.parse(file.read_text("utf-8")))] for file in files}
    assert {name: calls for name, calls in found.items() if calls} == {}


@pytest.mark.parametrize(
    "code",
    [
        pytest.param("row.witness.partition('=')", id="a method of the text"),
        pytest.param("PATTERN.findall(row.note)", id="a regular expression"),
        pytest.param("re.split(',', group.rows[0].where)", id="a place in words"),
    ],
)
def test_what_would_be_found(code: str) -> None:
    assert list(taken_apart(ast.parse(code))) == [code]


def reworded(row: Row) -> Row:
    return row.model_copy(update={"note": "opinion: see eq:1 and tab:1[8]; 3.5 in [1, 2]."})


def test_other_words_in_the_notes_change_no_fact(ledger: Ledger) -> None:
    other = ledger.model_copy(update={"rows": tuple(map(reworded, ledger.rows))})
    facts, others = (
        (
            [[row.id for row in item.rows] for item in corrigendum(each, EDITION).contradictions],
            Overview((each,), ()).uncheckable().html,
            table_csv([row for row in each.rows if row.kind is Kind.VALUE], {}),
        )
        for each in (ledger, other)
    )
    assert facts == others
    assert ",".join(NUMBERS) in facts[2]
