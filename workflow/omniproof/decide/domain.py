"""The points that an equation is asserted at, beside those at which it is not defined.

What is continuous and holds inside of a range holds at its ends, so a domain has no ends of its
own: ranges are open, and conditions strict.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeAlias

from omniproof.decide.exact import sign
from omniproof.formula.term import ZERO, Term

Range: TypeAlias = tuple[Term | None, Term | None]
"""Exact lower and upper end; None where there is none."""
REAL_LINE: Range = (None, None)
POSITIVE: Range = (ZERO, None)


@dataclass(frozen=True)
class Domain:
    """Ranges of symbols, by name, and terms that are positive as well.

    A symbol that is not named is any real number.
    """

    ranges: Mapping[str, Range] = field(default_factory=dict)
    positive: tuple[Term, ...] = ()

    def range(self, name: str) -> Range:
        """Return the ends between which a symbol lies."""
        return self.ranges.get(name, REAL_LINE)

    @cached_property
    def nonnegative(self) -> frozenset[str]:
        """Names of the symbols that are not negative."""
        lower = ((name, low) for name, (low, _) in self.ranges.items() if low is not None)
        return frozenset(name for name, low in lower if sign(low) >= 0)

    @cached_property
    def nonpositive(self) -> frozenset[str]:
        """Names of the symbols that are not positive."""
        upper = ((name, high) for name, (_, high) in self.ranges.items() if high is not None)
        return frozenset(name for name, high in upper if sign(high) <= 0)

    @cached_property
    def signs(self) -> frozenset[tuple[str, str]]:
        """Pairs of a name and how the symbol stands to 0."""
        signed = self.nonnegative | self.nonpositive
        known = {"\\geq": self.nonnegative, "\\leq": self.nonpositive, "\\neq": signed}
        return frozenset((name, sign) for sign, names in known.items() for name in names)

    @property
    def is_orthant(self) -> bool:
        """Whether nothing is said but that some symbols are positive."""
        known = REAL_LINE, POSITIVE
        return not self.positive and all(ends in known for ends in self.ranges.values())


REALS = Domain()
