"""What the table says of functions, as terms: derivatives, domains, angles."""

from __future__ import annotations

from functools import lru_cache
from typing import TypeAlias

from omniproof.formula.term import Symbol, Term, substitute
from omniproof.formula.unfold import unfold
from omniproof.formula.value import Comparison, Value
from omniproof.transcription.functions import CIRCULAR, FUNCTIONS, Lacks
from omniproof.transcription.reader import read

__all__ = ["ANGLES", "CIRCULAR", "FUNCTIONS", "Lacks", "Point", "angle", "derivatives", "domain"]

Point: TypeAlias = tuple[Term, Term]
"""Cosine and sine of an angle."""
ANGLES = frozenset(name for name, row in FUNCTIONS.items() if row.angle)
"""Functions that are angles."""


def derivatives(function: str, *arguments: Term) -> tuple[Term, ...] | Lacks:
    """Return the derivatives by each argument, or why there are none."""
    row = FUNCTIONS.get(function)
    found = row.derivative if row else Lacks("it is no function of the table")
    if isinstance(found, Lacks):
        return found
    return tuple(_of(_meaning(text), arguments) for text in found)


def domain(function: str, *arguments: Term) -> tuple[Comparison, ...]:
    """Return the conditions under which a function is defined."""
    conditions = map(_meaning, FUNCTIONS[function].domain)
    return tuple(
        Comparison(_of(c.left, arguments), c.operator, _of(c.right, arguments)) for c in conditions
    )


def angle(function: str, *arguments: Term) -> Point:
    """Return cosine and sine of an angle that is a value of one of `ANGLES`."""
    cosine, sine = map(_meaning, FUNCTIONS[function].angle or ())
    return _of(cosine, arguments), _of(sine, arguments)


def _of(term: Term, arguments: tuple[Term, ...]) -> Term:
    return substitute(term, dict(zip("xy", arguments, strict=False)))


@lru_cache
def _meaning(text: str) -> Value:
    return unfold(read(text, symbols="xy"), {"x": Symbol("x"), "y": Symbol("y")}, text)
