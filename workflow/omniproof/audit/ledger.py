"""The ledger: one row per printed cell, the record that everything downstream reads.

The row is a pydantic model, and its JSON Schema (`ledger.schema.json`) is kept in the repository,
so that a change of the interface is seen as one.
"""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterable
from enum import StrEnum
from pathlib import Path

from pydantic import BaseModel, ConfigDict

from omniproof.audit.evidence import Counterexample, Interval, Rival
from omniproof.transcription.model import Kind, Reading, Source, Uncheckable

RECORDS = ("rivals", "uncheckable", "argument", "against", "convention")
"""Fields of a row that have no column of their own."""
MOST_SHOWN = 2
"""Other edits that a remark shows: a reader compares no more."""


class Verdict(StrEnum):
    """What became of a printed cell; see `contracts` in the maintainers' part of the report."""

    VERIFIED = "verified"
    CONDITIONAL = "conditional"
    ERRATUM = "erratum"
    MISROUNDED = "misrounded"
    INCONSISTENT = "inconsistent"
    MODEL_GAP = "model-gap"
    EDITORIAL = "editorial"
    UNCHECKABLE = "uncheckable"
    UNDECIDED = "undecided"

    @property
    def is_fault(self) -> bool:
        """Whether a reader has to know of this row."""
        return self not in {Verdict.VERIFIED, Verdict.UNCHECKABLE, Verdict.UNDECIDED}


class Origin(StrEnum):
    """Who decided: a program, or a person who read the place."""

    COMPUTED = "computed"
    READ = "read"


class Consequence(StrEnum):
    """How far a fault reaches."""

    NONE = ""
    MOTION = "motion"
    NUMBER = "number"
    TEXT = "text"


class Repair(StrEnum):
    """How the printed form becomes true: by one edit, by two, or only by hand."""

    NONE = ""
    EXPLAINED = "explained"
    POSSIBLE = "possible"
    MANUAL = "manual"


class Row(BaseModel):
    """One printed cell with its verdict; the fields up to `note` are the columns of the CSV.

    The others are for programs: `rivals` of the correction, in the CSV a sentence of the note; of
    an `uncheckable` row the class, and the `argument` for what was reconstructed; the claims that
    an inconsistent row is `against`; the reading of its `convention` that a row was judged under.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    paper: str
    id: str
    where: str
    kind: Kind
    verdict: Verdict
    origin: Origin = Origin.COMPUTED
    source: Source = Source.CLEAR
    reading: Reading = Reading.PLAIN
    printed: str = ""
    derived: str = ""
    correction: str = ""
    repair: Repair = Repair.NONE
    assumption: str = ""
    witness: Counterexample | None = None
    interval: Interval | None = None
    follows: str = ""
    consequence: Consequence = Consequence.NONE
    engines: str = ""
    note: str = ""
    rivals: tuple[Rival, ...] = ()
    uncheckable: Uncheckable | None = None
    argument: str = ""
    against: tuple[str, ...] = ()
    convention: str = ""

    @property
    def remark(self) -> str:
        """The note, and which other edits are as small as the correction: a few, or how many."""
        others = [rival.correction for rival in self.rivals]
        shown = f"as small an edit: ${'$, or $'.join(others)}$."
        counted = f"{len(others)} other edits of the same size would make it true, too."
        said = (shown if len(others) <= MOST_SHOWN else counted) if others else ""
        return " ".join(filter(None, [self.note, said]))


COLUMNS = tuple(name for name in Row.model_fields if name not in RECORDS)


class Ledger(BaseModel):
    """All rows of one paper in order of place; `claims` counts printed things, not entries."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    paper: str
    claims: int
    rows: tuple[Row, ...]


def schema() -> str:
    """Return the JSON Schema of a ledger file, as it stands in the repository."""
    return json.dumps(Ledger.model_json_schema(), indent=2, sort_keys=True) + "\n"


def write_json(ledger: Ledger, path: Path) -> None:
    """Write one paper's ledger."""
    path.write_text(ledger.model_dump_json(indent=1) + "\n", encoding="utf-8")


def read_json(path: Path) -> Ledger:
    """Read one paper's ledger.

    Raises `pydantic.ValidationError` when the file is no ledger.
    """
    return Ledger.model_validate_json(path.read_bytes())


def read_ledgers(results: Path) -> tuple[Ledger, ...]:
    """Read every ledger of the folder of results, by name of paper."""
    return tuple(read_json(path) for path in sorted((results / "ledger").glob("*.json")))


def to_csv(ledgers: Iterable[Ledger]) -> str:
    """Lay the rows of all papers under one header, in order of place."""
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for ledger in ledgers:
        writer.writerows(map(cells, ledger.rows))
    return text.getvalue()


def cells(row: Row) -> dict[str, str]:
    """Write a row as plain text, column by column."""
    return {name: str(getattr(row, name) or "") for name in COLUMNS} | {"note": row.remark}


def write_csv(ledgers: Iterable[Ledger], path: Path) -> None:
    """Write `results/ledger.csv`."""
    path.write_text(to_csv(ledgers), encoding="utf-8")
