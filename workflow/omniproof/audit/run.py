"""Audit one paper: load, check, choose conventions, judge every claim, attribute the faults."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from sympy import MatrixBase

from omniproof.audit.agreement import disagreements
from omniproof.audit.attribution import attribute
from omniproof.audit.context import Context
from omniproof.audit.judge import judge_claim
from omniproof.audit.ledger import Ledger, Row
from omniproof.audit.other_notation import misread
from omniproof.audit.own_text import refuse_own_text, same_by_name
from omniproof.audit.readings import load_readings, unfit
from omniproof.audit.wavering import choose, choose_among
from omniproof.decide.answer import DisagreementError
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.grid import Grid
from omniproof.registry import Registry, load_registry
from omniproof.transcription.faults import BadInput, Fault
from omniproof.transcription.loader import load_paper, load_sound_part
from omniproof.transcription.matching import unmatched
from omniproof.transcription.model import Claim, Form, Kind, Role
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import names


def audit_paper(folder: Path) -> Ledger:
    """Return the ledger of the paper in a folder of `paper_data`; raises `BadInput`."""
    context = prepare_to_judge(folder)
    rows = [row for claim in context.loaded.claims for row in _judged(claim, context)]
    if faults := list(misread(rows, context)):
        raise BadInput(faults)
    return Ledger(
        paper=context.loaded.paper.key,
        claims=len(context.loaded.claims),
        rows=tuple(refuse_own_text(row, context) for row in attribute(rows, context)),
    )


def _judged(claim: Claim, context: Context) -> list[Row]:
    """Judge a claim; a disagreement about it names it, and what may be behind it."""
    try:
        return judge_claim(claim, context)
    except DisagreementError as error:
        parts = [str(error), same_by_name(claim.id, context)]
        told = "; ".join(filter(None, parts))
        raise DisagreementError(f"{context.loaded.paper.key}, {claim.id}: {told}") from None


def prepare_to_judge(folder: Path) -> Context:
    """Load a paper as `prepare` does, and choose the readings of its conventions."""
    context = prepare(folder)
    context.choices = choose(context)
    return context


def open_to_judge(folder: Path) -> Context:
    """Load a paper to judge single claims: nothing is checked that its whole audit checks.

    Raises `BadInput` when its files cannot be read. See `choose_reading` before one is judged.
    """
    loaded = load_paper(folder)
    key = loaded.paper.key
    return Context(loaded, _registry(key), load_readings(key))


def choose_reading(claim: str, context: Context) -> None:
    """Choose the readings of the convention that a claim depends on, if it does."""
    if convention := context.derivation(claim).convention:
        context.choices = {**context.choices, **choose_among(convention, context)}


def prepare(folder: Path) -> Context:
    """Load a paper with its derivations and readings; raises `BadInput` with all faults."""
    loaded, faults = load_sound_part(folder, lambda key: _registry(key).known)
    context = Context(loaded, _registry(loaded.paper.key), load_readings(loaded.paper.key))
    registry = context.registry
    found = [
        *faults,
        *unmatched(
            loaded, set(registry.derivations), set(registry.quantities), set(context.readings)
        ),
    ]
    found += [*unfit(context.readings, loaded), *disagreements(context)]
    sound = [claim for claim in loaded.claims if _can_be_evaluated(claim, context, found)]
    found += [fault for claim in sound for fault in _unfit(claim, context)]
    found += [fault for claim in loaded.claims for fault in _no_domain(claim, context)]
    if found:
        raise BadInput(found)
    return context


def _registry(paper: str) -> Registry:
    """Return what is derived for a paper: nothing, as long as nobody wrote anything."""
    try:
        return load_registry(paper)
    except ModuleNotFoundError as error:
        if error.name and error.name.startswith("omniproof.papers."):
            return Registry(paper)
        raise


def _can_be_evaluated(claim: Claim, context: Context, faults: list[Fault]) -> bool:
    """Whether a claim has a formula and a derivation, and no fault so far."""
    if claim.uncheckable or claim.id not in context.loaded.trees:
        return False
    if claim.id not in context.registry.derivations:
        return False
    if any(fault.path.startswith(f"claims[{claim.id}]") for fault in faults):
        return False
    return all(_has_meaning(name, context) for name in names(context.loaded.trees[claim.id]))


def _has_meaning(printed: str, context: Context) -> bool:
    """Whether a symbol, or the determinant of one, is declared and derived where it has to be."""
    symbols, quantities = context.loaded.symbols, context.registry.quantities
    if printed not in symbols:
        return printed.removeprefix("\\det ") in symbols
    symbol = symbols[printed]
    if symbol.role is not Role.QUANTITY:
        return True
    return symbol.name in quantities and all(
        _has_meaning(symbol_name(latex), context) for latex in symbol.of
    )


def _unfit(claim: Claim, context: Context) -> Iterator[Fault]:
    """Find what only evaluation shows: unknown symbols, impossible products, wrong shapes."""
    compared = claim.kind is Kind.IDENTITY
    if not compared and (
        claim.asserts is None or claim.asserts.form not in {Form.EQUIVALENT, Form.INSTANCE}
    ):
        return
    try:
        nodes = context.sides(claim.id) if compared else (context.loaded.trees[claim.id],)
        values = [context.unfolded(claim.id, node) for node in nodes]
    except LatexError as error:
        yield context.loaded.fault(claim.id, error.message, error.cure, "latex")
        return
    if compared:
        yield from _shapes(claim, context, values)


def _no_domain(claim: Claim, context: Context) -> Iterator[Fault]:
    """Find assumptions that cannot be evaluated, or that nothing fulfils."""
    formulas = context.loaded.formulas(claim.id)
    derived = claim.id in context.registry.derivations
    if not derived or not all(_has_meaning(n, context) for node in formulas for n in names(node)):
        return
    try:
        context.domain(claim.id)
    except (LatexError, UnsupportedError) as reason:
        message = getattr(reason, "message", str(reason))
        yield context.loaded.fault(claim.id, message, "see `range` of symbols", "assumes")


def _shapes(claim: Claim, context: Context, values: list[object]) -> Iterator[Fault]:
    expected = _shape(context.derive_by_mechanics(claim.id))
    for found in map(_shape, values):
        if found != expected:
            message = f"expected {expected}, found {found}"
            cure = "write every row with as many entries as the paper prints"
            yield context.loaded.fault(claim.id, message, cure, "latex")


def _shape(value: object) -> str:
    if isinstance(value, MatrixBase | Grid):
        rows, columns = value.shape
        return f"a matrix of {rows} x {columns}"
    return "a single expression"
