"""Which rows a reader has to know of, which of them first, and the files that list them all."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Sequence

from pydantic import TypeAdapter

from omniproof.audit.ledger import Consequence, Ledger, Row, Verdict, to_csv
from omniproof.report.latexfmt import is_latex
from omniproof.report.shorten import differing
from omniproof.transcription.model import Kind, Source

GRAVITY = (
    Verdict.UNDECIDED,
    Verdict.ERRATUM,
    Verdict.INCONSISTENT,
    Verdict.MODEL_GAP,
    Verdict.MISROUNDED,
    Verdict.CONDITIONAL,
    Verdict.UNCHECKABLE,
    Verdict.EDITORIAL,
    Verdict.VERIFIED,
)
"""Of several verdicts the first is shown; the order of `contracts`, section 1."""

REACH = (Consequence.MOTION, Consequence.NUMBER, Consequence.TEXT, Consequence.NONE)


def findings(ledger: Ledger) -> tuple[Row, ...]:
    """Return the rows of a paper that are faults, in order of place."""
    return tuple(row for row in ledger.rows if row.verdict.is_fault)


def consequential(ledgers: Iterable[Ledger], limit: int) -> tuple[Row, ...]:
    """Return the findings that matter most: by how far they reach, and what is false first.

    Of these the papers take turns, each with its own ranked by what follows from them, by gravity
    and by place: one paper with many faults does not hide those of another. Left out: what follows
    from another finding, what a fault of text recognition would explain, and what changes the text
    only.
    """
    ranked: list[tuple[tuple[int, bool, int], Row]] = []
    for ledger in ledgers:
        turns: Counter[tuple[int, bool]] = Counter()
        for row in _ranked(ledger):
            group = REACH.index(row.consequence), row.verdict is Verdict.CONDITIONAL
            ranked.append(((*group, turns[group]), row))
            turns[group] += 1
    return tuple(row for _, row in sorted(ranked, key=lambda pair: pair[0])[:limit])


def _ranked(ledger: Ledger) -> list[Row]:
    """Return the findings of a paper that reach beyond the text: by followers, gravity, place."""
    followers = Counter(row.follows for row in ledger.rows)
    rows = (
        row
        for row in findings(ledger)
        if not row.follows
        and row.source is Source.CLEAR
        and row.verdict is not Verdict.EDITORIAL
        and row.consequence in {Consequence.MOTION, Consequence.NUMBER}
    )
    return sorted(rows, key=lambda row: (-followers[row.id], GRAVITY.index(row.verdict)))


def sentence(row: Row, *, short: bool = False) -> str:
    """Return one sentence on a finding: what is printed and what is true, else its note.

    `short`: leave out printed words and the left side that two formulas share.
    """
    words = not is_latex(row.printed)
    printed = "" if short and words else quoted(row.printed)
    if row.correction:
        return _corrected(row, printed, words=words, short=short)
    if row.assumption:
        link = ": only when" if words and printed else " holds only when"
        return f"{printed}{link} {quoted(row.assumption)}".strip()
    return row.remark or row.printed


def _corrected(row: Row, printed: str, *, words: bool, short: bool) -> str:
    correct = quoted(row.correction)
    if not words and is_latex(row.correction):
        printed, correct = map(quoted, differing(row.printed, row.correction))
    left, sign, right = row.correction.partition("=")
    if short and sign and row.printed.startswith(left + sign):
        return f"{quoted(row.printed.removeprefix(left + sign))} should read {quoted(right)}"
    link = ": in fact" if words and row.kind is Kind.RELATION and printed else " should read"
    return f"{printed}{link} {correct}".strip()


def quoted(text: str) -> str:
    """Return a cell of the ledger for running text: a formula between dollar signs."""
    text = text.strip()
    return f"${text}$" if is_latex(text) else text


def findings_csv(ledgers: Sequence[Ledger]) -> str:
    """Return every finding of all papers with the columns of the ledger."""
    return to_csv(ledger.model_copy(update={"rows": findings(ledger)}) for ledger in ledgers)


def findings_json(ledgers: Sequence[Ledger]) -> str:
    """Return every finding of all papers as a JSON array of ledger rows."""
    rows = [row.model_dump(mode="json") for ledger in ledgers for row in findings(ledger)]
    return json.dumps(rows, ensure_ascii=False, indent=1) + "\n"


def findings_schema() -> str:
    """Return the JSON Schema of `findings.json`, as it stands in the repository."""
    schema = TypeAdapter(tuple[Row, ...]).json_schema()
    return json.dumps({"title": "Findings"} | schema, indent=2, sort_keys=True) + "\n"
