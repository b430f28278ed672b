"""Angles and functions of them as language: what all engines read alike, before any arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple, TypeAlias, TypeVar

from omniproof.formula.monomials import Monomial, expand
from omniproof.formula.term import (
    ONE,
    PI,
    Call,
    Pi,
    Power,
    Sum,
    Symbol,
    Term,
    divide,
    root,
    subtract,
)

CIRCULAR = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})
Point: TypeAlias = tuple[Term, Term]
"""Cosine and sine of an angle."""
T = TypeVar("T")


class Angle(NamedTuple):
    """Sum of rational multiples of atoms, plus `turns` times pi."""

    multiples: dict[Monomial, Fraction]
    turns: Fraction


def angle_of(argument: Term) -> Angle:
    """Split the argument of a circular function; raises `UnsupportedError` as `expand` does."""
    multiples = expand(argument)
    turns = multiples.pop(frozenset({(PI, 1)}), Fraction(0))
    return Angle(multiples, turns)


def is_independent(atom: Monomial) -> bool:
    """Whether an atom is a product of powers of symbols and pi, with a symbol in it."""
    bases = [base for base, _ in atom if not isinstance(base, Pi)]
    return bool(bases) and all(isinstance(base, Symbol) for base in bases)


def circular(function: str, one: T, cosine: T, sine: T) -> tuple[T, T]:
    """Return numerator and denominator of a circular function at a point of the circle."""
    return {
        "cos": (cosine, one),
        "sin": (sine, one),
        "tan": (sine, cosine),
        "cot": (cosine, sine),
        "sec": (one, cosine),
        "csc": (one, sine),
    }[function]


def inverse_function(atom: Monomial) -> Point | None:
    """Return cosine and sine of an atom that is an inverse function; None for any other atom."""
    match tuple(atom):
        case ((Call(function=function, arguments=arguments), 1),) if function in _POINTS:
            return _POINTS[function](*arguments)
    return None


def _complement(x: Term) -> Term:
    return root(subtract(ONE, Power(x, 2)))


def _of_tangent(x: Term) -> Point:
    length = root(Sum((ONE, Power(x, 2))))
    return divide(ONE, length), divide(x, length)


def _of_point(y: Term, x: Term) -> Point:
    length = root(Sum((Power(x, 2), Power(y, 2))))
    return divide(x, length), divide(y, length)


_POINTS: dict[str, Callable[..., Point]] = {
    "arcsin": lambda x: (_complement(x), x),
    "arccos": lambda x: (x, _complement(x)),
    "arctan": _of_tangent,
    "atan2": _of_point,
}
