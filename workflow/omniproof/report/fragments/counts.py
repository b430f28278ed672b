"""The accounting: how many rows got which verdict, as a bar and as a table that adds up."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from html import escape

from omniproof.audit.ledger import Ledger, Verdict
from omniproof.report.fragments.base import badge, table
from omniproof.report.theme import MARKS


def verdict_counts(ledger: Ledger) -> Counter[Verdict]:
    """Return the number of rows of each verdict."""
    return Counter(row.verdict for row in ledger.rows)


def bar_html(ledger: Ledger) -> str:
    """Return one paper's verdicts as a bar; every part names its verdict by shape and number."""
    counts = verdict_counts(ledger)
    parts, words = [], []
    for verdict, mark in MARKS.items():
        if counts[verdict]:
            words.append(f"{counts[verdict]} {mark.word}")
            parts.append(
                f'<span class="v-{verdict}" style="flex-grow:{counts[verdict]}">'
                f"{mark.shape} {counts[verdict]}</span>"
            )
    label = escape(f"{len(ledger.rows)} rows: {', '.join(words)}")
    return f'<div class="bar" role="img" aria-label="{label}">{"".join(parts)}</div>'


def accounting_html(ledgers: Sequence[Ledger], *, linked: bool = False) -> str:
    """Return bars and the table of verdicts by paper, with the sums that have to agree.

    `linked`: head each column with a link to the paper's chapter.
    """
    counts = {ledger.paper: verdict_counts(ledger) for ledger in ledgers}
    bars = "".join(_bar_name(ledger, linked) + bar_html(ledger) for ledger in ledgers)
    names = [_name(ledger.paper, linked) for ledger in ledgers]
    body = []
    for verdict, mark in MARKS.items():
        if any(count[verdict] for count in counts.values()):
            cells = "".join(
                f'<td class="number" data-paper="{paper}" data-verdict="{verdict}">'
                f"{count[verdict]}</td>"
                for paper, count in counts.items()
            )
            body.append(f"<tr><td>{badge(verdict)}</td>{cells}<td>{mark.meaning}</td></tr>")
    body.append(_sums(ledgers))
    claims = "; ".join(f"{ledger.claims} claims in {ledger.paper}" for ledger in ledgers)
    remark = f'<p class="quiet">{claims}. A matrix is one claim, with a row for each entry.</p>'
    return bars + table(["verdict", *names, "meaning"], body, "accounting") + remark


def _bar_name(ledger: Ledger, linked: bool) -> str:
    # In its own chapter a paper's bar needs no name.
    return f'<div class="bar-name">{_name(ledger.paper, linked)}</div>' if linked else ""


def _name(paper: str, linked: bool) -> str:
    return f'<a href="{escape(paper)}.html">{escape(paper)}</a>' if linked else escape(paper)


def _sums(ledgers: Sequence[Ledger]) -> str:
    rows = "".join(
        f'<td class="number" data-paper="{ledger.paper}" data-verdict="all">{len(ledger.rows)}</td>'
        for ledger in ledgers
    )
    return f'<tr class="sum"><td>all</td>{rows}<td>every row has one verdict</td></tr>'
