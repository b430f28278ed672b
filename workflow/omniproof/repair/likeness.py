r"""When two printed formulas are one in two spellings.

Order of terms and factors, brackets, and the place of a sign or a number are a matter of taste: a
reader takes `-\sin(\alpha_1 - \alpha_2)` for `\sin(\alpha_2 - \alpha_1)`. Nothing is expanded, no
identity is used, so that other repairs stay other repairs.
"""

from __future__ import annotations

from dataclasses import fields
from fractions import Fraction
from math import prod
from typing import TypeAlias

from omniproof.transcription import tree
from omniproof.transcription.functions import FUNCTIONS

PARITY = {row.name: row.parity for row in FUNCTIONS.values() if row.parity}

Form: TypeAlias = tuple[object, ...]
ONE: Form = ("1",)


def likeness(node: tree.Node) -> Form:
    """Return a form that is equal for formulas that differ in spelling only."""
    return _scaled(node)


def _scaled(node: tree.Node) -> tuple[Fraction, Form]:
    """Take the number out of a formula: the number, and the rest."""
    while isinstance(node, tree.Power) and node.exponent == 1:
        node = node.base
    match node:
        case tree.Number(text):
            return Fraction(text), ONE
        case tree.Negative(operand):
            number, form = _scaled(operand)
            return -number, form
        case tree.Sum(parts) | tree.Product(parts):
            join = _sum if isinstance(node, tree.Sum) else _product
            return join([_scaled(part) for part in parts])
        case tree.Quotient(above, below):
            return _quotient(_scaled(above), _scaled(below))
        case tree.Call(function, argument) if function in PARITY:
            number, form = _scaled(argument)
            sign = -1 if number < 0 and PARITY[function] == "odd" else 1
            return Fraction(sign), (function, abs(number), form)
        case _:
            return Fraction(1), _plain(node)


def _sum(terms: list[tuple[Fraction, Form]]) -> tuple[Fraction, Form]:
    """Order the terms, in units of the first one."""
    ordered = sorted(terms, key=lambda term: (repr(term[1]), -term[0]))
    lead = ordered[0][0] or Fraction(1)
    return lead, ("Sum", *((number / lead, form) for number, form in ordered))


def _product(factors: list[tuple[Fraction, Form]]) -> tuple[Fraction, Form]:
    forms = sorted((form for _, form in factors if form != ONE), key=repr)
    product = forms[0] if len(forms) == 1 else ("Product", *forms) if forms else ONE
    return prod((number for number, _ in factors), start=Fraction(1)), product


def _quotient(above: tuple[Fraction, Form], below: tuple[Fraction, Form]) -> tuple[Fraction, Form]:
    number = above[0] / below[0] if below[0] else Fraction(0)
    return number, above[1] if below[1] == ONE else ("Quotient", above[1], below[1])


def _plain(node: tree.Node) -> Form:
    """A node with its own fields, its parts in their forms."""
    own = [getattr(node, item.name) for item in fields(node) if item.name != "span"]
    return (type(node).__name__, *(_part(value) for value in own))


def _part(value: object) -> object:
    if isinstance(value, tree.Node):
        return _scaled(value)
    return tuple(map(_part, value)) if isinstance(value, tuple) else value
