"""A domain in SymPy, as the engines of order ask for it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

REAL_LINE = (-sp.oo, sp.oo)


@dataclass(frozen=True)
class Domain:
    """Intervals of symbols, by symbol name; a symbol that is not named is any real number.

    End points are exact SymPy numbers (`pi/2`, not 1.57). `conditions` are SymPy inequalities
    between the symbols that hold as well. `closed` tells for (lower, upper) which ends belong to an
    interval; without it, none does.
    """

    intervals: Mapping[str, tuple[Any, Any]] = field(default_factory=dict)
    conditions: tuple[Any, ...] = ()
    closed: Mapping[str, tuple[bool, bool]] = field(default_factory=dict)

    def interval(self, name: str) -> tuple[Any, Any]:
        """Return the ends between which a symbol lies."""
        return self.intervals.get(name, REAL_LINE)


REALS = Domain()
