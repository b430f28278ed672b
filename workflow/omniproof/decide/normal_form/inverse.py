"""Functions of their own inverse, written without it.

The square of sqrt(u) is u, the root of u^2 is |u|, and cos(a + k arccos u) is a polynomial in
cos a, sin a, u and sqrt(1 - u^2). Each is the same wherever the inverse function is defined, so
that nothing is lost but where that is, which the print tells.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from omniproof.decide.normal_form.angles import CIRCULAR
from omniproof.formula.monomials import Monomial, OutsideError, expand
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
    root,
    subtract,
)

MOST_TURNS = 6
"""Multiples of one inverse function: each turn doubles the length of what is written."""

Point = tuple[Term, Term]
"""Cosine and sine of an angle."""


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
                return None if point is None else _OF_POINT[function](*point)
        return None

    return rebuild(term, change)


def _point(angle: Term) -> Point | None:
    """Return cosine and sine of an angle with inverse functions in it; None for any other."""
    try:
        multiples = expand(angle)
    except OutsideError:
        return None
    turned = {atom: factor for atom, factor in multiples.items() if _inverse(atom)}
    if not turned or any(f.denominator != 1 or abs(f) > MOST_TURNS for f in turned.values()):
        return None
    rest = _sum({atom: factor for atom, factor in multiples.items() if atom not in turned})
    point: Point = (ONE, ZERO) if rest is None else (Call("cos", (rest,)), Call("sin", (rest,)))
    for atom, factor in turned.items():
        cosine, sine = _known_point(atom)
        for _ in range(abs(int(factor))):
            point = _turn(point, (cosine, sine if factor > 0 else negative(sine)))
    return point


def _inverse(atom: Monomial) -> bool:
    match tuple(atom):
        case ((Call(function=function), 1),):
            return function in _POINTS
    return False


def _known_point(atom: Monomial) -> Point:
    ((call, _),) = atom
    assert isinstance(call, Call)
    return _POINTS[call.function](*call.arguments)


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
_OF_POINT: dict[str, Callable[[Term, Term], Term]] = {
    "cos": lambda c, s: c,
    "sin": lambda c, s: s,
    "tan": lambda c, s: divide(s, c),
    "cot": divide,
    "sec": lambda c, s: Power(c, -1),
    "csc": lambda c, s: Power(s, -1),
}
