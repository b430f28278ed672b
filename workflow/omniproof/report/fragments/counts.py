"""The accounting: how many rows got which verdict, as a bar and as a table that adds up."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from html import escape

from omniproof.audit.ledger import Ledger, Verdict
from omniproof.report.fragments.base import badge, table
from omniproof.report.theme import MARKS

ALL = "all"
"""Name of the sum over all papers among the names of papers."""


def verdict_counts(ledger: Ledger) -> Counter[Verdict]:
    """Return the number of rows of each verdict."""
    return Counter(row.verdict for row in ledger.rows)


def bar_html(ledger: Ledger) -> str:
    """Return one paper's verdicts as a bar, true to scale: no word in it widens a part."""
    counts = dict(_counted(ledger))
    parts = (
        f'<span class="v-{verdict}" style="width:{100 * number / len(ledger.rows):.4f}%"></span>'
        for verdict, number in counts.items()
    )
    words = ", ".join(f"{number} {MARKS[verdict].word}" for verdict, number in counts.items())
    label = escape(f"{len(ledger.rows)} rows: {words}")
    return f'<div class="bar" role="img" aria-label="{label}">{"".join(parts)}</div>'


def legend_html(ledger: Ledger) -> str:
    """Return what a bar shows in words: shape, number and name of each verdict."""
    items = (badge(verdict, str(number)) for verdict, number in _counted(ledger))
    return f'<p class="legend">{" ".join(items)}</p>'


def _counted(ledger: Ledger) -> list[tuple[Verdict, int]]:
    counts = verdict_counts(ledger)
    return [(verdict, counts[verdict]) for verdict in MARKS if counts[verdict]]


def accounting_html(ledger: Ledger) -> str:
    """Return one paper's bar, and its table of verdicts with their meaning and the sum."""
    counts = verdict_counts(ledger)
    body = [
        f"<tr><td>{badge(verdict)}</td>{_number(ledger.paper, str(verdict), counts[verdict])}"
        f"<td>{mark.meaning}</td></tr>"
        for verdict, mark in MARKS.items()
        if counts[verdict]
    ]
    total = _number(ledger.paper, "all", len(ledger.rows))
    body.append(f'<tr class="sum"><td>all</td>{total}<td>every row has one verdict</td></tr>')
    remark = f"{ledger.claims} claims. A matrix is one claim, with a row for each entry."
    head = ["verdict", "rows", "meaning"]
    return f'{bar_html(ledger)}{table(head, body, "accounting")}<p class="quiet">{remark}</p>'


def matrix_html(ledgers: Sequence[Ledger]) -> str:
    """Return verdicts by paper, with sums both ways; heads are links to the chapters."""
    counts = {ledger.paper: verdict_counts(ledger) for ledger in ledgers}
    total = sum(counts.values(), Counter[Verdict]())
    body = [
        f"<tr><td>{badge(verdict)}</td>"
        + "".join(_number(paper, str(verdict), count[verdict]) for paper, count in counts.items())
        + f"{_number(ALL, str(verdict), total[verdict])}</tr>"
        for verdict in MARKS
        if total[verdict]
    ]
    sums = "".join(_number(ledger.paper, "all", len(ledger.rows)) for ledger in ledgers)
    whole = _number(ALL, "all", sum(total.values()))
    body.append(f'<tr class="sum"><td>all</td>{sums}{whole}</tr>')
    names = [f'<a href="{escape(paper)}.html">{escape(paper)}</a>' for paper in counts]
    return table(["verdict", *names, "all"], body, "accounting matrix")


def _number(paper: str, verdict: str, number: int) -> str:
    return f'<td class="number" data-paper="{escape(paper)}" data-verdict="{verdict}">{number}</td>'
