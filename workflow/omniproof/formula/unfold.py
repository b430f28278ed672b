"""From the printed tree to terms: vectors and matrices entry by entry, shapes checked.

Nothing is evaluated: a term still shows every printed denominator, radicand and argument, and so
where the line is defined. What symbols stand for comes from outside, as terms or as SymPy's
expressions of a derivation.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from types import FunctionType
from typing import Any, NoReturn

from omniproof.formula.errors import UnsupportedError
from omniproof.formula.grid import LARGEST_DETERMINANT, Grid, ShapeError, cross, inner
from omniproof.formula.monomials import is_plainly_zero
from omniproof.formula.term import (
    PI,
    Call,
    Integral,
    Number,
    Power,
    Product,
    Symbol,
    Term,
    add,
    divide,
    multiply,
    negative,
    number,
    rational,
    root,
    substitute,
)
from omniproof.formula.value import Cases, Comparison, Function, Logic, Statement, Value, kind
from omniproof.formula.writers import latex
from omniproof.transcription import tree
from omniproof.transcription.faults import nearest
from omniproof.transcription.functions import FUNCTIONS
from omniproof.transcription.reader import read
from omniproof.transcription.tokens import LatexError

AXES = {"x": 0, "y": 1, "z": 2}
MAX_BITS = 40_000
"""Powers of numbers beyond this size are refused: no paper prints one, and each takes its time."""
MAX_MATRIX_POWER = 8
MAX_DIGITS = 1_000


def unfold(node: tree.Node, meanings: Mapping[str, Any], source: str = "") -> Value:
    """Give a tree the value that its symbols mean.

    `meanings` are keyed by canonical symbol name: a `Term`, a `Grid`, a `Function` of arguments, or
    an operator to call. A number gives a `Term`, a vector an n×1 and a matrix an n×m `Grid`, a
    comparison a `Statement`; a chain gives the tuple of its sides, a listing or set the tuple of
    its items, a set builder its element and conditions.
    Raises `LatexError` for an unknown symbol and for shapes that do not fit; `source` is the text
    that was read.
    """
    return _Scope(meanings, source).value(node)


def applied(function: str, arguments: Sequence[Term]) -> Term:
    """Return a function of terms, by its definition if it has one; of more than two, in turn."""
    definition = FUNCTIONS[function].definition if function in FUNCTIONS else ""
    if not definition:
        return Call(function, tuple(arguments))
    node = read(definition, symbols="xy")
    if len(arguments) == 1:
        return unfold(node, {"x": arguments[0]})
    return reduce(lambda x, y: unfold(node, {"x": x, "y": y}), arguments)


@dataclass(frozen=True)
class _Scope:
    """What the symbols mean, and the text for messages."""

    meanings: Mapping[str, Any]
    source: str

    def value(self, node: tree.Node) -> Value:
        return _RULES[type(node)](self, node)

    def number(self, node: tree.Node) -> Term:
        """The value of a node that has to be a number."""
        value = self.value(node)
        if not isinstance(value, Term):
            self.refuse(node, f"expected a number, found {kind(value)}")
        return value

    def vector(self, node: tree.Node) -> Grid:
        """The value of a node that has to be a vector, as a column."""
        value = self.value(node)
        if not isinstance(value, Grid) or 1 not in value.shape:
            self.refuse(node, f"expected a vector, found {kind(value)}")
        return value if value.shape[1] == 1 else value.transposed

    def square(self, node: tree.Node) -> Grid:
        """The value of a node that has to be a square matrix."""
        value = self.value(node)
        if not isinstance(value, Grid) or value.shape[0] != value.shape[1]:
            self.refuse(node, f"expected a square matrix, found {kind(value)}")
        return value

    def truth(self, node: tree.Node) -> Statement:
        """The value of a statement; an equation between its sides becomes a comparison."""
        if not isinstance(node, tree.STATEMENTS):
            self.refuse(node, f"expected a statement, found {kind(self.value(node))}")
        value = self.value(node)
        if not isinstance(node, tree.Chain):
            return value
        if node.relation != "=":
            return Logic("equivalent", value)
        return Logic("and", tuple(Comparison(a, "=", b) for a, b in pairwise(value)))

    def refuse(self, node: tree.Node, message: str, cure: str = "") -> NoReturn:
        if self.source:
            raise LatexError(message, self.source, node.span, cure)
        text = latex(node)
        raise LatexError(message, text, (0, len(text)), cure)


def _name(scope: _Scope, node: tree.Name) -> Value:
    value = _meaning(scope, node)
    if isinstance(value, FunctionType):
        scope.refuse(node, f"expected arguments of `{node.name}`")
    return value


def _meaning(scope: _Scope, node: tree.Name | tree.Applied) -> Value:
    """Look a symbol up; the determinant of a known matrix needs no entry of its own."""
    name = node.name
    if name in scope.meanings:
        meaning = scope.meanings[name]
        return meaning.value if isinstance(meaning, Function) else meaning
    if name.removeprefix("\\det ") in scope.meanings:
        return _determinant(scope, node, scope.square(tree.Name(name[5:], span=node.span)))
    cure = nearest(name, scope.meanings, "declare it among the symbols of the paper")
    return scope.refuse(node, f"unknown symbol `{name}`", cure)


def _applied(scope: _Scope, node: tree.Applied) -> Value:
    """A quantity with its arguments in the place of the variables that it is a function of."""
    value, function = _meaning(scope, node), scope.meanings.get(node.name)
    if isinstance(value, FunctionType):  # an operator: `Rot(z, a)` takes an axis and an angle
        try:
            return value(*map(scope.value, node.arguments))
        except (TypeError, ValueError, UnsupportedError):
            scope.refuse(node, f"`{node.name}` has no such arguments")
    # Arguments of what is no function would be dropped: different formulas would look alike.
    if not isinstance(function, Function):
        cure = f"say of what `{node.name}` is a function: `of: ['\\theta']` beside its `role`"
        scope.refuse(node, f"`{node.name}` has arguments, and is declared no function", cure)
    if len(node.arguments) != len(function.of):
        scope.refuse(node, f"expected {len(function.of)} arguments of `{node.name}`")
    arguments = [scope.number(argument) for argument in node.arguments]
    places = dict(zip(function.of, arguments, strict=True))
    if isinstance(value, Grid):
        return Grid(tuple(tuple(substitute(x, places) for x in row) for row in value.rows))
    return substitute(value, places)


def _sum(scope: _Scope, node: tree.Sum) -> Value:
    values = [scope.value(term) for term in node.terms]
    for value in values[1:]:
        if getattr(values[0], "shape", ()) != getattr(value, "shape", ()):
            scope.refuse(node, f"cannot add {kind(value)} to {kind(values[0])}")
    if isinstance(values[0], Term):
        return add(*values)
    return reduce(Grid.__add__, values)


def _times(scope: _Scope, node: tree.Node, left: Value, right: Value) -> Value:
    """The product in printed order; a 1×1 result is a number."""
    match left, right:
        case Term(), Term():
            return multiply(left, right)
        case (Term() as factor, Grid() as grid) | (Grid() as grid, Term() as factor):
            return grid.scaled(factor)
        case Grid(), Grid():
            if left.shape[1] != right.shape[0]:
                scope.refuse(node, f"cannot multiply {kind(left)} by {kind(right)}")
            product = left @ right
            return product.rows[0][0] if product.shape == (1, 1) else product
    bad = right if isinstance(left, Term | Grid) else left
    return scope.refuse(node, f"cannot multiply {kind(bad)}")


def _product(scope: _Scope, node: tree.Product) -> Value:
    values = [scope.value(factor) for factor in node.factors]
    if all(isinstance(value, Term) for value in values):
        return multiply(*values)
    return reduce(lambda left, right: _times(scope, node, left, right), values)


def _dot(scope: _Scope, node: tree.Dot) -> Value:
    left, right = scope.value(node.left), scope.value(node.right)
    if all(isinstance(value, Grid) and value.is_vector for value in (left, right)):
        return _inner(scope, tree.Inner(node.left, node.right, span=node.span))
    return _times(scope, node, left, right)


def _inner(scope: _Scope, node: tree.Inner) -> Term:
    left, right = scope.vector(node.left), scope.vector(node.right)
    if left.shape != right.shape:
        scope.refuse(node, f"no inner product of {kind(left)} and {kind(right)}")
    return inner(left.entries, right.entries)


def _cross(scope: _Scope, node: tree.Cross) -> Value:
    """The cross product; vectors of the plane lie in z = 0. Between numbers, the product."""
    left, right = scope.value(node.left), scope.value(node.right)
    if not all(isinstance(value, Grid) and value.is_vector for value in (left, right)):
        return _times(scope, node, left, right)
    if not {left.shape[0], right.shape[0]} <= {2, 3}:
        scope.refuse(node, f"no cross product of {kind(left)} and {kind(right)}")
    return cross(left, right)


def _quotient(scope: _Scope, node: tree.Quotient) -> Value:
    above, below = scope.value(node.numerator), scope.number(node.denominator)
    if is_plainly_zero(below):
        scope.refuse(node.denominator, "cannot divide by 0")
    if isinstance(above, Term):
        return divide(above, below)
    return _times(scope, node, above, Power(below, -1))


def _number(scope: _Scope, node: tree.Node, text: str) -> Number:
    if len(text) > MAX_DIGITS:
        scope.refuse(node, f"expected a number with at most {MAX_DIGITS} digits")
    return Number(Fraction(text))


def _degrees(scope: _Scope, node: tree.Degrees) -> Term:
    return Product((Number(_number(scope, node, node.value).value / 180), PI))


def _negative(scope: _Scope, node: tree.Negative) -> Value:
    value = scope.value(node.operand)
    if isinstance(value, Number):
        return Number(-value.value)
    return negative(value) if isinstance(value, Term) else _times(scope, node, number(-1), value)


def _power(scope: _Scope, node: tree.Power) -> Value:
    base, exponent = scope.value(node.base), node.exponent
    if isinstance(base, Term):
        if exponent < 0 and is_plainly_zero(base):
            scope.refuse(node, "cannot divide by 0")
        value = rational(base)
        if value is not None:
            bits = max(abs(value.numerator), value.denominator).bit_length()
            if bits * abs(exponent) > MAX_BITS:
                scope.refuse(node, "expected a smaller power of a number")
        return Power(base, exponent)
    base = scope.square(node.base)
    if abs(exponent) > MAX_MATRIX_POWER:
        scope.refuse(node, f"expected a power of a matrix up to {MAX_MATRIX_POWER}")
    if exponent == 0:
        return Grid.identity(base.shape[0])
    if exponent < 0:
        if rational(_determinant(scope, node, base)) == 0:
            scope.refuse(node, "cannot invert a singular matrix")
        base = base.inverse
    return reduce(Grid.__matmul__, [base] * abs(exponent))


def _transpose(scope: _Scope, node: tree.Transpose) -> Grid:
    """Transpose a matrix; a vector printed in a line stands for a column already."""
    value = scope.value(node.operand)
    if not isinstance(value, Grid):
        scope.refuse(node, f"cannot transpose {kind(value)}")
    return value if isinstance(node.operand, tree.Tuple) else value.transposed


def _call(scope: _Scope, node: tree.Call) -> Term:
    if node.function == "det":
        return _determinant(scope, node, scope.square(node.argument))
    if FUNCTIONS[node.function].arguments == 1:
        return applied(node.function, (scope.number(node.argument),))
    items = node.argument.items if isinstance(node.argument, tree.Tuple) else ()
    if len(items) < 2 or (len(items) > 2 and node.function == "atan2"):
        scope.refuse(node, f"expected two arguments of `{node.function}`")
    return applied(node.function, tuple(map(scope.number, items)))


def _integral(scope: _Scope, node: tree.Integral) -> Term:
    """A definite integral as it is printed: nothing is integrated here."""
    variable = scope.number(node.variable)
    if not isinstance(variable, Symbol):
        scope.refuse(node.variable, "expected a variable to integrate over")
    ends = scope.number(node.lower), scope.number(node.upper)
    return Integral(scope.number(node.integrand), variable, *ends)


def _norm(scope: _Scope, node: tree.Norm) -> Term:
    value = scope.value(node.operand)
    if isinstance(value, Term):
        return Call("abs", (value,))
    entries = scope.vector(node.operand).entries
    return root(add(*(Power(entry, 2) for entry in entries)))


def _columns(scope: _Scope, node: tree.Determinant) -> Term:
    columns = [scope.vector(column) for column in node.columns]
    if {column.shape[0] for column in columns} != {len(columns)}:
        scope.refuse(node, f"expected {len(columns)} vectors of {len(columns)}")
    return _determinant(scope, node, Grid(tuple(c.entries for c in columns)).transposed)


def _determinant(scope: _Scope, node: tree.Node, grid: Grid) -> Term:
    if grid.is_rational:
        return Number(grid.rational_determinant)
    if grid.shape[0] > LARGEST_DETERMINANT:
        scope.refuse(node, f"expected a determinant with at most {LARGEST_DETERMINANT} rows")
    return grid.determinant


def _component(scope: _Scope, node: tree.Component) -> Term:
    vector = scope.vector(node.vector)
    place = AXES.get(node.axis, int(node.axis) - 1 if node.axis.isdigit() else -1)
    if not 0 <= place < vector.shape[0]:
        scope.refuse(node, f"no component {node.axis} in {kind(vector)}")
    return vector.entries[place]


def _tuple(scope: _Scope, node: tree.Tuple) -> Value:
    """A vector of numbers, a matrix of column vectors; a set stays a list."""
    values = tuple(scope.value(item) for item in node.items)
    if node.kind == "set" or any(not isinstance(value, Term | Grid) for value in values):
        return values
    if all(isinstance(value, Term) for value in values):
        return Grid.column(values)
    first = values[0]
    vectors = all(isinstance(value, Grid) and value.is_vector for value in values)
    if not vectors or any(value.shape != first.shape for value in values):
        scope.refuse(node, "expected numbers only, or vectors of one length only")
    return Grid(tuple(value.entries for value in values)).transposed


def _matrix(scope: _Scope, node: tree.MatrixLiteral) -> Grid:
    """A matrix of numbers, or of blocks that fit together."""
    rows = ([_block(scope, entry) for entry in row] for row in node.rows)
    try:
        return Grid.of_blocks(rows)
    except ShapeError:
        return scope.refuse(node, "the parts of the matrix do not fit together")


def _block(scope: _Scope, node: tree.Node) -> Grid:
    value = scope.value(node)
    if not isinstance(value, Term | Grid):
        scope.refuse(node, f"expected a number, found {kind(value)}")
    return value if isinstance(value, Grid) else Grid(((value,),))


def _chain(scope: _Scope, node: tree.Chain) -> Value:
    read = scope.value if node.relation == "=" else scope.truth
    return tuple(read(side) for side in node.sides)


_RULES: dict[type[tree.Node], Callable[[_Scope, Any], Value]] = {
    tree.Number: lambda scope, node: _number(scope, node, node.text),
    tree.Degrees: _degrees,
    tree.Pi: lambda scope, node: PI,
    tree.Name: _name,
    tree.Applied: _applied,
    tree.Negative: _negative,
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
    tree.Absolute: lambda scope, node: Call("abs", (scope.number(node.operand),)),
    tree.Determinant: _columns,
    tree.Component: _component,
    tree.Tuple: _tuple,
    tree.MatrixLiteral: _matrix,
    tree.SetBuilder: lambda scope, node: tuple(map(scope.value, (node.element, *node.conditions))),
    tree.Cases: lambda scope, node: Cases(
        tuple((scope.number(row.value), scope.truth(row.condition)) for row in node.branches)
    ),
    tree.Comparison: lambda scope, node: Comparison(
        scope.number(node.left), node.operator, scope.number(node.right)
    ),
    tree.Logic: lambda scope, node: Logic(node.operator, tuple(map(scope.truth, node.operands))),
    tree.Chain: _chain,
    tree.Listing: lambda scope, node: tuple(scope.value(item) for item in node.items),
}
