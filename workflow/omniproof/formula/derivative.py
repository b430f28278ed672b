"""Derivatives of terms, by the rules of the table of functions; nothing but 0 and 1 is left out."""

from __future__ import annotations

from omniproof.formula.errors import UnsupportedError
from omniproof.formula.functions import Lacks, derivatives
from omniproof.formula.term import (
    ONE,
    ZERO,
    Call,
    Integral,
    Power,
    Product,
    Sum,
    Symbol,
    Term,
    add,
    multiply,
    number,
    walk,
)


def derivative(term: Term, name: str) -> Term:
    """Return the derivative by a symbol, wherever there is one.

    Raises `UnsupportedError` for a function without a rule.
    """
    found: dict[Term, Term] = {}
    for part in walk(term):
        constant = all(found[inner] == ZERO for inner in part.parts)
        is_other = part != Symbol(name) and not isinstance(part, Integral)
        found[part] = ZERO if constant and is_other else _rule(part, found)
    return found[term]


def _rule(part: Term, found: dict[Term, Term]) -> Term:
    match part:
        case Symbol():
            return ONE
        case Sum(terms=terms):
            return _sum(*(found[each] for each in terms))
        case Product(factors=factors):
            pieces = ((*factors[:k], found[each], *factors[k + 1 :])
                      for k, each in enumerate(factors))  # fmt: skip
            return _sum(*(_product(*piece) for piece in pieces))
        case Power(base=base, exponent=exponent):
            lower = ONE if exponent == 1 else Power(base, exponent - 1)
            return _product(number(exponent), lower, found[base])
        case Call(function=function, arguments=arguments):
            known = derivatives(function, *arguments)
            if isinstance(known, Lacks):
                raise UnsupportedError(f"the derivative of {function} is not known")
            partial = zip(known, arguments, strict=True)
            return _sum(*(_product(slope, found[each]) for slope, each in partial))
    raise UnsupportedError(f"the derivative of an {type(part).__name__.lower()} is not taken")


def _sum(*parts: Term) -> Term:
    kept = [part for part in parts if part != ZERO]
    return add(*kept) if kept else ZERO


def _product(*parts: Term) -> Term:
    if ZERO in parts:
        return ZERO
    kept = [part for part in parts if part != ONE]
    return multiply(*kept) if kept else ONE
