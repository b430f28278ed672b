r"""The printed formula as a tree: nothing is evaluated, ordered or cancelled.

SymPy turns `-L \sin\alpha_1 + L \sin\alpha_1` into 0 and the misprint is gone; here both terms
stay, each with its place in the source: messages can point at them, and repairs can edit them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, fields
from typing import Literal, TypeAlias, TypeVar

T = TypeVar("T")
Span: TypeAlias = tuple[int, int]
"""Offsets of a node in its source text, as in `source[start:end]`."""


@dataclass(frozen=True)
class Node:
    """A piece of a printed formula; nodes that read alike are equal, wherever they stand."""

    span: Span = field(default=(0, 0), compare=False, kw_only=True)


@dataclass(frozen=True)
class Number(Node):
    """A number as printed: `2`, `3.08`."""

    text: str


@dataclass(frozen=True)
class Degrees(Node):
    r"""An angle `30^\circ`; `value` as printed."""

    value: str


@dataclass(frozen=True)
class Pi(Node):
    r"""The number `\pi`."""


@dataclass(frozen=True)
class Name(Node):
    r"""A printed symbol in canonical spelling: fonts dropped, `\hat{a}_1`, `v_k^T`, `\det A`."""

    name: str


@dataclass(frozen=True)
class Applied(Node):
    r"""A quantity with its arguments, `D_V(\theta)`."""

    name: str
    arguments: tuple[Node, ...]


@dataclass(frozen=True)
class Negative(Node):
    """`-a`; a difference is a sum with a negative term."""

    operand: Node


@dataclass(frozen=True)
class Sum(Node):
    """`a + b - c`, in printed order."""

    terms: tuple[Node, ...]


@dataclass(frozen=True)
class Product(Node):
    """Juxtaposed factors, in printed order."""

    factors: tuple[Node, ...]


@dataclass(frozen=True)
class Dot(Node):
    r"""`a \cdot b`: inner product of vectors, product of everything else."""

    left: Node
    right: Node


@dataclass(frozen=True)
class Cross(Node):
    r"""`a \times b`: cross product of vectors, product of numbers."""

    left: Node
    right: Node


@dataclass(frozen=True)
class Quotient(Node):
    """A fraction or `a / b`."""

    numerator: Node
    denominator: Node


@dataclass(frozen=True)
class Power(Node):
    """A whole power, the inverse of a matrix included."""

    base: Node
    exponent: int


@dataclass(frozen=True)
class Transpose(Node):
    """`a^T` where no such symbol is declared."""

    operand: Node


@dataclass(frozen=True)
class Call(Node):
    """An elementary function; `atan2` has a tuple of two as its argument."""

    function: str
    argument: Node


@dataclass(frozen=True)
class Integral(Node):
    r"""`\int_{lower}^{upper} integrand d variable`; papers call variable and upper limit alike."""

    lower: Node
    upper: Node
    integrand: Node
    variable: Name


@dataclass(frozen=True)
class Inner(Node):
    r"""`\langle a, b \rangle`."""

    left: Node
    right: Node


@dataclass(frozen=True)
class Norm(Node):
    r"""`\|a\|`."""

    operand: Node


@dataclass(frozen=True)
class Absolute(Node):
    """`|a|`."""

    operand: Node


@dataclass(frozen=True)
class Determinant(Node):
    r"""`\det[a_1, a_2, a_3]`, by columns."""

    columns: tuple[Node, ...]


@dataclass(frozen=True)
class Component(Node):
    """`(a)_z`; `axis` as printed: x, y, z, or a number from 1."""

    vector: Node
    axis: str


@dataclass(frozen=True)
class Tuple(Node):
    r"""`(a, b)` or `[a, b]`, which stand for a vector, or a set `\{a, b\}`."""

    items: tuple[Node, ...]
    kind: Literal["tuple", "set"] = "tuple"


@dataclass(frozen=True)
class MatrixLiteral(Node):
    """A printed matrix by rows of equal length."""

    rows: tuple[tuple[Node, ...], ...]


@dataclass(frozen=True)
class SetBuilder(Node):
    r"""`\{element \mid condition, condition\}`."""

    element: Node
    conditions: tuple[Node, ...]


@dataclass(frozen=True)
class Branch(Node):
    """One line of a brace: a value and its condition."""

    value: Node
    condition: Node


@dataclass(frozen=True)
class Cases(Node):
    """A definition by cases."""

    branches: tuple[Branch, ...]


@dataclass(frozen=True)
class Comparison(Node):
    r"""`a < b`; the operator is one of `<`, `>`, `\leq`, `\geq`, `\neq`."""

    left: Node
    operator: str
    right: Node


@dataclass(frozen=True)
class Logic(Node):
    """Statements joined by `and` or by `or`; `0 < a < b` is read as two of them."""

    operator: Literal["and", "or"]
    operands: tuple[Node, ...]


@dataclass(frozen=True)
class Chain(Node):
    r"""`a = b = c`, or statements joined by `\Leftrightarrow`.

    A `continued` chain (`= b`) is printed without its first side, which stands in a display before.
    """

    sides: tuple[Node, ...]
    relation: str = "="
    continued: bool = False


@dataclass(frozen=True)
class Listing(Node):
    """Statements or expressions side by side: `a = 1, b = 2`."""

    items: tuple[Node, ...]


Symbolic = Name | Applied
"""A symbol: what it means is known from outside of the formula."""

STATEMENTS = (Chain, Comparison, Logic, Listing)
"""What is true or false, and therefore no factor, term or argument."""


def children(node: Node) -> tuple[Node, ...]:
    """The nodes directly below, in printed order."""
    found: list[Node] = []
    for item in fields(node):
        found.extend(_nodes(getattr(node, item.name)))
    return tuple(found)


def _nodes(value: object) -> Iterator[Node]:
    if isinstance(value, Node):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from _nodes(item)


def walk(node: Node) -> Iterator[Node]:
    """The node and everything below it, from the outside in, in printed order."""
    yield node
    for child in children(node):
        yield from walk(child)


def fold(node: Node, rule: Callable[[Node, tuple[T, ...]], T]) -> T:
    """Compute something of a tree from the inside out: `rule` gets a node and what its parts gave.

    Parts are those of `children`, in that order.
    """
    return rule(node, tuple(fold(child, rule) for child in children(node)))


def names(node: Node) -> set[str]:
    """The canonical names of all symbols in a tree."""
    return {item.name for item in walk(node) if isinstance(item, Name | Applied)}
