"""Whether a formula of the corpus holds at a point, by the digits that judge the mutation study.

They rest on mpmath and on the reader alone: no engine, no FLINT.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from itertools import pairwise

from mpmath import mp

from omniproof.decide import digits
from omniproof.transcription import tree
from omniproof.transcription.reader import read

Point = Mapping[str, digits.Value]


@cache
def parsed(text: str) -> tree.Node:
    """Read a formula once."""
    return read(text)


def value(text: str | tree.Node, point: Point) -> digits.Value:
    """Evaluate an expression at a point; raises `UndefinedError` where it has no real value."""

    def meaning(symbol: tree.Symbolic, _: digits.Bound) -> digits.Value:
        known = point[symbol.name.removeprefix("\\det ")]
        return mp.det(known) if symbol.name.startswith("\\det ") else known

    return digits.value(parsed(text) if isinstance(text, str) else text, meaning)


def holds(text: str, point: Point) -> bool:
    """Whether an equation, a chain or a comparison is true at a point; equal is: to 40 digits."""
    node = parsed(text)
    if isinstance(node, tree.Chain):
        sides = [value(side, point) for side in node.sides if side is not None]
        return all(digits.are_equal(*pair) for pair in pairwise(sides))
    assert isinstance(node, tree.Comparison)
    left, right = value(node.left, point), value(node.right, point)
    less = {"<": left < right, ">": left > right}
    return less[node.operator] if node.operator in less else _at_most(node.operator, left, right)


def _at_most(operator: str, left: digits.Value, right: digits.Value) -> bool:
    low, high = (left, right) if operator == "\\leq" else (right, left)
    return bool(low < high) or digits.are_equal(low, high)


def with_definitions(where: tuple[str, ...], point: Point) -> dict[str, digits.Value]:
    """Add what is defined before a formula to the values of its symbols."""
    known = dict(point)
    for text in where:
        node = parsed(text)
        assert isinstance(node, tree.Chain)
        name, meaning = node.sides
        assert isinstance(name, tree.Name)
        assert meaning is not None
        known[name.name] = value(meaning, known)
    return known
