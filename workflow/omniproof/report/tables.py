"""A paper's tables, made anew as CSV: what is printed beside what is computed, cell by cell.

The kind of table follows from its rows: cells of kind `value` make a table of numbers, anything
else (a nomenclature) a list.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from omniproof.audit.ledger import Row, read_json
from omniproof.report.anchors import selects
from omniproof.transcription.ids import index
from omniproof.transcription.model import Kind
from omniproof.transcription.paperfile import load_document

NUMBERS = ("row", "column", "printed", "unit", "interval", "computed", "verdict")
LIST = ("row", "printed", "verdict", "correction", "note")


def write_tables(folder: Path, ledger_path: Path, outputs: Mapping[int, Path]) -> None:
    """Write each table of a paper: `outputs` maps the number of a table to its file.

    folder: what the paper prints (`paper.yaml` has the units); ledger_path: its ledger. Raises
    `ValueError` when the ledger has no cell of a table.
    """
    rows = read_json(ledger_path).rows
    for number, path in outputs.items():
        cells = [row for row in rows if selects(f"tab:{number}[", row.id)]
        if not cells:
            raise ValueError(f"{ledger_path.name}: no cell of Table {number}")
        units = table_units(folder, number)
        path.write_text(table_csv(cells, units), encoding="utf-8")


def table_units(folder: Path, number: int) -> dict[str, str]:
    """Return the unit of each column of a table by the column's name in the ids."""
    document = load_document(folder / "paper.yaml").values
    tables = document.get("tables", []) if isinstance(document, dict) else []
    for table in tables:
        if isinstance(table, dict) and table.get("id") == f"tab:{number}":
            units = table.get("units", {})
            return {str(k): str(v) for k, v in units.items()} if isinstance(units, dict) else {}
    return {}


def table_csv(cells: Sequence[Row], units: Mapping[str, str]) -> str:
    """Return the table as CSV: of numbers when every cell is one, else as a list."""
    if all(cell.kind is Kind.VALUE for cell in cells):
        return _csv(NUMBERS, (_number(cell, units) for cell in cells))
    return _csv(LIST, (_line(cell) for cell in cells))


def _number(cell: Row, units: Mapping[str, str]) -> Sequence[str]:
    place = index(cell.id)
    column = place[1] if len(place) > 1 else ""
    bounds, value = (cell.interval.bounds, cell.interval.value) if cell.interval else ("", "")
    return (place[0], column, cell.printed, units.get(column, ""), bounds, value, cell.verdict)


def _line(cell: Row) -> Sequence[str]:
    return (",".join(index(cell.id)), cell.printed, cell.verdict, cell.correction, cell.remark)


def _csv(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue()
