"""Rational points of a domain, for what asks in SymPy."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import sympy as sp
from flint import fmpq

from omniproof.decide import sampling
from omniproof.decide.in_sympy.domain import REALS, Domain, in_terms

Sample = dict[sp.Symbol, fmpq]


def sample_points(
    symbols: Iterable[sp.Symbol], domain: Domain = REALS, **options: Any
) -> Iterator[Sample]:
    """Yield rational points inside the domain as `decide.sampling` does, by SymPy's symbols."""
    named = {symbol.name: symbol for symbol in symbols}
    for point in sampling.sample_points(named, in_terms(domain, named.values()), **options):
        yield {named[name]: number for name, number in point.items()}
