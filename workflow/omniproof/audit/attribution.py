"""Which fault explains which row, and how far a fault reaches: two rules over finished rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from omniproof.audit.context import Context
from omniproof.audit.ledger import Consequence, Row, Verdict
from omniproof.registry import Derivation
from omniproof.transcription.ids import base
from omniproof.transcription.model import Form, Kind


def attribute(rows: Sequence[Row], context: Context) -> list[Row]:
    """Fill `follows` and `consequence` of all rows of a paper, in order of place."""
    faults = {row.id: row for row in rows if row.verdict.is_fault}
    first_places: dict[tuple[str, ...], str] = {}
    finished = []
    for row in rows:
        known = row.follows or _recurrence(row, context, first_places)
        follows = known or _premise(row, context, faults)
        fields = {"follows": follows, "consequence": _consequence(row, context)}
        finished.append(row.model_copy(update=fields))
    return finished


def _recurrence(row: Row, context: Context, first_places: dict[tuple[str, ...], str]) -> str:
    """Return the first place of a misprint that stands here again."""
    claim = context.claims.get(row.id)
    misprint: tuple[str, ...]
    match row.kind, row.verdict:
        case Kind.IDENTITY, Verdict.ERRATUM:
            misprint = (row.kind, row.printed)
        case (Kind.CONSISTENCY, Verdict.INCONSISTENT) if claim is not None:
            misprint = (row.kind, row.printed, *claim.agrees_with)
        case (Kind.REFERENCE, Verdict.ERRATUM) if claim is not None and claim.target:
            misprint = (row.kind, claim.target, str(claim.about))
        case _:
            return ""
    first = first_places.setdefault(misprint, row.id)
    return first if first != row.id else ""


def _premise(row: Row, context: Context, faults: Mapping[str, Row]) -> str:
    """Return the faulty claim on which a right row rests, or a wrong one in the same way.

    A decimal is held against the mended claim: a wrong one is explained only where it is the same.
    """
    derivation = _derivation(row, context)
    if derivation is None:
        return ""
    for premise in derivation.rests_on:
        fault = faults.get(premise)
        if fault and (row.verdict is Verdict.VERIFIED or _is_alike(row, fault)):
            return premise
    return ""


def _derivation(row: Row, context: Context) -> Derivation | None:
    """Return how a row follows; the entry of a matrix follows as the matrix does."""
    derivations = context.registry.derivations
    return derivations.get(row.id) or derivations.get(base(row.id))


def _is_alike(row: Row, fault: Row) -> bool:
    same_decimal = row.kind is not Kind.VALUE or row.printed == fault.printed
    return row.verdict is fault.verdict and same_decimal


_STEPS_OF_ARGUMENTS = {Form.POSITIVE, Form.NEGATIVE, Form.CONCAVE, Form.EQUIVALENT}


def _consequence(row: Row, context: Context) -> Consequence:
    """`motion` for a formula or a choice between designs; idle ones and steps are `text`."""
    if not row.verdict.is_fault:
        return Consequence.NONE
    if row.kind is Kind.VALUE:
        return Consequence.NUMBER
    if row.kind not in {Kind.IDENTITY, Kind.RELATION} or row.id.startswith("app:"):
        return Consequence.TEXT
    derivation = _derivation(row, context)
    if derivation is not None and derivation.idle:
        return Consequence.TEXT
    asserts = context.claims[row.id].asserts if row.kind is Kind.RELATION else None
    in_an_argument = asserts is not None and asserts.form in _STEPS_OF_ARGUMENTS
    return Consequence.TEXT if in_an_argument else Consequence.MOTION
