"""The edits of a printed formula that only its tree shows: what a text does not mark as a part."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise, product

from omniproof.repair.kinds import Edit, Repair, Word, edited, join
from omniproof.transcription import tree
from omniproof.transcription.tree import Span

WRAPPED = ("arctan", "sqrt")


def regrouped(text: str, node: tree.Node, words: Sequence[Word]) -> Iterator[Repair]:
    """Yield the edits of a text whose tree is `node`; `words` may be put in."""
    return _Regrouped(text, node, words).edits()


class _Regrouped:
    """The edits that only the tree shows."""

    def __init__(self, text: str, node: tree.Node, words: Sequence[Word]) -> None:
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
            new = join(name, f" {angle}")
            yield self.edit(Edit.PART, (end, end), f" {new}", f"insert {new}")

    def angles(self) -> list[str]:
        """Symbols that are the argument of a function, and their kin."""
        calls = [node for node in tree.walk(self.node) if isinstance(node, tree.Call)]
        inner = [self.shown(c.argument.span) for c in calls if isinstance(c.argument, tree.Name)]
        known = [Word.read(text) for text in dict.fromkeys(inner)]
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
        return edited(self.text, kind, span, new, description)
