"""Rational points of a domain: small denominators, so that a reader can check a witness by hand.

The choice is seeded and depends on nothing but the symbols' names and their domain, so that a
ledger has the same bytes on every machine.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Any

import sympy as sp
from flint import fmpq

from omniproof.audit.balls import evaluate, exact_number
from omniproof.audit.sympy_domain import REALS, Domain
from omniproof.decide.balls import as_float, rational_ball, sign_of
from omniproof.formula.errors import UnsupportedError

MOST_TRIES = 60  # points tried for one at which all conditions hold
REACH = 6  # length of the interval in which an unbounded symbol is sampled, unless told
DENOMINATORS = range(3, 14)

Sample = dict[sp.Symbol, fmpq]


def sample_points(
    symbols: Iterable[sp.Symbol],
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
    ranges = _ranges(symbols, domain, reach)
    if not ranges and not domain.conditions:
        yield {}
        return
    generator = random.Random(seed)  # noqa: S311 - points, not secrets
    found = 0
    for _ in range((MOST_TRIES if domain.conditions else 1) * (count if ranges else 1)):
        point = {symbol: interval.draw(generator) for symbol, interval in ranges.items()}
        if not domain.conditions or _is_allowed(point, domain, generator):
            yield point
            found += 1
        if found == count:
            return


def _ranges(
    symbols: Iterable[sp.Symbol], domain: Domain, reach: int = REACH
) -> dict[sp.Symbol, _Range]:
    """Return where symbols are sampled, in the order of their names."""
    ranges = {}
    for symbol in sorted(symbols, key=by_name):
        known = symbol.assumptions0  # quicker than to ask for what is not known
        signs = known.get("nonnegative", False), known.get("nonpositive", False)
        ends = domain.interval(symbol.name)
        ranges[symbol] = _range(*map(exact_number, ends), *signs, reach)
    return ranges


def by_name(symbol: sp.Symbol) -> str:
    """Order symbols as points and witnesses list them."""
    return str(symbol.name)


def _is_allowed(point: Sample, domain: Domain, generator: random.Random) -> bool:
    """Whether the conditions certainly hold at a point; symbols that only they have are drawn."""
    missing = set().union(*(c.free_symbols for c in domain.conditions)) - point.keys()
    others = _ranges(missing, domain)
    full = point | {symbol: interval.draw(generator) for symbol, interval in others.items()}
    for condition in domain.conditions:
        known = sign_of(evaluate(condition.lhs - condition.rhs, full))
        if known is None or not condition.func(known, 0):
            return False
    return True


class _Range:
    """An open interval with exact end points, which are enclosed once for all draws."""

    def __init__(self, lower: Any, upper: Any) -> None:
        self.lower, self.upper = lower, upper
        self.low, self.high = evaluate(lower), evaluate(upper)
        if not self.low < self.high:
            raise UnsupportedError(f"the interval ({lower}, {upper}) is empty")
        self.left, self.right = as_float(self.low), as_float(self.high)

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
        raise UnsupportedError(f"no short rational was found in ({self.lower}, {self.upper})")


@lru_cache(maxsize=256)
def _range(lower: Any, upper: Any, nonnegative: bool, nonpositive: bool, reach: int) -> _Range:
    """Return the finite interval in which a symbol is sampled, from its sign and the domain."""
    if nonnegative:
        lower = sp.Max(lower, 0)
    if nonpositive:
        upper = sp.Min(upper, 0)
    if lower == -sp.oo:
        lower = sp.Integer(-reach) / 2 if upper == sp.oo else upper - reach
        upper = sp.Integer(reach) / 2 if upper == sp.oo else upper
    return _Range(lower, lower + reach if upper == sp.oo else upper)
