"""Everything a claim is judged with: the paper as printed, and what is derived for it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain
from typing import Any

from sympy import Gt, Lt, MatrixBase, Symbol

from omniproof.audit.printing import Spelling
from omniproof.audit.readings import Read
from omniproof.decide import domain as decide
from omniproof.decide.in_sympy.domain import Domain, in_terms
from omniproof.decide.in_sympy.exact import sign, subtract
from omniproof.decide.order.hypotheses import domain_of
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.evaluation import Function, Lifted, evaluate
from omniproof.formula.monomials import is_plainly_zero
from omniproof.formula.sympy_terms import Converter
from omniproof.formula.term import Term, divide
from omniproof.formula.unfold import unfold
from omniproof.formula.value import terms_in
from omniproof.formula.where_defined import requirements
from omniproof.registry import Derivation, Derived, Modelled, Registry, Relation
from omniproof.transcription.checking import known_names
from omniproof.transcription.conventions import Names
from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.model import Claim, Kind, Role
from omniproof.transcription.model import Symbol as PrintedSymbol
from omniproof.transcription.reader import read_with
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tree import Chain, Name, Node, names


@dataclass(eq=False)  # one and the same, or another: so it can be the key of a cache
class Context:
    """One paper under audit; `choices` are the readings of its conventions, once chosen, by claim.

    Derived once: `derived`, by what derives it and the reading of its convention, so that claims
    with one derivation share it; `domains`, where claims are judged, and `converters`, which know
    the symbols of each claim. Without `mends`, no misprint is mended: the derived form is the
    correction, and it comes at once.
    """

    loaded: LoadedPaper
    registry: Registry
    readings: Mapping[str, Read]
    choices: Mapping[str, str] = field(default_factory=dict)
    derived: dict[tuple[Callable[..., Any], tuple[str, ...]], Any] = field(default_factory=dict)
    domains: dict[str, Domain] = field(default_factory=dict)
    converters: dict[str, Converter] = field(default_factory=dict)
    mends: bool = True

    @cached_property
    def claims(self) -> dict[str, Claim]:
        """Claims by id."""
        return {claim.id: claim for claim in self.loaded.claims}

    @cached_property
    def spelling(self) -> Spelling:
        """How the paper writes what is derived."""
        symbols = {
            self.sympy_symbol(symbol): symbol.latex
            for symbol in self.loaded.paper.symbols
            if symbol.role is not Role.QUANTITY
        }
        short = {build(): latex for latex, build in self.registry.abbreviations.items()}
        return Spelling(symbols, short)

    @cached_property
    def names(self) -> Names:
        """The declared symbols, for reading more LaTeX."""
        return known_names(self.loaded.symbols)

    @cached_property
    def variables(self) -> frozenset[Symbol]:
        """SymPy's symbols for what the paper prints and does not derive."""
        symbols = self.loaded.paper.symbols
        return frozenset(self.sympy_symbol(s) for s in symbols if s.role is not Role.QUANTITY)

    def value(self, text: str, claim: str) -> Any:
        """Read and evaluate a formula with the symbols of a claim; raises `LatexError`."""
        node = read_with(text, self.loaded.paper.notation, self.names)
        return evaluate(node, self.meanings_at(claim, node), text)

    def _once(self, build: Callable[..., Any], *reading: str) -> Any:
        if (build, reading) not in self.derived:
            self.derived[build, reading] = build(*reading)
        return self.derived[build, reading]

    def meaning(self, printed: str) -> Any:
        """What a printed symbol stands for, by canonical name; quantities are derived once."""
        symbol = self.loaded.symbols[printed]
        if symbol.role is Role.QUANTITY:
            return self.quantity(symbol.name)
        return self.sympy_symbol(symbol)

    def quantity(self, name: str) -> Any:
        """Derive a quantity; raises `KeyError` for one without derivation."""
        return self._once(self.registry.quantities[name])

    def lemma(self, claim: str) -> Mapping[str, Any]:
        """What symbols stand for in one claim only, by their names."""
        lemma: Mapping[str, Any] = self._once(self.derivation(claim).meanings)
        return lemma

    def sympy_symbol(self, symbol: PrintedSymbol) -> Symbol:
        """What a variable is in the derivations; where no code says it, the paper file does."""
        if self.registry.symbols and symbol.name in self.registry.symbols.by_name:
            return self.registry.symbols.by_name[symbol.name]
        assumption = {"positive": True} if symbol.positive else {"real": True}
        return Symbol(symbol.name, **assumption)

    def derivation(self, claim: str) -> Derivation:
        """Return how a claim follows; raises `KeyError` for a claim without derivation."""
        return self.registry.derivations[claim]

    def derive(self, claim: str) -> Derived:
        """Run the derivation of a claim, under the chosen reading of its convention."""
        derivation, reading = self.derivation(claim), tuple[str, ...]()
        if derivation.convention:
            stated = self.registry.conventions[derivation.convention].stated
            reading = (self.choices.get(claim, stated),)
        derived: Derived = self._once(derivation.build, *reading)
        return derived

    def derive_by_mechanics(self, claim: str) -> Derived:
        """Run the derivation of an identity, without what only the paper's premises give."""
        derived = self.derive(claim)
        return derived.mechanics if isinstance(derived, Modelled) else derived

    def relation(self, claim: str) -> Relation:
        """Run the derivation of a relation."""
        derived = self.derive(claim)
        return derived if isinstance(derived, Relation) else Relation(derived)

    def meanings_at(self, claim: str, node: Node) -> dict[str, Any]:
        """Meanings of the symbols in a formula; in a lemma, some stand for anything."""
        own = self.lemma(claim)
        found: dict[str, Any] = {}
        for printed in names(node) & self.loaded.symbols.keys():
            symbol = self.loaded.symbols[printed]
            value = own[symbol.name] if symbol.name in own else self.meaning(printed)
            variables = tuple(self.meaning(symbol_name(latex)).name for latex in symbol.of)
            found[printed] = Function(value, variables) if variables else value
        return found

    def evaluate(self, claim: str, node: Node | None = None) -> Any:
        """Value of the printed form, or of one part of it; raises `LatexError`."""
        tree = self.loaded.trees[claim] if node is None else node
        return evaluate(tree, self.meanings_at(claim, tree), self.printed(claim))

    def unfolded(self, claim: str, node: Node) -> Any:
        """The same as terms, in which nothing is simplified; raises `LatexError`."""
        return self._unfolded(claim, node, self.printed(claim))

    def _unfolded(self, claim: str, node: Node, text: str) -> Any:
        converter = self.converters.setdefault(claim, Converter())
        return unfold(node, Lifted(self.meanings_at(claim, node), converter), text)

    def factor(self, side: Term, text: str, claim: str) -> Any:
        """Return what stands before a printed part that makes it a side, in SymPy."""
        node = read_with(text, self.loaded.paper.notation, self.names)
        part = self._unfolded(claim, node, text)
        quotient = divide(side, part)
        return 1 if is_plainly_zero(part) else self.converters[claim].expression(quotient)

    def domain(self, claim: str) -> Domain:
        """Where a claim is judged: the ranges of the symbols, and what the claim assumes.

        Raises `LatexError` for what has no value, `UnsupportedError` for an empty domain.
        """
        if claim not in self.domains:
            self.domains[claim] = self._domain(claim)
        return self.domains[claim]

    def _domain(self, claim: str) -> Domain:
        ranges = {symbol.name: ends for symbol, ends in self._ranges()}
        # An empty range would make every claim on it true.
        for name, (lower, upper) in ranges.items():
            if sign(subtract(upper, lower)) <= 0:
                raise UnsupportedError(f"no value of {name} is left")
        return domain_of([*self._stated(claim), *self._defined(claim)], Domain(ranges))

    def assumed(self, claim: str) -> list[Any]:
        """Return the same as SymPy relations: `domain` does not tell closed ends from open ones."""
        ranges = [part for x, (low, high) in self._ranges() for part in (Gt(x, low), Lt(x, high))]
        return [*ranges, *self._stated(claim)]

    def _ranges(self) -> Iterator[tuple[Symbol, tuple[Any, Any]]]:
        if self.registry.symbols:
            yield from self.registry.symbols.ranges.items()
        for printed, (lower, upper) in self.loaded.ranges.items():
            if printed in self.loaded.symbols:
                symbol = self.sympy_symbol(self.loaded.symbols[printed])
                yield symbol, (evaluate(lower, {}), evaluate(upper, {}))

    def _stated(self, claim: str) -> list[Any]:
        stated = self.loaded.assumptions.get(claim, ())
        return [evaluate(node, self.meanings_at(claim, node)) for node in stated]

    def _defined(self, claim: str) -> list[Any]:
        """Return where a printed order is defined, which its values in SymPy may have forgotten."""
        if claim not in self.loaded.trees or self.claims[claim].kind is Kind.IDENTITY:
            return []
        value = self.unfolded(claim, self.loaded.trees[claim])
        expression = self.converters[claim].expression
        return [expression(each) for each in requirements(*terms_in(value))]

    def domain_in_terms(self, claim: str, derived: Any) -> decide.Domain:
        """Return where an equation of a claim is judged, with the signs of all symbols in it."""
        own = (getattr(value, "free_symbols", ()) for value in self.lemma(claim).values())
        return in_terms(self.domain(claim), [*self.variables, *chain(*own), *derived.free_symbols])

    def sides(self, claim: str) -> tuple[Node, ...]:
        """Sides of a printed equation that its derivation is held against.

        The symbol on the left is what the equation defines. Under another convention than the
        stated one it means something else here than in the rest of the paper, and says nothing.
        """
        tree = self.loaded.trees[claim]
        if not isinstance(tree, Chain):
            return (tree,)
        convention = self.derivation(claim).convention
        sides = tuple(side for side in tree.sides if side is not None)
        if convention and len(sides) > 1 and isinstance(sides[0], Name):
            return sides[1:]
        return sides

    def printed(self, claim: str) -> str:
        """LaTeX of a claim, its fragments joined."""
        return self.loaded.sources.get(claim, "")


def entries(value: Any) -> dict[tuple[int, ...], Any]:
    """Entries of a matrix by printed index: (row, column) from 1, (row,) for a column vector."""
    assert isinstance(value, MatrixBase)
    rows, columns = value.shape
    if columns == 1:
        return {(i + 1,): value[i, 0] for i in range(rows)}
    return {(i + 1, k + 1): value[i, k] for i in range(rows) for k in range(columns)}


def flat(value: Any) -> list[Any]:
    """Entries of a matrix in printed order; an expression is its only one."""
    return list(entries(value).values()) if isinstance(value, MatrixBase) else [value]
