"""Graphs in layers: what is implied is left out, arrows lead downwards, nothing overlaps."""

from __future__ import annotations

from itertools import pairwise, product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omniproof.report.layers import PASSAGE, Arrow, laid_out, reduced

NODES = "abcdefgh"
ARROWS = st.sets(st.sampled_from([(a, b) for a, b in product(NODES, NODES) if a < b]))


def reachable(arrows: frozenset[Arrow] | set[Arrow]) -> set[Arrow]:
    """Return all pairs that a chain joins (Warshall)."""
    found = set(arrows)
    for middle in NODES:
        found |= {(a, d) for a, b in found for c, d in found if b == c == middle}
    return found


@given(ARROWS)
def test_reduction_keeps_what_is_reached_and_nothing_to_spare(arrows: set[Arrow]) -> None:
    kept = reduced(arrows)
    assert kept <= arrows
    assert reachable(kept) == reachable(arrows)
    assert all(reachable(kept - {one}) < reachable(kept) for one in kept)


@given(ARROWS, st.integers(1, 4))
def test_arrows_lead_down_through_free_places(arrows: set[Arrow], widest: int) -> None:
    layout = laid_out(NODES, arrows, widest)
    assert set(layout.places) == set(NODES)
    assert set(layout.paths) == reduced(arrows)
    for (start, end), path in layout.paths.items():
        assert (path[0], path[-1]) == (layout.places[start], layout.places[end])
        assert [row for _, row in path] == list(range(path[0][1], path[-1][1] + 1))
        assert len(path) > 1
    inner = {spot for path in layout.paths.values() for spot in path[1:-1]}
    through = {(start, spot) for (start, _), path in layout.paths.items() for spot in path[1:-1]}
    assert len(through) == len(inner)  # only arrows with one beginning share a passage
    for row in {row for _, row in layout.places.values()}:
        nodes = sorted(x for x, at in layout.places.values() if at == row)
        assert 0 < len(nodes) <= widest
        assert all(b - a > 1 - 1e-9 for a, b in pairwise(nodes))
        room = (1 + PASSAGE) / 2 - 1e-9
        assert all(abs(x - node) > room for x, at in inner if at == row for node in nodes)


@pytest.mark.parametrize("arrows", [{("a", "a")}, {("a", "b"), ("b", "c"), ("c", "a")}])
def test_a_cycle_is_refused(arrows: set[Arrow]) -> None:
    with pytest.raises(ValueError, match="expected a graph without cycles"):
        laid_out("abc", arrows, 3)


def test_rows_are_ordered_so_that_arrows_do_not_cross() -> None:
    """a over x and b over y by name would cross; one turn undoes it."""
    layout = laid_out("abxy", {("a", "y"), ("b", "x")}, 2)
    assert (layout.places["a"][0] < layout.places["b"][0]) == (
        layout.places["y"][0] < layout.places["x"][0]
    )
