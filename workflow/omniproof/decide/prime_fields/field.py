"""Prime fields of 127 bits in which angles have a place: p = 1 modulo the order of a root of unity.

In such a field there is an element zeta that behaves as e^(2 pi i / order), so that cosines of
rational multiples of pi, the imaginary unit and square roots of integers (as Gauss sums of zeta,
hence with the right sign) exist at once and agree with each other. Plain integers of Python: the
point of a second engine is that it shares no arithmetic with the first.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import count
from random import Random

BITS = 127
ROUNDS = 64
"""Rounds of Miller-Rabin: a composite passes them with probability below 4^-64 < 10^-38."""


@dataclass(frozen=True)
class PrimeField:
    """The integers modulo `prime`, with `zeta` in the place of e^(2 pi i / order)."""

    prime: int
    order: int
    zeta: int

    def unit(self, numerator: int, denominator: int) -> int:
        """Return e^(i pi numerator/denominator); twice the denominator divides the order."""
        steps = self.order // (2 * denominator)
        return pow(self.zeta, numerator * steps % self.order, self.prime)

    def inverse(self, value: int) -> int:
        """Return 1/value; raises `ZeroDivisionError` for zero."""
        if value % self.prime == 0:
            raise ZeroDivisionError("zero has no inverse")
        return pow(value, -1, self.prime)

    def root_of_prime(self, number: int) -> int:
        """Return the square root of a small prime that is positive as a sum of roots of unity.

        Gauss: sum over k of e^(2 pi i k^2 / q) is sqrt(q) or i sqrt(q), as q is 1 or 3 modulo 4.
        """
        if number == 2:
            return (self.unit(1, 4) + self.unit(-1, 4)) % self.prime
        total = sum(self.unit(2 * k * k, number) for k in range(number))
        return total * (1 if number % 4 == 1 else self.unit(-1, 2)) % self.prime

    def square_root(self, value: int) -> int | None:
        """Return one of the two square roots, or None where there is none (Tonelli, Shanks)."""
        prime, value = self.prime, value % self.prime
        if value == 0:
            return 0
        if pow(value, (prime - 1) // 2, prime) != 1:
            return None
        twos = ((prime - 1) & (1 - prime)).bit_length() - 1
        odd = (prime - 1) >> twos
        root, rest = pow(value, (odd + 1) // 2, prime), pow(value, odd, prime)
        step = pow(self._non_residue(), odd, prime)
        while rest != 1:
            squarings, power = 0, rest
            while power != 1:
                power, squarings = power * power % prime, squarings + 1
            factor = pow(step, 1 << (twos - squarings - 1), prime)
            step, twos = factor * factor % prime, squarings
            root, rest = root * factor % prime, rest * step % prime
        return root

    def _non_residue(self) -> int:
        return next(k for k in count(2) if pow(k, (self.prime - 1) // 2, self.prime) != 1)


@lru_cache(maxsize=1024)
def prime_field(order: int, number: int) -> PrimeField:
    """Return the field of the given number (0, 1, ...) for an order; the same in every run."""
    random = Random(f"prime field {order} {number}")  # noqa: S311 - reproducible, not secret
    low, high = -(-(1 << (BITS - 1)) // order), ((1 << BITS) - 1) // order
    while True:
        prime = random.randrange(low, high) * order + 1
        if is_prime(prime, random):
            return PrimeField(prime, order, _root_of_unity(prime, order, random))


def is_prime(number: int, random: Random) -> bool:
    """Test an odd number above 200 by small factors, then by Miller-Rabin with random bases."""
    if any(number % small == 0 for small in _SMALL):
        return False
    twos = ((number - 1) & (1 - number)).bit_length() - 1
    odd = (number - 1) >> twos
    return all(_passes(number, random.randrange(2, number - 1), odd, twos) for _ in range(ROUNDS))


def _passes(number: int, base: int, odd: int, twos: int) -> bool:
    value = pow(base, odd, number)
    if value in (1, number - 1):
        return True
    for _ in range(twos - 1):
        value = value * value % number
        if value == number - 1:
            return True
    return False


def _root_of_unity(prime: int, order: int, random: Random) -> int:
    while True:
        zeta = pow(random.randrange(2, prime), (prime - 1) // order, prime)
        if all(pow(zeta, order // factor, prime) != 1 for factor in prime_factors(order)):
            return zeta


def prime_factors(number: int) -> dict[int, int]:
    """Factor a positive integer by trial division, prime -> exponent."""
    found: dict[int, int] = {}
    divisor = 2
    while divisor * divisor <= number:
        while number % divisor == 0:
            number //= divisor
            found[divisor] = found.get(divisor, 0) + 1
        divisor += 1
    if number > 1:
        found[number] = found.get(number, 0) + 1
    return found


_SMALL = tuple(q for q in range(3, 200, 2) if all(q % k for k in range(3, q, 2)))
