"""What a paper prints, held against a formula that a chapter derives before the reader's eyes.

    printed("omni-arrangement", "eq:7").agrees_with(det)
    printed("omni-arrangement", "eq:6[2,3]").should_be(entry, but_is=misprint)

The sentence around such a line is true only while the engines say so. The claim is read from the
paper's data and judged there and then, and a line that does not hold stops the chapter.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any, NoReturn

import sympy as sp

from omniproof.audit.context import Context, entries, flat
from omniproof.audit.decimals import read_decimal
from omniproof.audit.judge import judge_claim
from omniproof.audit.ledger import Row, Verdict
from omniproof.audit.run import choose_reading, open_to_judge
from omniproof.decide.answer import OnBranch, Proved, Refuted
from omniproof.decide.in_sympy.equality import confirmed_equal
from omniproof.registry import Fit
from omniproof.report.fragments.base import Fragment, worst
from omniproof.report.fragments.printed import printed_beside
from omniproof.report.paper_context import paper_folder
from omniproof.transcription.faults import nearest
from omniproof.transcription.ids import base, index
from omniproof.transcription.model import Claim, Kind
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError

LONGEST_TO_MEND = 200
"""Characters of a formula whose misprint is marked: to look for the edit that mends an integral of
this length takes a second, and the chapter shows the right form anyway."""


class StaleTextError(AssertionError):
    """A chapter says of a printed formula what is not so, or not so any more."""


@dataclass(frozen=True)
class Printed:
    """One printed formula, matrix, entry or number, and its rows as the audit judges them.

    `latex` is verbatim, `value` what it says by the paper's notation, `derived` what it ought to
    say: SymPy, in the paper's symbols. `id` may be an entry of the matrix that is `claim`.
    """

    id: str
    claim: str
    latex: str
    value: Any
    derived: Any
    rows: tuple[Row, ...] = field(repr=False)
    context: Context = field(repr=False)

    def agrees_with(self, formula: Any) -> Fragment:
        """Show that print is right, and that `formula` (SymPy) is what it was judged by.

        Letters are the paper's, by their looks or by the `name` in its data; others raise
        `ValueError`. Raises `StaleTextError` where the audit or the engines say otherwise.
        """
        own = self._judged_by(formula)
        if self.verdict is not Verdict.VERIFIED:
            self._stale("it is right", f"it is judged {self.verdict}")
        return self._shown(own)

    def should_be(self, formula: Any, *, but_is: Any) -> Fragment:
        """Show that print has a fault: it ought to say `formula`, and says `but_is`.

        Letters and errors as in `agrees_with`.
        """
        own, misprint = self._judged_by(formula), self._in_letters(but_is)
        if not self.verdict.is_fault:
            self._stale("it has a fault", f"it is judged {self.verdict}")
        if differs := self._difference(self.value, misprint):
            self._stale(f"it says `{self._written(misprint)}`", f"print {differs}")
        return self._shown(own)

    @property
    def verdict(self) -> Verdict:
        """The verdict; of a matrix the gravest one."""
        return worst(self.rows)

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex}$"

    def _shown(self, own: Any) -> Fragment:
        return printed_beside(self.id, self.latex, self.context.spelling.latex(own), self.rows)

    def _judged_by(self, formula: Any) -> Any:
        """Return a formula in the paper's letters; it has to be what the audit derives."""
        own = self._in_letters(formula)
        if differs := self._difference(self.derived, own):
            self._stale(f"it has to be `{self._written(own)}`", f"what mechanics gives {differs}")
        return own

    def _difference(self, right: Any, own: Any) -> str:
        """Say how a formula of the chapter differs; nothing where both are proved equal."""
        if getattr(right, "shape", ()) != getattr(own, "shape", ()):
            return "has another shape"
        domain = self.context.domain(self.claim)
        for pair in zip(flat(right), flat(own), strict=True):
            match confirmed_equal(*pair, domain):
                case Proved():
                    continue
                case Refuted(witness=witness) | OnBranch(witness=witness):
                    point = ", ".join(f"{name} = {x}" for name, x in witness.point.items())
                    here = f" at {point}" if point else ""
                    return f"is {witness.printed} where that is {witness.derived}{here}"
                case unknown:
                    return f"is not proved to be that: {unknown.reason}"
        return ""

    def _stale(self, said: str, found: str) -> NoReturn:
        raise StaleTextError(
            f"{self.context.loaded.paper.key} {self.id}: the chapter says of `{self.latex}` that "
            f"{said}, but {found}; mend the chapter, its text or what it derives"
        )

    def _in_letters(self, formula: Any) -> Any:
        """Write a formula in the symbols of the paper."""
        own = sp.sympify(formula, strict=True)
        return own.xreplace({letter: self._letter(letter) for letter in own.free_symbols})

    def _letter(self, letter: sp.Symbol) -> Any:
        """Return what a letter stands for in the paper, or in the lemma that the claim is."""
        lemma = self.context.derivation(self.claim).meanings()
        if letter.name in lemma:
            return lemma[letter.name]
        known = self.context.loaded.symbols
        names = {symbol.name: looks for looks, symbol in known.items()}
        try:
            looks = symbol_name(sp.latex(letter))
        except LatexError:
            looks = letter.name
        found = looks if looks in known else names.get(letter.name)
        if found is None:
            paper, cure = self.context.loaded.paper.key, _near(letter.name, names)
            raise ValueError(f"{paper} has no symbol `{letter}`{cure}")
        return self.context.meaning(found)

    def _written(self, formula: Any) -> str:
        return self.context.spelling.latex(formula) or "…"


def printed(paper: str, claim: str) -> Printed:
    """Read a claim of a paper, and judge it; raises `ValueError` for none that has a value.

    `claim`: an identity (`eq:7`), an entry of a matrix (`eq:6[2,3]`), or a number (`tab:2[X,D_V]`).
    """
    folder = paper_folder(paper)
    context = _context(folder, tuple(file.stat().st_mtime_ns for file in sorted(folder.iterdir())))
    own = context.claims.get(claim) or context.claims.get(base(claim))
    derived = own is not None and own.id in context.registry.derivations
    if own and derived:
        choose_reading(own.id, context)
    mends = len(context.printed(claim)) <= LONGEST_TO_MEND
    rows = judge_claim(own, replace(context, mends=mends)) if own and derived else []
    rows = [row for row in rows if claim in {row.id, base(row.id)}]
    if own is None or not rows:
        raise ValueError(f"{paper} derives no claim `{claim}`{_near(claim, context.claims)}")
    sides, latex = _sides(own, context), own.printed or context.printed(own.id)
    if own.id != claim:
        place = tuple(map(int, index(claim)))
        sides, latex = tuple(entries(side)[place] for side in sides), rows[0].printed
    return Printed(claim, own.id, latex, *sides, tuple(rows), context)


def _sides(claim: Claim, context: Context) -> tuple[Any, Any]:
    """Return what a claim prints, and what the audit derives for it."""
    derived = context.derive_by_mechanics(claim.id)
    if claim.kind is Kind.IDENTITY:
        return context.evaluate(claim.id, context.sides(claim.id)[-1]), derived
    if claim.kind is Kind.VALUE and not isinstance(derived, Fit):
        return sp.Rational(read_decimal(str(claim.printed)).value), derived
    raise ValueError(f"{context.loaded.paper.key} {claim.id} is no single formula or number")


def _near(word: str, known: Iterable[str]) -> str:
    cure = nearest(word, known)
    return f": {cure}" if cure else ""


@cache
def _context(folder: Path, state: tuple[int, ...]) -> Context:
    """Load a paper once, and again when a file of it has changed meanwhile."""
    return open_to_judge(folder)
