"""The symbols that a paper's derivations are written in, each with the code that brings it in.

They are looked up in what the derivations return, not in a list of ours: a list could say one
thing and the derivation another, and SymPy takes `L` and a positive `L` for two symbols.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields, is_dataclass
from inspect import unwrap
from itertools import chain
from pathlib import Path
from types import CodeType
from typing import Any

from sympy import Basic, MatrixBase, Symbol

from omniproof.audit.context import Context
from omniproof.transcription.files import display_name


@dataclass(frozen=True)
class KnownSymbols:
    """What derivations know: `places` says where a symbol of that name comes in first.

    `claims` are the symbols that a claim is derived in, `lemmas` those that some printed quantities
    stand for in it, `quantities` those in the value of a quantity, by its name.
    """

    places: Mapping[str, Mapping[Symbol, str]]
    claims: Mapping[str, frozenset[Symbol]]
    lemmas: Mapping[str, frozenset[Symbol]]
    quantities: Mapping[str, frozenset[Symbol]]


def known_symbols(context: Context) -> KnownSymbols:
    """Derive everything once (`Context` keeps it), and collect the symbols."""
    places: dict[str, dict[Symbol, str]] = defaultdict(dict)

    def noted(value: Any, build: Callable[..., Any]) -> frozenset[Symbol]:
        found = frozenset(symbols_in(value))
        for symbol in found:
            if symbol not in places[symbol.name]:
                places[symbol.name][symbol] = place_of(build)
        return found

    registry = context.registry
    quantities = {
        name: noted(context.quantity(name), build) for name, build in registry.quantities.items()
    }
    lemmas = {
        claim: noted(context.lemma(claim), derivation.meanings)
        for claim, derivation in registry.derivations.items()
    }
    claims = {
        claim: noted(context.derive(claim), derivation.build)
        for claim, derivation in registry.derivations.items()
    }
    return KnownSymbols(dict(places), claims, lemmas, quantities)


def symbols_in(value: Any) -> set[Symbol]:
    """Free symbols of an expression, or of all expressions in a record, a list or a mapping."""
    if isinstance(value, Basic | MatrixBase):
        return set(value.free_symbols)
    return set[Symbol]().union(*map(symbols_in, _parts(value)))


def _parts(value: Any) -> Iterable[Any]:
    if is_dataclass(value):
        return (getattr(value, item.name) for item in fields(value))
    if isinstance(value, Mapping):
        return chain(value, value.values())
    return value if isinstance(value, list | tuple | set | frozenset) else ()


def place_of(build: Callable[..., Any]) -> str:
    """File and line of a derivation."""
    code = getattr(unwrap(build), "__code__", None)
    if not isinstance(code, CodeType):
        return "the derivations"
    return f"{display_name(Path(code.co_filename))}:{code.co_firstlineno}"
