"""Whether two conditions on the signs of monomials hold in the same cases.

The sign of a monomial depends on the signs of its symbols only, so that -1, 0 and 1 for each symbol
are all the cases there are. What is assumed strikes cases out: sign by sign where it bounds one
symbol by a number, case by case where it is itself on a monomial. Both leave only cases that occur,
so that a case in which the conditions differ refutes. Any other assumption may strike out more.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any

from sympy import And, Symbol, latex, true
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean

from omniproof.decide.answer import Answer, Proved, Refuted, Undecided, Witness

ENGINE = ("signs",)
Case = Mapping[Symbol, int]


def equivalent(printed: Boolean, derived: Boolean, assumed: Sequence[Boolean] = ()) -> Answer:
    """Decide whether two conditions hold in the same of the cases that are assumed to occur."""
    if not all(map(_on_a_monomial, printed.atoms(Relational) | derived.atoms(Relational))):
        return Undecided("a condition is not on the sign of a monomial")
    known, others = _premises(assumed)
    symbols = sorted(printed.free_symbols | derived.free_symbols, key=str)
    for case in _cases(symbols, known):
        sides = bool(printed.subs(case)), bool(derived.subs(case))
        if sides[0] != sides[1]:
            shown = {str(symbol): str(case[symbol]) for symbol in symbols}
            return _unless(others, Witness(shown, *(str(side).lower() for side in sides)))
    return Proved(ENGINE)


def _unless(others: Sequence[Any], witness: Witness) -> Answer:
    """Refute, unless an assumption that is not used here may strike the case out."""
    if not others:
        return Refuted(ENGINE, witness)
    told = ", ".join(f"${latex(part)}$" for part in others)
    return Undecided(f"it is not proved from {told}, and false without")


def _premises(assumed: Sequence[Boolean]) -> tuple[list[Any], list[Any]]:
    """Sort what is assumed into what strikes out cases, and the rest."""
    stated = [part for statement in assumed for part in And.make_args(statement)]
    premises = [part.canonical for part in stated if part != true]
    known = [part for part in premises if _on_a_monomial(part) or _is_bound(part)]
    return known, [part for part in premises if part not in known]


def _cases(symbols: Sequence[Symbol], known: Sequence[Any]) -> Iterator[Case]:
    """Yield the signs of the symbols, and of those that the assumptions bring in."""
    others = {symbol for part in known for symbol in part.free_symbols} - set(symbols)
    everything = [*symbols, *sorted(others, key=str)]
    for signs in product(*(_signs(symbol) for symbol in everything)):
        case = dict(zip(everything, signs, strict=True))
        if all(_may_hold(part, case) for part in known):
            yield case


def _signs(symbol: Symbol) -> tuple[int, ...]:
    if symbol.is_positive:
        return (1,)
    return (-1, 1) if symbol.is_nonzero else (-1, 0, 1)


def _may_hold(part: Any, case: Case) -> bool:
    """Whether numbers of these signs can fulfil an assumption."""
    if _on_a_monomial(part):
        return bool(part.subs(case))
    symbol, bound = part.lhs, part.rhs
    at_zero = bool(part.subs(symbol, 0))
    if case[symbol] == 0:
        return at_zero
    # Numbers of one sign reach from 0, which is not among them, to infinity: a bound that neither
    # end of that half-line meets, no number on it meets.
    far_out = bool(part.subs(symbol, case[symbol] * (abs(bound) + 1)))
    return far_out or (at_zero and bound != 0)


def _is_bound(part: Any) -> bool:
    """Whether a relation bounds one symbol by a number."""
    return isinstance(part, Relational) and part.lhs.is_Symbol and part.rhs.is_number


def _on_a_monomial(part: Any) -> bool:
    if not isinstance(part, Relational) or part.rhs != 0:
        return False
    factors = part.lhs.as_ordered_factors()
    return all(f.is_number or f.as_base_exp()[0].is_Symbol for f in factors)
