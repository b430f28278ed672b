"""Rows of one claim together: a matrix is printed as one thing, and judged entry by entry."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from omniproof.audit.ledger import Row
from omniproof.report.latexfmt import is_latex, is_settable
from omniproof.transcription.ids import base, index

_UNALIGNED = re.compile(r"&(?==)")


@dataclass(frozen=True)
class Group:
    """A claim with its rows: one for most, one per entry for a matrix."""

    base: str
    rows: tuple[Row, ...]

    @property
    def is_matrix(self) -> bool:
        """Whether the rows are entries of something printed as one."""
        return any(index(row.id) for row in self.rows)

    @property
    def whole(self) -> str:
        """The one formula that is printed for all entries; empty where each has its own."""
        first, *others = {row.printed for row in self.rows}
        one = not others and len(self.rows) > 1 and is_settable(first)
        return _UNALIGNED.sub("", first) if one and re.search(r"[\\=]", first) else ""


def groups(rows: Iterable[Row]) -> tuple[Group, ...]:
    """Gather entries under their claim, in the order of the ledger."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(base(row.id), []).append(row)
    return tuple(Group(name, tuple(members)) for name, members in found.items())


def matrix_of(group: Group, entry: Callable[[Row], str]) -> str:
    """Return the LaTeX of a matrix from that of its entries; nothing when one has no place."""
    grid = _grid(group.rows, entry)
    height, width = (max((place[k] for place in grid), default=0) for k in (0, 1))
    if not grid or len(grid) != height * width:
        return ""
    lines = (" & ".join(grid[i, j] for j in range(1, width + 1)) for i in range(1, height + 1))
    body = r" \\ ".join(lines)
    return rf"\begin{{pmatrix}} {body} \end{{pmatrix}}"


def _grid(rows: Iterable[Row], entry: Callable[[Row], str]) -> dict[tuple[int, int], str]:
    """Return the entries by row and column; empty where one has no place or cannot be set."""
    grid = {}
    for row in rows:
        place, latex = index(row.id), entry(row)
        numbered = place and all(part.isdigit() for part in place)
        if not (numbered and is_latex(latex) and is_settable(latex)):
            return {}
        grid[int(place[0]), int(place[-1]) if len(place) > 1 else 1] = latex
    return grid
