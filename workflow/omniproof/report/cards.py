"""Read the rows of finished pages back: each has its note whole, a fault all that is known of it.

A row is a line of the table on the page; opened, it has its details below, which a file beside the
page brings: its card, a list of terms (`dl.facts`). What has to be in it follows from the ledger: a
correction wants "should read", a witness "counterexample", and so on. The buttons (copy, dispute)
are made by a script from the attributes of the list.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from html import unescape
from html.parser import HTMLParser

from omniproof.audit.ledger import Ledger, Row
from omniproof.report.anchors import anchor
from omniproof.report.changes import changes
from omniproof.report.code_pages import code_link
from omniproof.report.derived import Derived
from omniproof.report.finish import set_formulas
from omniproof.report.fragments.base import note_html
from omniproof.report.latexfmt import is_latex
from omniproof.report.theme import MARKS
from omniproof.transcription.model import Kind

TERMS: Mapping[str, str] = {
    "correction": "should read",
    "assumption": "true when",
    "witness": "counterexample",
    "interval": "exact value",
    "follows": "follows from",
    "consequence": "consequence",
    "engines": "decided by",
}
"""Column of the ledger -> the term under which a card has it."""

_LINE = re.compile(r'(<tr class="claim [^>]*? (?:id|data-row)="([^"]+)".*?)(</td></tr>)', re.DOTALL)
_TAG = re.compile(r"<[^>]*>")
_VOID = frozenset({"br", "img", "input", "link", "meta", "hr", "col", "source", "wbr"})


@dataclass
class Card:
    """What a page has of one row; `words` is all text of the claim that the list stands in."""

    attributes: Mapping[str, str]
    claim: str
    terms: dict[str, str] = field(default_factory=dict)
    links: list[str] = field(default_factory=list)
    words: str = ""

    def copied(self, language: str) -> str:
        """Return what the button of a language copies."""
        return self.attributes.get(f"data-{language}", "")


class Cards(HTMLParser):
    """The cards of a page, by the address in them (`#eq-6-2-3`)."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.cards: dict[str, Card] = {}
        self._open: list[tuple[str, set[str]]] = []
        self._claims: list[list[str]] = []
        self._card: Card | None = None
        self._term = ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Enter a claim, a list of facts, a term; note links."""
        found = {name: value or "" for name, value in attrs}
        classes = set(found.get("class", "").split())
        if tag not in _VOID:
            self._open.append((tag, classes))
        if "claim" in classes:
            self._claims.append([])
        if tag == "dl" and "facts" in classes:
            claim = next((c for _, c in reversed(self._open) if "claim" in c), set())
            verdict = next((name for name in claim if name.startswith("v-")), "")
            words = " ".join(self._claims[-1]) if self._claims else ""
            self._card = Card(found, verdict, words=words)
        if self._card is None:
            return
        self._term = "" if tag == "dt" else self._term
        if tag == "a":
            self._card.links.append(found.get("href", ""))
            if "address" in classes:
                self.cards[found["href"]] = self._card

    def handle_endtag(self, tag: str) -> None:
        """Leave what was entered."""
        if tag == "dl":
            self._card = None
        while self._open:
            name, classes = self._open.pop()
            if "claim" in classes:
                self._claims.pop()
            if name == tag:
                return

    def handle_data(self, data: str) -> None:
        """Note the words of terms and their texts, and those of the claim before its facts."""
        if self._claims:
            self._claims[-1].append(data)
        if self._card is None or not self._open:
            return
        if self._open[-1][0] == "dt":
            self._term = data
        elif self._term:
            self._card.terms[self._term] = self._card.terms.get(self._term, "") + data


def opened(text: str, details: Mapping[str, str]) -> str:
    """Return the HTML of a page with the details of every row in it, as if all were opened."""
    return _LINE.sub(lambda line: line[1] + details.get(line[2], "") + line[3], text)


def card_faults(page: str, text: str, ledger: Ledger, derived: Derived) -> Iterator[str]:
    """Name everything that the card of a row lacks, as `page: claim lacks what`.

    `text`: of the page with all rows opened. Every row has its whole note; a faulty one has more.
    """
    cards = Cards(text).cards
    notes = set_formulas(note_html(row.remark, lambda _: None) for row in ledger.rows)
    for row, note in zip(ledger.rows, notes, strict=True):
        card = cards.get(f"#{anchor(row.id)}")
        lacking = [] if card is None or _says(card, note) else ["its whole note"]
        if row.verdict.is_fault:
            lacking += _lacking(row, card, derived) if card else ["a card"]
        yield from (f"{page}: {row.id} lacks {what}" for what in lacking)


def _says(card: Card, note: str) -> bool:
    """Whether a note (HTML) stands on a card; blanks depend on the elements around."""
    shown = unescape(_TAG.sub("", note))
    return "".join(shown.split()) in "".join(card.words.split())


def _lacking(row: Row, card: Card, derived: Derived) -> Iterator[str]:
    """Yield what a card lacks of its row."""
    mark, source = MARKS[row.verdict], derived.source(row.id)
    right = row.correction or row.derived or row.printed
    changed = bool(row.correction and changes(row.printed, row.correction))
    # Of formulas only: deriving every number and relation again takes longer than all checks.
    formula = row.kind is Kind.IDENTITY
    wanted = {
        "its verdict in colour": card.claim == f"v-{row.verdict}",
        "its verdict in words": mark.word in card.words,
        "the shape of its verdict": mark.shape in card.words,
        "what changes": not changed or "change" in card.terms,
        "the source of its derivation": not source or code_link(source) in card.links,
        "a link to the data": "ledger.csv" in card.links,
        "LaTeX to copy": not is_latex(right) or card.copied("latex") == right,
        "SymPy to copy": not formula or card.copied("sympy") == derived.sympy(row.id),
    }
    yield from (what for what, there in wanted.items() if not there)
    for column, term in TERMS.items():
        if getattr(row, column) and not card.terms.get(term):
            yield term
