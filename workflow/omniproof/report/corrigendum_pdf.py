"""A corrigendum as a PDF of at most two pages, typeset by Typst.

Typst needs no network and no installation of its own, embeds its fonts, and gives the same bytes
for the same content: the document has no date. The layout is `corrigendum.typ`; the content is
written here. What two pages do not hold is left out, minor things only, and counted.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable
from importlib.resources import files
from typing import Final

import typst

from omniproof.audit.ledger import Consequence, Row
from omniproof.formula.writers import words
from omniproof.report.anchors import anchor
from omniproof.report.corrigendum import Corrigendum, Item, Premise, place
from omniproof.report.fragments.base import sentences
from omniproof.report.fragments.claims import symbol_latex
from omniproof.report.groups import Group, matrix_of
from omniproof.report.theme import MARKS
from omniproof.report.typeset import cell, contrasted, inline, is_formula, math
from omniproof.transcription.ids import base, index, whole
from omniproof.transcription.model import Kind

PAGES = 2
ACCESSIBLE: Final = "ua-1"  # tags, and words for every formula: Typst refuses a document without
LONGEST_WITNESS = 4  # values; a longer one says less than its place in the report
LONGEST_LINE = 150  # characters of LaTeX; a longer formula gets the full width
_SYMBOL = re.compile(r"[A-Za-z]+_\w+")
_COUNT = "\n#context [#metadata(counter(page).final().first()) <pages>]"


def pdf(content: Corrigendum) -> bytes:
    """Typeset a corrigendum; the same content gives the same bytes.

    Raises `typst.TypstError` when Typst refuses the source, which is a defect of this module.
    """
    minor = len(content.minor)

    def fits(dropped: int) -> bool:
        return pages(source(content, minor - dropped)) <= PAGES

    kept = minor - bisect_left(range(minor), True, key=fits)
    text = source(content, kept).encode()
    return bytes(
        typst.compile(text, format="pdf", ignore_system_fonts=True, pdf_standards=ACCESSIBLE)
    )


def pages(text: str) -> int:
    """Return how many pages a Typst source fills."""
    document = (text + _COUNT).encode()
    return int(typst.query(document, "<pages>", "value", one=True, ignore_system_fonts=True))


def source(content: Corrigendum, minor: int) -> str:
    """Return the Typst source of a corrigendum with the first `minor` of its minor items."""
    kept = frozenset(content.minor[:minor])
    corrections = [item for item in content.corrections if not item.is_minor or item in kept]
    contradictions = [item for item in content.contradictions if item in kept]
    parts = [
        files("omniproof.report").joinpath("corrigendum.typ").read_text(encoding="utf-8"),
        _head(content),
        _call("corrections", map(_row, corrections)),
        *map(_premise, content.premises),
        _call("contradictions", map(_pair, contradictions)),
        _call("questions", map(_row, content.questions)),
        _end(content, len(content.minor) - len(kept)),
    ]
    return "\n".join(parts)


def _head(content: Corrigendum) -> str:
    edition = content.edition
    venue = ", ".join(str(part) for part in (edition.venue, edition.year) if part)
    venue = venue[:1].upper() + venue[1:]
    return (
        f"#show: sheet.with(title: {words(edition.title)}, "
        f"authors: {words(', '.join(edition.authors))}, venue: {words(venue)}, "
        f"text: {words(edition.source)}, sum: {words(edition.sha256[:16])}, "
        f"chapter: {words(f'{content.paper}.html')})"
    )


def _call(function: str, arguments: Iterable[str]) -> str:
    return "\n  ".join([f"#{function}(", *arguments]) + "\n)"


def _end(content: Corrigendum, dropped: int) -> str:
    counts = ", ".join(f"{n} {MARKS[verdict].word}" for verdict, n in content.unlisted.items())
    chapter = words(f"{content.paper}.html")
    return f"#end(dropped: {dropped}, unlisted: {words(counts)}, chapter: {chapter})"


def _row(item: Item) -> str:
    """Return one line of a table: place, printed and corrected, reason."""
    lead = item.lead
    if item.is_contradiction:
        name, body = _place(lead), _sides(item)
    elif item.is_table:
        name, body = _named(place(whole(lead.id))), _cells(item)
    else:
        name, body = _place(lead), _change(item)
    wide = is_formula(lead.printed) and len(lead.correction) > LONGEST_LINE
    reach = "" if lead.consequence is Consequence.TEXT else lead.consequence
    return (
        f"(place: [{name}], reach: {words(reach)}, address: {_address(lead)}, "
        f"wide: {str(wide).lower()}, body: [{body}], reason: [{_reason(item)}]),"
    )


def _premise(premise: Premise) -> str:
    """Return a premise in a sentence, with what its formulas are to read without it."""
    root = premise.root
    named = {
        "place": f"[{_place(root)}]",
        "address": _address(root),
        "says": f"[{cell(root.printed, _refer)}]",
        "supposed": f"[{inline(premise.supposed, _refer)}]",
        "law": f"[{cell(root.correction, _refer)}]",
        "also": f"[{'; '.join(map(_place, premise.statements))}]",
    }
    lines = map(_formula, premise.formulas)
    return _call("premise", [*(f"{name}: {text}," for name, text in named.items()), *lines])


def _right(row: Row) -> str:
    return row.correction or row.derived or row.printed


def _formula(rows: tuple[Row, ...]) -> str:
    """Return one line of a premise's table: a formula as printed, and as it should read."""
    group = Group(base(rows[0].id), rows)
    printed = (group.whole or matrix_of(group, lambda row: row.printed)) or rows[0].printed
    corrected = matrix_of(group, _right) if group.is_matrix else _right(rows[0])
    reach = next((row.consequence for row in rows if row.consequence), "")
    faulty = next(row for row in rows if row.verdict.is_fault)
    return (
        f"(place: [{_refer(group.base)}], reach: {words(reach)}, address: {_address(faulty)}, "
        f"wide: false, body: [#change([{math(printed)}], [{math(corrected)}])], "
        f"reason: [{_counterexample(faulty)}]),"
    )


def _change(item: Item) -> str:
    """Return what is printed and what it should read, and where else the same is to be mended."""
    lead = item.lead
    if is_formula(lead.printed) and is_formula(lead.correction):
        printed, corrected = contrasted(lead.printed, lead.correction)
    else:
        printed, corrected = (cell(text, _refer) for text in (lead.printed, lead.correction))
    exact = lead.witness.derived if lead.witness and lead.kind is Kind.VALUE else ""
    also = "; ".join(_place(row) for row in item.rows[1:])
    return (
        f"#change([{printed}], [{corrected}{f' #exact[{math(exact)}]' if exact else ''}])"
        f"{f'#also[{also}]' if also else ''}"
    )


def _cells(item: Item) -> str:
    """Return the cells of one table, each with its name, what is printed, and the exact value."""
    return " ".join(
        f"#entry([{_named(index(row.id))}], [{math(row.printed)}], "
        f"[{math(row.correction)} #exact[{math(row.witness.derived)}]])"
        for row in item.rows
        if row.witness
    )


def _pair(item: Item) -> str:
    return f"[{_sides(item)} #by({_address(item.lead)})],"


def _sides(item: Item) -> str:
    """Return the forms that disagree, each with its places."""
    places: dict[str, list[str]] = {}
    for row in item.rows:
        places.setdefault(row.printed, []).append(_place(row))
    return " #differs ".join(
        f"{cell(text, _refer)} #at[{'; '.join(named)}]" for text, named in places.items()
    )


def _address(row: Row) -> str:
    return words(f"#{anchor(row.id)}")


def _place(row: Row) -> str:
    return _refer(row.id)


def _refer(claim: str) -> str:
    return _named(place(claim))


def _named(names: Iterable[str]) -> str:
    """Return names joined by commas as markup; one with an index is a symbol, `N_1`."""
    return ", ".join(
        math(name) if _SYMBOL.fullmatch(name) else f"#{words(name)};" for name in names
    )


def _reason(item: Item) -> str:
    """Return why the printed form is wrong: the note of the row, or its counterexample."""
    lead = item.lead
    told = lead.remark if lead.kind is not Kind.IDENTITY else ""
    reason = inline(sentences(told), _refer) if told else _counterexample(lead)
    if lead.follows and lead.follows not in {row.id for row in item.rows}:
        return f"{reason} {inline(f'Follows from {lead.follows}.', _refer)}"
    return reason


def _counterexample(row: Row) -> str:
    if row.witness is None:
        return inline(row.remark, _refer)
    printed, true = (cell(text, _refer) for text in (row.witness.printed, row.witness.derived))
    values = row.witness.point.items()
    point = ", ".join(math(f"{symbol_latex(name)} = {value}") for name, value in values)
    if len(values) > LONGEST_WITNESS:
        point = "one choice of values"
    return f"{f'At {point}: p' if point else 'P'}rinted {printed}, true {true}."
