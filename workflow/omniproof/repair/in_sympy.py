"""Values of SymPy's expressions in plain floating point: what a derivation gives, as terms."""

from __future__ import annotations

from typing import Any

from omniproof.decide.in_sympy.domain import REALS, Domain, in_terms
from omniproof.decide.in_sympy.integrals import flattened
from omniproof.formula.sympy_terms import Converter
from omniproof.repair import values
from omniproof.repair.values import Values


def at_points(value: Any, domain: Domain = REALS) -> Values:
    """Evaluate an expression or a matrix as `values.at_points` does, with the signs of its symbols.

    Raises `UnsupportedError` for a function that balls do not know, or an empty domain.
    """
    value = flattened(value)
    symbols = value.free_symbols
    ranges = Domain({symbol.name: domain.interval(symbol.name) for symbol in symbols})
    return values.at_points(Converter().value(value), in_terms(ranges, symbols))
