"""The list of findings: a table that is complete without a script, and can be sorted with one.

A cell says in `data-order` how it sorts (verdicts by gravity, not by the alphabet) and in
`data-search` under which word it is filtered; `book/_static/findings.js` does both.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape

from omniproof.audit.ledger import Consequence, Row
from omniproof.report.anchors import anchor
from omniproof.report.changes import changes
from omniproof.report.findings import GRAVITY, REACH
from omniproof.report.fragments.base import Href, badge, link, note_html, table
from omniproof.report.latexfmt import cell, is_latex
from omniproof.report.theme import MARKS
from omniproof.transcription.model import Kind

HEAD = ("paper", "place", "verdict", "kind", "changes", "finding")


def listing_html(rows: Iterable[Row], href: Mapping[str, Href]) -> str:
    """Return findings, given in order of place, as one table: by reach, then by gravity."""
    placed = sorted(enumerate(rows), key=lambda found: _rank(found[1]))
    lines = [_line(place, row, href[row.paper]) for place, row in placed]
    if not lines:
        return "<p>None.</p>"
    return table(HEAD, lines, "findings")


def place_html(row: Row) -> str:
    """Return where a finding stands, as a link to its card."""
    return f'<a href="{escape(row.paper)}.html#{anchor(row.id)}">{escape(row.where)}</a>'


def reach_of(row: Row) -> Consequence:
    """Return how far a finding reaches; one without a consequence is about the text."""
    return row.consequence or Consequence.TEXT


def _rank(row: Row) -> tuple[int, int]:
    return REACH.index(reach_of(row)), GRAVITY.index(row.verdict)


def _line(place: int, row: Row, href: Href) -> str:
    reach = reach_of(row)
    cells = (
        _cell(row.paper, escape(row.paper)),
        _cell("", place_html(row), place),
        _cell(MARKS[row.verdict].word, badge(row.verdict), GRAVITY.index(row.verdict)),
        _cell(row.kind, escape(row.kind)),
        _cell(reach, escape(reach), REACH.index(reach)),
        _cell("", _finding(row, href)),
    )
    return f'<tr class="v-{row.verdict}">{"".join(cells)}</tr>'


def _cell(word: str, html: str, order: int | None = None) -> str:
    search = f' data-search="{escape(word)}"' if word else ""
    sort = f' data-order="{order:04d}"' if order is not None else ""
    return f"<td{search}{sort}>{html}</td>"


def _finding(row: Row, href: Href) -> str:
    """Return what is printed, what is right, and what there is to say."""
    changed = changes(row.printed, row.correction) if row.correction else None
    printed = changed.printed if changed else row.printed
    correct = changed.corrected if changed else row.correction or row.derived
    follows = f" Follows from {link(row.follows, href)}." if row.follows else ""
    note = note_html(row.remark, href) + follows
    lines = (
        _labelled(_printed(row), printed, href),
        _labelled("correct", correct, href),
        _labelled("true when", row.assumption, href),
        f"<p>{note}</p>" if note else "",
    )
    return "".join(lines)


def _printed(row: Row) -> str:
    """Return what the ledger's column `printed` holds of this row: print, or what it says."""
    said = row.kind in {Kind.RELATION, Kind.REFERENCE} and not is_latex(row.printed)
    return "states" if said else "printed"


def _labelled(word: str, text: str, href: Href) -> str:
    if not text:
        return ""
    shown = cell(text, lambda claim: link(claim, href))
    return f'<p class="line"><span class="quiet">{word}</span> {shown}</p>'
