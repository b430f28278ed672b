"""The second engine: a formula at random points of random prime fields.

Modulo a prime p = 1 (mod N) the unit circle is full of points: e^(iu) is any non-zero z, with
sin u = (z - 1/z)/2i and cos u = (z + 1/z)/2. An identity is zero there; a formula that is none is
zero with a probability of at most degree/p (Schwartz, Zippel; the coefficients are too small to
vanish modulo more than a few of the primes). So a value other than zero refutes, and zeros prove
with a stated bound. Polynomials, balls and factors, on which the first engine rests, do not occur.

Roots and absolute values have squares modulo p, and no sign: all sign patterns are tried. Those
that no real point can have are left out: what is never negative has no product that is a negative
constant. If the rest agrees, that is the answer; else the truth depends on signs (`Mixed`).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import combinations, product
from math import gcd

from omniproof.decide.prime_fields.field import BITS
from omniproof.decide.prime_fields.growth import Bounds
from omniproof.decide.prime_fields.parts import (
    Parts,
    constants_of_angles,
    even_powers,
    is_plainly_positive,
    signed_terms,
)
from omniproof.decide.prime_fields.point import NoRootError, RandomPoint
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.term import Call, Power, Sum, Symbol, Term, add, symbols

WANTED = 1e-30
ATTEMPTS = 256
MOST_ROOTS, MOST_ELEMENTS, LONGEST_PRODUCT, LARGEST_RATIO = 6, 9, 5, 12


@dataclass(frozen=True)
class Zero:
    """Zero wherever it is defined; `bound` is on the probability that this is wrong."""

    bound: float


@dataclass(frozen=True)
class NonZero:
    """Not zero, neither at this point of the field with `prime` elements nor identically."""

    prime: int
    point: Mapping[str, int]


@dataclass(frozen=True)
class Mixed:
    """Zero for `vanishing` of the `patterns` of signs that are possible: it depends on these."""

    vanishing: int
    patterns: int


@dataclass(frozen=True)
class Unsupported:
    """Not tested, and why."""

    reason: str


ModularAnswer = Zero | NonZero | Mixed | Unsupported


def vanishes(
    term: Term, nonnegative: Sequence[Term] = (), positive: Collection[str] = ()
) -> ModularAnswer:
    """Test whether a term is zero wherever it is defined and others are not negative.

    `positive` names the symbols that are not negative, as `nonnegative` does terms.
    """
    try:
        return _Test(term, nonnegative, positive).answer()
    except UnsupportedError as reason:
        return Unsupported(str(reason))
    except RecursionError:
        return Unsupported("the formula is nested too deeply")


class _Test:
    def __init__(self, term: Term, nonnegative: Sequence[Term], positive: Collection[str]) -> None:
        self.term, self.positive = term, positive
        self.parts = Parts()
        self.parts.note([term, *nonnegative])
        self.same = self._spellings()
        self.roots = list(dict.fromkeys(self.same.values()))
        if len(self.roots) > MOST_ROOTS:
            raise UnsupportedError(f"it has more than {MOST_ROOTS} roots and absolute values")
        self.elements = self._elements(nonnegative) if self.roots else []
        self.patterns = list(product((1, -1), repeat=len(self.roots)))

    def answer(self) -> ModularAnswer:
        """Look at as many points as the wanted bound takes."""
        bound = 1.0
        for point, values in self._points():
            vanishing, patterns = values.count(0), len(values)
            if 0 < vanishing < patterns:
                return Mixed(vanishing, patterns)
            if not vanishing:
                return self._refuted(point)
            bound *= self.bound
            if bound < WANTED:
                return Zero(bound)
        raise UnsupportedError(
            f"fewer than the wanted number of {ATTEMPTS} points were fit for a test"
        )

    def _spellings(self) -> dict[Call, Call]:
        """Return for each root the first one that has its value: they are one number.

        What is printed in two spellings is one root where the radicands agree at a random point.
        Radicands that have roots inside are one only where they are written alike.
        """
        point = RandomPoint(self.parts, ATTEMPTS)
        point.choose({}, {})
        first: dict[object, Call] = {}
        same: dict[Call, Call] = {}
        for term in self.parts.roots:
            # By the square: |a - b|, |b - a| and sqrt((a - b)^2) are one number.
            square = term.parts[0] if term.function == "sqrt" else Power(term.parts[0], 2)
            key = _fingerprint(square, point)
            same[term] = first.setdefault(key, term)
        return same

    def _two_sides(self) -> list[Term]:
        """Collect the terms that cannot be negative, and those that cannot be positive.

        What stands on both sides of an equation tells nothing: it is left out.
        """
        point = RandomPoint(self.parts, ATTEMPTS)
        point.choose(dict.fromkeys(self.roots, 1), self.same)
        sides: dict[int, dict[object, Term]] = {1: {}, -1: {}}
        for sign, part in signed_terms(self.term):
            if is_plainly_positive(part, self.positive):
                self.parts.note([part])
                value = _fingerprint(part, point)
                if sides[-sign].pop(value, None) is None:
                    sides[sign][value] = part
        return [add(*side.values()) for side in sides.values() if len(side) > 1]

    def _refuted(self, point: RandomPoint) -> ModularAnswer:
        if self.parts.unknown:
            return Unsupported(
                f"relations of {', '.join(sorted(self.parts.unknown))} are not known"
            )
        return NonZero(point.field.prime, point.coordinates())

    def _points(self) -> Iterator[tuple[RandomPoint, list[int]]]:
        """Yield points where everything is defined, with the values for all possible signs."""
        for attempt in range(ATTEMPTS):
            point = RandomPoint(self.parts, attempt)
            try:
                values = [self._at(point, signs) for signs in self.patterns]
            except (ZeroDivisionError, NoRootError):
                continue
            yield point, self._possible(point, values)

    @staticmethod
    def _possible(point: RandomPoint, values: list[tuple[int, list[int]]]) -> list[int]:
        """Keep the values for signs that can be; all of them where they say the same."""
        vanishing = sum(value == 0 for value, _ in values)
        if vanishing in (0, len(values)):
            return [value for value, _ in values]
        possible = [value for value, elements in values if not _contradicts(point, elements)]
        if not possible:
            raise UnsupportedError("no signs of its roots are possible: it is nowhere defined")
        return possible

    def _at(self, point: RandomPoint, signs: tuple[int, ...]) -> tuple[int, list[int]]:
        point.choose(dict(zip(self.roots, signs, strict=True)), self.same)
        return point.value(self.term), [point.value(element) for element in self.elements]

    def _elements(self, nonnegative: Sequence[Term]) -> list[Term]:
        """Collect what is never negative, the most telling first."""
        sums = [term for term in self.parts.inside if isinstance(term, Sum)]
        sides = self._two_sides()
        found = [
            *self.roots,
            *nonnegative,
            *sides,
            *(Symbol(name) for name in sorted(self.positive) if name in symbols(self.term)),
            *(each for each in sums if is_plainly_positive(each, self.positive)),
            *constants_of_angles(self.parts),
            *even_powers([self.term]),
        ]
        chosen = list(dict.fromkeys(found))[:MOST_ELEMENTS]
        self.parts.note(chosen)
        return chosen

    @cached_property
    def bound(self) -> float:
        """Bound the probability that one point misleads.

        The norm over all sign patterns is a polynomial with the degree and bits of the formula
        times their number. It vanishes at a random point with probability degree/p, and modulo at
        most bits * order / 126 of the primes, of which there are about 2^126/(88 order). The same
        holds for each product that is compared with a constant. `ATTEMPTS` points may be looked at.
        """
        bounds = Bounds(self.parts)
        growths = [bounds.of(self.term)]
        ratios = 0
        if self.elements:
            found = [bounds.of(element) for element in self.elements]
            growths += [growth.power(LONGEST_PRODUCT) for growth in found]
            ratios = len(_products(len(found))) * LARGEST_RATIO**2
        degree = max(max(growth.degree, growth.below) for growth in growths) + 1
        bits = max(max(growth.bits, growth.bits_below) for growth in growths) + 8
        each = len(self.patterns) * (degree + bits * self.parts.order**2)
        bound = ATTEMPTS * (1 + ratios) * each / 2.0 ** (BITS - 1)
        if bound >= WANTED ** (1 / 8):
            raise UnsupportedError("its degree is too large for a useful bound")
        return float(bound)


def _fingerprint(term: Term, point: RandomPoint) -> object:
    """Return what tells a term from others of another value; itself where it has none here."""
    try:
        return point.value(term)
    except (KeyError, ZeroDivisionError, NoRootError):
        return term


@lru_cache
def _products(count: int) -> tuple[tuple[tuple[int, int], ...], ...]:
    """Return products of elements and inverses: tuples of (place, exponent), the first one 1."""
    return tuple(
        tuple(zip(places, (1, *exponents), strict=True))
        for size in range(1, LONGEST_PRODUCT + 1)
        for places in combinations(range(count), size)
        for exponents in product((1, -1), repeat=size - 1)
    )


@lru_cache(maxsize=64)
def _negative_ratios(prime: int) -> frozenset[int]:
    numbers = range(1, LARGEST_RATIO + 1)
    return frozenset(
        -above * pow(below, -1, prime) % prime
        for above, below in product(numbers, numbers)
        if gcd(above, below) == 1
    )


def _contradicts(point: RandomPoint, elements: Sequence[int]) -> bool:
    """Whether a product of what is never negative is a negative constant: these signs cannot be."""
    negative, prime = _negative_ratios(point.prime), point.prime
    # What is zero, or written twice, tells nothing more.
    elements = [element for element in dict.fromkeys(elements) if element]
    inverses = [point.field.inverse(element) for element in elements]
    for factors in _products(len(elements)):
        total = 1
        for index, exponent in factors:
            total = total * (elements[index] if exponent > 0 else inverses[index]) % prime
        if total in negative:
            return True
    return False
