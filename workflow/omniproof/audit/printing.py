"""Derived expressions as LaTeX in the paper's own symbols."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sympy import MatrixBase, Symbol, latex

LONGEST = 400
"""Derived forms beyond this many characters are not shown: nobody reads them."""


def to_latex(value: Any, names: Mapping[Symbol, str]) -> str:
    """Print an expression, matrix or tuple with the paper's spelling of its symbols.

    `names`: LaTeX by symbol. An expression too long to read gives an empty string.
    """
    if isinstance(value, tuple):
        return r",\; ".join(to_latex(entry, names) for entry in value)
    matrices = {"mat_delim": "(", "mat_str": "matrix"} if isinstance(value, MatrixBase) else {}
    text = latex(
        value,
        symbol_names=dict(names),
        fold_func_brackets=True,
        ln_notation=True,
        **matrices,
    )
    return text if len(text) <= LONGEST else ""
