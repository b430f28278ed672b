"""Is a number built from nested square roots zero?  Conjugates and a root-separation bound.

Nested constants such as sqrt(5 + 2 sqrt(6)) are kept as generators w with w^2 = radicand, although
they may depend on each other (this one is sqrt(2) + sqrt(3)). An apparent zero F is then proved as
follows. The product of (T - F') over all sign choices F' of the roots, taken from the outermost
root inwards, is a polynomial T^m Q(T) over the base field with Q(0) != 0, and F is one of its
zeros. A non-zero one is at least |Q(0)| / (|Q(0)| + max |coefficient of Q|) in size (Cauchy's
bound), so a ball of F below that bound leaves only F = 0.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from flint import arb, ctx, fmpq

from omniproof.decide.balls import Ball
from omniproof.decide.normal_form.quotient_ring import Polynomial, QuotientRing
from omniproof.formula.errors import UnsupportedError, WorkLimitError

PRECISIONS = (128, 1_024, 8_192)
MOST_ROOTS = 7


@dataclass(frozen=True)
class Constants:
    """The numbers of a ring: names of all constant generators, and the roots among them.

    The outermost root comes first. `balls` encloses the generators, at the current precision.
    """

    ring: QuotientRing
    names: frozenset[str]
    roots: Sequence[str]
    balls: Callable[[], Mapping[str, Ball]]

    def coefficients(self, polynomial: Polynomial) -> dict[tuple[int, ...], Polynomial]:
        """Split a polynomial by the monomials in its variables; the coefficients are constants."""
        places = frozenset(self.ring.place[name] for name in self.names)
        parts: dict[tuple[int, ...], dict[tuple[int, ...], object]] = {}
        for exponents, coefficient in polynomial.to_dict().items():
            outer = tuple(0 if place in places else e for place, e in enumerate(exponents))
            inner = tuple(e if place in places else 0 for place, e in enumerate(exponents))
            parts.setdefault(outer, {})[inner] = coefficient
        return {outer: self.ring.context.from_dict(part) for outer, part in parts.items()}

    def vanishes(self, polynomial: Polynomial) -> bool:
        """Decide whether a reduced polynomial is zero; its coefficients may be nested roots."""
        if polynomial == 0 or not self.roots:
            return bool(polynomial == 0)
        return all(self.is_zero(part) for part in self.coefficients(polynomial).values())

    def enclose(self, polynomial: Polynomial, balls: Mapping[str, Ball]) -> Ball:
        """Enclose a polynomial in the constant generators.

        Raises `UnsupportedError` for sines of numbers like 2, which no separation bound covers.
        """
        names = polynomial.context().names()
        total = arb(0)
        for exponents, coefficient in polynomial.terms():
            term = arb(fmpq(coefficient))
            for name, exponent in zip(names, exponents, strict=True):
                if exponent and name not in balls:
                    raise UnsupportedError("a root of the sine or cosine of a number is not read")
                if exponent:
                    term = term * balls[name] ** int(exponent)
            total = total + term
        return total

    def is_zero(self, polynomial: Polynomial) -> bool:
        """Decide whether a polynomial in the constant generators is the number zero."""
        if polynomial == 0:
            return True
        used = [name for name in self.roots if polynomial.degrees()[self.ring.place[name]]]
        if not used:
            return False
        norm: list[Polynomial] = []
        for precision in PRECISIONS:
            with ctx.workprec(precision):
                balls = self.balls()
                value = self.enclose(polynomial, balls)
                if not value.contains(0):
                    return False
                norm = norm or _characteristic(self.ring, polynomial, self.roots)
                if self._below_bound(value, norm, balls):
                    return True
        raise UnsupportedError("a constant is too small to be told from zero")

    def sign(self, polynomial: Polynomial) -> int:
        """Return the sign of a polynomial in the constant generators: -1, 0 or 1."""
        for precision in PRECISIONS:
            with ctx.workprec(precision):
                value = self.enclose(polynomial, self.balls())
                if not value.contains(0):
                    return 1 if value > 0 else -1
            if precision == PRECISIONS[0] and self.is_zero(polynomial):
                return 0
        raise UnsupportedError("a constant is too small for its sign to be told")

    def _below_bound(
        self, value: Ball, norm: Sequence[Polynomial], balls: Mapping[str, Ball]
    ) -> bool:
        sizes = [abs(self.enclose(coefficient, balls)) for coefficient in norm]
        if sizes[0].contains(0):
            return False
        largest = max((size.upper() for size in sizes[1:]), default=arb(0))
        return bool(abs(value) < sizes[0] / (sizes[0] + largest))


def _characteristic(
    ring: QuotientRing, polynomial: Polynomial, roots: Sequence[str]
) -> list[Polynomial]:
    """Return the coefficients of Q, where T^m Q is the product of T - F' over all sign choices.

    The lowest comes first, and is not zero. `roots` go from the outermost to the innermost:
    conjugating one leaves no trace of it, and the radicands of the others do not mention it.
    """
    product = [-polynomial, ring.one]
    used = 0
    for root in roots:
        if not any(part.degrees()[ring.place[root]] for part in product):
            continue
        used += 1
        if used > MOST_ROOTS:
            raise WorkLimitError(f"more than {MOST_ROOTS} nested roots in one constant")
        product = _multiply(ring, product, [_conjugate(ring, part, root) for part in product])
    first = next(place for place, coefficient in enumerate(product) if coefficient != 0)
    return product[first:]


def _conjugate(ring: QuotientRing, polynomial: Polynomial, root: str) -> Polynomial:
    """Change the sign of one root."""
    place = ring.place[root]
    terms = polynomial.to_dict().items()
    return ring.context.from_dict({e: -c if e[place] % 2 else c for e, c in terms})


def _multiply(
    ring: QuotientRing, left: Sequence[Polynomial], right: Sequence[Polynomial]
) -> list[Polynomial]:
    product = [ring.zero] * (len(left) + len(right) - 1)
    for i, a in enumerate(left):
        for j, b in enumerate(right):
            product[i + j] = product[i + j] + ring.times(a, b)
    return product
