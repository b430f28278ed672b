"""Everything a source text prints that could be checked, so that omissions become visible.

`scan` finds equation numbers, table cells, numerals, comparisons and references by simple patterns
that know nothing of the claims; `inventory.csv` gives each of them a claim, or the reason for
leaving it out. What is compared are three lists: the text, the inventory, the claims.
"""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from omniproof.transcription.faults import BadInput, Fault, nearest, shorten
from omniproof.transcription.files import display_name, read_text
from omniproof.transcription.ids import whole
from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.model import Kind, Source

PRINTED = frozenset({Kind.IDENTITY, Kind.VALUE, Kind.REFERENCE})
COLUMNS = ["line", "item", "text", "claim", "reason"]

NUMBER_WORDS = {
    "two": "2", "three": "3", "four": "4", "five": "5", "six": "6", "seven": "7", "eight": "8",
    "nine": "9", "ten": "10",
}  # fmt: skip
COMPARISON_WORDS = """
smallest largest smaller larger minimal maximal minimum maximum minimise minimised minimize
minimized maximise maximised maximize maximized most least less more greater fewer highest lowest
shortest longest equal equals equivalent same similar identical different close closer stretched
perpendicular parallel orthogonal symmetrical symmetric symmetry equilateral isosceles regular
convex concave unit opposite increases decreases increasing decreasing effective ineffective
efficient easy excellent arbitrary arbitrarily all always never every only
"""
COMPARISON_SIGNS = ["<", ">", "≤", "≥", "≠", "≈", r"\\leq?(?![a-z])", r"\\geq?(?![a-z])",
                    r"\\neq(?![a-z])", r"\\approx", r"\\Leftrightarrow"]  # fmt: skip

_LABEL = r"\((?:\\text\s*\{)?[A-Z]?(?:\})?[,.]?\s*\d+(?:-\d+)?\)"
_NUMBER = r"\d+[a-z]?(?:\s?\([a-z]\))?"
_AND = r"(?:\s*(?:,|and|or|to|-|–|—|through)\s*(?:and\s*)?"
RULES = (
    ("tag", r"<[^>]*sup[^>]*>[^<]*<[^>]*sup>|</?[a-z][^>]*>|<https?:[^>]*>|[\w.-]+@[\w.-]+"),
    ("tag", r"<\|[^|>]*\|>"),
    ("equation", rf"\\q?quad\s*{_LABEL}|\\tag\s*\{{[^{{}}]*\}}"),
    ("reference", rf"\bEq(?:s?\.?|uations?)\s*\([A-Z]?[,.]?\d+(?:-\d+)?\)"
                  rf"{_AND}\([A-Z]?[,.]?\d+(?:-\d+)?\))*"),
    ("reference", rf"\b(?:Figures?|Figs?\.|Tables?|Chapters?|Sections?)\s*{_NUMBER}"
                  rf"{_AND}(?:{_NUMBER}|\([a-z]\)))*"),
    ("reference", r"\bAppendix\s*\([A-Z]\)"),
    ("reference", r"\[\d+\]"),
    ("equation", r"\([A-Z]\.\d+\)(?=\s*$)"),
    ("script", r"[_^]\s*(?:\{[^{}]*\}|\\[A-Za-z]+|\d)|\\text\s*\{\s*\[[^\]]*\]\s*\}"),
    ("comparison", "|".join(COMPARISON_SIGNS)),
    ("comparison", rf"\b(?:{'|'.join(COMPARISON_WORDS.split())})\b"),
    ("numeral", r"(?<![\w\\.])\d+(?:\.\d+)?(?![\w]*@)"),
    ("numeral", rf"\b(?:{'|'.join(NUMBER_WORDS)})\b"),
)  # fmt: skip
"""Patterns of items, first match first; `tag` and `script` are read over."""
_SCANNER = re.compile("|".join(f"(?P<k{i}>{rule})" for i, (_, rule) in enumerate(RULES)), re.I)
_SKIPPED = frozenset({"tag", "script"})


@dataclass(frozen=True, order=True)
class Item:
    """One thing that could be checked: `ordinal` counts its kind on the line, from 1."""

    line: int
    column: int
    kind: str
    ordinal: int
    text: str

    @property
    def key(self) -> tuple[int, str]:
        """Line and name, as the inventory has them: `(135, "numeral-2")`."""
        return self.line, f"{self.kind}-{self.ordinal}"


@dataclass(frozen=True)
class Row:
    """One line of an inventory: an item, and its claims or the reason for leaving it out."""

    line: int
    item: str
    text: str
    claims: tuple[str, ...]
    reason: str
    place: int


def scan(source: str) -> tuple[Item, ...]:
    """List everything in a source text that could be checked, in order of place."""
    items: list[Item] = []
    for number, line in enumerate(source.split("\n"), 1):
        counts: Counter[str] = Counter()
        for column, kind, text in sorted([*_cells(line), *_matches(line)]):
            counts[kind] += 1
            items.append(Item(number, column, kind, counts[kind], text))
    return tuple(items)


def _cells(line: str) -> Iterator[tuple[int, str, str]]:
    """The cells of a line that is a row of a table."""
    column = 0
    for cell in line.split("\t") if "\t" in line else ():
        if cell.strip():
            yield column, "cell", cell.strip()
        column += len(cell) + 1


def _matches(line: str) -> Iterator[tuple[int, str, str]]:
    """The items inside a line; of a table's rows the cells are items enough."""
    for match in _SCANNER.finditer(line if "\t" not in line else ""):
        kind = RULES[int(str(match.lastgroup)[1:])][0]
        if kind not in _SKIPPED:
            yield match.start(), kind, match.group()


def load_inventory(path: Path) -> tuple[Row, ...]:
    """Read an inventory; raises `BadInput` with all its faults."""
    name = display_name(path)
    lines = list(csv.reader(read_text(path).splitlines(keepends=True)))
    if not lines or lines[0] != COLUMNS:
        message = f"expected the header {','.join(COLUMNS)}"
        raise BadInput([Fault(name, 1, 1, "", message, "write it on the first line")])
    rows, faults = list[Row](), list[Fault]()
    for place, cells in enumerate(lines[1:], 2):
        if len(cells) != len(COLUMNS) or not cells[0].isdigit():
            message = f"expected {len(COLUMNS)} cells, the first one a line number"
            faults.append(Fault(name, place, 1, "", f"{message}, found {shorten(','.join(cells))}"))
            continue
        line, item, text, claims, reason = cells
        rows.append(Row(int(line), item, text, tuple(claims.split()), reason, place))
        if bool(claims.strip()) == bool(reason.strip()):
            message = "expected either a claim or the reason for having none"
            found = "both" if claims.strip() else "neither"
            faults.append(Fault(name, place, 1, item, f"{message}, found {found}"))
    if faults:
        raise BadInput(faults)
    return tuple(rows)


def compare(
    rows: Collection[Row],
    loaded: LoadedPaper,
    source: str | None = None,
    name: str = "inventory.csv",
) -> list[Fault]:
    """List what is missing either way between inventory, claims and (if present) source text."""
    faults = [*_unknown_claims(rows, loaded, name), *_unlisted_claims(rows, loaded)]
    if source is not None:
        faults += _against_source(rows, scan(source), name)
    return sorted(faults)


def _unknown_claims(rows: Iterable[Row], loaded: LoadedPaper, name: str) -> Iterator[Fault]:
    for row in rows:
        for claim in row.claims:
            if claim not in loaded.positions:
                message = f"expected the id of a claim, found {shorten(claim)}"
                yield Fault(name, row.place, 1, row.item, message, nearest(claim, loaded.positions))


def _unlisted_claims(rows: Iterable[Row], loaded: LoadedPaper) -> Iterator[Fault]:
    """Claims that rest on something printed as an item, and that no row names.

    Of a lost display nothing is printed.
    """
    named = {claim for row in rows for claim in row.claims}
    wholes = {whole(claim) for claim in named}
    for claim in loaded.claims:
        if claim.kind in PRINTED and claim.source is not Source.LOST:
            if claim.id in named or (claim.id.startswith("eq:") and whole(claim.id) in wholes):
                continue
            message = "expected a row of the inventory that names this claim, found none"
            yield loaded.fault(claim.id, message, f"name it in a row for line {claim.line}")


def _against_source(rows: Iterable[Row], items: Iterable[Item], name: str) -> Iterator[Fault]:
    listed = {(row.line, row.item): row for row in rows}
    found = {item.key: item for item in items}
    last = max((row.place for row in rows), default=1)
    for key, item in found.items():
        row = listed.get(key)
        if row is None:
            message = f"expected a row for {item.key[1]} of line {item.line}, {shorten(item.text)}"
            yield Fault(name, last + 1, 1, "", f"{message}, found none", "add it")
        elif row.text != item.text:
            message = f"expected {shorten(item.text)} as in the source, found {shorten(row.text)}"
            yield Fault(name, row.place, 1, row.item, message, "copy the text of the source")
    for key, row in listed.items():
        if key not in found:
            message = f"expected an item of the source text, found {shorten(row.text)}"
            yield Fault(name, row.place, 1, row.item, message, "remove the row")
