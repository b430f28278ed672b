"""The corpus as typed records: formulas of textbooks and papers with what mathematics says of them.

A record knows nothing of engines. `expected` and `condition` are checked by 60-digit arithmetic in
`test_truth.py`, which shares no code with the engines.
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import yaml
from pydantic import BaseModel, ConfigDict, Field, model_validator

FILE = Path(__file__).with_name("corpus.yaml")
Expected = Literal["proved", "refuted", "branch"]


class Record(BaseModel):
    """One formula, what is assumed, what is expected, and where it comes from."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str = Field(pattern="^[a-z0-9]+(-[a-z0-9]+)*$")
    latex: str
    expected: Expected
    source: str = Field(min_length=1)
    condition: str = ""
    where: tuple[str, ...] = ()
    positive: tuple[str, ...] = ()
    ranges: dict[str, tuple[str, str]] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _condition_of_a_branch(self) -> Record:
        if (self.expected == "branch") != bool(self.condition):
            raise ValueError(f"{self.id}: a branch has a condition, nothing else has one")
        return self


def load(path: Path = FILE) -> tuple[Record, ...]:
    """Read all records; ids are unique."""
    records = tuple(Record(**row) for row in yaml.safe_load(path.read_text(encoding="utf-8")))
    if len({record.id for record in records}) != len(records):
        raise ValueError("an id occurs twice")
    return records
