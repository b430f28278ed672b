# ruff: noqa: D403 - the docstring of a rule is the rule
r"""Reads the LaTeX of a paper into a tree that keeps the printed form.

Public parsers read 5 to 10 of 20 real lines of such papers: they know neither matrices nor `\dot`
nor `\tan^{-1}`, and take `v_x^B` for a power. Hence a reader by recursive descent, one method per
grammar rule with the rule as its docstring. What can be read in two ways is refused, with a cure,
unless the paper's `Notation` settles it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Literal

from omniproof.transcription.arguments import ArgumentReader
from omniproof.transcription.conventions import Conventions, Names, Writing
from omniproof.transcription.symbols import END, TRANSPOSE, symbol_name
from omniproof.transcription.tokens import Cure
from omniproof.transcription.tree import (
    STATEMENTS,
    Call,
    Chain,
    Comparison,
    Component,
    Cross,
    Degrees,
    Dot,
    Listing,
    Logic,
    Negative,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Transpose,
)

COMPARISONS = frozenset({"<", ">", "\\leq", "\\geq", "\\neq"})
RELATIONS = COMPARISONS | {"="}
AXES = frozenset("xyz123456789")


def read(
    text: str,
    notation: Writing | None = None,
    symbols: Sequence[str] = (),
    quantities: Sequence[str] = (),
    functions: Sequence[str] = (),
) -> Node:
    r"""Read a formula, an equation, or a list of them.

    `symbols` are the LaTeX of the declared symbols. Among them, `quantities` may be followed by
    plain arguments, as `D_V(\theta)`, and `functions` by any. Raises `LatexError` for what cannot
    be read, or in more than one way.
    """
    declared, applied, called = (
        frozenset(symbol_name(latex) for latex in listed)
        for listed in ((*symbols, *quantities, *functions), quantities, functions)
    )
    return read_with(text, notation or Conventions(), Names(declared, applied, called))


def read_with(
    text: str, notation: Writing, names: Names, reach: Mapping[int, int] | None = None
) -> Node:
    """Read a formula as `read` does, for symbols that are canonical already; `reach`: see there."""
    return Reader(text, names, notation, reach).document()


class Reader(ArgumentReader):
    """Sums, products, powers and statements."""

    def __init__(
        self,
        source: str,
        names: Names,
        notation: Writing,
        reach: Mapping[int, int] | None = None,
    ) -> None:
        super().__init__(source, names, notation, reach)
        self.slash, self.angles = notation.slash, notation.angles

    def document(self) -> Node:
        r"""document = statement {("," | "\\") statement} ["," | "."]."""
        items = [self.line()]
        while self.separator() and self.peek() is not END:
            items.append(self.line())
        if self.peek() is not END:
            self.expected("an operator or the end of the formula")
        whole = _continue_chains(items)
        if len(whole) == 1:
            return whole[0]
        return Listing(_distribute(whole), span=(whole[0].span[0], whole[-1].span[1]))

    def separator(self) -> bool:
        """Step over what may stand between two statements."""
        start = self.place
        # A full stop ends a display, or a row of it; nowhere else does it end a statement.
        if not self.consume(",", ";") and self.peek(1).kind in {"row", END.kind}:
            self.consume(".")
        self.consume_kind("row")
        return self.consume_text("and") or self.place > start

    def consume_text(self, *words: str) -> bool:
        r"""Step over `\text{word}`."""
        token = self.peek()
        found = token.kind == "text" and token.text[:-1].split("{")[1].strip(" ,") in words
        self.place += found
        return found

    def line(self) -> Node:
        r"""line = ["=" | "\Leftrightarrow" | "or" | "and"] statement, going on from before."""
        start = self.start
        for relation in ("=", "\\Leftrightarrow"):
            if self.consume(relation):
                node = self.statement()
                if isinstance(node, Chain) and node.relation == relation:
                    return replace(node, continued=True, span=self.since(start))
                return Chain((node,), relation, continued=True, span=self.since(start))
        words: tuple[Literal["or", "and"], ...] = ("or", "and")
        for word in words:
            if self.consume_text(word):
                return Logic(word, (self.statement(),), span=self.since(start))
        return self.statement()

    def statement(self) -> Node:
        r"""statement = disjunction {"\Leftrightarrow" disjunction}."""
        start = self.start
        sides = [self.disjunction()]
        while self.consume("\\Leftrightarrow"):
            sides.append(self.disjunction())
        if len(sides) == 1:
            return sides[0]
        return Chain(tuple(sides), "\\Leftrightarrow", span=self.since(start))

    def disjunction(self) -> Node:
        """disjunction = conjunction {"or" conjunction}."""
        start = self.start
        parts = [self.conjunction()]
        while self.consume("\\lor") or self.consume_text("or"):
            parts.append(self.conjunction())
        return parts[0] if len(parts) == 1 else Logic("or", tuple(parts), span=self.since(start))

    def conjunction(self) -> Node:
        """conjunction = relation {"and" relation}."""
        start = self.start
        parts = [self.relation()]
        while self.consume("\\land") or self.consume_text("and"):
            parts.append(self.relation())
        return parts[0] if len(parts) == 1 else Logic("and", tuple(parts), span=self.since(start))

    def relation(self) -> Node:
        """relation = sum {("=" | "<" | …) sum}."""
        start = self.start
        sides, operators = [self.sum()], list[str]()
        while self.peek().kind == "sign" and self.peek().text in RELATIONS:
            operators.append(self.take().text)
            sides.append(self.sum())
        return self.related(sides, operators, start)

    def items(self) -> tuple[Node, ...]:
        """items = statement {"," statement}."""
        items = [self.statement()]
        while self.consume(",", ";"):
            items.append(self.statement())
        return _distribute(items)

    def entry(self) -> Node:
        """entry = sum that is no statement."""
        start = self.start
        return self.value(self.sum(), start)

    def sum(self) -> Node:
        """sum = ["-" | "+"] product {("+" | "-") product}."""
        start = self.start
        terms: list[Node] = []
        while not terms or self.at("+", "-"):
            begin = self.start
            minus = self.at("-")
            if self.at("+", "-"):
                self.place += 1
            term = self.product()
            terms.append(Negative(term, span=self.since(begin)) if minus else term)
        if len(terms) == 1:
            return terms[0]
        return Sum(tuple(self.value(term, start) for term in terms), span=self.since(start))

    def product(self) -> Node:
        r"""product = power {["*" | "\cdot" | "\times" | "/"] power}."""
        start = self.start
        factors = [self.power()]
        while True:
            if self.at("/"):
                factors = [self.divided(factors, start)]
            elif self.at("\\cdot", "\\times"):
                kind = Cross if self.take().text == "\\times" else Dot
                right = self.value(self.power(), start)
                factors = [kind(self.joined(factors, start), right, span=self.since(start))]
            elif self.consume("*") or self.at_atom():
                factors.append(self.power())
            else:
                break
        self.unit()
        return self.joined(factors, start)

    def joined(self, factors: list[Node], start: int) -> Node:
        """The product of what has been read since `start`."""
        if len(factors) == 1:
            return factors[0]
        end = max(factor.span[1] for factor in factors)
        return Product(tuple(self.value(factor, start) for factor in factors), span=(start, end))

    def unit(self) -> None:
        r"""Read over a unit `\text{ [m/s]}^3`: numbers carry theirs beside the formula."""
        token = self.peek()
        if token.kind == "text" and token.text.split("{")[1].strip().startswith("["):
            self.place += 1
            if self.consume("^"):
                self.script()

    def divided(self, factors: list[Node], start: int) -> Node:
        """divided = "/" power, or "/" {power} where the notation says `slash: all`."""
        self.place += 1
        below = self.start
        parts = [self.value(self.power(), below)]
        if self.slash is None:
            self.ambiguous_slash(factors[-1], parts[0], start)
        while self.slash == "all" and self.at_atom():
            parts.append(self.power())
        denominator = self.joined(parts, below)
        return Quotient(self.joined(factors, start), denominator, span=self.since(start))

    def ambiguous_slash(self, above: Node, below: Node, start: int) -> None:
        r"""Refuse `1/3L` and `\sin x/2`."""
        if self.at_atom() or self.at("*", "\\cdot", "\\times"):
            self.take()
            self.refuse("it is not clear what the slash divides by", start, SLASH)
        if above.span[1] == self.bare and not isinstance(below, Call):
            self.refuse("the slash may divide the function or its argument", start, SLASH)

    def power(self) -> Node:
        """power = atom ["^" whole number | "^" "T" | "_" axis]."""
        if self.place in self.ahead:
            node, self.place = self.ahead[self.place]
            return node
        start = self.start
        node = self.atom()
        if self.at("_") and self.tokens[self.place - 1].text in {")", "]"}:
            self.place += 1
            axis = self.script()
            if axis not in AXES:
                self.refuse("expected a component: x, y, z or a number", start, "")
            node = Component(self.value(node, start), axis, span=self.since(start))
        if not self.at("^"):
            return node
        node = self.value(node, start)
        if self.peek(1).text == "\\circ" or self.peek(2).text == "\\circ":
            self.expected("degrees after a number only", "write `\\theta \\cdot 1^\\circ`")
        if self.transposed():
            return Transpose(node, span=self.since(start))
        self.place += 1
        return Power(node, self.exponent(), span=self.since(start))

    def transposed(self) -> bool:
        """Step over `^T` or `^{T}`."""
        ahead = [self.peek(step).text for step in range(4)]
        if ahead[1] in TRANSPOSE:
            self.place += 2
        elif ahead[1] == "{" and ahead[2] in TRANSPOSE and ahead[3] == "}":
            self.place += 4
        else:
            return False
        return True

    def argument(self, function: str) -> Node:
        """Read the argument of a function; numbers added to an angle get their unit."""
        node = super().argument(function)
        return _in_degrees(node) if self.angles == "degrees" and isinstance(node, Sum) else node

    def related(self, sides: list[Node], operators: list[str], start: int) -> Node:
        """One side, a chain of equations, or comparisons joined by `and`."""
        if not operators:
            return sides[0]
        sides = [self.value(side, start) for side in sides]
        if set(operators) == {"="}:
            return Chain(tuple(sides), span=self.since(start))
        parts = tuple(
            Chain((left, right), span=(left.span[0], right.span[1]))
            if operator == "="
            else Comparison(left, operator, right, span=(left.span[0], right.span[1]))
            for left, operator, right in zip(sides, operators, sides[1:], strict=False)
        )
        return parts[0] if len(parts) == 1 else Logic("and", parts, span=self.since(start))


FRACTION = "write `\\frac{…}{…}`, or settle it with"
SLASH = Cure(
    f"{FRACTION} `slash: first` or `slash: all` in the notation",
    f"{FRACTION} `--slash first` or `--slash all`",
)


def _in_degrees(node: Sum) -> Sum:
    """Read the bare numbers among the terms as degrees."""

    def term(part: Node) -> Node:
        if isinstance(part, Negative):
            return replace(part, operand=term(part.operand))
        return Degrees(part.text, span=part.span) if isinstance(part, Number) else part

    return replace(node, terms=tuple(term(part) for part in node.terms))


def _distribute(items: list[Node]) -> tuple[Node, ...]:
    r"""Read `|a|, |b| \leq 1` as two comparisons: alike on the left, the bound printed once."""
    found = list(items)
    for place in reversed(range(len(found) - 1)):
        after = found[place + 1]
        if isinstance(after, Comparison) and type(found[place]) is type(after.left):
            left = found[place]
            found[place] = Comparison(left, after.operator, after.right, span=left.span)
    return tuple(found)


def _continue_chains(items: list[Node]) -> list[Node]:
    """Join a line that starts with `=` to the line before it."""
    whole = [items[0]]
    for item in items[1:]:
        before = whole[-1]
        if not (isinstance(item, Chain) and item.continued):
            whole.append(item)
            continue
        span = (before.span[0], item.span[1])
        if isinstance(before, Chain) and before.relation == item.relation:
            whole[-1] = replace(before, sides=before.sides + item.sides, span=span)
        elif item.relation != "=" or not isinstance(before, STATEMENTS):
            whole[-1] = Chain((before, *item.sides), item.relation, span=span)
        else:
            whole.append(item)
    return whole
