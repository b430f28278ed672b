"""What differs between two formulas, box by box, as deep as it goes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import SequenceMatcher
from typing import TypeAlias

from omniproof.formula.writers.boxes import Box, Row

SMALL = frozenset({"scripts", "name", "accent"})
"""What is marked as a whole: in its parts a mark would be too small to see."""
Pair: TypeAlias = tuple[Row, Row]


@dataclass(frozen=True)
class Difference:
    """Both rows with marks `old` and `new` around what differs, and what that is, in pairs."""

    one: Row
    other: Row
    pairs: tuple[Pair, ...]


def difference(one: Row, other: Row, whole: frozenset[str] = SMALL) -> Difference:
    """Compare two rows; boxes of the kinds in `whole` are marked as a whole."""
    found = _Comparison(whole)
    pairs = tuple(dict.fromkeys(found.pairs(one, other)))
    return Difference(found.marked(one, other, "old"), found.marked(other, one, "new"), pairs)


def in_common(one: Row, other: Row, whole: frozenset[str] = SMALL) -> bool:
    """Whether two rows share a box, or boxes in them do that are not marked as a whole."""
    return any(
        equal or any(in_common(*pair, whole) for pair in inside)
        for equal, _, _, inside in _Comparison(whole).runs(one, other)
    )


@dataclass(frozen=True)
class _Comparison:
    whole: frozenset[str]

    def runs(self, one: Row, other: Row) -> Iterator[tuple[bool, Row, Row, tuple[Pair, ...]]]:
        """Yield runs that are equal or not; where one can go into them, box by box, their parts."""
        matcher = SequenceMatcher(a=one, b=other, autojunk=False)
        for what, a, b, c, d in matcher.get_opcodes():
            left, right = one[a:b], other[c:d]
            alike = len(left) == len(right) and all(map(self._is_enterable, left, right))
            if what == "equal" or not alike:
                yield what == "equal", left, right, ()
                continue
            for x, y in zip(left, right, strict=True):
                yield False, (x,), (y,), tuple(zip(x.parts, y.parts, strict=True))

    def _is_enterable(self, one: Box, other: Box) -> bool:
        same = (one.kind, one.text, len(one.parts)) == (other.kind, other.text, len(other.parts))
        return same and one.kind not in self.whole and bool(one.parts)

    def pairs(self, one: Row, other: Row) -> Iterator[Pair]:
        """Yield what differs, the innermost."""
        for equal, left, right, inside in self.runs(one, other):
            if inside:
                for pair in inside:
                    yield from self.pairs(*pair)
            elif not equal:
                yield left, right

    def marked(self, one: Row, other: Row, mark: str) -> Row:
        """Put marks into the first row around what the second one lacks."""
        row: Row = ()
        for equal, left, _, inside in self.runs(one, other):
            if inside:
                parts = tuple(self.marked(*pair, mark) for pair in inside)
                row += (Box(left[0].kind, left[0].text, parts),)
            else:
                row += left if equal or not left else (Box("mark", mark, (left,)),)
        return row
