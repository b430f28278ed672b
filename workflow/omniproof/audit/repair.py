r"""The one edit that makes a misprint true, in the paper's own spelling.

Misprints are edits of the printed text: a flipped sign, a wrong index, sin for cos, a factor too
many. So every single edit of that kind is made on the tokens of the printed LaTeX, and the caller
says which results are true. Working on text keeps the paper's spelling; an expression would already
have turned `-L \sin \alpha_1 + L \sin \alpha_1` into 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from enum import IntEnum

from omniproof.transcription.tokens import LatexError, Token, tokenize

MOST_EDITS = 2_000
CONSTANTS = ("1", "2", "3", "4", "6", "8")
FACTORS = ("2", "3", "4", r"\frac{1}{2}")
FUNCTIONS = {
    r"\sin": (r"\cos",),
    r"\cos": (r"\sin",),
    r"\tan": (r"\sin", r"\cos", r"\cot"),
    r"\cot": (r"\tan",),
}
OPERAND_ENDS = {"number", "symbol"}
OPENING = {"(", "[", "{", "=", "&", "\\\\", ","}
CLOSING = {")", "]", "}", r"\}", "|", "'"}


class Edit(IntEnum):
    """What an edit does, the most common misprint first."""

    SIGN = 0  # between two terms
    MINUS = 1  # before a term
    INDEX = 2
    FUNCTION = 3
    LETTER = 4  # with the same index
    DROP = 5  # a constant that should not be there
    CONSTANT = 6
    FACTOR = 7  # a small constant that is missing
    SYMBOL = 8
    WHOLE = 9  # a symbol that is missing before everything


@dataclass(frozen=True, order=True)
class Repair:
    """A single edit that makes a formula true; repairs sort by how common such a misprint is.

    `span` is the place in the printed text that the edit replaces; `text` is the whole result.
    """

    kind: Edit
    span: tuple[int, int]
    description: str
    text: str


def repair(
    printed: str, is_true: Callable[[str], bool], vocabulary: Sequence[str]
) -> tuple[Repair, ...]:
    """Return all single edits of a false formula that make it true, the likeliest first.

    `vocabulary` holds the LaTeX of symbols that may replace one another. Empty when no edit helps,
    or when the text cannot be cut into tokens.
    """
    try:
        words = [(word, tuple(t.text for t in tokenize(word))) for word in vocabulary]
        edits = sorted(set(_Editor(printed, words).edits()))
    except LatexError:
        return ()
    results = {edit.text: edit for edit in reversed(edits[:MOST_EDITS]) if edit.text != printed}
    return tuple(sorted(edit for text, edit in results.items() if is_true(text)))


class _Editor:
    """All edits of one text."""

    def __init__(self, text: str, words: Sequence[tuple[str, tuple[str, ...]]]) -> None:
        self.text, self.words = text, words
        self.tokens = tokenize(text)
        self.symbols = list(_symbols(self.tokens))
        inside = {place for first, last in self.symbols for place in range(first, last)}
        self.free = [(k, token) for k, token in enumerate(self.tokens) if k not in inside]

    def edits(self) -> Iterator[Repair]:
        for place, token in self.free:
            if token.text in {"+", "-"}:
                yield from self.flip(place, token)
            elif token.text in FUNCTIONS:
                for other in FUNCTIONS[token.text]:
                    yield self.edit(Edit.FUNCTION, token.span, other, f"{token.text} -> {other}")
            elif token.kind == "number":
                yield from self.constant(token)
        for first, last in self.symbols:
            yield from self.rename(first, last)
        for place in range(len(self.tokens)):
            yield from self.insert(place)
        for word, _ in self.words:
            whole = (0, len(self.text))
            yield self.edit(Edit.WHOLE, whole, f"{word} ({self.text})", f"multiply by {word}")

    def flip(self, place: int, token: Token) -> Iterator[Repair]:
        """Turn a sign between terms over; drop a leading one."""
        if _ends_operand(self.tokens, place):
            other = "-" if token.text == "+" else "+"
            yield self.edit(Edit.SIGN, token.span, other, f"{token.text} -> {other}")
        else:
            yield self.edit(Edit.MINUS, token.span, "", f"drop {token.text}")

    def constant(self, token: Token) -> Iterator[Repair]:
        for other in CONSTANTS:
            if other != token.text:
                yield self.edit(Edit.CONSTANT, token.span, other, f"{token.text} -> {other}")
        yield self.edit(Edit.DROP, token.span, "", f"drop {token.text}")

    def rename(self, first: int, last: int) -> Iterator[Repair]:
        """Put another symbol for one, by index, by letter, or any; or drop it."""
        span = self.tokens[first].span[0], self.tokens[last - 1].span[1]
        own = tuple(token.text for token in self.tokens[first:last])
        shown = self.text[slice(*span)]
        for word, other in self.words:
            if other == own:
                continue
            base = len(other) > 1 and len(own) > 1 and other[0] == own[0]
            index = len(other) > 1 and len(own) > 1 and other[1:] == own[1:]
            kind = Edit.INDEX if base else Edit.LETTER if index else Edit.SYMBOL
            yield self.edit(kind, span, word, f"{shown} -> {word}")
        yield self.edit(Edit.SYMBOL, span, "", f"drop {shown}")

    def insert(self, place: int) -> Iterator[Repair]:
        """Put a minus before a term; put a factor before a term or the argument of a function."""
        if any(first < place < last for first, last in self.symbols):
            return
        before, here = self.tokens[place - 1] if place else None, self.tokens[place]
        opens = before is None or before.text in OPENING
        signed = before is not None and (before.kind == "function" or before.text in {"+", "-"})
        if not (opens or signed) or here.text in {"+", "-"}:
            return
        span = here.span[0], here.span[0]
        if opens:
            yield self.edit(Edit.MINUS, span, "-", "insert -")
        for factor in FACTORS:
            yield self.edit(Edit.FACTOR, span, factor, f"insert {factor}")
        for word, _ in self.words:
            yield self.edit(Edit.SYMBOL, span, word, f"insert {word}")

    def edit(self, kind: Edit, span: tuple[int, int], new: str, description: str) -> Repair:
        """Replace a span; a blank keeps a command apart from a letter that follows it."""
        before, after = self.text[: span[0]], self.text[span[1] :]
        return Repair(kind, span, description, _join(_join(before, new), after))


def _join(left: str, right: str) -> str:
    tail = left.rstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")
    is_command = tail != left and tail.endswith("\\")
    return f"{left} {right}" if is_command and right[:1].isalpha() else left + right


def _ends_operand(tokens: Sequence[Token], place: int) -> bool:
    """Whether the token before a sign ends a term, so that the sign stands between terms."""
    if place == 0:
        return False
    before = tokens[place - 1]
    return before.kind in OPERAND_ENDS or before.text in CLOSING


def _symbols(tokens: Sequence[Token]) -> Iterator[tuple[int, int]]:
    """Yield the range of tokens of each symbol, with its accents and indices."""
    place = 0
    while place < len(tokens):
        first = place
        if tokens[place].kind in {"symbol", "accent", "font"}:
            place = _after_atom(tokens, place + (tokens[place].kind != "symbol"))
            while place < len(tokens) - 1 and tokens[place].text == "_":
                place = _after_atom(tokens, place + 1)
            yield first, place
        else:
            place += 1


def _after_atom(tokens: Sequence[Token], place: int) -> int:
    """Return the place after one token or one group in braces."""
    depth = 0
    for end in range(place, len(tokens)):
        depth += (tokens[end].text == "{") - (tokens[end].text == "}")
        if depth <= 0:
            return end + 1
    return len(tokens)
