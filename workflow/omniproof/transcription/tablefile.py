"""Printed tables as CSV: a header, then one named row a line; each cell becomes a claim.

The cells stay text, so that `4.00` keeps its zeros.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass
from io import StringIO
from pathlib import Path

from omniproof.transcription.faults import BadInput, Fault, nearest, shorten
from omniproof.transcription.files import display_name, read_text
from omniproof.transcription.model import Claim, Kind, Table

INDEX = re.compile(r"[A-Za-z0-9_]+")
DECIMAL = re.compile(r"[+-]?\d+(\.\d*)?")
MAX_CELL = 40


@dataclass(frozen=True)
class Cell:
    """One printed cell and its place in the CSV file."""

    claim: Claim
    file: str
    line: int
    column: int


@dataclass(frozen=True)
class _Row:
    """One line of a CSV file."""

    line: int
    cells: tuple[str, ...]

    def column(self, place: int) -> int:
        """Where a cell starts, if nothing before it is quoted."""
        return 1 + sum(len(cell) + 1 for cell in self.cells[:place])


def load_table(folder: Path, table: Table) -> tuple[Cell, ...]:
    """Read a table; `table.line` is the source line of its first row, the others follow.

    Raises `BadInput` with all faults of the CSV file.
    """
    name = display_name(folder / table.file)
    rows = _rows(name, read_text(folder / table.file))
    faults = [
        Fault(name, row.line, row.column(place), _name(table, rows[0], row, place), message, cure)
        for row, place, message, cure in _check(rows)
    ]
    if faults:
        raise BadInput(faults)
    header, *body = rows
    return tuple(
        Cell(
            _claim(table, header.cells[place], row, place, table.line + offset),
            name,
            row.line,
            row.column(place),
        )
        for offset, row in enumerate(body)
        for place in range(1, len(row.cells))
    )


def unit_faults(table: Table, cells: tuple[Cell, ...]) -> Iterator[tuple[str, str, str]]:
    """Units of columns that the table does not have: column, message, cure."""
    columns = {str(cell.claim.id).split(",")[-1].rstrip("]") for cell in cells}
    for column in table.units:
        if column not in columns:
            known = ", ".join(sorted(columns))
            message = f"expected a column of {table.file} ({known}), found {shorten(column)}"
            yield column, message, nearest(column, columns)


def _claim(table: Table, column: str, row: _Row, place: int, line: int) -> Claim:
    return Claim(
        id=f"{table.id}[{row.cells[0]},{column}]",
        kind=Kind.VALUE,
        line=line,
        says=table.says,
        printed=row.cells[place],
        unit=table.units.get(column),
    )


def _name(table: Table, header: _Row, row: _Row, place: int) -> str:
    """The id of a cell, where a fault is in one; else of the table."""
    if row is header or not 0 < place < len(header.cells):
        return str(table.id)
    return f"{table.id}[{row.cells[0]},{header.cells[place]}]"


def _rows(name: str, text: str) -> list[_Row]:
    reader = csv.reader(StringIO(text, newline=""), strict=True)
    rows: list[_Row] = []
    try:
        for cells in reader:
            rows.append(_Row(reader.line_num, tuple(cell.strip() for cell in cells)))
    except csv.Error as error:
        message = f"expected CSV, found a fault: {error}"
        raise BadInput([Fault(name, reader.line_num or 1, 1, "", message)]) from None
    rows = [row for row in rows if row.cells]
    if len(rows) < 2:
        message = "expected a header and at least one row"
        raise BadInput([Fault(name, 1, 1, "", f"{message}, found {len(rows)} lines")])
    return rows


def _check(rows: list[_Row]) -> Iterator[tuple[_Row, int, str, str]]:
    """Row, cell, message and cure of every fault."""
    header = rows[0]
    if len(header.cells) == 1:
        cure = "put a comma between any two cells"
        yield header, 0, f"expected columns, found one: {shorten(header.cells[0])}", cure
        return
    columns = [(header, place, name) for place, name in enumerate(header.cells) if place]
    yield from _check_names("column", columns)
    yield from _check_names("row", [(row, 0, row.cells[0]) for row in rows[1:]])
    for row in rows[1:]:
        if len(row.cells) != len(header.cells):
            found = f"expected {len(header.cells)} cells as in the header, found {len(row.cells)}"
            yield row, 0, found, "give every row the same number of cells"
        for place, cell in enumerate(row.cells):
            if place and not (DECIMAL.fullmatch(cell) and len(cell) <= MAX_CELL):
                message = f"expected a decimal such as 4.00, found {shorten(cell)}"
                cure = "write the digits that the paper prints, zeros included"
                yield row, place, message if cell else "expected a decimal, found nothing", cure


def _check_names(
    kind: str, names: list[tuple[_Row, int, str]]
) -> Iterator[tuple[_Row, int, str, str]]:
    seen: dict[str, int] = {}
    for row, place, name in names:
        if not INDEX.fullmatch(name) or len(name) > MAX_CELL:
            message = f"expected a {kind} name of letters, digits and `_`, found {shorten(name)}"
            yield row, place, message, "use the name that the ids of the cells shall have"
        elif name in seen:
            message = f"expected each {kind} name once, found `{name}` again"
            yield row, place, message, f"the first one is on line {seen[name]}"
        seen.setdefault(name, row.line)
