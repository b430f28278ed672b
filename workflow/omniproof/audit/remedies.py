"""The repair of a statement that stands alone: its own symbols are all that an edit puts in."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from omniproof.audit.definitions import definitions
from omniproof.audit.setting import Assumptions, Setting
from omniproof.decide.answer import Witness
from omniproof.decide.direct import exact_place
from omniproof.formula.errors import UnsupportedError
from omniproof.repair.mend import mend
from omniproof.repair.misprint import Mended, Misprint
from omniproof.repair.values import Values, at_points
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError


def remedies(
    printed: str,
    assumptions: Assumptions,
    setting: Setting,
    proved: Callable[[str], tuple[str, ...]],
    witness: Witness | None,
) -> Mended | None:
    """Return the least edits that make a statement true under its assumptions, if there are any.

    `proved` names the engines that prove an edited text; at `witness` the printed one is false.
    """
    at = exact_place(witness) if witness else None

    def judged(text: str) -> tree.Node:
        rest = definitions(assumptions.read(text)).rest
        if rest is None:
            raise LatexError("nothing to prove", text, (0, len(text)))
        return rest

    @cache
    def meaning(symbol: tree.Symbolic) -> Values:
        known = setting.letters[symbol.name]
        try:
            values = at_points(known, setting.domain)
        except UnsupportedError:
            raise KeyError(symbol.name) from None
        # A relation may fail at few points: the witness is one of them.
        if at and known.name in at:
            values[0] = float(at[known.name])
        return values

    words = tuple(sorted(setting.letters))
    return mend(Misprint(printed, judged, assumptions.read, proved, meaning, words=words))
