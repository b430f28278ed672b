r"""A numbered equation as a whole: how its parts stand together, and what to calculate with.

A paper's claims are the parts of an equation: a vector, a factor, a matrix. `<eq:6>` in a display
stands for what that claim prints, or for what it ought to; what is between is verbatim.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

PART = re.compile(r"<([a-z]+:[^<>]+)>")


@dataclass(frozen=True)
class Line:
    """One formula of an equation.

    `display`: LaTeX with `<claims>` in it. `value`: the claims whose product the formula gives, in
    their order (by default, the only one of the display), over the claim `per`, if any. `call`: a
    call of `function` to try it with; `name`: of what is calculated, where there is no function.
    """

    display: str
    value: tuple[str, ...] = ()
    per: str = ""
    function: Callable[..., Any] | None = None
    call: str = ""
    name: str = ""

    @property
    def claims(self) -> tuple[str, ...]:
        """Return the claims of the display, in order."""
        return tuple(PART.findall(self.display))

    @property
    def factors(self) -> tuple[str, ...]:
        """Return the claims whose product the formula gives."""
        return self.value or (self.claims if len(self.claims) == 1 else ())

    def filled(self, write: Callable[[str], str]) -> str:
        """Return the display with every claim written out."""
        return PART.sub(lambda found: write(found[1]), self.display)


@dataclass(frozen=True)
class Answer:
    """What to use for an equation: `why` is the reason for its fault, in a sentence."""

    title: str
    lines: tuple[Line, ...]
    why: str = ""

    @property
    def claims(self) -> frozenset[str]:
        """Return all claims that it is made of."""
        used = (claim for line in self.lines for claim in (*line.claims, *line.value, line.per))
        return frozenset(filter(None, used))


Answers: TypeAlias = Mapping[str, Answer]
"""Equation, or another place with a formula, -> its answer."""
