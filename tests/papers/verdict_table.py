"""Tables of expected verdicts, each with its reason by hand, and edits that turn them."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import pytest

from omniproof.audit.ledger import Row, cells
from omniproof.audit.run import audit_paper

Edit = tuple[str, str, str]
"""File of the paper, what stands there exactly once, and what to write instead."""

Rows = Mapping[str, Row]


def verdict(row: str, found: str, reason: str, **fields: str) -> Any:
    """Make a line of a table of fields to expect, by row; the reason shows in the test's name."""
    return pytest.param(row, {"verdict": found, **fields}, id=f"{row}: {reason}")


def shown(row: Row, names: Iterable[str]) -> dict[str, Any]:
    """Some fields of a row, as the CSV has them."""
    fields = cells(row)
    return {name: fields[name] for name in names}


def edited(paper: Path, folder: Path, *edits: Edit) -> Path:
    """Copy a paper's folder into another one, with edits, and return the copy."""
    copy = folder / paper.name
    shutil.copytree(paper, copy)
    for name, old, new in edits:
        text = (copy / name).read_text(encoding="utf-8")
        assert text.count(old) == 1, old
        (copy / name).write_text(text.replace(old, new), encoding="utf-8")
    return copy


def audited(paper: Path) -> Rows:
    """Audit a paper: rows by their ids."""
    return {row.id: row for row in audit_paper(paper).rows}


def turned(before: Rows, after: Rows) -> dict[str, tuple[str, str]]:
    """Both verdicts of each row whose verdict differs; the rows have to be the same ones."""
    assert after.keys() == before.keys()
    pairs = {name: (row.verdict.value, after[name].verdict.value) for name, row in before.items()}
    return {name: pair for name, pair in pairs.items() if pair[0] != pair[1]}
