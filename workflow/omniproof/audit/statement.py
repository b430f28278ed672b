r"""A printed statement as links `left operator right` between numbers.

`a = b = c` has two links, `0 < a < b` too, and an equation between matrices one for each entry: a
verdict can then name the step and the entry that fails.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise, product
from typing import Any, NoReturn, TypeAlias

import sympy as sp

from omniproof.audit.zero_test import Terms, both_terms
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.grid import Grid
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError

Evaluate: TypeAlias = Callable[[tree.Node], Any]


@dataclass(frozen=True)
class Link:
    """Two numbers and how they are said to be related; `place` names step and entry.

    `printed` are the sides as they are printed, of which these are the entries at `index`; `terms`
    are they, before SymPy had an idea of them.
    """

    left: sp.Expr
    operator: str
    right: sp.Expr
    place: str = ""
    printed: tuple[tree.Node, ...] = ()
    index: tuple[int, int] = (0, 0)
    terms: Terms | None = None


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


def links(
    node: tree.Node, value: Evaluate, text: str, unfolded: Evaluate | None = None
) -> tuple[Link, ...]:
    """Take a statement apart, in printed order; `value` gives the value of a side in SymPy.

    `unfolded` gives it in terms, for the engines that look at what is printed.
    Raises `LatexError` for what states nothing or has sides of different shapes, and
    `UnsupportedError` for statements that are not decided here.
    """
    steps = tuple(_steps(node, text))
    names = [f"`{step.source(text)}`" if len(steps) > 1 else "" for step in steps]
    named = zip(steps, names, strict=True)
    found = tuple(link for step, name in named for link in _entries(step, name, value, text))
    return found if unfolded is None else tuple(_with_terms(link, unfolded) for link in found)


def _with_terms(link: Link, unfolded: Evaluate) -> Link:
    row, column = link.index
    sides = (unfolded(side) for side in link.printed)
    left, right = (s.rows[row][column] if isinstance(s, Grid) else s for s in sides)
    return replace(link, terms=both_terms(left, right))


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
    if not all(isinstance(side, sp.Expr | sp.MatrixBase) for side in (left, right)):
        raise UnsupportedError("only numbers, vectors and matrices are compared here")
    printed = step.left, step.right
    shapes: list[Any] = [getattr(side, "shape", ()) for side in (left, right)]
    if shapes == [(), ()]:
        yield Link(left, step.operator, right, name, printed)
        return
    whole = tree.Node(span=(step.left.span[0], step.right.span[1]))
    if step.operator != "=":
        _refuse(whole, text, "expected numbers, found a matrix", "compare entry by entry")
    if shapes[0] != shapes[1]:
        found = " and ".join(_shape(shape) for shape in shapes)
        _refuse(whole, text, f"expected sides of one shape, found {found}", "")
    for index, entry in _places(shapes[0]):
        place = f"{entry} of {name}" if name else entry
        yield Link(left[index], step.operator, right[index], place, printed, index)


def _places(shape: tuple[int, int]) -> Iterator[tuple[tuple[int, int], str]]:
    """Yield each index from 0 and what a reader calls it, from 1."""
    rows, columns = shape
    for i, k in product(range(rows), range(columns)):
        yield (i, k), f"row {i + 1}, column {k + 1}" if columns > 1 else f"entry {i + 1}"


def _shape(shape: tuple[int, ...]) -> str:
    return f"a {shape[0]}×{shape[1]} matrix" if shape else "a number"


def _refuse(node: tree.Node, text: str, message: str, cure: str) -> NoReturn:
    raise LatexError(message, text, node.span, cure)
