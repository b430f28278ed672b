"""Rigorous evaluation of SymPy expressions in ball arithmetic (Arb, through python-flint).

A ball is a midpoint with a radius that is certain to enclose the exact value, so a ball that keeps
clear of zero *proves* that a number is not zero; that is how every witness of the audit is found.
An expression is compiled once, to a flat list of steps with shared subexpressions. The same steps
run over balls (values), over wide balls (ranges on a cell of a box) and over power series with ball
coefficients (derivatives), which spares symbolic differentiation and its swollen results.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any, TypeAlias

import sympy as sp
from flint import arb, arb_series, ctx, fmpq

Ball: TypeAlias = Any
"""An `arb`, or an `arb_series` where derivatives are wanted (python-flint publishes no types)."""
Memory: TypeAlias = list[Ball]
Step: TypeAlias = Callable[[Memory], Ball]


sys.set_int_max_str_digits(0)  # what is read can also be written: Python's own limit is 4300
MAX_REASON = 300
"""So many characters of a reason are shown."""


class UnsupportedError(Exception):
    """An engine is asked for what it cannot do; public functions turn it into `Undecided`."""

    def __str__(self) -> str:
        """The reason, cut where it quotes a number of thousands of digits."""
        reason = super().__str__()
        return reason if len(reason) <= MAX_REASON else f"{reason[: MAX_REASON - 1]}…"


class WorkLimitError(UnsupportedError):
    """An engine would need more work than it is allowed."""


@dataclass(frozen=True)
class Program:
    """Expressions as steps over a memory that starts with the values of the symbols."""

    symbols: tuple[sp.Symbol, ...]
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


def exact_number(number: Any) -> sp.Expr:
    """Turn an int into a SymPy number; leave an expression as it is, unevaluated parts included."""
    return sp.Integer(number) if isinstance(number, int) else number


def rational_ball(value: Any) -> Ball:
    """Enclose a rational number (SymPy, fmpq, Fraction or int) at the current precision."""
    if isinstance(value, fmpq):
        return arb(value)
    return arb(fmpq(int(value.numerator), int(value.denominator)))


def compile_balls(expressions: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]) -> Program:
    """Compile expressions to one program with shared steps.

    Raises `UnsupportedError` for what has no enclosure: floats, complex numbers, unknown functions.
    """
    compiler = _Compiler({symbol: place for place, symbol in enumerate(symbols)})
    outputs = tuple(compiler.place(expression) for expression in expressions)
    return Program(tuple(symbols), tuple(compiler.steps), outputs)


def evaluate(
    expression: sp.Expr, point: Mapping[sp.Symbol, Any] | None = None, precision: int = 128
) -> Ball:
    """Enclose an expression at a point of rational numbers, working with `precision` bits."""
    point = point or {}
    program = compile_balls([expression], tuple(point))
    with ctx.workprec(precision):
        return program.run([rational_ball(value) for value in point.values()])[0]


def as_float(ball: Ball) -> float:
    """Return the middle of a ball; raises `UnsupportedError` for one that floats do not reach."""
    middle = float(ball.mid())
    if not isfinite(middle):
        raise UnsupportedError("it contains numbers beyond 10^308")
    return middle


def format_ball(ball: Ball, digits: int = 4) -> str:
    """Write the midpoint to significant digits: `0.8415`; `undefined` when it is not finite."""
    if not ball.is_finite():
        return "undefined"
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
    def __init__(self, places: dict[Any, int]) -> None:
        self.places = places
        self.steps: list[Step] = []
        self.inputs = len(places)

    def place(self, node: sp.Expr) -> int:
        """Return where the value of a node will stand, after adding the steps that make it."""
        known = self.places.get(node)
        if known is None:
            step = self.step(node)
            known = self.places[node] = self.inputs + len(self.steps)
            self.steps.append(step)
        return known

    def step(self, node: sp.Expr) -> Step:
        if node.is_Rational:
            number = fmpq(int(node.p), int(node.q))
            return lambda memory: arb(number)
        if node.is_Add or node.is_Mul:
            fold = _add if node.is_Add else _multiply
            return fold(tuple(self.place(argument) for argument in node.args))
        if node.is_Pow:
            return self.power(node)
        if node in _CONSTANTS:
            constant = _CONSTANTS[node]
            return lambda memory: constant()
        function = _FUNCTIONS.get(type(node))
        if function is None:
            raise UnsupportedError(_refusal(node))
        places = tuple(self.place(argument) for argument in node.args)
        return lambda memory: function(*(memory[place] for place in places))

    def power(self, node: sp.Expr) -> Step:
        base, exponent = node.base, node.exp
        if base is sp.E:
            inner = self.place(exponent)
            return lambda memory: memory[inner].exp()
        place = self.place(base)
        if exponent.is_Integer:
            count = int(exponent)
            return lambda memory: memory[place] ** count
        if exponent.is_Rational and exponent.q == 2:
            count = int(exponent.p)
            return lambda memory: _root(memory[place]) ** count
        other = self.place(exponent)
        return lambda memory: (memory[place].log() * memory[other]).exp()


def _refusal(node: sp.Expr) -> str:
    if node.is_Symbol:
        return f"the symbol {node} has no value"
    if node.is_Float:
        return f"{node} is a floating-point number, not an exact one"
    if node in (sp.nan, sp.zoo, sp.oo, -sp.oo):
        return "it contains a division by zero or another undefined value"
    if node is sp.I:
        return "it contains the imaginary unit"
    return f"{type(node).__name__} is not among the functions that can be enclosed"


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


_CONSTANTS: dict[Any, Callable[[], Ball]] = {sp.pi: arb.pi, sp.E: lambda: arb(1).exp()}

_FUNCTIONS: dict[Any, Callable[..., Ball]] = {
    sp.sin: lambda x: x.sin(),
    sp.cos: lambda x: x.cos(),
    sp.tan: lambda x: x.sin() / x.cos(),
    sp.cot: lambda x: x.cos() / x.sin(),
    sp.sec: lambda x: 1 / x.cos(),
    sp.csc: lambda x: 1 / x.sin(),
    sp.asin: lambda x: x.asin(),
    sp.acos: lambda x: x.acos(),
    sp.atan: lambda x: x.atan(),
    sp.atan2: _arctangent_of_point,
    sp.exp: lambda x: x.exp(),
    sp.log: lambda x: x.log(),
    sp.sinh: lambda x: (x.exp() - (-x).exp()) / 2,
    sp.cosh: lambda x: (x.exp() + (-x).exp()) / 2,
    sp.tanh: lambda x: (x.exp() - (-x).exp()) / (x.exp() + (-x).exp()),
    sp.Abs: _abs,
    sp.sign: _sign,
}
