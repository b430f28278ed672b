"""Direct evaluation of what a claim prints, held against what is derived for it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache, lru_cache
from itertools import islice, pairwise, product
from typing import Any, TypeAlias

from mpmath import mp
from sympy import Integral, ilcm

from omniproof.audit.context import Context
from omniproof.decide.answer import Answer, Refuted, Witness
from omniproof.decide.digits import DIGITS, Value, are_equal
from omniproof.decide.direct import Place, Statement, entry_of, heard, is_true, printed_side
from omniproof.decide.in_sympy.digits import is_met, known_side, known_value, places_in
from omniproof.decide.order.hypotheses import with_box
from omniproof.formula.evaluation import Function, evaluate
from omniproof.transcription.tree import Name, Node, children

MOST_PLACES = 12
"""Enough for three that count: papers print what is defined almost everywhere."""
IN_INTEGRALS = 1, 30
"""Of integrals in integrals, so many places and digits take a tenth of a second."""
Box: TypeAlias = Mapping[Any, tuple[Any, Any]]


class Voice:
    """Evaluates the printed parts of one claim, at points of its domain; raises as `heard` does."""

    def __init__(self, claim: str, context: Context) -> None:
        self.claim, self.context, self.domain = claim, context, context.domain(claim)
        value = cache(lambda node: evaluate(node, context.meanings_at(claim, node)))
        self.side = cache(
            lambda node: printed_side(
                node, lambda symbol: known_side(value(symbol)), lambda name: str(value(Name(name)))
            )
        )

    def equal(self, answer: Answer, printed: Node, index: tuple[int, ...], derived: Any) -> Answer:
        """Ask about an answer on a printed side and what it should be.

        Of a matrix, about the entry at a printed index, which counts from 1.
        """
        row, column = (*index, 1, 1)[:2]
        side = entry_of(self.side(printed), (row - 1, column - 1))
        symbols = self._symbols(printed).union(derived.free_symbols)
        most, digits = IN_INTEGRALS if derived.has(Integral) else (MOST_PLACES, DIGITS)
        statement = Statement(((side, "=", known_side(derived)),), digits)
        return heard(answer, statement, lambda: islice(self._places(symbols), most))

    def ascending(self, answer: Answer, printed: Sequence[Node], box: Box) -> Answer:
        """Ask about an answer on printed terms of which each is less than the next on a box."""
        links = tuple((less, "<", more) for less, more in pairwise(map(self.side, printed)))
        symbols = box.keys() | frozenset().union(*map(self._symbols, printed))
        statement = Statement(links)
        return heard(answer, statement, lambda: places_in(with_box(self.domain, box), symbols))

    def equivalent(self, answer: Answer, printed: Node, derived: Any) -> Answer:
        """Ask about an answer on a printed condition and the one that it should be."""
        truth = Statement(((
            lambda place: mp.mpf(is_true(printed, self.side, place)),
            "=",
            lambda place: mp.mpf(is_met(derived, place)),
        ),))  # fmt: skip
        symbols = self._symbols(printed) | derived.free_symbols
        return heard(answer, truth, lambda: places_in(self.domain, symbols))

    def instance(self, answer: Answer, printed: Node, family: Sequence[Any]) -> Answer:
        """Ask whether printed angles are those of one parameter; what is assumed of it is not."""
        sides = [self.side(node) for node in children(printed)]
        statement = Statement(((
            lambda place: mp.mpf(_most_in_common([side(place) for side in sides], family)),
            "=",
            lambda _: mp.mpf(max(len(sides), len(family))),
        ),))  # fmt: skip
        if isinstance(answer, Refuted):
            if not answer.note:
                # Its witness is the angles themselves: no point of a domain.
                heard(replace(answer, witness=Witness({}, "", "")), statement, lambda: [Place({})])
            return answer
        return heard(answer, statement, lambda: [Place({})])

    def _symbols(self, printed: Node) -> frozenset[Any]:
        """Collect what the printed symbols are expressions in."""
        meanings = self.context.meanings_at(self.claim, printed).values()
        values = (known.value if isinstance(known, Function) else known for known in meanings)
        return frozenset().union(*(getattr(value, "free_symbols", ()) for value in values))

    def _places(self, symbols: frozenset[Any]) -> Iterator[Place]:
        """Yield points; claims on one domain share them, and what has been evaluated there."""
        shared = _shared_places(self.context, repr(self.domain), self.claim)
        others = symbols - self.context.variables
        if not others:
            yield from shared
            return
        for place, more in zip(shared, places_in(self.domain, others), strict=False):
            yield Place({**place, **more})


@lru_cache(maxsize=8)
def _shared_places(context: Context, _domain: str, claim: str) -> list[Place]:
    found = places_in(context.domain(claim), context.variables)
    return list(islice(found, MOST_PLACES))


def _most_in_common(angles: Sequence[Value], family: Sequence[Any]) -> int:
    """Count the angles, but for full turns, that a family of angles has for its best parameter."""
    (parameter,) = set().union(*(member.free_symbols for member in family))
    turns = int(ilcm(1, *(member.coeff(parameter).q for member in family)))

    def at(number: Value) -> list[Value]:
        return [known_value(member, {parameter.name: number}) for member in family]

    best = 0
    for start, end in zip(at(mp.mpf(0)), at(mp.mpf(1)), strict=True):
        # In a period of the family, a member goes round so often; one without parameter does not.
        for angle, turn in product(angles, range(int(mp.nint(turns * abs(end - start))))):
            left = at((angle - start + 2 * mp.pi * turn) / (end - start))
            for one in angles:
                left = next((left[:k] + left[k + 1 :] for k, other in enumerate(left)
                             if are_equal(mp.sin((one - other) / 2), mp.mpf(0))), left)  # fmt: skip
            best = max(best, len(family) - len(left))
    return best
