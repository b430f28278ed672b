"""Formulas as code: what NumPy and SymPy have in common, and what each has to say for itself.

The code follows the printed tree, so that a reader finds the formula again. Products of arrays need
to be told from products of numbers, so every piece of code knows its rank: what is printed as a
matrix or a vector is known to be one, and of symbols the caller says so.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from itertools import pairwise
from typing import Any, TypeAlias

from omniproof.formula.errors import UnsupportedError
from omniproof.formula.grid import Grid
from omniproof.formula.term import Term
from omniproof.formula.writers.identifiers import identifier
from omniproof.formula.writers.printable import printable
from omniproof.transcription import tree
from omniproof.transcription.functions import FUNCTIONS

Formula: TypeAlias = tree.Node | Term | Grid
SUM, PRODUCT, POWER, ATOM = range(4)
"""Binding strengths of Python, the weakest first."""
ROW, NUMBER, COLUMN, MATRIX = -1, 0, 1, 2
"""Ranks; vectors are columns, a row is a transposed one."""
AXES = {"x": 0, "y": 1, "z": 2}
JOINED = {(ROW, MATRIX): ROW, (MATRIX, COLUMN): COLUMN, (ROW, COLUMN): NUMBER}
"""Ranks of products of arrays; of all others it is a matrix."""
COMPARE = {"<": "less", ">": "greater", "\\leq": "less_equal", "\\geq": "greater_equal",
           "\\neq": "not_equal"}  # fmt: skip


@dataclass(frozen=True)
class Code:
    """A piece of code; `whole` is one that Python itself evaluates to a whole number."""

    text: str
    strength: int = ATOM
    rank: int = NUMBER
    whole: bool = False
    items: tuple[Code, ...] = ()

    def within(self, strength: int) -> str:
        """Return the text, in brackets where it binds more weakly than its place needs."""
        return self.text if self.strength >= strength else f"({self.text})"


class CodeWriter(ABC):
    """Writes trees as Python; `ranks` are those of symbols that are no numbers, by name."""

    def __init__(self, ranks: Mapping[str, int]) -> None:
        self.ranks = ranks
        self.names: dict[str, str] = {}

    def lines(self, node: tree.Node) -> str:
        """Write a formula: a symbol that is said to be equal to something gets it assigned."""
        if isinstance(node, tree.Listing):
            return "\n".join(map(self.lines, node.items))
        if isinstance(node, tree.Chain) and node.relation == "=":
            first, last = node.sides[0], node.sides[-1]
            if node.continued or isinstance(first, tree.Name):
                start = "" if node.continued else f"{self.code(first).text} = "
                return start + self.code(last).text
        return self.code(node).text

    def code(self, node: tree.Node) -> Code:
        """Write a part; raises `UnsupportedError` for what has no code."""
        return tree.fold(node, self._written)

    def _written(self, node: tree.Node, parts: tuple[Code, ...]) -> Code:
        rule = _RULES.get(type(node))
        if rule is None:
            raise UnsupportedError(f"no code is written of a {type(node).__name__.lower()}")
        return rule(self, node, parts)

    def named(self, name: str) -> str:
        """Return the identifier of a symbol; two symbols never have one."""
        found = identifier(name)
        if self.names.setdefault(found, name) != name:
            message = f"`{self.names[found]}` and `{name}` would both be called `{found}`"
            raise UnsupportedError(message)
        return found

    def over(self, above: Code, below: Code) -> Code:
        """Write a quotient."""
        text = f"{above.within(PRODUCT)} / {below.within(POWER)}"
        return Code(text, PRODUCT, above.rank)

    def times(self, left: Code, right: Code) -> Code:
        """Write a product of two factors."""
        if NUMBER in (left.rank, right.rank):
            text = f"{left.within(PRODUCT)} * {right.within(POWER)}"
            rank = left.rank or right.rank
            return Code(text, PRODUCT, rank, left.whole and right.whole)
        return self.array_product(left, right)

    @abstractmethod
    def number(self, text: str) -> Code:
        """Write a decimal or whole number."""

    @abstractmethod
    def call(self, function: str, *arguments: Code) -> Code:
        """Write a function of the table."""

    @abstractmethod
    def spelled(self, name: str, *arguments: str) -> Code:
        """Write what NumPy and SymPy spell differently: `pi`, `degrees`, `cross`, …."""

    @abstractmethod
    def array_product(self, left: Code, right: Code) -> Code:
        """Write a product of vectors or matrices."""

    @abstractmethod
    def array(self, rows: Sequence[Sequence[Code]]) -> Code:
        """Write a matrix by its entries, or blocks."""

    @abstractmethod
    def columns(self, vectors: Sequence[Code]) -> Code:
        """Write a matrix by its columns."""

    @abstractmethod
    def cases(self, branches: Sequence[tuple[Code, Code]]) -> Code:
        """Write values, each with its condition."""

    @abstractmethod
    def integral(self, lower: Code, upper: Code, integrand: Code, variable: Code) -> Code:
        """Write a definite integral."""


def _sum(writer: CodeWriter, node: tree.Sum, parts: tuple[Code, ...]) -> Code:
    text = parts[0].text
    for term, part in zip(node.terms[1:], parts[1:], strict=True):
        minus = isinstance(term, tree.Negative)
        text += f" - {part.text[1:]}" if minus else f" + {part.within(PRODUCT)}"
    return Code(text, SUM, parts[0].rank, all(part.whole for part in parts))


def _negative(writer: CodeWriter, node: tree.Negative, parts: tuple[Code, ...]) -> Code:
    # A product behind the sign reads as it does in print, and has the same value.
    return replace(parts[0], text=f"-{parts[0].within(PRODUCT)}", strength=SUM, items=())


def _power(writer: CodeWriter, node: tree.Power, parts: tuple[Code, ...]) -> Code:
    (base,), exponent = parts, node.exponent
    if base.rank:
        found = writer.spelled("matrix_power", base.within(ATOM), str(exponent))
        return replace(found, rank=base.rank)
    if exponent < 0:
        inverse = _power(writer, replace(node, exponent=-exponent), parts)
        return writer.over(Code("1", whole=True), inverse)
    if exponent == 1:
        return base
    return Code(f"{base.within(ATOM)}**{exponent}", POWER, whole=base.whole)


def _call(writer: CodeWriter, node: tree.Call, parts: tuple[Code, ...]) -> Code:
    if node.function == "det":
        return writer.spelled("determinant", parts[0].within(ATOM))
    if FUNCTIONS[node.function].arguments == 1:
        return writer.call(node.function, parts[0])
    return reduce(lambda a, b: writer.call(node.function, a, b), parts[0].items)


def _vectors(name: str) -> Callable[..., Code]:
    """Write an operation on two vectors; on numbers it is a product."""

    def rule(writer: CodeWriter, node: tree.Node, parts: tuple[Code, ...]) -> Code:
        left, right = parts
        if not isinstance(node, tree.Inner) and not left.rank == right.rank == COLUMN:
            return writer.times(left, right)
        if name == "cross" and 2 in (len(left.items), len(right.items)):
            raise UnsupportedError("no code is written of a cross product of vectors in the plane")
        found = writer.spelled(name, left.within(ATOM), right.within(ATOM))
        return replace(found, rank=COLUMN if name == "cross" else NUMBER)

    return rule


def _transpose(writer: CodeWriter, node: tree.Transpose, parts: tuple[Code, ...]) -> Code:
    if isinstance(node.operand, tree.Tuple):  # printed in a line, it stands for a column already
        return parts[0]
    rank = {COLUMN: ROW, ROW: COLUMN}.get(parts[0].rank, MATRIX)
    return Code(f"{parts[0].within(ATOM)}.T", rank=rank)


def _norm(writer: CodeWriter, node: tree.Norm, parts: tuple[Code, ...]) -> Code:
    if parts[0].rank:
        return writer.spelled("norm", parts[0].within(ATOM))
    return writer.call("abs", parts[0])


def _component(writer: CodeWriter, node: tree.Component, parts: tuple[Code, ...]) -> Code:
    place = AXES.get(node.axis, int(node.axis) - 1 if node.axis.isdigit() else -1)
    return Code(f"{parts[0].within(ATOM)}[{place}]")


def _tuple(writer: CodeWriter, node: tree.Tuple, parts: tuple[Code, ...]) -> Code:
    if node.kind == "set":
        return Code(f"{{{', '.join(part.text for part in parts)}}}")
    vectors = all(part.rank for part in parts)
    found = writer.columns(parts) if vectors else writer.array([(part,) for part in parts])
    return replace(found, items=parts)


def _matrix(writer: CodeWriter, node: tree.MatrixLiteral, parts: tuple[Code, ...]) -> Code:
    width = len(node.rows[0])
    return writer.array([parts[k : k + width] for k in range(0, len(parts), width)])


def _chain(writer: CodeWriter, node: tree.Chain, parts: tuple[Code, ...]) -> Code:
    name = "equal" if node.relation == "=" else "equivalent"
    pairs = [writer.spelled(name, a.text, b.text) for a, b in pairwise(parts)]
    return reduce(lambda a, b: writer.spelled("and", a.text, b.text), pairs)


def _logic(writer: CodeWriter, node: tree.Logic, parts: tuple[Code, ...]) -> Code:
    return reduce(lambda a, b: writer.spelled(node.operator, a.text, b.text), parts)


def _applied(writer: CodeWriter, node: tree.Applied, parts: tuple[Code, ...]) -> Code:
    arguments = ", ".join(part.text for part in parts)
    return Code(f"{writer.named(node.name)}({arguments})", rank=writer.ranks.get(node.name, NUMBER))


Rule: TypeAlias = Callable[[CodeWriter, Any, tuple[Code, ...]], Code]
_RULES: dict[type[tree.Node], Rule] = {
    tree.Number: lambda writer, node, parts: writer.number(node.text),
    tree.Degrees: lambda writer, node, parts: writer.spelled(
        "degrees", writer.number(node.value).text
    ),
    tree.Pi: lambda writer, node, parts: writer.spelled("pi"),
    tree.Name: lambda writer, node, parts: Code(
        writer.named(node.name), rank=writer.ranks.get(node.name, NUMBER)
    ),
    tree.Applied: _applied,
    tree.Negative: _negative,
    tree.Sum: _sum,
    tree.Product: lambda writer, node, parts: reduce(writer.times, parts),
    tree.Dot: _vectors("inner"),
    tree.Cross: _vectors("cross"),
    tree.Inner: _vectors("inner"),
    tree.Quotient: lambda writer, node, parts: writer.over(*parts),
    tree.Power: _power,
    tree.Transpose: _transpose,
    tree.Call: _call,
    tree.Integral: lambda writer, node, parts: writer.integral(*parts),
    tree.Norm: _norm,
    tree.Absolute: lambda writer, node, parts: writer.call("abs", *parts),
    tree.Determinant: lambda writer, node, parts: writer.spelled(
        "determinant", writer.columns(parts).text
    ),
    tree.Component: _component,
    tree.Tuple: _tuple,
    tree.MatrixLiteral: _matrix,
    tree.Branch: lambda writer, node, parts: Code("", items=parts),
    tree.Cases: lambda writer, node, parts: writer.cases(
        [(part.items[0], part.items[1]) for part in parts]
    ),
    tree.Comparison: lambda writer, node, parts: writer.spelled(
        COMPARE[node.operator], parts[0].text, parts[1].text
    ),
    tree.Logic: _logic,
    tree.Chain: _chain,
}


def written(writer: CodeWriter, formula: Formula) -> str:
    """Write a tree, a term or a grid of terms."""
    return writer.lines(formula if isinstance(formula, tree.Node) else printable(formula))
