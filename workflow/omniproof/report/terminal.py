"""The ledger of one paper on a terminal: what a reader has to know of, then the counts."""

from __future__ import annotations

from collections import Counter

from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.report.layout import detail, terminal_width


def ledger_text(ledger: Ledger, width: int | None = None) -> str:
    """Write the ledger for a terminal of `width` columns (by default, this one's)."""
    columns = width or terminal_width()
    faults = [_entry(row, columns) for row in ledger.rows if row.verdict.is_fault]
    return "\n\n".join([*faults, _counts(ledger)])


def _entry(row: Row, columns: int) -> str:
    head = f"{row.verdict.upper()}  {row.id}  ({row.where})"
    details = {
        "printed": row.printed,
        "correct": row.correction,
        "holds for": row.assumption,
        "witness": str(row.witness or ""),
        "follows": row.follows,
        "note": row.remark,
    }
    lines = [head]
    for name, text in details.items():
        lines += detail(name, text, columns)
    return "\n".join(lines)


def _counts(ledger: Ledger) -> str:
    found = Counter(row.verdict for row in ledger.rows)
    counts = ", ".join(f"{found[verdict]} {verdict}" for verdict in Verdict if found[verdict])
    return f"{ledger.paper}: {ledger.claims} claims, {len(ledger.rows)} rows: {counts}"
