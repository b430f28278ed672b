"""A printed claim and the formula that a chapter derived for it, below each other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape

from omniproof.audit.ledger import Row
from omniproof.audit.places import where
from omniproof.report.anchors import anchor
from omniproof.report.changes import changes
from omniproof.report.fragments.base import Fragment, badge, interval_html, worst
from omniproof.report.fragments.claims import decided_by, witness_html
from omniproof.report.latexfmt import cell, is_latex, math, same


def printed_beside(claim: str, latex: str, derived: str, rows: Sequence[Row]) -> Fragment:
    """Show what a claim prints (`latex`) and what was `derived`, its verdict, and its proof.

    `rows`: those of the claim; of a matrix, the gravest speaks for all.
    """
    verdict = worst(rows)
    row = next(row for row in rows if row.verdict is verdict)
    correction = row.correction if len(rows) == 1 else ""
    facts = [*_formulas(latex, derived, correction), *_evidence(row)]
    items = "".join(f"<div><dt>{term}</dt><dd>{html}</dd></div>" for term, html in facts if html)
    html = (
        f'<div class="printed-check v-{verdict}"><p>{badge(verdict)} '
        f'<a href="{escape(row.paper)}.html#{anchor(claim)}">{escape(where(claim))}</a> '
        f'<span class="quiet">{escape(row.paper)}</span></p><dl class="facts">{items}</dl></div>'
    )
    return Fragment(html, f"{row.paper} {claim}: {verdict}")


def _formulas(latex: str, derived: str, correction: str) -> Iterator[tuple[str, str]]:
    changed = changes(latex, correction) if correction else None
    yield "printed", _large(changed.printed if changed else latex)
    yield "derived", _large(derived)
    if not same(correction, derived):
        yield "should read", _large(changed.corrected if changed else correction)


def _evidence(row: Row) -> Iterator[tuple[str, str]]:
    yield "true when", cell(row.assumption)
    yield "exact value", interval_html(row)
    yield "counterexample", "" if row.interval else witness_html(row.witness)
    yield "decided by", decided_by(row)


def _large(text: str) -> str:
    """Return a formula in the large style, in a box that scrolls; words as they are."""
    return math(text, display=True) if is_latex(text) else cell(text)
