"""What the paper file says of a symbol against what the derivations know of it.

A slip of ours here would become an erratum of theirs: SymPy takes `alpha_1` and `alpha_one`, `L`
and a positive `L` for different symbols, so that what is printed and what is derived are no longer
equal. Both places therefore have to say the same; the first difference stops the audit.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

from sympy import Dummy, Symbol

from omniproof.audit.context import Context
from omniproof.audit.exact import subtract, vanishes
from omniproof.audit.known_symbols import KnownSymbols, known_symbols, place_of
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.evaluation import evaluate
from omniproof.transcription.faults import Fault, nearest
from omniproof.transcription.ids import base
from omniproof.transcription.model import Kind, Role
from omniproof.transcription.model import Symbol as Declared
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tree import names

Said: TypeAlias = tuple[str, str, str]
"""A key of a declared symbol, what is wrong with it, and the cure."""

NOT_INTRODUCED = "leave it out, or write `role: undefined` for what the paper never introduces"
MOST_NAMED = 8
"""So many symbols a cure lists; a longer list is not read."""


def disagreements(context: Context) -> list[Fault]:
    """List all differences; none where nobody has derived anything yet."""
    if not context.registry.derivations:
        return []
    check = _Agreement(context, known_symbols(context))
    faults = [
        context.loaded.symbol_fault(symbol.name, *said)
        for printed, symbol in context.loaded.symbols.items()
        for said in check.differences(printed, symbol)
    ]
    # A wrong name makes every derivation look wrong that uses the right one.
    return faults or list(check.unprintable())


@dataclass(frozen=True)
class _Agreement:
    context: Context
    known: KnownSymbols

    def differences(self, printed: str, symbol: Declared) -> Iterator[Said]:
        """Yield what is said of one symbol in two ways."""
        if symbol.role is Role.QUANTITY:
            yield from self.arguments(printed, symbol)
        if symbol.name in self.context.registry.quantities or symbol.role is Role.QUANTITY:
            return
        yield from self.range(printed, symbol)
        rule = self.undefined if symbol.role is Role.UNDEFINED else self.variable
        yield from rule(printed, symbol)

    def variable(self, printed: str, symbol: Declared) -> Iterator[Said]:
        """A variable is known to the derivations, with the same sign wherever it comes in."""
        places = self.known.places.get(symbol.name, {})
        alike = {known: at for known, at in places.items() if not isinstance(known, Dummy)}
        own = self.context.sympy_symbol(symbol)
        others = [other for other in alike if other != own]
        for other in others[:1]:
            message = f"expected {_numbers(other)}, as in {alike[other]}, found {_numbers(own)}"
            yield "positive", message, "say the same in both places"
        if others:
            return
        printing = self.printing(printed)
        claims = [claim for claim in printing if claim in self.context.registry.derivations]
        around = self.names_around(claims)
        missed = around - self.declared
        # Where nothing is derived, nothing can go wrong: a symbol may stand there alone.
        unknown = not alike and (claims or not printing)
        if unknown or (claims and missed and symbol.name not in around):
            message = f"expected a symbol of the derivations, found `{symbol.name}`"
            free = self.known.places.keys() - self.declared
            otherwise = nearest(symbol.name, free, NOT_INTRODUCED)
            yield "name", message, _meant(symbol.name, missed) if missed else otherwise

    def undefined(self, printed: str, symbol: Declared) -> Iterator[Said]:
        """What the paper never introduces has no part in the mechanics."""
        for place in list(self.known.places.get(symbol.name, {}).values())[:1]:
            message = f"expected a symbol that no derivation knows, found one of {place}"
            yield "role", message, "leave `role: undefined` out, or give it another name"

    def range(self, printed: str, symbol: Declared) -> Iterator[Said]:
        """The range in which a symbol is judged is the one that the derivations state."""
        if self.context.registry.ranges is None:
            return
        stated = {key.name: ends for key, ends in self.context.registry.ranges.items()}
        wanted = stated.get(symbol.name)
        found = tuple(evaluate(end, {}) for end in self.context.loaded.ranges.get(printed, ()))
        if not _same_ends(wanted or (), found):
            said = f"({wanted[0]}, {wanted[1]})" if wanted else "no range"
            message = f"expected {said}, as the derivations state, found {symbol.range or 'none'}"
            yield "range", message, "say the same in both places"

    def arguments(self, printed: str, symbol: Declared) -> Iterator[Said]:
        """What a quantity is a function of is what its derivation says, or what its value has."""
        build = self.context.registry.quantities.get(symbol.name)
        if build is None:
            return
        found = [symbol_name(latex) for latex in symbol.of]
        stated = self.context.registry.arguments.get(symbol.name)
        value = self.known.quantities[symbol.name]
        wanted = [self.latex(variable) for variable in (value if stated is None else stated)]
        if stated is not None and found != wanted:
            message = f"expected {_listed(wanted)}, as in {place_of(build)}, found {_listed(found)}"
            yield "of", message, "say the same in both places"
        for name in found if stated is None else ():
            if name not in wanted:
                message = f"expected a variable of its value, found {_listed([name])}"
                yield "of", message, _meant(name, wanted)

    def latex(self, variable: Symbol) -> str:
        """The canonical name by which the paper prints a variable."""
        symbols = self.context.loaded.symbols.items()
        return next(
            (printed for printed, own in symbols if own.name == variable.name), str(variable)
        )

    def unprintable(self) -> Iterator[Fault]:
        """Yield what an identity is derived in although nothing that is printed can mean it."""
        for claim, found in self.known.claims.items():
            printed = self.context.claims.get(claim) or self.context.claims.get(base(claim))
            if printed is None or printed.kind is not Kind.IDENTITY:
                continue
            for symbol in sorted(found - self.printable - self.known.lemmas[claim], key=str):
                message = (
                    f"expected a derivation in what the paper prints, found `{symbol}` "
                    f"({_numbers(symbol)}) in {self.known.places[symbol.name][symbol]}"
                )
                cure = _meant(symbol.name, {known.name for known in self.printable})
                yield self.context.loaded.fault(printed.id, message, cure)

    @cached_property
    def declared(self) -> frozenset[str]:
        """Names of all declared symbols."""
        return frozenset(symbol.name for symbol in self.context.loaded.symbols.values())

    @cached_property
    def printable(self) -> frozenset[Symbol]:
        """Symbols that something printed can stand for."""
        own = (
            self.context.sympy_symbol(symbol)
            for symbol in self.context.loaded.symbols.values()
            if symbol.role is Role.VARIABLE
        )
        return frozenset(own).union(*self.known.quantities.values())

    @cached_property
    def printed(self) -> dict[str, frozenset[str]]:
        """Canonical names of the symbols in all formulas of a claim."""
        loaded = self.context.loaded
        return {
            claim.id: frozenset[str]().union(*map(names, loaded.formulas(claim.id)))
            for claim in loaded.claims
        }

    def printing(self, printed: str) -> list[str]:
        """Claims that print a symbol."""
        return [claim for claim, found in self.printed.items() if printed in found]

    def names_around(self, claims: Collection[str]) -> frozenset[str]:
        """Names of all symbols that these claims are derived in, or that they print."""
        found = set[Symbol]()
        for claim in claims:
            found |= self.known.claims[claim] | self.known.lemmas[claim]
            for printed in self.printed[claim] & self.context.loaded.symbols.keys():
                found |= self.known.quantities.get(self.context.loaded.symbols[printed].name, set())
        return frozenset(symbol.name for symbol in found)


def _numbers(symbol: Symbol) -> str:
    """What SymPy takes a symbol for."""
    kinds = ("positive", "negative", "nonnegative", "nonpositive", "nonzero", "real")
    kind = next((kind for kind in kinds if getattr(symbol, f"is_{kind}")), "complex")
    return f"a {kind} number"


def _listed(words: Collection[str]) -> str:
    return ", ".join(f"`{word}`" for word in words) or "nothing"


def _meant(word: str, known: Collection[str]) -> str:
    """The cure for a name that is unknown: the one that was meant, or all that could be."""
    if len(known) == 1:
        return f"did you mean `{min(known)}`?"
    names = sorted(known)[:MOST_NAMED]
    return nearest(word, known, f"the derivations know {_listed(names) or 'none'}")


def _same_ends(wanted: Collection[Any], found: Collection[Any]) -> bool:
    """Whether two intervals, or none, are the same; ends may be infinite."""
    if len(wanted) != len(found):
        return False
    return all(one == other or _equal(one, other) for one, other in zip(wanted, found, strict=True))


def _equal(one: Any, other: Any) -> bool:
    try:
        return vanishes(subtract(one, other))
    except UnsupportedError:
        return False
