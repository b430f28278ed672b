"""Tables of a paper as the audit sees them: printed beside computed, cell by cell."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape

from omniproof.audit.ledger import Row, Verdict
from omniproof.report.anchors import anchor
from omniproof.report.changes import changes
from omniproof.report.derived import Derived
from omniproof.report.fragments.base import Href, badge, interval_html, link, note_html, table
from omniproof.report.fragments.claims import facts_html, row_html
from omniproof.report.latexfmt import cell, inline
from omniproof.transcription.ids import index

Labels = Mapping[str, str]


def beside_html(
    rows: Sequence[Row],
    href: Href,
    columns: Labels,
    lines: Labels,
    derived: Derived | None = None,
) -> str:
    """Return a grid of cells (printed, exact, interval, verdict), then the cards of the faults.

    `columns`, `lines`: headings of the columns and rows by their name in the ids.
    """
    grid = {index(row.id): row for row in rows}
    names = list(dict.fromkeys(place[-1] for place in grid))
    sides = list(dict.fromkeys(place[0] for place in grid))
    head = ["", *(inline(columns.get(name, name)) for name in names)]
    body = []
    for side in sides:
        cells = "".join(_cell(grid.get((side, name))) for name in names)
        label = inline(lines.get(side, side))
        body.append(f'<tr><th scope="row">{label}</th>{cells}</tr>')
    faults = [row for row in rows if row.verdict is not Verdict.VERIFIED]
    cards = "".join(row_html(row, href, addressed=False, derived=derived) for row in faults)
    return table(head, body, "beside") + cards


def _cell(row: Row | None) -> str:
    if row is None:
        return "<td></td>"
    interval = f'<span class="interval">{interval_html(row)}</span>' if row.interval else ""
    return (
        f'<td id="{anchor(row.id)}" class="v-{row.verdict}"><b class="value">{cell(row.printed)}'
        f'</b> {badge(row.verdict)}<span class="exact">{cell(row.derived)}</span>{interval}</td>'
    )


def list_html(rows: Sequence[Row], href: Href, derived: Derived | None = None) -> str:
    """Return one line per row: printed, verdict, what there is to say (a nomenclature, say).

    What is known of a fault unfolds in its line, which is its card.
    """
    body = []
    for row in rows:
        said = "".join(f"<p>{part}</p>" for part in _said(row, href) if part)
        kind = f"v-{row.verdict}"
        if row.verdict.is_fault:
            facts = facts_html(row, href, derived, changes(row.printed, row.correction))
            said += f"<details><summary>evidence</summary>{facts}</details>"
            kind = f"claim {kind}"
        body.append(
            f'<tr id="{anchor(row.id)}" class="{kind}">'
            f'<th scope="row">{cell(row.printed) or escape(row.where)}</th>'
            f"<td>{badge(row.verdict)}</td><td>{said}</td></tr>"
        )
    return table(["printed or stated", "verdict", "remark"], body, "list")


def grid_html(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return computed cells (text with `$math$`) under column heads; the first names the row."""
    body = [
        f'<tr><th scope="row">{inline(first)}</th>'
        + "".join(f"<td>{inline(text)}</td>" for text in others)
        + "</tr>"
        for first, *others in rows
    ]
    return table([inline(text) for text in head], body, "grid")


def _said(row: Row, href: Href) -> Sequence[str]:
    corrected = row.correction or (row.derived if row.verdict is not Verdict.VERIFIED else "")
    target = cell(corrected, lambda claim: link(claim, href))
    return (note_html(row.remark, href), f"should read: {target}" if corrected else "")
