"""Order between two terms, by the engines that ask in SymPy."""

from __future__ import annotations

from omniproof.decide.answer import Answer
from omniproof.decide.domain import Domain
from omniproof.decide.in_sympy.domain import converter_for, in_sympy
from omniproof.decide.order import comparison
from omniproof.decide.order.hypotheses import domain_of
from omniproof.formula.term import Term, symbols
from omniproof.formula.where_defined import requirements


def compare(left: Term, operator: str, right: Term, domain: Domain) -> Answer:
    r"""Decide `left operator right` as `comparison.compare` does, wherever all parts are defined.

    An order may fail at a single point, so that each that is left out has to be told. Raises
    `UnsupportedError` where none is left.
    """
    converter = converter_for(domain, symbols(left) | symbols(right))
    needed = map(converter.expression, requirements(left, right))
    within = domain_of(needed, in_sympy(domain, converter))
    sides = converter.expression(left), converter.expression(right)
    return comparison.compare(sides[0], operator, sides[1], within, (left, right))
