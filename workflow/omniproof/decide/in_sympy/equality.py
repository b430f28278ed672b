"""Equality of what derivations give in SymPy: by way of terms, through the one door."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from omniproof.decide import confirm, zero_test
from omniproof.decide import domain as decide
from omniproof.decide.answer import Answer, OnBranch, Undecided
from omniproof.decide.in_sympy.balls import exact_number
from omniproof.decide.in_sympy.domain import REALS, Domain, in_symbols, in_terms
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Term, multiply
from omniproof.formula.value import Value, kind


def confirmed_equal(
    printed: Any, derived: Any, domain: Domain = REALS, *, enough: int | None = None
) -> Answer:
    """Decide whether two expressions agree, as `decide.confirm` does."""
    return _asked(partial(confirm.confirmed_equal, enough=enough), printed, derived, domain)


def equal_to_derived(side: Value, derived: Any, domain: decide.Domain, factor: Any = 1) -> Answer:
    """Decide whether a factor times a printed side, in terms, is what a derivation gives."""
    if not isinstance(side, Term):
        return Undecided(f"it is {kind(side)}, and no number")
    try:
        printed = side if factor == 1 else multiply(term_of(factor), side)
        return confirm.confirmed_equal(printed, term_of(derived), domain)
    except UnsupportedError as reason:
        return Undecided(str(reason))


def decide_equal(printed: Any, derived: Any, domain: Domain = REALS) -> Answer:
    """Decide whether two expressions agree, by the first engine alone."""
    return _asked(zero_test.decide_equal, printed, derived, domain)


def _asked(engine: Callable[..., Answer], printed: Any, derived: Any, domain: Domain) -> Answer:
    sides = exact_number(printed), exact_number(derived)
    symbols = sides[0].free_symbols | sides[1].free_symbols
    try:
        answer = engine(*map(term_of, sides), in_terms(domain, symbols))
    except UnsupportedError as reason:
        return Undecided(str(reason))
    return in_symbols(answer, symbols) if isinstance(answer, OnBranch) else answer
