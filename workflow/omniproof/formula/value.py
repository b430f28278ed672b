"""What a printed formula is, unfolded: a number, a matrix, a statement, a list."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

from omniproof.formula.grid import Grid
from omniproof.formula.term import Term

Value: TypeAlias = Any
"""A `Term`, a `Grid`, a `Statement`, `Cases`, or a tuple of these."""


@dataclass(frozen=True)
class Function:
    """What a quantity is, and the names in it that its printed arguments replace.

    The value is a term or grid, or SymPy's expression or matrix of a derivation.
    """

    value: Any
    of: tuple[str, ...]


@dataclass(frozen=True)
class Comparison:
    r"""`a < b`; the operator is one of `=`, `<`, `>`, `\leq`, `\geq`, `\neq`."""

    left: Any
    operator: str
    right: Any


@dataclass(frozen=True)
class Logic:
    """Statements that all hold, of which one holds, or of which all or none hold."""

    operator: Literal["and", "or", "equivalent"]
    operands: tuple[Any, ...]


Statement: TypeAlias = Comparison | Logic
"""What is true or false of terms."""


@dataclass(frozen=True)
class Cases:
    """A number by cases: values, each with its condition."""

    branches: tuple[tuple[Term, Statement], ...]


def terms_in(value: Value) -> Iterator[Term]:
    """Yield the numbers in a value; those of cases only hold for some values, and are left out."""
    match value:
        case Term():
            yield value
        case Grid(entries=parts) | Logic(operands=parts) | (tuple() as parts):
            for part in parts:
                yield from terms_in(part)
        case Comparison(left=left, right=right):
            yield from (left, right)


def kind(value: Value) -> str:
    """Say in words what a value is."""
    match value:
        case Grid(shape=(rows, 1)):
            return f"a vector of {rows}"
        case Grid(shape=(rows, columns)):
            return f"a {rows}×{columns} matrix"
        case Term():
            return "a number"
        case tuple() | Cases():
            return "a list" if isinstance(value, tuple) else "cases"
    return "a statement"
