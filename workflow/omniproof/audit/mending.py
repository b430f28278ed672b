"""The repair of a printed cell, with the symbols and the derivation of its claim."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, lru_cache
from typing import Any

from sympy import MatrixBase

from omniproof.audit.context import Context, entries
from omniproof.audit.evidence import Rival
from omniproof.audit.ledger import Repair as Grade
from omniproof.audit.ledger import Row
from omniproof.audit.relations import merge
from omniproof.audit.voice import Box, Voice
from omniproof.decide.answer import Proved
from omniproof.decide.in_sympy.equality import equal_to_derived
from omniproof.decide.order.hypotheses import with_box
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.evaluation import evaluate
from omniproof.repair.in_sympy import at_points
from omniproof.repair.mend import mend
from omniproof.repair.misprint import Mended, Misprint
from omniproof.repair.values import UNTOLD, Values
from omniproof.transcription.model import Claim, Form, Role
from omniproof.transcription.reader import read_with
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Node, Symbolic, names

at_points_once = lru_cache(maxsize=1_000)(at_points)


def mend_claim(text: str, derived: Any, voice: Voice, factor: Any = 1) -> Mended | None:
    """Return the least edit of a false text that makes it, times a factor, what is derived.

    `derived` is an expression or a matrix, `voice` is asked about each repair of its claim; `None`
    where no edit, and no two, are found.
    """
    claim, context = voice.claim, voice.context
    target = derived / factor
    try:
        values = at_points(target)
    except UnsupportedError:
        return None
    read, meaning = _reading(claim, context)
    # A symbol that the truth does not contain is never put in: a third of the edits, or fewer.
    needed = {symbol.name for symbol in target.free_symbols}
    symbols = context.loaded.paper.symbols
    variables = (s for s in symbols if s.role is Role.VARIABLE and s.name in needed)
    printed = [latex for each in context.claims.values() for latex in each.latex]
    misprint = Misprint(
        text,
        judged=read,
        read=read,
        proved=lambda edited: _proved(read(edited), derived, voice, factor),
        meaning=meaning,
        target=values,
        words=tuple(symbol.latex for symbol in variables),
        relatives=tuple(s.latex for s in symbols if s.role is Role.QUANTITY),
        known=tuple(symbol.latex for symbol in symbols),
        familiar=lambda edited: any(edited in latex for latex in printed),
    )
    return mend(misprint)


def mend_relation(
    claim: Claim, proved: Callable[[Node], tuple[str, ...]], box: Box, context: Context
) -> Mended | None:
    """Return the least edit of a printed relation that makes it true, on the box of its subject.

    `proved` names the engines that prove another printed tree. A chain ought to hold at all points;
    what a condition or a set of angles ought to be is told by no number.
    """
    assert claim.asserts is not None
    text, is_chain = context.printed(claim.id), claim.asserts.form is Form.CHAIN
    read, _ = _reading(claim.id, context)
    domain = with_box(context.domain(claim.id), box)

    def meaning(node: Symbolic) -> Values:
        try:
            return at_points(evaluate(node, context.meanings_at(claim.id, node)), domain)
        except (UnsupportedError, AttributeError, LatexError):
            raise KeyError(node.name) from None

    def proved_text(edited: str) -> tuple[str, ...]:
        try:
            return proved(read(edited))
        except (LatexError, TypeError, UnsupportedError):
            return ()

    own = names(context.loaded.trees[claim.id])
    words = tuple(s.latex for s in context.loaded.paper.symbols if symbol_name(s.latex) in own)
    target = None if is_chain else UNTOLD
    return mend(Misprint(text, read, read, proved_text, meaning, target, words))


def repaired(row: Row, mended: Mended) -> Row:
    """Add the correction to a row, and its rivals: other edits that are as small."""
    first, *others = (edit.text for edit in mended.repairs)
    grade = Grade.EXPLAINED if mended.size == 1 else Grade.POSSIBLE
    rivals = tuple(Rival(correction=text) for text in others)
    return row.model_copy(update={"correction": first, "repair": grade, "rivals": rivals})


def _proved(node: Node, derived: Any, voice: Voice, factor: Any) -> tuple[str, ...]:
    """Name the engines that prove an edited text, times a factor, to be what is derived."""
    claim, context = voice.claim, voice.context
    try:
        value = context.unfolded(claim, node)
        if getattr(value, "shape", ()) != getattr(derived, "shape", ()):
            return ()
        engines: tuple[str, ...] = ()
        domain = context.domain_in_terms(claim, derived)
        wanted = entries(derived) if isinstance(derived, MatrixBase) else {(): derived}
        for index, right in wanted.items():
            own = value.at(*index) if index else value
            answer = equal_to_derived(own, right, domain, factor)
            answer = voice.equal(answer, node, index, right / factor)
            if not isinstance(answer, Proved):
                return ()
            engines = merge(engines, answer.engines)
    except LatexError:  # shapes that do not fit
        return ()
    return engines


@lru_cache(maxsize=1)
def _reading(
    claim: str, context: Context
) -> tuple[Callable[[str], Node], Callable[[Symbolic], Values]]:
    """Return what reads an edited text of a claim, and what evaluates a symbol in it.

    Both remember: in every wrong entry of a matrix, the same edits with the same symbols come up.
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
