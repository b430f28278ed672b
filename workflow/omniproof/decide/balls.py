"""Rigorous evaluation of terms in ball arithmetic (Arb, through python-flint).

A ball is a midpoint with a radius that is certain to enclose the exact value, so a ball that keeps
clear of zero *proves* that a number is not zero; that is how every witness of the audit is found.
A term is compiled once, to a flat list of steps with shared parts. The same steps run over balls
(values), over wide balls (ranges on a cell of a box) and over power series with ball coefficients
(derivatives), which spares symbolic differentiation and its swollen results.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import repeat
from math import isfinite
from operator import mul
from typing import Any, TypeAlias

from flint import arb, arb_series, ctx, fmpq

from omniproof.formula.errors import UnsupportedError
from omniproof.formula.term import (
    Call,
    Integral,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    Term,
    walk,
)

CANCELLED = 1e-20
"""A ball about 0 of this radius is shown as 0: a witness has 20 digits at most to tell it apart."""
Ball: TypeAlias = Any
"""An `arb`, or an `arb_series` where derivatives are wanted (python-flint publishes no types)."""
Memory: TypeAlias = list[Ball]
Step: TypeAlias = Callable[[Memory], Ball]


@dataclass(frozen=True)
class Program:
    """Terms as steps over a memory that starts with the values of the symbols."""

    symbols: tuple[str, ...]
    steps: tuple[Step, ...]
    outputs: tuple[int, ...]

    def run(self, values: Sequence[Ball]) -> list[Ball]:
        """Evaluate all outputs at the current precision; undefined values are not finite."""
        memory: Memory = list(values)
        for step in self.steps:
            memory.append(step(memory))
        return [memory[place] for place in self.outputs]

    def taylor(
        self, point: Sequence[Ball], direction: Sequence[int], order: int
    ) -> list[list[Ball]]:
        """Enclose the Taylor coefficients of all outputs along a direction, up to an order.

        Over a wide point they enclose the coefficients at every point in it. Undefined ones are not
        finite.
        """
        old, ctx.cap = ctx.cap, order + 1
        try:
            lines = [arb_series([x, d], order + 1) for x, d in zip(point, direction, strict=True)]
            return [_coefficients(result, order) for result in self.run(lines)]
        except (ValueError, ZeroDivisionError):  # a denominator whose range contains zero
            return [[arb.nan()] * (order + 1) for _ in self.outputs]
        finally:
            ctx.cap = old


def _coefficients(result: Ball, order: int) -> list[Ball]:
    if isinstance(result, arb_series):
        return [result[k] for k in range(order + 1)]
    return [result, *([arb(0)] * order)]


def rational_ball(value: Any) -> Ball:
    """Enclose a rational number (SymPy, fmpq, Fraction or int) at the current precision."""
    if isinstance(value, fmpq):
        return arb(value)
    return arb(fmpq(int(value.numerator), int(value.denominator)))


def compile_balls(terms: Sequence[Term], symbols: Sequence[str]) -> Program:
    """Compile terms to one program with shared steps; `symbols` are the names of its inputs.

    Raises `UnsupportedError` for what has no enclosure: integrals, unknown functions.
    """
    compiler = _Compiler({Symbol(name): place for place, name in enumerate(symbols)})
    outputs = tuple(compiler.place(term) for term in terms)
    return Program(tuple(symbols), tuple(compiler.steps), outputs)


def enclose(term: Term, point: Mapping[str, Any] | None = None, precision: int = 128) -> Ball:
    """Enclose a term at a point of rational numbers, working with `precision` bits."""
    point = point or {}
    program = compile_balls([term], tuple(point))
    with ctx.workprec(precision):
        return program.run([rational_ball(value) for value in point.values()])[0]


def is_enclosed(term: Term) -> bool:
    """Whether balls know all that a term is made of: no integral, and no unknown function."""
    return all(
        part.function in FUNCTIONS if isinstance(part, Call) else not isinstance(part, Integral)
        for part in walk(term)
    )


def as_float(ball: Ball) -> float:
    """Return the middle of a ball; raises `UnsupportedError` for one that floats do not reach."""
    middle = float(ball.mid())
    if not isfinite(middle):
        raise UnsupportedError("it contains numbers beyond 10^308")
    return middle


def format_ball(ball: Ball, digits: int = 4) -> str:
    """Write the midpoint to significant digits: `0.8415`; `undefined` when it is not finite.

    What terms cancel to is 0 but for the last bits, and written so.
    """
    if not ball.is_finite():
        return "undefined"
    if ball.contains(0) and ball.rad() < CANCELLED:
        return "0"
    with ctx.workprec(max(ctx.prec, 4 * digits)):
        return str(ball.str(digits, radius=False))


def sign_of(ball: Ball) -> int | None:
    """Return the certain sign 1 or -1 of a ball, 0 for the exact zero, None when it is open."""
    if not ball.is_finite():
        return None
    if ball > 0:
        return 1
    if ball < 0:
        return -1
    return 0 if ball == 0 else None


class _Compiler:
    def __init__(self, places: dict[Term, int]) -> None:
        self.places = places
        self.steps: list[Step] = []
        self.inputs = len(places)

    def place(self, term: Term) -> int:
        """Return where the value of a term will stand, after adding the steps that make it."""
        known = self.places.get(term)
        if known is None:
            step = self.step(term)
            known = self.places[term] = self.inputs + len(self.steps)
            self.steps.append(step)
        return known

    def step(self, term: Term) -> Step:
        match term:
            case Number(value=value):
                number = fmpq(value.numerator, value.denominator)
                return lambda memory: arb(number)
            case Pi():
                return lambda memory: arb.pi()
            case Symbol(name=name):
                raise UnsupportedError(f"the symbol {name} has no value")
            case Sum() | Product():
                fold = _add if isinstance(term, Sum) else _multiply
                return fold(tuple(map(self.place, term.parts)))
            case Power(base=base, exponent=exponent):
                inside = self.place(base)
                return lambda memory: _power(memory[inside], exponent)
        return self.call(term)

    def call(self, term: Term) -> Step:
        function = FUNCTIONS.get(term.function) if isinstance(term, Call) else None
        if function is None:
            name = term.function if isinstance(term, Call) else type(term).__name__
            raise UnsupportedError(f"{name} is not among the functions that can be enclosed")
        places = tuple(map(self.place, term.parts))
        return lambda memory: function(*(memory[place] for place in places))


def _add(places: tuple[int, ...]) -> Step:
    first, *rest = places

    def step(memory: Memory) -> Ball:
        total = memory[first]
        for place in rest:
            total = total + memory[place]
        return total

    return step


def _multiply(places: tuple[int, ...]) -> Step:
    first, *rest = places

    def step(memory: Memory) -> Ball:
        product = memory[first]
        for place in rest:
            product = product * memory[place]
        return product

    return step


def _power(base: Ball, exponent: int) -> Ball:
    """Enclose a whole power; FLINT's own says nothing where a ball contains 0."""
    if isinstance(base, arb_series) or not base.contains(0) or not base.is_finite():
        return base**exponent
    size = base if exponent % 2 else abs(base)
    product = reduce(mul, repeat(size, abs(exponent)), arb(1))
    return product if exponent >= 0 else 1 / product


def _root(value: Ball) -> Ball:
    """Enclose a square root; over a range that reaches below zero, where it is defined."""
    if isinstance(value, arb_series) or not value.contains(0):
        return value.sqrt()
    return arb(0).union(value.upper().sqrt())


def _abs(value: Ball) -> Ball:
    if not isinstance(value, arb_series):
        return abs(value)
    sign = sign_of(value[0])
    return value if sign == 1 else -value if sign == -1 else value * arb.nan()


def _sign(value: Ball) -> Ball:
    if not isinstance(value, arb_series):
        return value.sgn()
    sign = sign_of(value[0])
    return arb(sign) if sign else arb.nan()


def _arctangent_of_point(ordinate: Ball, abscissa: Ball) -> Ball:
    if isinstance(ordinate, arb_series) or isinstance(abscissa, arb_series):
        raise UnsupportedError("derivatives of atan2 are not enclosed")
    return arb.atan2(ordinate, abscissa)


FUNCTIONS: dict[str, Callable[..., Ball]] = {
    "sin": lambda x: x.sin(),
    "cos": lambda x: x.cos(),
    "tan": lambda x: x.sin() / x.cos(),
    "cot": lambda x: x.cos() / x.sin(),
    "sec": lambda x: 1 / x.cos(),
    "csc": lambda x: 1 / x.sin(),
    "arcsin": lambda x: x.asin(),
    "arccos": lambda x: x.acos(),
    "arctan": lambda x: x.atan(),
    "atan2": _arctangent_of_point,
    "exp": lambda x: x.exp(),
    "log": lambda x: x.log(),
    "sqrt": _root,
    "abs": _abs,
    "sign": _sign,
    "power": lambda base, exponent: (base.log() * exponent).exp(),
}
"""Every function of the table that has no definition by others."""
