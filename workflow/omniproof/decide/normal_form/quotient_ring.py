"""Fractions over Q[generators] modulo triangular relations: the arithmetic of the normal form.

Each relation starts with a pure power of its own generator (s^2 = 1 - c^2, g^4 = 4 g^2 - 1,
w^2 = radicand in lower generators), and the order is lexicographic. Such leading terms are coprime,
so the relations already are a Groebner basis and one division by each of them, from the highest
generator down, is the normal form. Work is counted in terms, not in seconds, so that an answer
does not depend on the machine.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction as Rational
from typing import Any, NamedTuple, TypeAlias

from flint import Ordering, fmpq, fmpq_mpoly_ctx

from omniproof.formula.errors import UnsupportedError, WorkLimitError

Polynomial: TypeAlias = Any
"""An `fmpq_mpoly` (python-flint publishes no types)."""

MOST_TERMS = 20_000
MOST_PRODUCTS = 4_000_000


class Fraction(NamedTuple):
    """A numerator over a denominator; both are reduced by the relations of their ring."""

    numerator: Polynomial
    denominator: Polynomial


@dataclass(frozen=True)
class Relation:
    """`polynomial` = 0, where the leading term is `generator` to the power `degree`."""

    place: int
    degree: int
    polynomial: Polynomial


class QuotientRing:
    """Polynomials in named generators, from the highest to the lowest, modulo relations."""

    def __init__(self, names: Sequence[str]) -> None:
        self.context = fmpq_mpoly_ctx.get(tuple(names), Ordering.lex)
        self.place = {name: place for place, name in enumerate(names)}
        self.generators = dict(zip(names, self.context.gens(), strict=True))
        self.zero, self.one = self.context.constant(0), self.context.constant(1)
        self.relations: list[Relation] = []

    def relate(self, name: str, polynomial: Polynomial) -> None:
        """Add the relation polynomial = 0, led by a pure power of the named generator."""
        place = self.place[name]
        self.relations.append(Relation(place, polynomial.degrees()[place], polynomial))
        self.relations.sort(key=lambda relation: relation.place)

    def adopt(self, polynomial: Polynomial) -> Polynomial:
        """Return a polynomial of another ring in the generators of the same names here."""
        names = polynomial.context().names()
        terms = {}
        for exponents, coefficient in polynomial.to_dict().items():
            monomial = [0] * len(self.place)
            for name, exponent in zip(names, exponents, strict=True):
                if exponent:
                    monomial[self.place[name]] = exponent
            terms[tuple(monomial)] = coefficient
        return self.context.from_dict(terms)

    def reduce(self, polynomial: Polynomial) -> Polynomial:
        """Return the normal form of a polynomial."""
        degrees = polynomial.degrees()
        for relation in self.relations:
            if degrees[relation.place] >= relation.degree:
                polynomial = polynomial % relation.polynomial
                degrees = polynomial.degrees()
        if len(polynomial) > MOST_TERMS:
            raise WorkLimitError(f"the normal form grew beyond {MOST_TERMS} terms")
        return polynomial

    def times(self, left: Polynomial, right: Polynomial) -> Polynomial:
        """Multiply polynomials and reduce the product."""
        if len(left) * len(right) > MOST_PRODUCTS:
            raise WorkLimitError(f"a product of {len(left)} by {len(right)} terms is too large")
        return self.reduce(left * right)

    def rational(self, value: Rational) -> Fraction:
        """Embed a rational number."""
        number = fmpq(value.numerator, value.denominator)
        return Fraction(self.context.constant(number), self.one)

    def whole(self, polynomial: Polynomial) -> Fraction:
        """Embed a polynomial."""
        return Fraction(polynomial, self.one)

    def add(self, left: Fraction, right: Fraction) -> Fraction:
        """Add fractions over the least common denominator."""
        (a, b), (c, d) = left, right
        if b == d:
            return Fraction(a + c, b)
        if b == 1:
            return Fraction(self.times(a, d) + c, d)
        if d == 1:
            return Fraction(a + self.times(c, b), b)
        common = b.gcd(d)
        b_rest, d_rest = b // common, d // common
        return Fraction(self.times(a, d_rest) + self.times(c, b_rest), self.times(b, d_rest))

    def subtract(self, left: Fraction, right: Fraction) -> Fraction:
        """Subtract fractions."""
        return self.add(left, Fraction(-right.numerator, right.denominator))

    def multiply(self, left: Fraction, right: Fraction) -> Fraction:
        """Multiply fractions."""
        (a, b), (c, d) = left, right
        denominator = d if b == 1 else b if d == 1 else self.times(b, d)
        return Fraction(self.times(a, c), denominator)

    def invert(self, fraction: Fraction) -> Fraction:
        """Turn a fraction over; raises `UnsupportedError` for zero."""
        if fraction.numerator == 0:
            raise UnsupportedError("a denominator is identically zero")
        return Fraction(fraction.denominator, fraction.numerator)

    def power(self, fraction: Fraction, exponent: int) -> Fraction:
        """Raise to an integer power by repeated squaring."""
        if exponent < 0:
            fraction, exponent = self.invert(fraction), -exponent
        result = self.whole(self.one)
        while exponent:
            if exponent & 1:
                result = self.multiply(result, fraction)
            exponent >>= 1
            if exponent:
                fraction = self.multiply(fraction, fraction)
        return result
