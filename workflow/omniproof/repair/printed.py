"""A printed tree with the values of its parts, and what may be read and replaced by itself.

A formula of a line has hundreds of edits. To read the whole line for each of them, and to evaluate
it, would take as long as the line: so an edit is read in the smallest part that is closed (the
entry of a matrix, the numerator of a fraction, the side of an equation), and evaluated from there
upwards. A part whose value does not reach all that is wrong holds no misprint that explains it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from omniproof.repair.edits import CLOSING, OPENING, SEPARATORS
from omniproof.repair.misprint import Misprint
from omniproof.repair.values import TOLERANCE, ShapeError, Values, combine
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError, Token, tokenize
from omniproof.transcription.tree import Span

Path = tuple[int, ...]
"""The way down a tree: which child, which child of that, and so on."""
MOST_CHARACTERS = 600_000
"""So much is read of edited texts, in about two seconds: the likeliest edits come first."""
MOVED = 1.2345, 0.6789
"""A factor and a summand that move nearly every value, and nearly everything made of it."""


class Printed:
    """The tree of a misprint; raises `LatexError`, and `ShapeError` for what floats cannot tell."""

    def __init__(self, misprint: Misprint) -> None:
        self.misprint, self.text, self.characters = misprint, misprint.text, 0
        self.root = misprint.judged(misprint.text)
        self.known: dict[Path, tuple[tree.Node, Values]] = {}
        values = self.learn((), self.root)
        statement = np.where(np.isfinite(values), 0.0, np.nan)
        self.target = statement if misprint.target is None else misprint.target
        if not np.isfinite(self.target).any():
            raise ShapeError("it has no value at any point")
        self.wrong = self.apart(values, self.target)
        self.has_relations = any(isinstance(n, tree.Comparison) for n in tree.walk(self.root))
        self.parts = sorted(self.closed(), key=lambda part: part[0][1] - part[0][0])

    def learn(self, path: Path, node: tree.Node) -> Values:
        """Evaluate the printed tree, and keep the values of every part."""
        if isinstance(node, tree.Name | tree.Applied):
            values = self.meaning(node)
        else:
            parts = enumerate(tree.children(node))
            values = combine(node, [self.learn((*path, k), part) for k, part in parts])
        self.known[path] = node, values
        return values

    def meaning(self, node: tree.Symbolic) -> Values:
        """Give the values of a symbol; raises `ShapeError` where it has none."""
        try:
            return self.misprint.meaning(node)
        except KeyError:
            raise ShapeError(f"no values of {node.name}") from None

    def closed(self) -> Iterator[tuple[Span, Path]]:
        """Yield the parts in brackets or between separators, and where they may be edited alone.

        Those are the parts that read the same by themselves. The place before a bracket of a part
        is no place in it: a sign there would be one between terms.
        """
        tokens = tokenize(self.text)
        begins = {right.span[0]: right.span[0] for left, right in pairwise(tokens) if _opens(left)}
        ends = {left.span[1]: left.span[1] for left, right in pairwise(tokens) if _closes(right)}
        begins |= {tokens[0].span[0]: 0} | {t.span[0]: t.span[1] for t in tokens if _opens(t)}
        ends |= {tokens[-1].span[1]: len(self.text)}
        ends |= {t.span[1]: t.span[0] for t in tokens if _closes(t)}
        for path, (node, _) in self.known.items():
            begin, end = node.span
            if path and begin in begins and end in ends and self.reads_alone(node):
                yield (begins[begin], ends[end]), path

    def reads_alone(self, node: tree.Node) -> bool:
        """Whether a part is the same without what stands around it."""
        try:
            return self.misprint.read(self.text[slice(*node.span)]) == node
        except LatexError:
            return False

    def around(self, span: Span) -> Path:
        """Find the smallest closed part that holds a place of the text."""
        for (begin, end), path in self.parts:
            if begin <= span[0] and span[1] <= end:
                return path
        return ()

    def reread(self, path: Path, text: str) -> tree.Node:
        """Read what a part has become in another text; raises as `Printed` does."""
        if path:
            begin, end = self.known[path][0].span
            text = text[begin : end + len(text) - len(self.text)]
        self.characters += len(text)
        if self.characters > MOST_CHARACTERS:
            raise ShapeError("enough has been read")
        return self.misprint.read(text) if path else self.misprint.judged(text)

    @cache  # noqa: B019 - it lives as long as one search
    def reached(self, path: Path) -> NDArray[np.bool_]:
        """Return which entries of the whole hang on a part; of a relation, any may."""
        if self.has_relations:
            return np.ones_like(self.wrong)
        factor, summand = MOVED
        values = self.lift(path, factor * self.known[path][1] + summand)
        return self.apart(values, self.known[()][1])

    def apart(self, values: Values, others: Values) -> NDArray[np.bool_]:
        """Return which entries differ, or lose their value, at one of the points.

        Of values of different shapes, all entries that are printed differ.
        """
        if values.shape[-2:] != others.shape[-2:]:
            return np.ones(self.known[()][1].shape[-2:], dtype=bool)
        near = np.abs(values - others) <= TOLERANCE * (1 + np.abs(others))
        return np.asarray((np.isfinite(others) & ~near).any(axis=-3))

    def lift(self, path: Path, values: Values, top: int = 0) -> Values:
        """Carry values at a place up the printed tree, to the ancestor at depth `top`."""
        for depth in reversed(range(top, len(path))):
            values = self.over(path[:depth], {path[depth]: values})
        return values

    def over(self, parent: Path, replaced: Mapping[int, Values]) -> Values:
        """Evaluate a printed node with other values for some of its children."""
        node = self.known[parent][0]
        places = range(len(tree.children(node)))
        return combine(node, [self.part((*parent, k), replaced.get(k)) for k in places])

    def part(self, path: Path, instead: Values | None) -> Values:
        """Return the values of a part, unless others stand for them."""
        return self.known[path][1] if instead is None else instead


def _opens(token: Token) -> bool:
    return token.text in OPENING or token.kind == "begin"


def _closes(token: Token) -> bool:
    return token.text in CLOSING or token.text in SEPARATORS or token.kind == "end"
