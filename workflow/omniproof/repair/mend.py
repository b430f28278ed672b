"""The one door to repairs: a claim of a paper and a formula that stands alone are mended here."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import islice, pairwise
from math import inf

from omniproof.repair.kinds import Edit, Repair
from omniproof.repair.likeness import likeness
from omniproof.repair.misprint import Mended, Misprint
from omniproof.repair.search import Search, edits_of
from omniproof.repair.values import ShapeError
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError

MOST_PROOFS = 24
MOST_UNSEEN = 300
"""Edits that go to the proof where floats tell nothing: a second or two."""
UPWARDS = {"<", "\\leq"}
NUMBERS = {Edit.DROP, Edit.CONSTANT, Edit.FACTOR}


def mend(misprint: Misprint) -> Mended | None:
    """Return the least edits that make a false text true, the likeliest first.

    One edit, or else two: an unrelated formula becomes true by two in one case of seven, so that
    such a repair is possible, and no explanation; of an inequality, two say nothing. `None` where
    none is found, or nothing is read.
    """
    try:
        search = Search(misprint)
    except ShapeError:
        # No floats for the printed text itself: every edit is put to the proof instead.
        found = _proved(edits_of(misprint)[:MOST_UNSEEN], misprint)
        return Mended(found, 1) if found else None
    except LatexError:
        return None
    node = search.printed.root
    sizes = [search.single] if _relations(node) else [search.single, search.double]
    for size, candidates in enumerate(sizes, start=1):
        ranked = sorted(candidates(), key=lambda edit: _rank(edit, node, misprint.text))
        if found := _proved(islice(ranked, MOST_PROOFS), misprint):
            return Mended(found, size)
    return None


def _rank(edit: Repair, node: tree.Node, printed: str) -> tuple[object, ...]:
    """Order edits: what an equation is held against comes last, what it is about after the rest.

    A side without symbols, such as 1 or a unit matrix, says what an equation is for, and what
    stands before the first sign is what it is about. Many numbers make an inequality true: the one
    nearest to what is printed says most.
    """
    relations = _relations(node)
    sides = tree.children(node) if isinstance(node, tree.Chain | tree.Comparison) else ()
    own = next((side for side in sides if _holds(side, edit)), None)
    constant = not relations and own is not None and not tree.names(own)
    kind, change = edit.kind, 0.0
    if relations and kind in NUMBERS:
        kind, change = Edit.CONSTANT, _change(printed[slice(*edit.span)], edit.replacement(printed))
    return constant, kind, bool(sides) and edit.span[0] < sides[0].span[1], change, edit


def _holds(side: tree.Node, edit: Repair) -> bool:
    return side.span[0] <= edit.span[0] and edit.span[1] <= side.span[1]


def _change(old: str, new: str) -> float:
    """By how much one number differs from another; what is no number comes last."""
    return abs(int(new) - int(old)) if old.isdecimal() and new.isdecimal() else inf


def _proved(candidates: Iterable[Repair], misprint: Misprint) -> tuple[Repair, ...]:
    printed = misprint.judged(misprint.text)
    sensible = (edit for edit in candidates if _says_something(edit, misprint, printed))
    proved = (replace(edit, engines=misprint.proved(edit.text)) for edit in sensible)
    return tuple(_unlike([edit for edit in proved if edit.engines], misprint))


def _says_something(edit: Repair, misprint: Misprint, printed: tree.Node) -> bool:
    """Whether an edit does not make a formula say `x = x`, nor `0 < x > 1`, as print does not."""
    try:
        node = misprint.judged(edit.text)
    except LatexError:
        return False
    empty, mixed = _is_trivial(node), len(_directions(node)) > 1
    return not ((empty and not _is_trivial(printed)) or (mixed and len(_directions(printed)) < 2))


def _unlike(found: Sequence[Repair], misprint: Misprint) -> Iterator[Repair]:
    """Leave out what is an earlier repair in another spelling.

    At one place of an inequality, the first says most: what is weaker follows from it.
    """
    alike: dict[object, list[Repair]] = {}
    for edit in found:
        node = misprint.judged(edit.text)
        key = edit.span[0] if _relations(node) else likeness(node)
        alike.setdefault(key, []).append(edit)
    for spellings in alike.values():
        yield next((edit for edit in spellings if misprint.familiar(edit.text)), spellings[0])


def _relations(node: tree.Node) -> list[tree.Comparison]:
    return [item for item in tree.walk(node) if isinstance(item, tree.Comparison)]


def _directions(node: tree.Node) -> set[bool]:
    """Return which ways the signs of inequalities point."""
    signs = {relation.operator for relation in _relations(node)} - {"\\neq"}
    return {sign in UPWARDS for sign in signs}


def _is_trivial(node: tree.Node) -> bool:
    """Whether a step of a statement says of something that it is itself."""
    steps = [pair for item in tree.walk(node) if isinstance(item, tree.Chain)
             for pair in pairwise(item.sides)]  # fmt: skip
    steps += [(relation.left, relation.right) for relation in _relations(node)]
    return any(likeness(one) == likeness(other) for one, other in steps)
