"""Trigonometric functions as algebra: two charts of the circle.

An angle is a rational combination of *atoms* (symbols, products such as omega*t, anything real)
plus a rational multiple of pi. With u = atom / (common denominator), every sine and cosine is a
polynomial in the points (cos u, sin u) of the circle. Atoms are linearly independent over Q, so
these points are algebraically independent of each other, and of the atoms themselves: a symbol may
stand inside and outside of a sine.

`CircleChart` keeps (c, s) with s^2 = 1 - c^2: no denominators, fast, right where no radicals are.
`TangentChart` uses t = tan(u/2). Its polynomials factor uniquely (those on the circle do not:
s s = (1 - c)(1 + c)), which is what taking square roots and absolute values needs.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction as Rational
from functools import reduce
from typing import TypeAlias

from omniproof.decide.normal_form.constant_field import ConstantField
from omniproof.decide.normal_form.quotient_ring import Polynomial, QuotientRing
from omniproof.formula.angle import Angle, angle_of
from omniproof.formula.errors import WorkLimitError
from omniproof.formula.monomials import Monomial
from omniproof.formula.term import Number, Term

LARGEST_MULTIPLE = 120

ONE_ITSELF: Monomial = frozenset()


def read_angle(argument: Term) -> Angle:
    """Split the argument of a trigonometric function into atoms and a multiple of pi."""
    multiples, turns = angle_of(argument)
    size = multiples.get(ONE_ITSELF, Rational(0))
    if abs(size.numerator) > LARGEST_MULTIPLE:  # an angle of its own, not so many times another
        multiples[frozenset({(Number(size), 1)})] = Rational(1)
        del multiples[ONE_ITSELF]
    return Angle(multiples, turns)


Point: TypeAlias = tuple[Polynomial, Polynomial, Polynomial]
"""(C, S, D) with cos = C/D and sin = S/D; the later multiples of a point follow it in a list."""


class CircleChart:
    """Generators c_k, s_k = cos, sin of atom_k / denominator_k."""

    def __init__(
        self, ring: QuotientRing, constants: ConstantField, denominators: Mapping[Monomial, int]
    ) -> None:
        self.ring, self.constants, self.denominators = ring, constants, denominators
        self.multiples: dict[Monomial, list[Point]] = {}
        for place, atom in enumerate(denominators):
            cosine, sine = ring.generators[f"c{place}"], ring.generators[f"s{place}"]
            ring.relate(f"s{place}", sine**2 + cosine**2 - 1)
            self.multiples[atom] = [(cosine, sine, ring.one)]

    @staticmethod
    def names(count: int) -> list[str]:
        """Name the generators of `count` atoms, the highest first."""
        return [f"s{place}" for place in range(count)] + [f"c{place}" for place in range(count)]

    def cosine_sine(self, angle: Angle) -> Point:
        """Return (C, S, D) with cos = C/D and sin = S/D, by de Moivre's formula."""
        parts = [
            self._multiple(atom, int(factor * self.denominators[atom]))
            for atom, factor in angle.multiples.items()
        ]
        if angle.turns or not parts:
            cosine, sine = self.constants.cosine(angle.turns), self.constants.sine(angle.turns)
            parts.append((cosine, sine, self.ring.one))
        return reduce(self._turn, parts)

    def _multiple(self, atom: Monomial, count: int) -> Point:
        """Return the point of a multiple of atom / denominator."""
        if abs(count) > LARGEST_MULTIPLE:
            raise WorkLimitError(f"{count} times an angle is more than {LARGEST_MULTIPLE} times")
        known = self.multiples[atom]
        while len(known) < abs(count):
            known.append(self._turn(known[-1], known[0]))
        cosine, sine, denominator = known[abs(count) - 1]
        return cosine, sine if count > 0 else -sine, denominator

    def _turn(self, one: Point, other: Point) -> Point:
        """Add the angles of two points."""
        (cosine, sine, denominator), (c, s, d) = one, other
        times = self.ring.times
        return times(cosine, c) - times(sine, s), times(cosine, s) + times(sine, c), denominator * d


class TangentChart(CircleChart):
    """Generators t_k = tan(atom_k / (2 denominator_k)); cos = (1 - t^2)/(1 + t^2)."""

    def __init__(
        self, ring: QuotientRing, constants: ConstantField, denominators: Mapping[Monomial, int]
    ) -> None:
        self.ring, self.constants, self.denominators = ring, constants, denominators
        self.multiples = {}
        for place, atom in enumerate(denominators):
            t = ring.generators[f"t{place}"]
            self.multiples[atom] = [(1 - t**2, 2 * t, 1 + t**2)]

    @staticmethod
    def names(count: int) -> list[str]:
        """Name the generators of `count` atoms."""
        return [f"t{place}" for place in range(count)]
