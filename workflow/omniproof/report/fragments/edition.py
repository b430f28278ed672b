"""What changed since the first edition: rows whose verdict is another one now, and why.

The verdicts of the first edition lie beside this module's package as data: they are what
`omniproof audit` of its last commit computes from the papers as they were written down then.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path

from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.report.fragments.base import Href, badge, table
from omniproof.report.fragments.listing import place_html
from omniproof.report.fragments.rows import said_html

FIRST = Path(__file__).parents[1] / "first-edition.csv"
COMMIT = "4e9956724"
"""Last commit of the first edition, from which `FIRST` was computed."""


@dataclass(frozen=True)
class Change:
    """One place: its verdict in the first edition, or none, and its row now, or none."""

    paper: str
    id: str
    before: Verdict | None
    now: Row | None


def read_first(path: Path = FIRST) -> dict[tuple[str, str], Verdict]:
    """Read the verdicts of the first edition, by paper and id."""
    with path.open(encoding="utf-8", newline="") as file:
        return {(row["paper"], row["id"]): Verdict(row["verdict"]) for row in csv.DictReader(file)}


def changes_since(
    first: dict[tuple[str, str], Verdict], ledgers: Sequence[Ledger]
) -> Iterator[Change]:
    """Yield what has another verdict now, in order of place; then what is not a row any more."""
    papers = {ledger.paper for ledger in ledgers}
    rows = {(row.paper, row.id): row for ledger in ledgers for row in ledger.rows}
    for (paper, claim), row in rows.items():
        before = first.get((paper, claim))
        if before is not row.verdict:
            yield Change(paper, claim, before, row)
    for (paper, claim), before in first.items():
        if paper in papers and (paper, claim) not in rows:
            yield Change(paper, claim, before, None)


def edition_html(changes: Iterable[Change], href: dict[str, Href]) -> str:
    """Return the changes as a table: place, verdict then and now, and what is known of it now."""
    lines = [_line(change, href[change.paper]) for change in changes]
    if not lines:
        return "<p>No verdict has changed.</p>"
    return table(("paper", "place", "first edition", "now", "what is known now"), lines, "list")


def _line(change: Change, href: Href) -> str:
    row = change.now
    cells = (
        escape(change.paper),
        place_html(row) if row else f"<code>{escape(change.id)}</code>",
        badge(change.before) if change.before else "no row",
        badge(row.verdict) if row else "no row",
        said_html(row, href) if row else "",
    )
    verdict = f' class="v-{row.verdict}"' if row else ""
    return f"<tr{verdict}>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>"
