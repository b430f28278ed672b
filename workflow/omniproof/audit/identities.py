"""Identities: printed against derived, entry by entry, and the edit that mends a misprint."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from sympy import MatrixBase

from omniproof.audit.context import Context, entries, flat
from omniproof.audit.ledger import Repair, Row, Verdict
from omniproof.audit.mending import mend_claim, repaired
from omniproof.audit.own_text import same_by_name
from omniproof.audit.relations import merge
from omniproof.audit.rows import answered, start, with_note
from omniproof.audit.voice import Voice
from omniproof.decide.answer import Answer, DisagreementError, Proved, Refuted
from omniproof.decide.domain import REALS, Domain
from omniproof.decide.in_sympy.equality import equal_to_derived
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Term, multiply
from omniproof.formula.value import Value
from omniproof.registry import Modelled
from omniproof.repair.misprint import Mended
from omniproof.transcription.entries import entry_source
from omniproof.transcription.model import Claim
from omniproof.transcription.parses import Parse, parses
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Node, Span


@dataclass(frozen=True)
class Cell:
    """One printed cell: its verbatim text, its sides, and what they should be.

    `places` says which part of the text each side is; for the entry of a matrix that is the text.
    `factor` stands before a printed matrix: it belongs to the sides, and not to the text.
    `nodes` are the printed sides, and `index` says which entry of them this is.
    `premises` is what the paper's own premises give, where mechanics contradicts one: the `gap`.
    """

    id: str
    text: str
    places: tuple[Span, ...]
    sides: tuple[Value, ...]
    derived: Any
    nodes: tuple[Node, ...]
    index: tuple[int, ...] = ()
    factor: Any = 1
    domain: Domain = REALS
    premises: Any = None
    gap: str = ""


def judge_identity(claim: Claim, context: Context) -> list[Row]:
    """Judge a printed formula; a matrix gives a row for each entry."""
    voice = Voice(claim.id, context)
    return [_judge_cell(cell, claim, context, voice) for cell in _cells(claim, context)]


def count_faults(claim: Claim, context: Context) -> int:
    """Count the cells of a claim that are not plainly true, without looking for a repair."""
    cells = _cells(claim, context)
    return sum(not isinstance(_in_favour(cell, claim, context)[0], Proved) for cell in cells)


def _cells(claim: Claim, context: Context) -> Iterator[Cell]:
    if same_by_name(claim.id, context):
        raise DisagreementError("two symbols have one name")
    derived = context.derive(claim.id)
    domain = context.domain_in_terms(claim.id, context.derive_by_mechanics(claim.id))
    if not isinstance(derived, Modelled):
        cells = _printed_cells(claim, context, derived)
        return (replace(cell, domain=domain) for cell in cells)
    return (
        replace(cell, domain=domain, premises=granted, gap=derived.gap)
        for cell, granted in zip(
            _printed_cells(claim, context, derived.mechanics),
            flat(derived.premises),
            strict=True,
        )
    )


def _printed_cells(claim: Claim, context: Context, derived: Any) -> Iterator[Cell]:
    nodes = context.sides(claim.id)
    values = tuple(context.unfolded(claim.id, node) for node in nodes)
    text = context.printed(claim.id)
    if not isinstance(derived, MatrixBase):
        spans = tuple(node.span for node in nodes)
        yield Cell(claim.id, text, spans, values, derived, nodes)
        return
    for index, entry in entries(derived).items():
        sides = tuple(grid.at(*index) for grid in values)
        name = f"{claim.id}[{','.join(map(str, index))}]"
        verbatim = entry_source(text, context.loaded.trees[claim.id], index)
        if verbatim is None:
            spans = tuple(node.span for node in nodes)
            yield Cell(name, text, spans, sides, entry, nodes, index)
            continue
        factor = context.factor(sides[-1], verbatim, claim.id)
        spans = ((0, len(verbatim)),) * len(sides)
        yield Cell(name, verbatim, spans, sides, entry, nodes, index, factor)


def _judge_cell(cell: Cell, claim: Claim, context: Context, voice: Voice) -> Row:
    answer, place, way = _in_favour(cell, claim, context)
    answer = _heard(answer, place, way, cell, voice)
    shown = {"printed": cell.text, "derived": context.spelling.latex(cell.derived / cell.factor)}
    row = answered(start(claim, context, cell.id).model_copy(update=shown), answer, context)
    row = with_note(row, _told(way))
    if row.verdict is not Verdict.ERRATUM:
        return row
    if _follows_from_premises(cell):
        fields = {"verdict": Verdict.MODEL_GAP, "repair": Repair.MANUAL}
        row = row.model_copy(update={"correction": row.derived, "assumption": cell.gap, **fields})
        return with_note(row, "It follows from a premise that mechanics contradicts")
    if mended := _mend(cell, place, voice):
        return repaired(row, mended)
    return row.model_copy(update={"correction": row.derived, "repair": Repair.MANUAL})


def _in_favour(cell: Cell, claim: Claim, context: Context) -> tuple[Answer, int, Parse | None]:
    """Compare a cell; a side that is false is read in the other ways, too, that its print allows.

    Gives the reading that makes it true, if it is not the usual one.
    """
    answer, place = _compare(cell)
    if not isinstance(answer, Refuted):
        return answer, place, None
    begin, end = cell.places[place]
    for way in parses(cell.text[begin:end], context.loaded.paper.notation, context.names)[0][1:]:
        try:
            unfolded = context.unfolded(claim.id, way.node)
        except LatexError:  # shapes that do not fit: no formula in this reading
            continue
        side = multiply(term_of(cell.factor), unfolded) if isinstance(unfolded, Term) else unfolded
        sides = (*cell.sides[:place], side, *cell.sides[place + 1 :])
        found, _ = _compare(replace(cell, sides=sides))
        if isinstance(found, Proved):
            return found, place, way
    return answer, place, None


def _told(way: Parse | None) -> str:
    if way is None:
        return ""
    return f"true if one reads {', '.join(f'${one}$ as ${other}$' for one, other in way.chosen)}"


def _heard(answer: Answer, place: int, way: Parse | None, cell: Cell, voice: Voice) -> Answer:
    """Ask direct evaluation of each side that was found true, or of the one that was not."""
    if way is not None:
        return voice.equal(answer, way.node, (), cell.derived / cell.factor)
    for node in cell.nodes if isinstance(answer, Proved) else cell.nodes[place : place + 1]:
        answer = voice.equal(answer, node, cell.index, cell.derived)
    return answer


def _compare(cell: Cell) -> tuple[Answer, int]:
    """Hold each side against what is derived; the answer on the first that fails, and its place."""
    engines: tuple[str, ...] = ()
    for place, side in enumerate(cell.sides):
        answer = equal_to_derived(side, cell.derived, cell.domain)
        if not isinstance(answer, Proved):
            return answer, place
        engines = merge(engines, answer.engines)
    return Proved(engines), 0


def _follows_from_premises(cell: Cell) -> bool:
    """Whether each side is what mechanics implies, or what the paper's own premises do."""
    if cell.premises is None:
        return False
    implied = cell.derived, cell.premises
    return all(
        any(isinstance(equal_to_derived(side, each, cell.domain), Proved) for each in implied)
        for side in cell.sides
    )


def _mend(cell: Cell, place: int, voice: Voice) -> Mended | None:
    """Return the printed text with the least edit that makes the side at `place` true, if any."""
    if not voice.context.mends:
        return None
    begin, end = cell.places[place]
    found = mend_claim(cell.text[begin:end], cell.derived, voice, cell.factor)
    return found.inside(cell.text[:begin], cell.text[end:]) if found else None
