"""No slip of ours in a symbol's entry accuses a paper: it stops the audit, or changes nothing."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import pytest
from altered_metadata import Alteration, in_place_of, symbol_alterations
from audited import audited_once

from omniproof.audit.run import audit_paper, prepare
from omniproof.transcription.faults import BadInput

PAPERS = sorted(path.parent for path in Path("paper_data").glob("*/paper.yaml"))
SAMPLE = 12
"""So many slips of each paper are tried each time; `make test-slow` tries all."""


@pytest.mark.parametrize("folder", PAPERS, ids=lambda folder: folder.name)
def test_some_slips(folder: Path) -> None:
    slips = random.Random(folder.name).sample([*symbol_alterations(folder)], SAMPLE)
    assert not accusations(folder, slips)


@pytest.mark.slow
@pytest.mark.parametrize("folder", PAPERS, ids=lambda folder: folder.name)
def test_all_slips(folder: Path) -> None:
    assert not accusations(folder, symbol_alterations(folder))


def accusations(folder: Path, slips: Iterable[Alteration]) -> list[str]:
    """Slips that are not told with their line, and rows that they turn into errata."""
    found, outcomes = [], Counter[tuple[str, str, str]]()
    with in_place_of(folder) as put:
        for slip in slips:
            put(slip)
            outcome = told(folder) or changed(folder)
            outcomes[slip.attribute, slip.how, outcome] += 1
            if outcome not in {"stopped", "same verdicts"}:
                found.append(f"{slip}: {outcome}")
    for (attribute, how, outcome), count in sorted(outcomes.items()):
        print(f"{folder.name:20} {attribute:9} {how:12} {outcome:14} {count}")
    return found


def told(folder: Path) -> str:
    """Whether the audit stops with a line of the paper file."""
    try:
        prepare(folder)
    except BadInput as bad:
        return "stopped" if any(fault.line > 1 for fault in bad.faults) else f"no line: {bad}"
    return ""


def changed(folder: Path) -> str:
    """Rows that have another verdict now."""
    before = {row.id: row for row in audited_once(folder).rows}
    rows = [row for row in audit_paper(folder).rows if row.verdict != before[row.id].verdict]
    return ", ".join(f"{row.id} is {row.verdict}" for row in rows) or "same verdicts"
