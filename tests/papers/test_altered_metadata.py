"""No slip of ours in what is said of a symbol accuses a paper: it stops the audit, or acquits."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import pytest
from altered_metadata import Alteration, in_place_of, symbol_alterations
from altered_symbols import Fact, facts, in_place
from audited import audited_once

from omniproof.audit.ledger import Row, Verdict
from omniproof.audit.run import audit_paper, prepare
from omniproof.transcription.faults import BadInput
from omniproof.transcription.loader import load_paper

PAPERS = sorted(path.parent for path in Path("paper_data").glob("*/paper.yaml"))
SAMPLE, FACTS = 12, 2
"""So many slips of each paper are tried each time, and facts; `make test-slow` tries all."""
PRINTED = {"latex", "means"}
"""What only says how the paper writes a symbol: one that no claim prints may be misspelt."""
each_paper = pytest.mark.parametrize("folder", PAPERS, ids=lambda folder: folder.name)


@each_paper
def test_some_slips(folder: Path) -> None:
    slips = random.Random(folder.name).sample([*symbol_alterations(folder)], SAMPLE)
    assert not accusations(folder, slips)


@pytest.mark.slow
@each_paper
def test_all_slips(folder: Path) -> None:
    assert not accusations(folder, symbol_alterations(folder))


@each_paper
def test_some_facts(folder: Path) -> None:
    assert not changes(folder, random.Random(folder.name).sample([*facts(folder.name)], FACTS))


@pytest.mark.slow
@each_paper
def test_all_facts(folder: Path) -> None:
    assert not changes(folder, facts(folder.name))


def accusations(folder: Path, slips: Iterable[Alteration]) -> list[str]:
    """Slips that are not told with their line; what stands in two places always is."""
    found, outcomes = [], Counter[tuple[str, str, str]]()
    with in_place_of(folder) as put:
        for slip in slips:
            put(slip)
            outcome = told(folder) or ", ".join(turned(folder)) or "same verdicts"
            outcomes[slip.attribute, slip.how, outcome] += 1
            allowed = {"stopped", "same verdicts"} if slip.attribute in PRINTED else {"stopped"}
            if outcome not in allowed:
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


def changes(folder: Path, altered: Iterable[Fact]) -> list[str]:
    """Facts of which a slip changes a verdict without naming what it lost."""
    found = []
    for fact in altered:
        with in_place(fact):
            outcome = told(folder) or ", ".join(changed(folder, fact)) or "same verdicts"
        print(f"{fact}: {outcome}")
        if outcome not in {"stopped", "same verdicts"}:
            found.append(f"{fact}: {outcome}")
    return found


def changed(folder: Path, fact: Fact) -> list[str]:
    """Rows with another verdict now: an accusation, or a condition without the symbol."""
    rows = turned(folder)
    symbols = load_paper(folder).symbols.values()
    latex = next(symbol.latex for symbol in symbols if symbol.name == fact.symbol.name)
    return [f"{name} is {row.verdict}" for name, row in rows.items() if not names(row, latex)]


def turned(folder: Path) -> dict[str, Row]:
    """Rows that have another verdict now."""
    before = {row.id: row for row in audited_once(folder).rows}
    rows = audit_paper(folder).rows
    return {row.id: row for row in rows if row.verdict != before[row.id].verdict}


def names(row: Row, latex: str) -> bool:
    """Whether a changed verdict is no accusation, and says on which symbol it hangs."""
    if row.verdict is Verdict.VERIFIED:
        return True
    return row.verdict is not Verdict.ERRATUM and latex in row.assumption + row.note
