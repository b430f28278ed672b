"""From a claim to its rows: one function a kind."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from sympy import Expr, MatrixBase

from omniproof.audit.angle_family import instance
from omniproof.audit.confirm_decimals import confirmed_class
from omniproof.audit.context import Context
from omniproof.audit.decimals import Rounding
from omniproof.audit.evidence import Counterexample
from omniproof.audit.fits import judge_fit
from omniproof.audit.identities import judge_identity
from omniproof.audit.ledger import Origin, Repair, Row, Verdict
from omniproof.audit.mending import mend_relation, repaired
from omniproof.audit.relations import judge, merge
from omniproof.audit.rows import answered, start, with_note
from omniproof.audit.sign_cases import equivalent
from omniproof.audit.voice import Voice
from omniproof.audit.wavering import judge_alone, judge_convention
from omniproof.decide.answer import Answer, Proved, Refuted, Undecided
from omniproof.formula.evaluation import evaluate
from omniproof.registry import Fit, Obligation, Ordered, Relation, Subject
from omniproof.transcription.model import ID, Claim, Form, Kind, Reading
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Chain, Comparison, Node, names, walk
from omniproof.transcription.verbatim import normalise


def judge_claim(claim: Claim, context: Context) -> list[Row]:
    """Return the rows of a claim: one, or one for each entry of a matrix."""
    if claim.uncheckable is not None:
        return [_judge_uncheckable(claim, context)]
    judges: dict[Kind, Callable[[Claim, Context], Row]] = {
        Kind.VALUE: _judge_value,
        Kind.RELATION: _judge_relation,
        Kind.CONSISTENCY: _judge_consistency,
        Kind.REFERENCE: _judge_reference,
        Kind.EDITORIAL: _judge_reading,
    }
    if claim.kind is Kind.IDENTITY:
        return judge_alone(claim, context)
    return [judges[claim.kind](claim, context)]


def _judge_uncheckable(claim: Claim, context: Context) -> Row:
    told = {"uncheckable": claim.uncheckable, "argument": claim.argument or ""}
    row = start(claim, context).model_copy(update={"verdict": Verdict.UNCHECKABLE, **told})
    row = with_note(row, f"{claim.uncheckable}. Would decide it: {claim.decided_by}")
    if claim.argument:
        row = with_note(row, f"Argument: {claim.argument}")
    if claim.reading is Reading.RECONSTRUCTED and claim.id in context.registry.derivations:
        return _reconstructed(row, judge_identity(claim, context))
    return row


def _reconstructed(row: Row, entries: Sequence[Row]) -> Row:
    """Say that a reconstruction is what mechanics implies; one that is not is ours to mend."""
    wrong = [entry.id for entry in entries if entry.verdict is not Verdict.VERIFIED]
    if wrong:
        return _undecided(row, f"the reconstruction does not follow from mechanics: {wrong[0]}")
    return with_note(row, f"The reconstruction follows from mechanics: {entries[0].engines}")


_BY_ROUNDING = {
    Rounding.EXACT: Verdict.VERIFIED,
    Rounding.ROUNDED: Verdict.VERIFIED,
    Rounding.TIE: Verdict.VERIFIED,
    Rounding.TRUNCATED: Verdict.MISROUNDED,
    Rounding.OFF_BY_ONE: Verdict.MISROUNDED,
    Rounding.WRONG: Verdict.ERRATUM,
}


def _judge_value(claim: Claim, context: Context) -> Row:
    value = context.derive(claim.id)
    if isinstance(value, Fit):
        return judge_fit(claim, value, context)
    finding = confirmed_class(value, str(claim.printed))
    row = start(claim, context)
    if isinstance(finding, Undecided):
        return answered(row, finding, context)
    verdict = _BY_ROUNDING[finding.rounding]
    if verdict is Verdict.MISROUNDED and _is_count(claim, value):
        verdict = Verdict.ERRATUM
    row = row.model_copy(
        update={
            "verdict": verdict,
            "derived": context.spelling.latex(value),
            "interval": finding.record,
            "engines": "+".join(finding.engines),
        }
    )
    if verdict is Verdict.VERIFIED:
        return row
    mended = {
        "witness": Counterexample(printed=str(claim.printed), derived=finding.digits),
        "correction": finding.correction,
        "repair": Repair.MANUAL,
    }
    return with_note(
        row.model_copy(update=mended),
        f"{finding.rounding}, relative error {finding.relative_error}",
    )


def _is_count(claim: Claim, value: Expr) -> bool:
    """Whether things are counted: a whole number without unit is right or wrong, never rounded."""
    return bool(value.is_Integer) and claim.unit == "1" and "." not in str(claim.printed)


def _judge_relation(claim: Claim, context: Context) -> Row:
    relation = context.relation(claim.id)
    answer = _judge_form(claim, relation, context)
    row = answered(start(claim, context), answer, context)
    if not isinstance(answer, Refuted):
        return _for_all(row, claim)
    if not (relation.condition or relation.correction):
        return _mended_by_edits(row, claim, relation, context)
    row = _for_all(_mended(row, relation, answer.engines), claim)
    if relation.premises is None or row.verdict is not Verdict.ERRATUM:
        return row
    granted = _judge_form(claim, replace(relation, subject=relation.premises), context)
    if not isinstance(granted, Proved):
        return row
    row = row.model_copy(update={"verdict": Verdict.MODEL_GAP})
    return with_note(row, "By the paper's own premises it is true")


def _mended(row: Row, relation: Relation, engines: tuple[str, ...]) -> Row:
    """Say what holds instead of a false relation: a proved correction, or a condition."""
    for obligation in relation.proof:
        # The correction is ours: it is believed no more than what is printed, and proved as well.
        proof = judge(obligation)
        if not isinstance(proof, Proved):
            return _undecided(row, f"the {obligation.form} of its correction is not proved")
        engines = merge(engines, proof.engines)
    if relation.condition:
        fields = {"verdict": Verdict.CONDITIONAL, "assumption": relation.condition}
    else:
        fields = {"correction": relation.correction, "repair": Repair.MANUAL}
    return row.model_copy(update={"engines": "+".join(engines), **fields})


def _mended_by_edits(row: Row, claim: Claim, relation: Relation, context: Context) -> Row:
    """Mend a printed relation whose derivation does not say what holds instead."""

    def proved(tree: Node) -> tuple[str, ...]:
        answer = _judge_printed(claim, relation.subject, context, tree)
        return answer.engines if isinstance(answer, Proved) else ()

    if _is_printed(claim, relation, context):
        box = getattr(relation.subject, "box", {})
        if found := mend_relation(claim, proved, box, context):
            return repaired(row, found)
    return _undecided(row, "false as it stands; its derivation does not say what holds instead")


def _for_all(row: Row, claim: Claim) -> Row:
    """What is said of all values is false where some are left out: it should say for which."""
    assert claim.asserts is not None
    if row.verdict is not Verdict.CONDITIONAL or not claim.asserts.for_all:
        return row
    correction = rf"{row.printed} \text{{ for }} {row.assumption}"
    fields = {"correction": correction, "assumption": "", "repair": Repair.MANUAL}
    return row.model_copy(update={"verdict": Verdict.ERRATUM, **fields})


def _undecided(row: Row, reason: str) -> Row:
    return with_note(row.model_copy(update={"verdict": Verdict.UNDECIDED}), reason)


def _judge_form(claim: Claim, relation: Relation, context: Context) -> Answer:
    assert claim.asserts is not None
    form, subject = claim.asserts.form, relation.subject
    if _is_printed(claim, relation, context):
        return _judge_printed(claim, subject, context, context.loaded.trees[claim.id])
    at = tuple(_point(node, context) for node in context.loaded.points.get(claim.id, ()))
    obligation = Obligation(form, subject, at, claim.asserts.member)
    return judge(obligation, context.domain(claim.id))


def _is_printed(claim: Claim, relation: Relation, context: Context) -> bool:
    """Whether what is printed takes part in a relation, and not only what is derived."""
    assert claim.asserts is not None
    if claim.asserts.form in {Form.EQUIVALENT, Form.INSTANCE}:
        return True
    return isinstance(relation.subject, Ordered) and claim.id in context.loaded.trees


def _judge_printed(claim: Claim, subject: Subject, context: Context, tree: Node) -> Answer:
    """Judge what is printed itself, and ask direct evaluation of it."""
    assert claim.asserts is not None
    form = claim.asserts.form
    voice, assumed = Voice(claim.id, context), context.assumed(claim.id)
    if form is Form.EQUIVALENT:
        answer = equivalent(context.evaluate(claim.id, tree), subject, assumed)
        return voice.equivalent(answer, tree, subject)
    if form is Form.INSTANCE:
        angles = tuple(context.evaluate(claim.id, tree))
        answer = instance(angles, subject, voice.domain, assumed)
        return voice.instance(answer, tree, subject)
    nodes = _ascending(tree)
    if not nodes:
        return Undecided("a chain is judged where it is printed with `<` alone, or with `>`")
    # The printed terms take the place of the derived ones, on the same box.
    terms = tuple(context.evaluate(claim.id, node) for node in nodes)
    answer = judge(Obligation(form, replace(subject, terms=terms)), voice.domain)
    return voice.ascending(answer, nodes, subject.box)


def _ascending(tree: Node) -> list[Node]:
    """Return the terms of a chain, the least first; none where its signs are not all alike."""
    links = [link for link in walk(tree) if isinstance(link, Comparison)]
    signs = {link.operator for link in links}
    if signs not in ({"<"}, {">"}):
        return []
    nodes = [links[0].left, *(link.right for link in links)]
    return nodes if signs == {"<"} else nodes[::-1]


def _point(node: Node, context: Context) -> tuple[Expr, ...]:
    value = evaluate(node, {name: context.meaning(name) for name in names(node)})
    return tuple(value) if isinstance(value, MatrixBase) else (value,)


def _judge_consistency(claim: Claim, context: Context) -> Row:
    conventions = context.registry.conventions
    convention = next((o for o in (claim.id, *claim.agrees_with) if o in conventions), None)
    if convention:
        return judge_convention(start(claim, context), convention, context)
    row = start(claim, context)
    against = [other for other in claim.agrees_with if not _agree(claim, other, context)]
    verdict = Verdict.INCONSISTENT if against else Verdict.VERIFIED
    fields = {"verdict": verdict, "engines": "text", "against": tuple(against)}
    differs = f"differs from {', '.join(against)}" if against else ""
    return with_note(row.model_copy(update=fields), differs)


def _agree(claim: Claim, other: str, context: Context) -> bool:
    """Whether two places print one thing: the same wording, or the symbol in a formula."""
    printed = str(claim.printed)
    partner = context.claims.get(other)
    if partner is not None and partner.kind is Kind.CONSISTENCY:
        return _spelling(printed) == _spelling(str(partner.printed))
    return _spelling(printed) in names(context.loaded.trees[other])


def _spelling(text: str) -> str:
    try:
        return symbol_name(text)
    except LatexError:
        return normalise(text)


def _judge_reference(claim: Claim, context: Context) -> Row:
    if claim.id in context.readings:
        return _judge_reading(claim, context)
    found = _symbols_at(str(claim.target), context)
    wanted = symbol_name(claim.about) if claim.about else None
    row = start(claim, context).model_copy(update={"engines": "text"})
    # Without a symbol to look for, a place that exists is all a program can tell.
    if wanted is None or wanted in found:
        row = row.model_copy(update={"verdict": Verdict.VERIFIED})
        return row if wanted else with_note(row, "there is such a place")
    places = _defining(wanted, context)
    return with_note(
        row.model_copy(
            update={
                "verdict": Verdict.ERRATUM,
                "correction": ", ".join(places),
                "repair": Repair.MANUAL,
            }
        ),
        f"{claim.target} does not contain ${claim.about}$",
    )


def _object(claim: str) -> str:
    parts = ID.fullmatch(claim)
    assert parts is not None
    return f"{parts['object']}:{parts['number']}"


def _symbols_at(target: str, context: Context) -> set[str]:
    trees = context.loaded.trees
    return {name for id_, tree in trees.items() if _object(id_) == target for name in names(tree)}


def _defining(symbol: str, context: Context) -> list[str]:
    """Equations that print a symbol alone, or as the left side of what they say."""
    trees = context.loaded.trees.items()
    lefts = ((id_, tree.sides[0] if isinstance(tree, Chain) else tree) for id_, tree in trees)
    found = (_object(id_) for id_, left in lefts if getattr(left, "name", None) == symbol)
    return list(dict.fromkeys(found))


def _judge_reading(claim: Claim, context: Context) -> Row:
    reading = context.readings[claim.id]
    row = start(claim, context).model_copy(
        update={
            "verdict": reading.verdict,
            "origin": Origin.READ,
            "correction": reading.correction,
            "printed": claim.quote or claim.says,
        }
    )
    return with_note(row, reading.reason)
