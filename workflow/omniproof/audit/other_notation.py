"""Errata that hang on a setting of ours: `notation` says how the paper's print is read.

`1/3L` is false where it should be true if `slash` is set the wrong way, and so are `90` and `c`. A
setting is believed where it makes more formulas true than another one would; otherwise it is asked
for, and nothing is charged to the paper.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from omniproof.audit.context import Context
from omniproof.audit.identities import count_faults
from omniproof.audit.ledger import Row, Verdict
from omniproof.transcription.faults import Fault
from omniproof.transcription.ids import base
from omniproof.transcription.model import Claim, Kind, Notation
from omniproof.transcription.reader import read_with
from omniproof.transcription.tokens import LatexError

FUNCTIONS = ("cos", "sin", "tan")
"""What a shorthand of one letter may stand for."""


def misread(rows: list[Row], context: Context) -> Iterator[Fault]:
    """Find wrong identities that another notation makes right, if it makes fewer wrong."""
    rows = [row for row in rows if row.kind is Kind.IDENTITY]
    wrong = dict.fromkeys(base(row.id) for row in rows if row.verdict is Verdict.ERRATUM)
    right = dict.fromkeys(base(row.id) for row in rows if base(row.id) not in wrong)
    for notation, wanted, found in _others(context.loaded.paper.notation):
        better = [claim for claim in wrong if _gain(notation, claim, context) > 0]
        # The right ones are many, and are read again only where they decide something.
        if better and len(better) > sum(_gain(notation, claim, context) < 0 for claim in right):
            for claim in better:
                message = f"expected `{wanted}`, under which more of it is true, found `{found}`"
                cure = "settle in `notation` how the paper writes this"
                yield context.loaded.fault(claim, message, cure, "latex")


def _others(notation: Notation) -> Iterator[tuple[Notation, str, str]]:
    """Notations that differ in one setting, that setting, and what it is now."""
    for key, values in (("slash", ("first", "all")), ("angles", (None, "degrees"))):
        now = getattr(notation, key)
        for value in values:
            if value != now:
                other = notation.model_copy(update={key: value})
                yield other, f"{key}: {value or 'none'}", f"{key}: {now or 'none'}"
    for letter, now in notation.functions.items():
        for function in FUNCTIONS:
            if function != now:
                functions = {**notation.functions, letter: function}
                other = notation.model_copy(update={"functions": functions})
                yield other, f"{letter}: {function}", f"{letter}: {now}"


def _gain(notation: Notation, name: str, context: Context) -> int:
    """How many faulty cells of a claim another notation mends; 0 where it reads the same."""
    claim = context.claims[name]
    other = _under(notation, claim, context)
    return count_faults(claim, context) - count_faults(claim, other) if other else 0


def _under(notation: Notation, claim: Claim, context: Context) -> Context | None:
    """Return the paper with a claim read in another notation; None where it reads the same."""
    loaded = context.loaded
    try:
        tree = read_with(loaded.sources[claim.id], notation, context.names)
    except LatexError:
        return None
    if tree == loaded.trees[claim.id]:
        return None
    paper = loaded.paper.model_copy(update={"notation": notation})
    return replace(
        context, loaded=replace(loaded, paper=paper, trees={**loaded.trees, claim.id: tree})
    )
