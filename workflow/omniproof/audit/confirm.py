"""Every answer twice: what the first engine says is asked again of engines with other mathematics.

An engine is named in an answer only where it decided: a second engine that does not support a
formula, or that leaves its truth to signs, adds no name. Engines that contradict each other are a
defect of this project, whatever the formula is: `DisagreementError` stops the build.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from omniproof.audit.counterexample import counterexample
from omniproof.audit.integrals import without_integrals
from omniproof.audit.sympy_domain import REALS, Domain
from omniproof.audit.zero_test import DisagreementError, Terms, both_terms, decide_equal
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.prime_fields.zero import Mixed, NonZero, Zero, vanishes
from omniproof.decide.z3.equation import Different, Equal, differ_somewhere
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import assumed_signs, positive_names, term_if_any, term_of
from omniproof.formula.term import Term, subtract

Vote = bool | None
"""True: the answer is confirmed; False: it is contradicted; None: not decided."""


@dataclass(frozen=True)
class Asked:
    """What an engine is asked: SymPy's idea of both sides, a domain, and the sides as printed."""

    printed: sp.Expr
    derived: sp.Expr
    domain: Domain
    terms: Terms | None


def confirmed_equal(
    printed: Any,
    derived: Any,
    domain: Domain = REALS,
    *,
    enough: int | None = None,
    terms: Terms | None = None,
) -> Answer:
    """Decide as `decide_equal` does, and name every engine that comes to the same answer.

    `terms` are the sides as they are printed, before SymPy had an idea of them; the engines look at
    these. After `enough` confirmations no further engine is asked; without it, all are.
    Raises `DisagreementError` when an engine comes to another one.
    """
    given = printed, derived
    try:
        printed, derived = map(sp.sympify, without_integrals(printed, derived))
    except UnsupportedError as reason:
        return counterexample(printed, derived, domain) or Undecided(str(reason))
    if terms is None or (printed, derived) != given:  # what stands for integrals is printed nowhere
        terms = both_terms(term_if_any(printed), term_if_any(derived))
    answer = decide_equal(printed, derived, domain, terms)
    if isinstance(answer, Undecided):
        return answer
    asked = Asked(printed, derived, domain, terms)
    for engine, vote_of in ENGINES.items():
        vote = vote_of(answer, asked)
        if vote is False:
            raise DisagreementError(_both_sides(engine, answer, printed, derived))
        if vote:
            answer = replace(answer, engines=(*answer.engines, engine))
            enough = None if enough is None else enough - 1
        if enough == 0:
            break
    return answer


def _both_sides(engine: str, answer: Answer, printed: Any, derived: Any) -> str:
    sides = f"{sp.sstr(printed)} = {sp.sstr(derived)}"
    return f"{engine} contradicts {'+'.join(answer.engines)} on {sides}: {answer}"


def _modular(answer: Answer, asked: Asked) -> Vote:
    """Ask at points of prime fields; a test over all reals, so that a domain only leaves cases out.

    A condition is confirmed when it suffices (zero under it) and something is needed (not without).
    """
    if asked.terms is None:
        return None
    positive = positive_names(asked.printed, asked.derived)
    difference = subtract(*asked.terms)
    match vanishes(difference, (), positive), answer:
        case (Zero(), Proved()) | (NonZero(), Refuted()):
            return True
        case (Zero(), _) | (NonZero(), _):
            return False
        case Mixed(), OnBranch(relations=relations):
            return _suffices(difference, relations, positive)
    return None


def _suffices(difference: Term, relations: Sequence[Any], positive: frozenset[str]) -> Vote:
    signed = (sp.StrictGreaterThan, sp.GreaterThan)
    if not relations or not all(isinstance(r, signed) and r.rhs == 0 for r in relations):
        return None
    match vanishes(difference, [term_of(relation.lhs) for relation in relations], positive):
        case Zero():
            return True
        case NonZero():
            return False
    return None


def _smt(answer: Answer, asked: Asked) -> Vote:
    """Ask z3 for a point anywhere: where a domain leaves points out, only "no point" counts."""
    if asked.terms is None:
        return None
    assumed = assumed_signs(asked.printed, asked.derived)
    match differ_somewhere(*asked.terms, assumed), answer:
        case (Equal(), Proved()) | (Different(), Refuted()):
            return True
        case Equal(widened=widened), _:
            return None if widened else False
        case Different(), _:
            return None if asked.domain != REALS else False
    return None


ENGINES: dict[str, Callable[[Answer, Asked], Vote]] = {"modular": _modular, "z3": _smt}
"""By the name in the ledger, in the order in which they are asked."""
