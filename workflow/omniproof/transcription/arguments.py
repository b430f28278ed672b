# ruff: noqa: D403 - the docstring of a rule is the rule
r"""What a function without brackets is taken of: `\sin 2\theta`, `\cos{\theta} T`.

Whether `\cos\theta T` takes in the T, print does not tell. A reader of one formula gets every
possible end, and may be told which to take (`parses`); in a paper the longest is meant.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from omniproof.transcription.atoms import AtomReader
from omniproof.transcription.conventions import Names, Writing
from omniproof.transcription.symbols import END
from omniproof.transcription.tokens import CLOSING, OPENING, Token
from omniproof.transcription.tree import Call, Node, Number, Pi, Quotient

SIMPLE = frozenset({"number", "symbol", "accent", "font"})


@dataclass(frozen=True)
class Argument:
    """An argument without brackets: offsets of its function, its start, and its possible ends.

    `usual` is the place among the ends that is taken where nothing else is said.
    """

    function: int
    start: int
    ends: tuple[int, ...]
    usual: int


class ArgumentReader(AtomReader, ABC):
    """Reads arguments; `reach` says by their offsets which of their ends to take, if not `usual`.

    Without a `reach`, nobody asks for other parses: what is not clear is refused.
    """

    def __init__(
        self, source: str, names: Names, notation: Writing, reach: Mapping[int, int] | None
    ) -> None:
        super().__init__(source, names, notation)
        self.reach = reach
        self.arguments: dict[int, Argument] = {}
        self.ahead: dict[int, tuple[Node, int]] = {}  # what an argument left, read once
        self.bare = -1  # where the last argument without brackets ended

    @abstractmethod
    def power(self) -> Node:
        """Read an atom with its power."""

    @abstractmethod
    def joined(self, factors: list[Node], start: int) -> Node:
        """Make a product of factors."""

    def argument(self, function: str) -> Node:
        """argument = bracket | bars | juxtaposed."""
        if self.alone and self.at("{"):
            self.unbrace(function)
        if self.at("(", "[", "{", "|", "\\|"):
            return self.expression()
        return self.juxtaposed(function)

    def unbrace(self, function: str) -> None:
        r"""Take the braces of `\cos{\theta} T` away: they do not print.

        Where they hold together what print does not, the formula is refused.
        """
        opened, closed = self.place, self.partner()
        inside = self.tokens[opened + 1 : closed]
        behind = self.tokens[closed + 1] if closed + 1 < len(self.tokens) else END
        split = any(
            token.text in {"+", "-"} for token in list(self.uncovered(opened + 1, closed))[1:]
        )
        bracketed = inside[:1] and inside[0].text in OPENING
        if split or (behind.text == "^" and inside and not bracketed):
            self.place = closed + 1
            message = f"braces do not print: it is not clear what `\\{function}` is taken of"
            self.refuse(message, self.called, f"write `\\{function}(…)`")
        if inside and (inside[0].kind in SIMPLE or inside[0].text in {"(", "\\frac", "\\sqrt"}):
            self.tokens = (*self.tokens[:opened], *inside, *self.tokens[closed + 1 :])

    def partner(self) -> int:
        """The place of the brace that ends the group which starts here, or of the last token."""
        depth = 0
        for place in range(self.place, len(self.tokens)):
            depth += (self.tokens[place].text == "{") - (self.tokens[place].text == "}")
            if depth == 0:
                return place
        return len(self.tokens) - 1

    def uncovered(self, start: int, end: int) -> Iterator[Token]:
        """The tokens between two places that stand in no bracket, matrix or script."""
        depth = 0
        for place in range(start, end):
            token = self.tokens[place]
            depth -= token.text in CLOSING or token.kind == "end"
            if depth == 0 and self.tokens[place - 1].text not in {"_", "^"}:
                yield token
            depth += token.text in OPENING or token.kind == "begin"

    def juxtaposed(self, function: str) -> Node:
        r"""juxtaposed = {number | symbol | fraction | root}, as in `\sin 2\theta`."""
        called, start = self.called, self.start
        parts: list[Node] = []
        ends: list[tuple[int, int]] = []  # parts and place where the argument may end
        usual = -1
        while self.at_part(bool(parts) and not isinstance(parts[-1], Number)):
            if parts and (_closed(parts[-1]) or self.at("(")) and usual < 0:
                usual = len(ends) - 1
                if self.reach is None:
                    self.refuse(f"it is not clear where the argument of `\\{function}` ends", start,
                                f"write `\\{function}(…)`")  # fmt: skip
            begin = self.place
            parts.append(self.power())
            self.ahead[begin] = parts[-1], self.place
            if not all(map(_is_coefficient, parts)):
                ends.append((len(parts), self.place))
        if not parts:
            self.expected(f"the argument of `\\{function}`", f"write `\\{function}(…)`")
        if len(ends) > 1 and self.reach is not None:
            size, self.place = ends[self.reach.get(start, usual)]
            parts = parts[:size]
            behind = tuple(self.tokens[place - 1].span[1] for _, place in ends)
            self.arguments[start] = Argument(called, start, behind, usual % len(ends))
        self.bare = self.since(start)[1]
        if isinstance(parts[-1], Number) and self.at_atom():
            self.expected(f"the end of the argument of `\\{function}`", f"write `\\{function}(…)`")
        return self.joined(parts, start)

    def at_part(self, bracket: bool) -> bool:
        """Whether a part of an argument starts here; a bracket may be one in another reading."""
        if self.at("("):
            return bracket and self.reach is not None
        return self.peek().kind == "number" or self.at_symbol() or self.at("\\frac", "\\sqrt")


def _is_coefficient(node: Node) -> bool:
    r"""Whether a factor never ends an argument that goes on: `\sin\frac{1}{2}\pi x`."""
    if isinstance(node, Quotient):
        return _is_coefficient(node.numerator) and _is_coefficient(node.denominator)
    return isinstance(node, Number | Pi)


def _closed(node: Node) -> bool:
    r"""Whether a fraction or root ends an argument; `\frac{1}{2}\theta` goes on."""
    if isinstance(node, Quotient):
        return not _is_coefficient(node)
    return isinstance(node, Call)
