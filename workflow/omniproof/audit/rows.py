"""How an answer of the engines becomes fields of a row."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sympy import (
    Expr,
    GreaterThan,
    Integer,
    LessThan,
    StrictGreaterThan,
    StrictLessThan,
    pi,
)
from sympy.core.relational import Relational

from omniproof.audit.context import Context
from omniproof.audit.evidence import Counterexample
from omniproof.audit.ledger import Row, Verdict
from omniproof.audit.places import where
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided, Witness
from omniproof.decide.in_sympy.domain import in_symbols
from omniproof.decide.in_sympy.equality import confirmed_equal
from omniproof.decide.order.extrema import sign_on
from omniproof.registry import Family
from omniproof.transcription.model import Claim, Kind


def start(claim: Claim, context: Context, row_id: str = "") -> Row:
    """Begin the row of a claim or of one of its entries; its verdict is still open."""
    name = row_id or claim.id
    quote = claim.quote if claim.kind is Kind.RELATION else None
    return Row(
        paper=context.loaded.paper.key,
        id=name,
        where=where(name),
        kind=claim.kind,
        verdict=Verdict.UNDECIDED,
        source=claim.source,
        reading=claim.reading,
        printed=claim.printed or context.printed(claim.id) or quote or claim.says,
        note=_sentence(claim.says) if claim.latex or claim.printed or quote else "",
    )


def _fields(answer: Answer, context: Context) -> dict[str, Any]:
    """Verdict, witness, condition and engines of an answer, as an update of a row."""
    match answer:
        case Proved(engines, note):
            return {"verdict": Verdict.VERIFIED, "engines": "+".join(engines), "note": note}
        case Refuted(engines, witness, note):
            return {
                "verdict": Verdict.ERRATUM,
                "note": note,
                "witness": _counterexample(witness),
                "engines": "+".join(engines),
            }
        case OnBranch(engines, _, witness):
            condition, note = _condition(in_symbols(answer, context.variables), context)
            return {
                "verdict": Verdict.CONDITIONAL,
                "assumption": condition,
                "note": note,
                "witness": _counterexample(witness),
                "engines": "+".join(engines),
            }
        case Undecided(reason):
            return {"verdict": Verdict.UNDECIDED, "note": reason}


def _counterexample(witness: Witness) -> Counterexample:
    return Counterexample(
        point=dict(witness.point), printed=witness.printed, derived=witness.derived
    )


def answered(row: Row, answer: Answer, context: Context) -> Row:
    """Put an answer into a row; what the engine remarks is added to the note."""
    fields = _fields(answer, context)
    note = fields.pop("note", "")
    return with_note(row.model_copy(update=fields), note)


def with_note(row: Row, *sentences: str) -> Row:
    """Add sentences to the note of a row."""
    added = [_sentence(sentence) for sentence in sentences if sentence]
    return row.model_copy(update={"note": " ".join(filter(None, [row.note, *added]))})


def _condition(answer: OnBranch, context: Context) -> tuple[str, str]:
    """Write the condition in the paper's symbols, and in degrees where it is on one angle."""
    signs = [relation for relation in answer.relations if relation.func in _SIGNS]
    if len(signs) != len(answer.relations) or any(relation.rhs != 0 for relation in signs):
        return answer.condition, answer.note
    solved = _interval(signs)
    if solved is not None:
        return solved.condition, solved.note
    named = [f"{_name(relation.lhs, context)} {_SIGNS[relation.func]} 0" for relation in signs]
    return r" \text{ and } ".join(named), answer.note


_SIGNS = {StrictGreaterThan: ">", GreaterThan: r"\geq", StrictLessThan: "<", LessThan: r"\leq"}


def _interval(relations: Sequence[Relational]) -> OnBranch | None:
    """Solve a condition on one angle over a full turn; None for any other condition."""
    if len(relations) != 1 or relations[0].func is not StrictGreaterThan:
        return None
    expression = relations[0].lhs
    symbols = expression.free_symbols
    bare = expression.replace(lambda part: part.is_Function, lambda part: Integer(1))
    # A symbol outside of a sine or cosine is no angle: a turn does not cover its values.
    if len(symbols) != 1 or bare.free_symbols:
        return None
    answer = sign_on(Family(expression, dict.fromkeys(symbols, (-pi, pi))), 1)
    return answer if isinstance(answer, OnBranch) else None


def _name(expression: Expr, context: Context) -> str:
    """Call an expression by what the paper calls it, where it is one of its long ones."""
    for known, latex in context.spelling.abbreviations.items():
        if isinstance(confirmed_equal(expression, known, enough=1), Proved):
            return latex
    return context.spelling.latex(expression)


def _sentence(text: str) -> str:
    return text if not text or text.endswith((".", "!", "?")) else f"{text}."
