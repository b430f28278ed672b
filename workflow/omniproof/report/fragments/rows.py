"""Every row of a paper as one table: a line each, complete in itself, and a file of details beside.

A line says what is printed and, of a fault, what is right and why. All that is known of a row (its
card) is made by a script when a reader asks for it (`book/_static/rows.js`); filtering is, too.
Without a script every line stands there.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from html import escape
from pathlib import Path

from omniproof.audit.ledger import Consequence, Ledger, Row, Verdict
from omniproof.audit.places import where
from omniproof.report.anchors import anchor, rows_anchor
from omniproof.report.changes import changes
from omniproof.report.derived import Derived
from omniproof.report.fragments.addresses import Addresses
from omniproof.report.fragments.base import (
    Href,
    badge,
    link,
    note_html,
    worst,
)
from omniproof.report.fragments.claims import facts_html, matrix_html
from omniproof.report.groups import Group, groups
from omniproof.report.latexfmt import cell, inline, is_latex
from omniproof.transcription.ids import whole
from omniproof.transcription.model import Kind

FOLDER = "rows"
HEAD = ("place", "verdict", "what is printed, and what there is to say")
_QUIET = frozenset({Verdict.EDITORIAL, Verdict.INCONSISTENT})


def rows_html(ledger: Ledger, href: Href, addresses: Addresses) -> str:
    """Return the table of all rows of a paper, in the order of the ledger."""
    columns = "".join(f'<th scope="col">{name}</th>' for name in HEAD)
    bodies = "".join(_body(group, href, addresses) for group in groups(ledger.rows))
    return (
        f'<div class="rows" data-paper="{escape(ledger.paper)}"><table class="audit list">'
        f"<thead><tr>{columns}</tr></thead>{bodies}</table></div>"
    )


def _body(group: Group, href: Href, addresses: Addresses) -> str:
    """Return the rows of a claim; the first ones of an equation bear the address of its rows."""
    equation = whole(group.base)
    first = equation.startswith("eq:") and addresses.take(rows_anchor(equation))
    address = f' id="{rows_anchor(equation)}"' if first else ""
    head = _whole(group, addresses) if group.is_matrix else ""
    bare = bool(group.whole)
    lines = "".join(
        _line(row, href, bare=bare, addressed=not addresses.is_answered(row.id))
        for row in group.rows
    )
    return f"<tbody{address}>{head}{lines}</tbody>"


def _whole(group: Group, addresses: Addresses) -> str:
    verdict = worst(group.rows)
    count = sum(row.verdict is verdict for row in group.rows)
    address = f' id="{anchor(group.base)}"' if addresses.take(anchor(group.base)) else ""
    return (
        f'<tr class="whole v-{verdict}"{address}><th scope="rowgroup" colspan="{len(HEAD)}">'
        f"{badge(verdict, f'{count} of {len(group.rows)}')} "
        f"{inline(where(group.base))}{matrix_html(group)}</th></tr>"
    )


def _line(row: Row, href: Href, *, bare: bool, addressed: bool) -> str:
    """Return the line of a row; one whose address an answer bears is known by `data-row`."""
    name = "id" if addressed else "data-row"
    trivial = " data-trivial" if is_trivial(row) else ""
    return (
        f'<tr class="claim v-{row.verdict}" {name}="{anchor(row.id)}" data-verdict="{row.verdict}" '
        f'data-claim="{row.kind}"{trivial}><th scope="row">{inline(row.where)}</th>'
        f"<td>{badge(row.verdict)}</td><td>{said_html(row, href, bare=bare)}</td></tr>"
    )


def is_trivial(row: Row) -> bool:
    """Whether a fault is one of wording, names or references: it changes no formula, no number."""
    about_text = row.consequence in {"", Consequence.TEXT} and row.verdict in _QUIET
    return row.verdict.is_fault and (about_text or row.kind in {Kind.REFERENCE, Kind.EDITORIAL})


def said_html(row: Row, href: Href, *, bare: bool = False) -> str:
    """Return what is printed, what is right, and what there is to say; if verified, the first.

    `bare` leaves out what is printed, where that stands above already.
    """
    changed = changes(row.printed, row.correction) if row.correction else None
    printed = changed.printed if changed else row.printed
    if row.verdict is Verdict.VERIFIED:
        return "" if bare else _labelled("", printed, href, "printed")
    correct = changed.corrected if changed else row.correction or row.derived
    follows = f" Follows from {link(row.follows, href)}." if row.follows else ""
    note = note_html(row.remark, href) + follows
    lines = (
        _labelled(_printed(row), "" if bare else printed, href, "printed"),
        _labelled("correct", correct, href),
        _labelled("true when", row.assumption, href),
        f'<p class="note">{note}</p>' if note else "",
    )
    return "".join(lines)


def _printed(row: Row) -> str:
    """Return what the ledger's column `printed` holds of this row: print, or what it says."""
    said = row.kind in {Kind.RELATION, Kind.REFERENCE} and not is_latex(row.printed)
    return "states" if said else "printed"


def _labelled(word: str, text: str, href: Href, kind: str = "") -> str:
    if not text:
        return ""
    shown = cell(text, lambda claim: link(claim, href))
    label = f'<span class="quiet">{word}</span> ' if word else ""
    classes = " ".join(["line", *[kind] * bool(kind), *["formula"] * is_latex(text)])
    return f'<div class="{classes}">{label}{shown}</div>'


def details_script(ledger: Ledger) -> str:
    """Return a script with the details of every row, by its anchor.

    A script and not data: browsers let a page from disk load nothing else.
    """
    addresses, derived = Addresses(ledger), Derived(ledger)
    details = {anchor(row.id): details_html(row, addresses.href, derived) for row in ledger.rows}
    return details_text(ledger.paper, details)


def details_html(row: Row, href: Href, derived: Derived | None = None) -> str:
    """Return all that is known of a row: its note, where its line does not say it, and facts."""
    said = row.verdict is not Verdict.VERIFIED or not row.remark
    note = "" if said else f'<p class="note">{note_html(row.remark, href)}</p>'
    changed = changes(row.printed, row.correction) if row.correction else None
    return note + facts_html(row, href, derived, changed)


def details_text(paper: str, details: dict[str, str]) -> str:
    """Write details as a script: each line is the address and the HTML of one row."""
    lines = ",\n".join(f"{json.dumps(key)}: {_quoted(html)}" for key, html in details.items())
    return f"(window.rowsOf ??= {{}})[{json.dumps(paper)}] = {{\n{lines}\n}};\n"


def read_details(script: str) -> dict[str, str]:
    """Read back what `details_text` wrote."""
    _, _, data = script.partition(" = ")
    details: dict[str, str] = json.loads(data.rstrip().removesuffix(";"))
    return details


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("</", "<\\/")


def write_details(folder: Path, ledgers: Iterable[Ledger]) -> None:
    """Write the details of each paper's rows into `folder / "rows"`."""
    (folder / FOLDER).mkdir()
    for ledger in ledgers:
        script = details_script(ledger)
        (folder / FOLDER / f"{ledger.paper}.js").write_text(script, encoding="utf-8")
