"""What differs between two formulas, box by box, as deep as it goes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import SequenceMatcher

from omniproof.formula.writers.boxes import Box, Row

WHOLE = frozenset({"scripts", "fraction", "name", "accent"})
"""What is marked as a whole: a mark would grow, or be too small to see, in its parts."""


@dataclass(frozen=True)
class Difference:
    """Both rows with marks `old` and `new` around what differs, and what that is, in pairs."""

    one: Row
    other: Row
    pairs: tuple[tuple[Row, Row], ...]


def difference(one: Row, other: Row) -> Difference:
    """Compare two rows."""
    pairs = tuple(dict.fromkeys(_pairs(one, other)))
    return Difference(_marked(one, other, "old"), _marked(other, one, "new"), pairs)


def in_common(one: Row, other: Row) -> bool:
    """Whether two rows share a box, or boxes in them do that are compared inside."""
    for equal, left, right in _runs(one, other):
        inside = _inside(left, right) if not equal and _alike(left, right) else ()
        if equal or any(in_common(*pair) for pair in inside):
            return True
    return False


def _inside(one: Row, other: Row) -> Iterator[tuple[Row, Row]]:
    """The parts of two boxes, in pairs."""
    return zip(one[0].parts, other[0].parts, strict=True)


def _runs(one: Row, other: Row) -> Iterator[tuple[bool, Row, Row]]:
    """Yield runs that are equal, or not; boxes in the same place that can be entered one by one."""
    matcher = SequenceMatcher(a=one, b=other, autojunk=False)
    for what, a, b, c, d in matcher.get_opcodes():
        left, right = one[a:b], other[c:d]
        if what != "equal" and _alike(left, right):
            yield from ((False, (x,), (y,)) for x, y in zip(left, right, strict=True))
        else:
            yield what == "equal", left, right


def _alike(one: Row, other: Row) -> bool:
    return len(one) == len(other) and all(map(_enterable, one, other))


def _enterable(one: Box, other: Box) -> bool:
    same = (one.kind, one.text, len(one.parts)) == (other.kind, other.text, len(other.parts))
    return same and one.kind not in WHOLE and bool(one.parts)


def _pairs(one: Row, other: Row) -> Iterator[tuple[Row, Row]]:
    for equal, left, right in _runs(one, other):
        if not equal and _alike(left, right):
            for pair in _inside(left, right):
                yield from _pairs(*pair)
        elif not equal:
            yield left, right


def _marked(one: Row, other: Row, mark: str) -> Row:
    row: Row = ()
    for equal, left, right in _runs(one, other):
        if equal or not left:
            row += left
        elif _alike(left, right):
            parts = tuple(_marked(*pair, mark) for pair in _inside(left, right))
            row += (Box(left[0].kind, left[0].text, parts),)
        else:
            row += (Box("mark", mark, (left,)),)
    return row
