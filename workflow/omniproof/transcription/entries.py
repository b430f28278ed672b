"""The printed LaTeX of one entry of a matrix or vector."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from omniproof.transcription.tree import MatrixLiteral, Node, Power, Span, Tuple, children


def entry_source(
    text: str, node: Node, index: Sequence[int], shape: tuple[int, int] | None = None
) -> str | None:
    """Return entry `index` (one or two numbers from 1) of the matrix or vector in a tree, verbatim.

    `text` is what `node` was read from; `shape` as in `entry_span`. `None` where there is none.
    """
    span = entry_span(node, index, shape)
    return text[slice(*span)] if span else None


def entry_span(
    node: Node, index: Sequence[int], shape: tuple[int, int] | None = None
) -> Span | None:
    """Return where entry `index` of the matrix or vector in a tree stands in its text.

    `shape` (rows, columns) narrows the choice. `None` where no printed matrix has such an entry, or
    more than one. The entries of a matrix that is raised to a power, or inverted, are not those of
    the result.
    """
    grids = map(_grid, _outside_powers(node))
    found = [grid for grid in grids if grid and _fits(grid, index, shape)]
    return _entry(found[0], index).span if len(found) == 1 else None


def _outside_powers(node: Node) -> Iterator[Node]:
    """The node and what is below it, except the base of a power."""
    yield node
    for child in () if isinstance(node, Power) else children(node):
        yield from _outside_powers(child)


def _grid(node: Node) -> tuple[tuple[Node, ...], ...]:
    """The rows of a printed matrix; a tuple is a column. Anything else has none."""
    if isinstance(node, MatrixLiteral):
        return node.rows
    if isinstance(node, Tuple) and node.kind == "tuple":
        return tuple((item,) for item in node.items)
    return ()


def _fits(
    grid: tuple[tuple[Node, ...], ...], index: Sequence[int], shape: tuple[int, int] | None
) -> bool:
    rows, columns = len(grid), len(grid[0])
    vector = 1 in (rows, columns)
    if shape is not None and shape != (rows, columns) and not (vector and shape == (columns, rows)):
        return False
    if len(index) == 1:
        return vector and 1 <= index[0] <= max(rows, columns)
    return not vector and 1 <= index[0] <= rows and 1 <= index[1] <= columns


def _entry(grid: tuple[tuple[Node, ...], ...], index: Sequence[int]) -> Node:
    if len(index) == 1:
        return [entry for row in grid for entry in row][index[0] - 1]
    return grid[index[0] - 1][index[1] - 1]
