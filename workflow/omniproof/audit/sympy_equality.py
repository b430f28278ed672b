"""Equality of what derivations give in SymPy: by way of terms, through the one door."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from omniproof.audit.balls import exact_number
from omniproof.audit.sympy_domain import REALS, Domain, in_symbols, in_terms
from omniproof.decide import confirm, zero_test
from omniproof.decide.answer import Answer, OnBranch, Undecided
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of


def confirmed_equal(
    printed: Any, derived: Any, domain: Domain = REALS, *, enough: int | None = None
) -> Answer:
    """Decide whether two expressions agree, as `decide.confirm` does."""
    return _asked(partial(confirm.confirmed_equal, enough=enough), printed, derived, domain)


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
