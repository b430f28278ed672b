"""How an answer of the engines becomes fields of a row."""

from __future__ import annotations

from typing import Any

from sympy import Expr, GreaterThan, LessThan, StrictGreaterThan, StrictLessThan

from omniproof.audit.answer import Answer, OnBranch, Proved, Refuted, Undecided
from omniproof.audit.context import Context
from omniproof.audit.ledger import Row, Verdict
from omniproof.audit.places import where
from omniproof.audit.zero_test import decide_equal
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
        case OnBranch(engines, _, witness):
            return {
                "verdict": Verdict.CONDITIONAL,
                "assumption": _condition(answer, context),
                "witness": str(witness),
                "engines": "+".join(engines),
            }
        case Undecided(reason):
            return {"verdict": Verdict.UNDECIDED, "note": reason}


def with_note(row: Row, *sentences: str) -> Row:
    """Add sentences to the note of a row."""
    added = [_sentence(sentence) for sentence in sentences if sentence]
    return row.model_copy(update={"note": " ".join(filter(None, [row.note, *added]))})


def _condition(answer: OnBranch, context: Context) -> str:
    """Write the condition in the paper's symbols; other conditions as the engine has them."""
    signs = [_SIGNS.get(relation.func) for relation in answer.relations]
    if not signs or not all(signs):
        return answer.condition
    named = [f"{_name(r.lhs - r.rhs, context)}" for r in answer.relations]
    return r" \text{ and } ".join(f"{n} {s} 0" for n, s in zip(named, signs, strict=True))


_SIGNS = {StrictGreaterThan: ">", GreaterThan: r"\geq", StrictLessThan: "<", LessThan: r"\leq"}


def _name(expression: Expr, context: Context) -> str:
    """Call an expression by what the paper calls it, where it is one of its long ones."""
    for known, latex in context.spelling.abbreviations.items():
        if isinstance(decide_equal(expression, known), Proved):
            return latex
    return context.spelling.latex(expression)


def _sentence(text: str) -> str:
    return text if not text or text.endswith((".", "!", "?")) else f"{text}."
