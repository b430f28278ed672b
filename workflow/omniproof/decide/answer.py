"""What an engine answers.

"Not decided" is a value of the type: an engine neither raises nor guesses when it gives up.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

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


class DisagreementError(RuntimeError):
    """Engines contradict each other: a defect of one of them, never of a formula."""


Answer = Proved | Refuted | OnBranch | Undecided
