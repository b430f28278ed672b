"""Every answer twice: what the first engine says is asked again of engines with other mathematics.

An engine is named in an answer only where it decided: a second engine that does not support a
formula, or that leaves its truth to signs, adds no name. Engines that contradict each other are a
defect of this project, whatever the formula is: `DisagreementError` stops the build.

Claims of a paper ask all of them. One confirmation is enough for a formula on the command line: z3
takes a quarter of a second to be imported, and is asked there only where prime fields do not
decide.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from omniproof.decide.answer import Answer, DisagreementError, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.balls import is_enclosed
from omniproof.decide.domain import REALS, Domain
from omniproof.decide.prime_fields.zero import Mixed, NonZero, Zero, vanishes
from omniproof.decide.z3.equation import Different, Equal, differ_somewhere
from omniproof.decide.zero_test import decide_equal
from omniproof.formula.term import Term, subtract, symbols

Vote = bool | None
"""True: the answer is confirmed; False: it is contradicted; None: not decided."""


@dataclass(frozen=True)
class Equation:
    """Two sides, and where they are said to agree."""

    left: Term
    right: Term
    domain: Domain


def confirmed_equal(
    printed: Term, derived: Term, domain: Domain = REALS, *, enough: int | None = None
) -> Answer:
    """Decide as `decide_equal` does, and name every engine that comes to the same answer.

    After `enough` confirmations no further engine is asked; without it, all are.
    Raises `DisagreementError` when an engine comes to another one.
    """
    if not (is_enclosed(printed) and is_enclosed(derived)):
        from omniproof.decide.in_sympy.unknown_functions import in_symbols

        reduced = in_symbols(printed, derived, domain)
        if not isinstance(reduced, tuple):
            return reduced
        printed, derived = reduced
    answer = decide_equal(printed, derived, domain)
    if isinstance(answer, Undecided):
        return answer
    return _confirmed(answer, Equation(printed, derived, domain), enough)


def _confirmed(answer: Proved | Refuted | OnBranch, asked: Equation, enough: int | None) -> Answer:
    for engine, vote_of in ENGINES.items():
        vote = vote_of(answer, asked)
        if vote is False:
            raise DisagreementError(_both_sides(engine, answer, asked))
        if vote:
            answer = replace(answer, engines=(*answer.engines, engine))
            enough = None if enough is None else enough - 1
        if enough == 0:
            break
    return answer


def _both_sides(engine: str, answer: Proved | Refuted | OnBranch, asked: Equation) -> str:
    from sympy import sstr

    from omniproof.decide.in_sympy.domain import converter_for

    converter = converter_for(asked.domain, symbols(asked.left) | symbols(asked.right))
    sides = " = ".join(sstr(converter.expression(side)) for side in (asked.left, asked.right))
    return f"{engine} contradicts {'+'.join(answer.engines)} on {sides}: {answer}"


def _modular(answer: Answer, asked: Equation) -> Vote:
    """Ask at points of prime fields; a test over all reals, so that a domain only leaves cases out.

    A condition is confirmed when it suffices (zero under it) and something is needed (not without).
    """
    positive = asked.domain.nonnegative
    difference = subtract(asked.left, asked.right)
    match vanishes(difference, (), positive), answer:
        case (Zero(), Proved()) | (NonZero(), Refuted()):
            return True
        case (Zero(), _) | (NonZero(), _):
            return False
        case Mixed(), OnBranch(relations=relations):
            return _suffices(difference, relations, positive)
    return None


def _suffices(difference: Term, relations: Sequence[Any], positive: frozenset[str]) -> Vote:
    from omniproof.formula.sympy_terms import term_of

    signed = {">", ">="}
    if not relations or not all(r.rel_op in signed and r.rhs == 0 for r in relations):
        return None
    match vanishes(difference, [term_of(relation.lhs) for relation in relations], positive):
        case Zero():
            return True
        case NonZero():
            return False
    return None


def _smt(answer: Answer, asked: Equation) -> Vote:
    """Ask z3 for a point anywhere: where a domain leaves points out, only "no point" counts."""
    match differ_somewhere(asked.left, asked.right, asked.domain.signs), answer:
        case (Equal(), Proved()) | (Different(), Refuted()):
            return True
        case Equal(widened=widened), _:
            return None if widened else False
        case Different(), _:
            return False if asked.domain.is_orthant else None
    return None


ENGINES: dict[str, Callable[[Answer, Equation], Vote]] = {"modular": _modular, "z3": _smt}
"""By the name in the ledger, in the order in which they are asked."""
