# ruff: noqa: D403 - the docstring of a rule is the rule
r"""The smallest parts of a formula: numbers, symbols, functions, fractions, roots.

What mathematicians print without brackets is read as they read it (`\sin 2\theta \cos \theta` is a
product of two); what they would ask about (`\sin 2(a - b)`, `f(x)` of an unknown f) is refused.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import replace

from omniproof.transcription.conventions import Names, Writing
from omniproof.transcription.enclosed import EnclosedReader
from omniproof.transcription.functions import CIRCULAR, COMMANDS, FUNCTIONS, INVERSES, WORDS
from omniproof.transcription.tokens import MAX_DEPTH, Cure, LatexError, Token
from omniproof.transcription.tree import (
    Applied,
    Call,
    Degrees,
    Determinant,
    Integral,
    MatrixLiteral,
    Name,
    Negative,
    Node,
    Number,
    Pi,
    Power,
    Product,
    Quotient,
    Tuple,
    children,
)

PLAIN = (Name, Number, Degrees, Pi, Applied)
PARTS = (Negative, Quotient, Power, Product)
SPELLED = {
    **{word: f"write `\\{word}` for the function" for word in COMMANDS},
    "sqrt": r"write `\sqrt{…}` for the root",
    "atan2": r"write `\operatorname{atan2}(y, x)` for the function",
    **{word: rf"write `\operatorname{{{word}}}(x)` for the function" for word in ("sgn", "sign")},
    **{f"a{word}": rf"write `\arc{word}` for the function" for word in INVERSES},
    **dict.fromkeys(
        ("log", "mod", "det", "arg", "rank", "diag"),
        "as a function it is not read; as a product, put blanks between the letters",
    ),
}  # fmt: skip
"""Words that would be products of their letters, and what to write instead."""
_E_NOTATION = re.compile(r"(?<=[0-9.])[eE][-+]?[0-9]")


class AtomReader(EnclosedReader, ABC):
    """Reads atoms; the rules for sums and statements come from the reader above."""

    def __init__(self, source: str, names: Names, notation: Writing) -> None:
        super().__init__(source, None if names.shown else names.declared)
        self.quantities, self.functions = names.quantities, names.functions
        self.alone = names.alone
        self.shorthands = notation.functions
        self.called = 0  # where the last function starts
        self.depth = 0
        self.rules: dict[str, Callable[[int], Node]] = {
            "(": self.bracket, "[": self.bracket, "{": self.group, "\\{": self.braces,
            "|": self.between_bars, "\\|": self.between_bars, "\\langle": self.inner,
            "\\frac": self.fraction, "\\binom": self.binomial, "\\sqrt": self.root,
            "\\det": self.determinant, "\\operatorname": self.operator,
            "\\int": self.integral,
        }  # fmt: skip

    def at_atom(self) -> bool:
        """Whether an atom starts here; a bar does unless it closes one."""
        token = self.peek()
        if token.kind in {"number", "function", "begin"} or self.at_symbol():
            return True
        if token.text in {"|", "\\|"}:
            return token.kind == "open" or (token.kind == "sign" and token.text not in self.bars)
        return token.kind in {"sign", "command"} and token.text in self.rules

    def atom(self) -> Node:
        r"""atom = number | symbol | function | bracket | bars | matrix | "\frac" part part | …."""
        token, start = self.peek(), self.start
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise LatexError(f"expected at most {MAX_DEPTH} levels", self.source, token.span,
                             "split the formula")  # fmt: skip
        if token.kind == "number":
            node: Node = self.number()
        elif token.kind == "function":
            node = self.function(COMMANDS[self.take().text[1:]], start)
        elif token.kind == "begin":
            node = self.cases() if token.text == "cases" else self.matrix()
        elif self.at_symbol():
            node = self.named()
        elif token.kind in {"sign", "command", "open"} and token.text in self.rules:
            node = self.rules[token.text](start)
        else:
            self.expected("a number, a symbol or a bracket", _habit(token.text))
        self.depth -= 1
        return node

    def number(self) -> Number | Degrees:
        r"""number = digits ["." digits] ["^" "\circ"]."""
        token = self.take()
        circles = (["\\circ"], ["^", "\\circ"], ["^", "{", "\\circ", "}"])
        for circle in circles:
            if [self.peek(step).text for step in range(len(circle))] == circle:
                self.place += len(circle)
                if circle[0] == "^" and self.at("^"):  # LaTeX: "double superscript"
                    self.expected("one exponent", r"write brackets: `(30^\circ)^2`")
                return Degrees(token.text, span=self.since(token.span[0]))
        if self.peek().kind == "number":
            self.expected("a sign between two numbers", "write `\\cdot` between them")
        if _E_NOTATION.match(self.source, token.span[1]):
            self.expected("a number without `e`", r"write `\cdot 10^{…}` for a power of ten")
        if token.text.isdigit() and len(token.text.lstrip("0")) < len(token.text) > 1:
            cure = "write thousands without a comma"
            self.refuse("expected a number without zeros before it", token.span[0], cure)
        return Number(token.text, span=token.span)

    def named(self) -> Node:
        """named = shorthand atom | symbol ["(" plain {"," plain} ")"]."""
        token, start = self.peek(), self.start
        if token.text in self.shorthands and self.peek(1).kind in {"symbol", "accent", "font"}:
            self.place += 1
            begin = self.start
            argument = Name(self.symbol(), span=self.since(begin))
            if self.at("^"):
                self.expected("brackets around the argument", f"write `{token.text}(…)`")
            return Call(self.shorthands[token.text], _pi(argument), span=self.since(start))
        if token.text in self.shorthands and self.peek(1).text == "(":
            self.place += 1
            return Call(self.shorthands[token.text], self.expression(), span=self.since(start))
        self.refuse_spelled_function(start)
        if token.kind == "font" and (word := self.word()) in WORDS:
            return self.function(self.worded(word), start)
        name = self.symbol()
        span = self.since(start)
        if self.alone and self.peek().kind == "number" and self.since(start)[1] == self.start:
            cure = f"write `{name}_{self.peek().text}` for an index, or the number first"
            self.take()
            self.refuse("an index or a factor stands behind the symbol", start, cure)
        called = self.at("(") and name != "\\pi"
        return self.applied(name, start) if called else _pi(Name(name, span=span))

    def word(self) -> str:
        r"""The letters of `\mathrm{word}` ahead, empty when there is no such word."""
        letters, step = "", 2
        while len(self.peek(step).text) == 1 and self.peek(step).kind in {"symbol", "number"}:
            letters += self.peek(step).text
            step += 1
        return letters if self.peek(1).text == "{" and self.peek(step).text == "}" else ""

    def worded(self, word: str) -> str:
        r"""Step over `\mathrm{word}` and return the function; some write `\mathrm{atan}_2`."""
        self.place += len(word) + 3
        for index in (["_", "2"], ["_", "{", "2", "}"]):
            if f"{word}2" in WORDS and [self.peek(k).text for k in range(len(index))] == index:
                self.place += len(index)
                return WORDS[f"{word}2"]
        return WORDS[word]

    def refuse_spelled_function(self, start: int) -> None:
        """Refuse `sin x`, which would be the product s i n x."""
        for word in sorted(SPELLED, key=len, reverse=True):
            if self.source.startswith(word, start) and not self.knows(word):
                span = (start, start + len(word))
                raise LatexError(
                    f"`{word}` is a product of letters", self.source, span, SPELLED[word]
                )

    def applied(self, name: str, start: int) -> Node:
        """Tell the arguments of a quantity from a factor in brackets."""
        place, span = self.place, self.since(start)
        node = self.bracket(self.start)
        arguments = node.items if isinstance(node, Tuple) else (node,)
        plain = isinstance(node, Tuple) if self.alone else False
        plain = plain or all(_is_plain(argument) for argument in arguments)
        if name in self.functions or (plain and (name in self.quantities or self.alone)):
            return Applied(name, arguments, span=self.since(start))
        if isinstance(node, Name):
            product = "drop the brackets for a product"
            cure = Cure(f"declare `{name}` with `role: quantity`, or {product}", product)
            self.refuse(f"`{name}({node.name})` may be a function or a product", start, cure)
        self.place = place
        return _pi(Name(name, span=span))

    def expression(self) -> Node:
        """expression = atom that is no statement."""
        start = self.start
        return self.value(self.atom(), start)

    def part(self) -> Node:
        """part = "{" sum "}" | one character | command."""
        start = self.start
        if self.peek().kind == "number":
            token = self.first_digit()
            return Number(token.text, span=token.span)
        if self.peek().kind == "symbol":
            return _pi(Name(self.base(), span=self.since(start)))
        return self.expression()

    def first_digit(self) -> Token:
        """Take one character of a number, as TeX does for an argument without braces."""
        token = self.take()
        if len(token.text) == 1 or not token.text.isdigit():
            return token
        start, end = token.span
        first = Token("number", token.text[0], (start, start + 1))
        rest = Token("number", token.text[1:], (start + 1, end))
        self.tokens = (*self.tokens[: self.place - 1], first, rest, *self.tokens[self.place :])
        return first

    def fraction(self, start: int) -> Node:
        r"""fraction = "\frac" part part."""
        self.place += 1
        numerator, denominator = self.part(), self.part()
        return Quotient(numerator, denominator, span=self.since(start))

    def binomial(self, start: int) -> Node:
        r"""binomial = "\binom" part part: a column of two."""
        self.place += 1
        rows = tuple((self.unbraced(),) for _ in range(2))
        return MatrixLiteral(rows, span=self.since(start))

    def unbraced(self) -> Node:
        """Read a part; its braces belong to the command, not to what stands there."""
        node = self.part()
        begin, end = node.span
        return replace(node, span=(begin + 1, end - 1)) if self.source[begin] == "{" else node

    def root(self, start: int) -> Node:
        r"""root = "\sqrt" part."""
        self.place += 1
        if self.at("["):
            self.expected("a square root", "only square roots are read")
        return Call("sqrt", self.part(), span=self.since(start))

    def integral(self, start: int) -> Node:
        r"""integral = "\int" "_" part "^" part sum "d" symbol."""
        self.place += 1
        cure = r"write `\int_{0}^{t} … dt`"
        if not self.consume("_"):
            self.expected("the lower limit of the integral", cure)
        lower = self.part()
        if not self.consume("^"):
            self.expected("the upper limit of the integral", cure)
        upper = self.part()
        self.integrals += 1
        integrand = self.entry()
        if not self.at_differential():
            self.expected("the variable of the integral", cure)
        self.integrals -= 1
        self.place += 1
        begin = self.start
        variable = Name(self.symbol(), span=self.since(begin))
        return Integral(lower, upper, integrand, variable, span=self.since(start))

    def determinant(self, start: int) -> Node:
        r"""determinant = "\det" (symbol | bracket | matrix)."""
        self.place += 1
        if self.at_symbol():
            base = self.base() + self.primes()
            if self.consume("_"):
                base += "_" + self.script()
            return Name(f"\\det {base}", span=self.since(start))
        if not self.at("(", "[", "{") and self.peek().kind != "begin":
            self.expected("a matrix after `\\det`")
        argument = self.expression()
        if isinstance(argument, Tuple):
            return Determinant(argument.items, span=self.since(start))
        return Call("det", argument, span=self.since(start))

    def operator(self, start: int) -> Node:
        r"""operator = "\operatorname" "{" function "}" argument."""
        word = self.word()
        if word not in WORDS:
            self.place += 1
            cure = f"write one of {', '.join(sorted(WORDS))}"
            self.expected("a function that is read", cure)
        return self.function(self.worded(word), start)

    def function(self, name: str, start: int) -> Node:
        r"""function = "\sin" ["^" whole number] argument; the power -1 is the inverse function."""
        exponent = self.exponent() if self.consume("^") else 1
        if exponent == -1:
            if name not in INVERSES:
                cure = "write it by `\\arctan`" if name in CIRCULAR else "write what is meant"
                self.refuse(f"no inverse of `{name}` is read", start, cure)
            name, exponent = INVERSES[name], 1
        self.called = start
        argument = self.argument(FUNCTIONS[name].latex.removeprefix("\\"))
        call = Call(name, argument, span=self.since(start))
        return call if exponent == 1 else Power(call, exponent, span=call.span)

    def exponent(self) -> int:
        """exponent = digit | "{" ["-"] digits "}"."""
        start = self.start
        script = self.script().strip("{}")
        if not re.fullmatch("[-+]?[0-9]{1,6}", script):
            self.refuse("expected a whole power", start, "write roots with `\\sqrt`")
        return int(script)

    @abstractmethod
    def argument(self, function: str) -> Node:
        """Read the argument of a function."""


def _pi(node: Name) -> Name | Pi:
    return Pi(span=node.span) if node.name == "\\pi" else node


def _is_plain(node: Node) -> bool:
    """Whether a factor like this would need no brackets: no sum, no function."""
    if isinstance(node, PARTS):
        return all(map(_is_plain, children(node)))
    return isinstance(node, PLAIN)


def _habit(text: str) -> str:
    if text == ".":
        return "write 0 before the point"
    return "put the signed part into brackets" if text in {"-", "+"} else ""
