"""The value of a printed tree to 60 digits, by mpmath: a judge that no engine has a part in.

Nothing here rests on FLINT, on normal forms, on prime fields or on the floats of the repair; the
reader alone is shared. So where an engine and these digits disagree about two formulas, it is the
engine that is wrong. The corpus, the mutation study and the fuzzing are judged by them. A value is
a number, or an mpmath matrix.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any, TypeAlias

from mpmath import mp
from sympy import MatrixBase, Rational, Symbol

from omniproof.transcription import tree

Value: TypeAlias = Any
DIGITS = 60
AGREED = 40
"""So many digits of two equal values agree, whatever was lost on the way."""


class UndefinedError(ArithmeticError):
    """A formula has no real value at a point, or its parts do not fit together."""


def value(node: tree.Node, meaning: Callable[[tree.Symbolic], Value]) -> Value:
    """Evaluate a tree; `meaning` gives the value of a symbol, with its arguments if it has any.

    Raises `UndefinedError` where there is no real value.
    """
    if isinstance(node, tree.Name | tree.Applied):
        return meaning(node)
    if type(node) not in _RULES:
        raise UndefinedError(f"{type(node).__name__} has no value")
    parts = [value(part, meaning) for part in tree.children(node)]
    with mp.workdps(DIGITS):
        try:
            return _real(_RULES[type(node)](node, parts))
        except (ZeroDivisionError, ValueError, TypeError, IndexError) as error:
            raise UndefinedError(str(error)) from None


def known_value(known: Any, point: dict[Symbol, Rational]) -> Value:
    """Evaluate what a symbol stands for, an expression or a matrix, at a rational point."""
    with mp.workdps(DIGITS):
        if isinstance(known, MatrixBase):
            return mp.matrix([[_digits(entry, point) for entry in row] for row in known.tolist()])
        return _digits(known, point)


def _digits(expression: Any, point: dict[Symbol, Rational]) -> Value:
    # SymPy gives up at `maxn` digits and returns the expression: that is no real value here.
    number = expression.evalf(DIGITS, subs=point, maxn=400)
    if not number.is_Float and not number.is_Rational:
        raise UndefinedError(f"no real value of {expression}")
    return mp.mpf(str(number))


def are_equal(one: Value, other: Value) -> bool:
    """Whether two values agree to 40 digits; matrices entry by entry, and only of one shape."""
    if _shape(one) != _shape(other):
        return False
    pairs = zip(_entries(one), _entries(other), strict=True)
    with mp.workdps(DIGITS):
        bound = mp.mpf(10) ** -AGREED
        return all(abs(a - b) <= bound * (1 + abs(a) + abs(b)) for a, b in pairs)


def _shape(item: Value) -> tuple[int, int]:
    return (item.rows, item.cols) if isinstance(item, mp.matrix) else (1, 1)


def _entries(item: Value) -> list[Value]:
    return list(item) if isinstance(item, mp.matrix) else [item]


def _real(item: Value) -> Value:
    if any(mp.im(entry) != 0 or not mp.isfinite(entry) for entry in _entries(item)):
        raise UndefinedError("no real value")
    return item


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
    if node.function == "atan2":
        return mp.atan2(*parts[0])
    return _FUNCTIONS[node.function](parts[0])


def _component(node: tree.Component, parts: Sequence[Value]) -> Value:
    place = "xyz".index(node.axis) if node.axis in "xyz" else int(node.axis) - 1
    return _column(parts[0])[place]


_FUNCTIONS: dict[str, Callable[[Value], Value]] = {
    "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "cot": mp.cot, "sec": mp.sec, "csc": mp.csc,
    "arcsin": mp.asin, "arccos": mp.acos, "arctan": mp.atan, "sqrt": mp.sqrt, "det": mp.det,
}  # fmt: skip

_RULES: dict[type[tree.Node], Callable[[Any, Sequence[Value]], Value]] = {
    tree.Number: lambda node, parts: mp.mpf(node.text),
    tree.Degrees: lambda node, parts: mp.mpf(node.value) * mp.pi / 180,
    tree.Pi: lambda node, parts: +mp.pi,
    tree.Negative: lambda node, parts: -parts[0],
    tree.Sum: lambda node, parts: _sum(parts),
    tree.Product: lambda node, parts: reduce(_times, parts),
    tree.Dot: lambda node, parts: _dot(*parts),
    tree.Cross: lambda node, parts: _cross(*parts),
    tree.Quotient: lambda node, parts: parts[0] / parts[1],
    tree.Power: lambda node, parts: parts[0] ** node.exponent,
    tree.Transpose: lambda node, parts: (
        parts[0] if isinstance(node.operand, tree.Tuple) else parts[0].T
    ),
    tree.Call: _call,
    tree.Inner: lambda node, parts: _inner(*parts),
    tree.Norm: lambda node, parts: mp.sqrt(sum(entry**2 for entry in _entries(parts[0]))),
    tree.Absolute: lambda node, parts: abs(parts[0]),
    tree.Determinant: lambda node, parts: mp.det(_grid([[_column(part) for part in parts]])),
    tree.Component: _component,
    tree.Tuple: _tuple,
    tree.MatrixLiteral: _matrix,
}
