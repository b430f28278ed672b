"""Functions of their own inverse, written without it.

The square of sqrt(u) is u, the root of u^2 is |u|, and cos(a + k arccos u) is a polynomial in
cos a, sin a, u and sqrt(1 - u^2). The exponential of a sum is a product, and that of log u is u.
Each is the same wherever the inverse function is defined, so that nothing is lost but where that
is, which the print tells.
"""

from __future__ import annotations

from fractions import Fraction

from omniproof.formula.angle import circular, inverse_function
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.functions import CIRCULAR, Point
from omniproof.formula.monomials import Monomial, expand
from omniproof.formula.term import (
    ONE,
    ZERO,
    Call,
    Number,
    Power,
    Product,
    Sum,
    Term,
    add,
    divide,
    multiply,
    negative,
    rebuild,
    subtract,
)

MOST_TURNS = 6
"""Multiples of one inverse function: each turn doubles the length of what is written."""


def without_inverse_functions(term: Term) -> Term:
    """Write powers of roots, roots of powers, and sines of inverse functions without these."""

    def change(part: Term) -> Term | None:
        match part:
            case Power(base=Call(function="sqrt", arguments=(inside,)), exponent=exponent):
                if exponent % 2 == 0:
                    return Power(without_inverse_functions(inside), exponent // 2)
            case Call(function="sqrt", arguments=(Power(base=inside, exponent=exponent),)):
                if exponent % 2 == 0:
                    size = Call("abs", (without_inverse_functions(inside),))
                    return Power(size, exponent // 2)
            case Call(function=function, arguments=(argument,)) if function in CIRCULAR:
                point = _point(without_inverse_functions(argument))
                return None if point is None else divide(*circular(function, ONE, *point))
            case Call(function="log", arguments=(Call(function="exp", arguments=(inside,)),)):
                return without_inverse_functions(inside)
            case Call(function="exp", arguments=(argument,)):
                return _exponential(without_inverse_functions(argument))
        return None

    return rebuild(term, change)


def _exponential(exponent: Term) -> Term | None:
    """Write exp(3x/2 + log u) as a power of exp(x/2) times u."""
    try:
        multiples = expand(exponent)
    except UnsupportedError:
        return None
    factors = [
        Power(_exponential_of(atom, factor.denominator), factor.numerator)
        for atom, factor in multiples.items()
    ]
    return multiply(*factors) if factors else ONE


def _exponential_of(atom: Monomial, part: int) -> Term:
    match tuple(atom):
        case ((Call(function="log", arguments=(inside,)), 1),) if part == 1:
            return inside
    powers = sorted((Power(base, count) for base, count in atom), key=repr)
    return Call("exp", (Product((Number(Fraction(1, part)), *powers)),))


def _point(angle: Term) -> Point | None:
    """Return cosine and sine of an angle with inverse functions in it; None for any other."""
    try:
        multiples = expand(angle)
    except UnsupportedError:
        return None
    points = {atom: known for atom in multiples if (known := inverse_function(atom))}
    turned = {atom: multiples.pop(atom) for atom in points}
    if not turned or any(f.denominator != 1 or abs(f) > MOST_TURNS for f in turned.values()):
        return None
    rest = _sum(multiples)
    point: Point = (ONE, ZERO) if rest is None else (Call("cos", (rest,)), Call("sin", (rest,)))
    for atom, factor in turned.items():
        cosine, sine = points[atom]
        for _ in range(abs(int(factor))):
            point = _turn(point, (cosine, sine if factor > 0 else negative(sine)))
    return point


def _sum(multiples: dict[Monomial, Fraction]) -> Term | None:
    terms = [
        Product((Number(factor), *(Power(base, count) for base, count in atom)))
        for atom, factor in multiples.items()
    ]
    return add(*terms) if terms else None


def _turn(one: Point, other: Point) -> Point:
    """Add two angles."""
    (c, s), (d, t) = one, other
    return subtract(multiply(c, d), multiply(s, t)), Sum((multiply(c, t), multiply(s, d)))
