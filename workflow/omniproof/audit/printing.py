"""Derived expressions as LaTeX in the paper's own symbols."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Dummy, Expr, MatrixBase, Symbol, latex
from sympy.core.function import AppliedUndef

LONGEST = 400
"""Derived forms beyond this many characters are not shown: nobody reads them."""


@dataclass(frozen=True)
class Spelling:
    """How a paper writes: LaTeX of its symbols, and short names for long expressions."""

    symbols: Mapping[Symbol, str]
    abbreviations: Mapping[Expr, str]

    def latex(self, value: Any) -> str:
        """Print an expression, a matrix or a tuple; nothing where it would be too long to read."""
        if isinstance(value, tuple):
            return r",\; ".join(self.latex(entry) for entry in value)
        value = self._abbreviated(value)
        # SymPy orders terms by names: those of the functions, so that every run prints alike.
        functions = {f: Dummy(str(f)) for f in value.atoms(AppliedUndef)}
        names = {own: _applied(f) for f, own in functions.items()}
        text = latex(
            value.xreplace(functions),
            symbol_names=dict(self.symbols) | names,
            fold_func_brackets=True,
            **({"mat_delim": "(", "mat_str": "matrix"} if isinstance(value, MatrixBase) else {}),
        )
        return text if len(text) <= LONGEST else ""

    def _abbreviated(self, value: Any) -> Any:
        """Name long parts, and the inverses of named roots; a long expression alone stays whole."""
        if not hasattr(value, "xreplace") or value in self.abbreviations:
            return value
        named = {part: Symbol(text) for part, text in self.abbreviations.items()}
        inverses = {1 / part: 1 / name for part, name in named.items() if part.is_Pow}
        return value.xreplace(named | inverses)


def _applied(function: AppliedUndef) -> str:
    """Write an unknown function with its argument in brackets; SymPy would leave them out."""
    (argument,) = function.args
    return f"{latex(Symbol(str(function.func)))}({latex(argument)})"
