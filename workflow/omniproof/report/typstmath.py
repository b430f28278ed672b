r"""TeX as Typst math: the report's own prose has more of it than the formulas of a paper.

Typst is a programming language, and the LaTeX comes from outside: so nothing is passed through.
A formula is read into pieces that only this module's tables can make; letters and digits stand
for themselves, every other character becomes a string literal, and a command that no table knows
makes the whole formula appear as code (`raw`): ugly, but visible, and never run.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import zip_longest
from typing import TypeAlias

from omniproof.formula.writers.typst_text import AROUND, said, words
from omniproof.formula.writers.typst_text import SYMBOLS as LETTERS_AND_SIGNS
from omniproof.report.latexfmt import TAG
from omniproof.transcription.functions import COMMANDS
from omniproof.transcription.functions import FUNCTIONS as FUNCTIONS_OF_MATHEMATICS

_TOKEN = re.compile(r"\\(?:begin|end)\s*\{\w+\*?\}|\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\s+|.", re.DOTALL)
_TEXT = re.compile(r"\\(?:text|textbf|mathrm|operatorname)\s*\{([^{}\\$]*)\}")
MAX_DEPTH = 64

SYMBOLS = {
    **{sign[1:]: text for sign, text in LETTERS_AND_SIGNS.items() if sign[0] == "\\"},
    **{command: FUNCTIONS_OF_MATHEMATICS[name].typst for command, name in COMMANDS.items()},
    **{name: name for name in ("det", "lim", "sum", "emptyset", "degree")},
    "int": "integral", "propto": "prop", "le": "lt.eq", "ge": "gt.eq", "ne": "eq.not",
    "pm": "plus.minus", "mp": "minus.plus", "to": "arrow.r", "rightarrow": "arrow.r",
    "ldots": "dots", "dots": "dots", "cdots": "dots.c", "cup": "union", "cap": "inter",
    "%": "percent", "_": '"_"', " ": "space.nobreak",
    ",": "thin", ";": "thick", ":": "med", "!": "", "quad": "quad", "qquad": "wide",
    "\\": "quad", "limits": "", "nolimits": "", "displaystyle": "", "big": "", "Big": "",
}  # fmt: skip
"""What a command without arguments becomes; an empty text leaves it out."""

FUNCTIONS = {
    **{command[1:]: call for command, call in AROUND.items()},
    "frac": "frac", "dfrac": "frac", "tfrac": "frac", "operatorname": "upright", "sqrt": "sqrt",
    "binom": "binom", "boxed": "boxed", "changed": "changed",
}  # fmt: skip
"""What a command with arguments becomes; two of them have two, everything else one."""

_OF_TWO = frozenset({"frac", "binom"})
_CLASSES = {"mathbin": "binary", "mathrel": "relation", "mathop": "large"}
"""Commands that say what space there is around their argument."""

_SIGNS = {
    **{sign: text for sign, text in LETTERS_AND_SIGNS.items() if sign[0] != "\\"},
    ";": r"\;", "°": "degree", "&": "", "~": "space.nobreak", "∈": "in", "≤": "lt.eq",
    "≥": "gt.eq", "−": "-", "×": "times",
}  # fmt: skip
_MATRICES = {"pmatrix": '"("', "bmatrix": '"["', "vmatrix": '"|"', "matrix": "#none"}


class UnsettableError(ValueError):
    """A formula with something in it that no table of this module knows."""


@dataclass(frozen=True)
class Piece:
    """A piece of Typst math: `glue` stands before, between and behind the `parts`.

    `len(glue) == len(parts) + 1`; a symbol has no parts.
    """

    glue: tuple[str, ...]
    parts: tuple[Row, ...] = ()

    def __str__(self) -> str:
        """Return Typst source."""
        return _woven(self.glue, [source(part) for part in self.parts])


Row: TypeAlias = tuple[Piece, ...]


def source(row: Row) -> str:
    """Return the Typst source of pieces side by side; of none, an empty string literal."""
    return " ".join(map(str, row)) or '""'


def _woven(glue: tuple[str, ...], parts: list[str]) -> str:
    return "".join(a + b for a, b in zip_longest(glue, parts, fillvalue=""))


def read(latex: str) -> Row:
    r"""Read LaTeX into pieces; the number of a display (`\tag`) is left out.

    Raises `UnsettableError` for a command that is not known, or brackets that do not close.
    """
    body = TAG.sub("", latex)
    reader = _Reader(_tokens(body))
    row = reader.row(frozenset())
    if reader.next:
        raise UnsettableError(f"{reader.next} closes nothing in {latex}")
    return row


def _tokens(latex: str) -> Iterator[str]:
    r"""Yield the tokens; the words of `\text{…}` are one token that starts with a quote."""
    end = 0
    for found in _TEXT.finditer(latex):
        yield from _TOKEN.findall(latex[end : found.start()])
        yield f'"{found[1]}'
        end = found.end()
    yield from _TOKEN.findall(latex[end:])


class _Reader:
    """A recursive reader over tokens; `next` is the next one, empty at the end."""

    def __init__(self, tokens: Iterator[str]) -> None:
        self._rest = iter([token for token in tokens if not token.isspace()])
        self.next = next(self._rest, "")
        self._depth = 0

    def row(self, stops: frozenset[str]) -> Row:
        """`row = { piece [ scripts ] }`, up to one of the tokens `stops` (not taken)."""
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise UnsettableError("nested too deep")
        pieces: list[Piece] = []
        while self.next and self.next not in stops and self.next != "}":
            if self.next in {"^", "_", "'"}:
                pieces += self._scripts(pieces.pop() if pieces else Piece(('""',)))
            else:
                pieces += self._piece()
        self._depth -= 1
        return tuple(pieces)

    def _take(self) -> str:
        token, self.next = self.next, next(self._rest, "")
        return token

    def _expect(self, token: str) -> None:
        if self._take() != token:
            raise UnsettableError(f"expected {token}")

    def _argument(self) -> Row:
        """`argument = '{' row '}' | piece`."""
        if self.next[:1].isdigit():  # the first digit only, as TeX has it
            digit, self.next = self.next[0], self.next[1:] or next(self._rest, "")
            return (Piece((digit,)),)
        if self.next != "{":
            return self._piece()
        self._take()
        row = self.row(frozenset())
        self._expect("}")
        return row

    def _piece(self) -> Row:
        """`piece = group | command | number | letter | sign`; some leave nothing."""
        if self.next == "{":
            return self._argument()
        token = self._take()
        if not token:
            raise UnsettableError("the formula ends where an argument is needed")
        if token[0] == '"':
            return (Piece((said(token[1:]),)),)
        if token[0] == "\\":
            return self._command(token[1:])
        if token[0].isalnum() and token.isascii():
            return (Piece((token,)),)
        text = _SIGNS.get(token, words(token))
        return (Piece((text,)),) if text else ()

    def _command(self, name: str) -> Row:
        if name == "left":
            return self._fenced()
        if name.startswith("begin"):
            return self._environment(name[5:].strip(" {}"))
        if name in FUNCTIONS:
            return self._function(name)
        if name in _CLASSES:
            return (Piece((f'class("{_CLASSES[name]}", ', ")"), (self._argument(),)),)
        if name not in SYMBOLS:
            raise UnsettableError(f"unknown: \\{name}")
        return (Piece((SYMBOLS[name],)),) if SYMBOLS[name] else ()

    def _function(self, name: str) -> Row:
        call = FUNCTIONS[name]
        close = ")" * (call.count("(") + 1)
        if call in _OF_TWO:
            return (Piece((f"{call}(", ", ", ")"), (self._argument(), self._argument())),)
        if call == "sqrt" and self.next == "[":
            raise UnsettableError("a root with an index")
        return (Piece((f"{call}(", close), (self._argument(),)),)

    def _fenced(self) -> Row:
        r"""`fenced = '\left' sign row '\right' sign`; a dot is no sign."""
        left = self._fence()
        inside = self.row(frozenset({r"\right"}))
        self._expect(r"\right")
        return (Piece((f"lr({left} ", f" {self._fence()})"), (inside,)),)

    def _fence(self) -> str:
        if self.next == ".":
            self._take()
            return ""
        return source(self._piece())

    def _scripts(self, base: Piece) -> Row:
        r"""`scripts = { ('_' | '^') argument | "'" }`; `^\circ` is the sign for degrees."""
        scripts: dict[str, Row] = {}
        while self.next in {"^", "_", "'"}:
            sign = self._take()
            place = "b" if sign == "_" else "t"
            added = (Piece(("prime",)),) if sign == "'" else self._argument()
            scripts[place] = scripts.get(place, ()) + added
        if scripts == {"t": (Piece((SYMBOLS["circ"],)),)}:
            return (base, Piece(("degree",)))
        glue = ("attach(", *(f", {place}: " for place in sorted(scripts)), ")")
        return (Piece(glue, ((base,), *(scripts[place] for place in sorted(scripts)))),)

    def _environment(self, name: str) -> Row:
        rows = self._cells(f"\\end{{{name}}}")
        if name in _MATRICES:
            glue, parts = _grid(rows, ", ", "; ")
            return (Piece((f"mat(delim: {_MATRICES[name]}, ", *glue, ")"), parts),)
        if name == "cases":
            glue, parts = _grid(rows, " & ", ", ")
            return (Piece(("cases(", *glue, ")"), parts),)
        if name in {"aligned", "gathered", "split"}:
            glue, parts = _grid(rows, ", ", "; ")
            return (Piece(("aligned(", *glue, ";)"), parts),)  # `;`: one row is a row, too
        raise UnsettableError(f"unknown environment {name}")

    def _cells(self, end: str) -> list[list[Row]]:
        rows: list[list[Row]] = [[]]
        while True:
            rows[-1].append(self.row(frozenset({"&", r"\\", end})))
            sign = self._take()
            if sign == end:
                return rows
            if sign == r"\\":
                rows.append([])
            elif sign != "&":
                raise UnsettableError(f"expected {end}")


def _grid(rows: list[list[Row]], aside: str, below: str) -> tuple[tuple[str, ...], tuple[Row, ...]]:
    """Return glue (inner only) and parts of cells in rows."""
    glue: list[str] = []
    for row in rows:
        glue += [aside] * (len(row) - 1) + [below]
    return tuple(glue[:-1]), tuple(cell for row in rows for cell in row)
