"""Loads the folder of one paper, or reports everything that is wrong with it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from omniproof.transcription.checking import Check, Position, one_is_enough
from omniproof.transcription.faults import BadInput
from omniproof.transcription.model import Claim, Paper, Symbol
from omniproof.transcription.paperfile import load_document
from omniproof.transcription.tablefile import Cell
from omniproof.transcription.tree import Node

__all__ = ["FILE", "LoadedPaper", "Position", "load_paper"]

FILE = "paper.yaml"


@dataclass(frozen=True)
class LoadedPaper:
    """A paper that can be audited.

    `claims` are the paper's claims and the cells of its tables, in order of place; `sources` is
    their LaTeX, fragments joined by a blank, and `trees` what was read from it, both by claim id;
    `points` are the trees of `asserts.at`. `symbols` are keyed by canonical name.
    """

    paper: Paper
    folder: Path
    claims: tuple[Claim, ...]
    positions: Mapping[str, Position]
    sources: Mapping[str, str]
    trees: Mapping[str, Node]
    points: Mapping[str, tuple[Node, ...]]
    symbols: Mapping[str, Symbol]


def load_paper(folder: Path) -> LoadedPaper:
    """Load `paper.yaml` and its tables.

    Raises `BadInput` with all faults of the folder.
    """
    document = load_document(folder / FILE)
    check = Check(folder, document, one_is_enough(document.values))
    check.run()
    if check.faults or check.paper is None:
        raise BadInput(check.faults)
    return LoadedPaper(
        check.paper,
        folder,
        _merged(check.paper.claims, check.cells),
        check.positions,
        check.sources,
        check.trees,
        check.points,
        check.symbols,
    )


def _merged(claims: tuple[Claim, ...], cells: Mapping[str, tuple[Cell, ...]]) -> tuple[Claim, ...]:
    """Put the cells of tables before the first claim that stands further down in the paper."""
    merged = list(claims)
    for table in cells.values():
        last = table[-1].claim.line
        place = next((i for i, claim in enumerate(merged) if claim.line > last), len(merged))
        merged[place:place] = [cell.claim for cell in table]
    return tuple(merged)
