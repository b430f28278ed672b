"""Rational points of a domain: small denominators, so that a reader can check a witness by hand.

The choice is seeded and depends on nothing but the symbols' names and their domain, so that a
ledger has the same bytes on every machine.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import lru_cache
from typing import TypeAlias

from flint import fmpq

from omniproof.decide.balls import as_float, enclose, format_ball, rational_ball
from omniproof.decide.domain import REALS, Domain
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.term import Term, add, number, subtract, symbols

MOST_TRIES = 60  # points tried for one at which all conditions hold
REACH = 6  # length of the interval in which an unbounded symbol is sampled, unless told
DENOMINATORS = range(3, 14)

Sample: TypeAlias = dict[str, fmpq]


def sample_points(
    names: Iterable[str],
    domain: Domain = REALS,
    *,
    count: int = 40,
    seed: int = 0,
    reach: int = REACH,
) -> Iterator[Sample]:
    """Yield up to `count` rational points inside the domain; one empty point without symbols.

    Unbounded symbols lie in an interval of length `reach`.
    Raises `UnsupportedError` when an interval is empty or its end points are not numbers.
    """
    ranges = _ranges(names, domain, reach)
    if not ranges and not domain.positive:
        yield {}
        return
    generator = random.Random(seed)  # noqa: S311 - points, not secrets
    found = 0
    for _ in range((MOST_TRIES if domain.positive else 1) * (count if ranges else 1)):
        point = {name: interval.draw(generator) for name, interval in ranges.items()}
        if not domain.positive or _is_allowed(point, domain, generator):
            yield point
            found += 1
        if found == count:
            return


def _ranges(names: Iterable[str], domain: Domain, reach: int = REACH) -> dict[str, _Range]:
    """Return where symbols are sampled, in the order of their names."""
    return {name: _range(*domain.range(name), reach) for name in sorted(names)}


def _is_allowed(point: Sample, domain: Domain, generator: random.Random) -> bool:
    """Whether the conditions certainly hold at a point; symbols that only they have are drawn."""
    missing = set().union(*map(symbols, domain.positive)) - point.keys()
    others = _ranges(missing, domain)
    full = point | {name: interval.draw(generator) for name, interval in others.items()}
    return all(enclose(condition, full) > 0 for condition in domain.positive)


class _Range:
    """An open interval with exact end points, which are enclosed once for all draws."""

    def __init__(self, lower: Term, upper: Term) -> None:
        self.low, self.high = enclose(lower), enclose(upper)
        if not self.low < self.high:
            raise UnsupportedError(f"the interval {self} is empty")
        self.left, self.right = as_float(self.low), as_float(self.high)

    def __str__(self) -> str:
        return f"({format_ball(self.low)}, {format_ball(self.high)})"

    def draw(self, generator: random.Random) -> fmpq:
        """Pick a rational that is certain to lie strictly inside; zero is avoided."""
        left, right = self.left, self.right
        denominator = generator.choice(DENOMINATORS)
        while denominator < 2**40:
            numerator = generator.randint(int(left * denominator) - 1, int(right * denominator) + 1)
            value = fmpq(numerator, denominator)
            if numerator and self.low < rational_ball(value) < self.high:
                return value
            denominator += 1 if (right - left) * denominator > 4 else denominator
        raise UnsupportedError(f"no short rational was found in {self}")


@lru_cache(maxsize=256)
def _range(lower: Term | None, upper: Term | None, reach: int) -> _Range:
    """Return the finite interval in which a symbol is sampled."""
    width = number(reach)
    if lower is None:
        lower = number(Fraction(-reach, 2)) if upper is None else subtract(upper, width)
    return _Range(lower, add(lower, width) if upper is None else upper)
