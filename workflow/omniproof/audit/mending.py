"""The repair of a printed cell, with the symbols and the derivation of its claim."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any

from sympy import MatrixBase

from omniproof.audit.approximate import Values, at_points
from omniproof.audit.context import Context
from omniproof.audit.ledger import Repair as Grade
from omniproof.audit.likeness import likeness
from omniproof.audit.repair import QuickLook, Repair, repair, repair_twice
from omniproof.audit.sympy_domain import REALS, Domain
from omniproof.audit.sympy_equality import confirmed_equal
from omniproof.decide.answer import Proved
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.evaluation import evaluate
from omniproof.transcription.model import Role
from omniproof.transcription.reader import read_with
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Node, Symbolic

at_points_once = lru_cache(maxsize=1_000)(at_points)


@dataclass(frozen=True)
class Mended:
    """A text that is true after one edit (explained) or two (possible), and what else would be.

    `others` have as few edits, and are not the same formula in another spelling.
    """

    text: str
    grade: Grade
    others: tuple[str, ...] = ()

    def inside(self, before: str, after: str) -> Mended:
        """Put the texts into the line that they stand in."""
        whole = (before + text + after for text in (self.text, *self.others))
        first, *others = whole
        return Mended(first, self.grade, tuple(others))


def mend(text: str, derived: Any, claim: str, context: Context, factor: Any = 1) -> Mended | None:
    """Return the least edit of a false text that makes it, times a factor, what is derived.

    `derived` is an expression or a matrix; `None` where no edit, and no two, are found.
    """
    domain = context.domain(claim)

    def is_true(edited: str) -> bool:
        try:
            return equal(context.value(edited, claim) * factor, derived, domain)
        except (LatexError, TypeError, AttributeError):
            return False

    # A symbol that the truth does not contain is never put in: a third of the edits, or fewer.
    needed = {symbol.name for symbol in (derived / factor).free_symbols}
    symbols = [s for s in context.loaded.paper.symbols if s.name in needed]
    words = [symbol.latex for symbol in symbols if symbol.role is Role.VARIABLE]
    quick = _quick_look(derived / factor, claim, context)
    found = repair(text, is_true, words, quick)
    if found:
        return _mended(found, Grade.EXPLAINED, context)
    found = repair_twice(text, is_true, words, quick) if quick else ()
    return _mended(found, Grade.POSSIBLE, context) if found else None


def equal(printed: Any, derived: Any, domain: Domain = REALS) -> bool:
    """Whether two expressions, or two matrices entry by entry, are proved equal."""
    if not isinstance(derived, MatrixBase):
        return isinstance(confirmed_equal(printed, derived, domain), Proved)
    if getattr(printed, "shape", None) != derived.shape:
        return False
    return all(equal(*pair, domain) for pair in zip(printed, derived, strict=True))


def _quick_look(target: Any, claim: str, context: Context) -> QuickLook | None:
    """Prepare the quick look; there is none at what balls cannot evaluate."""
    try:
        values = at_points(target)
    except UnsupportedError:
        return None
    symbols = context.loaded.paper.symbols
    relatives = (symbol.latex for symbol in symbols if symbol.role is Role.QUANTITY)
    known = (symbol.latex for symbol in symbols)
    return QuickLook(*_reading(claim, context), values, tuple(relatives), tuple(known))


@lru_cache(maxsize=1)
def _reading(
    claim: str, context: Context
) -> tuple[Callable[[str], Node], Callable[[Symbolic], Values]]:
    """Return what reads an edited text of a claim, and what evaluates a symbol in it.

    Both remember: one edit is looked for before two are, in every wrong entry of a matrix, and the
    same edits with the same symbols come up each time.
    """

    @cache
    def read(text: str) -> Node:
        return read_with(text, context.loaded.paper.notation, context.names)

    @cache
    def meaning(node: Symbolic) -> Values:
        try:
            return at_points_once(evaluate(node, context.meanings_at(claim, node)))
        except (UnsupportedError, AttributeError, LatexError):
            raise KeyError(node.name) from None

    return read, meaning


def _mended(found: Iterable[Repair], grade: Grade, context: Context) -> Mended:
    first, *others = _unlike(found, context)
    return Mended(first.text, grade, tuple(other.text for other in others))


def _unlike(found: Iterable[Repair], context: Context) -> Iterator[Repair]:
    """Leave out what is an earlier repair in another spelling, unless the paper has that one."""
    alike: dict[object, list[Repair]] = {}
    for edit in found:
        node = read_with(edit.text, context.loaded.paper.notation, context.names)
        alike.setdefault(likeness(node), []).append(edit)
    printed = [text for claim in context.claims.values() for text in claim.latex]
    for spellings in alike.values():
        familiar = (edit for edit in spellings if any(edit.text in text for text in printed))
        yield next(familiar, spellings[0])
