"""A paper of one claim, and a formula by itself: the two doors to a repair."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from sympy import symbols

from omniproof.audit import mending, run
from omniproof.audit.ledger import Row
from omniproof.registry import Registry
from omniproof.repair.misprint import Mended

PAPER = r"""
key: tiny-paper
edition:
  title: On one thing
  authors: [A. Writer]
  year: 2023
  venue: Journal 1(1)
  source: tiny-paper.txt
  sha256: 0000000000000000000000000000000000000000000000000000000000000000
symbols:
  - {{latex: 'a', name: a, means: a number}}
  - {{latex: 'b', name: b, means: a number}}
  - {{latex: 'x', name: x, means: a number}}
claims:
  - {{id: 'eq:1', kind: {kind}, line: 1, says: it, latex: '{latex}'{asserts}}}
  - {{id: 'eq:2', kind: identity, line: 2, says: all symbols, latex: 'a + b + x'}}
"""


@dataclass(frozen=True)
class Judged:
    """The row of a claim, and the repairs that it was made from."""

    row: Row
    mended: Mended | None


@pytest.fixture
def paper(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Judged]:
    """Return what judges a paper that prints one formula, with what is derived for it."""
    found: list[Mended | None] = [None]

    def kept(misprint: Any) -> Mended | None:
        found[0] = mend(misprint)
        return found[0]

    def judge(latex: str, derived: Any, form: str = "") -> Judged:
        kind, asserts = ("relation", f", asserts: {{form: {form}}}") if form else ("identity", "")
        registry = Registry("tiny-paper")
        registry.derives("eq:1")(lambda: derived)
        registry.derives("eq:2")(lambda: sum(symbols("a b x", real=True)))
        monkeypatch.setattr(run, "load_registry", lambda paper: registry)
        monkeypatch.setattr(run, "load_readings", lambda paper: {})
        text = PAPER.lstrip().format(kind=kind, latex=latex, asserts=asserts)
        (tmp_path / "paper.yaml").write_text(text, encoding="utf-8")
        return Judged(run.audit_paper(tmp_path).rows[0], found[0])

    mend = mending.mend
    monkeypatch.setattr(mending, "mend", kept)
    return judge
