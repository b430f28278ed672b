"""The sign of a term as far as its form shows it: even powers, products, sums of one sign.

For each part, the signs that it may have. A sum of squares and a product of positive symbols need
no other proof, on any domain and with any number of symbols.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from itertools import product
from math import prod

from omniproof.decide.exact import sign
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.term import Call, Power, Product, Sum, Symbol, Term, symbols, walk

Signs = frozenset[int]
ANY: Signs = frozenset({-1, 0, 1})
KEPT: dict[str, Callable[[int], bool]] = {
    ">": lambda sign: sign > 0,
    "\\geq": lambda sign: sign >= 0,
    "<": lambda sign: sign < 0,
    "\\leq": lambda sign: sign <= 0,
    "\\neq": lambda sign: sign != 0,
    "=": lambda sign: sign == 0,
}
"""The signs of numbers that stand to 0 in a relation."""
_OF_FUNCTIONS: dict[str, Callable[[Signs], Signs]] = {
    "abs": lambda inside: frozenset(map(abs, inside)),
    "sqrt": lambda inside: frozenset(map(abs, inside)),
    "exp": lambda _: frozenset({1}),
    "cosh": lambda _: frozenset({1}),
    "arccos": lambda _: frozenset({0, 1}),
    "sign": lambda inside: inside,
    "arctan": lambda inside: inside,
    "arcsin": lambda inside: inside,
    "sinh": lambda inside: inside,
    "tanh": lambda inside: inside,
}
"""A root has the sign of its radicand where it is defined."""


def is_evident(
    term: Term,
    relation: str,
    assumed: Collection[tuple[str, str]] = (),
    apart: Collection[Term] = (),
) -> bool:
    r"""Whether the form of a term shows that it stands so to 0 wherever it is defined.

    `assumed` are pairs of a symbol's name and how it stands to 0; the terms in `apart` are not 0.
    """
    return all(map(KEPT[relation], possible_signs(term, assumed, apart)))


def possible_signs(
    term: Term, assumed: Collection[tuple[str, str]] = (), apart: Collection[Term] = ()
) -> Signs:
    """Return the signs -1, 0 or 1 that a term may have where it is defined, and some that not."""
    found: dict[Term, Signs] = {}
    for part in walk(term):
        own = _own(part, found, assumed)
        found[part] = own - {0} if part in apart else own
    return found[term]


def _own(part: Term, found: dict[Term, Signs], assumed: Collection[tuple[str, str]]) -> Signs:
    if not symbols(part):
        return _of_number(part)
    signs = [found[each] for each in part.parts]
    match part:
        case Symbol(name=name):
            relations = [KEPT[relation] for known, relation in assumed if known == name]
            return frozenset(sign for sign in ANY if all(keeps(sign) for keeps in relations))
        case Sum():
            return _of_sum(signs)
        case Product():
            return frozenset(map(prod, product(*signs)))
        case Power(exponent=exponent):
            return frozenset(sign**exponent for sign in signs[0] if sign or exponent >= 0)
    known = _OF_FUNCTIONS.get(part.function) if isinstance(part, Call) else None
    return known(*signs) if known else ANY


def _of_number(part: Term) -> Signs:
    try:
        return frozenset({sign(part)})
    except UnsupportedError:
        return ANY


def _of_sum(signs: Sequence[Signs]) -> Signs:
    """Return what numbers of these signs add up to: of two signs, anything."""
    either = frozenset().union(*signs)
    if {-1, 1} <= either:
        return ANY
    return either - {0} if any(0 not in each for each in signs) else either
