"""What code says of a paper's symbols, so that the paper file need not: one place for each fact.

A fact that stood in both places could be stated in two ways, and a slip of ours there would become
an erratum of theirs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module

from omniproof.transcription.faults import Fault, nearest
from omniproof.transcription.messages import label
from omniproof.transcription.model import Role
from omniproof.transcription.paperfile import Document, Path_, Tree

FACTS = ("role", "positive", "range", "of")
"""Keys of a symbol that say what it is, and not how it is printed."""


@dataclass(frozen=True)
class Known:
    """What code knows of the symbols of a paper, by name.

    `roles`: of every symbol; `of`: names of the variables that a quantity is a function of.
    """

    paper: str
    roles: Mapping[str, Role]
    of: Mapping[str, tuple[str, ...]]

    @property
    def file(self) -> str:
        """Where it says so."""
        return f"papers/{self.paper.replace('-', '_')}/symbols.py"

    def completed(self, document: Document) -> tuple[Tree, list[Fault]]:
        """Return the values of a paper file with what code says, and the faults of its symbols."""
        values = document.values
        listed = values.get("symbols") if isinstance(values, dict) else None
        if not isinstance(values, dict) or not isinstance(listed, list):
            return values, []
        latex = {
            str(entry.get("name")): entry.get("latex", "")
            for entry in listed
            if isinstance(entry, dict)
        }
        symbols = [self._completed(entry, latex) for entry in listed]
        return {**values, "symbols": symbols}, list(self._faults(document, listed))

    def _completed(self, entry: Tree, latex: Mapping[str, Tree]) -> Tree:
        if not isinstance(entry, dict) or not isinstance(name := entry.get("name"), str):
            return entry
        own = {key: value for key, value in entry.items() if key not in FACTS}
        if name in self.roles:
            own["role"] = self.roles[name].value
            own["of"] = [latex[each] for each in self.of.get(name, ()) if each in latex]
        return own

    def _faults(self, document: Document, listed: list[Tree]) -> Iterator[Fault]:
        """Find what is stated twice, and the symbols that only one of both places has."""

        def fault(path: Path_, message: str, cure: str) -> Fault:
            where = label(path, document.values)
            return Fault(document.name, *document.place(path), where, message, cure)

        entries = {i: entry for i, entry in enumerate(listed) if isinstance(entry, dict)}
        names = {i: str(entry["name"]) for i, entry in entries.items() if "name" in entry}
        missing = self.roles.keys() - set(names.values())
        for i, entry in entries.items():
            for key in filter(entry.__contains__, FACTS):
                message = f"expected `{key}` in {self.file} only, found it here as well"
                yield fault(("symbols", i, key), message, "leave it out: code says it")
        unknown = {i: name for i, name in names.items() if name not in self.roles}
        for i, name in unknown.items():
            message = f"expected a symbol that {self.file} has, found `{name}`"
            cure = nearest(name, missing, "add it there, or remove it here")
            yield fault(("symbols", i, "name"), message, cure)
        # A quantity that has no symbol is told where derivations are matched with claims.
        variables = [name for name in missing if self.roles[name] is not Role.QUANTITY]
        for name in variables if not unknown else ():
            message = f"expected an entry for the symbol `{name}` of {self.file}, found none"
            yield fault(("symbols",), message, "add how the paper prints it, or remove it there")


def known_by_code(key: str) -> Known | None:
    """Return what the derivations of a paper of ours know; None where it has none."""
    try:
        module = import_module(f"omniproof.papers.{key.replace('-', '_')}.derivations")
    except ModuleNotFoundError as error:
        if error.name and error.name.startswith("omniproof.papers."):
            return None
        raise
    known: Known | None = module.REGISTRY.known
    return known
