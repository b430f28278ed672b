r"""The functions of mathematics that formulas are made of: one table, a row a function.

A row says how a function is read and written, and what is true of it, in the language of formulas
itself; its arguments are called x and y. How an engine computes it stands in that engine, by the
name of the row: this module knows no engine, and SymPy and NumPy by the words of their code only.
To add a function is to add a row and its mathematics; `tests/formula/test_functions.py` names
every engine that lacks it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal


class Lacks(str):
    """Why a function has nothing in a column."""

    __slots__ = ()


@dataclass(frozen=True, kw_only=True)
class Row:
    r"""A function of the table: how it is read and written, and what is true of it.

    `commands` and `words` read as it: `\ln`, `\operatorname{atan2}`. `latex`, `text` and `typst`
    are its name in print; `sympy` is its name there, `numpy` its code with `{0}`, `{1}` for the
    arguments. `inverse` is what `\sin^{-1}` means. `neighbours` are what a misprint may have made
    of it, or it of them, the likeliest first.

    `derivative`, one an argument, is undefined just where the function has none. `domain` are the
    conditions under which it is defined. `circle` is a quotient of 1, the cosine `c` and the sine
    `s` of its argument; `angle` gives cosine and sine of the angle that it is. Where there is a
    `definition` by other functions, terms hold that, and no engine of terms meets the function.
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
    derivative: tuple[str, ...] | Lacks
    domain: tuple[str, ...]
    neighbours: tuple[str, ...]
    inverse: str
    circle: tuple[str, str] | None
    angle: tuple[str, str] | None
    definition: str


def _row(name: str, *derivative: str, **columns: Any) -> Row:
    """Return a row; what is not said is as for most: a LaTeX command of one argument."""
    usual: dict[str, Any] = {
        "arguments": 1, "commands": (name,), "words": (name,), "latex": f"\\{name}",
        "text": name, "typst": name, "sympy": name, "numpy": f"np.{name}({{0}})",
        "parity": None, "domain": (), "neighbours": (), "inverse": "", "circle": None,
        "angle": None, "definition": "", "derivative": derivative,
    }  # fmt: skip
    return Row(name=name, **usual | columns)


_WITHIN_ONE = (r"1 - x \geq 0", r"1 + x \geq 0")
_RISES, _RESTS = (
    r"\frac{1}{2}(1 + \frac{x - y}{|x - y|})",
    r"\frac{1}{2}(1 - \frac{x - y}{|x - y|})",
)
_ROWS = (
    _row("sin", r"\cos x", parity="odd", inverse="arcsin", neighbours=("cos",), circle=("s", "1")),
    _row("cos", r"-\sin x", parity="even", inverse="arccos", neighbours=("sin",),
         circle=("c", "1")),
    _row("tan", r"\frac{1}{\cos(x)^2}", domain=(r"\cos x \neq 0",), circle=("s", "c"),
         parity="odd", inverse="arctan", neighbours=("sin", "cos", "cot")),
    _row("cot", r"-\frac{1}{\sin(x)^2}", domain=(r"\sin x \neq 0",), circle=("c", "s"),
         parity="odd", neighbours=("tan",), numpy="(1 / np.tan({0}))"),
    _row("sec", r"\frac{\sin x}{\cos(x)^2}", domain=(r"\cos x \neq 0",), circle=("1", "c"),
         parity="even", neighbours=("csc",), numpy="(1 / np.cos({0}))"),
    _row("csc", r"-\frac{\cos x}{\sin(x)^2}", domain=(r"\sin x \neq 0",), circle=("1", "s"),
         parity="odd", neighbours=("sec",), numpy="(1 / np.sin({0}))"),
    _row("arcsin", r"\frac{1}{\sqrt{1 - x^2}}", domain=_WITHIN_ONE,
         angle=(r"\sqrt{1 - x^2}", "x"),
         parity="odd", neighbours=("arccos",), words=("arcsin", "asin"), sympy="asin"),
    _row("arccos", r"-\frac{1}{\sqrt{1 - x^2}}", domain=_WITHIN_ONE,
         angle=("x", r"\sqrt{1 - x^2}"),
         neighbours=("arcsin",), words=("arccos", "acos"), sympy="acos"),
    _row("arctan", r"\frac{1}{1 + x^2}",
         angle=(r"\frac{1}{\sqrt{1 + x^2}}", r"\frac{x}{\sqrt{1 + x^2}}"),
         parity="odd", words=("arctan", "atan"), sympy="atan"),
    _row("atan2", domain=(r"y^2 + x^2 \neq 0",),
         derivative=Lacks("it jumps where its first argument passes 0 and its second is negative"),
         angle=(r"\frac{y}{\sqrt{y^2 + x^2}}", r"\frac{x}{\sqrt{y^2 + x^2}}"),
         arguments=2, commands=(), latex=r"\operatorname{atan2}", typst='op("atan2")',
         numpy="np.arctan2({0}, {1})"),
    _row("sqrt", r"\frac{1}{2\sqrt{x}}", domain=(r"x \geq 0",), commands=(), words=(), text="√"),
    _row("abs", r"\frac{x}{|x|}", parity="even",
         commands=(), words=(), latex="|", text="|", sympy="Abs"),
    _row("sign", derivative=Lacks("it jumps at 0"), parity="odd", commands=(),
         words=("sgn", "sign"), latex=r"\operatorname{sgn}", text="sgn", typst='op("sgn")'),
    _row("exp", r"\exp x"),
    _row("log", r"\frac{1}{x}", domain=("x > 0",),
         commands=("ln",), words=("ln",), latex=r"\ln", text="ln", typst="ln"),
    _row("sinh", r"\cosh x", parity="odd", neighbours=("cosh",),
         definition=r"\frac{1}{2}(\exp(x) - \exp(-x))"),
    _row("cosh", r"\sinh x", parity="even", neighbours=("sinh",),
         definition=r"\frac{1}{2}(\exp(x) + \exp(-x))"),
    _row("tanh", r"\frac{1}{\cosh(x)^2}", parity="odd",
         definition=r"\frac{\exp(x) - \exp(-x)}{\exp(x) + \exp(-x)}"),
    _row("max", _RISES, _RESTS, definition=r"\frac{1}{2}(x + y + |x - y|)",
         arguments=2, neighbours=("min",), sympy="Max", numpy="np.maximum({0}, {1})"),
    _row("min", _RESTS, _RISES, definition=r"\frac{1}{2}(x + y - |x - y|)",
         arguments=2, neighbours=("max",), sympy="Min", numpy="np.minimum({0}, {1})"),
    _row("power", r"\frac{y}{x} \exp(y \ln(x))", r"\ln(x) \exp(y \ln(x))", domain=("x > 0",),
         arguments=2, commands=(), words=(), sympy="Pow", numpy="np.power({0}, {1})"),
)  # fmt: skip

FUNCTIONS: Mapping[str, Row] = MappingProxyType({row.name: row for row in _ROWS})
"""Every function, by its name in terms and trees."""
COMMANDS = MappingProxyType({name: row.name for row in _ROWS for name in row.commands})
"""The function that a command of LaTeX, without its backslash, reads as."""
WORDS = MappingProxyType({word: row.name for row in _ROWS for word in row.words})
r"""The function that a word in `\operatorname{…}` or `\mathrm{…}` reads as."""
INVERSES = MappingProxyType({row.name: row.inverse for row in _ROWS if row.inverse})
CIRCULAR = frozenset(row.name for row in _ROWS if row.circle)
"""Functions of the point of the circle at an angle."""
SHORTENED = CIRCULAR | frozenset(INVERSES.values())
"""Functions that a paper may shorten to a letter, c for cos."""
