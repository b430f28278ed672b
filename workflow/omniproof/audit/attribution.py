"""Which fault explains which row, and how far a fault reaches: two rules over finished rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from omniproof.audit.context import Context
from omniproof.audit.ledger import Consequence, Row, Verdict
from omniproof.transcription.model import Kind


def attribute(rows: Sequence[Row], context: Context) -> list[Row]:
    """Fill `follows` and `consequence` of all rows of a paper, in order of place."""
    faults = {row.id: row for row in rows if row.verdict.is_fault}
    first_by_print: dict[str, str] = {}
    finished = []
    for row in rows:
        follows = _recurrence(row, first_by_print) or _premise(row, context, faults)
        fields = {"follows": follows, "consequence": _consequence(row)}
        finished.append(row.model_copy(update=fields))
    return finished


def _recurrence(row: Row, first_by_print: dict[str, str]) -> str:
    """Return the first place of a misprint that stands here again."""
    if row.kind is not Kind.IDENTITY or row.verdict is not Verdict.ERRATUM:
        return ""
    first = first_by_print.setdefault(row.printed, row.id)
    return first if first != row.id else ""


def _premise(row: Row, context: Context, faults: Mapping[str, Row]) -> str:
    """Return the faulty claim on which a right row rests, or a wrong one in the same way."""
    derivation = context.registry.derivations.get(row.id) or context.registry.derivations.get(
        row.id.partition("[")[0]
    )
    if derivation is None:
        return ""
    for premise in derivation.rests_on:
        fault = faults.get(premise)
        if fault and row.verdict in {Verdict.VERIFIED, fault.verdict}:
            return premise
    convention = derivation.convention
    if convention in faults and (row.verdict is Verdict.VERIFIED or _only_here(row, context)):
        return convention
    return ""


def _only_here(row: Row, context: Context) -> bool:
    """Whether a faulty row would be right under the stated reading of its convention."""
    from omniproof.audit.identities import count_faults

    stated = Context(context.loaded, context.registry, context.readings)
    return count_faults(context.claims[row.id.partition("[")[0]], stated) == 0


def _consequence(row: Row) -> Consequence:
    """`motion` for a formula or a statement on motion; steps of a proof and wording are `text`."""
    if not row.verdict.is_fault:
        return Consequence.NONE
    if row.kind is Kind.VALUE:
        return Consequence.NUMBER
    in_a_proof = row.id.startswith("app:")
    if row.kind in {Kind.IDENTITY, Kind.RELATION} and not in_a_proof:
        return Consequence.MOTION
    return Consequence.TEXT
