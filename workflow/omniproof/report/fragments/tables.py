"""Tables of a paper as the audit sees them: printed beside computed, cell by cell."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape

from omniproof.audit.ledger import Row
from omniproof.report.fragments.base import Href, badge, interval_html, table
from omniproof.report.latexfmt import cell, inline
from omniproof.transcription.ids import index

Labels = Mapping[str, str]


def beside_html(rows: Sequence[Row], href: Href, columns: Labels, lines: Labels) -> str:
    """Return a grid of cells: printed, exact, interval, verdict, which leads to the cell's row.

    `columns`, `lines`: headings of the columns and rows by their name in the ids.
    """
    grid = {index(row.id): row for row in rows}
    names = list(dict.fromkeys(place[-1] for place in grid))
    sides = list(dict.fromkeys(place[0] for place in grid))
    head = ["", *(inline(columns.get(name, name)) for name in names)]
    body = []
    for side in sides:
        cells = "".join(_cell(grid.get((side, name)), href) for name in names)
        label = inline(lines.get(side, side))
        body.append(f'<tr><th scope="row">{label}</th>{cells}</tr>')
    return table(head, body, "beside")


def _cell(row: Row | None, href: Href) -> str:
    if row is None:
        return "<td></td>"
    sign = badge(row.verdict)
    if row.verdict.is_fault:
        sign = f'<a href="{escape(href(row.id) or "")}">{sign}</a>'
    interval = f'<span class="interval">{interval_html(row)}</span>' if row.interval else ""
    return (
        f'<td class="v-{row.verdict}"><b class="value">{cell(row.printed)}'
        f'</b> {sign}<span class="exact">{cell(row.derived)}</span>{interval}</td>'
    )


def grid_html(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return computed cells (text with `$math$`) under column heads; the first names the row."""
    body = [
        f'<tr><th scope="row">{inline(first)}</th>'
        + "".join(f"<td>{inline(text)}</td>" for text in others)
        + "</tr>"
        for first, *others in rows
    ]
    return table([inline(text) for text in head], body, "grid")
