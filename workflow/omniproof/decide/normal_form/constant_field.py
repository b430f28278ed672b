"""The number field of an expression: cosines of rational angles and square roots of rationals.

All cosines and sines of multiples of pi/N live in the real field Q(g), g = 2 cos(pi/N), N even:
2 cos(k pi/N) is a Chebyshev polynomial in g. So do the roots of the primes that divide 2N once N is
raised to the conductor of these roots; they are Gauss sums there (Ireland & Rosen, A Classical
Introduction to Modern Number Theory, 6.4). The root of any other prime p ramifies at p and Q(g)
does not, so these roots are independent generators: what is not zero here is not zero at all.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction as Rational
from math import lcm

from flint import arb, fmpz, fmpz_poly

from omniproof.decide.balls import Ball
from omniproof.decide.normal_form.quotient_ring import Fraction, Polynomial, QuotientRing
from omniproof.formula.errors import WorkLimitError

LARGEST_ORDER = 1_440
SMOOTH_BITS = 17
"""Prime factors of so many bits are found; what is left counts as one prime."""


def square_free_part(value: Rational) -> tuple[Rational, tuple[int, ...]]:
    """Write a positive rational as q^2 times a product of distinct primes: (q, primes)."""
    scale, primes = Rational(1, value.denominator), []
    for prime, exponent in fmpz(value.numerator * value.denominator).factor_smooth(SMOOTH_BITS):
        scale *= Rational(int(prime)) ** (int(exponent) // 2)
        if exponent % 2:
            primes.append(int(prime))
    return scale, tuple(sorted(primes))


def field_order(order: int, primes: Iterable[int]) -> int:
    """Raise N until the roots of those primes that divide 2N lie in Q(2 cos(pi/N))."""
    order = lcm(order, 2)
    if 2 in primes:
        order = lcm(order, 4)
    for prime in primes:
        if order % prime == 0 and prime % 4 == 3:
            order = lcm(order, 2 * prime)
    if order > LARGEST_ORDER:
        raise WorkLimitError(f"angles in steps of pi/{order} are finer than pi/{LARGEST_ORDER}")
    return order


def generator_names(order: int, primes: Iterable[int]) -> list[str]:
    """Name the generators of the field, the highest first."""
    free = [f"r{prime}" for prime in sorted(set(primes)) if (2 * order) % prime]
    return free + (["g"] if order > 2 else [])


class ConstantField:
    """Cosines, sines and square roots as elements of a ring that has the named generators."""

    def __init__(self, ring: QuotientRing, order: int, primes: Iterable[int]) -> None:
        self.ring, self.order = ring, order
        self.names = generator_names(order, primes)
        self.g = ring.generators["g"] if order > 2 else ring.zero
        self.cosines = [ring.context.constant(2), self.g]
        if order > 2:
            ring.relate("g", _minimal_polynomial(2 * order, self.g, ring))
        for name in self.names:
            if name != "g":
                ring.relate(name, ring.generators[name] ** 2 - int(name[1:]))

    def cosine(self, turns: Rational) -> Polynomial:
        """Return cos(turns * pi)."""
        steps = abs(int(turns * self.order)) % (2 * self.order)
        steps = min(steps, 2 * self.order - steps)
        if 2 * steps > self.order:
            return -self._half(self.order - steps)
        return self._half(steps)

    def sine(self, turns: Rational) -> Polynomial:
        """Return sin(turns * pi)."""
        return self.cosine(Rational(1, 2) - turns)

    def root_of_prime(self, prime: int) -> Polynomial:
        """Return the positive square root of a prime."""
        if (2 * self.order) % prime:
            return self.ring.generators[f"r{prime}"]
        if prime == 2:
            return 2 * self.cosine(Rational(1, 4))
        wave = self.cosine if prime % 4 == 1 else self.sine
        legendre = (int(fmpz(k).jacobi(prime)) for k in range(1, prime))
        waves = (wave(Rational(2 * k, prime)) for k in range(1, prime))
        return sum((e * w for e, w in zip(legendre, waves, strict=True)), self.ring.zero)

    def root(self, value: Rational) -> Fraction:
        """Return the square root of a positive rational."""
        scale, primes = square_free_part(value)
        result = self.ring.rational(scale)
        for prime in primes:
            result = self.ring.multiply(result, self.ring.whole(self.root_of_prime(prime)))
        return result

    def balls(self) -> dict[str, Ball]:
        """Enclose the generators at the current precision."""
        values = {name: arb(int(name[1:])).sqrt() for name in self.names if name != "g"}
        return values | {"g": 2 * (arb.pi() / self.order).cos()}

    def _half(self, steps: int) -> Polynomial:
        while len(self.cosines) <= steps:
            latest = self.ring.times(self.g, self.cosines[-1]) - self.cosines[-2]
            self.cosines.append(latest)
        return self.cosines[steps] / 2


def _minimal_polynomial(conductor: int, g: Polynomial, ring: QuotientRing) -> Polynomial:
    """Return the minimal polynomial of 2 cos(2 pi / conductor), at g."""
    value = ring.zero
    for coefficient in reversed(fmpz_poly.cos_minpoly(conductor).coeffs()):
        value = value * g + int(coefficient)
    return value
