"""Terms as trees that could have been printed: with quotients, signs, and roots as people write."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from omniproof.formula.grid import Grid
from omniproof.formula.term import (
    Call,
    Integral,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    Term,
    fold,
)
from omniproof.transcription import tree
from omniproof.transcription.functions import FUNCTIONS

Parts = tuple[tree.Node, ...]
ONE = tree.Number("1")


def printable(value: Term | Grid) -> tree.Node:
    """Return a term, or a matrix of terms, as a tree; a column is written as a matrix, too."""
    if isinstance(value, Grid):
        return tree.MatrixLiteral(tuple(tuple(map(printable, row)) for row in value.rows))
    return fold(value, lambda term, parts: _RULES[type(term)](term, parts))


def _number(term: Number, parts: Parts) -> tree.Node:
    size = abs(term.value)
    node: tree.Node = tree.Number(str(size.numerator))
    if size.denominator != 1:
        node = tree.Quotient(node, tree.Number(str(size.denominator)))
    return tree.Negative(node) if term.value < 0 else node


def _product(term: Product, parts: Parts) -> tree.Node:
    """Put what is divided by below a line, and one sign before it."""
    above: list[tree.Node] = []
    below: list[tree.Node] = []
    minus = False
    for part in parts:
        minus ^= isinstance(part, tree.Negative)
        size = part.operand if isinstance(part, tree.Negative) else part
        quotient = size if isinstance(size, tree.Quotient) else tree.Quotient(size, ONE)
        above += _factors(quotient.numerator)
        below += _factors(quotient.denominator)
    node = _joined(above)
    if below:
        node = tree.Quotient(node, _joined(below))
    return tree.Negative(node) if minus else node


def _factors(node: tree.Node) -> Parts:
    if isinstance(node, tree.Product):
        return node.factors
    return () if node == ONE else (node,)


def _joined(factors: list[tree.Node]) -> tree.Node:
    if len(factors) > 1:
        return tree.Product(tuple(factors))
    return factors[0] if factors else ONE


def _power(term: Power, parts: Parts) -> tree.Node:
    size = abs(term.exponent)
    node = parts[0] if size == 1 else tree.Power(parts[0], size)
    return node if term.exponent >= 0 else tree.Quotient(ONE, node)


def _call(term: Call, parts: Parts) -> tree.Node:
    if term.function not in FUNCTIONS:
        return tree.Applied(term.function, parts)
    if term.function == "abs":
        return tree.Absolute(*parts)
    return tree.Call(term.function, parts[0] if len(parts) == 1 else tree.Tuple(parts))


_RULES: dict[type[Term], Callable[[Any, Parts], tree.Node]] = {
    Number: _number,
    Pi: lambda term, parts: tree.Pi(),
    Symbol: lambda term, parts: tree.Name(term.name),
    Sum: lambda term, parts: tree.Sum(parts),
    Product: _product,
    Power: _power,
    Call: _call,
    Integral: lambda term, parts: tree.Integral(
        parts[1], parts[2], parts[0], tree.Name(term.variable.name)
    ),
}
