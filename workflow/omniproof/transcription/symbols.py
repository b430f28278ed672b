# ruff: noqa: D403 - the docstring of a rule is the rule
r"""The cursor over the tokens, and the one rule for symbols.

Papers change fonts from line to line (`\mathbf{A}`, `A`), never to tell two symbols apart, so fonts
are dropped; accents, primes and scripts belong to the name. Whether `v_k^T` is a symbol or a
transposition, only the paper's list of symbols can say.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from typing import NoReturn

from omniproof.transcription.tokens import OPENING, Cure, LatexError, Token, tokenize
from omniproof.transcription.tree import Span

END = Token("end of formula", "", (0, 0))
_WORD = re.compile("[A-Za-z]{2,}")
_WHOLE = re.compile("[-+]?[0-9]+")
NO_SIGNS = frozenset({"text", "begin", "end"})
TRANSPOSE = frozenset({"T", "t", "\\top"})
DIFFERENCES = frozenset({"\\Delta", "\\delta", "\\mathrm{d}"})
"""What makes one symbol of itself and the next one, unless it is declared."""


class Cursor:
    """A place in the tokens of one formula."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.tokens = tokenize(source)
        self.place = 0

    def peek(self, ahead: int = 0) -> Token:
        """The token ahead, `END` behind the last one."""
        place = self.place + ahead
        return self.tokens[place] if place < len(self.tokens) else END

    def at(self, *texts: str) -> bool:
        """Whether the next token is one of these signs or commands."""
        # Asked a thousand times a formula: `peek` would be as much work again.
        if self.place >= len(self.tokens):
            return False
        token = self.tokens[self.place]
        return token.text in texts and token.kind not in NO_SIGNS

    def take(self) -> Token:
        """Step over the next token and return it."""
        token = self.peek()
        self.place += 1
        return token

    def consume(self, *texts: str) -> bool:
        """Step over the next token if it is one of these."""
        found = self.at(*texts)
        self.place += found
        return found

    @property
    def start(self) -> int:
        """Offset of the next token."""
        if self.place < len(self.tokens):
            return self.tokens[self.place].span[0]
        return len(self.source.rstrip())

    def since(self, start: int) -> Span:
        """The span from an offset to the end of the token just taken."""
        return start, max(start, self.tokens[self.place - 1].span[1] if self.place else 0)

    def found(self) -> str:
        """The next token in words."""
        token = self.peek()
        if token is END:
            return "the end of the formula"
        start, end = token.span
        return f"`{self.source[start:end]}`"

    def expected(self, what: str, cure: str = "") -> NoReturn:
        """Refuse the next token."""
        span = (self.start, self.start + 1) if self.peek() is END else self.peek().span
        raise LatexError(f"expected {what}, found {self.found()}", self.source, span, cure)

    def refuse(self, message: str, start: int, cure: str | Cure) -> NoReturn:
        """Refuse everything from an offset to the token just taken."""
        raise LatexError(message, self.source, self.since(start), cure)

    def close(self, opened: Token, closing: str) -> None:
        """Step over the bracket that ends an enclosed part."""
        if not self.consume(closing):
            end = self.start + 1 if self.peek() is END else self.peek().span[1]
            message = f"expected `{closing}` to close `{opened.text}`, found {self.found()}"
            raise LatexError(message, self.source, (opened.span[0], end), "balance the brackets")

    @contextmanager
    def enclosed(self) -> Iterator[str]:
        """Read what stands between a bracket and its partner; gives the opening bracket."""
        opened = self.take()
        yield opened.text
        self.close(opened, OPENING.get(opened.text, opened.text))


class SymbolReader(Cursor):
    """Reads symbols; `declared` are the canonical names of the paper."""

    def __init__(self, source: str, declared: Collection[str] | None = ()) -> None:
        super().__init__(source)
        self.declared = declared
        self.integrals = 0  # how many are open here
        words = {match[0] for name in declared or () if (match := _WORD.match(name))}
        self.words = sorted(words, key=len, reverse=True)

    def knows(self, name: str) -> bool:
        """Whether a name is declared; without a list of symbols (`None`) every name is."""
        return self.declared is None or name in self.declared

    def at_symbol(self) -> bool:
        """Whether a symbol starts here; the `d` that ends an integral is none."""
        return (
            self.peek().kind in {"symbol", "accent", "font", "angle"} and not self.at_differential()
        )

    def at_differential(self) -> bool:
        """Whether the end of an integral starts here: `d` and the variable."""
        return self.integrals > 0 and self.at("d") and self.peek(1).kind in {"symbol", "accent"}

    def symbol(self, word: bool = False) -> str:
        r"""symbol = [difference] base {"'"} ["_" script] ["^" script].

        `word`: letters may run together. difference = "\Delta" | "\delta" | "\mathrm{d}", unless it
        is declared: the change of a quantity is one symbol, and no product.
        """
        if sign := self.difference():
            return f"{sign} {self.symbol(word)}"
        name = self.base(word) + self.primes()
        if self.consume("_"):
            subscript = "_" + self.script()
            name += self.primes() + subscript
            if self.at("_"):
                self.expected("one subscript", "write both in one pair of braces")
        return name + self.superscript(name)

    def base(self, word: bool = False) -> str:
        r"""base = letter | greek | declared word | (font | accent) "{" symbol "}" | angle.

        angle = "\angle" symbol symbol symbol, one symbol by its three points.
        """
        token = self.take()
        if token.kind == "angle":
            return f"{token.text} {''.join(self.symbol() for _ in range(3))}"
        if token.kind == "font":
            return self.content(token, word)
        if token.kind == "accent":
            return f"{token.text}{{{self.content(token, word=True)}}}"
        if token.kind != "symbol":
            self.place -= 1
            self.expected("a symbol")
        for known in self.words:
            if self.source.startswith(known, token.span[0]):
                while self.peek().kind == "symbol" and self.start < token.span[0] + len(known):
                    self.place += 1
                return known
        return token.text

    def difference(self) -> str:
        """Step over the sign of a difference or differential before a symbol."""
        texts = [self.peek(step).text for step in range(4)]
        sign, size = texts[0], 1
        if sign == "\\mathrm":
            size = {"d": 2, "{": 4}.get(texts[1], 0)
            sign = "\\mathrm{d}" if "".join(texts[1:size]) in {"d", "{d}"} else ""
        declared = sign in (self.declared or ())
        if declared or sign not in DIFFERENCES:
            return ""
        if self.peek(size).kind not in {"symbol", "accent", "font"}:
            return ""
        self.place += size
        return sign

    def content(self, outer: Token, word: bool) -> str:
        """content = "{" (symbol | word) "}" | base; a word in a font has to be declared."""
        if not self.at("{"):
            return self.base(word)
        with self.enclosed():
            letters = ""
            while len(self.peek().text) == 1 and self.peek().kind == "symbol":
                letters += self.take().text
            if len(letters) > 1 and self.at("}"):
                if not word and self.declared is not None and letters not in self.words:
                    message = f"`{letters}` may be one symbol or a product"
                    split = f"give each letter its own `{outer.text}`"
                    cure = Cure(f"declare `{letters}`, or {split}", split)
                    self.refuse(message, outer.span[0], cure)
                return letters
            self.place -= len(letters)
            return self.symbol(word)

    def primes(self) -> str:
        r"""primes = {"'" | "^" "\prime" | "^" "{" "\prime" "}"}."""
        found = ""
        while True:
            ahead = [self.peek(step).text for step in range(4)]
            if ahead[0] == "'":
                self.place += 1
            elif ahead[:2] == ["^", "\\prime"]:
                self.place += 2
            elif ahead == ["^", "{", "\\prime", "}"]:
                self.place += 4
            else:
                return found
            found += "'"

    def script(self) -> str:
        """script = character | command | "{" what is printed there, fonts dropped "}"."""
        if not self.at("{"):
            token = self.peek()
            if token.kind == "number" and len(token.text) > 1:
                self.expected("one digit", f"write {{{token.text}}} with braces")
            if token.kind in {"font", "accent"}:
                return _braced([self.base()])
            if token.kind not in {"symbol", "number"} and not self.at("*", "+", "-"):
                self.expected("a subscript or superscript")
            return self.take().text
        with self.enclosed():
            parts = self.printed()
        if not parts:
            self.refuse("an empty script", self.tokens[self.place - 2].span[0], "leave it out")
        return _braced(parts)

    def printed(self) -> list[str]:
        """The canonical pieces up to the closing brace."""
        parts: list[str] = []
        while not self.at("}"):
            token = self.peek()
            if token.kind == "text":
                parts.append(_inner_text(self.take().text))
            elif token.kind in {"font", "accent"}:
                parts.append(self.base())
            elif self.at("_", "^"):
                self.place += 1
                parts.append(token.text + self.script())
            elif token.kind in {"symbol", "number"} or self.at("+", "-", ",", "(", ")", "'", "*"):
                parts.append(self.take().text)
            else:
                self.expected("`}` to close the script")
        return parts

    def superscript(self, name: str) -> str:
        """A superscript of the name; whole powers, degrees and transposition are none."""
        if not self.at("^") or self.peek(1).text == "\\circ":
            return ""
        place, start = self.place, self.start
        inner = self.peek(2) if self.peek(1).text == "{" else self.peek(1)
        if inner.text in {"\\circ", "\\top"}:
            return ""
        self.place += 1
        script = self.script()
        whole = _WHOLE.fullmatch(script.strip("{}"))
        if not whole and self.knows(f"{name}^{script}"):
            return f"^{script}"
        if not whole and script not in TRANSPOSE:
            power = "write a whole number as the power"
            cure = Cure(f"declare the symbol `{name}^{script}`, or {power}", power)
            message = f"`^{script}` is neither a whole power nor part of a declared symbol"
            self.refuse(message, start, cure)
        self.place = place
        return ""


def _braced(parts: list[str]) -> str:
    """Join the pieces of a script; braces only where TeX needs them."""
    text = ""
    for part in parts:
        text += " " * (_ends_in_command(text) and part[:1].isalpha()) + part
    single = len(text) == 1 or (text.startswith("\\") and text[1:].isalpha())
    return text if single else f"{{{text}}}"


def _ends_in_command(text: str) -> bool:
    return text[text.rfind("\\") + 1 :].isalpha() if "\\" in text else False


def _inner_text(text: str) -> str:
    return text[text.index("{") + 1 : -1].strip()


def symbol_name(latex: str) -> str:
    r"""The canonical name of one printed symbol: `\mathbf{a}_{1}` gives `a_1`.

    Raises `LatexError` when the text is not one symbol.
    """
    reader = SymbolReader(latex, declared=None)
    word = latex.strip()
    if len(word) > 1 and word.isascii() and word.isalpha():
        return word
    prefix = "\\det " if reader.consume("\\det") else ""
    name = prefix + reader.symbol()
    if reader.peek() is not END:
        reader.expected("one symbol")
    return name
