"""Identities: printed against derived, entry by entry, and the edit that mends a misprint."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from sympy import MatrixBase, Mul

from omniproof.audit.answer import Answer, OnBranch, Proved
from omniproof.audit.context import Context, entries
from omniproof.audit.ledger import Repair, Row, Verdict
from omniproof.audit.relations import merge
from omniproof.audit.repair import repair
from omniproof.audit.rows import answer_fields, start
from omniproof.audit.zero_test import decide_equal
from omniproof.transcription.entries import entry_source
from omniproof.transcription.expression import evaluate
from omniproof.transcription.model import Claim, Role
from omniproof.transcription.reader import read
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Node


@dataclass(frozen=True)
class Cell:
    """One printed cell: its sides as values, its verbatim text, and what it should be."""

    id: str
    text: str
    values: tuple[Any, ...]
    nodes: tuple[Node, ...]
    derived: Any
    factor: Any = 1


def judge_identity(claim: Claim, context: Context) -> list[Row]:
    """Judge a printed formula; a matrix gives a row for each entry."""
    return [_judge_cell(cell, claim, context) for cell in _cells(claim, context)]


def count_faults(claim: Claim, context: Context) -> int:
    """Count the cells of a claim that are not plainly true, without looking for a repair."""
    return sum(not isinstance(_compare(cell), Proved) for cell in _cells(claim, context))


def _cells(claim: Claim, context: Context) -> Iterator[Cell]:
    derived = context.derive(claim.id)
    nodes = context.sides(claim.id)
    values = tuple(context.evaluate(claim.id, node) for node in nodes)
    text = context.printed(claim.id)
    if not isinstance(derived, MatrixBase):
        yield Cell(claim.id, text, values, nodes, derived)
        return
    for index, entry in entries(derived).items():
        sides = tuple(entries(value)[index] for value in values)
        verbatim = entry_source(text, context.loaded.trees[claim.id], index)
        name = f"{claim.id}[{','.join(map(str, index))}]"
        yield Cell(name, verbatim or text, sides, nodes if verbatim is None else (), entry)


def _judge_cell(cell: Cell, claim: Claim, context: Context) -> Row:
    answer = _compare(cell)
    row = start(claim, context, cell.id).model_copy(
        update={"printed": cell.text, "derived": context.latex(cell.derived)}
        | answer_fields(answer, context)
    )
    if row.verdict is not Verdict.ERRATUM:
        return row
    mended = _mend(cell, claim.id, context)
    if mended:
        return row.model_copy(update={"correction": mended, "repair": Repair.EXPLAINED})
    return row.model_copy(update={"correction": row.derived, "repair": Repair.MANUAL})


def _compare(cell: Cell) -> Answer:
    engines: tuple[str, ...] = ()
    branch: OnBranch | None = None
    for value in cell.values:
        answer = decide_equal(value, cell.derived)
        if isinstance(answer, Proved):
            engines = merge(engines, answer.engines)
        elif isinstance(answer, OnBranch):
            branch = answer
        else:
            return answer
    return branch or Proved(engines)


def _mend(cell: Cell, claim: str, context: Context) -> str:
    """Return the printed text after the one edit that makes it true, if there is one."""
    meanings = context.meanings_at(claim)
    symbols = [symbol.latex for symbol in context.loaded.paper.symbols]
    notation = context.loaded.paper.notation

    def value_of(text: str) -> Any:
        return evaluate(read(text, notation, symbols), meanings, text)

    try:
        factor = _factor(cell, value_of(cell.text))
    except (LatexError, TypeError):
        return ""

    def is_true(text: str) -> bool:
        try:
            return isinstance(decide_equal(value_of(text) * factor, cell.derived), Proved)
        except (LatexError, TypeError, AttributeError):
            return False

    vocabulary = [s.latex for s in context.loaded.paper.symbols if s.role is Role.VARIABLE]
    found = repair(cell.text, is_true, vocabulary)
    return found[0].text if found else ""


def _factor(cell: Cell, value: Any) -> Any:
    """Factor that stands before a printed matrix, outside the text of its entry."""
    if value == 0 or isinstance(value, tuple):
        return 1
    return Mul(cell.values[-1], 1 / value)
