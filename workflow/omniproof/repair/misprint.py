"""A false text and all that it takes to mend it, whoever printed it; and what mends it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from omniproof.repair.kinds import Repair
from omniproof.repair.values import Values
from omniproof.transcription import tree


@dataclass(frozen=True)
class Misprint:
    """A false text; the claim of a paper and a formula from the command line fill it in.

    `judged` gives the tree of what of a whole text is judged, `read` that of a part of one; both
    raise `LatexError`. `proved` is the door that found the text false: it names the engines that
    prove another text, and none where it is not proved. `meaning` gives the values of a symbol,
    with its arguments; it raises `KeyError`. `target` are the values that the text ought to have;
    without it, the text is a statement that ought to hold.

    What may be put in: `words` for any symbol, `relatives` only for symbols like them; a symbol
    that is `known` is recognised. Of two spellings of a repair, a `familiar` one is shown.
    """

    text: str
    judged: Callable[[str], tree.Node]
    read: Callable[[str], tree.Node]
    proved: Callable[[str], tuple[str, ...]]
    meaning: Callable[[tree.Symbolic], Values]
    target: Values | None = None
    words: tuple[str, ...] = ()
    relatives: tuple[str, ...] = ()
    known: tuple[str, ...] = ()
    familiar: Callable[[str], bool] = lambda _: False


@dataclass(frozen=True)
class Mended:
    """The repairs of a text, the likeliest first, each of `size` edits: one explains a misprint."""

    repairs: tuple[Repair, ...]
    size: int

    def inside(self, before: str, after: str) -> Mended:
        """Put the texts into the line that they stand in."""
        return Mended(tuple(each.inside(before, after) for each in self.repairs), self.size)
