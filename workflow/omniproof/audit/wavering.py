"""A paper that wavers between two readings of a definition: each place is judged alone.

A place is judged under the reading that makes it true, the stated one first; where none does, it is
a misprint of its own. The fault is the second reading, and is charged once, where it comes in. What
is right under it says so; what contradicts another numbered result by it is inconsistent, too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from omniproof.audit.context import Context, flat
from omniproof.audit.identities import count_faults, judge_identity
from omniproof.audit.ledger import Row, Verdict
from omniproof.audit.places import where
from omniproof.audit.rows import with_note
from omniproof.decide.answer import Proved
from omniproof.decide.in_sympy.equality import confirmed_equal
from omniproof.transcription.ids import whole
from omniproof.transcription.model import Claim, Kind
from omniproof.transcription.tree import Chain, Name


def choose(context: Context) -> dict[str, str]:
    """Choose a reading for each claim to which it matters, by its id.

    Where none makes it true, it is the reading under which the fewest printed cells are wrong.
    """
    return {
        claim: reading
        for convention in context.registry.conventions
        for claim, reading in choose_among(convention, context).items()
    }


def choose_among(convention: str, context: Context) -> dict[str, str]:
    """Choose a reading for each claim that depends on one convention."""
    options = context.registry.conventions[convention].options
    group = [c for c in context.loaded.claims if _depends(c, context) == convention]
    faults = {
        option: {c.id: count_faults(c, under(option, c, context)) for c in group}
        for option in options
    }
    needed = min(options, key=lambda option: sum(faults[option].values()))
    return {
        c.id: next((option for option in options if faults[option][c.id] == 0), needed)
        for c in group
        if any(faults[option][c.id] for option in options)
    }


def _depends(claim: Claim, context: Context) -> str:
    """Return the convention on which a claim depends, if any."""
    derivation = context.registry.derivations.get(claim.id)
    return derivation.convention if derivation else ""


def under(option: str, claim: Claim, context: Context) -> Context:
    """Return what a claim is judged with under another reading."""
    return replace(context, choices={**context.choices, claim.id: option})


def judge_alone(claim: Claim, context: Context) -> list[Row]:
    """Judge a printed formula under its own reading, and say which it is where that matters."""
    convention = _depends(claim, context)
    if not convention:
        return judge_identity(claim, context)
    stated = context.registry.conventions[convention].stated
    chosen = context.choices.get(claim.id, stated)
    rows = _judge_under(chosen, claim, context)
    matters = claim.id in context.choices
    if not matters or any(row.verdict is not Verdict.VERIFIED for row in rows):
        return rows
    told = f"right where {chosen}"
    if chosen == stated:
        return [with_note(row, told) for row in rows]
    if result := _contradicted(claim, context):
        told = f"{told}, against {where(result)}"
        rows = [
            row.model_copy(update={"verdict": Verdict.INCONSISTENT})
            for row in _judge_under(stated, claim, context)
        ]
    return [with_note(row.model_copy(update={"follows": convention}), told) for row in rows]


def _judge_under(reading: str, claim: Claim, context: Context) -> list[Row]:
    rows = judge_identity(claim, under(reading, claim, context))
    return [row.model_copy(update={"convention": reading}) for row in rows]


def _contradicted(claim: Claim, context: Context) -> str:
    """Return the numbered equation that gives the same symbol another value, if there is one."""
    defined = _defined(claim, context)
    for other in context.loaded.claims:
        independent = not _depends(other, context) and other.id in context.registry.derivations
        if defined and independent and _defined(other, context) == defined:
            pair = (flat(context.derive_by_mechanics(each.id)) for each in (claim, other))
            if not all(isinstance(confirmed_equal(*e), Proved) for e in zip(*pair, strict=True)):
                return other.id
    return ""


def _defined(claim: Claim, context: Context) -> str:
    """Return the symbol that a numbered equation defines: the one that stands alone on its left."""
    tree = context.loaded.trees.get(claim.id)
    numbered = claim.kind is Kind.IDENTITY and claim.id.startswith("eq:")
    left = tree.sides[0] if numbered and isinstance(tree, Chain) else None
    return left.name if isinstance(left, Name) else ""


def judge_convention(row: Row, convention: str, context: Context) -> Row:
    """Judge the place where a reading comes in, or one that states it: both say the same."""
    row = row.model_copy(update={"verdict": Verdict.VERIFIED, "engines": "flint"})
    definition = context.registry.conventions[convention]
    used = {reading: list(_places(convention, reading, context)) for reading in definition.options}
    second = next((other for other in definition.others if used[other]), None)
    if second is None:
        return row
    stated_at = context.claims[convention].agrees_with
    against = tuple(place for place in (*stated_at, convention) if place != row.id)
    return with_note(
        row.model_copy(update={"verdict": Verdict.INCONSISTENT, "against": against}),
        f"stated at {', '.join(stated_at)}: {definition.stated}; "
        f"used from {convention} on: {second}",
        f"two cures: keep the first, and change {_listed(used[second])}; or give the second a name "
        f"of its own, and change {_listed(used[definition.stated]) or 'nothing else'}",
    )


def _places(convention: str, reading: str, context: Context) -> Iterator[str]:
    """Yield the places that follow a reading of a convention."""
    for claim, chosen in context.choices.items():
        if chosen == reading and _depends(context.claims[claim], context) == convention:
            yield where(whole(claim))


def _listed(places: Sequence[str]) -> str:
    return ", ".join(dict.fromkeys(places))
