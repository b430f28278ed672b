"""Between SymPy and terms: how what a derivation gives comes into the language of formulas.

A term has no assumptions, and a name means one thing: two symbols of SymPy with one name and
different assumptions, which SymPy takes for two numbers, are refused.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache, reduce
from operator import mul
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from omniproof.formula.angle import circular
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.grid import Grid
from omniproof.formula.term import (
    ONE,
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
from omniproof.formula.unfold import applied
from omniproof.formula.value import Cases, Comparison, Logic, Value
from omniproof.transcription.functions import CIRCULAR, FUNCTIONS

SYMPY_FUNCTIONS: dict[str, Any] = {n: getattr(sp, row.sympy) for n, row in FUNCTIONS.items()}
"""Functions of terms, and SymPy's."""
CIRCULAR_FUNCTIONS = tuple(SYMPY_FUNCTIONS[name] for name in sorted(CIRCULAR))
NAMES: dict[Any, str] = {function: name for name, function in SYMPY_FUNCTIONS.items()}
COMPARE: dict[str, Callable[..., Any]] = {
    "=": sp.Eq, "<": sp.Lt, ">": sp.Gt, "\\leq": sp.Le, "\\geq": sp.Ge, "\\neq": sp.Ne,
}  # fmt: skip
_OPERATORS = {relation: operator for operator, relation in COMPARE.items()}
JOIN: dict[str, Callable[..., Any]] = {"and": sp.And, "or": sp.Or, "equivalent": sp.Equivalent}


def term_of(expression: Any) -> Term:
    """Return an expression of SymPy, or a number, as a term; raises `UnsupportedError`."""
    return _term(sp.sympify(expression))


@lru_cache(maxsize=100_000)
def _term(node: Any) -> Term:
    """Convert node by node.

    What derivations share is converted once. The memory holds every node of the largest audit.
    """
    if node.is_Rational:
        return Number(Fraction(int(node.p), int(node.q)))
    if node is sp.pi or node is sp.E:
        return PI if node is sp.pi else Call("exp", (ONE,))
    if isinstance(node, sp.Symbol) and node.is_commutative:
        return Symbol(node.name)
    if node.is_Add or node.is_Mul:
        return (Sum if node.is_Add else Product)(tuple(map(_term, node.args)))
    if node.is_Pow:
        return _power(node)
    return _integral(node) if isinstance(node, sp.Integral) else _call(node)


def _power(node: Any) -> Term:
    base, exponent = node.base, node.exp
    if exponent.is_Integer:
        return Power(_term(base), int(exponent))
    twos = int(exponent.q).bit_length() - 1 if exponent.is_Rational else 0
    if twos and exponent.q == 1 << twos:
        term = reduce(lambda inside, _: root(inside), range(twos), _term(base))
        return term if exponent.p == 1 else Power(term, int(exponent.p))
    if exponent.is_Rational:  # what is a power of one root should be seen to be one
        index = Number(Fraction(1, int(exponent.q)))
        root_of_base = Call("power", (_term(base), index))
        return root_of_base if exponent.p == 1 else Power(root_of_base, int(exponent.p))
    return Call("power", (_term(base), _term(exponent)))


def _integral(node: Any) -> Term:
    inside = _term(node.function)
    for variable, *ends in node.limits:
        if len(ends) != 2:
            raise UnsupportedError("an integral has no ends")
        inside = Integral(inside, Symbol(variable.name), *map(_term, ends))
    return inside


def _call(node: Any) -> Term:
    """Name a function of the table, or one that is not known, and so may be any."""
    name = NAMES.get(node.func) or (str(node.func) if isinstance(node, AppliedUndef) else "")
    if not name:
        raise UnsupportedError(_refusal(node))
    return applied(name, tuple(map(_term, node.args)))


def comparison_of(relation: Any) -> Comparison:
    """Return a relation of SymPy as a comparison of terms; raises `UnsupportedError`."""
    return Comparison(term_of(relation.lhs), _OPERATORS[relation.func], term_of(relation.rhs))


def end_of(end: Any) -> Term | None:
    """Return the end of a range as a term; None for infinity."""
    end = sp.sympify(end)
    return None if end.is_infinite else term_of(end)


def positive_names(*expressions: Any) -> frozenset[str]:
    """Return the names of the symbols that SymPy assumes not to be negative."""
    found = set().union(*(expression.free_symbols for expression in expressions))
    return frozenset(symbol.name for symbol in found if symbol.is_nonnegative)


def assumed_signs(*expressions: Any) -> frozenset[tuple[str, str]]:
    """Return what SymPy assumes of symbols: pairs of a name and how it stands to 0."""
    found = set().union(*(expression.free_symbols for expression in expressions))
    return frozenset(
        (symbol.name, relation)
        for symbol in found
        for assumption, relation in _SIGNS.items()
        if getattr(symbol, assumption)
    )


_SIGNS = {"is_nonnegative": "\\geq", "is_nonpositive": "\\leq", "is_nonzero": "\\neq"}


def _refusal(node: Any) -> str:
    if node.is_Float:
        return f"{node} is a floating-point number, not an exact one"
    if node in (sp.nan, sp.zoo, sp.oo, -sp.oo):
        return "it contains a division by zero or another undefined value"
    if node is sp.I:
        return "it contains the imaginary unit"
    return f"{type(node).__name__} is not among the functions that can be enclosed"


class Converter:
    """Converts to and fro: a term comes back with the assumptions that its symbols came with."""

    def __init__(self) -> None:
        self._given: dict[Term, Any] = {}
        self._symbols: dict[str, Any] = {}

    def term(self, expression: Any) -> Term:
        """Return an expression of SymPy as a term; raises `UnsupportedError`."""
        node = sp.sympify(expression)
        term = _term(node)
        self._given.setdefault(term, node)
        return term

    def value(self, expression: Any) -> Any:
        """Return an expression or a matrix as a term or a grid; raises `UnsupportedError`."""
        if isinstance(expression, sp.MatrixBase):
            return Grid(tuple(tuple(map(self.term, row)) for row in expression.tolist()))
        return self.term(expression)

    def _symbol(self, name: str) -> Any:
        if name not in self._symbols:
            known = set().union(*(node.free_symbols for node in self._given.values()))
            self._symbols = {symbol.name: symbol for symbol in known}
        return self._symbols.get(name, sp.Symbol(name, real=True))

    def expression(self, value: Value) -> Any:
        """Return a value in SymPy, which simplifies on the way what it can.

        A grid gives an `ImmutableMatrix`, a statement a relation, a tuple a tuple.
        Raises `TypeError` for an order between numbers that are not real.
        """
        match value:
            case Term():
                if value not in self._given:
                    self._given[value] = self._built(value)
                return self._given[value]
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
        if isinstance(term, Symbol):
            return self._symbol(term.name)
        parts = tuple(map(self.expression, term.parts))
        if isinstance(term, Integral):
            return sp.Integral(parts[0], (self.expression(term.variable), *parts[1:]))
        return _BUILT[type(term)](term, *parts)


_BUILT: dict[type[Term], Callable[..., Any]] = {
    Number: lambda term: sp.Rational(term.value.numerator, term.value.denominator),
    Pi: lambda term: sp.pi,
    Sum: lambda term, *parts: sp.Add(*parts),
    Product: lambda term, *parts: reduce(mul, parts),
    Power: lambda term, base: base**term.exponent,
    Call: lambda term, *parts: _applied(term.function, *parts),
}


def _applied(function: str, *arguments: Any) -> Any:
    """Apply a function, and keep SymPy from a wrong idea of its sign where that is a number.

    SymPy tells the signs of most functions from two digits: an arc cosine near 0 is 0 for it, and a
    cotangent near a pole may be on the wrong side. Sine, cosine and arc sine are told to the end.
    """
    apply = SYMPY_FUNCTIONS.get(function) or sp.Function(function, real=True)
    try:
        value = apply(*arguments)
    except (TypeError, AttributeError):  # it cannot order numbers of hundreds of digits
        return apply(*arguments, evaluate=False)
    if any(argument.free_symbols for argument in arguments):
        return value
    if isinstance(value, sp.acos):  # not even whether it is 0 is asked: the answer varies
        return sp.pi / 2 - sp.asin(*arguments)
    if function in CIRCULAR and value.has(SYMPY_FUNCTIONS[function]):
        above, below = circular(function, sp.S.One, sp.cos(*arguments), sp.sin(*arguments))
        return above / below
    return value
