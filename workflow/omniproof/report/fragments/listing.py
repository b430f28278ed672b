"""The list of findings: a table that is complete without a script, and can be sorted with one.

A cell says in `data-order` how it sorts (verdicts by gravity, not by the alphabet) and in
`data-search` under which word it is filtered; `book/_static/findings.js` does both.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape

from omniproof.audit.ledger import Consequence, Row
from omniproof.report.anchors import anchor
from omniproof.report.findings import GRAVITY, REACH
from omniproof.report.fragments.base import Href, badge, table
from omniproof.report.fragments.rows import is_trivial, said_html
from omniproof.report.theme import MARKS

HEAD = ("paper", "place", "verdict", "kind", "changes", "finding")


def listing_html(rows: Iterable[Row], href: Mapping[str, Href]) -> str:
    """Return findings, given in order of place, as a table.

    By reach; of one reach, faults before remarks on wording and references; then by gravity.
    """
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


def _rank(row: Row) -> tuple[int, bool, int]:
    return REACH.index(reach_of(row)), is_trivial(row), GRAVITY.index(row.verdict)


def _line(place: int, row: Row, href: Href) -> str:
    reach = reach_of(row)
    cells = (
        _cell(row.paper, escape(row.paper)),
        _cell("", place_html(row), place),
        _cell(MARKS[row.verdict].word, badge(row.verdict), GRAVITY.index(row.verdict)),
        _cell(row.kind, escape(row.kind)),
        _cell(reach, escape(reach), REACH.index(reach)),
        _cell("", said_html(row, href)),
    )
    trivial = " data-trivial" if is_trivial(row) else ""
    return f'<tr class="v-{row.verdict}"{trivial}>{"".join(cells)}</tr>'


def _cell(word: str, html: str, order: int | None = None) -> str:
    search = f' data-search="{escape(word)}"' if word else ""
    sort = f' data-order="{order:04d}"' if order is not None else ""
    return f"<td{search}{sort}>{html}</td>"
