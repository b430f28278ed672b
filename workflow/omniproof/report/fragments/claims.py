"""What is known of a claim, and the matrix that its rows are entries of."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from html import escape

from omniproof.audit.evidence import Counterexample
from omniproof.audit.ledger import Consequence, Origin, Repair, Row
from omniproof.report.anchors import anchor
from omniproof.report.changes import Changes
from omniproof.report.code_pages import code_link
from omniproof.report.derived import Derived
from omniproof.report.fragments.base import (
    Href,
    interval_html,
    link,
)
from omniproof.report.groups import Group, matrix_of
from omniproof.report.latexfmt import GREEK, cell, inline, is_latex, math, same
from omniproof.transcription.model import Kind, Reading, Source

_INTEGRAL = re.compile(r"int_(\w+)_from_(\w+)\((\w+)\)")
_VALUE = re.compile(r"(\w+)\((\w+)\)")
_PI = re.compile(r"\*?\bpi\b")

ENGINES: Mapping[str, str] = {
    "flint": "FLINT",
    "sympy": "SymPy",
    "z3": "Z3",
    "arb": "Arb balls",
    "modular": "modular arithmetic",
    "text": "comparison of texts",
    "exact": "exact arithmetic",
    "signs": "signs of balls",
    "read": "reading",
}
REPAIRS: Mapping[Repair, str] = {
    Repair.EXPLAINED: "one edit of the printed form makes it true",
    Repair.POSSIBLE: "two edits of the printed form make it true",
    Repair.MANUAL: "no small edit of the printed form makes it true",
}
CONSEQUENCES: Mapping[Consequence, str] = {
    Consequence.MOTION: "changes a predicted motion or a design choice",
    Consequence.NUMBER: "changes a printed number",
    Consequence.TEXT: "changes the text only",
}
SOURCES: Mapping[Source, str] = {
    Source.DOUBTFUL: "a fault of text recognition would explain it: look at the PDF",
    Source.LOST: "the text recognition lost this place",
}
READINGS: Mapping[Reading, str] = {
    Reading.GLYPHS: "read from re-encoded glyphs",
    Reading.RECONSTRUCTED: "reconstructed: the display is gone",
}


def matrix_html(group: Group) -> str:
    """Return the matrix as printed, with a box around every entry that has a fault.

    Entries of a product or an inverse that is not multiplied out share one formula: that is shown.
    """
    if group.whole:
        return math(group.whole, display=True)
    matrix = matrix_of(group, _boxed)
    return math(matrix, display=True) if matrix else ""


def _boxed(row: Row) -> str:
    return rf"\boxed{{{row.printed}}}" if row.verdict.is_fault else row.printed


def facts_html(
    row: Row, href: Href, derived: Derived | None = None, changed: Changes | None = None
) -> str:
    """Return what is known of a row as a list of terms; empty fields are left out.

    What a script offers to copy stands in attributes: the right form as LaTeX and as SymPy text.
    """
    facts = [*_facts(row, href, changed), *_evidence(row, href, derived)]
    items = "".join(f"<div><dt>{term}</dt><dd>{text}</dd></div>" for term, text in facts if text)
    right = row.correction or row.derived or row.printed
    copied = {
        "latex": right if is_latex(right) else "",
        "sympy": derived.sympy(row.id) if derived else "",
    }
    data = "".join(f' data-{name}="{escape(text)}"' for name, text in copied.items() if text)
    return f'<dl class="facts"{data}>{items}</dl>'


def _facts(row: Row, href: Href, changed: Changes | None) -> Sequence[tuple[str, str]]:
    shown_already = same(row.printed, row.derived) or same(row.correction, row.derived)
    correction = changed.corrected if changed else row.correction
    return (
        ("derived", "" if shown_already else cell(row.derived)),
        ("should read", cell(correction, lambda claim: link(claim, href))),
        ("change", changes_html(changed)),
        ("true when", cell(row.assumption)),
        ("counterexample", witness_html(row.witness)),
        ("exact value", interval_html(row)),
        ("follows from", link(row.follows, href) if row.follows else ""),
        ("repair", REPAIRS.get(row.repair, "") if row.kind is Kind.IDENTITY else ""),
        ("consequence", CONSEQUENCES.get(row.consequence, "")),
        ("source", SOURCES.get(row.source, "")),
        ("read as", READINGS.get(row.reading, "")),
    )


def _evidence(row: Row, href: Href, derived: Derived | None) -> Sequence[tuple[str, str]]:
    """Return who decided a row, by which code, and where it stands on the page and as data."""
    source = derived.source(row.id) if derived else ""
    return (
        ("decided by", decided_by(row)),
        ("derivation", derivation_html(source)),
        (
            "address",
            f'<a class="address" href="{_own(row, href)}">{escape(row.id)}</a> in '
            '<a href="ledger.csv">ledger.csv</a>',
        ),
    )


def derivation_html(source: str) -> str:
    """Return file and line of a derivation as a link to its code."""
    link = f'<a href="{escape(code_link(source))}"><code>{escape(source)}</code></a>'
    return link if source else ""


def changes_html(changed: Changes | None) -> str:
    """Return what a correction changes, in words that a screen reader says too."""
    return "; ".join(map(_change, changed.parts if changed else ()))


def _change(part: tuple[str, str]) -> str:
    old, new = (math(text) for text in part)
    if not part[1]:
        return f"{old} is left out"
    return f"{old} becomes {new}" if part[0] else f"{new} is added"


def _own(row: Row, href: Href) -> str:
    return escape(href(row.id) or f"#{anchor(row.id)}")


def decided_by(row: Row) -> str:
    """Return who decided a row: its engines, or a person who read the place."""
    if row.engines:
        return engine_names(row.engines)
    return "reading" if row.origin is Origin.READ else ""


def engine_names(engines: str) -> str:
    """Return `flint+modular+z3` in words: `FLINT, modular arithmetic, Z3`."""
    return escape(", ".join(ENGINES.get(name, name) for name in engines.split("+")))


def witness_html(witness: Counterexample | None) -> str:
    """Return a counterexample as a sentence with formulas."""
    if witness is None:
        return ""
    point = [f"{symbol_latex(name)}={_coordinate(x)}" for name, x in witness.point.items()]
    at = f"at {', '.join(map(math, point))}: " if point else ""
    return f"{at}printed {inline(witness.printed)}, derived {inline(witness.derived)}"


def _coordinate(text: str) -> str:
    """Return the LaTeX of a coordinate: a number, or a multiple of pi."""
    return _PI.sub(r"\\pi ", text)


def symbol_latex(name: str) -> str:
    r"""Return the LaTeX of a name: `alpha_1` gives `\alpha_{1}`, `v_1(t)` `v_{1}(t)`.

    `int_v_1_from_0(t)` is the integral of an unknown function (`audit.integrals`).
    """
    if integral := _INTEGRAL.fullmatch(name):
        function, lower, upper = integral.groups()
        return rf"\int_{{{lower}}}^{{{upper}}} {symbol_latex(function)}\,d{upper}"
    if value := _VALUE.fullmatch(name):
        return f"{symbol_latex(value[1])}({value[2]})"
    stem, _, sub = name.partition("_")
    head = rf"\{stem}" if stem in GREEK else stem
    if len(head) > 1 and stem not in GREEK:
        head = rf"\mathrm{{{stem}}}"
    if sub == "dot":
        return rf"\dot{{{head}}}"
    return f"{head}_{{{sub}}}" if sub else head
