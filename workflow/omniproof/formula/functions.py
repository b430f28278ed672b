r"""The functions of mathematics that formulas are made of: one table, a row a function.

A row says how a function is read and written, and what is true of it as language: where it is
defined, its derivative, its symmetry. How an engine computes it stands in that engine, by the
name of the row: this module knows no engine, and SymPy and NumPy by the words of their code only.
To add a function is to add a row and its mathematics; `tests/formula/test_functions.py` names
every engine that lacks it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from types import MappingProxyType
from typing import Any, Literal, TypeAlias

from omniproof.formula.term import (
    ONE,
    ZERO,
    Call,
    Power,
    Product,
    Sum,
    Term,
    add,
    divide,
    multiply,
    negative,
    number,
    root,
    subtract,
)
from omniproof.formula.value import Comparison

Rule: TypeAlias = Callable[..., Term]
Point: TypeAlias = tuple[Term, Term]
"""Cosine and sine of an angle."""
OnCircle: TypeAlias = Callable[[Any, Any, Any], tuple[Any, Any]]


class Lacks(str):
    """Why a function has nothing in a column."""

    __slots__ = ()


@dataclass(frozen=True, kw_only=True)
class Elementary:
    r"""A function of the table: how it is read and written, and what is true of it.

    `commands` and `words` read as it: `\ln`, `\operatorname{atan2}`. `latex`, `text` and `typst`
    are its name in print; `sympy` is its name there, `numpy` its code with `{0}`, `{1}` for the
    arguments. `derivatives`, one an argument, are undefined just where the function has none.
    `domain` are the conditions under which it is defined. `neighbours` are what a misprint may have
    made of it, or it of them, the likeliest first. `inverse` is what `\sin^{-1}` means.
    `on_circle` gives numerator and denominator from 1, cosine and sine of the argument; `angle`
    gives cosine and sine of the angle that the function is. Where there is a `definition` by other
    functions, terms hold that, and no engine of terms meets the function itself.
    """

    name: str
    arguments: int
    commands: tuple[str, ...]
    words: tuple[str, ...]
    latex: str
    text: str
    typst: str
    sympy: str
    numpy: str
    parity: Literal["odd", "even"] | None
    derivatives: tuple[Rule, ...] | Lacks
    domain: Callable[..., tuple[Comparison, ...]]
    neighbours: tuple[str, ...]
    inverse: str
    on_circle: OnCircle | None
    angle: Callable[..., Point] | None
    definition: Rule | None


def _everywhere(*_: Term) -> tuple[Comparison, ...]:
    return ()


def _row(name: str, derivatives: tuple[Rule, ...] | Lacks, **columns: Any) -> Elementary:
    """Return a row; what is not said is as for most: a LaTeX command of one argument."""
    usual: dict[str, Any] = {
        "arguments": 1, "commands": (name,), "words": (name,), "latex": f"\\{name}",
        "text": name, "typst": name, "sympy": name, "numpy": f"np.{name}({{0}})",
        "parity": None, "domain": _everywhere, "neighbours": (), "inverse": "",
        "on_circle": None, "angle": None, "definition": None,
    }  # fmt: skip
    return Elementary(name=name, derivatives=derivatives, **usual | columns)


def _of(function: str) -> Rule:
    return lambda *arguments: Call(function, arguments)


HALF = number(Fraction(1, 2))
sin, cos, exp, size = _of("sin"), _of("cos"), _of("exp"), _of("abs")


def _square(x: Term) -> Term:
    return Power(x, 2)


def _inverse_of(x: Term) -> Term:
    return Power(x, -1)


def _complement(x: Term) -> Term:
    """Return the sine of an angle in the right half plane from its cosine, or the reverse."""
    return root(subtract(ONE, _square(x)))


def _hypotenuse(x: Term, y: Term) -> Term:
    return root(Sum((_square(x), _square(y))))


def _secant(x: Term) -> Term:
    """Return the secant of an angle in the right half plane from its tangent."""
    return root(Sum((ONE, _square(x))))


def _differs_from_0(term: Term) -> tuple[Comparison, ...]:
    return (Comparison(term, "\\neq", ZERO),)


def _not_negative(term: Term) -> tuple[Comparison, ...]:
    return (Comparison(term, "\\geq", ZERO),)


def _within_one(x: Term) -> tuple[Comparison, ...]:
    return _not_negative(subtract(ONE, x)) + _not_negative(add(ONE, x))


def _half(term: Term) -> Term:
    return multiply(HALF, term)


def _extreme(sign: int) -> dict[str, Any]:
    """Return the columns of the maximum (1) or minimum (-1) of two numbers, from their distance."""

    def rises(a: Term, b: Term) -> Term:  # 1, 0, or undefined where both meet
        gap = subtract(a, b)
        return _half(Sum((ONE, Product((number(sign), gap, _inverse_of(size(gap)))))))

    return {
        "derivatives": (rises, lambda a, b: rises(b, a)),
        "definition": lambda a, b: _half(Sum((a, b, multiply(number(sign), size(subtract(a, b)))))),
        "arguments": 2,
    }


def _hyperbolic(sign: int, x: Term) -> Term:
    return _half(Sum((exp(x), multiply(number(sign), exp(negative(x))))))


_ROWS = (
    _row("sin", (cos,), parity="odd", inverse="arcsin", neighbours=("cos",),
         on_circle=lambda one, c, s: (s, one)),
    _row("cos", (lambda x: negative(sin(x)),), parity="even", inverse="arccos", neighbours=("sin",),
         on_circle=lambda one, c, s: (c, one)),
    _row("tan", (lambda x: Power(cos(x), -2),), parity="odd", inverse="arctan",
         neighbours=("sin", "cos", "cot"), domain=lambda x: _differs_from_0(cos(x)),
         on_circle=lambda one, c, s: (s, c)),
    _row("cot", (lambda x: negative(Power(sin(x), -2)),), parity="odd", neighbours=("tan",),
         domain=lambda x: _differs_from_0(sin(x)), numpy="(1 / np.tan({0}))",
         on_circle=lambda one, c, s: (c, s)),
    _row("sec", (lambda x: multiply(sin(x), Power(cos(x), -2)),), parity="even",
         neighbours=("csc",), domain=lambda x: _differs_from_0(cos(x)),
         numpy="(1 / np.cos({0}))", on_circle=lambda one, c, s: (one, c)),
    _row("csc", (lambda x: negative(multiply(cos(x), Power(sin(x), -2))),), parity="odd",
         neighbours=("sec",), domain=lambda x: _differs_from_0(sin(x)),
         numpy="(1 / np.sin({0}))", on_circle=lambda one, c, s: (one, s)),
    _row("arcsin", (lambda x: _inverse_of(_complement(x)),), parity="odd", sympy="asin",
         neighbours=("arccos",), domain=_within_one, angle=lambda x: (_complement(x), x)),
    _row("arccos", (lambda x: negative(_inverse_of(_complement(x))),), sympy="acos",
         neighbours=("arcsin",), domain=_within_one, angle=lambda x: (x, _complement(x))),
    _row("arctan", (lambda x: _inverse_of(add(ONE, _square(x))),), parity="odd", sympy="atan",
         angle=lambda x: (divide(ONE, _secant(x)), divide(x, _secant(x)))),
    _row("atan2", Lacks("it jumps where its first argument passes 0 and its second is negative"),
         arguments=2, commands=(), latex=r"\operatorname{atan2}", numpy="np.arctan2({0}, {1})",
         domain=lambda y, x: _differs_from_0(Sum((_square(y), _square(x)))),
         angle=lambda y, x: (divide(x, _hypotenuse(x, y)), divide(y, _hypotenuse(x, y)))),
    _row("sqrt", (lambda x: _inverse_of(multiply(number(2), root(x))),), words=(), commands=(),
         text="√", domain=_not_negative),
    _row("abs", (lambda x: divide(x, size(x)),), words=(), commands=(), latex="|", text="|",
         parity="even", sympy="Abs"),
    _row("sign", Lacks("it jumps at 0"), commands=(), words=("sgn", "sign"), text="sgn",
         latex=r"\operatorname{sgn}", typst='op("sgn")', parity="odd"),
    _row("exp", (exp,)),
    _row("log", (_inverse_of,), commands=("ln",), words=("ln",), latex=r"\ln", text="ln",
         typst="ln", domain=lambda x: (Comparison(x, ">", ZERO),)),
    _row("sinh", (lambda x: _hyperbolic(1, x),), parity="odd", neighbours=("cosh",),
         definition=lambda x: _hyperbolic(-1, x)),
    _row("cosh", (lambda x: _hyperbolic(-1, x),), parity="even", neighbours=("sinh",),
         definition=lambda x: _hyperbolic(1, x)),
    _row("tanh", (lambda x: Power(_hyperbolic(1, x), -2),), parity="odd",
         definition=lambda x: divide(_hyperbolic(-1, x), _hyperbolic(1, x))),
    _row("max", sympy="Max", numpy="np.maximum({0}, {1})", neighbours=("min",), **_extreme(1)),
    _row("min", sympy="Min", numpy="np.minimum({0}, {1})", neighbours=("max",), **_extreme(-1)),
    _row("power", (lambda a, b: Product((b, Call("power", (a, b)), _inverse_of(a))),
                   lambda a, b: multiply(_of("log")(a), Call("power", (a, b)))),
         arguments=2, commands=(), words=(), sympy="Pow", numpy="np.power({0}, {1})",
         domain=lambda a, b: (Comparison(a, ">", ZERO),)),
)  # fmt: skip

FUNCTIONS: Mapping[str, Elementary] = MappingProxyType({row.name: row for row in _ROWS})
"""Every function, by its name in terms and trees."""
COMMANDS = MappingProxyType({name: row.name for row in _ROWS for name in row.commands})
"""The function that a command of LaTeX, without its backslash, reads as."""
WORDS = MappingProxyType({word: row.name for row in _ROWS for word in row.words})
r"""The function that a word in `\operatorname{…}` or `\mathrm{…}` reads as."""
INVERSES = MappingProxyType({row.name: row.inverse for row in _ROWS if row.inverse})
ON_CIRCLE = MappingProxyType({row.name: row.on_circle for row in _ROWS if row.on_circle})
CIRCULAR = frozenset(ON_CIRCLE)
"""Functions of the point of the circle at an angle."""
ANGLES = MappingProxyType({row.name: row.angle for row in _ROWS if row.angle})
"""Cosine and sine of the functions that are angles."""


def applied(function: str, arguments: Sequence[Term]) -> Term:
    """Return a function of terms, by its definition if it has one.

    A function of two arguments is taken of more of them two by two: a maximum, a minimum.
    """
    definition = FUNCTIONS[function].definition if function in FUNCTIONS else None
    if definition is None:
        return Call(function, tuple(arguments))
    return definition(*arguments) if len(arguments) == 1 else reduce(definition, arguments)
