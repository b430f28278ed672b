"""Angles and functions of them as language: what all engines read alike, before any arithmetic."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple, TypeVar

from omniproof.formula.functions import ANGLES, Point, angle
from omniproof.formula.monomials import Monomial, expand
from omniproof.formula.term import (
    PI,
    Call,
    Pi,
    Symbol,
    Term,
)
from omniproof.transcription.functions import FUNCTIONS

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
    parts = {"1": one, "c": cosine, "s": sine}
    above, below = FUNCTIONS[function].circle or ("", "")
    return parts[above], parts[below]


def inverse_function(atom: Monomial) -> Point | None:
    """Return cosine and sine of an atom that is an inverse function; None for any other atom."""
    match tuple(atom):
        case ((Call(function=function, arguments=arguments), 1),) if function in ANGLES:
            return angle(function, *arguments)
    return None
