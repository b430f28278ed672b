"""What an engine answers, and over which domain it was asked.

"Not decided" is a value of the type: an engine neither raises nor guesses when it gives up.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

REAL_LINE = (-sp.oo, sp.oo)

Point = Mapping[str, str]
"""Symbol name -> rational number or decimal, as it is shown to a reader."""


@dataclass(frozen=True)
class Witness:
    """A point at which two sides differ, with a few digits of both values.

    `exact` holds coordinates that are no rational numbers, by name, as SymPy numbers.
    """

    point: Point
    printed: str
    derived: str
    exact: Mapping[str, Any] = field(default_factory=dict, compare=False, repr=False, kw_only=True)

    def __str__(self) -> str:
        """Write `alpha_1=2/7; printed=0.84; derived=-0.31`, the form of the ledger."""
        sides = {"printed": self.printed, "derived": self.derived}
        return "; ".join(f"{name}={value}" for name, value in (dict(self.point) | sides).items())


@dataclass(frozen=True)
class Proved:
    """The statement holds wherever both sides are defined."""

    engines: tuple[str, ...]
    note: str = ""


@dataclass(frozen=True)
class Refuted:
    """The statement is false; the witness shows it."""

    engines: tuple[str, ...]
    witness: Witness
    note: str = ""


@dataclass(frozen=True)
class OnBranch:
    """True exactly under `condition` (LaTeX); the witness shows that the condition is needed.

    `relations` are the same condition for programs: SymPy Booleans, all of which must hold.
    """

    engines: tuple[str, ...]
    condition: str
    witness: Witness
    note: str = ""
    relations: tuple[Any, ...] = ()


@dataclass(frozen=True)
class Undecided:
    """The engine gave up, and says why."""

    reason: str
    engines: tuple[str, ...] = ()


Answer = Proved | Refuted | OnBranch | Undecided


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
