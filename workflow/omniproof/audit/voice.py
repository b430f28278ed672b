"""Direct evaluation of what a claim prints, held against what is derived for it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, lru_cache
from itertools import islice
from typing import Any

from sympy import Integral

from omniproof.audit.answer import Answer
from omniproof.audit.context import Context
from omniproof.audit.digits import DIGITS
from omniproof.audit.direct import (
    Place,
    Statement,
    entry_of,
    heard,
    known_side,
    places,
    printed_side,
)
from omniproof.formula.evaluation import Function, evaluate
from omniproof.transcription.tree import Node

MOST_PLACES = 12
"""Enough for three that count: papers print what is defined almost everywhere."""
IN_INTEGRALS = 1, 30
"""Of integrals in integrals, so many places and digits take a tenth of a second."""


class Voice:
    """Evaluates the printed parts of one claim, at points of its domain."""

    def __init__(self, claim: str, context: Context) -> None:
        self.claim, self.context = claim, context
        known = cache(lambda node: evaluate(node, context.meanings_at(claim, node)))
        self.side = cache(lambda node: printed_side(node, known))

    def equal(self, answer: Answer, printed: Node, index: tuple[int, ...], derived: Any) -> Answer:
        """Ask about an answer on a printed side and what it should be; raises as `heard` does.

        Of a matrix, about the entry at a printed index, which counts from 1.
        """
        row, column = (*index, 1, 1)[:2]
        side = entry_of(self.side(printed), (row - 1, column - 1))
        symbols = self._symbols(printed).union(derived.free_symbols)
        most, digits = IN_INTEGRALS if derived.has(Integral) else (MOST_PLACES, DIGITS)
        statement = Statement(((side, "=", known_side(derived)),), digits)
        return heard(answer, statement, lambda: islice(self._places(symbols), most))

    def _symbols(self, printed: Node) -> frozenset[Any]:
        """Collect what the printed symbols are expressions in."""
        meanings = self.context.meanings_at(self.claim, printed).values()
        values = (known.value if isinstance(known, Function) else known for known in meanings)
        return frozenset().union(*(getattr(value, "free_symbols", ()) for value in values))

    def _places(self, symbols: frozenset[Any]) -> Iterator[Place]:
        """Yield points; claims on one domain share them, and what has been evaluated there."""
        domain = self.context.domain(self.claim)
        shared = _shared_places(self.context, repr(domain), self.claim)
        others = symbols - self.context.variables
        if not others:
            yield from shared
            return
        for place, more in zip(shared, places(others, domain), strict=False):
            yield Place({**place, **more})


@lru_cache(maxsize=8)
def _shared_places(context: Context, _domain: str, claim: str) -> list[Place]:
    found = places(context.variables, context.domain(claim))
    return list(islice(found, MOST_PLACES))
