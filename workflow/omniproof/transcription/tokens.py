r"""LaTeX as tokens: one table of rules, places kept, everything unknown refused at once.

Limits come first: a formula of a million characters, or one nested a thousand deep, is answered
before any work is done on it. What only spaces or frames a formula (`\,`, `\left`, `aligned`, the
number of a display) is read over here, so that no grammar rule needs to know of it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from typing import NamedTuple

from omniproof.transcription.functions import COMMANDS
from omniproof.transcription.tree import Span
from omniproof.visible import hidden

MAX_LENGTH = 10_000
MAX_DEPTH = 32
EXCERPT = 70


@dataclass(frozen=True)
class Cure:
    """What to write instead: in the file of a paper, and where a formula stands alone."""

    in_paper: str
    alone: str


class LatexError(Exception):
    """A formula that cannot be read (or not in one way only), with the place and a cure."""

    def __init__(self, message: str, source: str, span: Span, cure: str | Cure = "") -> None:
        self.message, self.source, self.span = message, source, span
        told = cure if isinstance(cure, Cure) else Cure(cure, cure)
        self.cure, self.cure_alone = told.in_paper, told.alone
        super().__init__(message, source, span, cure)

    def __str__(self) -> str:
        """Show the message, the source around the fault with a marker below, and the cure."""
        return self._told(self.cure)

    @property
    def alone(self) -> str:
        """The same of a formula that stands alone."""
        return self._told(self.cure_alone)

    def _told(self, cure: str) -> str:
        return f"{self.picture}\n    {cure}" if cure else self.picture

    @property
    def picture(self) -> str:
        """The message, and the source around the fault with a marker below."""
        excerpt, start = _excerpt(self.source, self.span)
        end = min(max(self.span[1], self.span[0] + 1), start + len(excerpt) + 1)
        left = self.span[0] - start
        marker = " " * left + "~" * (end - self.span[0] - 1) + "^"
        return f"{self.message}\n    {excerpt}\n    {marker}"


def _excerpt(source: str, span: Span) -> tuple[str, int]:
    """At most `EXCERPT` characters around a span, on one line, with their offset."""
    start = 0
    if len(source) > EXCERPT:
        middle = (span[0] + min(span[1], span[0] + EXCERPT)) // 2
        start = max(0, min(middle - EXCERPT // 2, len(source) - EXCERPT))
    shown = source[start : start + EXCERPT]
    return "".join(" " if sign.isspace() or hidden(sign) else sign for sign in shown), start


class Token(NamedTuple):
    """One token: its kind, its text after synonyms, its place."""

    kind: str
    text: str
    span: Span


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


GREEK = _words(
    "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi "
    "pi rho varrho sigma tau upsilon phi varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma "
    "Upsilon Phi Psi Omega ell nabla"
)
ACCENTS = _words("hat bar tilde widetilde widehat dot ddot overline vec overrightarrow underline")
FONTS = _words("mathbf boldsymbol bm mathrm mathbb mathcal mathit mathsf mathfrak")
OTHERS = _words("frac binom sqrt int det operatorname circ prime top")
SIGNS = _words("times cdot leq geq neq langle rangle mid Leftrightarrow land lor")

KINDS = {
    **dict.fromkeys(GREEK, "symbol"),
    **dict.fromkeys(ACCENTS, "accent"),
    **dict.fromkeys(FONTS, "font"),
    **dict.fromkeys(COMMANDS, "function"),
    **dict.fromkeys(OTHERS, "command"),
    **dict.fromkeys(SIGNS, "sign"),
    "angle": "angle",
}
"""Commands that are read, without their backslash."""

SYNONYMS = {
    "\\le": "\\leq", "\\ge": "\\geq", "\\ne": "\\neq", "\\leqslant": "\\leq",
    "\\geqslant": "\\geq", "\\iff": "\\Leftrightarrow", "\\vert": "|", "\\Vert": "\\|",
    "\\lbrace": "\\{", "\\rbrace": "\\}", "\\dfrac": "\\frac", "\\tfrac": "\\frac",
    "\\wedge": "\\land",
    "\\vee": "\\lor", "\\lt": "<", "\\gt": ">",
    "−": "-", "·": "\\cdot", "×": "\\times", "≤": "\\leq", "≥": "\\geq", "≠": "\\neq",
    "°": "\\circ", "ϕ": "\\phi", "φ": "\\varphi",
    "α": "\\alpha", "β": "\\beta", "γ": "\\gamma", "δ": "\\delta", "ε": "\\epsilon",
    "ζ": "\\zeta", "η": "\\eta", "θ": "\\theta", "λ": "\\lambda", "μ": "\\mu", "ν": "\\nu",
    "ξ": "\\xi", "π": "\\pi", "ρ": "\\rho", "σ": "\\sigma", "τ": "\\tau", "χ": "\\chi",
    "ψ": "\\psi", "ω": "\\omega", "Δ": "\\Delta", "Σ": "\\Sigma", "Ω": "\\Omega",
}  # fmt: skip
"""Other spellings of one sign."""

FRAMES = _words("aligned align gathered split equation")
"""Environments that only arrange lines."""
TABLES = _words("matrix pmatrix bmatrix smallmatrix array cases")
"""Environments of rows and columns."""

NO_DERIVATIVES = "derivatives are not read: write out what they are"
BOTH_SIGNS = Cure("write both signs as claims of their own", "write both signs alone")
NO_ARROW = Cure("leave the arrow out, or say it in `says`", "leave the arrow out")
UNREAD: dict[str, str | Cure] = {
    "partial": NO_DERIVATIVES,
    "differential": NO_DERIVATIVES,
    "log": "write `\\ln` for the natural logarithm; no other is read",
    "sum": "sums over an index are not read: write the terms out",
    "pm": BOTH_SIGNS,
    "mp": BOTH_SIGNS,
    "in": Cure("leave the membership out, or say it in `says`", "leave the membership out"),
    "rightarrow": NO_ARROW,
    "to": NO_ARROW,
}
"""Commands that papers use and that are refused, with what to do."""

SPACING = _words(
    "left right big Big bigg Bigg bigl bigr Bigl Bigr quad qquad displaystyle textstyle limits "
    "nonumber notag enspace enskip thinspace medspace thickspace negthinspace"
)
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
_UNIT = r"(?:mm|cm|pt|pc|bp|dd|cc|sp|mu|em|ex|in)(?![A-Za-z])"
_NAMED = r"\\(?:baselineskip|jot|lineskip|parskip|smallskipamount|medskipamount|bigskipamount)"
LENGTH = rf"(?:{_NUMBER}\s*{_UNIT}|(?:{_NUMBER})?\s*{_NAMED})"
"""A length of TeX, such as `0.5em` or `-.2\\baselineskip`."""

RULES = (
    (
        "space",
        r"\s+|\\[,;:!>]|~|\\tag\s*\{[^{}]*\}|\\[hv]?phantom\s*\{[^{}]*\}"
        rf"|\\[hv]space\*?\s*\{{\s*{LENGTH}\s*\}}|\\(?:hskip|mskip|m?kern)\s*{LENGTH}",
    ),
    ("number", r"\d+(?:\.\d+)?"),
    ("text", r"\\(?:text|mbox|textrm)\s*\{[^{}]*\}"),
    ("begin", r"\\begin\s*\{[^{}]{0,20}\}(?:\s*\{[lcr|]+\})?"),
    ("end", r"\\end\s*\{[^{}]{0,20}\}"),
    ("open", r"\\left\s*\\?\||\\l[vV]ert(?![A-Za-z])"),
    ("close", r"\\right\s*\\?\||\\r[vV]ert(?![A-Za-z])"),
    ("word", r"\\[A-Za-z]+"),
    ("blank", r"\\ "),
    ("row", rf"\\\\\*?(?:\s*\[\s*{LENGTH}\s*\])?"),
    ("sign", r"\\[{}|]|[-+*/=<>^_&(){}\[\],.;:|'−·×≤≥≠°]"),
    ("symbol", r"[A-Za-zα-ωϕΔΣΩ]"),
    ("unknown", r"."),
)
"""The token rules, first match first."""

_SCANNER = re.compile("|".join(f"(?P<{kind}>{rule})" for kind, rule in RULES), re.DOTALL | re.ASCII)
_LABEL = re.compile(
    r"\\q?quad\s*\(\s*(?:[A-Z]|\\text\s*\{[A-Z]\})?[\s,.]{0,2}\d+(?:-\d+)?\s*\)\s*[.,]?\s*$"
)
"""The number of a display: `\\quad (6)`, `\\quad (\\text{B},3)`."""

OPENING = {"(": ")", "[": "]", "{": "}", "\\{": "\\}", "\\langle": "\\rangle"}
CLOSING = frozenset(OPENING.values())


def tokenize(source: str) -> tuple[Token, ...]:
    """Cut a formula into tokens, without spaces, frames and the number of the display.

    Raises `LatexError` for what is too long, nested too deep, or no part of a formula that is read.
    """
    if len(source) > MAX_LENGTH:
        message = f"expected at most {MAX_LENGTH} characters, found {len(source)}"
        cure = Cure("split the formula into several claims", "split the formula")
        raise LatexError(message, source, (0, EXCERPT), cure)
    return tuple(_layout(list(_scan(source)), source))


def _scan(source: str) -> Iterator[Token]:
    label = _LABEL.search(source, max(0, len(source) - 60))
    for match in _SCANNER.finditer(source, 0, label.start() if label else len(source)):
        token = Token(*_settled(match.lastgroup or "", match.group()), match.span())
        if token.kind in {"unknown", "word"} or (
            token.kind == "begin" and token.text not in TABLES
        ):
            raise _unknown(token, source)
        if token.kind != "space":
            yield token


# A repair reads a formula thousands of times: the same few hundred words.
@lru_cache(maxsize=4_096)
def _settled(kind: str, text: str) -> tuple[str, str]:
    """Settle kind and text: synonyms and bars in one spelling, environments by their name."""
    if kind in {"word", "sign", "symbol"}:
        return _classify(SYNONYMS.get(text, text))
    if kind in {"open", "close"}:
        return kind, "\\|" if "\\|" in text or "V" in text else "|"
    if kind in {"begin", "end"}:
        name = text[text.index("{") + 1 : text.index("}")].strip().rstrip("*")
        return "space" if name in FRAMES else kind, name
    return kind, text


def _classify(text: str) -> tuple[str, str]:
    if not text.startswith("\\") or not text[1:].isalpha():
        return ("symbol" if text.isalpha() else "sign"), text
    name = text[1:]
    return ("space" if name in SPACING else KINDS.get(name, "word")), text


def _unknown(token: Token, source: str) -> LatexError:
    text = token.text
    cure: str | Cure
    if token.kind == "begin":
        message = f"the environment `{text}` is not read"
        cure = f"write one of {', '.join(sorted(TABLES))}"
    elif token.kind == "unknown":
        message, cure = f"{text!r} is no part of a formula", "write it in LaTeX"
    else:
        message = f"`{text}` is not read"
        near = get_close_matches(text[1:], [*KINDS, *SPACING], n=1, cutoff=0.8)
        cure = f"did you mean `\\{near[0]}`?" if near else "leave it out of the formula"
        cure = UNREAD.get(text[1:], cure)
    return LatexError(message, source, token.span, cure)


def _layout(tokens: list[Token], source: str) -> Iterator[Token]:
    r"""Settle the signs of layout: `&`, `\\` and `\ ` keep their meaning where they separate.

    `&` and `\\` separate in tables; between statements only `\\` does, unless the next line goes on
    with `& +`. `\ ` separates the entries of a row in square brackets.
    """
    opened: list[Token] = []
    for place, token in enumerate(tokens):
        kept = _separator(token, opened[-1] if opened else None, tokens[place + 1 : place + 3])
        if token.text in OPENING or token.kind == "begin":
            opened.append(token)
            if len(opened) > MAX_DEPTH:
                message = f"expected at most {MAX_DEPTH} brackets inside one another"
                raise LatexError(message, source, token.span, "split the formula")
        elif opened and (token.text in CLOSING or token.kind == "end"):
            opened.pop()
        if kept is not None:
            yield kept


def _separator(token: Token, inside: Token | None, following: list[Token]) -> Token | None:
    """Give a token as it counts in its bracket; `None` where it is only layout."""
    in_table = inside is not None and inside.kind == "begin"
    if token.kind == "blank":
        in_row = inside is not None and inside.text == "["
        return Token("sign", ",", token.span) if in_row else None
    if token.kind == "row":
        return token if in_table or (inside is None and not _goes_on(following)) else None
    return None if token.text == "&" and not in_table else token


def _goes_on(following: list[Token]) -> bool:
    """Whether a line starts with `+`, or with `&` and a sign: no statement does."""
    texts = [token.text for token in following]
    return texts[:1] == ["+"] or texts in (["&", "+"], ["&", "-"])
