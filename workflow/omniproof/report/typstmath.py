r"""LaTeX of the ledger as Typst math, for what is typeset without a TeX installation.

Typst is a programming language, and the LaTeX comes from outside: so nothing is passed through.
A formula is read into pieces that only this module's tables can make; letters and digits stand
for themselves, every other character becomes a string literal, and a command that no table knows
makes the whole formula appear as code (`raw`): ugly, but visible, and never run.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from difflib import SequenceMatcher
from itertools import zip_longest
from typing import TypeAlias

from omniproof.report.latexfmt import GREEK, PIECE, TAG, is_latex, plain
from omniproof.transcription.model import ID

_TOKEN = re.compile(r"\\(?:begin|end)\s*\{\w+\*?\}|\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\s+|.", re.DOTALL)
_TEXT = re.compile(r"\\(?:text|textbf|mathrm|operatorname)\s*\{([^{}\\$]*)\}")
_MATRIX = re.compile(r"\\begin\{[bpv]?matrix\}(.*?)\\end\{[bpv]?matrix\}", re.DOTALL)
_NEW_ROW = "\\\\"
MAX_DEPTH = 64

_VARIANTS = {"phi": "phi.alt", "varphi": "phi", "epsilon": "epsilon.alt", "varepsilon": "epsilon"}
SYMBOLS = {
    **{name: name for name in GREEK},
    **_VARIANTS,
    **{name: name for name in ("cos", "sin", "tan", "cot", "det", "ln", "exp", "lim")},
    **{name: name for name in ("max", "min", "sum", "in", "times", "perp", "prime", "angle")},
    "nabla": "nabla", "emptyset": "emptyset", "int": "integral", "propto": "prop",
    "leq": "lt.eq", "le": "lt.eq", "geq": "gt.eq", "ge": "gt.eq", "mp": "minus.plus",
    "neq": "eq.not", "ne": "eq.not", "pm": "plus.minus", "cdot": "dot.op", "to": "arrow.r",
    "rightarrow": "arrow.r", "Leftrightarrow": "arrow.l.r.double", "ldots": "dots", "dots": "dots",
    "cdots": "dots.c", "cup": "union", "cap": "inter", "mid": 'class("relation", bar.v)',
    "circ": "compose", "langle": "chevron.l", "rangle": "chevron.r", "degree": "degree",
    "|": 'class("normal", bar.v.double)', "{": r"\{", "}": r"\}", "%": "percent", "_": '"_"',
    " ": "space.nobreak",
    ",": "thin", ";": "thick", ":": "med", "!": "", "quad": "quad", "qquad": "wide",
    "\\": "quad", "limits": "", "nolimits": "", "displaystyle": "", "big": "", "Big": "",
}  # fmt: skip
"""What a command without arguments becomes; an empty text leaves it out."""

FUNCTIONS = {
    "frac": "frac", "dfrac": "frac", "tfrac": "frac", "dot": "dot", "ddot": "dot.double",
    "hat": "hat", "bar": "macron", "overline": "overline", "tilde": "tilde", "widetilde": "tilde",
    "vec": "arrow", "boldsymbol": "bold", "mathcal": "cal", "mathbb": "bb", "mathit": "italic",
    "mathbf": "bold(upright", "mathrm": "upright", "mathsf": "sans", "operatorname": "upright",
    "sqrt": "sqrt", "binom": "binom", "boxed": "boxed", "changed": "changed",
}  # fmt: skip
"""What a command with arguments becomes; two of them have two, everything else one."""

_OF_TWO = frozenset({"frac", "binom"})
_CLASSES = {"mathbin": "binary", "mathrel": "relation", "mathop": "large"}
"""Commands that say what space there is around their argument."""

_SIGNS = {
    "+": "+", "-": "-", "=": "=", "<": "<", ">": ">", "(": r"\(", ")": r"\)", "[": r"\[",
    "]": r"\]", ",": r"\,", ";": r"\;", "|": 'class("normal", bar.v)', "/": r"\/",
    "*": "ast.op", "°": "degree",
    "&": "", "~": "space.nobreak", "∈": "in", "≤": "lt.eq", "≥": "gt.eq", "−": "-", "×": "times",
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


def words(text: str) -> str:
    """Return a Typst string literal: nothing in it is markup or code."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{" ".join(escaped.split())}"'


def math(latex: str) -> str:
    """Return Typst markup of a formula; of one that cannot be set, its LaTeX as code."""
    try:
        return _equation(source(read(latex)), latex)
    except UnsettableError:
        return _code(latex)


def is_formula(text: str) -> bool:
    """Whether a ledger cell is one formula that can be set."""
    try:
        return is_latex(text) and not ID.fullmatch(text) and bool(read(text))
    except UnsettableError:
        return False


def contrasted(printed: str, corrected: str) -> tuple[str, str]:
    """Return Typst markup of two formulas, with what differs in `old(…)` and in `new(…)`.

    Formulas that share nothing, or cannot be set, are not marked.
    """
    try:
        one, two = read(printed), read(corrected)
    except UnsettableError:
        return math(printed), math(corrected)
    if not set(one) & set(two):
        return math(printed), math(corrected)
    marked = _marked(one, two, "old"), _marked(two, one, "new")
    return _equation(marked[0], printed), _equation(marked[1], corrected)


def _equation(text: str, latex: str) -> str:
    """Return an equation with its text for those who hear it (PDF/UA asks for one)."""
    return f"#math.equation(alt: {words(spoken(latex))}, ${text}$);"


def spoken(latex: str) -> str:
    r"""Return a formula as text for a screen reader: `\sin\alpha_1` gives `sin α₁`.

    A matrix is read by rows: `(a, b; c, d)`.
    """
    rows = _MATRIX.sub(lambda m: f"({m[1].replace('&', ',').replace(_NEW_ROW, ';')})", latex)
    apart = re.sub(r"(\\(?:sin|cos|tan))(?=\\)", r"\1 ", rows)
    return plain(apart.replace(r"\{", "(").replace(r"\}", ")"))


def inline(text: str, refer: Callable[[str], str]) -> str:
    """Return Typst markup of words with `$math$`, `code` and claim ids (markup by `refer`)."""
    parts: list[str] = []
    end = 0
    for piece in PIECE.finditer(text):
        latex, code, claim = piece.groups()
        parts += [_spaced(text[end : piece.start()])]
        parts += [math(latex) if latex else _code(code) if code else refer(claim)]
        end = piece.end()
    return "".join([*parts, _spaced(text[end:])])


def cell(text: str, refer: Callable[[str], str]) -> str:
    """Return Typst markup of a ledger cell: a formula, a decimal, or words (see `inline`)."""
    if ID.fullmatch(text) or not (is_latex(text) or ("\\" in text and "$" not in text)):
        return inline(text, refer)
    return math(text)


def _spaced(text: str) -> str:
    """Return words as string literals, with blank space at the ends kept as markup."""
    if not text.strip():
        return " " if text else ""
    left, right = (" " if text[k].isspace() else "" for k in (0, -1))
    return f"{left}#{words(text)};{right}"


def _code(text: str) -> str:
    return f"#raw({words(text)});"


def _woven(glue: tuple[str, ...], parts: list[str]) -> str:
    return "".join(a + b for a, b in zip_longest(glue, parts, fillvalue=""))


def _marked(row: Row, other: Row, mark: str) -> str:
    """Return Typst source of a row with what `other` lacks inside `mark(…)`, as deep as it goes."""
    done: list[str] = []
    matcher = SequenceMatcher(a=row, b=other, autojunk=False)
    for what, a, b, c, d in matcher.get_opcodes():
        if what == "equal":
            done += map(str, row[a:b])
        elif _alike(row[a:b], other[c:d]):
            done += [_inside(x, y, mark) for x, y in zip(row[a:b], other[c:d], strict=True)]
        elif b > a:
            done.append(_wrapped(row[a:b], mark))
    return " ".join(done) or '""'


def _alike(row: Row, other: Row) -> bool:
    """Whether marks can go inside of these pieces: marks would grow in what is set small."""
    small = any(piece.glue[0] in {"attach(", "frac("} for piece in row)
    return not small and [piece.glue for piece in row] == [piece.glue for piece in other]


def _wrapped(row: Row, mark: str) -> str:
    """Put a mark around pieces; a lone sign keeps the space that it has between its sides."""
    text = f"{mark}({source(row)})"
    kind = {"+": "binary", "-": "binary", "=": "relation"}.get(source(row), "")
    return f'class("{kind}", {text})' if kind else text


def _inside(piece: Piece, other: Piece, mark: str) -> str:
    pairs = zip(piece.parts, other.parts, strict=True)
    return _woven(piece.glue, [_marked(one, two, mark) for one, two in pairs])


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
            return (Piece((_said(token[1:]),)),)
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


def _said(text: str) -> str:
    r"""Return the words of `\text{ … }` with the space at their ends; without any, an operator."""
    if text == text.strip():
        return f"op({words(text)})"
    left, right = (" " if text[k : k + 1 or None].isspace() else "" for k in (0, -1))
    return f'class("normal", "{left}{words(text)[1:-1]}{right}")'
