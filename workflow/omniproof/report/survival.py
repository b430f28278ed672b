"""What becomes of a paper when its misprints are mended: which conclusions stand, which fall.

Two things are computed from finished rows. The fate of a claim follows from its verdict and from
the fault that it rests on (`follows`). And every fault has dependents: those that fall with it, and
those that stand as soon as it is read as corrected.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.report.latexfmt import is_latex
from omniproof.transcription.ids import base
from omniproof.transcription.model import Kind

JUDGED = frozenset({Kind.IDENTITY, Kind.VALUE, Kind.RELATION})
"""Kinds that say something of robots; the others are about the text."""

_SECTION = re.compile(r"sec:(\d+(?:#\d+)?)/")


class Fate(StrEnum):
    """What becomes of a claim."""

    STANDS = "stands"
    MENDED = "stands, once a fault is mended"
    LIMITED = "stands under a condition"
    FALLS = "falls"
    OPEN = "open"


def fate(row: Row) -> Fate:
    """Return what becomes of a row."""
    match row.verdict:
        case Verdict.VERIFIED:
            return Fate.MENDED if row.follows else Fate.STANDS
        case Verdict.CONDITIONAL:
            return Fate.LIMITED
        case Verdict.UNCHECKABLE | Verdict.UNDECIDED:
            return Fate.OPEN
        case _:
            return Fate.FALLS


def conclusions(ledger: Ledger) -> tuple[Row, ...]:
    """Return what a paper says in its abstract and in its last section, but for the wording."""
    sections = [found[1] for row in ledger.rows if (found := _SECTION.match(row.id))]
    ends = ("sec:abstract/", f"sec:{sections[-1]}/" if sections else "sec:abstract/")
    return tuple(row for row in ledger.rows if row.kind in JUDGED and row.id.startswith(ends))


@dataclass(frozen=True)
class Fault:
    """A fault with what rests on it, in order of place."""

    row: Row
    falling: tuple[Row, ...]
    standing: tuple[Row, ...]


def faults(ledger: Ledger) -> tuple[Fault, ...]:
    """Return the faults that follow from no other one, with all that rests on them."""
    rows = {row.id: row for row in ledger.rows}
    resting: dict[str, list[Row]] = {}
    for row in ledger.rows:
        root = _root(row, rows)
        if root is not row:
            resting.setdefault(root.id, []).append(row)
    return tuple(
        Fault(
            row,
            tuple(r for r in resting.get(row.id, ()) if r.verdict.is_fault),
            tuple(r for r in resting.get(row.id, ()) if not r.verdict.is_fault),
        )
        for row in ledger.rows
        if row.kind in JUDGED and row.verdict.is_fault and row.follows not in rows
    )


def _root(row: Row, rows: Mapping[str, Row]) -> Row:
    """Return the fault at the beginning of a chain; a chain that bites its tail ends there."""
    seen = {row.id}
    while row.follows in rows and row.follows not in seen:
        seen.add(row.follows)
        row = rows[row.follows]
    return row


def replaced(ledger: Ledger) -> tuple[tuple[Row, ...], ...]:
    """Return the formulas with another one to use instead, each with all its entries."""
    rows = {row.id: row for row in ledger.rows}
    wrong = {base(row.id) for row in ledger.rows if _has_another(row, rows)}
    groups: dict[str, list[Row]] = {}
    for row in ledger.rows:
        if base(row.id) in wrong:
            groups.setdefault(base(row.id), []).append(row)
    return tuple(tuple(group) for group in groups.values())


def _has_another(row: Row, rows: Mapping[str, Row]) -> bool:
    if row.kind is Kind.IDENTITY:
        right = row.correction or row.derived
        return row.verdict.is_fault and bool(right) and not _recurs(row, rows)
    falls = row.kind is Kind.RELATION and fate(row) is Fate.FALLS and not row.follows
    return falls and is_latex(row.correction)


def _recurs(row: Row, rows: Mapping[str, Row]) -> bool:
    """Whether a row is a misprint once more: reads as the one that it follows, and should, too."""
    first = rows.get(row.follows)
    return first is not None and (first.printed, first.correction) == (row.printed, row.correction)


def tally(rows: Iterable[Row]) -> Sequence[tuple[Fate, int]]:
    """Return how many rows have which fate, in the order of `Fate`."""
    fates = [fate(row) for row in rows]
    return [(kind, fates.count(kind)) for kind in Fate if kind in fates]
