r"""The single edits of a printed formula: what a compositor or an author gets wrong at one place.

Misprints are edits of the printed text: a flipped sign, a wrong index, sin for cos, a factor too
many. Working on text keeps the paper's spelling; an expression would already have turned
`-L \sin \alpha_1 + L \sin \alpha_1` into 0. Signs, symbols and constants are found among the
tokens; what has parts that a text does not show (a ratio, a difference) in the tree.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations

from omniproof.repair.kinds import Edit, Repair, Word, edited, join, unbraced
from omniproof.repair.regrouped import regrouped
from omniproof.transcription import tree
from omniproof.transcription.functions import COMMANDS, FUNCTIONS
from omniproof.transcription.tokens import Token, tokenize
from omniproof.transcription.tree import Span

CONSTANTS = ("1", "2", "3", "4", "6", "8")
FACTORS = ("2", "3", "4", r"\frac{1}{2}", r"\frac{1}{3}")
NEIGHBOURS = {
    f"\\{command}": tuple(FUNCTIONS[other].latex for other in FUNCTIONS[function].neighbours)
    for command, function in COMMANDS.items()
}
RELATIONS = {
    "<": (">", r"\leq", r"\geq"),
    ">": ("<", r"\geq", r"\leq"),
    r"\leq": (r"\geq",),
    r"\geq": (r"\leq",),
    r"\neq": ("=",),
}
"""What may stand for a relation that is false: nothing that says more of the same."""
SIGNS = {"+", "-"}
OPERAND_ENDS = {"number", "symbol"}
SEPARATORS = {"=", *RELATIONS, "&", "\\\\", ","}
OPENING = {"(", "[", "{", "\\|", "\\langle"} | SEPARATORS
CLOSING = {")", "]", "}", r"\}", "|", "'", r"\rangle", r"\circ"}
EITHER = {"|", r"\|"}
"""Bars open and close: a sign after them may be either."""
MOST_SWAPS = 60


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
    words, kin = ([Word.read(word) for word in group] for group in (vocabulary, relatives))
    found = list(_Editor(text, words, kin, known).edits())
    if node is not None:
        found += regrouped(text, node, words)
    # Of two edits to one text the likelier one stays: it comes last, and the last entry wins.
    results = {edit.text: edit for edit in sorted(set(found), reverse=True) if edit.text != text}
    return sorted(results.values())


class _Editor:
    """The edits that tokens show."""

    def __init__(
        self,
        text: str,
        words: Sequence[Word],
        relatives: Sequence[Word],
        known: Sequence[str],
    ) -> None:
        self.text, self.words, self.relatives = text, words, relatives
        self.tokens = tokenize(text)
        # Without a superscript a symbol is recognised by itself.
        scripted = (Word.read(latex) for latex in known if "^" in latex)
        names = {unbraced(word.texts) for word in (*words, *relatives, *scripted)}
        self.symbols = list(_symbols(self.tokens, names))
        inside = {place for first, last in self.symbols for place in range(first, last)}
        self.free = [(k, token) for k, token in enumerate(self.tokens) if k not in inside]

    def edits(self) -> Iterator[Repair]:
        for place, token in self.free:
            if token.text in SIGNS:
                yield from self.flip(place, token)
            elif token.text in NEIGHBOURS:
                yield from self.others(Edit.FUNCTION, token, NEIGHBOURS[token.text])
            elif token.text in RELATIONS:
                yield from self.others(Edit.RELATION, token, RELATIONS[token.text])
            elif token.kind == "number":
                yield from self.constant(token)
        for first, last in self.symbols:
            yield from self.rename(first, last)
        yield from self.swap()
        for place in range(len(self.tokens)):
            yield from self.insert(place)
        yield from self.whole()

    def others(self, kind: Edit, token: Token, instead: Sequence[str]) -> Iterator[Repair]:
        """Put something else for a token."""
        for other in instead:
            yield self.edit(kind, token.span, other, f"{token.text} -> {other}")

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
            new = join(join(b, self.text[middle:resume]), a)
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
            if not (factor.isdecimal() and here.kind == "number"):  # they would be one number
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

    def word(self, first: int, last: int) -> Word:
        shown = self.text[slice(*self.place(first, last))]
        return Word.of(shown, [token.text for token in self.tokens[first:last]])

    def place(self, first: int, last: int) -> Span:
        """The place of tokens in the text."""
        return self.tokens[first].span[0], self.tokens[last - 1].span[1]

    def wide(self, span: Span) -> Span:
        """A place with the blanks after it, which go when it is dropped."""
        rest = self.text[span[1] :]
        return span[0], span[1] + len(rest) - len(rest.lstrip(" "))

    def edit(self, kind: Edit, span: Span, new: str, description: str) -> Repair:
        """Replace a span; a blank keeps a word apart from a letter that follows it."""
        return edited(self.text, kind, span, new, description)


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
                texts = unbraced([token.text for token in tokens[first:end]])
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
