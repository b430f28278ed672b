"""A random point of a prime field: values of letters and units there, and of every term."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from math import prod
from random import Random
from typing import Any

from omniproof.decide.prime_fields.field import PrimeField, prime_field
from omniproof.decide.prime_fields.parts import Parts, radicand_primes
from omniproof.formula.angle import circular
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.monomials import Monomial
from omniproof.formula.term import Call, Number, Power, Product, Sum, Symbol, Term, rational


class NoRootError(ValueError):
    """A radicand has no square root in the field."""


class RandomPoint:
    """A prime field and random values of letters and units there."""

    def __init__(self, parts: Parts, attempt: int) -> None:
        self.parts = parts
        self.field: PrimeField = prime_field(parts.order, attempt)
        self.prime = self.field.prime
        random = Random(f"point {attempt} of {self.prime}")  # noqa: S311 - reproducible
        self.known: dict[Term, int] = {
            letter: random.randrange(1, self.prime) for letter in parts.letters
        }
        self.units: dict[Monomial, int] = {
            atom: random.randrange(1, self.prime)
            for atom in parts.denominators
            if atom not in parts.turned
        }
        self.square_roots: dict[int, int] = {}
        self.signs: Mapping[Call, int] = {}
        self.same: Mapping[Call, Call] = {}
        self.memo: dict[Term, int] = {}

    def choose(self, signs: Mapping[Call, int], same: Mapping[Call, Call]) -> None:
        """Choose the signs of roots and absolute values; `same` gives the one to look at."""
        self.signs, self.same, self.memo = signs, same, dict(self.known)

    def coordinates(self) -> dict[str, int]:
        """Name the values of symbols, for a reader who wants to see the point."""
        return {item.name: value for item, value in self.known.items() if isinstance(item, Symbol)}

    def value(self, term: Term) -> int:
        """Evaluate; raises `ZeroDivisionError` and `NoRootError`."""
        found = self.memo.get(term)
        if found is None:
            found = self.memo[term] = self._compute(term) % self.prime
        return found

    def _compute(self, term: Term) -> int:
        return _RULES[type(term)](self, term)

    def _sum(self, term: Sum) -> int:
        return sum(map(self.value, term.terms))

    def _product(self, term: Product) -> int:
        return reduce(lambda a, b: a * b % self.prime, map(self.value, term.factors), 1)

    def _number(self, term: Number) -> int:
        above, below = term.value.numerator, term.value.denominator
        return above * (1 if below == 1 else self.field.inverse(below))

    def _call(self, term: Call) -> int:
        (argument,) = term.arguments
        if term.function in CIRCULAR:
            return self._circular(term.function, argument)
        if term.function == "sign":
            size = self.value(Call("abs", (argument,)))
            return size * self.field.inverse(self.value(argument))
        same = self.same.get(term, term)
        if same is not term:
            return self.value(same)
        if term.function == "abs":
            return self.signs[term] * self.value(argument)
        return self._root(term, argument)

    def _power(self, base: int, exponent: int) -> int:
        return pow(base if exponent >= 0 else self.field.inverse(base), abs(exponent), self.prime)

    def _circular(self, function: str, argument: Term) -> int:
        z = self._turned(argument)
        back = self.field.inverse(z)
        twice_cosine, twice_sine = z + back, (z - back) * self.field.unit(-1, 2)
        above, below = circular(function, 2, twice_cosine, twice_sine)
        return above * self.field.inverse(below)

    def _turned(self, argument: Term) -> int:
        """Return e^(i argument)."""
        angle = self.parts.angles[argument]
        z = self.field.unit(angle.turns.numerator, angle.turns.denominator)
        for atom, ratio in angle.multiples.items():
            steps = int(ratio * self.parts.denominators[atom])
            z = z * self._power(self._unit(atom), steps) % self.prime
        return z

    def _unit(self, atom: Monomial) -> int:
        """Return e^(i atom/denominator)."""
        if atom in self.units:
            return self.units[atom]
        if self.parts.denominators[atom] != 1:
            raise NoRootError  # the half of an inverse function
        cosine, sine = map(self.value, self.parts.turned[atom])
        return (cosine + sine * self.field.unit(1, 2)) % self.prime

    def _root(self, term: Call, radicand: Term) -> int:
        number = rational(radicand)
        if number is not None:
            return self._root_of_rational(number)
        square = self.value(radicand)
        if square not in self.square_roots:
            found = self.field.square_root(square)
            if found is None:
                raise NoRootError
            self.square_roots[square] = found
        return self.signs[term] * self.square_roots[square]

    def _root_of_rational(self, number: Fraction) -> int:
        if number == 0:
            return 0
        return prod(
            self._power(self.field.root_of_prime(prime), exponent)
            for prime, exponent in radicand_primes(number).items()
        )


_RULES: dict[type[Term], Callable[[RandomPoint, Any], int]] = {
    Number: lambda point, term: point._number(term),
    Sum: lambda point, term: point._sum(term),
    Product: lambda point, term: point._product(term),
    Power: lambda point, term: point._power(point.value(term.base), term.exponent),
    Call: lambda point, term: point._call(term),
}
"""Values of parts; letters have theirs from the start."""
