"""Everything a claim is judged with: the paper as printed, and what is derived for it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from sympy import MatrixBase, Symbol

from omniproof.audit.printing import to_latex
from omniproof.audit.readings import Read
from omniproof.papers.registry import Derivation, Derived, Registry, Relation
from omniproof.transcription.expression import evaluate
from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.model import Claim, Role
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tree import Chain, Name, Node


@dataclass
class Context:
    """One paper under audit; `choices` are the readings of its conventions, once chosen."""

    loaded: LoadedPaper
    registry: Registry
    readings: Mapping[str, Read]
    choices: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def claims(self) -> dict[str, Claim]:
        """Claims by id."""
        return {claim.id: claim for claim in self.loaded.claims}

    @cached_property
    def latex_names(self) -> dict[Symbol, str]:
        """LaTeX of the paper's free symbols."""
        return {
            self._symbol(symbol.name, symbol.positive): symbol.latex
            for symbol in self.loaded.paper.symbols
            if symbol.role is not Role.QUANTITY
        }

    @cached_property
    def meanings(self) -> dict[str, Any]:
        """What each printed symbol stands for, by canonical name."""
        return {
            symbol_name(symbol.latex): (
                self.registry.quantities[symbol.name]()
                if symbol.role is Role.QUANTITY
                else self._symbol(symbol.name, symbol.positive)
            )
            for symbol in self.loaded.paper.symbols
        }

    @staticmethod
    def _symbol(name: str, positive: bool) -> Symbol:
        return Symbol(name, positive=True) if positive else Symbol(name, real=True)

    def derivation(self, claim: str) -> Derivation:
        """Return how a claim follows; raises `KeyError` for a claim without derivation."""
        return self.registry.derivations[claim]

    def derive(self, claim: str) -> Derived:
        """Run the derivation of a claim, under the chosen reading of its convention."""
        derivation = self.derivation(claim)
        if not derivation.convention:
            return derivation.build()
        stated = self.registry.conventions[derivation.convention].stated
        return derivation.build(self.choices.get(derivation.convention, stated))

    def relation(self, claim: str) -> Relation:
        """Run the derivation of a relation."""
        derived = self.derive(claim)
        return derived if isinstance(derived, Relation) else Relation(derived)

    def meanings_at(self, claim: str) -> dict[str, Any]:
        """Meanings of symbols at one claim: some stand for anything in a lemma."""
        own = self.derivation(claim).meanings()
        by_name = {symbol.name: symbol_name(symbol.latex) for symbol in self.loaded.paper.symbols}
        return self.meanings | {by_name[name]: value for name, value in own.items()}

    def evaluate(self, claim: str, node: Node | None = None) -> Any:
        """Value of the printed form, or of one part of it; raises `LatexError`."""
        latex = self.printed(claim)
        tree = self.loaded.trees[claim] if node is None else node
        return evaluate(tree, self.meanings_at(claim), latex)

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
        return " ".join(self.claims[claim].latex)

    def latex(self, value: Any) -> str:
        """Print a derived value in the paper's symbols."""
        return to_latex(value, self.latex_names)


def entries(value: Any) -> dict[tuple[int, ...], Any]:
    """Entries of a matrix by printed index: (row, column) from 1, (row,) for a column vector."""
    assert isinstance(value, MatrixBase)
    rows, columns = value.shape
    if columns == 1:
        return {(i + 1,): value[i, 0] for i in range(rows)}
    return {(i + 1, k + 1): value[i, k] for i in range(rows) for k in range(columns)}
