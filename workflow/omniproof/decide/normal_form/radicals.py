"""Square roots and absolute values of formulas, with their signs under control.

An argument is factored into irreducibles b_j. Each |b_j| is e_j b_j with an unknown sign e_j,
e_j^2 = 1, and each sqrt|b_j| is a generator p_j with p_j^2 = e_j b_j. As the b_j are coprime and
square-free, these roots are independent: for fixed signs the ring is a field, and a formula is zero
exactly if its normal form is. Dependent radicals, sqrt(1 - c) sqrt(1 + c) = |s|, the conjugates of
which would have to be multiplied out otherwise, never arise. A root of a product needs the product
to be positive; that is a *requirement* on the signs, and outside of it there is nothing to prove.

Nested radicals go level by level: an argument that contains roots is factored in the ring of the
level below. As polynomials its factors are coprime, as numbers they may depend on each other: with
c^2 = a^2 + b^2 - 2 a b cos x, the area of a triangle has (a + b + c)(a + b - c) = 2 a b (1 + cos x)
under a root. So a factor that known ones complete to a product without roots is not new, but that
product divided by them. Where other relations between roots remain, a form that is not zero proves
nothing; one that is zero always does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction as Rational
from itertools import combinations
from typing import Any

from flint import fmpq

from omniproof.decide.normal_form.constant_field import square_free_part
from omniproof.decide.normal_form.quotient_ring import Fraction, Polynomial, QuotientRing
from omniproof.formula.errors import UnsupportedError, WorkLimitError

MOST_FACTORS = 24
MOST_CONJUGATES = 3  # an element over two roots has three others
MOST_MATES = 8
MOST_TERMS_OF_MATES = 2_000

SignOf = Callable[[Polynomial], int | None]


@dataclass(frozen=True)
class Factored:
    """A rational unit times powers of the factors of a basis (by place), times signs e_j."""

    unit: Any
    exponents: Mapping[int, int]
    flips: frozenset[int] = frozenset()

    @property
    def signed(self) -> frozenset[int]:
        """Places of the factors whose signs make up the sign of the product."""
        odd = frozenset(place for place, exponent in self.exponents.items() if exponent % 2)
        return odd ^ self.flips

    def times(self, other: Factored, power: int = 1) -> Factored:
        """Multiply by a power of another product."""
        exponents = dict(self.exponents)
        for place, exponent in other.exponents.items():
            exponents[place] = exponents.get(place, 0) + power * exponent
        kept = {place: exponent for place, exponent in exponents.items() if exponent}
        flips = other.flips if power % 2 else frozenset()
        return Factored(self.unit * other.unit**power, kept, self.flips ^ flips)


@dataclass(frozen=True)
class Requirement:
    """`sign` times the signs of the factors at `places` must be positive."""

    sign: int
    places: frozenset[int]


@dataclass
class Basis:
    """Coprime irreducible factors in one ring, with the sign of each where it is known.

    `ring` has generators p_j and e_j for the factors of the levels below: the arguments of nested
    radicals contain them. `independent` says that what has no root is zero as a function only if it
    is zero in the ring, so that one may divide by it.
    """

    ring: QuotientRing
    independent: bool = False
    sign_of: SignOf = lambda _: None
    factors: list[Polynomial] = field(default_factory=list)
    signs: list[int | None] = field(default_factory=list)
    requirements: list[Requirement] = field(default_factory=list)

    def factor(self, fraction: Fraction) -> Factored:
        """Write a fraction in factors, and add those that are new."""
        unit, above = self._in_roots(fraction.numerator).factor()
        divisor, below = self._in_roots(fraction.denominator).factor()
        result = Factored(unit / divisor, {})
        for direction, factors in ((1, above), (-1, below)):
            for polynomial, exponent in factors:
                result = result.times(self._irreducible(polynomial), direction * int(exponent))
        return result

    def factor_product(self, parts: Iterable[tuple[Fraction, int]]) -> Factored:
        """Factor powers of fractions one by one: over a number field, products hide factors."""
        result = Factored(fmpq(1), {})
        for fraction, power in parts:
            result = result.times(self.factor(fraction), power)
        return result

    def require_positive(self, factored: Factored) -> None:
        """Note that a root of this is printed."""
        self.requirements.append(Requirement(*self.sign(factored)))

    def sign(self, factored: Factored) -> tuple[int, frozenset[int]]:
        """Return the sign of a product: the known part, and the places of unknown signs."""
        sign = 1 if factored.unit > 0 else -1
        return self._known_part(sign, factored.signed)

    def settle(self) -> None:
        """Fix the signs that the requirements leave no choice for.

        Raises `UnsupportedError` when they contradict each other.
        """
        changed = True
        while changed:
            parts = [self._known_part(r.sign, r.places) for r in self.requirements]
            self.requirements = [Requirement(*part) for part in parts]
            changed = False
            for requirement in self.requirements:
                if len(requirement.places) == 1 and not changed:
                    (place,) = requirement.places
                    self.signs[place] = requirement.sign
                    changed = True
        if any(not part.places and part.sign < 0 for part in self.requirements):
            raise UnsupportedError("the root of a negative quantity is not real")

    def move(self, ring: QuotientRing) -> None:
        """Take the factors over to a ring with more generators."""
        known = {f"e{place}": sign for place, sign in enumerate(self.signs) if sign is not None}
        used = {name: sign for name, sign in known.items() if name in self.ring.place}
        self.factors = [ring.adopt(factor.subs(used)) for factor in self.factors]
        self.ring = ring

    def names(self) -> list[str]:
        """Name the generators: roots p_j of all factors, signs e_j of those that are open."""
        if len(self.factors) > MOST_FACTORS:
            raise WorkLimitError(f"radicals of more than {MOST_FACTORS} different factors")
        roots = [f"p{place}" for place in reversed(range(len(self.factors)))]
        return roots + [f"e{place}" for place, sign in enumerate(self.signs) if sign is None]

    def _known_part(self, sign: int, places: frozenset[int]) -> tuple[int, frozenset[int]]:
        for place in places:
            sign *= self.signs[place] or 1
        return sign, frozenset(place for place in places if self.signs[place] is None)

    def _in_roots(self, polynomial: Polynomial) -> Polynomial:
        """Write x as e p^2 beside a root p of it, so that squares like (1 + p)^2 show."""
        generators = list(self.ring.generators.values())
        degrees = polynomial.degrees()
        for place, factor in enumerate(self.factors):
            name, sign = f"p{place}", self.signs[place]
            has_root = name in self.ring.place and degrees[self.ring.place[name]]
            if has_root and sign and factor in generators:
                generators[generators.index(factor)] = sign * self.ring.generators[name] ** 2
        return polynomial.compose(*generators)

    def _irreducible(self, polynomial: Polynomial) -> Factored:
        """Write an irreducible polynomial in factors: a sign, a known or a new one, or a quotient.

        A quotient v/g by known factors g is sound for all choices of signs: v = f g is not zero
        as a function, so that g vanishes on no open set.
        """
        sign = self._place_of_sign(polynomial)
        if sign is not None:
            return Factored(fmpq(1), {}, frozenset({sign}))
        completed = None if polynomial in self.factors else self._without_roots(polynomial)
        if completed is None:
            return Factored(fmpq(1), {self._place(polynomial): 1})
        product, mates = completed
        result = self.factor(self.ring.whole(product))
        return result.times(Factored(fmpq(1), dict.fromkeys(mates, 1)), -1)

    def _without_roots(self, polynomial: Polynomial) -> tuple[Polynomial, tuple[int, ...]] | None:
        """Find known factors, by place, whose product with a polynomial over roots has no root."""
        if not self.independent or _is_plain(polynomial):
            return None
        mates = [k for k, known in enumerate(self.factors) if not _is_plain(known)][-MOST_MATES:]
        for count in range(1, MOST_CONJUGATES + 1):
            for places in combinations(mates, count):
                product = self._completed(polynomial, places)
                if product is not None:
                    return product, places
        return None

    def _completed(self, polynomial: Polynomial, places: Iterable[int]) -> Polynomial | None:
        """Multiply by factors; None where roots are left, or the product is zero or too long."""
        for place in places:
            if len(polynomial) * len(self.factors[place]) > MOST_TERMS_OF_MATES:
                return None
            polynomial = self.ring.times(polynomial, self.factors[place])
        return polynomial if polynomial != 0 and _is_plain(polynomial) else None

    def _place_of_sign(self, polynomial: Polynomial) -> int | None:
        for place in range(len(self.factors)):
            if polynomial == self.ring.generators.get(f"e{place}"):
                return place
        return None

    def _place(self, polynomial: Polynomial) -> int:
        if polynomial not in self.factors:
            self.factors.append(polynomial)
            self.signs.append(self.sign_of(polynomial))
        return self.factors.index(polynomial)


class Extension:
    """The roots and signs of a basis as elements of its ring, which has generators for them."""

    def __init__(self, basis: Basis, root: Callable[[Any], Fraction]) -> None:
        self.ring, self.basis, self.rational_root = basis.ring, basis, root
        self.factors = basis.factors
        self.signs = [self._sign(place) for place in range(len(self.factors))]
        for place, factor in enumerate(self.factors):
            generator = self.ring.generators[f"p{place}"]
            square = self.ring.times(self.signs[place], factor)
            self.ring.relate(f"p{place}", generator**2 - square)

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
        for place in factored.signed:
            result = self.ring.times(result, self.signs[place])
        return self.ring.whole(result)

    def _power(self, place: int, exponent: int) -> Fraction:
        """Return |b|^exponent, where 1/|b| is e/b."""
        sign = self.signs[place] if exponent % 2 else self.ring.one
        size = self.ring.power(self.ring.whole(self.factors[place]), abs(exponent)).numerator
        if exponent < 0:
            return Fraction(sign, size)
        return self.ring.whole(self.ring.times(sign, size))


def generators_of(polynomial: Polynomial) -> set[str]:
    """Name the generators that a polynomial contains."""
    names = polynomial.context().names()
    degrees = zip(names, polynomial.degrees(), strict=True)
    return {name for name, degree in degrees if degree}


def _is_plain(polynomial: Polynomial) -> bool:
    """Whether a polynomial has neither roots p_j, signs e_j nor nested constant roots w_j."""
    return not any(name.startswith(("p", "e", "w")) for name in generators_of(polynomial))


def _rational(value: Any) -> Rational:
    return Rational(int(value.p), int(value.q))


def primes_under_roots(factored: Factored) -> frozenset[int]:
    """Return the primes of which the unit of a radicand needs the roots."""
    return frozenset(square_free_part(_rational(abs(factored.unit)))[1])
