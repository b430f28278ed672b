"""A function over a box as a quotient N/D of functions without poles.

SymPy proposes N and D, as it proposes factors; the normal form proves that N/D is what is printed,
and only then do balls look at either.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import sympy as sp
from flint import fmpq

from omniproof.audit.balls import compile_balls, exact_number
from omniproof.audit.box import Box
from omniproof.audit.sampling import sample_points
from omniproof.audit.sympy_domain import Domain
from omniproof.decide.answer import Witness
from omniproof.decide.balls import enclose, format_ball, sign_of
from omniproof.decide.exact import sign
from omniproof.decide.normal_form.form import normal_form
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Term, divide, substitute

PROBES = 40
QUOTIENTS = {
    sp.tan: lambda x: sp.sin(x) / sp.cos(x),
    sp.cot: lambda x: sp.cos(x) / sp.sin(x),
    sp.sec: lambda x: 1 / sp.cos(x),
    sp.csc: lambda x: 1 / sp.sin(x),
}


class Family(Protocol):
    """An expression over a box: what a derivation gives, or `OnBox`."""

    @property
    def expression(self) -> sp.Expr:
        """The function."""

    @property
    def box(self) -> Mapping[sp.Symbol, tuple[Any, Any]]:
        """Open intervals of its symbols, with exact end points."""


@dataclass(frozen=True)
class OnBox:
    """The engine's own family."""

    expression: sp.Expr
    box: Mapping[sp.Symbol, tuple[Any, Any]]
    printed: Term | None = None
    """The expression before SymPy had an idea of it, if it was printed."""


@dataclass(frozen=True)
class Quotient:
    """`value` = `numerator` / `denominator` on an open box.

    The symbols of `box` are real, and positive where their range is; `asked` are the symbols of the
    question, in the same order.
    """

    value: sp.Expr
    numerator: sp.Expr
    denominator: sp.Expr
    box: Box
    asked: tuple[sp.Symbol, ...]
    term: Term
    """The value before SymPy had an idea of it."""

    @staticmethod
    def of(family: Family) -> Quotient:
        """Prepare a family; raises `UnsupportedError` when its box lacks a symbol or is no box."""
        asked = Box.of(family.box)
        sides = zip(asked.symbols, asked.sides, strict=True)
        signed = {symbol: _signed(symbol, lower) for symbol, (lower, _) in sides}
        value = exact_number(family.expression).subs(signed)
        box = Box(tuple(signed.values()), asked.sides)
        compile_balls([value], box.symbols)  # refuses what cannot be enclosed
        plain = value
        for function, quotient in QUOTIENTS.items():
            plain = plain.replace(function, quotient)
        numerator, denominator = sp.fraction(sp.together(plain))
        printed = getattr(family, "printed", None) or term_of(family.expression)
        _confirm(printed, divide(term_of(numerator), term_of(denominator)), box)
        return Quotient(value, numerator, denominator, box, asked.symbols, printed)

    def is_pole(self, point: tuple[Any, ...]) -> bool:
        """Whether the denominator vanishes at an exact point."""
        return sign(substitute(term_of(self.denominator), self._place(point))) == 0

    def value_at(self, point: tuple[Any, ...]) -> Term:
        """Return what is printed at a rational or exact point, as it is."""
        return substitute(self.term, self._place(point))

    def _place(self, point: tuple[Any, ...]) -> dict[str, Term]:
        places = zip(self.box.symbols, point, strict=True)
        return {symbol.name: term_of(exact_number(x)) for symbol, x in places}

    def witness(self, point: tuple[Any, ...], printed: str, derived: str) -> Witness:
        """Show a rational or exact point, with what is said of it."""
        place = {s.name: x for s, x in zip(self.box.symbols, point, strict=True)}
        exact = {name: exact_number(x) for name, x in place.items()}
        names = {name: str(x) for name, x in place.items()}
        return Witness(names, printed, derived, exact=exact)

    def digits(self, point: tuple[Any, ...]) -> str:
        """Write the value at a rational or exact point, to six significant digits."""
        return format_ball(enclose(self.value_at(point)), 6)

    def find(self, term: Term, sign: int) -> tuple[fmpq, ...] | None:
        """Look for a rational point of the box where a term has a certain sign."""
        sides = {s.name: side for s, side in zip(self.box.symbols, self.box.sides, strict=True)}
        for point in sample_points(self.box.symbols, Domain(sides), count=PROBES):
            values = {symbol.name: value for symbol, value in point.items()}
            if sign_of(enclose(term, values)) == sign:
                return tuple(point[symbol] for symbol in self.box.symbols)
        return None


def _confirm(printed: Term, quotient: Term, box: Box) -> None:
    """Prove that SymPy's quotient is what is printed; raises `UnsupportedError` where it fails."""
    form = normal_form(printed, quotient, frozenset(s.name for s in box.symbols if s.is_positive))
    if not (form.is_zero or all(true for _, true in form.patterns())):
        raise UnsupportedError("it is not proved to be the quotient that SymPy takes it for")


def _signed(symbol: sp.Symbol, lower: sp.Expr) -> sp.Symbol:
    """Give a symbol the sign that its range has, so that sqrt(x) and |x| become plain."""
    return sp.Symbol(
        symbol.name, **({"positive": True} if lower.is_nonnegative else {"real": True})
    )
