"""The value of a printed tree to 60 digits, by mpmath: a judge that no engine has a part in.

Nothing here rests on FLINT, on normal forms, on prime fields or on the floats of the repair; the
reader alone is shared. So where an engine and these digits disagree about two formulas, it is the
engine that is wrong. The corpus, the mutation study and the fuzzing are judged by them. A value is
a number, or an mpmath matrix.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial, reduce
from numbers import Rational
from types import MappingProxyType
from typing import Any, TypeAlias

from mpmath import mp

from omniproof.formula.functions import FUNCTIONS as TABLE
from omniproof.transcription import tree

Value: TypeAlias = Any
Bound: TypeAlias = Mapping[str, Value]
"""Values of the variables of the integrals around a part, by their printed names."""
Meaning: TypeAlias = Callable[[tree.Symbolic, Bound], Value]
DIGITS = 60
LOST = 3
"""One digit in so many may be lost on the way: to 60 digits, equal values agree to 40."""
UNSET = 15
"""So many digits mpmath works to where nobody has set it."""
FINEST = 6
"""An integral takes rules of 3, 6, 12 points, up to 96, until three quarters of its digits settle;
the first two do for what is a polynomial."""


class UndefinedError(ArithmeticError):
    """A formula has no real value at a point, or its parts do not fit together."""


class NotEvaluatedError(UndefinedError):
    """Nobody knows whether a formula has a value: the digits do not reach it."""


def value(node: tree.Node, meaning: Meaning, bound: Bound = MappingProxyType({})) -> Value:
    """Evaluate a tree; `meaning` gives the value of a symbol, with its arguments if it has any.

    Raises `UndefinedError` where there is no real value, `NotEvaluatedError` where none is found.
    Works to 60 digits, or to as many as mpmath is set to.
    """
    if isinstance(node, tree.Name | tree.Applied):
        return meaning(node, bound)
    if isinstance(node, tree.Integral):
        return _over_range(node, meaning, bound)
    if type(node) not in _RULES:
        raise NotEvaluatedError(f"{type(node).__name__} has no value")
    parts = [value(part, meaning, bound) for part in tree.children(node)]
    with mp.workdps(precision()):
        try:
            return real(_RULES[type(node)](node, parts))
        except (ZeroDivisionError, ValueError, TypeError, IndexError) as error:
            raise UndefinedError(str(error)) from None


def precision() -> int:
    """Return the number of digits that is worked to: those that mpmath has been set to, or 60."""
    return DIGITS if mp.dps == UNSET else int(mp.dps)


def _over_range(node: tree.Integral, meaning: Meaning, bound: Bound) -> Value:
    name = node.variable.name
    ends = [value(end, meaning, bound) for end in (node.lower, node.upper)]
    return integral(lambda x: value(node.integrand, meaning, {**bound, name: x}), *ends)


def integral(integrand: Callable[[Value], Value], lower: Value, upper: Value) -> Value:
    """Integrate a smooth function; raises `NotEvaluatedError` where its digits do not settle."""
    digits = precision()

    def at(x: Value) -> Value:
        with mp.workdps(digits):
            return integrand(x)

    # What the integrand has lost itself would never settle.
    with mp.workdps(digits * 3 // 4):
        rule = partial(mp.quad, method="gauss-legendre", maxdegree=FINEST, error=True)
        found, error = rule(at, [lower, upper])
        if error <= mp.eps * (1 + abs(found)):
            return found
    raise NotEvaluatedError("the digits of an integral do not settle")


def number(item: Any) -> Value:
    """Return a number of Python, mpmath or SymPy to the digits that are worked to."""
    if isinstance(item, mp.mpf):
        return item
    if isinstance(item, Rational):
        return mp.mpf(int(item.numerator)) / int(item.denominator)
    return mp.mpf(item.evalf(precision()))


def are_equal(one: Value, other: Value) -> bool:
    """Whether two values agree to 40 digits; matrices entry by entry, and only of one shape."""
    if _shape(one) != _shape(other):
        return False
    pairs = zip(_entries(one), _entries(other), strict=True)
    with mp.workdps(precision()):
        return all(abs(a - b) <= _noise() * (1 + abs(a) + abs(b)) for a, b in pairs)


def _noise() -> Value:
    """What may be left of 0 after cancellation; nothing as small is told from it."""
    return mp.mpf(10) ** (precision() // LOST - precision())


def _shape(item: Value) -> tuple[int, int]:
    return (item.rows, item.cols) if isinstance(item, mp.matrix) else (1, 1)


def _entries(item: Value) -> list[Value]:
    return list(item) if isinstance(item, mp.matrix) else [item]


def real(item: Value) -> Value:
    """Return a value; raises `UndefinedError` for one that is not real, or not finite."""
    if any(mp.im(entry) != 0 or not mp.isfinite(entry) for entry in _entries(item)):
        raise UndefinedError("no real value")
    return item


def _over(above: Value, below: Value) -> Value:
    if _shape(below) != (1, 1):
        raise UndefinedError("cannot divide by a matrix")
    if abs(below) <= _noise():
        raise UndefinedError("a division by 0")
    return above / below


def power(base: Value, exponent: int) -> Value:
    """Return a whole power; raises `UndefinedError` for the inverse of 0."""
    if exponent >= 0:
        return base**exponent
    if isinstance(base, mp.matrix) and abs(mp.det(base)) <= _noise():
        raise UndefinedError("a singular matrix has no inverse")
    return base**exponent if isinstance(base, mp.matrix) else _over(mp.mpf(1), base) ** -exponent


def root(radicand: Value) -> Value:
    """The root of what is not told from 0 is 0: half of its digits would be lost."""
    return mp.mpf(0) if abs(radicand) <= _noise() else mp.sqrt(radicand)


def _within_one(function: Callable[[Value], Value]) -> Callable[[Value], Value]:
    """Let an inverse function take what is not told from the end of its domain."""

    def rule(argument: Value) -> Value:
        beyond = abs(argument) - 1
        return function(mp.sign(argument) if 0 < beyond <= _noise() else argument)

    return rule


def angle(ordinate: Value, abscissa: Value) -> Value:
    """Return the direction of a point; raises `UndefinedError` for the origin."""
    if max(abs(ordinate), abs(abscissa)) <= _noise():
        raise UndefinedError("the origin has no direction")
    return mp.atan2(ordinate, abscissa)


def _to_the(base: Value, exponent: Value) -> Value:
    if mp.isint(exponent):
        return power(base, int(exponent))
    if mp.isint(2 * exponent):
        return power(real(root(base)), int(2 * exponent))
    return mp.power(base, exponent)


def _sign(number: Value) -> Value:
    if 0 < abs(number) <= _noise():
        raise NotEvaluatedError("the sign of what is not told from 0")
    return mp.sign(number)


def _logarithm(number: Value) -> Value:
    if number <= _noise():
        raise UndefinedError("the logarithm of what is not positive")
    return mp.log(number)


def _times(left: Value, right: Value) -> Value:
    product = left * right
    return product[0, 0] if isinstance(product, mp.matrix) and len(product) == 1 else product


def _column(item: Value) -> Value:
    if 1 not in _shape(item) or _shape(item) == (1, 1):
        raise UndefinedError("expected a vector")
    return item if item.cols == 1 else item.T


def _is_column(item: Value) -> bool:
    return _shape(item)[0] > 1 == _shape(item)[1]


def _inner(left: Value, right: Value) -> Value:
    return (_column(left).T * _column(right))[0, 0]


def _dot(left: Value, right: Value) -> Value:
    both = _is_column(left) and _is_column(right)
    return _inner(left, right) if both else _times(left, right)


def _cross(left: Value, right: Value) -> Value:
    if not (_is_column(left) and _is_column(right)):
        return _times(left, right)
    # Vectors of the plane lie in z = 0.
    a, b = ([*item, mp.mpf(0)][:3] for item in (left, right))
    turns = ((1, 2), (2, 0), (0, 1))
    return mp.matrix([a[i] * b[k] - a[k] * b[i] for i, k in turns])


def _sum(parts: Sequence[Value]) -> Value:
    if len({_shape(part) for part in parts}) != 1:
        raise UndefinedError("cannot add")
    return reduce(lambda one, other: one + other, parts)


def _grid(rows: Sequence[Sequence[Value]]) -> Value:
    """A matrix of numbers and blocks."""
    lines: list[list[Value]] = []
    for row in rows:
        blocks = [b if isinstance(b, mp.matrix) else mp.matrix([[b]]) for b in row]
        for line in range(blocks[0].rows):
            lines.append([block[line, k] for block in blocks for k in range(block.cols)])
    return mp.matrix(lines)


def _tuple(node: tree.Tuple, parts: Sequence[Value]) -> Value:
    if node.kind == "set":
        raise UndefinedError("a set has no value")
    numbers = all(_shape(part) == (1, 1) for part in parts)
    return _grid([[part] for part in parts] if numbers else [parts])


def _matrix(node: tree.MatrixLiteral, parts: Sequence[Value]) -> Value:
    width = len(node.rows[0])
    return _grid([parts[start : start + width] for start in range(0, len(parts), width)])


def _call(node: tree.Call, parts: Sequence[Value]) -> Value:
    if node.function == "det":
        return mp.det(parts[0])
    several = TABLE[node.function].arguments > 1
    return FUNCTIONS[node.function](*(parts[0] if several else parts))


def _component(node: tree.Component, parts: Sequence[Value]) -> Value:
    place = "xyz".index(node.axis) if node.axis in "xyz" else int(node.axis) - 1
    return _column(parts[0])[place]


FUNCTIONS: dict[str, Callable[..., Value]] = {
    "sin": mp.sin, "cos": mp.cos,
    "tan": lambda x: _over(mp.sin(x), mp.cos(x)), "cot": lambda x: _over(mp.cos(x), mp.sin(x)),
    "sec": lambda x: _over(mp.mpf(1), mp.cos(x)), "csc": lambda x: _over(mp.mpf(1), mp.sin(x)),
    "arcsin": _within_one(mp.asin), "arccos": _within_one(mp.acos), "arctan": mp.atan,
    "atan2": angle, "sqrt": root, "abs": abs, "sign": _sign, "exp": mp.exp, "log": _logarithm,
    "sinh": mp.sinh, "cosh": mp.cosh, "tanh": mp.tanh, "max": max, "min": min, "power": _to_the,
}  # fmt: skip
"""Every function of the table."""

_RULES: dict[type[tree.Node], Callable[[Any, Sequence[Value]], Value]] = {
    tree.Number: lambda node, parts: mp.mpf(node.text),
    tree.Degrees: lambda node, parts: mp.mpf(node.value) * mp.pi / 180,
    tree.Pi: lambda node, parts: +mp.pi,
    tree.Negative: lambda node, parts: -parts[0],
    tree.Sum: lambda node, parts: _sum(parts),
    tree.Product: lambda node, parts: reduce(_times, parts),
    tree.Dot: lambda node, parts: _dot(*parts),
    tree.Cross: lambda node, parts: _cross(*parts),
    tree.Quotient: lambda node, parts: _over(*parts),
    tree.Power: lambda node, parts: power(parts[0], node.exponent),
    tree.Transpose: lambda node, parts: (
        parts[0] if isinstance(node.operand, tree.Tuple) else parts[0].T
    ),
    tree.Call: _call,
    tree.Inner: lambda node, parts: _inner(*parts),
    tree.Norm: lambda node, parts: root(sum(entry**2 for entry in _entries(parts[0]))),
    tree.Absolute: lambda node, parts: abs(parts[0]),
    tree.Determinant: lambda node, parts: mp.det(_grid([[_column(part) for part in parts]])),
    tree.Component: _component,
    tree.Tuple: _tuple,
    tree.MatrixLiteral: _matrix,
}
