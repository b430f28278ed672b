"""What papers assume and do not say: from the rows that hold only on a condition, or on a premise.

A list by hand would go stale; this one is read off the ledgers. A row without words of its own (a
statement that holds by the paper's premise) takes those of the rows with which it shares a root.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape

from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.report.fragments.base import Href, badge, link, table
from omniproof.report.latexfmt import cell
from omniproof.transcription.ids import base

UNSTATED = (Verdict.CONDITIONAL, Verdict.MODEL_GAP)


@dataclass(frozen=True)
class Assumption:
    """One unstated assumption of a paper, with the claims that need it, in order of place."""

    text: str
    verdict: Verdict
    claims: tuple[str, ...]


def assumptions(ledger: Ledger) -> tuple[Assumption, ...]:
    """Return what a paper assumes and does not state, in order of the first place."""
    rows = [row for row in ledger.rows if row.verdict in UNSTATED]
    words: dict[str, str] = {}
    for row in rows:
        if row.assumption:
            words.setdefault(_root(row), row.assumption)
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row.assumption or words.get(_root(row), row.note), []).append(row)
    return tuple(
        Assumption(text, group[0].verdict, tuple(dict.fromkeys(base(row.id) for row in group)))
        for text, group in found.items()
    )


def assumptions_html(
    ledgers: Iterable[Ledger], titles: Mapping[str, str], href: Mapping[str, Href]
) -> str:
    """Return a table of all unstated assumptions, paper by paper; `titles` are links, as HTML."""
    body = []
    for ledger in ledgers:
        lines = [_line(found, href[ledger.paper]) for found in assumptions(ledger)]
        head = f'<tr><th scope="rowgroup" colspan="2">{titles[ledger.paper]}</th></tr>'
        body += [head, *(lines or ['<tr><td colspan="2">None was found.</td></tr>'])]
    return table(["assumed, and not stated", "needed by"], body, "assumptions")


def _root(row: Row) -> str:
    return row.follows or row.id


def _line(found: Assumption, href: Href) -> str:
    places: Sequence[str] = [link(claim, href) for claim in found.claims]
    return (
        f'<tr class="v-{found.verdict}"><td>{cell(found.text) or escape(found.text)}</td>'
        f"<td>{badge(found.verdict)} {', '.join(places)}</td></tr>"
    )
