"""What the contract on verdicts asks of every row, whatever the paper."""

from __future__ import annotations

from collections.abc import Iterator

from omniproof.audit.ledger import Ledger, Repair, Row, Verdict
from omniproof.transcription.model import Kind

DECIDED = {Kind.IDENTITY, Kind.VALUE, Kind.RELATION}
LONGEST_NOTE = 600
"""Letters of a few sentences: a list of all that would also be true is none."""
MENDED = {Verdict.ERRATUM, Verdict.MISROUNDED, Verdict.MODEL_GAP, Verdict.INCONSISTENT}


def complaints(row: Row) -> Iterator[str]:
    """Everything that the contract on verdicts asks of a row, and that this row lacks."""
    decided = row.kind in DECIDED
    if row.verdict is Verdict.UNDECIDED:
        yield f"undecided: {row.note}"
    if row.verdict in MENDED and decided:
        yield from (name for name in ("witness", "correction", "engines") if not getattr(row, name))
        if row.repair is Repair.NONE:
            yield "repair"
    if row.verdict is Verdict.CONDITIONAL:
        yield from (name for name in ("witness", "assumption") if not getattr(row, name))
    if row.verdict is Verdict.VERIFIED and decided and not row.engines:
        yield "engines"
    if row.verdict is Verdict.VERIFIED and (row.correction or row.witness or row.assumption):
        yield "a right row needs no correction"
    if row.kind is Kind.VALUE and row.verdict is not Verdict.UNCHECKABLE and not row.interval:
        yield "interval"
    if (row.verdict is Verdict.UNCHECKABLE) != (row.uncheckable is not None):
        yield "class of uncheckable"
    if row.verdict.is_fault != bool(row.consequence):
        yield "consequence"
    if len(row.remark) > LONGEST_NOTE:
        yield f"a note of {len(row.remark)} letters"


ALLOWED = {
    Kind.IDENTITY: {
        "verified",
        "conditional",
        "erratum",
        "inconsistent",
        "model-gap",
        "uncheckable",
    },
    Kind.VALUE: {"verified", "misrounded", "erratum", "inconsistent", "uncheckable"},
    Kind.RELATION: {"verified", "conditional", "erratum", "model-gap", "uncheckable"},
    Kind.CONSISTENCY: {"verified", "inconsistent"},
    Kind.REFERENCE: {"verified", "erratum", "uncheckable"},
    Kind.EDITORIAL: {"editorial"},
}


def check_rows(ledger: Ledger) -> None:
    """Assert all of it, so that a failing test shows each row with what it lacks."""
    found = {row.id: list(complaints(row)) for row in ledger.rows}
    assert {name: lacking for name, lacking in found.items() if lacking} == {}
    assert [row.id for row in ledger.rows if row.verdict not in ALLOWED[row.kind]] == []
    ids = [row.id for row in ledger.rows]
    faults = {row.id for row in ledger.rows if row.verdict.is_fault}
    assert len(set(ids)) == len(ids)
    assert {row.follows for row in ledger.rows} - faults <= {""}
    read = {row.kind for row in ledger.rows if row.origin == "read"}
    assert read <= {Kind.REFERENCE, Kind.EDITORIAL}
