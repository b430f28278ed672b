"""The last screen of a build: what was found, what matters most, where to read on."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence, Sized

from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.report.findings import consequential, sentence
from omniproof.report.fragments.counts import verdict_counts
from omniproof.report.theme import MARKS
from omniproof.report.typeset import spoken
from omniproof.visible import visible

WIDTH = 80
HEIGHT = 24
MOST = 8
_TIE = "\0"  # a space that a line does not break at
REPORT = "book/_build/html/index.html"


def summary(ledgers: Sequence[Ledger], theorems: Sized) -> str:
    """Return at most 24 lines of at most 80 columns; `theorems` are only counted."""
    body = [line for ledger in ledgers for line in counts_lines(ledger)]
    if len(theorems):
        plural = "s" if len(theorems) > 1 else ""
        body.append(f"{len(theorems)} theorem{plural} that no paper prints")
    tail = ["", f"report  {REPORT}"]
    room = HEIGHT - len(body) - len(tail) - 2
    found = consequential(ledgers, max(0, min(MOST, room)))
    if found:
        body += [
            "",
            "most consequential findings",
            *(finding_line(row, named=len(ledgers) > 1) for row in found),
        ]
    return visible("\n".join([*body, *tail])) + "\n"


def counts_lines(ledger: Ledger) -> list[str]:
    """Return a paper's claims and rows per verdict; verdicts that do not occur are left out."""
    counts = verdict_counts(ledger)
    words = [f"{counts[verdict]} {mark.word}" for verdict, mark in MARKS.items() if counts[verdict]]
    listed = textwrap.wrap(", ".join(word.replace(" ", _TIE) for word in words), WIDTH - 2)
    head = f"{ledger.paper}: {ledger.claims} claims, {len(ledger.rows)} rows"
    return [_cut(head), *(f"  {line.replace(_TIE, ' ')}" for line in listed)]


def finding_line(row: Row, *, named: bool) -> str:
    """Return shape, place and one sentence on a finding, cut to the width of the screen.

    `named`: say in which paper it is.
    """
    shape = MARKS[Verdict(row.verdict)].shape
    where = f"{row.paper}, {row.where}" if named else row.where
    return _cut(f"  {shape} {where}: {spoken(sentence(row, short=True))}")


def _cut(line: str) -> str:
    return line if len(line) <= WIDTH else line[: WIDTH - 1].rstrip() + "…"
