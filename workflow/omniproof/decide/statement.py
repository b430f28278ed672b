r"""A printed statement as links `left operator right` between numbers.

`a = b = c` has two links, `0 < a < b` too, and an equation between matrices one for each entry: a
verdict can then name the step and the entry that fails.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise, product
from typing import Any, NoReturn, TypeAlias

from omniproof.formula.errors import UnsupportedError
from omniproof.formula.grid import Grid
from omniproof.formula.term import Term
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError

Evaluate: TypeAlias = Callable[[tree.Node], Any]


@dataclass(frozen=True)
class Link:
    """Two numbers and how they are said to be related; `place` names step and entry.

    `printed` are the sides as they are printed, of which these are the entries at `index`.
    """

    left: Term
    operator: str
    right: Term
    place: str = ""
    printed: tuple[tree.Node, ...] = ()
    index: tuple[int, int] = (0, 0)


@dataclass(frozen=True)
class _Step:
    """Two printed sides and the sign between them."""

    left: tree.Node
    operator: str
    right: tree.Node

    def source(self, text: str) -> str:
        """Cut the step out of the text."""
        sides = (" ".join(text[slice(*side.span)].split()) for side in (self.left, self.right))
        return f" {self.operator} ".join(sides)


def links(node: tree.Node, value: Evaluate, text: str) -> tuple[Link, ...]:
    """Take a statement apart, in printed order; `value` unfolds a side.

    Raises `LatexError` for what states nothing or has sides of different shapes, and
    `UnsupportedError` for statements that are not decided here.
    """
    steps = tuple(_steps(node, text))
    names = [f"`{step.source(text)}`" if len(steps) > 1 else "" for step in steps]
    named = zip(steps, names, strict=True)
    return tuple(link for step, name in named for link in _entries(step, name, value, text))


def _steps(node: tree.Node, text: str) -> Iterator[_Step]:
    match node:
        case tree.Chain(relation="=", continued=False) if len(node.sides) > 1:
            yield from (_Step(left, "=", right) for left, right in pairwise(node.sides))
        case tree.Comparison():
            yield _Step(node.left, node.operator, node.right)
        case tree.Logic(operator="and", operands=parts) | tree.Listing(items=parts):
            for part in parts:
                yield from _steps(part, text)
        case tree.Chain(relation="=") | tree.Chain(continued=True):
            _refuse(node, text, "expected something before the sign", "write `a = b`")
        case tree.Chain():
            raise UnsupportedError("equivalences are not decided here")
        case tree.Logic():
            raise UnsupportedError("alternatives joined by `or` are not decided here")
        case _:
            _refuse(node, text, "expected a statement, found an expression", "write `a = b`")


def _entries(step: _Step, name: str, value: Evaluate, text: str) -> Iterator[Link]:
    left, right = value(step.left), value(step.right)
    printed = step.left, step.right
    if isinstance(left, Term) and isinstance(right, Term):
        yield Link(left, step.operator, right, name, printed)
        return
    if not all(isinstance(side, Term | Grid) for side in (left, right)):
        raise UnsupportedError("only numbers, vectors and matrices are compared here")
    whole = tree.Node(span=(step.left.span[0], step.right.span[1]))
    if step.operator != "=":
        _refuse(whole, text, "expected numbers, found a matrix", "compare entry by entry")
    shapes: list[Any] = [getattr(side, "shape", ()) for side in (left, right)]
    if shapes[0] != shapes[1]:
        found = " and ".join(_shape(shape) for shape in shapes)
        _refuse(whole, text, f"expected sides of one shape, found {found}", "")
    for index, entry in _places(shapes[0]):
        place = f"{entry} of {name}" if name else entry
        row, column = index
        yield Link(left.rows[row][column], "=", right.rows[row][column], place, printed, index)


def _places(shape: tuple[int, int]) -> Iterator[tuple[tuple[int, int], str]]:
    """Yield each index from 0 and what a reader calls it, from 1."""
    rows, columns = shape
    for i, k in product(range(rows), range(columns)):
        yield (i, k), f"row {i + 1}, column {k + 1}" if columns > 1 else f"entry {i + 1}"


def _shape(shape: tuple[int, ...]) -> str:
    return f"a {shape[0]}×{shape[1]} matrix" if shape else "a number"


def _refuse(node: tree.Node, text: str, message: str, cure: str) -> NoReturn:
    raise LatexError(message, text, node.span, cure)
