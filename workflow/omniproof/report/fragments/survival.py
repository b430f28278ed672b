"""What survives: the conclusions of a paper, and its faults with what rests on them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from omniproof.audit.ledger import Ledger, Row
from omniproof.report.fragments.base import Href, badge, link, table
from omniproof.report.latexfmt import cell
from omniproof.report.survival import (
    JUDGED,
    Fate,
    Fault,
    conclusions,
    fate,
    faults,
    tally,
)
from omniproof.transcription.ids import base

WORDS = {
    Fate.STANDS: "stand as printed",
    Fate.MENDED: "stand once a fault elsewhere is mended",
    Fate.LIMITED: "stand under a condition",
    Fate.FALLS: "fall",
    Fate.OPEN: "cannot be checked here",
}


def survives_html(ledger: Ledger, href: Href) -> str:
    """Return what stands, and what falls with which fault."""
    return f"{_sum(ledger)}{_conclusions(ledger, href)}{_faults(faults(ledger), href)}"


def _sum(ledger: Ledger) -> str:
    judged = [row for row in ledger.rows if row.kind in JUDGED]
    fates = ", ".join(f"<b>{count}</b> {WORDS[kind]}" for kind, count in tally(judged))
    return (
        f"<p>Of the {len(judged)} formulas, numbers and statements of this paper, {fates}. Each "
        "was derived from mechanics, not from the lines before it: what stands does so even where "
        "the paper gets to it by way of a misprint.</p>"
    )


def _conclusions(ledger: Ledger, href: Href) -> str:
    found = conclusions(ledger)
    lines = [_conclusion(row, href) for row in found if fate(row) is not Fate.OPEN]
    if not lines:
        return f"<h3>Conclusions</h3><p>{_none(len(found))}</p>"
    open_ = len(found) - len(lines)
    rest = f'<p class="quiet">{open_} more cannot be checked here.</p>' if open_ else ""
    head = ["what the paper concludes", "what becomes of it"]
    return f"<h3>Conclusions</h3>{table(head, lines, 'fates')}{rest}"


def _none(conclusions: int) -> str:
    if not conclusions:
        return "The abstract and the last section say nothing that is not in the sections between."
    return f"None of the {conclusions} in abstract and last section can be checked here."


def _conclusion(row: Row, href: Href) -> str:
    follows = link(row.follows, href) if row.follows else ""
    because = f", with {follows}" if follows else ""
    told = {
        Fate.STANDS: "stands",
        Fate.MENDED: f"stands once {follows} is mended",
        Fate.LIMITED: f"stands under the condition: {cell(row.assumption)}",
        Fate.FALLS: f"falls{because}"
        + (f"; in fact {cell(row.correction)}" * bool(row.correction)),
    }[fate(row)]
    return (
        f'<tr class="v-{row.verdict}"><td>{cell(row.printed)} '
        f'<span class="quiet">{link(row.id, href)}</span></td>'
        f"<td>{badge(row.verdict)} {told}</td></tr>"
    )


def _faults(found: Sequence[Fault], href: Href) -> str:
    carrying = [fault for fault in found if fault.falling or fault.standing]
    alone = len(found) - len(carrying)
    remark = f"Nothing else rests on {'the other ' if carrying else 'any of the '}{alone} faults."
    rest = f'<p class="quiet">{remark}</p>' if alone else ""
    if not carrying:
        return f"<h3>What rests on the faults</h3>{rest or '<p>There are no faults.</p>'}"
    lines = (
        f'<tr class="v-{fault.row.verdict}"><th scope="row">{badge(fault.row.verdict)} '
        f"{link(fault.row.id, href)}</th><td>{_places(fault.falling, href)}</td>"
        f"<td>{_places(fault.standing, href)}</td></tr>"
        for fault in carrying
    )
    head = ["fault", "has the same fault", "stands once it is mended"]
    shown = (
        f"<details><summary>{len(carrying)} with followers</summary>{table(head, lines, 'fates')}"
    )
    return f"<h3>What rests on the faults</h3>{shown}</details>{rest}"


def _places(rows: Iterable[Row], href: Href) -> str:
    """Return links, the entries of a matrix as one."""
    found = dict.fromkeys(base(row.id) for row in rows)
    return "; ".join(link(name, href) for name in found) or "nothing"
