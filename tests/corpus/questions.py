"""From a record to what an engine is asked: sides, entry by entry, and a domain.

Positive symbols are positive SymPy symbols, so that every system that is asked sees the assumption.
Ranges have no place in a SymPy symbol; they are in the domain.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import sympy as sp

from corpus import Record
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.in_sympy.domain import Domain
from omniproof.decide.in_sympy.equality import confirmed_equal, decide_equal
from omniproof.decide.order.comparison import compare
from omniproof.formula.evaluation import evaluate
from omniproof.transcription.reader import read
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tree import Chain, Comparison, Node, names


@dataclass(frozen=True)
class Question:
    """The pairs of a record that are to be equal, or ordered, everywhere in the domain."""

    pairs: tuple[tuple[sp.Expr, sp.Expr], ...]
    relation: str
    domain: Domain
    symbols: tuple[sp.Symbol, ...]

    @property
    def is_equation(self) -> bool:
        """Whether the sides are to be equal."""
        return self.relation == "="

    @property
    def is_settled(self) -> bool:
        """Whether all sides are alike as soon as SymPy has built them: nothing to decide."""
        return self.is_equation and all(left - right == 0 for left, right in self.pairs)


def ask(record: Record) -> Question:
    """Read and evaluate a record."""
    domain = Domain(
        {symbol_name(name): tuple(map(_value, ends)) for name, ends in record.ranges.items()}
    )
    meanings = _Meanings(record)
    for text in record.where:
        node = read(text)
        assert isinstance(node, Chain)
        meanings.define(node.sides[0], meanings.value(node.sides[1], text))
    node = read(record.latex)
    if isinstance(node, Comparison):
        pair = meanings.value(node.left, record.latex), meanings.value(node.right, record.latex)
        return Question((pair,), node.operator, domain, meanings.symbols)
    sides = meanings.value(node, record.latex)
    pairs = tuple(pair for left, right in pairwise(sides) for pair in _entries(left, right))
    return Question(pairs, "=", domain, meanings.symbols)


class _Meanings:
    """The symbols of a record, made when they are first met, and its definitions."""

    def __init__(self, record: Record) -> None:
        self.positive = {symbol_name(name) for name in record.positive}
        self.known: dict[str, Any] = {}

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        return tuple(meaning for meaning in self.known.values() if isinstance(meaning, sp.Symbol))

    def define(self, name: Node, meaning: Any) -> None:
        (key,) = names(name)
        self.known[key] = meaning

    def value(self, node: Node, text: str) -> Any:
        for name in sorted(names(node)):
            key = name.removeprefix("\\det ")
            sign: Mapping[str, bool] = {"positive" if key in self.positive else "real": True}
            self.known.setdefault(key, sp.Symbol(key, **sign))
        return evaluate(node, self.known, text)


def _value(text: str) -> Any:
    return evaluate(read(text), {}, text)


def _entries(left: Any, right: Any) -> list[tuple[sp.Expr, sp.Expr]]:
    if not isinstance(left, sp.MatrixBase):
        return [(left, right)]
    assert left.shape == right.shape
    return list(zip(left, right, strict=True))


def decision(question: Question, *, confirmed: bool = False) -> Answer:
    """Give our answer: the first entry that is not proved, else the last one."""
    if not question.is_equation:
        return _relation(question)
    decide = confirmed_equal if confirmed else decide_equal
    answer: Answer = Undecided("nothing was asked")
    for left, right in question.pairs:
        answer = decide(left, right, question.domain)
        if not isinstance(answer, Proved):
            break
    return answer


def _relation(question: Question) -> Answer:
    """Decide an order everywhere in the domain; positive symbols are positive there too."""
    ((left, right),) = question.pairs
    positive = {s.name: (sp.S.Zero, sp.oo) for s in question.symbols if s.is_positive}
    domain = Domain(positive | dict(question.domain.intervals))
    return compare(left, question.relation, right, domain)


def verdict(question: Question, answer: Answer) -> str:
    """Name an answer as the corpus does; a relation `for all` that holds in parts is refuted."""
    match answer:
        case Proved():
            return "proved"
        case Refuted():
            return "refuted"
        case OnBranch():
            return "branch" if question.is_equation else "refuted"
    return "undecided"
