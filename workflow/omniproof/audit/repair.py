r"""The edits that make a misprint true: one, or else two, each result proved.

A formula of a line has hundreds of single edits and tens of thousands of pairs, and the exact test
takes milliseconds. So each edited text is read once, and the difference of its tree from the
printed one is evaluated in floating point, upwards from the place of the edit: all edits of one
place in a single array, and for pairs all combinations of two places. Only what agrees with the
derived values at every point is left to the caller, who says what is true.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from itertools import combinations, islice

import numpy as np
from numpy.typing import NDArray

from omniproof.audit.approximate import ShapeError, Values, agree, combine, evaluate
from omniproof.audit.edits import Edit, Repair, edits
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError

__all__ = ["Edit", "QuickLook", "Repair", "repair", "repair_twice"]

MOST_EDITS = 2_000
MOST_PROOFS = 24
MOST_READ = 1_500
"""Pairs of edits at one place, which have to be read anew."""
MOST_GROUPS = 120
MOST_FOR_PAIRS = 1_200
"""Beyond so many single edits, pairs would take seconds."""

Path = tuple[int, ...]
"""The way down a tree: which child, which child of that, and so on."""


@dataclass(frozen=True)
class QuickLook:
    """What it takes to see a wrong repair without proof.

    `read` gives the tree of a text (raises `LatexError`), `meaning` the values of a symbol with its
    arguments (raises `KeyError`), `target` those of the truth. `relatives` are symbols that only
    replace symbols like them.
    """

    read: Callable[[str], tree.Node]
    meaning: Callable[[tree.Symbolic], Values]
    target: Values
    relatives: tuple[str, ...] = ()
    known: tuple[str, ...] = ()


def repair(
    printed: str,
    is_true: Callable[[str], bool],
    vocabulary: Sequence[str],
    quick: QuickLook | None = None,
) -> tuple[Repair, ...]:
    """Return all single edits of a false formula that make it true, the likeliest first.

    `vocabulary` holds the LaTeX of symbols that may replace one another. Empty when no edit helps,
    or when the text cannot be cut into tokens. Without a quick look every edit is put to `is_true`.
    """
    try:
        if quick is None:
            found = edits(printed, vocabulary)
        else:
            found = list(_Search(printed, vocabulary, quick).single())
    except ShapeError:
        # No floats for the printed text itself: every edit is put to the proof instead.
        found = edits(printed, vocabulary)
    except LatexError:
        return ()
    most = MOST_EDITS if quick is None else MOST_PROOFS
    return tuple(edit for edit in found[:most] if is_true(edit.text))


def repair_twice(
    printed: str, is_true: Callable[[str], bool], vocabulary: Sequence[str], quick: QuickLook
) -> tuple[Repair, ...]:
    """Return pairs of edits that make a false formula true, the likeliest first.

    An unrelated formula becomes true so in one case of seven: such a repair is possible, and no
    explanation. Empty when none is found within the limits.
    """
    try:
        found = sorted(_Search(printed, vocabulary, quick).double())
    except (ShapeError, LatexError):
        return ()
    return tuple(edit for edit in found[:MOST_PROOFS] if is_true(edit.text))


@dataclass(frozen=True)
class _Change:
    """An edit, and what it does to the tree: another node at a place, and its values there."""

    edit: Repair
    path: Path
    node: tree.Node
    values: Values


class _Search:
    """The edits of one text, by the place of the tree that they change."""

    def __init__(self, printed: str, vocabulary: Sequence[str], quick: QuickLook) -> None:
        self.printed, self.quick = printed, quick
        self.root = quick.read(printed)
        found = edits(printed, vocabulary, quick.relatives, self.root, quick.known)
        self.edits = found[:MOST_EDITS]
        self.known: dict[Path, tuple[tree.Node, Values]] = {}
        self.learn((), self.root)

    def learn(self, path: Path, node: tree.Node) -> Values:
        """Evaluate the printed tree, and keep the values of every part."""
        if isinstance(node, tree.Name | tree.Applied):
            values = self.meaning(node)
        else:
            parts = enumerate(tree.children(node))
            values = combine(node, [self.learn((*path, k), part) for k, part in parts])
        self.known[path] = node, values
        return values

    def meaning(self, node: tree.Symbolic) -> Values:
        try:
            return self.quick.meaning(node)
        except KeyError:
            raise ShapeError(f"no values of {node.name}") from None

    @cached_property
    def places(self) -> list[list[_Change]]:
        """The changes that can be evaluated, by place and shape of their values; each once."""
        found: dict[tuple[Path, tuple[int, ...]], dict[tree.Node, _Change]] = defaultdict(dict)
        for edit in self.edits:
            try:
                path, node = _difference(self.root, self.quick.read(edit.text))
                values = evaluate(node, self.meaning)
            except (ShapeError, LatexError):
                continue
            change = _Change(edit, path, node, values)
            # Edits are stacked into one array later, so only values of one shape share a group.
            found[path, values.shape[-2:]].setdefault(node, change)
        return [list(group.values()) for group in found.values()]

    def single(self) -> Iterator[Repair]:
        """Yield the edits that no point shows to be wrong, the likeliest first."""
        return iter(sorted(change.edit for group in self.places for change in self.right(group)))

    def right(self, group: Sequence[_Change]) -> Iterator[_Change]:
        try:
            values = self.lift(group[0].path, np.stack([change.values for change in group]))
        except ShapeError:
            return
        right = self.is_right(values, (len(group),))
        yield from (change for change, fits in zip(group, right, strict=True) if fits)

    def is_right(self, values: Values, shape: tuple[int, ...]) -> NDArray[np.bool_]:
        return np.broadcast_to(agree(values, self.quick.target), shape)

    def lift(self, path: Path, values: Values, top: int = 0) -> Values:
        """Carry values at a place up the printed tree, to the ancestor at depth `top`."""
        for depth in reversed(range(top, len(path))):
            values = self.over(path[:depth], {path[depth]: values})
        return values

    def over(self, parent: Path, replaced: dict[int, Values]) -> Values:
        """Evaluate a printed node with other values for some of its children."""
        node = self.known[parent][0]
        places = range(len(tree.children(node)))
        return combine(node, [self.part((*parent, k), replaced.get(k)) for k in places])

    def part(self, path: Path, instead: Values | None) -> Values:
        return self.known[path][1] if instead is None else instead

    def double(self) -> Iterator[Repair]:
        """Yield the pairs of edits that no point shows to be wrong."""
        seen: set[tree.Node] = set()
        for pair in self.pairs():
            both = self.joined(*pair)
            if both is not None and both[0] not in seen:
                seen.add(both[0])
                yield both[1]

    def pairs(self) -> Iterator[tuple[_Change, _Change]]:
        """Yield candidates: at places apart those that agree, at one place the likeliest."""
        if len(self.edits) > MOST_FOR_PAIRS:
            return
        groups = self.places[:MOST_GROUPS]
        near: list[tuple[_Change, _Change]] = []
        for first in groups:
            near.extend(combinations(first, 2))
        for first, second in combinations(groups, 2):
            if _are_apart(first[0].path, second[0].path):
                yield from self.right_pairs(first, second)
            else:
                near.extend((a, b) for a in first for b in second)
        near.sort(key=lambda pair: pair[0].edit.kind + pair[1].edit.kind)
        yield from islice(near, MOST_READ)

    def right_pairs(
        self, first: Sequence[_Change], second: Sequence[_Change]
    ) -> Iterator[tuple[_Change, _Change]]:
        """Try all edits of one place with all of another."""
        one, other = first[0].path, second[0].path
        # Above the fork both edits are in one subtree: they go on together from there.
        fork = next(k for k, (a, b) in enumerate(zip(one, other, strict=False)) if a != b)
        left = np.stack([change.values for change in first])[:, None]
        right = np.stack([change.values for change in second])[None, :]
        try:
            left, right = self.lift(one, left, fork + 1), self.lift(other, right, fork + 1)
            values = self.over(one[:fork], {one[fork]: left, other[fork]: right})
            values = self.lift(one[:fork], values)
        except ShapeError:
            return
        for i, k in np.argwhere(self.is_right(values, (len(first), len(second)))):
            yield first[i], second[k]

    def joined(self, one: _Change, other: _Change) -> tuple[tree.Node, Repair] | None:
        """Make both edits, where they leave each other alone and may be right together."""
        first, second = sorted((one.edit, other.edit), key=lambda edit: edit.span)
        # One edit would be made on text that the other has replaced.
        if first.span[1] > second.span[0]:
            return None
        begin, end = first.span[0], second.span[1]
        between = self.printed[first.span[1] : second.span[0]]
        new = first.replacement(self.printed) + between + second.replacement(self.printed)
        text = self.printed[:begin] + new + self.printed[end:]
        try:
            node = self.quick.read(text)
            right = agree(evaluate(node, self.meaning), self.quick.target)
        except (ShapeError, LatexError):
            return None
        if not right.all():
            return None
        kind = max(first.kind, second.kind)
        description = f"{first.description}; {second.description}"
        return node, Repair(kind, (begin, end), description, text)


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
