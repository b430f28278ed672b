"""From the printed tree to SymPy: exact numbers, vectors as columns, shapes checked.

One side of an equation may simplify on the way, since its value is all that counts here; whether
two sides agree is asked elsewhere, of a difference that is built without evaluation. This and
`calls` are the only modules of the transcription that need SymPy.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import reduce
from itertools import pairwise
from operator import add, mul
from types import FunctionType
from typing import Any, NoReturn, TypeAlias

import sympy
from sympy import Expr, ImmutableMatrix, MatrixBase, Rational, Symbol

from omniproof.transcription import tree
from omniproof.transcription.calls import call
from omniproof.transcription.printer import latex
from omniproof.transcription.tokens import LatexError

Meaning: TypeAlias = Any
"""An expression, a matrix, for a quantity with arguments a `Function` of them, or an operator."""
Value: TypeAlias = Any
"""An expression, a matrix, a relation, or a tuple of these."""


@dataclass(frozen=True)
class Function:
    """What a quantity is, and the variables in it that its printed arguments replace."""

    value: Value
    of: tuple[Symbol, ...]


AXES = {"x": 0, "y": 1, "z": 2}
MAX_BITS = 40_000
"""Powers of numbers beyond this size are refused, and so are high powers of matrices."""
MAX_MATRIX_POWER = 8
MAX_DIGITS = 1_000
MAX_ROWS = 6
"""Larger determinants with symbols are refused: n! terms."""
COMPARE: dict[str, Callable[..., Any]] = {
    "<": sympy.Lt, ">": sympy.Gt, "\\leq": sympy.Le, "\\geq": sympy.Ge, "\\neq": sympy.Ne,
}  # fmt: skip


def evaluate(node: tree.Node, meanings: Mapping[str, Meaning], source: str = "") -> Value:
    """Give a tree the value that its symbols mean.

    `meanings` are keyed by canonical symbol name. An expression gives an `Expr`, a vector an n×1
    and a matrix an n×m `ImmutableMatrix`, a comparison a relation; a chain gives the tuple of its
    sides, a listing or set the tuple of its items, a set builder its element and conditions.
    Raises `LatexError` for an unknown symbol and for shapes that do not fit; `source` is the text
    that was read.
    """
    return _Scope(meanings, source, node).value(node)


@dataclass(frozen=True)
class _Scope:
    """What the symbols mean, and the text for messages."""

    meanings: Mapping[str, Meaning]
    source: str
    root: tree.Node

    def value(self, node: tree.Node) -> Value:
        return _RULES[type(node)](self, node)

    def number(self, node: tree.Node) -> Expr:
        """The value of a node that has to be a number."""
        value = self.value(node)
        if not _is_scalar(value):
            self.refuse(node, f"expected a number, found {_kind(value)}")
        return value

    def vector(self, node: tree.Node) -> MatrixBase:
        """The value of a node that has to be a vector, as a column."""
        value = self.value(node)
        if not isinstance(value, MatrixBase) or 1 not in value.shape:
            self.refuse(node, f"expected a vector, found {_kind(value)}")
        return value if value.shape[1] == 1 else value.T

    def square(self, node: tree.Node) -> MatrixBase:
        """The value of a node that has to be a square matrix."""
        value = self.value(node)
        if not isinstance(value, MatrixBase) or value.shape[0] != value.shape[1]:
            self.refuse(node, f"expected a square matrix, found {_kind(value)}")
        return value

    def truth(self, node: tree.Node) -> Value:
        """The value of a statement; an equation between its sides becomes a relation."""
        if not isinstance(node, tree.STATEMENTS):
            self.refuse(node, f"expected a statement, found {_kind(self.value(node))}")
        value = self.value(node)
        if not isinstance(node, tree.Chain):
            return value
        if node.relation == "=":
            return sympy.And(*(sympy.Eq(left, right) for left, right in pairwise(value)))
        return sympy.Equivalent(*value)

    def refuse(self, node: tree.Node, message: str, cure: str = "") -> NoReturn:
        if self.source:
            raise LatexError(message, self.source, node.span, cure)
        text = latex(node)
        raise LatexError(message, text, (0, len(text)), cure)


def _kind(value: Value) -> str:
    """A value in words."""
    if isinstance(value, MatrixBase):
        rows, columns = value.shape
        return f"a vector of {rows}" if columns == 1 else f"a {rows}×{columns} matrix"
    if _is_scalar(value):
        return "a number"
    return "a list" if isinstance(value, tuple) else "a statement"


def _name(scope: _Scope, node: tree.Name | tree.Applied) -> Value:
    """Look a symbol up; the determinant of a known matrix needs no entry of its own."""
    name = node.name
    if name in scope.meanings:
        meaning = scope.meanings[name]
        return meaning.value if isinstance(meaning, Function) else meaning
    if name.removeprefix("\\det ") in scope.meanings:
        return _det(scope, node, scope.square(tree.Name(name[5:], span=node.span)))
    near = get_close_matches(name, list(scope.meanings), n=1)
    cure = f"did you mean `{near[0]}`?" if near else "declare it among the symbols of the paper"
    return scope.refuse(node, f"unknown symbol `{name}`", cure)


def _applied(scope: _Scope, node: tree.Applied) -> Value:
    """A quantity with its arguments in the place of the variables that it is a function of."""
    value, function = _name(scope, node), scope.meanings.get(node.name)
    if isinstance(value, FunctionType):  # an operator: `Rot(z, a)` takes an axis and an angle
        try:
            return value(*map(scope.value, node.arguments))
        except (TypeError, ValueError):
            scope.refuse(node, f"`{node.name}` has no such arguments")
    # Arguments of what is no function would be dropped: different formulas would look alike.
    if not isinstance(function, Function):
        cure = f"say of what `{node.name}` is a function: `of: ['\\theta']` beside its `role`"
        scope.refuse(node, f"`{node.name}` has arguments, and is declared no function", cure)
    if len(node.arguments) != len(function.of):
        scope.refuse(node, f"expected {len(function.of)} arguments of `{node.name}`")
    arguments = [scope.number(argument) for argument in node.arguments]
    places = dict(zip(function.of, arguments, strict=True))
    # The variable of an integral is no argument, even where papers give both one name.
    bound = value.has(sympy.Integral)
    return value.subs(places, simultaneous=True) if bound else value.xreplace(places)


def _sum(scope: _Scope, node: tree.Sum) -> Value:
    values = [scope.value(term) for term in node.terms]
    for value in values[1:]:
        if getattr(values[0], "shape", ()) != getattr(value, "shape", ()):
            scope.refuse(node, f"cannot add {_kind(value)} to {_kind(values[0])}")
    return sympy.Add(*values) if _is_scalar(values[0]) else reduce(add, values)


def _times(scope: _Scope, node: tree.Node, left: Value, right: Value) -> Value:
    """The product in printed order; a 1×1 result is a number."""
    for value in (left, right):
        if not isinstance(value, Expr | MatrixBase):
            scope.refuse(node, f"cannot multiply {_kind(value)}")
    if isinstance(left, MatrixBase) and isinstance(right, MatrixBase):
        if left.shape[1] != right.shape[0]:
            scope.refuse(node, f"cannot multiply {_kind(left)} by {_kind(right)}")
        product = left * right
        return product[0, 0] if product.shape == (1, 1) else product
    return left * right


def _product(scope: _Scope, node: tree.Product) -> Value:
    values = (scope.value(factor) for factor in node.factors)
    return reduce(lambda left, right: _times(scope, node, left, right), values)


def _is_scalar(value: Value) -> bool:
    """Whether a value is a number; SymPy's immutable matrices are expressions too."""
    return isinstance(value, Expr) and not isinstance(value, MatrixBase)


def _is_vector(value: Value) -> bool:
    return isinstance(value, MatrixBase) and value.shape[1] == 1 and value.shape[0] > 1


def _dot(scope: _Scope, node: tree.Dot) -> Value:
    left, right = scope.value(node.left), scope.value(node.right)
    if _is_vector(left) and _is_vector(right):
        return _inner(scope, tree.Inner(node.left, node.right, span=node.span))
    return _times(scope, node, left, right)


def _inner(scope: _Scope, node: tree.Inner) -> Value:
    left, right = scope.vector(node.left), scope.vector(node.right)
    if left.shape != right.shape:
        scope.refuse(node, f"no inner product of {_kind(left)} and {_kind(right)}")
    return sum((a * b for a, b in zip(left, right, strict=True)), sympy.Integer(0))


def _cross(scope: _Scope, node: tree.Cross) -> Value:
    """The cross product; vectors of the plane lie in z = 0. Between numbers, the product."""
    left, right = scope.value(node.left), scope.value(node.right)
    if not (_is_vector(left) and _is_vector(right)):
        return _times(scope, node, left, right)
    if not {left.shape[0], right.shape[0]} <= {2, 3}:
        scope.refuse(node, f"no cross product of {_kind(left)} and {_kind(right)}")
    padded = (ImmutableMatrix([*vector, 0][:3]) for vector in (left, right))
    first, second = padded
    return first.cross(second)


def _quotient(scope: _Scope, node: tree.Quotient) -> Value:
    above, below = scope.value(node.numerator), scope.number(node.denominator)
    if below == 0:
        scope.refuse(node.denominator, "cannot divide by 0")
    return _times(scope, node, above, 1 / below)


def _rational(scope: _Scope, node: tree.Node, text: str) -> Rational:
    if len(text) > MAX_DIGITS:
        scope.refuse(node, f"expected a number with at most {MAX_DIGITS} digits")
    return Rational(text)


def _power(scope: _Scope, node: tree.Power) -> Value:
    base, size = scope.value(node.base), abs(node.exponent)
    if _is_scalar(base):
        if base == 0 and node.exponent < 0:
            scope.refuse(node, "cannot divide by 0")
        if base.is_Rational and max(base.p, -base.p, base.q).bit_length() * size > MAX_BITS:
            scope.refuse(node, "expected a smaller power of a number")
        return base**node.exponent
    base = scope.square(node.base)
    if size > MAX_MATRIX_POWER:
        scope.refuse(node, f"expected a power of a matrix up to {MAX_MATRIX_POWER}")
    if node.exponent == 0:
        return ImmutableMatrix.eye(base.shape[0])
    if node.exponent > 0:
        return reduce(mul, [base] * size)
    determinant = _det(scope, node, base)
    if determinant == 0:
        scope.refuse(node, "cannot invert a singular matrix")
    return reduce(mul, [base.adjugate() / determinant] * size)


def _transpose(scope: _Scope, node: tree.Transpose) -> Value:
    """Transpose a matrix; a vector printed in a line stands for a column already."""
    value = scope.value(node.operand)
    if not isinstance(value, MatrixBase):
        scope.refuse(node, f"cannot transpose {_kind(value)}")
    return value if isinstance(node.operand, tree.Tuple) else value.T


def _call(scope: _Scope, node: tree.Call) -> Value:
    if node.function == "det":
        return _det(scope, node, scope.square(node.argument))
    if node.function == "atan2":
        if not isinstance(node.argument, tree.Tuple) or len(node.argument.items) != 2:
            scope.refuse(node, "expected two arguments of `atan2`")
        return sympy.atan2(*(scope.number(item) for item in node.argument.items))
    return call(node.function, scope.number(node.argument))


def _integral(scope: _Scope, node: tree.Integral) -> Value:
    """A definite integral as it is printed: nothing is integrated here."""
    variable = scope.number(node.variable)
    if not variable.is_Symbol:
        scope.refuse(node.variable, "expected a variable to integrate over")
    limits = scope.number(node.lower), scope.number(node.upper)
    return sympy.Integral(scope.number(node.integrand), (variable, *limits))


def _norm(scope: _Scope, node: tree.Norm) -> Value:
    value = scope.value(node.operand)
    if _is_scalar(value):
        return sympy.Abs(value)
    return sympy.sqrt(sum(entry**2 for entry in scope.vector(node.operand)))


def _determinant(scope: _Scope, node: tree.Determinant) -> Value:
    columns = [scope.vector(column) for column in node.columns]
    if {column.shape[0] for column in columns} != {len(columns)}:
        scope.refuse(node, f"expected {len(columns)} vectors of {len(columns)}")
    return _det(scope, node, ImmutableMatrix.hstack(*columns))


def _det(scope: _Scope, node: tree.Node, matrix: MatrixBase) -> Expr:
    """Expand a determinant by minors; elimination would simplify each of its quotients."""
    if not matrix.free_symbols:
        return matrix.det()
    if matrix.shape[0] > MAX_ROWS:
        scope.refuse(node, f"expected a determinant with at most {MAX_ROWS} rows")
    return matrix.det(method="laplace")


def _component(scope: _Scope, node: tree.Component) -> Value:
    vector = scope.vector(node.vector)
    place = AXES.get(node.axis, int(node.axis) - 1 if node.axis.isdigit() else -1)
    if not 0 <= place < vector.shape[0]:
        scope.refuse(node, f"no component {node.axis} in {_kind(vector)}")
    return vector[place]


def _tuple(scope: _Scope, node: tree.Tuple) -> Value:
    """A vector of numbers, a matrix of column vectors; a set stays a list."""
    values = tuple(scope.value(item) for item in node.items)
    if node.kind == "set" or any(not isinstance(value, Expr | MatrixBase) for value in values):
        return values
    if all(_is_scalar(value) for value in values):
        return ImmutableMatrix(values)
    if not all(_is_vector(value) and value.shape == values[0].shape for value in values):
        scope.refuse(node, "expected numbers only, or vectors of one length only")
    return ImmutableMatrix.hstack(*values)


def _matrix(scope: _Scope, node: tree.MatrixLiteral) -> Value:
    """A matrix of numbers, or of blocks that fit together."""
    rows = [[_entry(scope, entry) for entry in row] for row in node.rows]
    if all(_is_scalar(value) for row in rows for value in row):
        return ImmutableMatrix(rows)
    try:
        blocks = [[sympy.Matrix([[v]]) if _is_scalar(v) else v for v in row] for row in rows]
        return ImmutableMatrix.vstack(*(ImmutableMatrix.hstack(*row) for row in blocks))
    except sympy.ShapeError:
        return scope.refuse(node, "the parts of the matrix do not fit together")


def _entry(scope: _Scope, node: tree.Node) -> Value:
    value = scope.value(node)
    if not isinstance(value, Expr | MatrixBase):
        scope.refuse(node, f"expected a number, found {_kind(value)}")
    return value


def _comparison(scope: _Scope, node: tree.Comparison) -> Value:
    left, right = scope.number(node.left), scope.number(node.right)
    try:
        return COMPARE[node.operator](left, right)
    except TypeError:
        return scope.refuse(node, "cannot compare numbers that are not real")


def _logic(scope: _Scope, node: tree.Logic) -> Value:
    join = sympy.And if node.operator == "and" else sympy.Or
    return join(*(scope.truth(part) for part in node.operands))


def _chain(scope: _Scope, node: tree.Chain) -> Value:
    read = scope.value if node.relation == "=" else scope.truth
    return tuple(read(side) for side in node.sides)


def _cases(scope: _Scope, node: tree.Cases) -> Value:
    branches = ((scope.number(row.value), scope.truth(row.condition)) for row in node.branches)
    return sympy.Piecewise(*branches)


_RULES: dict[type[tree.Node], Callable[[_Scope, Any], Value]] = {
    tree.Number: lambda scope, node: _rational(scope, node, node.text),
    tree.Degrees: lambda scope, node: _rational(scope, node, node.value) * sympy.pi / 180,
    tree.Pi: lambda scope, node: sympy.pi,
    tree.Name: _name,
    tree.Applied: _applied,
    tree.Negative: lambda scope, node: _times(scope, node, -sympy.S.One, scope.value(node.operand)),
    tree.Sum: _sum,
    tree.Product: _product,
    tree.Dot: _dot,
    tree.Cross: _cross,
    tree.Quotient: _quotient,
    tree.Power: _power,
    tree.Transpose: _transpose,
    tree.Call: _call,
    tree.Integral: _integral,
    tree.Inner: _inner,
    tree.Norm: _norm,
    tree.Absolute: lambda scope, node: sympy.Abs(scope.number(node.operand)),
    tree.Determinant: _determinant,
    tree.Component: _component,
    tree.Tuple: _tuple,
    tree.MatrixLiteral: _matrix,
    tree.SetBuilder: lambda scope, node: tuple(map(scope.value, (node.element, *node.conditions))),
    tree.Cases: _cases,
    tree.Comparison: _comparison,
    tree.Logic: _logic,
    tree.Chain: _chain,
    tree.Listing: lambda scope, node: tuple(scope.value(item) for item in node.items),
}
