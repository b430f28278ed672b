"""Theorems: what follows for the papers' quantities and no paper prints.

A theorem is a statement with proof steps; each step is an obligation, proved by the same engines
as the claims. A step that is not proved stops the build: a theorem is never merely believed.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from omniproof.audit.relations import judge, merge
from omniproof.decide.answer import Proved
from omniproof.registry import Theorem


@dataclass(frozen=True)
class UnprovedError(Exception):
    """A proof step that the engines did not confirm."""

    theorem: str
    step: str
    answer: object

    def __str__(self) -> str:
        """Name the theorem, the step and what the engines answered."""
        return f"{self.theorem}: the step {self.step!r} is not proved: {self.answer}"


def prove(theorem: Theorem) -> dict[str, Any]:
    """Return the record of a theorem with the engines of each step; raises `UnprovedError`."""
    steps = []
    for step in theorem.steps:
        engines: tuple[str, ...] = ()
        for obligation in step.obligations():
            answer = judge(obligation)
            if not isinstance(answer, Proved):
                raise UnprovedError(theorem.id, step.says, answer)
            engines = merge(engines, answer.engines)
        steps.append({"step": step.says, "engines": "+".join(engines)})
    engines = merge(*(step["engines"].split("+") for step in steps))
    return {
        "id": theorem.id,
        "title": theorem.title,
        "statement": theorem.statement,
        "papers": list(theorem.papers),
        "engines": "+".join(engines),
        "proof": steps,
    }


def prove_all(papers: Iterable[str]) -> list[dict[str, Any]]:
    """Prove the theorems of all papers and topics, in order; one without theorems adds none."""
    return [prove(theorem) for paper in papers for theorem in _theorems(paper)]


def _theorems(paper: str) -> Sequence[Theorem]:
    name = f"omniproof.papers.{paper.replace('-', '_')}.theorems"
    if find_spec(name) is None:
        return ()
    theorems: Sequence[Theorem] = import_module(name).THEOREMS
    return theorems


def write_theorems(records: Sequence[dict[str, Any]], path: Path) -> None:
    """Write `results/theorems.json`."""
    text = json.dumps(records, indent=1, ensure_ascii=False)
    path.write_text(text + "\n", encoding="utf-8")
