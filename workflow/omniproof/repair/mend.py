"""The one door to repairs: a claim of a paper and a formula that stands alone are mended here."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import islice, pairwise

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


def mend(misprint: Misprint) -> Mended | None:
    """Return the least edits that make a false text true, the likeliest first.

    One edit, or else two: an unrelated formula becomes true by two in one case of seven, so that
    such a repair is possible, and no explanation. `None` where none is found, or nothing is read.
    """
    try:
        search = Search(misprint)
        node = search.printed.root
    except ShapeError:
        # No floats for the printed text itself: every edit is put to the proof instead.
        found = _proved(edits_of(misprint)[:MOST_UNSEEN], misprint)
        return Mended(found, 1) if found else None
    except LatexError:
        return None
    for size, candidates in enumerate((search.single, search.double), start=1):
        ranked = sorted(candidates(), key=lambda edit: _rank(edit, node))
        if found := _proved(islice(ranked, MOST_PROOFS), misprint):
            return Mended(found, size)
    return None


def _rank(edit: Repair, node: tree.Node) -> tuple[object, ...]:
    """Order edits: what an equation is held against comes last, what it is about after the rest.

    A side without symbols, such as 1 or a unit matrix, says what the formula is for, and what
    stands before the first sign is what it is about.
    """
    sides = tree.children(node) if isinstance(node, tree.Chain | tree.Comparison) else ()
    own = next((side for side in sides if _holds(side, edit)), None)
    constant = own is not None and not tree.names(own) and edit.kind is not Edit.RELATION
    return constant, edit.kind, bool(sides) and edit.span[0] < sides[0].span[1], edit


def _holds(side: tree.Node, edit: Repair) -> bool:
    return side.span[0] <= edit.span[0] and edit.span[1] <= side.span[1]


def _proved(candidates: Iterable[Repair], misprint: Misprint) -> tuple[Repair, ...]:
    proved = (replace(edit, engines=misprint.proved(edit.text)) for edit in candidates)
    return tuple(_unlike([edit for edit in proved if edit.engines], misprint))


def _unlike(found: Sequence[Repair], misprint: Misprint) -> Iterator[Repair]:
    """Leave out what is an earlier repair in another spelling, or says nothing.

    Of the relations that may stand at a place, the first is the strongest.
    """
    alike: dict[object, list[Repair]] = {}
    for edit in found:
        node = misprint.judged(edit.text)
        if not _is_trivial(node):
            key = edit.span if edit.kind is Edit.RELATION else likeness(node)
            alike.setdefault(key, []).append(edit)
    for spellings in alike.values():
        yield next((edit for edit in spellings if misprint.familiar(edit.text)), spellings[0])


def _is_trivial(node: tree.Node) -> bool:
    """Whether an equation says of something that it is itself."""
    sides = node.sides if isinstance(node, tree.Chain) else ()
    return any(likeness(one) == likeness(other) for one, other in pairwise(sides))
