r"""The single edits of a printed formula: what a compositor or an author gets wrong at one place.

Misprints are edits of the printed text: a flipped sign, a wrong index, sin for cos, a factor too
many. Working on text keeps the paper's spelling; an expression would already have turned
`-L \sin \alpha_1 + L \sin \alpha_1` into 0. Signs, symbols and constants are found among the
tokens; what has parts that a text does not show (a ratio, a difference) in the tree.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from enum import IntEnum
from itertools import combinations, pairwise, product

from omniproof.formula.functions import COMMANDS, FUNCTIONS
from omniproof.transcription import tree
from omniproof.transcription.tokens import Token, tokenize
from omniproof.transcription.tree import Span

CONSTANTS = ("1", "2", "3", "4", "6", "8")
FACTORS = ("2", "3", "4", r"\frac{1}{2}", r"\frac{1}{3}")
NEIGHBOURS = {
    f"\\{command}": tuple(FUNCTIONS[other].latex for other in FUNCTIONS[function].neighbours)
    for command, function in COMMANDS.items()
}
WRAPPED = ("arctan", "sqrt")
SIGNS = {"+", "-"}
OPERAND_ENDS = {"number", "symbol"}
OPENING = {"(", "[", "{", "=", "&", "\\\\", ",", "\\|", "\\langle"}
CLOSING = {")", "]", "}", r"\}", "|", "'", r"\rangle", r"\circ"}
EITHER = {"|", r"\|"}
"""Bars open and close: a sign after them may be either."""
MOST_SWAPS = 60


class Edit(IntEnum):
    """What an edit does, the most common misprint first."""

    SIGN = 0  # between two terms
    MINUS = 1  # before a term
    INDEX = 2
    FUNCTION = 3
    LETTER = 4  # with the same index
    SWAP = 5  # of two symbols, or of the two sides of an operator
    DROP = 6  # a constant that should not be there
    CONSTANT = 7
    FACTOR = 8  # a small constant that is missing
    SYMBOL = 9
    RATIO = 10  # upside down
    PART = 11  # a factor or a power that should not be there, or is missing; a lost sign
    WHOLE = 12  # a symbol that is missing before, or below, everything
    WRAP = 13  # a root, a bar or an inverse tangent that is missing or too many


@dataclass(frozen=True, order=True)
class Repair:
    """Edits that make a formula true; repairs sort by how common such a misprint is.

    `span` is the place in the printed text that is replaced; `text` is the whole result.
    """

    kind: Edit
    span: Span
    description: str
    text: str

    def replacement(self, printed: str) -> str:
        """What stands at the span instead."""
        return self.text[self.span[0] : len(self.text) - (len(printed) - self.span[1])]


def edits(
    text: str,
    vocabulary: Sequence[str],
    relatives: Sequence[str] = (),
    node: tree.Node | None = None,
    known: Sequence[str] = (),
) -> list[Repair]:
    """Return all single edits of a text, sorted, each result once.

    `vocabulary` holds the LaTeX of symbols that may be inserted or stand for any other; `relatives`
    only replace symbols with the same letter or the same index; those `known` are recognised where
    they are printed. With `node`, the tree of the text, also what only the tree shows.
    Raises `LatexError` for a text that cannot be cut into tokens.
    """
    words, kin = ([_Word.read(word) for word in group] for group in (vocabulary, relatives))
    found = list(_Editor(text, words, kin, known).edits())
    if node is not None:
        found += _Regrouped(text, node, words).edits()
    # Of two edits to one text the likelier one stays: it comes last, and the last entry wins.
    results = {edit.text: edit for edit in sorted(set(found), reverse=True) if edit.text != text}
    return sorted(results.values())


@dataclass(frozen=True)
class _Word:
    """A symbol: how it is written, its letter with accents, and its scripts."""

    latex: str
    texts: tuple[str, ...]
    base: tuple[str, ...]
    index: tuple[str, ...]

    @classmethod
    def read(cls, latex: str) -> _Word:
        return cls.of(latex, [token.text for token in tokenize(latex)])

    @classmethod
    def of(cls, latex: str, texts: Sequence[str]) -> _Word:
        """Fonts are left out: they tell no two symbols apart."""
        plain = [text for text in texts if text not in {r"\mathbf", r"\boldsymbol", r"\mathrm"}]
        cut = plain.index("_") if "_" in plain else len(plain)
        return cls(latex, tuple(texts), _unbraced(plain[:cut]), _unbraced(plain[cut:]))

    def relation(self, other: _Word) -> Edit:
        """What kind of misprint it is to print one for the other."""
        if self.base == other.base and self.index and other.index:
            return Edit.INDEX
        return Edit.LETTER if self.index == other.index != () else Edit.SYMBOL

    def is_kin(self, other: _Word) -> bool:
        """Whether they share the letter or the index, or have one letter each and no index."""
        if self.relation(other) is not Edit.SYMBOL:
            return True
        return not self.index and not other.index and len(self.base) == len(other.base) == 1


def _unbraced(texts: Sequence[str]) -> tuple[str, ...]:
    """Leave braces out: `v_{x}` and `v_x` are one symbol."""
    return tuple(text for text in texts if text not in {"{", "}"})


class _Editor:
    """The edits that tokens show."""

    def __init__(
        self,
        text: str,
        words: Sequence[_Word],
        relatives: Sequence[_Word],
        known: Sequence[str],
    ) -> None:
        self.text, self.words, self.relatives = text, words, relatives
        self.tokens = tokenize(text)
        # Without a superscript a symbol is recognised by itself.
        scripted = (_Word.read(latex) for latex in known if "^" in latex)
        names = {_unbraced(word.texts) for word in (*words, *relatives, *scripted)}
        self.symbols = list(_symbols(self.tokens, names))
        inside = {place for first, last in self.symbols for place in range(first, last)}
        self.free = [(k, token) for k, token in enumerate(self.tokens) if k not in inside]

    def edits(self) -> Iterator[Repair]:
        for place, token in self.free:
            if token.text in SIGNS:
                yield from self.flip(place, token)
            elif token.text in NEIGHBOURS:
                for other in NEIGHBOURS[token.text]:
                    yield self.edit(Edit.FUNCTION, token.span, other, f"{token.text} -> {other}")
            elif token.kind == "number":
                yield from self.constant(token)
        for first, last in self.symbols:
            yield from self.rename(first, last)
        yield from self.swap()
        for place in range(len(self.tokens)):
            yield from self.insert(place)
        yield from self.whole()

    def flip(self, place: int, token: Token) -> Iterator[Repair]:
        """Turn a sign between terms over; drop a leading one."""
        either = place > 0 and self.tokens[place - 1].text in EITHER
        # After a bar that may open or close, a sign is tried as both.
        if either or _ends_operand(self.tokens, place):
            other = "-" if token.text == "+" else "+"
            yield self.edit(Edit.SIGN, token.span, other, f"{token.text} -> {other}")
        if either or not _ends_operand(self.tokens, place):
            yield self.edit(Edit.MINUS, self.wide(token.span), "", f"drop {token.text}")

    def constant(self, token: Token) -> Iterator[Repair]:
        near = {str(int(token.text) + step) for step in (-1, 1)} if token.text.isdigit() else set()
        for other in sorted({*CONSTANTS, *near} - {token.text, "-1"}):
            yield self.edit(Edit.CONSTANT, token.span, other, f"{token.text} -> {other}")
        yield self.edit(Edit.DROP, self.wide(token.span), "", f"drop {token.text}")
        root = rf"\sqrt{{{token.text}}}"
        yield self.edit(Edit.WRAP, token.span, root, f"{token.text} -> {root}")

    def rename(self, first: int, last: int) -> Iterator[Repair]:
        """Put another symbol for one, by index, by letter, or any; or drop it."""
        span = self.place(first, last)
        own = self.word(first, last)
        for other in (*self.words, *(word for word in self.relatives if own.is_kin(word))):
            if (other.base, other.index) != (own.base, own.index):
                description = f"{own.latex} -> {other.latex}"
                yield self.edit(own.relation(other), span, other.latex, description)
        yield self.edit(Edit.SYMBOL, self.wide(span), "", f"drop {own.latex}")

    def swap(self) -> Iterator[Repair]:
        """Let two symbols change places, the nearest pairs first."""
        pairs = sorted(combinations(self.symbols, 2), key=lambda pair: pair[1][0] - pair[0][0])
        for left, right in pairs[:MOST_SWAPS]:
            a, b = self.word(*left).latex, self.word(*right).latex
            (begin, middle), (resume, end) = self.place(*left), self.place(*right)
            new = _join(_join(b, self.text[middle:resume]), a)
            yield self.edit(Edit.SWAP, (begin, end), new, f"{a} <-> {b}")

    def insert(self, place: int) -> Iterator[Repair]:
        """Put a minus before a term; put a factor before a term or the argument of a function."""
        here, inside = self.tokens[place], any(a < place < b for a, b in self.symbols)
        opens = place == 0 or self.tokens[place - 1].text in OPENING
        if inside or here.text in SIGNS or not (opens or _awaits_operand(self.tokens[place - 1])):
            return
        span = here.span[0], here.span[0]
        if opens:
            yield self.edit(Edit.MINUS, span, "-", "insert -")
        for factor in FACTORS:
            yield self.edit(Edit.FACTOR, span, factor, f"insert {factor}")
        for word in self.words:
            yield self.edit(Edit.SYMBOL, span, word.latex, f"insert {word.latex}")

    def whole(self) -> Iterator[Repair]:
        """Multiply or divide everything by a symbol; wrap everything."""
        span, text = (0, len(self.text)), self.text.strip()
        yield self.edit(Edit.WHOLE, span, f"-({text})", "insert -")
        for word in self.words:
            name = word.latex
            yield self.edit(Edit.WHOLE, span, f"{name} ({text})", f"multiply by {name}")
            yield self.edit(Edit.WHOLE, span, rf"\frac{{{text}}}{{{name}}}", f"divide by {name}")
        for shape in (rf"\arctan({text})", rf"\sqrt{{{text}}}", rf"\left|{text}\right|"):
            yield self.edit(Edit.WRAP, span, shape, f"{text} -> {shape}")

    def word(self, first: int, last: int) -> _Word:
        shown = self.text[slice(*self.place(first, last))]
        return _Word.of(shown, [token.text for token in self.tokens[first:last]])

    def place(self, first: int, last: int) -> Span:
        """The place of tokens in the text."""
        return self.tokens[first].span[0], self.tokens[last - 1].span[1]

    def wide(self, span: Span) -> Span:
        """A place with the blanks after it, which go when it is dropped."""
        rest = self.text[span[1] :]
        return span[0], span[1] + len(rest) - len(rest.lstrip(" "))

    def edit(self, kind: Edit, span: Span, new: str, description: str) -> Repair:
        """Replace a span; a blank keeps a word apart from a letter that follows it."""
        return _edit(self.text, kind, span, new, description)


class _Regrouped:
    """The edits that only the tree shows."""

    def __init__(self, text: str, node: tree.Node, words: Sequence[_Word]) -> None:
        self.text, self.node, self.words = text, node, words

    def edits(self) -> Iterator[Repair]:
        yield from self.lost_functions()
        for node in tree.walk(self.node):
            match node:
                case tree.Quotient(above, below):
                    yield self.exchange(Edit.RATIO, above, below, "invert the ratio")
                case tree.Cross(left, right):
                    yield self.exchange(Edit.SWAP, left, right, "swap the factors")
                case tree.Sum(terms):
                    yield from self.differences(terms)
                case tree.Tuple(items) | tree.Determinant(items):
                    for left, right in pairwise(items):
                        yield self.exchange(Edit.SWAP, left, right, "swap two entries")
                case tree.Product(factors):
                    yield from self.without(factors)
                    yield from self.lost_signs(factors)
                case tree.Power(base):
                    span = base.span[1], node.span[1]
                    if base.span != node.span:
                        yield self.edit(Edit.PART, span, "", f"drop {self.shown(span)}")
                case tree.Absolute(inner) | tree.Norm(inner):
                    yield self.unwrap(node, inner, "drop bars")
                case tree.Call(function, inner) if function in WRAPPED:
                    yield self.unwrap(node, inner, f"drop the {function}")

    def differences(self, terms: Sequence[tree.Node]) -> Iterator[Repair]:
        """Turn a difference round: a - b -> b - a."""
        for left, right in pairwise(terms):
            if isinstance(right, tree.Negative) and not isinstance(left, tree.Negative):
                yield self.exchange(Edit.SWAP, left, right.operand, "swap the terms")

    def without(self, factors: Sequence[tree.Node]) -> Iterator[Repair]:
        """Leave a factor out that is no symbol and no number."""
        for factor in factors:
            if not isinstance(factor, tree.Number | tree.Name):
                description = f"drop {self.shown(factor.span)}"
                yield self.edit(Edit.PART, factor.span, "", description)

    def lost_signs(self, factors: Sequence[tree.Node]) -> Iterator[Repair]:
        """Put a sign between two factors: they may have been terms."""
        for factor in factors[1:]:
            for sign in "-+":
                place = factor.span[0], factor.span[0]
                yield self.edit(Edit.PART, place, f"{sign} ", f"insert {sign}")

    def lost_functions(self) -> Iterator[Repair]:
        """Put a sine or cosine after each term, of what stands in one already, or of its kin."""
        sums = [node.terms for node in tree.walk(self.node) if isinstance(node, tree.Sum)]
        ends = {term.span[1] for terms in (*sums, [self.node]) for term in terms}
        for end, name, angle in product(ends, (r"\sin", r"\cos"), self.angles()):
            new = _join(name, f" {angle}")
            yield self.edit(Edit.PART, (end, end), f" {new}", f"insert {new}")

    def angles(self) -> list[str]:
        """Symbols that are the argument of a function, and their kin."""
        calls = [node for node in tree.walk(self.node) if isinstance(node, tree.Call)]
        inner = [self.shown(c.argument.span) for c in calls if isinstance(c.argument, tree.Name)]
        known = [_Word.read(text) for text in dict.fromkeys(inner)]
        return [word.latex for word in self.words if any(map(word.is_kin, known))]

    def exchange(self, kind: Edit, left: tree.Node, right: tree.Node, description: str) -> Repair:
        """Let two parts change places."""
        (begin, middle), (resume, end) = left.span, right.span
        new = self.shown(right.span) + self.text[middle:resume] + self.shown(left.span)
        return self.edit(kind, (begin, end), new, description)

    def unwrap(self, node: tree.Node, inner: tree.Node, description: str) -> Repair:
        """Put brackets where bars or a function were."""
        return self.edit(Edit.WRAP, node.span, f"({self.shown(inner.span)})", description)

    def shown(self, span: Span) -> str:
        return self.text[slice(*span)]

    def edit(self, kind: Edit, span: Span, new: str, description: str) -> Repair:
        return _edit(self.text, kind, span, new, description)


def _edit(text: str, kind: Edit, span: Span, new: str, description: str) -> Repair:
    before, after = text[: span[0]], text[span[1] :]
    return Repair(kind, span, description, _join(_join(before, new), after, span[0] == span[1]))


def _join(left: str, right: str, apart: bool = False) -> str:
    r"""Put a text after another; a blank ends a command, and parts `L x` and `\theta \cos x`.

    With `apart`, a blank also parts two letters, which would look like one word.
    """
    if not (left[-1:].isalpha() and right[:1].isalpha()):
        return left + right
    tail = left.rstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")
    return f"{left} {right}" if apart or tail.endswith("\\") else left + right


def _ends_operand(tokens: Sequence[Token], place: int) -> bool:
    """Whether the token before a sign ends a term, so that the sign stands between terms."""
    if place == 0:
        return False
    before = tokens[place - 1]
    return before.kind in OPERAND_ENDS or before.text in CLOSING


def _awaits_operand(token: Token) -> bool:
    """Whether a term or an argument has to follow."""
    return token.kind == "function" or token.text in SIGNS


def _symbols(
    tokens: Sequence[Token], known: Collection[tuple[str, ...]]
) -> Iterator[tuple[int, int]]:
    """Yield the range of tokens of each symbol, with its accents and indices.

    A superscript belongs to a symbol if both together are `known`, braces left out.
    """
    place = 0
    while place < len(tokens):
        first = place
        if tokens[place].kind in {"symbol", "accent", "font"}:
            place = _after_atom(tokens, place + (tokens[place].kind != "symbol"))
            while place < len(tokens) - 1 and tokens[place].text == "_":
                place = _after_atom(tokens, place + 1)
            if place < len(tokens) - 1 and tokens[place].text == "^":
                end = _after_atom(tokens, place + 1)
                texts = _unbraced([token.text for token in tokens[first:end]])
                place = end if texts in known else place
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
