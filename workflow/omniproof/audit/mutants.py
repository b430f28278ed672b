r"""Planted misprints: every single edit of a printed formula, made on its tree.

These edits are the measure of the audit, so they are made apart from those that a repair tries:
from the places of the nodes, not from tokens, with other rules of what may stand for what.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from omniproof.transcription import tree
from omniproof.transcription.tree import Span

OTHER_FUNCTION = {
    "sin": "cos", "cos": "sin", "tan": "cot", "cot": "tan", "arcsin": "arccos", "arccos": "arcsin",
    "arctan": "tan", "sec": "csc", "csc": "sec",
}  # fmt: skip
KINDS = ("sign", "index", "symbol", "function", "factor", "constant", "transposition")


@dataclass(frozen=True)
class Spelled:
    """A declared symbol: its LaTeX, its canonical name, and whether it is a free variable."""

    latex: str
    name: str
    free: bool

    @property
    def parts(self) -> tuple[str, str]:
        """Letter and index."""
        base, _, index = self.name.partition("_")
        return base, index


@dataclass(frozen=True, order=True)
class Mutant:
    """A text with one misprint, and of what kind that is."""

    kind: str
    text: str


def mutants(
    text: str, node: tree.Node, symbols: Sequence[Spelled], *, entries: bool = True
) -> list[Mutant]:
    """Return all single misprints of a text whose tree is `node`, each once, in order.

    Without `entries`, only those outside of printed matrices and vectors.
    """
    found = dict.fromkeys(_Misprints(text, node, symbols, entries).all())
    return [mutant for mutant in found if mutant.text != text]


class _Misprints:
    def __init__(
        self, text: str, node: tree.Node, symbols: Sequence[Spelled], entries: bool
    ) -> None:
        self.text, self.node, self.symbols = text, node, symbols
        self.by_name = {symbol.name: symbol for symbol in symbols}
        self.places = list(_visible(node, entries))
        self.names = [item for item in self.places if isinstance(item, tree.Name)]

    def all(self) -> Iterator[Mutant]:
        yield from self.before_terms(self.node)
        for node in self.places:
            yield from self.changes(node)
            yield from (self.exchange(a.span, b.span) for a, b in _neighbours(node))
        yield from (self.exchange(a.span, b.span) for a, b in pairwise(self.names))

    def changes(self, node: tree.Node) -> Iterator[Mutant]:
        """Change one node, or a part of it."""
        match node:
            case tree.Sum(terms):
                yield from self.signs(terms)
            case tree.Negative():
                yield self.put("sign", (node.span[0], node.span[0] + 1), "")
            case tree.Name():
                yield from self.other_names(node)
            case tree.Call(function) if function in OTHER_FUNCTION:
                end = node.span[0] + len(function) + 1
                yield self.put("function", (node.span[0], end), "\\" + OTHER_FUNCTION[function])
            case tree.Product(factors):
                yield from (self.put("factor", factor.span, "") for factor in factors)
            case tree.Number(printed) | tree.Degrees(printed):
                yield from self.constants(node.span[0], printed)
            case tree.Power(base, exponent):
                yield from self.exponents((base.span[1], node.span[1]), exponent)

    def signs(self, terms: Sequence[tree.Node]) -> Iterator[Mutant]:
        """Turn the sign between two terms over; let two terms change places."""
        yield from self.before_terms(terms[0])
        for before, term in pairwise(terms):
            start, end = before.span[1], term.span[1]
            match = re.search(r"[+−-]", self.text[start:end])
            if match is None:
                continue
            place = start + match.start()
            other = "-" if match[0] == "+" else "+"
            yield self.put("sign", (place, place + 1), other)
            if other == "+" and isinstance(term, tree.Negative):
                yield self.exchange(before.span, term.operand.span)

    def before_terms(self, node: tree.Node) -> Iterator[Mutant]:
        """Put a minus, a number or a symbol before a first term."""
        place = (node.span[0], node.span[0])
        if isinstance(node, tree.Negative | tree.Sum):
            return
        yield self.put("sign", place, "-")
        digit = self.text[place[0]].isdigit()
        yield self.put("factor", place, r"2 \cdot " if digit else "2")
        yield from (self.put("factor", place, word.latex) for word in self.symbols if word.free)

    def other_names(self, node: tree.Name) -> Iterator[Mutant]:
        """Put another symbol: any variable for a variable, one of its kin for a quantity."""
        own = self.by_name.get(node.name)
        if own is None:
            return
        for other in self.symbols:
            same_letter = own.parts[0] == other.parts[0] and own.parts[1] and other.parts[1]
            # A variable for a quantity would be no misprint, but another formula.
            alike = own.free is other.free and (own.free or _are_kin(own, other))
            if other != own and alike:
                yield self.put("index" if same_letter else "symbol", node.span, other.latex)

    def constants(self, start: int, printed: str) -> Iterator[Mutant]:
        """Put a neighbour, the double or the half of a whole number."""
        if not printed.isdigit():
            return
        number, start = int(printed), self.text.index(printed, start)
        for other in sorted({number + 1, abs(number - 1), 2 * number, number // 2} - {number}):
            yield self.put("constant", (start, start + len(printed)), str(other))

    def exponents(self, span: Span, exponent: int) -> Iterator[Mutant]:
        """Put another power."""
        for other in sorted({exponent + 1, exponent - 1, -exponent} - {0, exponent}):
            if self.text[slice(*span)].lstrip().startswith("^"):
                yield self.put("constant", span, f"^{{{other}}}")

    def exchange(self, left: Span, right: Span) -> Mutant:
        """Let two parts change places."""
        between = self.text[left[1] : right[0]]
        new = self.text[slice(*right)] + between + self.text[slice(*left)]
        return self.put("transposition", (left[0], right[1]), new)

    def put(self, kind: str, span: Span, new: str) -> Mutant:
        """Replace a stretch of the text; blanks keep commands apart from letters."""
        before, after = self.text[: span[0]], self.text[span[1] :]
        if new[:1].isalnum() and before[-1:].isalnum():
            before += " "
        if after[:1].isalnum() and (before + new)[-1:].isalnum():
            after = " " + after
        return Mutant(kind, before + new + after)


def _are_kin(one: Spelled, other: Spelled) -> bool:
    """Whether two symbols share letter or index, or are single letters."""
    (letter, index), (base, script) = one.parts, other.parts
    if index and script:
        return letter == base or index == script
    return not index and not script and len(letter) == len(base) == 1


def _neighbours(node: tree.Node) -> Iterator[tuple[tree.Node, tree.Node]]:
    """Yield parts of a node that an author may have taken for each other."""
    match node:
        case tree.Quotient(left, right) | tree.Cross(left, right):
            yield left, right
        case tree.Tuple(items) | tree.Determinant(items):
            yield from pairwise(items)
        case tree.MatrixLiteral(rows):
            yield from (pair for row in rows for pair in pairwise(row))


def _visible(node: tree.Node, entries: bool) -> Iterator[tree.Node]:
    """Walk a tree; `entries` says whether into matrices and vectors, too."""
    if not entries and isinstance(node, tree.MatrixLiteral | tree.Tuple):
        return
    yield node
    for child in tree.children(node):
        yield from _visible(child, entries)
