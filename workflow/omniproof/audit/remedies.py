"""The single edits that make a false equation true, whichever of its sides they mend."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from omniproof.audit.approximate import ShapeError, Values, at_points, evaluate
from omniproof.audit.definitions import definitions
from omniproof.audit.likeness import likeness
from omniproof.audit.repair import QuickLook, Repair, repair
from omniproof.audit.setting import Assumptions, Setting
from omniproof.audit.unclear import refuse_unclear
from omniproof.decide.answer import Answer, Proved
from omniproof.decide.direct import heard_on
from omniproof.decide.statement import Link, links
from omniproof.decide.zero_test import decide_equal
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.unfold import unfold
from omniproof.transcription import tree
from omniproof.transcription.tokens import LatexError


def remedies(
    printed: str, node: tree.Node, assumptions: Assumptions, setting: Setting
) -> tuple[Repair, ...]:
    """Return the edits that make an equation true under its assumptions, the likeliest first.

    `node` is what of the equation is judged: a definition has no repair.

    Among edits of one kind, those behind the first equals sign lead: what stands before it is what
    a formula is about. Of edits that give one formula in two spellings, the likelier one is kept.
    The symbols of the formula are all that an edit puts in.
    """
    known: dict[tree.Node, Any] = {}

    def value(side: tree.Node) -> Any:
        if side not in known:
            known[side] = unfold(side, setting.letters)
        return known[side]

    def is_true(text: str) -> bool:
        try:
            steps = links(_judged(text, assumptions), value, text)
        except (LatexError, UnsupportedError):
            return False
        return all(isinstance(answer(step), Proved) for step in steps)

    def answer(step: Link) -> Answer:
        found = decide_equal(step.left, step.right, setting.domain)
        return heard_on(found, step, setting.names, setting.domain)

    quick = _quick_look(node, assumptions, setting.meanings)
    found = repair(printed, is_true, sorted(setting.meanings), quick)
    begin = tree.children(node)[0].span[1]
    ranked = sorted(found, key=lambda edit: (edit.kind, edit.span[0] < begin))
    return tuple(_unlike(ranked, assumptions))


def _judged(text: str, assumptions: Assumptions) -> tree.Node:
    """Read what of a text is judged; raises `LatexError` where there is nothing, or no one way."""
    rest = definitions(assumptions.read(text)).rest
    if rest is None:
        raise LatexError("nothing to prove", text, (0, len(text)))
    refuse_unclear(rest, text, assumptions.functions)
    return rest


def _quick_look(
    node: tree.Node, assumptions: Assumptions, meanings: Mapping[str, Any]
) -> QuickLook | None:
    """Prepare the quick look: the sides of a true equation differ by 0 where this one is defined.

    There is none for what floats cannot evaluate, or not at any of the points.
    """

    def meaning(node: tree.Symbolic) -> Values:
        return points[node.name]

    try:
        points = {name: at_points(symbol) for name, symbol in meanings.items()}
        gaps = evaluate(node, meaning)
    except (ShapeError, UnsupportedError):
        return None
    if not np.isfinite(gaps).any():
        return None
    target = np.where(np.isfinite(gaps), 0.0, np.nan)
    return QuickLook(partial(_judged, assumptions=assumptions), meaning, target)


def _unlike(found: Sequence[Repair], assumptions: Assumptions) -> Iterator[Repair]:
    seen = set()
    for edit in found:
        form = likeness(assumptions.read(edit.text))
        if form not in seen:
            seen.add(form)
            yield edit
