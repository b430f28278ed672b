"""What the pages about all papers show: the one-look result and the list of findings."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from html import escape
from pathlib import Path

from omniproof.audit.ledger import Consequence, Ledger, Row, Verdict, read_json
from omniproof.corrected.answer import Line
from omniproof.report.findings import REACH, findings, quoted
from omniproof.report.fragments.addresses import Addresses
from omniproof.report.fragments.assumptions import assumptions_html
from omniproof.report.fragments.base import (
    Fragment,
    Href,
    badge,
    results_folder,
    table,
)
from omniproof.report.fragments.counts import matrix_html, verdict_counts
from omniproof.report.fragments.edition import Change, edition_html
from omniproof.report.fragments.figures import drawn_html
from omniproof.report.fragments.front import check_words, paper_html, questions_html, told
from omniproof.report.fragments.listing import listing_html, place_html, reach_of
from omniproof.report.fragments.theorems import Theorem, read_theorems
from omniproof.report.fragments.values import Value
from omniproof.report.latexfmt import inline
from omniproof.settings import read_settings
from omniproof.transcription.model import Edition, Source, Uncheckable
from omniproof.transcription.paperfile import load_document

DECIDED_BY: Mapping[str, str] = {
    Uncheckable.FIGURE_NOT_SEEN: "a look at the figure in the PDF",
    Uncheckable.SOURCE_LOST: "the place in the PDF, which text recognition lost",
    Uncheckable.EXTERNAL_DATA: "the data behind the statement",
    Uncheckable.EXTERNAL_REFERENCE: "the cited work",
    Uncheckable.OPINION: "nothing: it is an opinion",
}


class Overview:
    """All papers at once; links lead to the chapters."""

    def __init__(
        self, ledgers: Iterable[Ledger], theorems: Iterable[Theorem], results: Path = Path()
    ) -> None:
        self.ledgers = tuple(ledgers)
        self.results = results
        self.papers_folder = results.parent / "paper_data"
        self.theorems = tuple(theorems)
        self._addresses = {ledger.paper: Addresses(ledger) for ledger in self.ledgers}

    @classmethod
    def open(cls, results: Path | None = None) -> Overview:
        """Open every ledger of the folder of results (found from the working folder)."""
        folder = results or results_folder()
        ledgers = [read_json(path) for path in sorted((folder / "ledger").glob("*.json"))]
        ordered = _in_order_of_book(ledgers, folder.parent)
        return cls(ordered, read_theorems(folder / "theorems.json"), folder)

    def papers(self, told: Mapping[str, str] | None = None) -> Fragment:
        """Show every paper: title, authors, edition, and its verdicts as a bar.

        told: by paper a sentence on what came of it, see `front.told`.
        """
        cards = (
            paper_html(
                ledger,
                read_edition(self.papers_folder / ledger.paper),
                self._told(ledger.paper, told[ledger.paper]) if told else "",
            )
            for ledger in self.ledgers
        )
        return Fragment(f'<div class="papers">{"".join(cards)}</div>', "papers")

    def questions(self, asked: Mapping[str, str | tuple[str, Line]]) -> Fragment:
        """Show questions with the right formula to copy, see `front.questions_html`."""
        return Fragment(questions_html(asked, self.ledgers), "questions")

    def picture(self, claim: str, drawing: str) -> Fragment:
        """Show a drawing of what a finding (`omni-arrangement eq:6[2,3]`) does.

        Raises `ValueError` when it is no finding.
        """
        row = self._finding(claim)
        html = drawn_html(self.results, row.paper, drawing, f"figure-{drawing}")
        return Fragment(html, f"figure {drawing}")

    def sources(self) -> Fragment:
        """Show which text of every paper was read, with the checksum of its file."""
        editions = (read_edition(self.papers_folder / ledger.paper) for ledger in self.ledgers)
        rows = (
            f'<tr><th scope="row">{escape(edition.source)}</th>'
            f"<td><code>{edition.sha256[:16]}…</code></td></tr>"
            for edition in editions
        )
        return Fragment(table(["text", "SHA-256"], rows, "sources"), "sources")

    def counts(self) -> Fragment:
        """Show how many rows of every paper got which verdict, with the sums."""
        return Fragment(matrix_html(self.ledgers), "counts")

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

    def headlines(self, chosen: Mapping[str, str]) -> Fragment:
        """Show findings in words of our own, in the order given, each with its verdict and a link.

        chosen: by paper and id (`omni-trajectory eq:8`) a sentence, in which `{printed}` and
        `{correct}` stand for what the ledger has. Raises `ValueError` for what is no finding, or
        would be no charge against the paper, and for a number that is typed.
        """
        items = "".join(_headline(self._finding(key), key, words) for key, words in chosen.items())
        return Fragment(f'<ol class="headlines">{items}</ol>', "findings that matter most")

    def uncheckable(self) -> Fragment:
        """Show how many claims nothing at hand decides, by class, and what would decide them."""
        found = [r for led in self.ledgers for r in led.rows if r.verdict is Verdict.UNCHECKABLE]
        counts = Counter(row.uncheckable or "" for row in found)
        rows = (
            f'<tr><th scope="row">{escape(name) or "not classified"}</th>'
            f'<td class="number">{counts[name]}</td><td>{DECIDED_BY.get(name, "")}</td></tr>'
            for name in (*DECIDED_BY, "")
            if counts[name]
        )
        return Fragment(table(["class", "rows", "decided by"], rows), "uncheckable by class")

    def edition(self, changes: Iterable[Change]) -> Fragment:
        """Show which verdicts are others than in the first edition."""
        links = {ledger.paper: self._href(ledger.paper) for ledger in self.ledgers}
        return Fragment(edition_html(changes, links), "changes since the first edition")

    def assumptions(self) -> Fragment:
        """Show what each paper assumes and does not state, with the claims that need it."""
        titles = {
            ledger.paper: _titled(ledger.paper, read_edition(self.papers_folder / ledger.paper))
            for ledger in self.ledgers
        }
        links = {paper: self._href(paper) for paper in titles}
        return Fragment(assumptions_html(self.ledgers, titles, links), "unstated assumptions")

    def findings(self, *reach: str) -> Fragment:
        """Show the findings as one list, those that reach furthest first.

        `reach`: only those that reach as far as one of `motion`, `number`, `text`. Findings of
        which a fault of text recognition would be an explanation are left out.
        """
        wanted = [Consequence(word) for word in reach] or [*REACH]
        rows = (row for row in self._all_findings() if row.source is Source.CLEAR)
        return self._listed((row for row in rows if reach_of(row) in wanted), "findings")

    def doubtful(self) -> Fragment:
        """Show the findings that a fault of text recognition would explain."""
        rows = (row for row in self._all_findings() if row.source is not Source.CLEAR)
        return self._listed(rows, "doubtful findings")

    def _told(self, paper: str, words: str) -> str:
        return told(paper, words, lambda claim: self._finding(f"{paper} {claim}"))

    def _finding(self, key: str) -> Row:
        """Return a finding by paper and id. Raises `ValueError` when there is none."""
        for row in self._all_findings():
            if key == f"{row.paper} {row.id}" and row.source is Source.CLEAR:
                return row
        raise ValueError(f"{key} is no finding whose source is clear")

    def _all_findings(self) -> Iterator[Row]:
        return (row for ledger in self.ledgers for row in findings(ledger))

    def _listed(self, rows: Iterable[Row], name: str) -> Fragment:
        links = {ledger.paper: self._href(ledger.paper) for ledger in self.ledgers}
        return Fragment(listing_html(rows, links), name)

    def _href(self, paper: str) -> Href:
        """Return how a page of the book links to a claim of a paper."""
        known = self._addresses[paper]

        def href(claim_id: str) -> str | None:
            address = known.find(claim_id)
            return f"{paper}.html#{address}" if address else None

        return href


def read_edition(folder: Path) -> Edition:
    """Read which text of a paper was audited from the folder of what it prints."""
    document = load_document(folder / "paper.yaml").values
    return Edition.model_validate(document["edition"] if isinstance(document, dict) else None)


def _in_order_of_book(ledgers: Iterable[Ledger], project: Path) -> list[Ledger]:
    """Put ledgers into the order of the configuration, others behind; without one, as they are."""
    config = project / "workflow" / "config.yaml"
    order = [*read_settings(config, root=project).papers] if config.is_file() else []
    places = {paper: place for place, paper in enumerate(order)}
    return sorted(ledgers, key=lambda ledger: places.get(ledger.paper, len(order)))


def _titled(paper: str, edition: Edition) -> str:
    return f'<a href="{escape(paper)}.html"><cite>{escape(edition.title)}</cite></a>'


def _headline(row: Row, key: str, words: str) -> str:
    """Return one finding as an item of a list: the sentence, the verdict, the place."""
    check_words(key, words)
    correct = quoted(row.correction or row.assumption or row.derived)
    said = words.replace("{printed}", quoted(row.printed)).replace("{correct}", correct)
    place = f'{place_html(row)} <span class="quiet">in {escape(row.paper)}</span>'
    return f"<li>{inline(said)}<br>{badge(row.verdict)} {place}</li>"
