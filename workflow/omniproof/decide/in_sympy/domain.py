"""A domain in SymPy, as the engines of order ask for it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from omniproof.decide import domain as decide
from omniproof.decide.answer import OnBranch
from omniproof.decide.domain import Range
from omniproof.decide.in_sympy.exact import subtract
from omniproof.formula.sympy_terms import Converter, term_of

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


def in_terms(domain: Domain, symbols: Iterable[sp.Symbol] = ()) -> decide.Domain:
    """Return the inside of a domain in terms, together with the signs that symbols have.

    What is said to differ only leaves out points that no equation hangs on.
    """
    known = {symbol.name: symbol for symbol in symbols}
    strict = [c for c in domain.conditions if not isinstance(c, sp.Ne)]
    for condition in strict:
        known |= {symbol.name: symbol for symbol in condition.free_symbols}
    ranges = {
        name: _signed(*domain.interval(name), known.get(name))
        for name in {**domain.intervals, **known}
    }
    positive = tuple(term_of(subtract(c.gts, c.lts)) for c in strict)
    return decide.Domain(
        {name: _range(*ends) for name, ends in ranges.items() if ends != REAL_LINE}, positive
    )


def _signed(lower: Any, upper: Any, symbol: sp.Symbol | None) -> tuple[Any, Any]:
    """Cut an interval to where a symbol has the sign that SymPy assumes of it."""
    known = symbol.assumptions0 if symbol else {}  # quicker than to ask for what is not known
    if known.get("nonnegative"):
        lower = sp.Max(lower, 0)
    if known.get("nonpositive"):
        upper = sp.Min(upper, 0)
    return lower, upper


def _range(lower: Any, upper: Any) -> Range:
    return (
        None if lower == -sp.oo else term_of(lower),
        None if upper == sp.oo else term_of(upper),
    )


def in_sympy(domain: decide.Domain, converter: Converter) -> Domain:
    """Return a domain as the engines of order ask for it."""
    ranges = {
        name: (
            -sp.oo if lower is None else converter.expression(lower),
            sp.oo if upper is None else converter.expression(upper),
        )
        for name, (lower, upper) in domain.ranges.items()
    }
    conditions = (sp.Gt(converter.expression(each), 0) for each in domain.positive)
    return Domain(ranges, tuple(c for c in conditions if c != sp.true))


def converter_for(domain: decide.Domain, names: Iterable[str]) -> Converter:
    """Return what writes terms in SymPy, with symbols that have the signs of a domain."""
    converter = Converter()
    for name in names:
        converter.term(symbol_in(domain, name))
    return converter


def symbol_in(domain: decide.Domain, name: str) -> sp.Symbol:
    """Return SymPy's symbol for a name, which knows the sign that it has in a domain."""
    if name in domain.nonnegative:
        return sp.Symbol(name, positive=True)
    return sp.Symbol(name, **({"negative": True} if name in domain.nonpositive else {"real": True}))


def in_symbols(answer: OnBranch, symbols: Iterable[sp.Symbol]) -> OnBranch:
    """Return an answer whose condition is on symbols that are given, and not on their like."""
    own = {symbol.name: symbol for symbol in symbols}
    found = set().union(*(relation.free_symbols for relation in answer.relations))
    known = {symbol: own.get(symbol.name, symbol) for symbol in found}
    return replace(answer, relations=tuple(each.xreplace(known) for each in answer.relations))
