"""Derivations by claim id: what mechanics implies, as code that never sees what is printed.

A paper's `derivations.py` fills one `Registry`. A derivation is a function without arguments; what
it returns depends on the kind of its claim (see `Derived`). It imports `omniproof.kinematics` and
SymPy only.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any, TypeAlias

from sympy import Expr, MatrixBase, Symbol


@dataclass(frozen=True)
class Family:
    """An expression over a box of its symbols (open intervals with exact end points)."""

    expression: Expr
    box: Mapping[Symbol, tuple[Expr, Expr]]


Derived: TypeAlias = Any
"""What a derivation returns, by the kind of its claim (SymPy publishes no types):

identity: an expression, or a matrix for a printed matrix; value: an exact number; relation: what its
`Form` says (a `Family`, a sequence or named values, a condition).
"""


@dataclass(frozen=True)
class Derivation:
    """How one claim follows, and on which other claims of the paper it rests."""

    build: Callable[[], Derived]
    rests_on: tuple[str, ...] = ()
    premise: str = ""
    convention: str = ""


@dataclass
class Registry:
    """All derivations and quantities of one paper."""

    paper: str
    derivations: dict[str, Derivation] = field(default_factory=dict)
    quantities: dict[str, Callable[[], Expr | MatrixBase]] = field(default_factory=dict)

    def derives(
        self, *ids: str, rests_on: Sequence[str] = (), premise: str = ""
    ) -> Callable[[Callable[[], Derived]], Callable[[], Derived]]:
        """Bind a function to claims; `premise` states a `model-gap`, in words, where there is one.

        Raises `ValueError` when an id is bound twice.
        """

        def bind(build: Callable[[], Derived]) -> Callable[[], Derived]:
            for claim in ids:
                if claim in self.derivations:
                    raise ValueError(f"{self.paper}: two derivations for {claim}")
                self.derivations[claim] = Derivation(build, tuple(rests_on), premise)
            return build

        return bind

    def quantity(
        self, name: str
    ) -> Callable[[Callable[[], Expr | MatrixBase]], Callable[[], Expr | MatrixBase]]:
        """Give a printed symbol of role `quantity` its meaning."""

        def bind(build: Callable[[], Expr | MatrixBase]) -> Callable[[], Expr | MatrixBase]:
            if name in self.quantities:
                raise ValueError(f"{self.paper}: two meanings for {name}")
            self.quantities[name] = build
            return build

        return bind


def load_registry(paper: str) -> Registry:
    """Import `omniproof.papers.<paper>.derivations` and return its `REGISTRY`.

    Raises `ModuleNotFoundError` when no such paper is known.
    """
    module = import_module(f"omniproof.papers.{paper.replace('-', '_')}.derivations")
    registry: Registry = module.REGISTRY
    return registry
