"""How an answer of the engines becomes fields of a row."""

from __future__ import annotations

from typing import Any

from omniproof.audit.answer import Answer, OnBranch, Proved, Refuted, Undecided
from omniproof.audit.context import Context
from omniproof.audit.ledger import Row, Verdict
from omniproof.audit.places import where
from omniproof.transcription.model import Claim


def start(claim: Claim, context: Context, row_id: str = "") -> Row:
    """Begin the row of a claim or of one of its entries; its verdict is still open."""
    name = row_id or claim.id
    return Row(
        paper=context.loaded.paper.key,
        id=name,
        where=where(name),
        kind=claim.kind,
        verdict=Verdict.UNDECIDED,
        source=claim.source,
        reading=claim.reading,
        printed=claim.printed or context.printed(claim.id) or claim.says,
        note=_sentence(claim.says) if claim.latex or claim.printed else "",
    )


def answer_fields(answer: Answer, context: Context) -> dict[str, Any]:
    """Verdict, witness, condition and engines of an answer, as an update of a row."""
    match answer:
        case Proved(engines):
            return {"verdict": Verdict.VERIFIED, "engines": "+".join(engines)}
        case Refuted(engines, witness):
            return {
                "verdict": Verdict.ERRATUM,
                "witness": str(witness),
                "engines": "+".join(engines),
            }
        case OnBranch(engines, condition, witness):
            return {
                "verdict": Verdict.CONDITIONAL,
                "assumption": _named(answer, condition, context),
                "witness": str(witness),
                "engines": "+".join(engines),
            }
        case Undecided(reason):
            return {"verdict": Verdict.UNDECIDED, "note": reason}


def with_note(row: Row, *sentences: str) -> Row:
    """Add sentences to the note of a row."""
    added = [_sentence(sentence) for sentence in sentences if sentence]
    return row.model_copy(update={"note": " ".join(filter(None, [row.note, *added]))})


def _named(answer: OnBranch, condition: str, context: Context) -> str:
    """Write the condition by a quantity of the paper, where it is the sign of one."""
    return condition


def _sentence(text: str) -> str:
    return text if not text or text.endswith((".", "!", "?")) else f"{text}."
