"""From the printed tree to SymPy, for what still asks SymPy: by way of terms.

The tree is unfolded into terms, in which nothing is simplified; SymPy then simplifies them on its
way, as it always does. Symbols keep the assumptions with which they are given.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from types import FunctionType
from typing import Any, TypeAlias

from sympy import MatrixBase

from omniproof.formula.sympy_terms import Converter
from omniproof.formula.unfold import unfold
from omniproof.formula.value import Function
from omniproof.formula.writers import latex
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError

__all__ = ["Function", "Lifted", "Meaning", "Value", "evaluate"]

Meaning: TypeAlias = Any
"""An expression, a matrix, for a quantity with arguments a `Function` of them, or an operator."""
Value: TypeAlias = Any
"""An expression, a matrix, a relation, or a tuple of these."""


def evaluate(node: tree.Node, meanings: Mapping[str, Meaning], source: str = "") -> Value:
    """Give a tree the value that its symbols mean, in SymPy.

    `meanings` are keyed by canonical symbol name. An expression gives an `Expr`, a vector an n×1
    and a matrix an n×m `ImmutableMatrix`, a comparison a relation; a chain gives the tuple of its
    sides, a listing or set the tuple of its items, a set builder its element and conditions.
    Raises `LatexError` for an unknown symbol and for shapes that do not fit; `source` is the text
    that was read.
    """
    converter = Converter()
    value = unfold(node, Lifted(meanings, converter), source)
    try:
        return converter.expression(value)
    except TypeError:
        text, span = (source, node.span) if source else (latex(node), (0, len(latex(node))))
        raise LatexError("cannot compare numbers that are not real", text, span) from None


@dataclass(frozen=True)
class Lifted(Mapping[str, Any]):
    """Meanings in SymPy, given as terms when they are asked for."""

    given: Mapping[str, Meaning]
    converter: Converter

    def __getitem__(self, name: str) -> Any:
        """Return a meaning as a term, a grid, or a function of them."""
        meaning, value = self.given[name], self.converter.value
        if isinstance(meaning, Function):
            return replace(meaning, value=value(meaning.value))
        if isinstance(meaning, FunctionType):
            expression = self.converter.expression
            return lambda *places: value(meaning(*map(expression, places)))
        return value(meaning) if isinstance(meaning, MatrixBase) else self.converter.term(meaning)

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names."""
        return iter(self.given)

    def __len__(self) -> int:
        """Count the names."""
        return len(self.given)
