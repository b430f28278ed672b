"""The mutation study: what the audit makes of misprints that are planted in true formulas.

Every single misprint of every verified identity is decided as a printed formula is. One that
differs from its original has to be flagged, and its repair has to be an equal of the original; one
that is equal has to be proved so. What differs is judged by 60-digit arithmetic without any engine.
"""

from __future__ import annotations

import json
import random
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property, partial
from pathlib import Path
from typing import Any

from sympy import MatrixBase, Rational, Symbol

from omniproof.audit.context import Context, entries
from omniproof.audit.mending import mend_claim
from omniproof.audit.mutants import KINDS, Mutant, Spelled, mutants
from omniproof.audit.run import prepare_to_judge
from omniproof.audit.voice import Voice
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted
from omniproof.decide.digits import (
    Bound,
    NotEvaluatedError,
    UndefinedError,
    Value,
    are_equal,
    value,
)
from omniproof.decide.in_sympy.digits import known_value
from omniproof.decide.in_sympy.domain import Domain
from omniproof.decide.in_sympy.equality import confirmed_equal
from omniproof.formula.evaluation import evaluate
from omniproof.transcription.entries import entry_source
from omniproof.transcription.model import Claim, Kind, Role
from omniproof.transcription.reader import read_with
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Name, Node, Symbolic

POINTS = 4
PAPERS = Path("paper_data")


class Fate(StrEnum):
    """What became of a mutant; the first four are as they should be."""

    EXPLAINED = "flagged, repaired by one edit"
    POSSIBLE = "flagged, repaired by two edits"
    EQUIVALENT = "equal to the original, proved equal"
    REFUSED = "no formula: refused by the reader"
    UNREPAIRED = "flagged, not repaired"
    MISREPAIRED = "flagged, repaired to something else"
    MISSED = "different from the original, not flagged"
    FALSE_ALARM = "equal to the original, flagged"
    UNDECIDED = "equal to the original, not decided"
    NOT_EVALUATED = "not evaluated: nobody knows whether it is equal to the original"


FLAGGED = (Fate.EXPLAINED, Fate.POSSIBLE, Fate.UNREPAIRED, Fate.MISREPAIRED)


@dataclass(frozen=True)
class Original:
    """A true formula: its text, and what the text times a factor is equal to."""

    claim: str
    text: str
    derived: Any
    factor: Any = 1
    entries: bool = True

    def mutants(self, context: Context) -> list[Mutant]:
        """All single misprints; in a matrix whose entries are originals, those outside of it."""
        node = _read(self.text, context)
        return mutants(self.text, node, _symbols(context), entries=self.entries)


@dataclass(frozen=True)
class Case:
    """One mutant and its fate."""

    claim: str
    original: str
    kind: str
    text: str
    fate: Fate
    correction: str = ""


@dataclass(frozen=True)
class Study:
    """The fates of all mutants, or of a sample of `population` mutants."""

    population: int
    cases: tuple[Case, ...]
    counts: Counter[Fate] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "counts", Counter(case.fate for case in self.cases))

    @property
    def different(self) -> int:
        """Mutants that differ from their originals."""
        return self.flagged + self.counts[Fate.MISSED]

    @property
    def flagged(self) -> int:
        """Mutants that differ and are decided not equal."""
        return sum(self.counts[fate] for fate in FLAGGED)

    @property
    def repaired(self) -> int:
        """Flagged mutants that one edit or two make an equal of the original."""
        return self.counts[Fate.EXPLAINED] + self.counts[Fate.POSSIBLE]

    @property
    def equivalent(self) -> int:
        """Mutants that are equal to their originals."""
        return sum(
            self.counts[fate] for fate in (Fate.EQUIVALENT, Fate.FALSE_ALARM, Fate.UNDECIDED)
        )

    def record(self) -> dict[str, Any]:
        """Return the figures of the study, without times."""
        return {
            "population": self.population,
            "mutants": len(self.cases),
            "refused": self.counts[Fate.REFUSED],
            "different": self.different,
            "flagged": self.flagged,
            "repaired": self.repaired,
            "explained": self.counts[Fate.EXPLAINED],
            "possible": self.counts[Fate.POSSIBLE],
            "equivalent": self.equivalent,
            "proved_equivalent": self.counts[Fate.EQUIVALENT],
            "not_evaluated": self.counts[Fate.NOT_EVALUATED],
            "kinds": {kind: self._kind(kind) for kind in KINDS},
            "failures": [
                {"claim": case.claim, "original": case.original, "mutant": case.text,
                 "fate": case.fate.value, "correction": case.correction}
                for case in self.cases if case.fate not in list(Fate)[:4]
            ],
        }  # fmt: skip

    def _kind(self, kind: str) -> dict[str, int]:
        part = Study(0, tuple(case for case in self.cases if case.kind == kind))
        return {
            "mutants": len(part.cases),
            "different": part.different,
            "flagged": part.flagged,
            "repaired": part.repaired,
        }


def study(papers: Iterable[str], sample: int | None = None, seed: int = 0) -> Study:
    """Plant misprints in the verified identities of papers, all or a seeded sample, and judge them.

    Raises `BadInput` for a paper that cannot be read.
    """
    planted = [
        (original, mutant, context)
        for paper in papers
        for context in [prepare_to_judge(PAPERS / paper)]
        for original in originals(context)
        for mutant in original.mutants(context)
    ]
    generator = random.Random(seed)  # noqa: S311 - a sample, not a secret
    chosen = planted if sample is None else generator.sample(planted, min(sample, len(planted)))
    return Study(len(planted), tuple(fate(*each) for each in chosen))


def write_study(found: Study, path: Path) -> None:
    """Write the figures as JSON."""
    path.write_text(json.dumps(found.record(), indent=1) + "\n", encoding="utf-8")


def originals(context: Context) -> Iterator[Original]:
    """Yield the verified sides of identities, matrices by their printed entries."""
    seen = set()
    for claim in context.loaded.claims:
        if claim.kind is Kind.IDENTITY and not claim.uncheckable:
            for original in _sides(claim, context):
                key = original.text, original.derived
                if key not in seen and _is_verified(original, context):
                    seen.add(key)
                    yield original


def _sides(claim: Claim, context: Context) -> Iterator[Original]:
    derived, text = context.derive_by_mechanics(claim.id), context.printed(claim.id)
    whole = True
    if isinstance(derived, MatrixBase):
        sources = {
            index: entry_source(text, context.loaded.trees[claim.id], index)
            for index in entries(derived)
        }
        if all(sources.values()):
            yield from _entries(claim, context, derived, sources)
            whole = False
    for node in context.sides(claim.id):
        yield Original(claim.id, text[slice(*node.span)], derived, entries=whole)


def _entries(
    claim: Claim, context: Context, derived: MatrixBase, sources: dict[Any, str | None]
) -> Iterator[Original]:
    last = entries(context.evaluate(claim.id, context.sides(claim.id)[-1]))
    for index, entry in entries(derived).items():
        source = sources[index] or ""
        printed = context.value(source, claim.id)
        yield Original(claim.id, source, entry, 1 if printed == 0 else last[index] / printed)


def _is_verified(original: Original, context: Context) -> bool:
    try:
        printed = context.value(original.text, original.claim) * original.factor
    except (LatexError, TypeError):
        return False
    domain = context.domain(original.claim)
    return isinstance(_decide(printed, original.derived, domain), Proved)


def _decide(printed: Any, derived: Any, domain: Domain) -> Answer | None:
    """Decide as the audit does; a matrix by its first entry that is not proved equal."""
    if not isinstance(derived, MatrixBase):
        return (
            None if isinstance(printed, MatrixBase) else confirmed_equal(printed, derived, domain)
        )
    if getattr(printed, "shape", None) != derived.shape:
        return None
    answer: Answer | None = None
    for pair in zip(printed, derived, strict=True):
        answer = confirmed_equal(*pair, domain)
        if not isinstance(answer, Proved):
            break
    return answer


def fate(original: Original, mutant: Mutant, context: Context) -> Case:
    """Judge one mutant, and repair it if it is flagged."""
    case = (original.claim, original.text, mutant.kind, mutant.text)
    try:
        return Case(*case, *_fate(original, mutant.text, context))
    except NotEvaluatedError:
        return Case(*case, Fate.NOT_EVALUATED)


def _fate(original: Original, text: str, context: Context) -> tuple[Fate, str]:
    judge = _Judge(original, context)
    try:
        printed = context.value(text, original.claim) * original.factor
        answer = _decide(printed, original.derived, context.domain(original.claim))
    except (LatexError, TypeError):
        answer = None
    if answer is None:
        return Fate.REFUSED, ""
    # A misprint that holds on a branch only is reported as conditional: it has not slipped through.
    flagged = isinstance(answer, Refuted | OnBranch)
    if judge.is_equal(text):
        equal = Fate.EQUIVALENT if isinstance(answer, Proved) else Fate.UNDECIDED
        return (Fate.FALSE_ALARM if flagged else equal), ""
    if not flagged:
        return Fate.MISSED, ""
    mended = mend_claim(text, original.derived, Voice(original.claim, context), original.factor)
    if mended is None:
        return Fate.UNREPAIRED, ""
    right = Fate.EXPLAINED if mended.size == 1 else Fate.POSSIBLE
    correction = mended.repairs[0].text
    return right if judge.is_equal(correction) else Fate.MISREPAIRED, correction


@dataclass(frozen=True)
class _Judge:
    """Compares a text with its original, to 60 digits at a few rational points."""

    original: Original
    context: Context

    def is_equal(self, text: str) -> bool:
        """Whether a text and the original agree at every point where both are defined.

        Raises `NotEvaluatedError` where the digits reach one of them nowhere.
        """
        node, compared = _read(text, self.context), False
        if node == self.own:
            return True
        for seed in range(POINTS):
            own, other = self.at(self.own, seed), self.at(node, seed)
            if own is not None and other is not None:
                if not are_equal(own, other):
                    return False
                compared = True
        # Defined at no common point is no evidence of being equal.
        return compared

    @cached_property
    def own(self) -> Node:
        return _read(self.original.text, self.context)

    def at(self, node: Node, seed: int) -> Value:
        """Give the value at a point, `None` where there is none."""
        try:
            return value(node, partial(self.meaning, seed))
        except NotEvaluatedError:
            raise
        except UndefinedError:
            return None

    def meaning(self, seed: int, symbol: Symbolic, bound: Bound) -> Value:
        try:
            known = self.known(symbol)
            moved = {self.known(Name(name)).name: x for name, x in bound.items()}
        except LatexError:
            raise NotEvaluatedError(f"{symbol.name} has no meaning") from None
        return _known_value(known, seed, moved)

    def known(self, symbol: Symbolic) -> Any:
        return evaluate(symbol, self.context.meanings_at(self.original.claim, symbol))


_VALUES: dict[tuple[Any, int], Value] = {}


def _known_value(known: Any, seed: int, moved: Mapping[str, Any]) -> Value:
    """Evaluate a quantity, at a point once; inside of an integral its variable moves."""
    point = {symbol.name: _coordinate(symbol, seed) for symbol in known.free_symbols}
    if moved.keys() & point.keys():
        return known_value(known, point | dict(moved), seed)
    if (known, seed) not in _VALUES:
        _VALUES[known, seed] = known_value(known, point, seed)
    return _VALUES[known, seed]


def _coordinate(symbol: Symbol, seed: int) -> Rational:
    """A rational number that is all a symbol's own, the same whenever it is asked for."""
    generator = random.Random(f"{symbol.name} {seed}")  # noqa: S311
    # Far from 0 and from each other, and no plain fraction at which a misprint may hold by chance.
    number = Rational(generator.randint(100, 2_900), 1_000 + generator.randint(1, 99))
    return number if symbol.is_positive or generator.random() < 0.5 else -number


def _read(text: str, context: Context) -> Node:
    return read_with(text, context.loaded.paper.notation, context.names)


def _symbols(context: Context) -> Sequence[Spelled]:
    return [
        Spelled(symbol.latex, symbol_name(symbol.latex), symbol.role is Role.VARIABLE)
        for symbol in context.loaded.paper.symbols
        if symbol.role is not Role.UNDEFINED
    ]
