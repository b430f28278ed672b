"""Values of a printed tree in plain floating point, at several points at once.

A repair tries thousands of edits, and nearly all of them are wrong. A float shows that in a
microsecond, where SymPy takes milliseconds; so only what a float cannot tell from the truth goes to
the exact test. Nothing here proves anything.

Every value is an array of shape (..., points, rows, columns), a number having one row and one
column; axes before the points hold alternatives and broadcast against one another. A statement
counts as a column of numbers, one for each entry of its sides: 0 where it holds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache, reduce
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from omniproof.decide.balls import compile_balls, rational_ball
from omniproof.decide.domain import REALS, Domain, Range
from omniproof.decide.sampling import sample_points
from omniproof.formula.functions import FUNCTIONS as TABLE
from omniproof.formula.grid import Grid
from omniproof.formula.term import Term, symbols
from omniproof.transcription import tree

Values: TypeAlias = NDArray[np.float64]
POINTS = 6
TOLERANCE = 1e-8
UNTOLD = np.full((POINTS, 1, 1), np.nan)
"""Values of what is no number."""
AXES = {"x": 0, "y": 1, "z": 2}


class ShapeError(ValueError):
    """The parts of a formula do not fit together, or it is none of numbers and vectors."""


def agree(values: Values, target: Values) -> NDArray[np.bool_]:
    """Whether values (..., points, n, m) equal the target wherever that is finite.

    False throughout where the shapes differ or the target is not finite at any point.
    """
    if values.shape[-2:] != target.shape[-2:]:
        return np.zeros(values.shape[:-3], dtype=bool)
    known = np.isfinite(target).all(axis=(-2, -1))
    size = 1 + np.abs(target)
    near = (np.abs(values - target) <= TOLERANCE * size).all(axis=(-2, -1))
    return np.asarray((near | ~known).all(axis=-1) & known.any())


def at_points(value: Term | Grid, domain: Domain = REALS) -> Values:
    """Evaluate a term or a matrix at the points of its symbols, the same for equal names.

    Raises `UnsupportedError` for what balls do not know, or an empty range.
    """
    grid = value if isinstance(value, Grid) else Grid(((value,),))
    names = sorted(set().union(*map(symbols, grid.entries)))
    program = compile_balls(grid.entries, names)
    drawn = [_coordinates(name, domain.range(name)) for name in names]
    points = [[rational_ball(each[k]) for each in drawn] for k in range(POINTS)]
    found = [[_float(ball) for ball in program.run(point)] for point in points]
    return np.array(found).reshape(POINTS, *grid.shape)


@cache
def _coordinates(name: str, ends: Range) -> tuple[Any, ...]:
    """Rational values of one symbol at all points, other than those of any other symbol."""
    seed, domain = int.from_bytes(name.encode()) % 2**31, Domain({name: ends})
    return tuple(point[name] for point in sample_points([name], domain, count=POINTS, seed=seed))


def _float(ball: Any) -> float:
    return float(ball.mid()) if ball.is_finite() else math.nan


def evaluate(node: tree.Node, meaning: Callable[[tree.Symbolic], Values]) -> Values:
    """Evaluate a tree; `meaning` gives the values of a symbol, with its arguments if it has any.

    Raises `ShapeError` for what is neither number nor vector nor matrix, or does not fit together.
    """
    if isinstance(node, tree.Name | tree.Applied):
        return meaning(node)
    return combine(node, [evaluate(part, meaning) for part in tree.children(node)])


def combine(node: tree.Node, parts: Sequence[Values]) -> Values:
    """Evaluate a node from the values of its children, in the order of `tree.children`."""
    rule = _RULES.get(type(node))
    if rule is None:
        raise ShapeError(f"no number: {type(node).__name__}")
    with np.errstate(all="ignore"):
        return rule(node, parts)


def _shape(value: Values) -> tuple[int, ...]:
    return value.shape[-2:]


def _number(value: Values) -> Values:
    if _shape(value) != (1, 1):
        raise ShapeError("expected a number")
    return value


def _column(value: Values) -> Values:
    rows, columns = _shape(value)
    if 1 not in (rows, columns) or rows == columns:
        raise ShapeError("expected a vector")
    return value if columns == 1 else value.swapaxes(-1, -2)


def _plus(left: Values, right: Values) -> Values:
    if _shape(left) != _shape(right):
        raise ShapeError("cannot add")
    return left + right


def _times(left: Values, right: Values) -> Values:
    if (1, 1) in (_shape(left), _shape(right)):
        return left * right
    if left.shape[-1] != right.shape[-2]:
        raise ShapeError("cannot multiply")
    return left @ right


def _inner(left: Values, right: Values) -> Values:
    left, right = _column(left), _column(right)
    if _shape(left) != _shape(right):
        raise ShapeError("no inner product")
    return (left * right).sum(axis=-2, keepdims=True)


def _dot(left: Values, right: Values) -> Values:
    columns = all(_shape(value)[0] > 1 == _shape(value)[1] for value in (left, right))
    return _inner(left, right) if columns else _times(left, right)


def _cross(left: Values, right: Values) -> Values:
    if not all(_shape(value) in {(2, 1), (3, 1)} for value in (left, right)):
        return _times(left, right)
    x, y, z = (part[..., None, None] for part in _components(left))
    u, v, w = (part[..., None, None] for part in _components(right))
    return _joined([y * w - z * v, z * u - x * w, x * v - y * u], -2)


def _components(vector: Values) -> list[Values]:
    entries = [vector[..., k, 0] for k in range(vector.shape[-2])]
    return [*entries, np.zeros_like(entries[0])][:3]


def _joined(parts: Sequence[Values], axis: int) -> Values:
    """Put matrices beside (-1) or above (-2) one another."""
    leading = np.broadcast_shapes(*(part.shape[:-2] for part in parts))
    try:
        return np.concatenate(
            [np.broadcast_to(p, leading + p.shape[-2:]) for p in parts], axis=axis
        )
    except ValueError:
        raise ShapeError("the parts of a matrix do not fit together") from None


def _determinant(value: Values) -> Values:
    if value.shape[-1] != value.shape[-2]:
        raise ShapeError("expected a square matrix")
    return np.linalg.det(value)[..., None, None]


def _power(node: tree.Power, value: Values) -> Values:
    if _shape(value) == (1, 1):
        return value**node.exponent
    _determinant(value)
    try:
        return np.linalg.matrix_power(value, node.exponent)
    except np.linalg.LinAlgError:
        return np.full_like(value, np.nan)


def _tuple(node: tree.Tuple, parts: Sequence[Values]) -> Values:
    if node.kind == "set":
        raise ShapeError("a set is no vector")
    return _joined(parts, -2 if all(_shape(part) == (1, 1) for part in parts) else -1)


def _matrix(node: tree.MatrixLiteral, parts: Sequence[Values]) -> Values:
    width = len(node.rows[0])
    rows = [parts[start : start + width] for start in range(0, len(parts), width)]
    return _joined([_joined(row, -1) for row in rows], -2)


def _component(node: tree.Component, value: Values) -> Values:
    column = _column(value)
    place = AXES[node.axis] if node.axis in AXES else int(node.axis) - 1
    if not 0 <= place < column.shape[-2]:
        raise ShapeError("no such component")
    return column[..., place : place + 1, :]


def _norm(value: Values) -> Values:
    return np.sqrt((value**2).sum(axis=(-2, -1), keepdims=True))


def _call(node: tree.Call, parts: Sequence[Values]) -> Values:
    if node.function == "det":
        return _determinant(parts[0])
    if TABLE[node.function].arguments == 1:
        return FUNCTIONS[node.function](_number(parts[0]))
    column = _column(parts[0])
    items = (column[..., k : k + 1, :] for k in range(column.shape[-2]))
    return reduce(FUNCTIONS[node.function], items)


def _chain(node: tree.Chain, sides: Sequence[Values]) -> Values:
    """An equation as the numbers by which the entries of its sides differ: 0 where it holds."""
    if node.relation != "=" or len(sides) < 2:
        raise ShapeError("no equation")
    return _joined([_column_of(_gap(left, right)) for left, right in pairwise(sides)], -2)


def _gap(left: Values, right: Values) -> Values:
    """How far two values are apart: 0 where floats cannot tell."""
    gap = _plus(left, -right)
    return np.where(np.abs(gap) <= TOLERANCE * (1 + np.abs(left)), 0.0, gap)


def _column_of(value: Values) -> Values:
    """All entries below one another."""
    return value.reshape(*value.shape[:-2], -1, 1)


def _comparison(node: tree.Comparison, left: Values, right: Values) -> Values:
    """0 where a relation holds, or may hold as far as floats can tell, and 1 where it fails."""
    gap = _gap(_number(left), _number(right))
    holds = {"<": gap <= 0, "\\leq": gap <= 0, ">": gap >= 0, "\\geq": gap >= 0, "\\neq": gap != 0}
    return np.where(np.isfinite(gap), ~holds[node.operator], np.nan)


def _any(parts: Sequence[Values]) -> Values:
    """The least failure of several statements: 0 where one of them holds."""
    return np.asarray(reduce(np.minimum, [part.max(axis=-2, keepdims=True) for part in parts]))


def _constant(value: float) -> Values:
    return np.full((POINTS, 1, 1), value)


FUNCTIONS: dict[str, Callable[..., Values]] = {
    "sin": np.sin, "cos": np.cos, "tan": np.tan, "cot": lambda x: 1 / np.tan(x),
    "sec": lambda x: 1 / np.cos(x), "csc": lambda x: 1 / np.sin(x), "arcsin": np.arcsin,
    "arccos": np.arccos, "arctan": np.arctan, "atan2": np.arctan2, "sqrt": np.sqrt,
    "abs": np.abs, "sign": np.sign, "exp": np.exp, "log": np.log, "sinh": np.sinh,
    "cosh": np.cosh, "tanh": np.tanh, "max": np.maximum, "min": np.minimum, "power": np.power,
}  # fmt: skip
"""Every function of the table."""

_RULES: dict[type[tree.Node], Callable[[Any, Sequence[Values]], Values]] = {
    tree.Number: lambda node, parts: _constant(float(node.text)),
    tree.Degrees: lambda node, parts: _constant(math.radians(float(node.value))),
    tree.Pi: lambda node, parts: _constant(math.pi),
    tree.Chain: _chain,
    tree.Comparison: lambda node, parts: _comparison(node, *parts),
    tree.Logic: lambda node, parts: _any(parts) if node.operator == "or" else _joined(parts, -2),
    tree.Listing: lambda node, parts: _joined(parts, -2),
    tree.Negative: lambda node, parts: -parts[0],
    tree.Sum: lambda node, parts: reduce(_plus, parts),
    tree.Product: lambda node, parts: reduce(_times, parts),
    tree.Dot: lambda node, parts: _dot(*parts),
    tree.Cross: lambda node, parts: _cross(*parts),
    tree.Quotient: lambda node, parts: parts[0] / _number(parts[1]),
    tree.Power: lambda node, parts: _power(node, parts[0]),
    tree.Transpose: lambda node, parts: (
        parts[0] if isinstance(node.operand, tree.Tuple) else parts[0].swapaxes(-1, -2)
    ),
    tree.Call: _call,
    tree.Integral: lambda node, parts: _plus(parts[1], -parts[0]) * parts[2],
    tree.Inner: lambda node, parts: _inner(*parts),
    tree.Norm: lambda node, parts: _norm(parts[0]),
    tree.Absolute: lambda node, parts: np.abs(_number(parts[0])),
    tree.Determinant: lambda node, parts: _determinant(_joined([_column(p) for p in parts], -1)),
    tree.Component: lambda node, parts: _component(node, parts[0]),
    tree.Tuple: _tuple,
    tree.MatrixLiteral: _matrix,
}
