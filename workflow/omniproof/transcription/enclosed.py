# ruff: noqa: D403 - the docstring of a rule is the rule
r"""What stands between a sign and its partner: brackets, bars, sets, matrices, cases.

A plain bar opens where a factor may stand and closes where an operator may; `\left|` and `\right|`
say it themselves. Brackets seal: no bar outside ends inside.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from dataclasses import replace

from omniproof.transcription.symbols import SymbolReader
from omniproof.transcription.tokens import Cure
from omniproof.transcription.tree import (
    STATEMENTS,
    Absolute,
    Branch,
    Cases,
    Inner,
    MatrixLiteral,
    Node,
    Norm,
    SetBuilder,
    Tuple,
)


class EnclosedReader(SymbolReader, ABC):
    """Reads enclosed parts; the rules for what is inside come from the readers above."""

    def __init__(self, source: str, declared: Collection[str] | None) -> None:
        super().__init__(source, declared)
        self.bars: list[str] = []  # what would close the bars that are open here
        self.brackets: dict[int, tuple[Node, int]] = {}  # read once, even where read ahead

    @abstractmethod
    def entry(self) -> Node:
        """Read a value: a sum that is no statement."""

    @abstractmethod
    def statement(self) -> Node:
        """Read a statement, or an expression where nothing is stated."""

    @abstractmethod
    def items(self) -> tuple[Node, ...]:
        """Read statements or expressions, separated by commas."""

    def value(self, node: Node, start: int) -> Node:
        """Refuse a statement where a value is needed."""
        if isinstance(node, STATEMENTS):
            cure = Cure("state it in a claim of its own", "state it alone")
            self.refuse("expected a value, found a statement", start, cure)
        return node

    def bracket(self, start: int) -> Node:
        """bracket = "(" items ")" | "[" items "]"; one item is grouped, several are a vector."""
        opened = self.place
        if opened not in self.brackets:
            items = self.enclosed_items()
            span = self.since(start)
            node = replace(items[0], span=span) if len(items) == 1 else Tuple(items, span=span)
            self.brackets[opened] = node, self.place
        node, self.place = self.brackets[opened]
        return node

    def enclosed_items(self) -> tuple[Node, ...]:
        """Read the items in a bracket; bars outside do not end inside."""
        with self.sealed(), self.enclosed():
            return self.items()

    @contextmanager
    def sealed(self) -> Iterator[None]:
        """Read an inner part in which the bars outside do not end."""
        bars, self.bars = self.bars, []
        yield
        self.bars = bars

    def group(self, start: int) -> Node:
        """group = "{" statement "}"."""
        with self.sealed(), self.enclosed():
            node = self.statement()
        return replace(node, span=self.since(start))

    def braces(self, start: int) -> Node:
        r"""braces = "\{" items ["\mid" items] "\}"."""
        conditions: tuple[Node, ...] = ()
        with self.sealed(), self.enclosed():
            items = self.items()
            if self.consume("\\mid"):
                conditions = self.items()
        if conditions and len(items) == 1:
            return SetBuilder(items[0], conditions, span=self.since(start))
        if conditions:
            self.refuse("expected one element before `\\mid`", start, "put it into brackets")
        if len(items) == 1:
            return replace(items[0], span=self.since(start))
        return Tuple(items, "set", span=self.since(start))

    def between_bars(self, start: int) -> Node:
        r"""bars = "|" entry "|" | "\|" entry "\|"; plain bars end at the first that may."""
        opened = self.take()
        with self.sealed():
            self.bars = [] if opened.kind == "open" else [opened.text]
            inner = self.entry()
            if opened.kind == "open" and self.peek().kind != "close":
                self.expected(f"`\\right{opened.text}`", "balance the bars")
            self.close(opened, opened.text)
        kind = Absolute if opened.text == "|" else Norm
        return kind(inner, span=self.since(start))

    def inner(self, start: int) -> Node:
        r"""inner = "\langle" sum "," sum "\rangle"."""
        items = self.enclosed_items()
        if len(items) != 2:
            self.refuse(
                "expected two vectors in an inner product", start, "write `\\langle a, b \\rangle`"
            )
        return Inner(*items, span=self.since(start))

    def matrix(self) -> Node:
        r"""matrix = "\begin" "{" name "}" row {"\\" row} "\end" "{" name "}"."""
        opened = self.take()
        rows = [self.row()]
        while self.consume_kind("row") and self.peek().kind != "end":
            start = self.start
            rows.append(self.row())
            if len(rows[-1]) != len(rows[0]):
                self.refuse(
                    f"expected {len(rows[0])} entries in row {len(rows)}, found {len(rows[-1])}",
                    start, "give every row the same number of entries",
                )  # fmt: skip
        self.end_environment(opened.text)
        return MatrixLiteral(tuple(rows), span=self.since(opened.span[0]))

    def row(self) -> tuple[Node, ...]:
        """row = entry {"&" entry}."""
        with self.sealed():
            cells = [self.entry()]
            while self.consume("&"):
                cells.append(self.entry())
        return tuple(cells)

    def end_environment(self, name: str) -> None:
        r"""Step over `\end{name}`."""
        if self.peek().kind != "end" or self.peek().text != name:
            self.expected(f"`\\end{{{name}}}`")
        self.place += 1

    def cases(self) -> Node:
        r"""cases = "\begin{cases}" branch {"\\" branch} "\end{cases}"."""
        opened = self.take()
        branches = [self.branch()]
        while self.consume_kind("row") and self.peek().kind != "end":
            branches.append(self.branch())
        self.end_environment("cases")
        return Cases(tuple(branches), span=self.since(opened.span[0]))

    def branch(self) -> Branch:
        r"""branch = sum ("&" | "\\" | ",") statement."""
        start = self.start
        value = self.entry()
        if not (self.consume("&", ",") or self.consume_kind("row")):
            self.expected("a condition", "write `value & condition`")
        return Branch(value, self.statement(), span=self.since(start))

    def consume_kind(self, kind: str) -> bool:
        """Step over the next token if it is of this kind."""
        found = self.peek().kind == kind
        self.place += found
        return found
