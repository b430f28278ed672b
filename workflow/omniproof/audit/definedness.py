r"""Where a printed formula is defined: told by its tree, since a value forgets what cancels.

`\frac{x^2}{x}` becomes `x` and `(\sqrt{x})^2` too, but neither says anything at x = -1 or at x = 0,
respectively. A statement is made wherever every printed part is defined: each denominator is not 0,
each radicand not negative, the argument of an inverse function in its range, a matrix that is
inverted not singular, a tangent away from its poles.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import sympy as sp

from omniproof.formula.sympy_terms import FUNCTIONS
from omniproof.transcription import tree

Evaluate = Callable[[tree.Node], Any]
POLES = {"tan": sp.cos, "sec": sp.cos, "cot": sp.sin, "csc": sp.sin}
"""What must not vanish where a function is defined."""


def conditions(node: tree.Node, value: Evaluate) -> tuple[Any, ...]:
    """Return what has to hold for each printed part to be defined, as SymPy relations.

    `value` gives the value of a part of the tree. What holds for all values of the symbols is left
    out, and so is what a quantity hides. Parts without symbols ask for nothing here.
    """
    needed = (each for part in _unbound(node) for each in _needs(part, value))
    return tuple(dict.fromkeys(each for each in needed if not _is_evident(each)))


def lost_conditions(node: tree.Node, value: Evaluate) -> tuple[Any, ...]:
    """Return those of the conditions that the value of a formula no longer shows."""
    needed = conditions(node, value)
    scalars = list(_scalars(value(node))) if needed else []
    divisors = set().union(*map(_divisors, scalars))
    radicands = set().union(*map(_radicands, scalars))

    def is_shown(condition: Any) -> bool:
        if isinstance(condition, sp.Ne):
            return condition.lhs in divisors
        own = _radicands(sp.sqrt(condition.gts - condition.lts))
        return bool(own) and own <= radicands

    return tuple(each for each in needed if not is_shown(each))


def _unbound(node: tree.Node) -> Iterator[tree.Node]:
    """Walk a tree, but not into what holds for some values only: integrands, branches, sets."""
    yield node
    if isinstance(node, tree.Integral):
        inside: tuple[tree.Node, ...] = (node.lower, node.upper)
    else:
        inside = () if isinstance(node, tree.Cases | tree.SetBuilder) else tree.children(node)
    for child in inside:
        yield from _unbound(child)


def _needs(node: tree.Node, value: Evaluate) -> Iterator[Any]:
    match node:
        case tree.Quotient(denominator=below):
            yield from _differ_from_0(value(below))
        case tree.Power(base=base, exponent=exponent) if exponent < 0:
            size = value(base)
            is_matrix = isinstance(size, sp.MatrixBase)
            yield from _differ_from_0(size.det(method="laplace") if is_matrix else size)
        case tree.Call(function="sqrt", argument=radicand):
            yield sp.Ge(value(radicand), 0, evaluate=False)
        case tree.Call(function="arcsin" | "arccos", argument=argument):
            place = value(argument)
            yield sp.Le(place, 1, evaluate=False)
            yield sp.Ge(place, -1, evaluate=False)
        case tree.Call(function="atan2", argument=tree.Tuple(items=(ordinate, abscissa))):
            yield from _differ_from_0(value(ordinate) ** 2 + value(abscissa) ** 2)
        case tree.Call(function=function, argument=argument) if function in POLES:
            yield from _differ_from_0(POLES[function](value(argument)))


def _differ_from_0(value: Any) -> Iterator[Any]:
    """Say of each factor that it does not vanish."""
    for factor in _factors(value):
        yield sp.Ne(factor, 0, evaluate=False)


def _is_evident(condition: Any) -> bool:
    if not condition.free_symbols:
        return True
    if isinstance(condition, sp.Ne):
        return bool(condition.lhs.is_nonzero)
    return bool((condition.gts - condition.lts).is_nonnegative)


def _scalars(value: Any) -> Iterator[Any]:
    """Yield the numbers in a value: a list of sides, a matrix, an expression, a relation."""
    if isinstance(value, tuple | sp.MatrixBase):
        for part in value:
            yield from _scalars(part)
    else:
        yield value


def _divisors(value: Any) -> set[Any]:
    """Collect the factors that a value itself keeps from vanishing."""
    powers = (power for power in value.atoms(sp.Pow) if power.exp.is_negative)
    found = {factor for power in powers for factor in _factors(power.base)}
    for name, pole in POLES.items():
        found |= {pole(call.args[0]) for call in value.atoms(FUNCTIONS[name])}
    return found


def _factors(value: Any) -> tuple[Any, ...]:
    """Return the variable factors of a product, each once, without its power and its sign."""
    bases = (factor.as_base_exp()[0] for factor in sp.Mul.make_args(value))
    variable = (base for base in bases if base.free_symbols)
    unsigned = (-base if base.could_extract_minus_sign() else base for base in variable)
    return tuple(dict.fromkeys(unsigned))


def _radicands(value: Any) -> set[Any]:
    """Collect what a value itself keeps from being negative."""
    powers = (power for power in value.atoms(sp.Pow) if power.exp.is_Rational)
    found = {power.base for power in powers if not power.exp.is_Integer}
    for call in value.atoms(sp.asin, sp.acos):
        found |= {1 - call.args[0], 1 + call.args[0]}
    return found
