"""How the audit fares with planted misprints, from `results/mutation.json`."""

from __future__ import annotations

import json
from pathlib import Path

from pydantic import BaseModel, ConfigDict

from omniproof.report.fragments.base import Fragment, results_folder, table

COLUMNS = {
    "planted": "mutants",
    "differ": "different",
    "flagged": "flagged",
    "repaired": "repaired",
}
"""Heads of the table, with the figures that they stand for."""


class ByKind(BaseModel):
    """Figures for one kind of misprint."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    mutants: int
    different: int
    flagged: int
    repaired: int


class Mutation(BaseModel):
    """The figures of the mutation study; each is a number for running text."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    population: int
    mutants: int
    refused: int
    different: int
    flagged: int
    repaired: int
    equivalent: int
    proved_equivalent: int
    not_evaluated: int
    kinds: dict[str, ByKind]

    @classmethod
    def open(cls, results: Path | None = None) -> Mutation:
        """Read the study in the folder of results (found from the working folder)."""
        folder = results or results_folder()
        return cls.model_validate(json.loads((folder / "mutation.json").read_bytes()))

    def by_kind(self) -> Fragment:
        """Show how many misprints of each kind were planted, flagged and repaired."""
        rows = (
            f'<tr><th scope="row">{name}</th>'
            + "".join(f'<td class="number">{getattr(kind, word)}</td>' for word in COLUMNS.values())
            + "</tr>"
            for name, kind in self.kinds.items()
        )
        return Fragment(table(["misprint", *COLUMNS], rows, "counted"), "planted misprints")
