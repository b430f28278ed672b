"""How the audit fares with planted misprints, from `results/mutation.json`."""

from __future__ import annotations

import json
from pathlib import Path

from pydantic import BaseModel, ConfigDict

from omniproof.report.fragments.base import Fragment, results_folder, table


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
            f'<tr><th scope="row">{name}</th><td>{kind.mutants}</td><td>{kind.different}</td>'
            f"<td>{kind.flagged}</td><td>{kind.repaired}</td></tr>"
            for name, kind in self.kinds.items()
        )
        head = ("misprint", "planted", "differ", "flagged", "repaired")
        return Fragment(table(head, rows), "planted misprints")
