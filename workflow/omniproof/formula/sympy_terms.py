"""Between SymPy and terms: how what a derivation gives comes into the language of formulas.

A term has no assumptions, and a name means one thing: two symbols of SymPy with one name and
different assumptions, which SymPy takes for two numbers, are refused.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import reduce
from operator import mul
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from omniproof.formula.grid import Grid
from omniproof.formula.statement import Comparison, Logic
from omniproof.formula.term import (
    PI,
    Call,
    Integral,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    Term,
    root,
)
from omniproof.formula.unfold import Cases, Value

FUNCTIONS: dict[str, Callable[..., Any]] = {
    "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "cot": sp.cot, "sec": sp.sec, "csc": sp.csc,
    "arcsin": sp.asin, "arccos": sp.acos, "arctan": sp.atan, "atan2": sp.atan2,
    "sqrt": sp.sqrt, "abs": sp.Abs, "sign": sp.sign, "exp": sp.exp, "log": sp.log,
    "sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh, "max": sp.Max, "min": sp.Min,
    "power": sp.Pow,
}  # fmt: skip
"""Functions of terms, and SymPy's."""
NAMES: dict[Any, str] = {function: name for name, function in FUNCTIONS.items()}
COMPARE: dict[str, Callable[..., Any]] = {
    "=": sp.Eq, "<": sp.Lt, ">": sp.Gt, "\\leq": sp.Le, "\\geq": sp.Ge, "\\neq": sp.Ne,
}  # fmt: skip
JOIN: dict[str, Callable[..., Any]] = {"and": sp.And, "or": sp.Or, "equivalent": sp.Equivalent}


class NotATermError(ValueError):
    """An expression of SymPy that stands for no exact real number; the text says why."""


class Converter:
    """Converts to and fro, and remembers: what derivations share is converted once."""

    def __init__(self) -> None:
        self._terms: dict[Any, Term] = {}
        self._expressions: dict[Term, Any] = {}

    def term(self, expression: Any) -> Term:
        """Return an expression of SymPy as a term; raises `NotATermError`."""
        node = sp.sympify(expression)
        if node not in self._terms:
            term = self._terms[node] = self._convert(node)
            if self._expressions.setdefault(term, node) != node and isinstance(term, Symbol):
                raise NotATermError(f"`{term.name}` is assumed to be two things")
        return self._terms[node]

    def value(self, expression: Any) -> Any:
        """Return an expression or a matrix as a term or a grid; raises `NotATermError`."""
        if isinstance(expression, sp.MatrixBase):
            return Grid(tuple(tuple(map(self.term, row)) for row in expression.tolist()))
        return self.term(expression)

    def _convert(self, node: Any) -> Term:
        if node.is_Rational:
            return Number(Fraction(int(node.p), int(node.q)))
        if node is sp.pi:
            return PI
        if isinstance(node, sp.Symbol) and node.is_commutative:
            return Symbol(node.name)
        if node.is_Add or node.is_Mul:
            return (Sum if node.is_Add else Product)(tuple(map(self.term, node.args)))
        if node.is_Pow:
            return self._power(node)
        if isinstance(node, sp.Integral):
            return self._integral(node)
        return self._call(node)

    def _power(self, node: Any) -> Term:
        base, exponent = node.base, node.exp
        if exponent.is_Integer:
            return Power(self.term(base), int(exponent))
        twos = int(exponent.q).bit_length() - 1 if exponent.is_Rational else 0
        if twos and exponent.q == 1 << twos:
            term = reduce(lambda inside, _: root(inside), range(twos), self.term(base))
            return term if exponent.p == 1 else Power(term, int(exponent.p))
        return Call("power", (self.term(base), self.term(exponent)))

    def _integral(self, node: Any) -> Term:
        inside = self.term(node.function)
        for variable, *ends in node.limits:
            if len(ends) != 2:
                raise NotATermError("an integral has no ends")
            inside = Integral(inside, Symbol(variable.name), *map(self.term, ends))
        return inside

    def _call(self, node: Any) -> Term:
        name = NAMES.get(node.func) or (str(node.func) if isinstance(node, AppliedUndef) else "")
        if not (name and node.args):
            raise NotATermError(f"{type(node).__name__} is no exact real number")
        return Call(name, tuple(map(self.term, node.args)))

    def expression(self, value: Value) -> Any:
        """Return a value in SymPy, which simplifies on the way what it can.

        A grid gives an `ImmutableMatrix`, a statement a relation, a tuple a tuple.
        Raises `TypeError` for an order between numbers that are not real.
        """
        match value:
            case Term():
                if value not in self._expressions:
                    self._expressions[value] = self._built(value)
                return self._expressions[value]
            case Grid(rows=rows):
                return sp.ImmutableMatrix([list(map(self.expression, row)) for row in rows])
            case Comparison(left=left, operator=operator, right=right):
                return COMPARE[operator](self.expression(left), self.expression(right))
            case Logic(operator=operator, operands=operands):
                return JOIN[operator](*map(self.expression, operands))
            case Cases(branches=branches):
                return sp.Piecewise(*(tuple(map(self.expression, each)) for each in branches))
            case tuple():
                return tuple(map(self.expression, value))
        raise AssertionError(value)

    def _built(self, term: Term) -> Any:
        parts = tuple(map(self.expression, term.parts))
        match term:
            case Number(value=number):
                return sp.Rational(number.numerator, number.denominator)
            case Pi():
                return sp.pi
            case Symbol(name=name):
                return sp.Symbol(name, real=True)
            case Sum():
                return sp.Add(*parts)
            case Product():
                return reduce(mul, parts)
            case Power(exponent=exponent):
                return parts[0] ** exponent
            case Integral(variable=variable):
                return sp.Integral(parts[0], (self.expression(variable), *parts[1:]))
            case Call(function=function):
                return FUNCTIONS.get(function, sp.Function(function))(*parts)
        raise AssertionError(term)
