"""Square roots and absolute values of formulas, with their signs under control.

An argument is factored into irreducibles b_j. Each |b_j| is e_j b_j with an unknown sign e_j,
e_j^2 = 1, and each sqrt|b_j| is a generator p_j with p_j^2 = e_j b_j. As the b_j are coprime and
square-free, these roots are independent: for fixed signs the ring is a field, and a formula is zero
exactly if its normal form is. Dependent radicals, sqrt(1 - c) sqrt(1 + c) = |s|, the conjugates of
which would have to be multiplied out otherwise, never arise. A root of a product needs the product
to be positive; that is a *requirement* on the signs, and outside of it there is nothing to prove.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from omniproof.audit.constant_field import square_free_part
from omniproof.audit.quotient_ring import Fraction, Polynomial, QuotientRing

SignOf = Callable[[Polynomial], int | None]


@dataclass(frozen=True)
class Factored:
    """A rational unit times powers of the factors of a basis (by place)."""

    unit: Any
    exponents: Mapping[int, int]

    @property
    def odd(self) -> frozenset[int]:
        """Places of the factors with odd exponents."""
        return frozenset(place for place, exponent in self.exponents.items() if exponent % 2)


@dataclass(frozen=True)
class Requirement:
    """`sign` times the signs of the factors at `places` must be positive."""

    sign: int
    places: frozenset[int]


@dataclass
class Basis:
    """Coprime irreducible factors, with the sign of each where it is known."""

    sign_of: SignOf
    factors: list[Polynomial] = field(default_factory=list)
    signs: list[int | None] = field(default_factory=list)
    requirements: list[Requirement] = field(default_factory=list)

    def factor(self, fraction: Fraction) -> Factored:
        """Write a fraction in factors, and add those that are new."""
        numerator, denominator = fraction
        unit, above = numerator.factor()
        divisor, below = denominator.factor()
        exponents: dict[int, int] = {}
        for direction, factors in ((1, above), (-1, below)):
            for polynomial, exponent in factors:
                place = self._place(polynomial)
                exponents[place] = exponents.get(place, 0) + direction * int(exponent)
        kept = {place: exponent for place, exponent in exponents.items() if exponent}
        return Factored(unit / divisor, kept)

    def require_positive(self, factored: Factored) -> None:
        """Note that a root of this is printed."""
        sign, places = self.sign(factored)
        self.requirements.append(Requirement(sign, places))

    def sign(self, factored: Factored) -> tuple[int, frozenset[int]]:
        """Return the sign of a product: the known part, and the places of unknown signs."""
        sign = 1 if factored.unit > 0 else -1
        for place in factored.odd:
            sign *= self.signs[place] or 1
        return sign, frozenset(place for place in factored.odd if self.signs[place] is None)

    def settle(self) -> None:
        """Fix the signs that the requirements leave no choice for."""
        changed = True
        while changed:
            changed = False
            for place, requirement in enumerate(self.requirements):
                sign, unknown = requirement.sign, set(requirement.places)
                for known in [p for p in unknown if self.signs[p] is not None]:
                    sign *= self.signs[known] or 1
                    unknown.discard(known)
                self.requirements[place] = Requirement(sign, frozenset(unknown))
                if len(unknown) == 1:
                    self.signs[unknown.pop()] = sign
                    changed = True

    def _place(self, polynomial: Polynomial) -> int:
        if polynomial not in self.factors:
            self.factors.append(polynomial)
            self.signs.append(self.sign_of(polynomial))
        return self.factors.index(polynomial)

    def names(self) -> list[str]:
        """Name the generators: roots p_j of all factors, signs e_j of those that are open."""
        roots = [f"p{place}" for place in range(len(self.factors))]
        return roots + [f"e{place}" for place, sign in enumerate(self.signs) if sign is None]


class Extension:
    """The roots and signs of a basis as elements of a ring that has their generators."""

    def __init__(self, ring: QuotientRing, basis: Basis, root: Callable[[Any], Fraction]) -> None:
        self.ring, self.basis, self.rational_root = ring, basis, root
        self.factors = [factor.project_to_context(ring.context) for factor in basis.factors]
        self.signs = [self._sign(place) for place in range(len(self.factors))]
        for place, factor in enumerate(self.factors):
            generator = ring.generators[f"p{place}"]
            ring.relate(f"p{place}", generator**2 - ring.reduce(self.signs[place] * factor))

    def _sign(self, place: int) -> Polynomial:
        known = self.basis.signs[place]
        if known is not None:
            return self.ring.context.constant(known)
        sign = self.ring.generators[f"e{place}"]
        self.ring.relate(f"e{place}", sign**2 - 1)
        return sign

    def root(self, factored: Factored) -> Fraction:
        """Return the square root of a product of factors."""
        result = self.rational_root(_rational(abs(factored.unit)))
        for place, exponent in factored.exponents.items():
            result = self.ring.multiply(result, self._power(place, exponent // 2))
            if exponent % 2:
                generator = self.ring.whole(self.ring.generators[f"p{place}"])
                result = self.ring.multiply(result, generator)
        return result

    def absolute(self, factored: Factored) -> Fraction:
        """Return the absolute value of a product of factors."""
        result = self.ring.rational(abs(_rational(factored.unit)))
        for place, exponent in factored.exponents.items():
            result = self.ring.multiply(result, self._power(place, exponent))
        return result

    def sign(self, factored: Factored) -> Fraction:
        """Return the sign of a product of factors."""
        result = self.ring.context.constant(1 if factored.unit > 0 else -1)
        for place in factored.odd:
            result = self.ring.times(result, self.signs[place])
        return self.ring.whole(result)

    def _power(self, place: int, exponent: int) -> Fraction:
        """Return |b|^exponent, where 1/|b| is e/b."""
        sign = self.signs[place] if exponent % 2 else self.ring.one
        size = self.ring.power(self.ring.whole(self.factors[place]), abs(exponent)).numerator
        if exponent < 0:
            return Fraction(sign, size)
        return self.ring.whole(self.ring.times(sign, size))


def _rational(value: Any) -> sp.Rational:
    return sp.Rational(int(value.p), int(value.q))


def primes_under_roots(factored: Factored) -> frozenset[int]:
    """Return the primes of which the unit of a radicand needs the roots."""
    return frozenset(square_free_part(_rational(abs(factored.unit)))[1])
