r"""What an edit of a printed text is: its kind, its place, and the text that it gives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import IntEnum

from omniproof.transcription.tokens import tokenize
from omniproof.transcription.tree import Span


class Edit(IntEnum):
    """What an edit does, the most common misprint first."""

    RELATION = 0  # turned over, or without the equality that it needs
    SIGN = 1  # between two terms
    MINUS = 2  # before a term
    INDEX = 3
    FUNCTION = 4
    LETTER = 5  # with the same index
    SWAP = 6  # of two symbols, or of the two sides of an operator
    DROP = 7  # a constant that should not be there
    CONSTANT = 8
    FACTOR = 9  # a small constant that is missing
    SYMBOL = 10
    RATIO = 11  # upside down
    PART = 12  # a factor or a power that should not be there, or is missing; a lost sign
    WHOLE = 13  # a symbol that is missing before, or below, everything
    WRAP = 14  # a root, a bar or an inverse tangent that is missing or too many


@dataclass(frozen=True, order=True)
class Repair:
    """Edits that make a formula true; repairs sort by how common such a misprint is.

    `span` is the place in the printed text that is replaced; `text` is the whole result; `engines`
    are those that proved it.
    """

    kind: Edit
    span: Span
    description: str
    text: str
    engines: tuple[str, ...] = field(default=(), compare=False)

    def inside(self, before: str, after: str) -> Repair:
        """Put the text into the line that it stands in."""
        begin, end = (len(before) + place for place in self.span)
        return replace(self, span=(begin, end), text=before + self.text + after)

    def replacement(self, printed: str) -> str:
        """What stands at the span instead."""
        return self.text[self.span[0] : len(self.text) - (len(printed) - self.span[1])]


@dataclass(frozen=True)
class Word:
    """A symbol: how it is written, its letter with accents, and its scripts."""

    latex: str
    texts: tuple[str, ...]
    base: tuple[str, ...]
    index: tuple[str, ...]

    @classmethod
    def read(cls, latex: str) -> Word:
        """Cut a symbol out of its LaTeX; raises `LatexError`."""
        return cls.of(latex, [token.text for token in tokenize(latex)])

    @classmethod
    def of(cls, latex: str, texts: Sequence[str]) -> Word:
        """Fonts are left out: they tell no two symbols apart."""
        plain = [text for text in texts if text not in {r"\mathbf", r"\boldsymbol", r"\mathrm"}]
        cut = plain.index("_") if "_" in plain else len(plain)
        return cls(latex, tuple(texts), unbraced(plain[:cut]), unbraced(plain[cut:]))

    def relation(self, other: Word) -> Edit:
        """What kind of misprint it is to print one for the other."""
        if self.base == other.base and self.index and other.index:
            return Edit.INDEX
        return Edit.LETTER if self.index == other.index != () else Edit.SYMBOL

    def is_kin(self, other: Word) -> bool:
        """Whether they share the letter or the index, or have one letter each and no index."""
        if self.relation(other) is not Edit.SYMBOL:
            return True
        return not self.index and not other.index and len(self.base) == len(other.base) == 1


def unbraced(texts: Sequence[str]) -> tuple[str, ...]:
    """Leave braces out: `v_{x}` and `v_x` are one symbol."""
    return tuple(text for text in texts if text not in {"{", "}"})


def edited(text: str, kind: Edit, span: Span, new: str, description: str) -> Repair:
    """Put something else at a place of a text."""
    before, after = text[: span[0]], text[span[1] :]
    return Repair(kind, span, description, join(join(before, new), after, span[0] == span[1]))


def join(left: str, right: str, apart: bool = False) -> str:
    r"""Put a text after another; a blank ends a command, and parts `L x` and `\theta \cos x`.

    With `apart`, a blank also parts two letters, which would look like one word.
    """
    if not (left[-1:].isalpha() and right[:1].isalpha()):
        return left + right
    tail = left.rstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")
    return f"{left} {right}" if apart or tail.endswith("\\") else left + right
