"""Loads the folder of one paper, or reports everything that is wrong with it."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias

from omniproof.transcription.checking import Check, Position, one_is_enough
from omniproof.transcription.faults import BadInput, Fault
from omniproof.transcription.files import display_name, refuse_no_folder
from omniproof.transcription.known import Known, known_by_code
from omniproof.transcription.model import KEY, Claim, Paper, Symbol
from omniproof.transcription.paperfile import Document, Tree, load_document
from omniproof.transcription.tablefile import Cell
from omniproof.transcription.tree import Node

__all__ = ["FILE", "LoadedPaper", "Position", "load_paper", "load_sound_part"]

FILE = "paper.yaml"
Knowing: TypeAlias = Callable[[str], Known | None]
"""What code says of the symbols of a paper with this key, if there is any."""


@dataclass(frozen=True)
class LoadedPaper:
    """A paper that can be audited.

    `claims` are the paper's claims and the cells of its tables, in order of place; `sources` is
    their LaTeX, fragments joined by a blank, and `trees` what was read from it, both by claim id;
    `points` are the trees of `asserts.at`. `symbols` are keyed by canonical name. `broken` are the
    names of entries that were left out for their faults. `assumptions` are the trees of `assumes`
    by claim id, `ranges` the two ends of the range of a symbol by canonical name. `declared_at`
    says where a key of a symbol stands, by the symbol's name and the key.
    """

    paper: Paper
    folder: Path
    claims: tuple[Claim, ...]
    positions: Mapping[str, Position]
    sources: Mapping[str, str]
    trees: Mapping[str, Node]
    points: Mapping[str, tuple[Node, ...]]
    symbols: Mapping[str, Symbol]
    broken: frozenset[str] = frozenset()
    assumptions: Mapping[str, tuple[Node, ...]] = field(default_factory=dict)
    ranges: Mapping[str, tuple[Node, ...]] = field(default_factory=dict)
    declared_at: Mapping[tuple[str, str], Position] = field(default_factory=dict)

    def formulas(self, claim: str) -> tuple[Node, ...]:
        """Return all that a claim prints: its formula, its points, what it assumes."""
        whole = (self.trees[claim],) if claim in self.trees else ()
        return (*whole, *self.points.get(claim, ()), *self.assumptions.get(claim, ()))

    @property
    def start(self) -> Position:
        """Where the paper file starts: the place of what has none of its own."""
        return Position(display_name(self.folder / FILE), 1, 1)

    def fault(self, claim: str, message: str, cure: str = "", key: str = "") -> Fault:
        """Return a fault of a claim, or of one of its keys."""
        path = f"claims[{claim}].{key}" if key else f"claims[{claim}]"
        return self.positions[claim].fault(path, message, cure)

    def symbol_fault(self, name: str, key: str, message: str, cure: str = "") -> Fault:
        """Return a fault of a key of a symbol, which is called by its name."""
        return self.declared_at[name, key].fault(f"symbols[{name}].{key}", message, cure)


def load_paper(folder: Path, known: Knowing = known_by_code) -> LoadedPaper:
    """Load `paper.yaml` and its tables; `known` gives what code says of the symbols, by key.

    Raises `BadInput` with all faults of the folder.
    """
    loaded, faults = load_sound_part(folder, known)
    if faults:
        raise BadInput(faults)
    return loaded


def load_sound_part(
    folder: Path, known: Knowing = known_by_code
) -> tuple[LoadedPaper, tuple[Fault, ...]]:
    """Load what is right in a folder, with the faults of the rest, so that more can be checked.

    Raises `BadInput` where nothing can be told of any entry: a file that cannot be read, no key.
    """
    refuse_no_folder(folder)
    document = load_document(folder / FILE)
    values, faults = _completed(document, known)
    check = Check(folder, document, one_is_enough(values), faults=faults)
    check.run()
    paper = check.paper or check.sound_part()
    if paper is None:
        raise BadInput(check.faults)
    loaded = LoadedPaper(
        paper,
        folder,
        _merged(paper.claims, check.cells),
        check.positions,
        check.sources,
        check.trees,
        check.points,
        check.symbols,
        check.broken(),
        check.assumptions,
        check.ranges,
        check.declared_at,
    )
    return loaded, tuple(check.faults)


def _completed(document: Document, known: Knowing) -> tuple[Tree, list[Fault]]:
    """Add what code says of the symbols; a key that is none is told later."""
    key = document.values.get("key") if isinstance(document.values, dict) else None
    found = known(key) if isinstance(key, str) and re.fullmatch(KEY, key) else None
    return found.completed(document) if found else (document.values, [])


def _merged(claims: tuple[Claim, ...], cells: Mapping[str, tuple[Cell, ...]]) -> tuple[Claim, ...]:
    """Put the cells of tables before the first claim that stands further down in the paper."""
    merged = list(claims)
    for table in cells.values():
        last = table[-1].claim.line
        place = next((i for i, claim in enumerate(merged) if claim.line > last), len(merged))
        merged[place:place] = [cell.claim for cell in table]
    return tuple(merged)
