r"""The edits of a misprint that no number shows to be wrong: one, or else two.

A formula of a line has hundreds of single edits and tens of thousands of pairs, and the exact test
takes milliseconds. So the part that an edit changes is evaluated in floating point, upwards from
its place: all edits of one place in a single array, and for pairs all combinations of two places.
Only what is right at every point is left to the proof.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, fields
from itertools import combinations, islice

import numpy as np
from numpy.typing import NDArray

from omniproof.repair.edits import edits
from omniproof.repair.kinds import Repair
from omniproof.repair.misprint import Misprint
from omniproof.repair.printed import Path, Printed
from omniproof.repair.values import ShapeError, Values, agree, evaluate
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError

MOST_EDITS = 2_000
MOST_READ = 1_500
"""Pairs of edits at one place, which have to be read anew."""
MOST_GROUPS = 120
MOST_FOR_PAIRS = 1_200
"""Beyond so many single edits, pairs would take seconds."""


@dataclass(frozen=True)
class Change:
    """An edit, and what it does to the tree: another node at a place, and its values there."""

    edit: Repair
    path: Path
    node: tree.Node
    values: Values


class Search:
    """The edits of one text, by the place of the tree that they change."""

    def __init__(self, misprint: Misprint) -> None:
        self.misprint, self.text = misprint, misprint.text
        self.printed = Printed(misprint)
        self.edits = edits_of(misprint, self.printed.root)

    def single(self) -> list[Repair]:
        """Return the edits that no point shows to be wrong."""
        near = [edit for edit in self.edits if self.may_reach(edit, np.all)][:MOST_EDITS]
        return [change.edit for group in self.changes(near) for change in self.right(group)]

    def double(self) -> Iterator[Repair]:
        """Yield the pairs of edits that no point shows to be wrong."""
        near = [edit for edit in self.edits if self.may_reach(edit, np.any)]
        if len(near) > MOST_FOR_PAIRS:
            return
        seen: set[tuple[Path, tree.Node]] = set()
        for pair in self.pairs(self.changes(near)[:MOST_GROUPS]):
            both = self.joined(*pair)
            if both is not None and (both.path, both.node) not in seen:
                seen.add((both.path, both.node))
                yield both.edit

    def may_reach(self, edit: Repair, enough: Callable[[NDArray[np.bool_]], np.bool_]) -> bool:
        """Whether a part that is edited reaches enough of the entries that are wrong."""
        reached = self.printed.reached(self.printed.around(edit.span))
        return bool(enough(reached[self.printed.wrong])) or not self.printed.wrong.any()

    def changes(self, edits: Iterable[Repair]) -> list[list[Change]]:
        """Return what edits change, by place and shape of their values; each once."""
        found: dict[tuple[Path, tuple[int, ...]], dict[tree.Node, Change]] = defaultdict(dict)
        for edit in edits:
            try:
                change = self.change(edit)
            except (ShapeError, LatexError):
                continue
            # Edits are stacked into one array later, so only values of one shape share a group.
            key = change.path, change.values.shape[-2:]
            found[key].setdefault(change.node, change)
        return [list(group.values()) for group in found.values()]

    def change(self, edit: Repair) -> Change:
        """Read an edit where it was made; raises `LatexError` and `ShapeError`."""
        part = self.printed.around(edit.span)
        new = self.printed.reread(part, edit.text)
        below, node = _difference(self.printed.known[part][0], new)
        return Change(edit, part + below, node, evaluate(node, self.printed.meaning))

    def right(self, group: Sequence[Change]) -> Iterator[Change]:
        """Yield the changes of one place that no point shows to be wrong."""
        try:
            stacked = np.stack([change.values for change in group])
            values = self.printed.lift(group[0].path, stacked)
        except ShapeError:
            return
        right = self.is_right(values, (len(group),))
        yield from (change for change, fits in zip(group, right, strict=True) if fits)

    def is_right(self, values: Values, shape: tuple[int, ...]) -> NDArray[np.bool_]:
        """Tell for each of several values whether it is the target at every point."""
        return np.broadcast_to(agree(values, self.printed.target), shape)

    def pairs(self, groups: Sequence[Sequence[Change]]) -> Iterator[tuple[Change, Change]]:
        """Yield candidates: at places apart those that agree, at one place the likeliest."""
        near: list[tuple[Change, Change]] = []
        for first in groups:
            near.extend(combinations(first, 2))
        for first, second in combinations(groups, 2):
            if not self.reach_together(first[0].path, second[0].path):
                continue
            if _are_apart(first[0].path, second[0].path):
                yield from self.right_pairs(first, second)
            else:
                near.extend((a, b) for a in first for b in second)
        near.sort(key=lambda pair: pair[0].edit.kind + pair[1].edit.kind)
        yield from islice(near, MOST_READ)

    def reach_together(self, one: Path, other: Path) -> bool:
        """Whether two parts together reach all that is wrong."""
        both = self.printed.reached(one) | self.printed.reached(other)
        return bool(both[self.printed.wrong].all())

    def right_pairs(
        self, first: Sequence[Change], second: Sequence[Change]
    ) -> Iterator[tuple[Change, Change]]:
        """Try all edits of one place with all of another."""
        one, other = first[0].path, second[0].path
        # Above the fork both edits are in one subtree: they go on together from there.
        fork = next(k for k, (a, b) in enumerate(zip(one, other, strict=False)) if a != b)
        left = np.stack([change.values for change in first])[:, None]
        right = np.stack([change.values for change in second])[None, :]
        try:
            left, right = (
                self.printed.lift(one, left, fork + 1),
                self.printed.lift(other, right, fork + 1),
            )
            values = self.printed.over(one[:fork], {one[fork]: left, other[fork]: right})
            values = self.printed.lift(one[:fork], values)
        except ShapeError:
            return
        for i, k in np.argwhere(self.is_right(values, (len(first), len(second)))):
            yield first[i], second[k]

    def joined(self, one: Change, other: Change) -> Change | None:
        """Make both edits, where they leave each other alone and may be right together."""
        first, second = sorted((one.edit, other.edit), key=lambda edit: edit.span)
        # One edit would be made on text that the other has replaced.
        if first.span[1] > second.span[0]:
            return None
        begin, end = first.span[0], second.span[1]
        between = self.text[first.span[1] : second.span[0]]
        new = first.replacement(self.text) + between + second.replacement(self.text)
        text = self.text[:begin] + new + self.text[end:]
        description = f"{first.description}; {second.description}"
        both = Repair(max(first.kind, second.kind), (begin, end), description, text)
        try:
            return next(self.right([self.change(both)]), None)
        except (ShapeError, LatexError):
            return None


def edits_of(misprint: Misprint, node: tree.Node | None = None) -> list[Repair]:
    """Return the single edits of a misprint, the likeliest first; raises `LatexError`."""
    return edits(misprint.text, misprint.words, misprint.relatives, node, misprint.known)


def _difference(old: tree.Node, new: tree.Node) -> tuple[Path, tree.Node]:
    """Find the smallest part in which two trees differ: its place, and the new part.

    A quantity with its arguments is one part: its values are not made from theirs.
    """
    path: Path = ()
    while _label(old) == _label(new) and not isinstance(old, tree.Applied):
        pairs = zip(tree.children(old), tree.children(new), strict=True)
        changed = [(k, one, other) for k, (one, other) in enumerate(pairs) if one != other]
        # Several children differ: the whole node is what has changed.
        if len(changed) != 1:
            break
        place, old, new = changed[0]
        path = (*path, place)
    return path, new


def _label(node: tree.Node) -> tuple[object, ...]:
    """What a node is without its children: its type, its own fields, how many children where."""
    own: list[object] = [type(node)]
    for item in fields(node):
        value = getattr(node, item.name)
        if isinstance(value, tuple) and item.name != "span":
            own.append(tuple(len(row) if isinstance(row, tuple) else 1 for row in value))
        elif not isinstance(value, tree.Node) and item.name != "span":
            own.append(value)
    return tuple(own)


def _are_apart(one: Path, other: Path) -> bool:
    """Whether neither of two places lies in the other."""
    shared = min(len(one), len(other))
    return one[:shared] != other[:shared]
