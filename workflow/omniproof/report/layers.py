"""Lay out a graph in layers, every arrow downwards, narrow enough for a phone.

Graphviz would need a program beside Python, and a layout by forces would differ between machines.
The classic scheme needs neither (Sugiyama, Tagawa, Toda, IEEE Trans. SMC 11, 1981): leave out what
other arrows imply, put nodes into rows, let long arrows pass through rows as places of their own,
and order each row by the middle of its neighbours. All ties are broken by name.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

Arrow = tuple[str, str]
Spot = tuple[str, int]
"""A node in its row, or a passage of arrows through a row: name, number of the row."""

SWEEPS = 8
"""Times that all rows are ordered anew; the pictures of this project settle after three."""

PASSAGE = 0.2
"""Width of a passage, where a node has the width 1."""


@dataclass(frozen=True)
class Layout:
    """Places of nodes and paths of arrows: x in widths of a node, rows from 0 at the top."""

    places: Mapping[str, tuple[float, int]]
    paths: Mapping[Arrow, tuple[tuple[float, int], ...]]


def reduced(arrows: Iterable[Arrow]) -> frozenset[Arrow]:
    """Return the arrows that no chain of others implies. Raises `ValueError` for a cycle."""
    kept = frozenset(arrows)
    below = {node: _below(node, kept) for arrow in kept for node in arrow}
    if any(node in under for node, under in below.items()):
        raise ValueError("expected a graph without cycles")
    return frozenset(
        (start, end)
        for start, end in kept
        if not any(end in below[middle] for first, middle in kept if first == start)
    )


def laid_out(nodes: Iterable[str], arrows: Iterable[Arrow], widest: int) -> Layout:
    """Place the nodes in rows of at most `widest` nodes, each below all that lead to it.

    Raises `ValueError` for a cycle.
    """
    drawn = sorted(reduced(arrows))
    rows = _rows(sorted(set(nodes)), drawn, widest)
    chains = {arrow: _chain(arrow, rows) for arrow in drawn}
    table = _ordered(_table(rows, chains), chains)
    at = {spot: place for row in table for spot, place in _spread(row, rows).items()}
    return Layout(
        {node: (at[node, row], row) for node, row in rows.items()},
        {arrow: tuple((at[spot], spot[1]) for spot in chain) for arrow, chain in chains.items()},
    )


def _below(node: str, arrows: frozenset[Arrow]) -> set[str]:
    """Return all nodes that a chain of arrows leads to."""
    found: set[str] = set()
    waiting = [node]
    while waiting:
        start = waiting.pop()
        fresh = {end for first, end in arrows if first == start} - found
        found |= fresh
        waiting += fresh
    return found


def _rows(nodes: Sequence[str], arrows: Sequence[Arrow], widest: int) -> dict[str, int]:
    """Number the rows from the bottom up, so that a node stands close above what needs it.

    Filled like the beds of Coffman and Graham (1972): of the nodes that are free, those first
    from which the longest chain leads back to a beginning.
    """
    rows: dict[str, int] = {}
    number = 0
    while len(rows) < len(nodes):
        free = [
            node
            for node in nodes
            if node not in rows
            and all(rows.get(end, number) < number for start, end in arrows if start == node)
        ]
        for node in sorted(free, key=lambda node: (-_height(node, arrows), node))[:widest]:
            rows[node] = number
        number += 1
    return {node: number - 1 - row for node, row in rows.items()}


def _height(node: str, arrows: Sequence[Arrow]) -> int:
    """Return the number of arrows of the longest chain that ends at a node."""
    return max((1 + _height(start, arrows) for start, end in arrows if end == node), default=0)


def _chain(arrow: Arrow, rows: Mapping[str, int]) -> list[Spot]:
    """Return an arrow as spots: its ends, and a passage in every row between them.

    Arrows with one beginning share their passages, so that they run as one line and part late.
    """
    start, end = arrow
    between = [(f"{start} \N{RIGHTWARDS ARROW}", row) for row in range(rows[start] + 1, rows[end])]
    return [(start, rows[start]), *between, (end, rows[end])]


def _table(rows: Mapping[str, int], chains: Mapping[Arrow, Sequence[Spot]]) -> list[list[Spot]]:
    """Return the spots row by row, by name."""
    spots = sorted({(node, row) for node, row in rows.items()}.union(*chains.values()))
    return [[spot for spot in spots if spot[1] == row] for row in range(1 + max(rows.values()))]


def _ordered(
    table: list[list[Spot]], chains: Mapping[Arrow, Sequence[Spot]]
) -> Sequence[Sequence[Spot]]:
    """Order every row by the middle of its neighbours, downwards and upwards in turn."""
    above: dict[Spot, list[Spot]] = {}
    below: dict[Spot, list[Spot]] = {}
    for upper, lower in sorted({pair for chain in chains.values() for pair in pairwise(chain)}):
        above.setdefault(lower, []).append(upper)
        below.setdefault(upper, []).append(lower)
    best = [list(row) for row in table]
    for sweep in range(SWEEPS):
        for row in table if sweep % 2 == 0 else reversed(table):
            _sort(row, above if sweep % 2 == 0 else below, table)
        if _crossings(table, below) < _crossings(best, below):
            best = [list(row) for row in table]
    return best


def _sort(row: list[Spot], near: Mapping[Spot, Sequence[Spot]], table: list[list[Spot]]) -> None:
    """Sort one row by the mean place of its neighbours; a spot without any stays where it is."""
    share = {spot: (place + 0.5) / len(line) for line in table for place, spot in enumerate(line)}

    def middle(spot: Spot) -> float:
        places = [share[other] for other in near.get(spot, [spot])]
        return sum(places) / len(places)

    row.sort(key=lambda spot: (round(middle(spot), 9), spot))


def _crossings(table: Sequence[Sequence[Spot]], below: Mapping[Spot, Sequence[Spot]]) -> int:
    """Count the pairs of arrows that cross."""
    place = {spot: k for row in table for k, spot in enumerate(row)}
    found = 0
    for row in table:
        ends = [(place[spot], place[end]) for spot in row for end in below.get(spot, ())]
        found += sum((a - c) * (b - d) < 0 for a, b in ends for c, d in ends) // 2
    return found


def _spread(row: Sequence[Spot], nodes: Mapping[str, int]) -> dict[Spot, float]:
    """Set the spots of a row side by side about 0; a passage takes less room than a node."""
    widths = [1.0 if spot[0] in nodes else PASSAGE for spot in row]
    left = -sum(widths) / 2
    places = {}
    for spot, width in zip(row, widths, strict=True):
        places[spot] = left + width / 2
        left += width
    return places
