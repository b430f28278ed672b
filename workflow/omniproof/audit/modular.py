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

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import combinations, product
from math import gcd, prod
from random import Random

import sympy as sp

from omniproof.audit.modular_parts import (
    CIRCULAR,
    Bounds,
    OutsideError,
    Parts,
    Root,
    is_plainly_positive,
    parts_of,
    radicand_primes,
    root_level,
    sign_of_constant,
)
from omniproof.decide.prime_fields.field import BITS, PrimeField, prime_field

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


def vanishes_modulo(formula: sp.Expr, non_negative: Sequence[sp.Expr] = ()) -> ModularAnswer:
    """Test whether a formula is zero wherever it is defined and the others are not negative."""
    try:
        return _Test(formula, non_negative).answer()
    except OutsideError as reason:
        return Unsupported(str(reason))
    except RecursionError:
        return Unsupported("the formula is nested too deeply")


class _Test:
    def __init__(self, formula: sp.Expr, non_negative: Sequence[sp.Expr]) -> None:
        self.formula = formula
        self.parts = parts_of([formula, *non_negative])
        if self.parts.roots:
            non_negative = [*non_negative, *_two_sides(formula)]
            self.parts = parts_of([formula, *non_negative])
        if len(self.parts.roots) > MOST_ROOTS:
            raise OutsideError(f"it has more than {MOST_ROOTS} roots and absolute values")
        self.elements = self._elements(non_negative) if self.parts.roots else []
        self.patterns = list(product((1, -1), repeat=len(self.parts.roots)))

    def answer(self) -> ModularAnswer:
        """Look at as many points as the wanted bound takes."""
        bound = 1.0
        for place, values in self._places():
            vanishing, patterns = values.count(0), len(values)
            if 0 < vanishing < patterns:
                return Mixed(vanishing, patterns)
            if not vanishing:
                return self._refuted(place)
            bound *= self.bound
            if bound < WANTED:
                return Zero(bound)
        raise OutsideError(f"fewer than the wanted number of {ATTEMPTS} points were fit for a test")

    def _refuted(self, place: _Place) -> ModularAnswer:
        if self.parts.unknown:
            names = ", ".join(sorted(map(str, self.parts.unknown)))
            return Unsupported(f"relations of {names} are not known")
        return NonZero(place.field.prime, place.point())

    def _places(self) -> Iterator[tuple[_Place, list[int]]]:
        """Yield places where everything is defined, with the values for all possible signs."""
        for attempt in range(ATTEMPTS):
            place = _Place(self.parts, attempt)
            try:
                values = [self._at(place, signs) for signs in self.patterns]
            except (ZeroDivisionError, _NoRootError):
                continue
            yield place, self._possible(place, values)

    @staticmethod
    def _possible(place: _Place, values: list[tuple[int, list[int]]]) -> list[int]:
        """Keep the values for signs that can be; all of them where they say the same."""
        vanishing = sum(value == 0 for value, _ in values)
        if vanishing in (0, len(values)):
            return [value for value, _ in values]
        possible = [value for value, elements in values if not _contradicts(place, elements)]
        if not possible:
            raise OutsideError("no signs of its roots are possible: it is nowhere defined")
        return possible

    def _at(self, place: _Place, signs: tuple[int, ...]) -> tuple[int, list[int]]:
        place.choose(dict(zip(self.parts.roots, signs, strict=True)))
        return place.value(self.formula), [place.element(element) for element in self.elements]

    def _elements(self, non_negative: Sequence[sp.Expr]) -> list[sp.Expr | Root]:
        """Collect what is never negative, the most telling first."""
        parts = self.parts
        symbols = [letter for letter in parts.letters if letter.is_nonnegative]
        fractions = {angle.turns for angle in parts.angles.values() if 2 % angle.turns.denominator}
        turns = [sp.Rational(f.numerator, f.denominator) for f in sorted(fractions)]
        constants = [f(t * sp.pi, evaluate=False) for t in turns for f in (sp.cos, sp.sin)]
        signed = [sign_of_constant(c) * c for c in constants if sign_of_constant(c)]
        for constant in signed:
            parts.angles |= parts_of([constant]).angles
        sums = [each for each in parts.sums if is_plainly_positive(each)]
        squares = [power for power in parts.powers if power.exp.is_even]
        found = [*parts.roots, *non_negative, *sums, *symbols, *signed, *squares]
        return list(dict.fromkeys(found))[:MOST_ELEMENTS]

    @cached_property
    def bound(self) -> float:
        """Bound the probability that one place misleads.

        The norm over all sign patterns is a polynomial with the degree and bits of the formula
        times their number. It vanishes at a random point with probability degree/p, and modulo at
        most bits * order / 126 of the primes, of which there are about 2^126/(88 order). The same
        holds for each product that is compared with a constant. `ATTEMPTS` places may be looked at.
        """
        bounds = Bounds(self.parts)
        growths = [bounds.of(self.formula)]
        ratios = 0
        if self.elements:
            found = [bounds.of(_formula(element)) for element in self.elements]
            growths += [growth.power(LONGEST_PRODUCT) for growth in found]
            ratios = len(_products(len(found))) * LARGEST_RATIO**2
        degree = max(max(growth.degree, growth.below) for growth in growths) + 1
        bits = max(max(growth.bits, growth.bits_below) for growth in growths) + 8
        each = len(self.patterns) * (degree + bits * self.parts.order**2)
        bound = ATTEMPTS * (1 + ratios) * each / 2.0 ** (BITS - 1)
        if bound >= WANTED ** (1 / 8):
            raise OutsideError("its degree is too large for a useful bound")
        return float(bound)


def _two_sides(formula: sp.Expr) -> list[sp.Expr]:
    """Collect the terms of a sum that cannot be negative, and the negatives of others likewise."""
    terms = [sp.Mul(*sp.Mul.make_args(term)) for term in sp.Add.make_args(formula)]
    terms = sp.Add.make_args(sp.Add(*terms))
    sides = (
        [term * sign for term in terms if is_plainly_positive(term * sign)] for sign in (1, -1)
    )
    return [sp.Add(*side) for side in sides if len(side) > 1]


def _formula(element: sp.Expr | Root) -> sp.Expr:
    """Write a root as what it is a root of: its growth is no less."""
    return element[0] if isinstance(element, tuple) else element


class _NoRootError(ValueError):
    """A radicand has no square root in the field."""


class _Place:
    """A prime field and random values of letters and units there."""

    def __init__(self, parts: Parts, attempt: int) -> None:
        self.parts = parts
        self.field: PrimeField = prime_field(parts.order, attempt)
        self.prime = self.field.prime
        random = Random(f"point {attempt} of {self.prime}")  # noqa: S311 - reproducible
        draw = {key: random.randrange(1, self.prime) for key in sorted(parts.letters, key=str)}
        self.known: dict[sp.Expr, int] = draw
        self.units = {
            key: random.randrange(1, self.prime) for key in sorted(parts.denominators, key=str)
        }
        self.square_roots: dict[int, int] = {}
        self.signs: Mapping[Root, int] = {}
        self.memo: dict[sp.Expr, int] = {}

    def choose(self, signs: Mapping[Root, int]) -> None:
        """Choose the signs of roots and absolute values."""
        self.signs, self.memo = signs, dict(self.known)

    def point(self) -> dict[str, int]:
        """Name the values of symbols, and of e^(iu) for the atoms u of angles."""
        units = {
            f"exp(i*{atom}/{self.parts.denominators[atom]})": value
            for atom, value in self.units.items()
        }
        return {str(letter): value for letter, value in self.known.items()} | units

    def element(self, element: sp.Expr | Root) -> int:
        """Return the value of a formula or of a root."""
        return self._root(element) if isinstance(element, tuple) else self.value(element)

    def value(self, node: sp.Expr) -> int:
        """Evaluate; raises `ZeroDivisionError` and `_NoRootError`."""
        found = self.memo.get(node)
        if found is None:
            found = self.memo[node] = self._compute(node) % self.prime
        return found

    def _compute(self, node: sp.Expr) -> int:
        if node.is_Rational:
            return int(node.p) * (1 if node.q == 1 else self.field.inverse(int(node.q)))
        if node.is_Add:
            return sum(map(self.value, node.args))
        if node.is_Mul:
            return self._product(node)
        if node.is_Pow:
            level = root_level(node)
            base = self._root((node.base, level)) if level else self.value(node.base)
            return self._power(base, int(node.exp.p))
        return self._function(node)

    def _function(self, node: sp.Expr) -> int:
        if isinstance(node, CIRCULAR):
            return self._circular(node)
        size = self._root((node.args[0], 0))
        if isinstance(node, sp.sign):
            return size * self.field.inverse(self.value(node.args[0]))
        return size

    def _product(self, node: sp.Expr) -> int:
        total = 1
        for factor in node.args:
            total = total * self.value(factor) % self.prime
        return total

    def _power(self, base: int, exponent: int) -> int:
        return pow(base if exponent > 0 else self.field.inverse(base), abs(exponent), self.prime)

    def _circular(self, node: sp.Expr) -> int:
        z = self._turned(node.args[0])
        back = self.field.inverse(z)
        twice_cosine, twice_sine = z + back, (z - back) * self.field.unit(-1, 2)
        half = (self.prime + 1) // 2
        inverse = self.field.inverse
        match node:
            case sp.cos():
                return twice_cosine * half
            case sp.sin():
                return twice_sine * half
            case sp.tan():
                return twice_sine * inverse(twice_cosine)
            case sp.cot():
                return twice_cosine * inverse(twice_sine)
            case sp.sec():
                return 2 * inverse(twice_cosine)
        return 2 * inverse(twice_sine)

    def _turned(self, argument: sp.Expr) -> int:
        """Return e^(i argument)."""
        angle = self.parts.angles[argument]
        z = self.field.unit(angle.turns.numerator, angle.turns.denominator)
        for atom, ratio in angle.multiples.items():
            steps = int(ratio * self.parts.denominators[atom])
            z = z * pow(self.units[atom], steps, self.prime) % self.prime
        return z

    def _root(self, root: Root) -> int:
        base, level = root
        if level == 0:
            return self.signs[root] * self.value(base) % self.prime
        if level == 1 and base.is_Rational:
            return self._root_of_rational(base)
        square = self._root((base, level - 1)) if level > 1 else self.value(base)
        if square not in self.square_roots:
            found = self.field.square_root(square)
            if found is None:
                raise _NoRootError
            self.square_roots[square] = found
        return self.signs[root] * self.square_roots[square] % self.prime

    def _root_of_rational(self, number: sp.Rational) -> int:
        factors = (
            self._power(self.field.root_of_prime(prime), exponent)
            for prime, exponent in radicand_primes(number).items()
        )
        return prod(factors) % self.prime


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


def _contradicts(place: _Place, elements: Sequence[int]) -> bool:
    """Whether a product of what is never negative is a negative constant: these signs cannot be."""
    if not elements or 0 in elements:
        return False
    negative, prime = _negative_ratios(place.prime), place.prime
    inverses = [place.field.inverse(element) for element in elements]
    for factors in _products(len(elements)):
        total = 1
        for index, exponent in factors:
            total = total * (elements[index] if exponent > 0 else inverses[index]) % prime
        if total in negative:
            return True
    return False
