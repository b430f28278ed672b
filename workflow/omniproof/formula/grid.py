"""Matrices of terms, of which a vector is one column; shapes are checked by whoever multiplies."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain

from omniproof.formula.term import (
    ONE,
    ZERO,
    Number,
    Power,
    Term,
    add,
    divide,
    multiply,
    negative,
    rational,
)

LARGEST_DETERMINANT = 6
"""Larger determinants with symbols have n! terms: 5 040 of seven factors each for n = 7."""


class ShapeError(ValueError):
    """Parts do not fit together; the text says which."""


@dataclass(frozen=True)
class Grid:
    """A matrix by rows of equal length."""

    rows: tuple[tuple[Term, ...], ...]

    @staticmethod
    def column(entries: tuple[Term, ...]) -> Grid:
        """Return a vector."""
        return Grid(tuple((entry,) for entry in entries))

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of rows and columns."""
        return len(self.rows), len(self.rows[0])

    @property
    def is_vector(self) -> bool:
        """Whether this is one column of at least two entries."""
        return self.shape[1] == 1 < self.shape[0]

    @property
    def entries(self) -> tuple[Term, ...]:
        """All entries in printed order."""
        return tuple(chain.from_iterable(self.rows))

    def at(self, row: int, column: int = 1) -> Term:
        """Return an entry by its printed place, counted from 1."""
        return self.rows[row - 1][column - 1]

    @property
    def transposed(self) -> Grid:
        """Rows as columns."""
        return Grid(tuple(zip(*self.rows, strict=True)))

    def __add__(self, other: Grid) -> Grid:
        """Add entry by entry."""
        pairs = zip(self.rows, other.rows, strict=True)
        return Grid(tuple(tuple(map(add, *pair)) for pair in pairs))

    def __matmul__(self, other: Grid) -> Grid:
        """Multiply by rows and columns; a factor that is plainly 0 leaves its term out."""
        columns = other.transposed.rows
        return Grid(tuple(tuple(inner(row, column) for column in columns) for row in self.rows))

    def scaled(self, factor: Term) -> Grid:
        """Multiply each entry, the factor first."""
        return Grid(tuple(tuple(multiply(factor, x) for x in row) for row in self.rows))

    @property
    def is_rational(self) -> bool:
        """Whether all entries are numbers."""
        return all(rational(entry) is not None for entry in self.entries)

    @property
    def rational_determinant(self) -> Fraction:
        """The determinant of a matrix of numbers, by elimination."""
        rows = [[rational(entry) or Fraction(0) for entry in row] for row in self.rows]
        total = Fraction(1)
        while rows:
            pivot = next((k for k, row in enumerate(rows) if row[0]), None)
            if pivot is None:
                return Fraction(0)
            rows[0], rows[pivot] = rows[pivot], rows[0]
            total *= rows[0][0] if pivot == 0 else -rows[0][0]
            first, *rest = rows
            rows = [
                [x - row[0] / first[0] * y for x, y in zip(row[1:], first[1:], strict=True)]
                for row in rest
            ]
        return total

    @property
    def determinant(self) -> Term:
        """The determinant by minors of the first row; the entries printed as 0 are left out."""
        size = len(self.rows)
        if size == 1:
            return self.rows[0][0]
        terms = [
            multiply(entry, minor if k % 2 == 0 else negative(minor))
            for k, entry in enumerate(self.rows[0])
            if entry != ZERO and (minor := self.without(0, k).determinant) != ZERO
        ]
        return add(*terms) if terms else ZERO

    def without(self, row: int, column: int) -> Grid:
        """Return the matrix without a row and a column."""
        kept = (line for i, line in enumerate(self.rows) if i != row)
        return Grid(tuple(line[:column] + line[column + 1 :] for line in kept))

    @property
    def inverse(self) -> Grid:
        """The adjugate over the determinant, entry by entry."""
        size, determinant = len(self.rows), self.determinant
        if size == 1:
            return Grid(((Power(determinant, -1),),))

        def entry(i: int, k: int) -> Term:
            minor = self.without(k, i).determinant
            return divide(minor if (i + k) % 2 == 0 else negative(minor), determinant)

        return Grid(tuple(tuple(entry(i, k) for k in range(size)) for i in range(size)))

    @staticmethod
    def identity(size: int) -> Grid:
        """Return the unit matrix."""
        places = range(size)
        return Grid(tuple(tuple(ONE if i == k else ZERO for k in places) for i in places))

    @staticmethod
    def of_blocks(rows: Iterator[list[Grid]]) -> Grid:
        """Join blocks; raises `ShapeError` where they do not fit."""
        lines: list[tuple[Term, ...]] = []
        for blocks in rows:
            if len({len(block.rows) for block in blocks}) != 1:
                raise ShapeError
            pieces = zip(*(block.rows for block in blocks), strict=True)
            lines.extend(tuple(chain.from_iterable(piece)) for piece in pieces)
        if len({len(line) for line in lines}) != 1:
            raise ShapeError
        return Grid(tuple(lines))


def inner(left: tuple[Term, ...], right: tuple[Term, ...]) -> Term:
    """Return the sum of products of entries."""
    pairs = [(a, b) for a, b in zip(left, right, strict=True) if ZERO not in (a, b)]
    return add(*(_product(a, b) for a, b in pairs)) if pairs else ZERO


def _product(left: Term, right: Term) -> Term:
    if ONE in (left, right):
        return right if left == ONE else left
    return multiply(left, right)


def cross(left: Grid, right: Grid) -> Grid:
    """Return the cross product; vectors of the plane lie in z = 0."""
    a, b = ((*item.entries, Number(ZERO.value))[:3] for item in (left, right))
    turns = ((1, 2), (2, 0), (0, 1))
    return Grid.column(tuple(inner((a[i], negative(a[k])), (b[k], b[i])) for i, k in turns))
