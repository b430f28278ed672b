"""One choice of unknown functions at which two sides with integrals differ, enclosed rigorously.

`audit.integrals` proves, and refutes, what has one of its two forms. A false statement of any other
form is refuted by an example: a polynomial for each unknown function and a rational number for each
symbol. What is claimed of all functions is claimed of these, so two balls without a common point
show it to be false. Equal sides never come apart, and nothing is proved here.

An integral of a polynomial is exact; any other one is enclosed by Arb, its error included
(F. Johansson, Numerical integration in arbitrary-precision ball arithmetic, 2018). An integral of
an integral that is no polynomial is left alone: each value of the outer one would take another.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from operator import add, mul
from typing import Any, TypeAlias

import sympy as sp
from flint import acb, arb, ctx, fmpq
from sympy.core.function import AppliedUndef

from omniproof.decide.answer import Refuted, Witness
from omniproof.decide.balls import format_ball
from omniproof.decide.in_sympy.domain import Domain
from omniproof.decide.in_sympy.sampling import Sample, sample_points
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import SYMPY_FUNCTIONS

__all__ = ["counterexample"]

TIME = sp.Symbol("t", real=True)
DEGREES = (1, 2)
POINTS = 2
PRECISION = 64
MOST_EVALUATIONS = 4_000
"""Of an integrand; beyond it the ball is wide, and the sides are not told apart."""

Ball: TypeAlias = Any
"""An `acb` (python-flint publishes no types)."""
Shapes: TypeAlias = Mapping[Any, sp.Expr]
"""A polynomial in `TIME` for each unknown function."""


def counterexample(printed: Any, derived: Any, domain: Domain) -> Refuted | None:
    """Return functions and a point in the domain at which two sides certainly differ, if found."""
    sides = [sp.sympify(side) for side in (printed, derived)]
    unknown = set().union(*(side.atoms(AppliedUndef) for side in sides))
    if not unknown or not all(map(_may_be_any_polynomial, unknown)):
        return None
    symbols = set().union(*(side.free_symbols for side in sides))
    try:
        for degree in DEGREES:
            shapes = _shapes(sorted({f.func for f in unknown}, key=str), degree)
            known = [_integrated(_substituted(side, shapes)) for side in sides]
            for point in sample_points(symbols, domain, count=POINTS):
                if answer := _compared(known, shapes, point):
                    return answer
    except UnsupportedError:
        return None
    return None


def _may_be_any_polynomial(function: AppliedUndef) -> bool:
    signs = function.is_nonnegative, function.is_nonpositive
    return len(function.args) == 1 and signs == (None, None)


def _shapes(functions: list[Any], degree: int) -> Shapes:
    """Give each function a polynomial of its own: 1 + t/2, 2 + t/3, …."""
    return {
        function: sp.Add(k, *(TIME**n / (k + n) for n in range(1, degree + 1)))
        for k, function in enumerate(functions, 1)
    }


def _substituted(side: sp.Expr, shapes: Shapes) -> sp.Expr:
    for function, shape in shapes.items():
        side = side.replace(function, lambda place, shape=shape: shape.xreplace({TIME: place}))
    return side


def _integrated(side: sp.Expr) -> sp.Expr:
    """Carry out the integrals of polynomials, the inner ones first."""
    return side.replace(sp.Integral, _carried_out)


def _carried_out(integrand: sp.Expr, *limits: sp.Tuple) -> sp.Expr:
    for variable, lower, upper in limits:
        if integrand.has(sp.Integral) or not integrand.is_polynomial(variable):
            integrand = sp.Integral(integrand, (variable, lower, upper))
            continue
        whole = sp.Poly(integrand, variable).integrate(variable).as_expr()
        integrand = whole.xreplace({variable: upper}) - whole.xreplace({variable: lower})
    return integrand


def _compared(sides: list[sp.Expr], shapes: Shapes, point: Sample) -> Refuted | None:
    """Refute where the enclosures of both sides are finite and have no point in common."""
    with ctx.workprec(PRECISION):
        values = {symbol: acb(arb(number)) for symbol, number in point.items()}
        printed, derived = (_enclosed(side, values, analytic=False) for side in sides)
        # A side that is not real here, or may not be, is no value of a formula.
        if not all(ball.is_finite() and ball.imag.contains(0) for ball in (printed, derived)):
            return None
        if printed.real.overlaps(derived.real):
            return None
        names = {f"{f}({TIME})": sp.sstr(shape).replace("**", "^") for f, shape in shapes.items()}
        numbers = {symbol.name: str(number) for symbol, number in point.items()}
        shown = format_ball(printed.real), format_ball(derived.real)
        return Refuted(("flint",), Witness(names | numbers, *shown))


def _enclosed(node: Any, values: Mapping[sp.Symbol, Ball], *, analytic: bool) -> Ball:
    """Enclose an expression; where `analytic`, not finite unless it is so on all of the balls.

    Raises `UnsupportedError` for functions without an enclosure.
    """
    if node in values or isinstance(node, sp.Integral):
        return values[node] if node in values else _integral(node, values)
    if node.is_Rational or node is sp.pi:
        return acb(arb(fmpq(int(node.p), int(node.q)))) if node.is_Rational else acb.pi()
    parts = [_enclosed(part, values, analytic=analytic) for part in node.args]
    if node.is_Add or node.is_Mul:
        return reduce(add if node.is_Add else mul, parts)
    if node.is_Pow and node.exp.is_Rational and node.exp.q in {1, 2}:
        base = parts[0] if node.exp.q == 1 else parts[0].sqrt(analytic=analytic)
        return base ** int(node.exp.p)
    if isinstance(node, sp.Abs):
        return parts[0].real_abs(analytic=analytic)
    if type(node) not in _ENTIRE:
        raise UnsupportedError(f"{type(node).__name__} is not enclosed in an integral")
    return _ENTIRE[type(node)](*parts)


def _integral(node: sp.Integral, values: Mapping[sp.Symbol, Ball]) -> Ball:
    integrand = node.function
    if len(node.limits) != 1 or integrand.has(sp.Integral):
        raise UnsupportedError("an integral inside of an integral is not enclosed")
    ((variable, lower, upper),) = node.limits
    ends = [_enclosed(end, values, analytic=False) for end in (lower, upper)]
    # Tried before: what the integrand raises would be lost inside of Arb.
    _enclosed(integrand, {**values, variable: ends[0]}, analytic=False)

    def at(place: Ball, analytic: bool) -> Ball:
        return _enclosed(integrand, {**values, variable: place}, analytic=analytic)

    return acb.integral(at, *ends, eval_limit=MOST_EVALUATIONS)


FUNCTIONS: dict[str, Callable[[Ball], Ball]] = {
    "sin": lambda x: x.sin(), "cos": lambda x: x.cos(), "tan": lambda x: x.sin() / x.cos(),
    "cot": lambda x: x.cos() / x.sin(), "sec": lambda x: 1 / x.cos(), "csc": lambda x: 1 / x.sin(),
    "exp": lambda x: x.exp(), "sinh": lambda x: x.sinh(), "cosh": lambda x: x.cosh(),
    "tanh": lambda x: x.sinh() / x.cosh(),
}  # fmt: skip
"""Functions without branches; at a pole their balls are not finite."""
LACKING = {
    **dict.fromkeys(("sqrt", "abs"), "a rule of its own says where it is analytic"),
    **dict.fromkeys(("log", "arcsin", "arccos", "arctan", "atan2", "power"), "it has branches"),
    **dict.fromkeys(("sign", "max", "min"), "it is analytic nowhere on the complex plane"),
}
_ENTIRE = {SYMPY_FUNCTIONS[name]: function for name, function in FUNCTIONS.items()}
