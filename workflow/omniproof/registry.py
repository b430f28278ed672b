"""Derivations by claim id: what mechanics implies, as code that never sees what is printed.

A paper's `derivations` fill one `Registry`. A derivation is a function that returns what its claim
ought to say; what that is depends on the kind of the claim (see `Derived`). Derivations import
`omniproof.kinematics`, SymPy and the records of this module only.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib import import_module
from typing import Any, TypeAlias

from sympy import Expr, MatrixBase, Symbol

from omniproof.transcription.known import Known
from omniproof.transcription.model import Form, Role

Derived: TypeAlias = Any
"""What a derivation returns, by the kind of its claim (SymPy publishes no types):

identity: an expression, or a matrix for a printed one, or `Modelled` where the paper's premises and
mechanics part; value: an exact number, or a `Fit`; relation: a `Relation`, or just its subject.
"""


@dataclass(frozen=True)
class Modelled:
    """The derived side of an identity whose premises contradict the mechanics they describe.

    `mechanics` is what the printed form is judged against; `premises` is what follows from the
    paper's own premises (both expressions, or matrices of one shape); `gap` names the premise.
    """

    mechanics: Expr | MatrixBase
    premises: Expr | MatrixBase
    gap: str


@dataclass(frozen=True)
class Fit:
    """A printed number from a set-up that is printed wrongly or not at all: its cells tell it.

    `value` is the number by the unknowns of the set-up, the first of which is shown. `setup` is one
    set-up from which the `cells` follow, rounded or truncated: claims that are derived in the same
    way. A claim that is none of them is a number of the set-up.
    """

    value: Expr
    setup: Mapping[Symbol, Expr]
    cells: tuple[str, ...]


@dataclass(frozen=True)
class Family:
    """An expression over a box of its symbols (open intervals with exact end points)."""

    expression: Expr
    box: Mapping[Symbol, tuple[Expr, Expr]]


@dataclass(frozen=True)
class Curve:
    """Two or three coordinates over the box of one parameter; other symbols are constants."""

    coordinates: tuple[Expr, ...]
    box: Mapping[Symbol, tuple[Expr, Expr]]


@dataclass(frozen=True)
class Ordered:
    """Expressions over a box, of which each is to be less than the next one."""

    terms: tuple[Expr, ...]
    box: Mapping[Symbol, tuple[Expr, Expr]]


Subject: TypeAlias = Any
"""What a `Form` is judged on: a `Family`, a `Curve`, `Ordered` expressions, a sequence of
expressions, named values, a condition."""


@dataclass(frozen=True)
class Obligation:
    """A statement for the engines to prove: `form` holds for `subject`."""

    form: Form
    subject: Subject
    at: tuple[tuple[Expr, ...], ...] = ()
    member: str | None = None


@dataclass(frozen=True)
class Relation:
    """The derived side of a relation.

    Where the printed relation is false, `correction` says what holds instead, or `condition` under
    which condition the printed one holds; either counts only when all of `proof` is proved.
    `premises` is the subject as the paper's own premises have it, where mechanics contradicts them.
    """

    subject: Subject
    correction: str = ""
    condition: str = ""
    proof: tuple[Obligation, ...] = ()
    premises: Subject = None


@dataclass(frozen=True)
class Derivation:
    """How one claim follows, and on which other claims of the paper it rests.

    Nothing in the paper rests on what is `idle`: a fault there moves no robot.
    """

    build: Callable[..., Derived]
    rests_on: tuple[str, ...] = ()
    convention: str = ""
    meanings: Callable[[], Mapping[str, Any]] = dict
    idle: bool = False


@dataclass(frozen=True)
class Convention:
    """Readings of a definition between which a paper wavers; the first one is what it states."""

    stated: str
    others: tuple[str, ...]

    @property
    def options(self) -> tuple[str, ...]:
        """All readings, the stated one first."""
        return (self.stated, *self.others)


@dataclass(frozen=True)
class Symbols:
    """What the symbols of a paper are: SymPy's, with their signs.

    `variables` stand for numbers; `ranges` are open intervals that some of them are confined to in
    the whole paper. What is `undefined` is printed, and never introduced.
    """

    variables: tuple[Symbol, ...]
    ranges: Mapping[Symbol, tuple[Expr, Expr]] = field(default_factory=dict)
    undefined: tuple[Symbol, ...] = ()

    @cached_property
    def by_name(self) -> dict[str, Symbol]:
        """All of them by name."""
        return {symbol.name: symbol for symbol in (*self.variables, *self.undefined)}


Bind: TypeAlias = Callable[[Callable[..., Derived]], Callable[..., Derived]]


@dataclass
class Registry:
    """All derivations, quantities and conventions of one paper, and names for long expressions."""

    paper: str
    derivations: dict[str, Derivation] = field(default_factory=dict)
    quantities: dict[str, Callable[[], Expr | MatrixBase]] = field(default_factory=dict)
    conventions: dict[str, Convention] = field(default_factory=dict)
    abbreviations: dict[str, Callable[[], Expr]] = field(default_factory=dict)
    """LaTeX for an expression that would fill a line wherever it occurs in a derived form."""
    arguments: dict[str, tuple[Symbol, ...]] = field(default_factory=dict)
    """What a quantity is a function of, by its name."""
    symbols: Symbols | None = None
    """What the symbols are; None: no code says it, and the paper file may."""

    @property
    def known(self) -> Known | None:
        """What the paper file need not say of its symbols: their roles, and what functions are of.

        None where it may say so itself.
        """
        if self.symbols is None:
            return None
        roles = dict.fromkeys((symbol.name for symbol in self.symbols.variables), Role.VARIABLE)
        roles |= dict.fromkeys((symbol.name for symbol in self.symbols.undefined), Role.UNDEFINED)
        roles |= dict.fromkeys(self.quantities, Role.QUANTITY)
        of = {
            name: tuple(variable.name for variable in self.arguments.get(name, ()))
            for name in self.quantities
        }
        return Known(self.paper, roles, of)

    def derives(
        self,
        *ids: str,
        rests_on: Sequence[str] = (),
        convention: str = "",
        meanings: Callable[[], Mapping[str, Any]] = dict,
        idle: bool = False,
    ) -> Bind:
        """Bind a function to claims.

        With `convention` (a claim id), the function takes one of that convention's options. With
        `idle`, the paper draws no conclusion from the faulty part of what it prints there.
        `meanings` gives printed quantities another value for these claims only (any vectors, say,
        in a lemma that the paper states with the columns of its matrix).
        Raises `ValueError` when an id is bound twice.
        """

        def bind(build: Callable[..., Derived]) -> Callable[..., Derived]:
            for claim in ids:
                if claim in self.derivations:
                    raise ValueError(f"{self.paper}: two derivations for {claim}")
                self.derivations[claim] = Derivation(
                    build, tuple(rests_on), convention, meanings, idle
                )
            return build

        return bind

    def quantity(self, name: str, of: Sequence[Symbol] = ()) -> Bind:
        """Give a printed symbol of role `quantity` its meaning, by the symbol's `name`.

        With `of`, it is a function: printed arguments take the place of these symbols.
        Raises `ValueError` when a name is bound twice.
        """

        def bind(build: Callable[..., Derived]) -> Callable[..., Derived]:
            if name in self.quantities:
                raise ValueError(f"{self.paper}: two meanings for {name}")
            self.quantities[name] = build
            self.arguments[name] = tuple(of)
            return build

        return bind


def load_registry(paper: str) -> Registry:
    """Import `omniproof.papers.<paper>.derivations` and return its `REGISTRY`.

    Raises `ModuleNotFoundError` when no such paper is known.
    """
    module = import_module(f"omniproof.papers.{paper.replace('-', '_')}.derivations")
    registry: Registry = module.REGISTRY
    return registry


@dataclass(frozen=True)
class Step:
    """One step of a proof: what it says (Markdown), and what the engines have to prove for it."""

    says: str
    obligations: Callable[[], Sequence[Obligation]]


@dataclass(frozen=True)
class Theorem:
    """A result that no paper prints; `id` is `thm:` and a slug, the texts are Markdown."""

    id: str
    title: str
    statement: str
    papers: tuple[str, ...]
    steps: tuple[Step, ...]
