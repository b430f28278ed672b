"""What a corrigendum says: which faults of a paper, put together how, in the paper's order.

It goes to the authors, so it holds only what stands on its own: faults whose source is clear. What
text recognition may have made is asked, not stated. A misprint that recurs is one item with all
its places, and two places that contradict each other are one item too. Formulas that follow from a
premise which mechanics contradicts are no misprints: they stand apart, under the premise.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from omniproof.audit.ledger import Consequence, Ledger, Row, Verdict
from omniproof.audit.places import places
from omniproof.transcription.ids import base
from omniproof.transcription.model import Edition, Kind, Source

LISTED = frozenset({Verdict.ERRATUM, Verdict.MISROUNDED, Verdict.INCONSISTENT})
TOLD = LISTED | {Verdict.MODEL_GAP}
REACHING = frozenset({Consequence.MOTION, Consequence.NUMBER})
_CITES = re.compile(r"xref:(sec|app)-([\w-]+?)-cites-.*")
_SECTIONS = {"sec": "Section {}", "app": "Appendix ({})"}


@dataclass(frozen=True)
class Item:
    """One thing to mend: the rows that one edit, or one decision, settles."""

    rows: tuple[Row, ...]

    @property
    def lead(self) -> Row:
        """The row whose place and address the item has."""
        return self.rows[0]

    @property
    def is_contradiction(self) -> bool:
        """Whether these are places that disagree, of which none is known to be right."""
        return self.lead.kind is Kind.CONSISTENCY

    @property
    def is_table(self) -> bool:
        """Whether these are cells of one table, each with a correction of its own."""
        forms = {(row.printed, row.correction) for row in self.rows}
        return len(forms) > 1 and not self.is_contradiction

    @property
    def is_minor(self) -> bool:
        """Whether the item changes the text only."""
        return not any(row.consequence in REACHING for row in self.rows)

    @property
    def is_clear(self) -> bool:
        """Whether no fault of text recognition would explain it."""
        return all(row.source is Source.CLEAR for row in self.rows)


@dataclass(frozen=True)
class Premise:
    """A premise that mechanics contradicts: where it is made, and what rests on it.

    `formulas` are the claims that would read otherwise, each with all its rows; `statements` are
    in words.
    """

    root: Row
    formulas: tuple[tuple[Row, ...], ...]
    statements: tuple[Row, ...]

    @property
    def supposed(self) -> str:
        """What the premise supposes, in words; empty where no derivation says it."""
        rows = (row for formula in self.formulas for row in formula)
        return next((row.assumption for row in rows if row.assumption), "")


@dataclass(frozen=True)
class Corrigendum:
    """Everything there is to say to the authors of one paper.

    `unlisted` counts the rows that are no matter of a corrigendum, by verdict.
    """

    paper: str
    edition: Edition
    corrections: tuple[Item, ...]
    premises: tuple[Premise, ...]
    contradictions: tuple[Item, ...]
    questions: tuple[Item, ...]
    unlisted: Mapping[Verdict, int]

    @property
    def minor(self) -> tuple[Item, ...]:
        """What is left out first where the space does not hold all."""
        return tuple(item for item in self.corrections if item.is_minor) + self.contradictions


def corrigendum(ledger: Ledger, edition: Edition) -> Corrigendum:
    """Gather the faults of a paper's ledger."""
    faults = [row for row in ledger.rows if row.verdict in LISTED]
    items = _in_order(faults, [*_recurring(faults), *_contradicting(faults)])
    clear = [item for item in items if item.is_clear]
    known = Counter(row.verdict for row in ledger.rows if row.verdict.is_fault)
    return Corrigendum(
        paper=ledger.paper,
        edition=edition,
        corrections=tuple(item for item in clear if not item.is_contradiction),
        premises=_premises(ledger),
        contradictions=tuple(item for item in clear if item.is_contradiction),
        questions=tuple(item for item in items if not item.is_clear),
        unlisted={verdict: n for verdict, n in known.items() if verdict not in TOLD},
    )


def _premises(ledger: Ledger) -> tuple[Premise, ...]:
    """Gather what rests on each premise that mechanics contradicts, in order of place."""
    gaps = [row for row in ledger.rows if row.verdict is Verdict.MODEL_GAP]
    places = {row.id: row for row in gaps}
    resting: dict[str, list[Row]] = {}
    for row in gaps:
        resting.setdefault(row.follows if row.follows in places else row.id, []).append(row)
    return tuple(_premise(places[root], rows, ledger) for root, rows in resting.items())


def _premise(root: Row, rows: Sequence[Row], ledger: Ledger) -> Premise:
    names = dict.fromkeys(base(row.id) for row in rows if row.kind is Kind.IDENTITY)
    return Premise(
        root=root,
        formulas=tuple(tuple(r for r in ledger.rows if base(r.id) == name) for name in names),
        statements=tuple(r for r in rows if r.kind is not Kind.IDENTITY and r is not root),
    )


def _in_order(rows: Sequence[Row], items: Iterable[Item]) -> list[Item]:
    place = {row.id: number for number, row in enumerate(rows)}
    return sorted(items, key=lambda item: place[item.lead.id])


def _recurring(rows: Iterable[Row]) -> list[Item]:
    """Put a misprint with those that follow from it and read alike, and a table's misroundings."""
    found: dict[tuple[str, ...], list[Row]] = {}
    for row in rows:
        if row.kind is Kind.CONSISTENCY:
            continue
        key: tuple[str, ...] = (row.follows or row.id, row.printed, row.correction)
        if row.verdict is Verdict.MISROUNDED:
            key = (base(row.id), row.verdict)
        found.setdefault(key, []).append(row)
    return [Item(tuple(members)) for members in found.values()]


def _contradicting(rows: Iterable[Row]) -> list[Item]:
    """Put the places together that are against each other, directly or by way of a third."""
    places = {row.id: row for row in rows if row.kind is Kind.CONSISTENCY}
    family: dict[str, frozenset[str]] = {}
    for row in places.values():
        named = {row.id, *row.against} & places.keys()
        joined = frozenset(named).union(*(family.get(name, frozenset()) for name in named))
        family.update(dict.fromkeys(joined, joined))
    members = dict.fromkeys(frozenset(names) for names in family.values())
    return [Item(tuple(row for name, row in places.items() if name in m)) for m in members]


def place(claim: str) -> tuple[str, ...]:
    """Return the place of a claim for a reader of the paper; of a reference, the section it is in.

    From the outermost place to the innermost. Raises `ValueError` for what is no id.
    """
    if cited := _CITES.fullmatch(claim):
        number = cited[2].replace("-", ".")
        section = _SECTIONS[cited[1]].format(number.upper() if cited[1] == "app" else number)
        return section, "reference"
    return places(claim)
