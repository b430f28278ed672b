"""Slips of ours in a paper file: each attribute of each symbol, dropped, added, changed, misspelt.

An alteration is made in the values of the file as it was read, so that a thousand of them cost no
reading; what is told of them still has the places of the file.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from omniproof.audit import agreement, run
from omniproof.audit.context import Context
from omniproof.audit.known_symbols import known_symbols
from omniproof.transcription import checking, loader
from omniproof.transcription.conventions import Names
from omniproof.transcription.loader import FILE
from omniproof.transcription.model import Notation
from omniproof.transcription.paperfile import Document, load_document
from omniproof.transcription.reader import read_with
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Node

Read = Callable[[str, Notation, Names], Node]
ROLES = ("variable", "quantity", "undefined")


@dataclass(frozen=True)
class Alteration:
    """One slip: `entry` is a path in the file, `value` what stands there (None: nothing)."""

    paper: str
    attribute: str
    how: str
    path: tuple[str | int, ...]
    value: Any = None
    new_key: str = ""

    def __str__(self) -> str:
        """Name it as a test does."""
        return "-".join(map(str, (self.paper, *self.path, self.how)))

    def made_in(self, document: Document) -> Document:
        """Return the document with this slip."""
        values: Any = copy.deepcopy(document.values)
        *way, key = self.path
        entry = values
        for step in way:
            entry = entry[step]
        if self.new_key:
            entry[self.new_key] = entry.pop(key)
        elif self.value is None:
            del entry[key]
        else:
            entry[key] = self.value
        return replace(document, values=values)


def symbol_alterations(folder: Path) -> Iterator[Alteration]:
    """All slips in the symbols of a paper file: how it writes them, and what code says already."""
    values: Any = load_document(folder / FILE).values
    symbols = values["symbols"]
    for i, symbol in enumerate(symbols):
        others = [other["latex"] for other in symbols if other is not symbol]
        for how, key, value in (*_slips(symbol, others), *_stated_again(others)):
            yield Alteration(folder.name, key, how, ("symbols", i, key), value)
        for key in symbol:
            how, new = "key misspelt", f"{key}s"
            yield Alteration(folder.name, key, how, ("symbols", i, key), new_key=new)


def _slips(symbol: Mapping[str, Any], others: list[str]) -> Iterator[tuple[str, str, Any]]:
    name, latex = symbol["name"], symbol["latex"]
    for key in symbol:
        yield "dropped", key, None
    yield "misspelt", "name", f"{name}x"
    yield "misspelt", "name", f"{name[:-1]}_one" if name.endswith("1") else f"{name}_{name}"
    yield "changed", "name", "phi" if name != "phi" else "psi"
    yield "misspelt", "latex", f"{latex[:-1]}l" if latex.endswith("1") else f"{latex}'"
    yield "changed", "latex", others[0]


def _stated_again(others: list[str]) -> Iterator[tuple[str, str, Any]]:
    for role in ROLES:
        yield "stated twice", "role", role
    for positive in ("true", "false"):
        yield "stated twice", "positive", positive
    yield "stated twice", "range", r"(0, 30^\circ)"
    yield "stated twice", "of", [others[0]]


@contextmanager
def in_place_of(folder: Path) -> Iterator[Callable[[Alteration], None]]:
    """Give a function that puts an altered paper in place of the paper.

    What no alteration changes is done once: derivations, and formulas with the same symbols.
    """
    document, derived = load_document(folder / FILE), dict[Any, Any]()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(checking, "read_with", _read_once())
        patch.setattr(run, "Context", partial(Context, derived=derived))
        known = known_symbols(run.prepare(folder))
        patch.setattr(agreement, "known_symbols", lambda context: known)
        yield lambda slip: patch.setattr(loader, "load_document", lambda _: slip.made_in(document))


def _read_once() -> Read:
    """Read each formula once, and remember also why it cannot be read."""
    found: dict[tuple[str, str, Names], Node | LatexError] = {}

    def read(text: str, notation: Notation, names: Names) -> Node:
        key = (text, repr(notation), names)
        if key not in found:
            try:
                found[key] = read_with(text, notation, names)
            except LatexError as error:
                found[key] = error
        node = found[key]
        if isinstance(node, LatexError):
            raise node
        return node

    return read
