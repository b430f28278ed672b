r"""Where a formula is defined, by its terms, which still show all that is printed.

A statement is made wherever every printed part is defined: each denominator is not 0, each radicand
not negative, the argument of an inverse function in its range, a matrix that is inverted not
singular (its determinant is a denominator of each entry), a tangent away from its poles. So
`\frac{x^2}{x} = x` says nothing at x = 0, nor `(\sqrt{x})^2 = x` at x = -1.
"""

from __future__ import annotations

from collections.abc import Iterator

from omniproof.formula.functions import FUNCTIONS, domain
from omniproof.formula.term import (
    ZERO,
    Call,
    Integral,
    Number,
    Power,
    Product,
    Term,
    symbols,
)
from omniproof.formula.value import Comparison


def requirements(*terms: Term) -> tuple[Comparison, ...]:
    """Return what has to hold for each part of terms to be defined, what holds always left out.

    What is under an integral has to be defined for some values of its variable only.
    """
    needed = (each for term in terms for part in _unbound(term) for each in _needs(part))
    return tuple(dict.fromkeys(each for each in needed if symbols(each.left)))


def radicands(*terms: Term) -> tuple[Term, ...]:
    """Return what must not be negative: radicands, and 1 - x and 1 + x for arguments of arcs."""
    return tuple(each.left for each in requirements(*terms) if each.operator != "\\neq")


def _unbound(term: Term) -> Iterator[Term]:
    """Yield each different part once, from the outside, but none of an integrand."""
    seen, left = {term}, [term]
    while left:
        part = left.pop()
        yield part
        inside = (part.lower, part.upper) if isinstance(part, Integral) else part.parts
        for inner in reversed(inside):
            if inner not in seen:
                seen.add(inner)
                left.append(inner)


def _needs(term: Term) -> Iterator[Comparison]:
    match term:
        case Power(base=base, exponent=exponent) if exponent < 0:
            yield from _differ_from_0(base)
        case Call(function=function, arguments=arguments) if function in FUNCTIONS:
            yield from domain(function, *arguments)


def _differ_from_0(term: Term) -> Iterator[Comparison]:
    """Say of each factor that it does not vanish."""
    match term:
        case Product(factors=factors):
            for factor in factors:
                yield from _differ_from_0(factor)
        case Power(base=base) | Call(function="sqrt", arguments=(base,)):
            yield from _differ_from_0(base)
        case Number():
            pass
        case _:
            yield Comparison(term, "\\neq", ZERO)
