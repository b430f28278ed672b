"""Equations with integrals and functions that nobody knows, by way of SymPy."""

from __future__ import annotations

from omniproof.decide.answer import Refuted, Undecided
from omniproof.decide.domain import Domain
from omniproof.decide.in_sympy.counterexample import counterexample
from omniproof.decide.in_sympy.domain import converter_for, in_sympy
from omniproof.decide.in_sympy.integrals import without_integrals
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Term, symbols


def in_symbols(left: Term, right: Term, domain: Domain) -> tuple[Term, Term] | Refuted | Undecided:
    """Return two sides with symbols in the place of functions and integrals, equal as these are.

    Where that is not possible, an answer: refuted by an example, or undecided.
    """
    converter = converter_for(domain, symbols(left) | symbols(right))
    sides = converter.expression(left), converter.expression(right)
    try:
        reduced = without_integrals(*sides)
        return term_of(reduced[0]), term_of(reduced[1])
    except UnsupportedError as reason:
        return counterexample(*sides, in_sympy(domain, converter)) or Undecided(str(reason))
