"""A term as a sum of rational multiples of monomials: how an angle is taken apart."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import reduce

from omniproof.formula.errors import UnsupportedError
from omniproof.formula.term import ZERO, Number, Power, Product, Sum, Term, add, multiply

Monomial = frozenset[tuple[Term, int]]
"""Powers of what is neither a sum nor a product; without any, the monomial of a number."""
Expanded = dict[Monomial, Fraction]

MOST_MONOMIALS, LARGEST_POWER = 1_000, 12
"""Angles of formulas that people write have a handful; beyond these, expanding takes the time."""


def expand(term: Term) -> Expanded:
    """Multiply a term out; none of its monomials has the factor 0.

    Raises `UnsupportedError` for too many monomials, and for a division by zero.
    """
    match term:
        case Number(value=value):
            return _without_zeros({frozenset(): value})
        case Sum(terms=parts):
            return _sum(map(expand, parts))
        case Product(factors=parts):
            return reduce(_times, map(expand, parts))
        case Power(base=base, exponent=exponent):
            return _power(term, expand(base), exponent)
    return {frozenset({(term, 1)}): Fraction(1)}


def is_plainly_zero(term: Term) -> bool:
    """Whether a term is 0 as soon as it is multiplied out: `b - b`, `0 x`."""
    try:
        return not expand(term)
    except UnsupportedError:
        return False


def joined(found: Expanded) -> Term:
    """Return what was multiplied out as a term again."""
    products = (
        multiply(Number(factor), *(Power(part, count) for part, count in monomial))
        for monomial, factor in found.items()
    )
    return add(*products) if found else ZERO


def _power(term: Power, base: Expanded, exponent: int) -> Expanded:
    if not base and exponent < 0:
        raise UnsupportedError("a denominator is identically zero")
    if len(base) == 1:
        ((monomial, factor),) = base.items()
        powers = frozenset((part, count * exponent) for part, count in monomial if exponent)
        return {powers: factor**exponent}
    if 0 <= exponent <= LARGEST_POWER:
        return reduce(_times, [base] * exponent, {frozenset(): Fraction(1)})
    return {frozenset({(term, 1)}): Fraction(1)}


def _sum(parts: Iterable[Expanded]) -> Expanded:
    total: Expanded = {}
    for part in parts:
        for monomial, factor in part.items():
            total[monomial] = total.get(monomial, Fraction(0)) + factor
    return _without_zeros(total)


def _times(left: Expanded, right: Expanded) -> Expanded:
    if len(left) * len(right) > MOST_MONOMIALS:
        raise UnsupportedError(f"an angle has more than {MOST_MONOMIALS} monomials")
    return _sum({_join(m, n): a * b} for m, a in left.items() for n, b in right.items())


def _join(left: Monomial, right: Monomial) -> Monomial:
    counts = dict(left)
    for part, count in right:
        counts[part] = counts.get(part, 0) + count
    return frozenset((part, count) for part, count in counts.items() if count)


def _without_zeros(found: Expanded) -> Expanded:
    return {monomial: factor for monomial, factor in found.items() if factor}
