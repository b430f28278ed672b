"""The checks on a paper file that need no derivation.

Shape first (the data model), then meaning: what has the right shape is checked further even where
other entries are broken, so that one run shows everything there is to mend.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from omniproof.transcription.conventions import Names
from omniproof.transcription.faults import BadInput, Fault, nearest, shorten
from omniproof.transcription.functions import SHORTENED
from omniproof.transcription.ids import base, whole
from omniproof.transcription.messages import label, model_fault
from omniproof.transcription.model import Claim, Notation, Paper, Reading, Role, Symbol, Table
from omniproof.transcription.paperfile import Document, Path_, Tree
from omniproof.transcription.reader import read_with
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tablefile import Cell, load_table, unit_faults
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Comparison, Logic, Node, Tuple, names, walk

LISTS = frozenset({"latex", "agrees_with", "at", "assumes"})
"""Keys of a claim whose single value may be written without a list."""
MOST_FAULTS = 200
"""So many faults of shape are put into words; more are one fault, many times."""

Entry = TypeVar("Entry", bound=BaseModel)


@dataclass(frozen=True)
class Position:
    """Where a claim stands in the folder; line and column from 1."""

    file: str
    line: int
    column: int

    def fault(self, path: str, message: str, cure: str = "") -> Fault:
        """Return a fault of what stands here."""
        return Fault(self.file, self.line, self.column, path, message, cure)


@dataclass
class Check:
    """One pass over a folder; every step adds to what is known and to the faults."""

    folder: Path
    document: Document
    values: Tree
    paper: Paper | None = None
    faults: list[Fault] = field(default_factory=list)
    notation: Notation = field(default_factory=Notation)
    symbols: dict[str, Symbol] = field(default_factory=dict)
    claims: dict[int, Claim] = field(default_factory=dict)
    cells: dict[str, tuple[Cell, ...]] = field(default_factory=dict)
    positions: dict[str, Position] = field(default_factory=dict)
    declared_at: dict[tuple[str, str], Position] = field(default_factory=dict)
    sources: dict[str, str] = field(default_factory=dict)
    trees: dict[str, Node] = field(default_factory=dict)
    points: dict[str, tuple[Node, ...]] = field(default_factory=dict)
    assumptions: dict[str, tuple[Node, ...]] = field(default_factory=dict)
    ranges: dict[str, tuple[Node, ...]] = field(default_factory=dict)

    def run(self) -> None:
        """Check everything, in the order in which one thing needs another."""
        symbols, tables = self.shape()
        self.check_notation()
        self.check_symbols(symbols)
        self.check_tables(tables)
        self.check_ids()
        self.check_decoding()
        self.read_all()
        self.check_pointers()

    def fault(self, path: Path_, message: str, cure: str = "") -> None:
        """Note a fault at a path of the paper file."""
        place = self.document.place(path)
        where = label(path, self.values)
        self.faults.append(Fault(self.document.name, *place, where, message, cure))

    def shape(self) -> tuple[dict[int, Symbol], dict[int, Table]]:
        """Validate everything; keep what fits, by its place in its list."""
        bad: set[Path_] = set()
        try:
            self.paper = Paper.model_validate(self.values)
        except ValidationError as error:
            errors = error.errors(include_url=False)
            self.faults += [model_fault(dict(item), self.document) for item in errors[:MOST_FAULTS]]
            bad = {tuple(item["loc"][:2]) for item in errors}
        self.claims = self.entries("claims", Claim, bad)
        if isinstance(self.values, dict) and not any(path[0] == "notation" for path in bad if path):
            self.notation = Notation.model_validate(self.values.get("notation", {}))
        return self.entries("symbols", Symbol, bad), self.entries("tables", Table, bad)

    def entries(self, key: str, kind: type[Entry], bad: set[Path_]) -> dict[int, Entry]:
        """The entries of a list that have the right shape."""
        if self.paper is not None:
            return dict(enumerate(getattr(self.paper, key)))
        listed = self.values.get(key, []) if isinstance(self.values, dict) else []
        if not isinstance(listed, list):
            return {}
        # One bad entry must not hide the faults of all others.
        good = ((i, value) for i, value in enumerate(listed) if (key, i) not in bad)
        return {i: kind.model_validate(value) for i, value in good}

    def sound_part(self) -> Paper | None:
        """Return the paper without the entries that have faults; None where it has no key."""
        key = self.values.get("key") if isinstance(self.values, dict) else None
        if any(fault.path == "key" for fault in self.faults) or not isinstance(key, str):
            return None
        symbols, claims = tuple(self.symbols.values()), tuple(self.claims.values())
        # Without validation: what is left of the faults is known by now.
        return Paper.model_construct(
            key=key, notation=self.notation, symbols=symbols, claims=claims
        )

    def broken(self) -> frozenset[str]:
        """Names of the entries that have faults: nothing more can be said of them."""
        symbols = {symbol.name for symbol in self.symbols.values()}
        sound = {*self.positions, *self.cells, *symbols}
        return frozenset(self.printed("claims", "symbols", "tables") - sound)

    def check_notation(self) -> None:
        """Shorthands are one letter for a function that is read."""
        for short, function in self.notation.functions.items():
            path = ("notation", "functions", short)
            if function not in SHORTENED:
                known = ", ".join(sorted(SHORTENED))
                message = f"expected one of {known}, found `{function[:20]}`"
                self.fault(path, message, nearest(function, SHORTENED))
            if len(short) != 1 or not short.isalpha():
                self.fault(path, f"expected one letter for a function, found `{short[:20]}`")

    def check_symbols(self, symbols: Mapping[int, Symbol]) -> None:
        """Each symbol is one readable symbol, declared once, with a name of its own."""
        by_name: dict[str, int] = {}
        for i, symbol in symbols.items():
            try:
                name = symbol_name(symbol.latex)
            except LatexError as error:
                self.fault(("symbols", i, "latex"), error.picture, error.cure)
                continue
            line = self.document.place(("symbols", by_name.get(symbol.name, i)))[0]
            if name in self.symbols:
                message = f"expected each symbol once, found `{name}` again"
                self.fault(("symbols", i, "latex"), message, "fonts do not tell symbols apart")
            elif symbol.name in by_name:
                message = f"expected each name once, found `{symbol.name}` again"
                self.fault(("symbols", i, "name"), message, f"the first one is on line {line}")
            # The first of two entries counts, so that formulas can be read and their faults told.
            self.symbols.setdefault(name, symbol)
            by_name.setdefault(symbol.name, i)
            for key in Symbol.model_fields:
                place = Position(self.document.name, *self.document.place(("symbols", i, key)))
                self.declared_at.setdefault((symbol.name, key), place)
            if symbol.range:
                self.read_range(i, name, symbol.range)
        variables = [s.latex for s in self.symbols.values() if s.role is not Role.QUANTITY]
        for i, symbol in symbols.items():
            self.check_arguments(i, symbol, variables)
        self.check_spelling(by_name)

    def check_spelling(self, by_name: Mapping[str, int]) -> None:
        r"""No symbol has the name that another one is printed by: two that were swapped."""
        for printed, symbol in self.symbols.items():
            spelled = "_".join(re.findall("[A-Za-z0-9]+", printed))
            if spelled != symbol.name and spelled in by_name:
                line = self.document.place(("symbols", by_name[spelled]))[0]
                message = f"expected `{spelled}`, as `{printed}` is printed, found `{symbol.name}`"
                path: Path_ = ("symbols", by_name[symbol.name], "name")
                self.fault(path, message, f"line {line} has that name")

    def check_arguments(self, i: int, symbol: Symbol, variables: Sequence[str]) -> None:
        """What a quantity is a function of are declared variables."""
        for k, latex in enumerate(symbol.of):
            if latex not in variables:
                message = f"expected a variable among the symbols, found `{latex}`"
                self.fault(("symbols", i, "of", k), message, nearest(latex, variables))

    def check_tables(self, tables: Mapping[int, Table]) -> None:
        """Read the tables, each with its units."""
        for i, table in tables.items():
            try:
                cells = load_table(self.folder, table)
            except BadInput as bad:
                self.faults.extend(bad.faults)
                continue
            self.cells[table.id] = cells
            for column, message, cure in unit_faults(table, cells):
                self.fault(("tables", i, "units", column), message, cure)

    def check_ids(self) -> None:
        """Every id once, cells of tables included."""
        for table in self.cells.values():
            for cell in table:
                self.positions[cell.claim.id] = Position(cell.file, cell.line, cell.column)
        for i, claim in self.claims.items():
            path: Path_ = ("claims", i, "id")
            if claim.id in self.positions:
                first = self.positions[claim.id]
                message = f"expected each id once, found `{claim.id}` again"
                self.fault(path, message, f"the first one is at {first.file}:{first.line}")
                continue
            place = self.document.place(path)
            self.positions[claim.id] = Position(self.document.name, *place)

    def broken_symbols(self) -> frozenset[str]:
        """Names of symbols whose entry has another fault: their use is none."""
        listed = self.values.get("symbols", []) if isinstance(self.values, dict) else []
        spelled = [entry.get("latex") for entry in listed if isinstance(entry, dict)]
        found = set()
        for latex in spelled:
            with suppress(LatexError):
                found.add(symbol_name(latex if isinstance(latex, str) else ""))
        return frozenset(found - set(self.symbols))

    def read_all(self) -> None:
        """Read all LaTeX: one fault for what cannot be read, one for each unknown symbol."""
        broken, sound = self.broken_symbols(), known_names(self.symbols)
        known = Names(broken | sound.declared, broken | sound.quantities, sound.functions)
        for i, claim in self.claims.items():
            source = " ".join(claim.latex)
            if source:
                tree = self.read(("claims", i, "latex"), source, claim.latex, known)
                if tree is not None:
                    self.trees[claim.id] = tree
                    self.sources[claim.id] = source
            at = claim.asserts.at if claim.asserts else ()
            path: Path_ = ("claims", i, "asserts", "at")
            points = [self.read((*path, k), text, (text,), known) for k, text in enumerate(at)]
            if at:
                self.points[claim.id] = tuple(point for point in points if point is not None)

            self.read_assumptions(i, claim, known)
            self.read_about(i, claim)

    def check_decoding(self) -> None:
        """Where a table decodes the source, what is decoded names its piece of the source."""
        for i, claim in self.claims.items():
            decoded = claim.reading is Reading.GLYPHS and (claim.latex or claim.quote)
            if self.notation.glyphs and decoded and not claim.glyphs:
                message = "expected `glyphs`, the piece of the source that is decoded"
                self.fault(("claims", i, "reading"), message, "copy it from the line of the claim")

    def read_assumptions(self, i: int, claim: Claim, known: Names) -> None:
        """Read what a claim states of its symbols: inequalities."""
        found = []
        for k, text in enumerate(claim.assumes):
            path: Path_ = ("claims", i, "assumes", k)
            node = self.read(path, text, (text,), known)
            if node is not None and not _is_inequality(node):
                message = f"expected an inequality, found {shorten(text)}"
                self.fault(path, message, r"write `0 < \theta < 90^\circ`, or `a \neq b`")
            elif node is not None:
                found.append(node)
        if claim.assumes:
            self.assumptions[claim.id] = tuple(found)

    def read_about(self, i: int, claim: Claim) -> None:
        """What a reference is about is one symbol."""
        try:
            symbol_name(claim.about or "L")
        except LatexError as error:
            self.latex_fault(("claims", i, "about"), error, (claim.about or "",))

    def read_range(self, i: int, name: str, text: str) -> None:
        """Read the range of a symbol: two numbers."""
        try:
            node = read_with(text, self.notation, Names())
        except LatexError as error:
            self.latex_fault(("symbols", i, "range"), error, (text,))
            return
        if isinstance(node, Tuple) and len(node.items) == 2 and not names(node):
            self.ranges[name] = node.items
        else:
            message = f"expected an open interval, found {shorten(text)}"
            self.fault(("symbols", i, "range"), message, r"write its ends: `(0, 90^\circ)`")

    def read(
        self, path: Path_, source: str, fragments: tuple[str, ...], known: Names
    ) -> Node | None:
        """Read one formula, or note why not."""
        try:
            tree = read_with(source, self.notation, known)
        except LatexError as error:
            self.latex_fault(path, error, fragments)
            return None
        for unknown in unknown_symbols(tree, source, known.declared):
            self.latex_fault(path, unknown, fragments)
        return tree

    def latex_fault(self, path: Path_, error: LatexError, fragments: tuple[str, ...]) -> None:
        """Note a fault of a formula, on the line of its fragment."""
        start = 0
        for k, fragment in enumerate(fragments):
            if start <= error.span[0] < start + len(fragment) + 1 and len(fragments) > 1:
                path = (*path, k)
            start += len(fragment) + 1
        cure = error.cure or "write LaTeX as the paper prints it, in symbols that are declared"
        self.fault(path, error.picture, cure)

    def printed(self, *keys: str) -> set[str]:
        """Names of all entries of these lists in the file, those with faults included."""
        lists = [self.values.get(key) for key in keys] if isinstance(self.values, dict) else []
        entries = [entry for listed in lists if isinstance(listed, list) for entry in listed]
        found = (e.get("id", e.get("name", "")) for e in entries if isinstance(e, dict))
        return {name for name in found if isinstance(name, str)}

    def check_pointers(self) -> None:
        """What a claim points to is a claim, or a place that has claims."""
        ids = set(self.positions) | self.printed("claims")
        wholes = {whole(claim) for claim in ids}
        for i, claim in self.claims.items():
            for k, other in enumerate(claim.agrees_with):
                path: Path_ = ("claims", i, "agrees_with", k)
                if other == claim.id:
                    self.fault(path, "expected another claim, found the claim itself")
                elif other not in ids and base(other) not in ids:
                    message = f"expected the id of a claim, found `{other}`"
                    self.fault(path, message, nearest(other, ids))
            target = claim.target
            if target and target not in ids | wholes and base(target) not in ids:
                message = f"expected an equation, figure or section with claims, found `{target}`"
                self.fault(("claims", i, "target"), message, nearest(target, ids | wholes))


def known_names(symbols: Mapping[str, Symbol]) -> Names:
    """Sort symbols, by canonical name, into those that may take arguments and those that do."""
    quantities = {name for name, symbol in symbols.items() if symbol.role is Role.QUANTITY}
    functions = {name for name, symbol in symbols.items() if symbol.of}
    return Names(frozenset(symbols), frozenset(quantities), frozenset(functions))


def unknown_symbols(tree: Node, source: str, declared: frozenset[str]) -> Iterator[LatexError]:
    """Symbols that nobody declared; the determinant of a declared matrix needs no entry."""
    unknown = {n for n in names(tree) if n not in declared}
    unknown = {n for n in unknown if n.removeprefix("\\det ") not in declared}
    for node in walk(tree):
        name = getattr(node, "name", None)
        if name in unknown:
            unknown.discard(name)
            cure = nearest(name, declared, "declare it under `symbols`")
            yield LatexError(f"unknown symbol `{name}`", source, node.span, cure)


def _is_inequality(node: Node) -> bool:
    """Whether a statement is an inequality, or several that hold together."""
    if isinstance(node, Logic):
        return node.operator == "and" and all(_is_inequality(part) for part in node.operands)
    return isinstance(node, Comparison)


def one_is_enough(values: Tree) -> Tree:
    """Let one fragment, id or point of a claim stand for a list of one."""
    claims = values.get("claims") if isinstance(values, dict) else None
    if not isinstance(values, dict) or not isinstance(claims, list):
        return values
    return {**values, "claims": [_with_lists(claim) for claim in claims]}


def _with_lists(entry: Tree) -> Tree:
    if not isinstance(entry, dict):
        return entry
    return {
        key: [value] if key in LISTS and isinstance(value, str) else _with_lists(value)
        for key, value in entry.items()
    }
