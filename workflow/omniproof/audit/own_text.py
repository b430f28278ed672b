"""The last line of defence: no row may say that a place should read what it reads.

Such a row is a defect of ours. What is printed and what is derived look the same and are not equal,
so that one of their symbols is not what it seems: another sign, another symbol of the same name.
"""

from __future__ import annotations

from typing import Any

from sympy import MatrixBase, Symbol

from omniproof.audit.context import Context
from omniproof.audit.known_symbols import symbols_in
from omniproof.audit.ledger import Row
from omniproof.formula.evaluation import Function
from omniproof.repair.likeness import likeness
from omniproof.transcription.ids import base
from omniproof.transcription.model import Kind
from omniproof.transcription.reader import read_with
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Node


class OwnTextError(Exception):
    """A claim that should read what it reads."""


def refuse_own_text(row: Row, context: Context) -> Row:
    """Return a row whose correction differs from what is printed; raises `OwnTextError`."""
    if row.verdict.is_fault and row.correction and _reads_alike(row, context):
        raise OwnTextError(
            f"{row.paper}, {row.id}: `{row.printed}` should read `{row.correction}`, which is what "
            f"it reads: {_cause(row, context)}"
        )
    return row


def _reads_alike(row: Row, context: Context) -> bool:
    if row.printed.split() == row.correction.split():
        return True
    if row.kind is not Kind.IDENTITY:
        return False
    try:
        printed, corrected = (_read(text, context) for text in (row.printed, row.correction))
    except LatexError:
        return False
    # The order of factors is a matter of taste for numbers only.
    claim = base(row.id)
    if any(isinstance(value, MatrixBase) for value in _values(printed, claim, context)):
        return printed == corrected
    return likeness(printed) == likeness(corrected)


def _read(text: str, context: Context) -> Node:
    return read_with(text, context.loaded.paper.notation, context.names)


def _values(node: Node, claim: str, context: Context) -> list[Any]:
    """What the symbols of a formula stand for."""
    values = context.meanings_at(claim, node).values()
    return [value.value if isinstance(value, Function) else value for value in values]


def _cause(row: Row, context: Context) -> str:
    claim = base(row.id)
    if row.kind is not Kind.IDENTITY or claim not in context.loaded.trees:
        return "its correction is written by hand"
    found = same_by_name(claim, context)
    return found or "what is printed there means something else than what is derived"


def same_by_name(claim: str, context: Context) -> str:
    """Say which symbols print and derivation of a claim share by name only; empty for none."""
    if claim not in context.loaded.trees:
        return ""
    tree = context.loaded.trees[claim]
    printed, theirs = symbols_in(_values(tree, claim, context)), symbols_in(context.derive(claim))
    shared = _names(printed - theirs) & _names(theirs - printed)
    return f"its derivation has another symbol named {', '.join(sorted(shared))}" if shared else ""


def _names(symbols: set[Symbol]) -> set[str]:
    return {symbol.name for symbol in symbols}
