"""The symbols of the derivations against those that print can mean.

A slip of ours here would become an erratum of theirs: SymPy takes `alpha_1` and `alpha_one`, `L`
and a positive `L` for different symbols, so that what is printed and what is derived are no longer
equal. What a symbol is, one place says; here the derivations are held to it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cached_property

from sympy import Dummy, Symbol

from omniproof.audit.context import Context
from omniproof.audit.known_symbols import KnownSymbols, known_symbols
from omniproof.transcription.faults import Fault, nearest
from omniproof.transcription.ids import base
from omniproof.transcription.model import Claim, Form, Kind, Role
from omniproof.transcription.model import Symbol as Declared
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tree import names

MOST_NAMED = 8
"""So many symbols a cure lists; a longer list is not read."""


def disagreements(context: Context) -> list[Fault]:
    """List all symbols that are not what they seem; none where nobody has derived anything yet."""
    if not context.registry.derivations:
        return []
    check = _Agreement(context, known_symbols(context))
    faults = [
        fault
        for printed, symbol in context.loaded.symbols.items()
        for fault in check.of_symbol(printed, symbol)
    ]
    # A wrong name makes every derivation look wrong that uses the right one.
    return faults or list(check.unprintable())


@dataclass(frozen=True)
class _Agreement:
    context: Context
    known: KnownSymbols

    def of_symbol(self, printed: str, symbol: Declared) -> Iterator[Fault]:
        """Yield what is wrong with one declared symbol."""
        if symbol.role is Role.QUANTITY:
            yield from self.arguments(symbol)
        elif symbol.name not in self.context.registry.quantities:
            yield from self.number(printed, symbol)

    def number(self, printed: str, symbol: Declared) -> Iterator[Fault]:
        """A symbol is the same one wherever it comes in; an undefined one comes in nowhere."""
        own, variable = self.context.sympy_symbol(symbol), symbol.role is Role.VARIABLE
        places = self.known.places.get(symbol.name, {})
        alike = {known: at for known, at in places.items() if not isinstance(known, Dummy)}
        others = [other for other in alike if other != own or not variable]
        for other in others[:1]:
            message = (
                f"expected {_numbers(own) if variable else 'no symbol of a derivation'}, "
                f"found {_numbers(other)} in {alike[other]}"
            )
            yield self.fault(symbol, "name", message, "take what is declared, or another name")
        by_file = variable and self.context.registry.symbols is None
        if by_file and not alike and self.is_printed(printed):
            message = f"expected a symbol of the derivations, found `{symbol.name}`"
            free = self.known.places.keys() - self.declared
            yield self.fault(symbol, "name", message, _meant(symbol.name, free))

    def arguments(self, symbol: Declared) -> Iterator[Fault]:
        """What the paper file says a quantity is a function of, its derivation says, or has."""
        if self.context.registry.symbols or symbol.name not in self.known.quantities:
            return
        stated = self.context.registry.arguments.get(symbol.name)
        found = [symbol_name(latex) for latex in symbol.of]
        known = self.known.quantities[symbol.name] if stated is None else stated
        wanted = [self.printed(variable) for variable in known]
        strange = [name for name in found if name not in wanted]
        if strange or (stated is not None and found != wanted):
            message = f"expected variables of its value, found {_listed(found)}"
            yield self.fault(symbol, "of", message, _meant("".join(strange), wanted))

    def printed(self, variable: Symbol) -> str:
        """The canonical name by which the paper prints a variable."""
        symbols = self.context.loaded.symbols.items()
        return next((name for name, own in symbols if own.name == variable.name), variable.name)

    def unprintable(self) -> Iterator[Fault]:
        """Yield what a formula is derived in although nothing that is printed can mean it."""
        for claim, found in self.known.claims.items():
            printed = self.context.claims.get(claim) or self.context.claims.get(base(claim))
            if printed is None or not _is_compared(printed):
                continue
            for symbol in sorted(found - self.printable - self.known.lemmas[claim], key=str):
                message = (
                    f"expected a derivation in what the paper prints, found `{symbol}` "
                    f"({_numbers(symbol)}) in {self.known.places[symbol.name][symbol]}"
                )
                cure = _meant(symbol.name, {known.name for known in self.printable})
                yield self.context.loaded.fault(printed.id, message, cure)

    def fault(self, symbol: Declared, key: str, message: str, cure: str) -> Fault:
        return self.context.loaded.symbol_fault(symbol.name, key, message, cure)

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

    def is_printed(self, printed: str) -> bool:
        """Whether a claim prints a symbol, and is derived."""
        claims = self.known.claims.keys() & self.context.claims.keys()
        formulas = (node for claim in claims for node in self.context.loaded.formulas(claim))
        return any(printed in names(node) for node in formulas)


def _is_compared(claim: Claim) -> bool:
    """Whether what a claim prints is held against what is derived for it."""
    condition = claim.asserts is not None and claim.asserts.form is Form.EQUIVALENT
    return claim.kind is Kind.IDENTITY or condition


def _numbers(symbol: Symbol) -> str:
    """What SymPy takes a symbol for."""
    kinds = ("positive", "negative", "nonnegative", "nonpositive", "nonzero", "real")
    kind = next((kind for kind in kinds if getattr(symbol, f"is_{kind}")), "complex")
    return f"a {kind} number"


def _meant(word: str, known: Collection[str]) -> str:
    """The cure for a name that is unknown: the one that was meant, or all that could be."""
    if len(known) == 1:
        return f"did you mean `{min(known)}`?"
    return nearest(word, known, f"the derivations know {_listed(sorted(known)[:MOST_NAMED])}")


def _listed(words: Collection[str]) -> str:
    return ", ".join(f"`{word}`" for word in words) or "none"
