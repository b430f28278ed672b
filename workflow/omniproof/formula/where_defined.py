r"""Where a formula is defined, by its terms, which still show all that is printed.

A statement is made wherever every printed part is defined: each denominator is not 0, each radicand
not negative, the argument of an inverse function in its range, a matrix that is inverted not
singular (its determinant is a denominator of each entry), a tangent away from its poles. So
`\frac{x^2}{x} = x` says nothing at x = 0, nor `(\sqrt{x})^2 = x` at x = -1.
"""

from __future__ import annotations

from collections.abc import Iterator

from omniproof.formula.term import (
    MINUS_ONE,
    ONE,
    ZERO,
    Call,
    Integral,
    Number,
    Power,
    Product,
    Sum,
    Term,
    subtract,
    symbols,
)
from omniproof.formula.value import Comparison

POLES = {"tan": "cos", "sec": "cos", "cot": "sin", "csc": "sin"}
"""What must not vanish where a function is defined."""


def requirements(*terms: Term) -> tuple[Comparison, ...]:
    """Return what has to hold for each part of terms to be defined, what holds always left out.

    What is under an integral has to be defined for some values of its variable only.
    """
    needed = (each for term in terms for part in _unbound(term) for each in _needs(part))
    return tuple(dict.fromkeys(each for each in needed if symbols(each.left)))


def radicands(*terms: Term) -> tuple[Term, ...]:
    """Return what must not be negative: radicands, and 1 - x and 1 + x for arguments of arcs."""
    found = (each for each in requirements(*terms) if each.operator != "\\neq")
    ends = ((c.left, c.right) if c.operator == "\\geq" else (c.right, c.left) for c in found)
    return tuple(low if high == ZERO else subtract(low, high) for low, high in ends)


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
        case Call(function="sqrt", arguments=(radicand,)):
            yield Comparison(radicand, "\\geq", ZERO)
        case Call(function="arcsin" | "arccos", arguments=(argument,)):
            yield Comparison(argument, "\\leq", ONE)
            yield Comparison(argument, "\\geq", MINUS_ONE)
        case Call(function="atan2", arguments=(ordinate, abscissa)):
            yield Comparison(Sum((Power(ordinate, 2), Power(abscissa, 2))), "\\neq", ZERO)
        case Call(function=function, arguments=arguments) if function in POLES:
            yield Comparison(Call(POLES[function], arguments), "\\neq", ZERO)


def _differ_from_0(term: Term) -> Iterator[Comparison]:
    """Say of each factor that it does not vanish."""
    match term:
        case Product(factors=factors):
            for factor in factors:
                yield from _differ_from_0(factor)
        case Power(base=base):
            yield from _differ_from_0(base)
        case Number():
            pass
        case _:
            yield Comparison(term, "\\neq", ZERO)
