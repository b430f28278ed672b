"""What the pages about all papers show: the one-look result and the list of findings."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from html import escape
from pathlib import Path

from omniproof.audit.ledger import Ledger, Row, Verdict, read_json
from omniproof.report.anchors import anchor
from omniproof.report.findings import consequential, findings, sentence, uncheckable_class
from omniproof.report.fragments.base import Fragment, badge, link, results_folder, table
from omniproof.report.fragments.claims import CONSEQUENCES
from omniproof.report.fragments.counts import accounting_html, verdict_counts
from omniproof.report.fragments.theorems import Theorem, read_theorems
from omniproof.report.fragments.values import Value
from omniproof.report.latexfmt import cell, inline
from omniproof.report.theme import MARKS
from omniproof.transcription.model import Source, Uncheckable

DECIDED_BY: Mapping[str, str] = {
    Uncheckable.FIGURE_NOT_SEEN: "a look at the figure in the PDF",
    Uncheckable.SOURCE_LOST: "the place in the PDF, which text recognition lost",
    Uncheckable.EXTERNAL_DATA: "the data behind the statement",
    Uncheckable.EXTERNAL_REFERENCE: "the cited work",
    Uncheckable.OPINION: "nothing: it is an opinion",
}


class Overview:
    """All papers at once; links lead to the chapters."""

    def __init__(self, ledgers: Iterable[Ledger], theorems: Iterable[Theorem]) -> None:
        self.ledgers = tuple(ledgers)
        self.theorems = tuple(theorems)

    @classmethod
    def open(cls, results: Path | None = None) -> Overview:
        """Open every ledger of the folder of results (found from the working folder)."""
        folder = results or results_folder()
        ledgers = [read_json(path) for path in sorted((folder / "ledger").glob("*.json"))]
        return cls(ledgers, read_theorems(folder / "theorems.json"))

    def counts(self) -> Fragment:
        """Show the verdicts of every paper as bars and a table."""
        return Fragment(accounting_html(self.ledgers, linked=True), "counts")

    def count(self, what: str) -> Value:
        """Return a number for running text: `claims`, `rows`, `theorems`, `papers` or a verdict.

        Raises `ValueError` for another word.
        """
        if what in list(Verdict):
            number = sum(verdict_counts(ledger)[Verdict(what)] for ledger in self.ledgers)
        else:
            numbers = {
                "claims": sum(ledger.claims for ledger in self.ledgers),
                "rows": sum(len(ledger.rows) for ledger in self.ledgers),
                "theorems": len(self.theorems),
                "papers": len(self.ledgers),
            }
            if what not in numbers:
                raise ValueError(f"expected a verdict or one of {sorted(numbers)}, found {what!r}")
            number = numbers[what]
        return Value(str(number))

    def most_consequential(self, limit: int = 10) -> Fragment:
        """Show the findings that matter most, one sentence and a link each."""
        items = "".join(
            f"<li>{badge(row.verdict)} {_place(row)}: {inline(sentence(row))}</li>"
            for row in consequential(self.ledgers, limit)
        )
        return Fragment(f'<ol class="consequential">{items}</ol>', "most consequential findings")

    def uncheckable(self) -> Fragment:
        """Show how many claims nothing at hand decides, by class, and what would decide them."""
        found = [r for led in self.ledgers for r in led.rows if r.verdict is Verdict.UNCHECKABLE]
        counts = Counter(uncheckable_class(row) for row in found)
        rows = (
            f'<tr><th scope="row">{escape(name) or "not classified"}</th>'
            f'<td class="number">{counts[name]}</td><td>{DECIDED_BY.get(name, "")}</td></tr>'
            for name in (*DECIDED_BY, "")
            if counts[name]
        )
        return Fragment(table(["class", "rows", "decided by"], rows), "uncheckable by class")

    def findings(self, *, doubtful: bool = False) -> Fragment:
        """Show every finding; `doubtful`: those that a fault of text recognition would explain."""
        rows = [
            row
            for ledger in self.ledgers
            for row in findings(ledger)
            if (row.source is not Source.CLEAR) == doubtful
        ]
        if not rows:
            return Fragment("<p>None.</p>", "no findings")
        head = ["place", "printed and correct", "remark"]
        return Fragment(table(head, map(_finding, rows), "findings"), "findings")

    def verdicts(self) -> Fragment:
        """Show what every verdict means."""
        rows = (f"<tr><td>{badge(v)}</td><td>{mark.meaning}</td></tr>" for v, mark in MARKS.items())
        return Fragment(table(["verdict", "meaning"], rows), "verdicts")


def href(row: Row) -> str:
    """Return the permanent address of a row from any page of the book."""
    return f"{row.paper}.html#{anchor(row.id)}"


def _place(row: Row) -> str:
    return f'<a href="{escape(href(row))}">{escape(row.where)}</a>'


def _finding(row: Row) -> str:
    follows = ""
    if row.follows:
        target = f"{row.paper}.html#{anchor(row.follows)}"
        follows = f" Follows from {link(row.follows, lambda _: target)}."
    consequence = CONSEQUENCES.get(row.consequence, "")
    correct = row.correction or row.derived
    return (
        f'<tr class="v-{row.verdict}"><td>{_place(row)}<br>{badge(row.verdict)}</td>'
        f"<td>{_line('printed', row.printed)}{_line('correct', correct)}</td>"
        f"<td><p>{inline(row.note)}{follows}</p>"
        f'<p class="quiet">{consequence}</p></td></tr>'
    )


def _line(word: str, text: str) -> str:
    if not text:
        return ""
    return f'<p class="line"><span class="quiet">{word}</span> {cell(text)}</p>'
