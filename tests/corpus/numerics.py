"""The value of a printed tree by 60-digit arithmetic: no SymPy, no FLINT, no engine.

Only the reader is shared with what is measured. Matrices are lists of rows of mpmath numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, reduce
from itertools import pairwise
from typing import Any, TypeAlias

from mpmath import mp, mpf

from omniproof.transcription import tree
from omniproof.transcription.reader import read

DIGITS = 60
Matrix: TypeAlias = list[list[Any]]
Value: TypeAlias = Any
FUNCTIONS = {
    "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "cot": mp.cot, "sec": mp.sec, "csc": mp.csc,
    "arctan": mp.atan,
}  # fmt: skip


@cache
def parsed(text: str) -> tree.Node:
    """Read a formula once."""
    return read(text)


class OutsideError(ArithmeticError):
    """A root of a negative number: the formula is not defined at the point."""


@dataclass(frozen=True)
class Side:
    """Two values next to each other in a chain, and the relation that is printed between them."""

    left: Value
    relation: str
    right: Value

    def entries(self) -> list[tuple[Any, Any]]:
        """Return the numbers to compare, entry by entry."""
        if not isinstance(self.left, list):
            return [(self.left, self.right)]
        rows = zip(self.left, self.right, strict=True)
        return [pair for left, right in rows for pair in zip(left, right, strict=True)]

    def holds(self) -> bool:
        """Whether the relation holds, with 20 guard digits."""
        pairs = self.entries()
        if self.relation == "=":
            return all(_near(left, right) for left, right in pairs)
        ((left, right),) = pairs
        less = {"<": left < right, "\\leq": left <= right or _near(left, right),
                ">": left > right, "\\geq": left >= right or _near(left, right)}  # fmt: skip
        return bool(less[self.relation])


def _near(left: Any, right: Any) -> bool:
    return bool(abs(left - right) <= mpf(10) ** (20 - DIGITS) * (1 + abs(left) + abs(right)))


def sides(node: tree.Node, values: Mapping[str, Value]) -> list[Side]:
    """Evaluate a statement at a point."""
    if isinstance(node, tree.Chain):
        found = [value(side, values) for side in node.sides]
        return [Side(left, "=", right) for left, right in pairwise(found)]
    assert isinstance(node, tree.Comparison)
    return [Side(value(node.left, values), node.operator, value(node.right, values))]


def with_definitions(where: tuple[str, ...], values: Mapping[str, Value]) -> dict[str, Value]:
    """Add what is defined before a formula to the values of its symbols."""
    known = dict(values)
    for text in where:
        node = parsed(text)
        assert isinstance(node, tree.Chain)
        name, meaning = node.sides
        assert isinstance(name, tree.Name)
        known[name.name] = value(meaning, known)
    return known


def value(node: tree.Node, values: Mapping[str, Value]) -> Value:  # noqa: C901 - one case a node
    """Evaluate an expression at a point."""

    def go(inner: tree.Node) -> Value:
        return value(inner, values)

    match node:
        case tree.Number(text=text):
            return mpf(text)
        case tree.Degrees(value=text):
            return mpf(text) * mp.pi / 180
        case tree.Pi():
            return +mp.pi
        case tree.Name(name=name) if name.startswith("\\det "):
            return _det(values[name.removeprefix("\\det ")])
        case tree.Name(name=name):
            return values[name]
        case tree.Negative(operand=operand):
            return _times(mpf(-1), go(operand))
        case tree.Sum(terms=terms):
            return reduce(_plus, map(go, terms))
        case tree.Product(factors=factors):
            return reduce(_times, map(go, factors))
        case tree.Dot(left=left, right=right):
            return _times(go(left), go(right))
        case tree.Cross(left=left, right=right):
            return _cross(go(left), go(right))
        case tree.Quotient(numerator=above, denominator=below):
            return _times(1 / go(below), go(above))
        case tree.Power(base=base, exponent=exponent):
            return _power(go(base), exponent)
        case tree.Transpose(operand=operand):
            return [list(row) for row in zip(*go(operand), strict=True)]
        case tree.Call(function="sqrt", argument=argument):
            return _root(go(argument))
        case tree.Call(function="det", argument=argument):
            return _det(go(argument))
        case tree.Call(function=function, argument=argument):
            return FUNCTIONS[function](go(argument))
        case tree.Absolute(operand=operand):
            return abs(go(operand))
        case tree.Norm(operand=operand):
            return mp.sqrt(sum(entry**2 for row in go(operand) for entry in row))
        case tree.Inner(left=left, right=right):
            return sum(a[0] * b[0] for a, b in zip(go(left), go(right), strict=True))
        case tree.Tuple(items=items):
            return [[go(item)] for item in items]
        case tree.MatrixLiteral(rows=rows):
            return [line for row in rows for line in _beside([go(entry) for entry in row])]
    raise NotImplementedError(type(node).__name__)


def _beside(blocks: list[Value]) -> Matrix:
    """Put the blocks of one row of a matrix beside each other."""
    full = [block if isinstance(block, list) else [[block]] for block in blocks]
    return [[entry for part in parts for entry in part] for parts in zip(*full, strict=True)]


def _root(radicand: Any) -> Any:
    if radicand < 0:
        raise OutsideError
    return mp.sqrt(radicand)


def _plus(left: Value, right: Value) -> Value:
    if not isinstance(left, list):
        return left + right
    rows = zip(left, right, strict=True)
    return [[a + b for a, b in zip(*pair, strict=True)] for pair in rows]


def _times(left: Value, right: Value) -> Value:
    if not isinstance(left, list) and not isinstance(right, list):
        return left * right
    if not isinstance(left, list):
        return [[left * entry for entry in row] for row in right]
    if not isinstance(right, list):
        return [[entry * right for entry in row] for row in left]
    columns = list(zip(*right, strict=True))
    return [[mp.fdot(row, column) for column in columns] for row in left]


def _cross(left: Matrix, right: Matrix) -> Matrix:
    (a,), (b,), (c,) = left
    (x,), (y,), (z,) = right
    return [[b * z - c * y], [c * x - a * z], [a * y - b * x]]


def _det(matrix: Matrix) -> Any:
    """Expand by the first row."""
    if len(matrix) == 1:
        return matrix[0][0]
    minors = ([row[:k] + row[k + 1 :] for row in matrix[1:]] for k in range(len(matrix)))
    return sum((-1) ** k * matrix[0][k] * _det(minor) for k, minor in enumerate(minors))


def _power(base: Value, exponent: int) -> Value:
    if not isinstance(base, list):
        return base**exponent
    if exponent < 0:
        base = mp.matrix(base) ** -1
        base = [[base[i, j] for j in range(base.cols)] for i in range(base.rows)]
    result = base
    for _ in range(abs(exponent) - 1):
        result = _times(result, base)
    return result
