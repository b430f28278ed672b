"""Other symbols in a paper's `symbols.py`: each fact that it states, altered by itself.

The derivations of the paper are imported anew with the altered symbols, so that everything that
rests on a sign is derived without it.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from importlib import import_module
from typing import Any

from sympy import MatrixBase, Symbol, pi

from omniproof.registry import Symbols


@dataclass(frozen=True)
class Fact:
    """One alteration: what becomes of one of the symbols."""

    paper: str
    symbol: Symbol
    how: str
    symbols: Symbols

    def __str__(self) -> str:
        """Name it as a test does."""
        return f"{self.paper}-{self.symbol}-{self.how}"

    @property
    def other(self) -> Symbol:
        """What code has in place of the symbol."""
        found = next((s for s in self.symbols.by_name.values() if s.name == self.symbol.name), None)
        return found or self.symbol


def facts(paper: str) -> Iterator[Fact]:
    """All alterations of the symbols of a paper."""
    own: Symbols = import_module(f"{package(paper)}.symbols").SYMBOLS
    for symbol in own.variables:
        others = tuple(each for each in own.variables if each != symbol)
        sign = "real" if symbol.is_positive else "positive"
        turned = Symbol(symbol.name, **{sign: True})
        ranges = {turned if key == symbol else key: ends for key, ends in own.ranges.items()}
        yield Fact(paper, symbol, sign, replace(own, variables=(*others, turned), ranges=ranges))
        yield Fact(paper, symbol, "left out", replace(own, variables=others))
        undefined = (*own.undefined, symbol)
        yield Fact(paper, symbol, "undefined", replace(own, variables=others, undefined=undefined))
        narrow = {**own.ranges, symbol: (pi / 7, pi / 6)}
        yield Fact(paper, symbol, "a range", replace(own, ranges=narrow))
        if symbol in own.ranges:
            free = {key: ends for key, ends in own.ranges.items() if key != symbol}
            yield Fact(paper, symbol, "no range", replace(own, ranges=free))
    for symbol in own.undefined:
        variables = (*own.variables, symbol)
        yield Fact(paper, symbol, "variable", replace(own, variables=variables, undefined=()))
        yield Fact(paper, symbol, "left out", replace(own, undefined=()))


def package(paper: str) -> str:
    """The package of a paper."""
    return f"omniproof.papers.{paper.replace('-', '_')}"


@contextmanager
def in_place(fact: Fact) -> Iterator[None]:
    """Import the paper's derivations anew with an altered fact."""
    home = package(fact.paper)
    kept = {name: module for name, module in sys.modules.items() if name.startswith(home)}
    for name in kept:
        del sys.modules[name]
    try:
        module = import_module(f"{home}.symbols")
        for name, value in vars(module).items():
            if not name.startswith("__"):
                setattr(module, name, _altered(value, fact))
        yield
    finally:
        for name in [name for name in sys.modules if name.startswith(home)]:
            del sys.modules[name]
        sys.modules.update(kept)


def _altered(value: Any, fact: Fact) -> Any:
    if isinstance(value, Symbols):
        return fact.symbols
    if isinstance(value, tuple):
        return tuple(_altered(each, fact) for each in value)
    if isinstance(value, Symbol | MatrixBase):
        return value.xreplace({fact.symbol: fact.other})
    return value
