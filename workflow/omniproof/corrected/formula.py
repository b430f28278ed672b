"""A derived claim as a NumPy function: generated from the derivation when it is first called.

Nothing is typed twice: the expression is what the audit judged the paper against. Only derivations
are turned into code, which are ours; what a paper prints never is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sympy import Expr, MatrixBase, Symbol, lambdify, sstr

from omniproof.registry import Modelled, Registry, load_registry

Array: TypeAlias = NDArray[np.float64]

Functions: TypeAlias = Mapping[str, Callable[..., Array]]
"""Claim of a paper -> the function that says what it ought to say."""


def derived_form(registry: Registry, claim_id: str, convention: str = "") -> Any:
    """Return the expression or matrix that mechanics gives for a claim, else None.

    `convention`: the reading under which a claim is derived that depends on one. None stands for a
    claim without derivation, and for one whose derivation gives no single expression.
    """
    derivation = registry.derivations.get(claim_id)
    if derivation is None or (derivation.convention and not convention):
        return None
    derived = derivation.build(convention) if derivation.convention else derivation.build()
    form = derived.mechanics if isinstance(derived, Modelled) else derived
    return form if isinstance(form, Expr | MatrixBase) else None


@dataclass(frozen=True)
class Formula:
    """What one claim of a paper ought to say, in SI units and radians.

    `convention`: the reading under which the claim is derived, of one that depends on a reading.
    """

    paper: str
    claim: str
    convention: str = ""

    @cached_property
    def expression(self) -> Any:
        """SymPy expression or matrix. Raises `LookupError` when the claim derives none."""
        form = derived_form(load_registry(self.paper), self.claim, self.convention)
        if form is None:
            raise LookupError(f"{self.paper}: {self.claim} has no derived expression")
        return form

    @property
    def sympy(self) -> str:
        """The expression as SymPy writes it."""
        return str(sstr(self.expression))

    @cached_property
    def symbols(self) -> tuple[Symbol, ...]:
        """Its symbols, by name."""
        found: set[Symbol] = self.expression.free_symbols
        return tuple(sorted(found, key=str))

    @cached_property
    def _functions(self) -> tuple[Callable[..., Any], ...]:
        # Entry by entry: a constant entry has to be broadcast, which a compiled matrix does not do.
        form = self.expression
        entries = form.flat() if isinstance(form, MatrixBase) else [form]
        return tuple(lambdify(self.symbols, entry, "numpy") for entry in entries)

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of one value: `()` of an expression, `(n,)` of a column, `(n, m)` of a matrix."""
        form = self.expression
        if not isinstance(form, MatrixBase):
            return ()
        return (form.rows,) if form.cols == 1 else (form.rows, form.cols)

    def __call__(self, **values: ArrayLike) -> Array:
        """Evaluate at values of all symbols by name; arrays are broadcast, entries come last.

        Raises `TypeError` when a symbol has no value, or a value no symbol.
        """
        names = [str(symbol) for symbol in self.symbols]
        if set(names) != set(values):
            raise TypeError(f"{self.claim}: expected {names}, found {sorted(values)}")
        arrays = np.broadcast_arrays(*(np.asarray(values[name], dtype=float) for name in names))
        common = arrays[0].shape if arrays else ()
        entries = [
            np.broadcast_to(np.asarray(function(*arrays), dtype=float), common)
            for function in self._functions
        ]
        return np.stack(entries, axis=-1).reshape(common + self.shape)
