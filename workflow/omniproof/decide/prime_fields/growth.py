"""How far the numerator of a term can grow: what the probability of a wrong "zero" rests on."""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from typing import NamedTuple

from omniproof.decide.prime_fields.parts import Parts
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.term import Call, Number, Power, Product, Sum, Term


class Growth(NamedTuple):
    """Degrees, and bits of the sum of sizes of coefficients, of numerator and denominator."""

    degree: float
    below: float
    bits: float
    bits_below: float

    def times(self, other: Growth) -> Growth:
        """Bound a product."""
        return Growth(*(mine + its for mine, its in zip(self, other, strict=True)))

    def power(self, exponent: int) -> Growth:
        """Bound a power; the inverse for a negative exponent."""
        parts = self if exponent >= 0 else (self.below, self.degree, self.bits_below, self.bits)
        return Growth(*(abs(exponent) * part for part in parts))

    def root(self) -> Growth:
        """Bound a square root, written as sqrt(numerator * denominator) / denominator."""
        return Growth(
            (self.degree + self.below) / 2, self.below,
            (self.bits + self.bits_below) / 2, self.bits_below,
        )  # fmt: skip


NOTHING = Growth(0, 0, 0, 0)


def sum_of(parts: Iterable[Growth]) -> Growth:
    """Bound a sum, written over the product of all denominators."""
    parts = list(parts)
    below, bits_below = sum(part.below for part in parts), sum(part.bits_below for part in parts)
    degree = max(part.degree - part.below for part in parts) + below
    bits = max(part.bits - part.bits_below for part in parts) + bits_below
    return Growth(degree, below, bits + len(parts).bit_length(), bits_below)


class Bounds:
    """Growth of terms with the given parts."""

    def __init__(self, parts: Parts) -> None:
        self.parts, self.known = parts, dict[Term, Growth]()

    def of(self, term: Term) -> Growth:
        """Bound a term as a fraction of polynomials."""
        if term not in self.known:
            self.known[term] = self._compute(term)
        return self.known[term]

    def _compute(self, term: Term) -> Growth:
        match term:
            case Number(value=value):
                return Growth(0, 0, value.numerator.bit_length(), value.denominator.bit_length())
            case Sum(terms=parts):
                return sum_of(map(self.of, parts))
            case Product(factors=parts):
                return reduce(Growth.times, map(self.of, parts), NOTHING)
            case Power(base=base, exponent=exponent):
                return self.of(base).power(exponent)
            case Call(function=function, arguments=parts) if term not in self.parts.letters:
                return self._function(function, parts[0])
        return NOTHING._replace(degree=1)

    def _function(self, function: str, argument: Term) -> Growth:
        if function in CIRCULAR:
            return self._circular(argument)
        inside = self.of(argument)
        if function == "sqrt":
            return inside.root()
        return inside.times(inside.power(-1)) if function == "sign" else inside

    def _circular(self, argument: Term) -> Growth:
        """Bound (z^n + z^-n)/2 and the like by polynomials of degree 2n over 2 z^n."""
        parts, total = self.parts, Growth(0, 0, 1, 1)
        for atom, factor in parts.angles[argument].multiples.items():
            steps = 2 * abs(int(factor * parts.denominators[atom]))
            each = NOTHING._replace(degree=1)
            if atom in parts.turned:
                each = sum_of(map(self.of, parts.turned[atom]))
            total = total.times(Growth(steps * each.degree, steps * (each.below or each.degree),
                                       steps * each.bits, steps * each.bits_below))  # fmt: skip
        return total
