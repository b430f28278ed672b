"""Numbers from a set-up that the paper does not state, or states wrongly.

Which set-ups give all cells of a table, each decimal rounded or truncated? A cell is right when one
of them gives it by rounding, misrounded when all of them give it by truncation; a cell that the
set-up of the derivation does not give is judged for itself, and says nothing of others. A printed
number of the set-up is right when it is among the solutions. Otherwise it contradicts the cells,
and only the author knows which of both was simulated.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

from omniproof.audit.confirm_decimals import confirmed_class
from omniproof.audit.context import Context
from omniproof.audit.decimals import DecimalFinding
from omniproof.audit.evidence import Counterexample, Interval
from omniproof.audit.ledger import Repair, Row, Verdict
from omniproof.audit.ranges import Reading, decimal_range
from omniproof.audit.rows import answered, start, with_note
from omniproof.audit.setups import Cell, Solution, check_setup, contradicting, solve
from omniproof.decide.answer import Undecided
from omniproof.formula.errors import UnsupportedError
from omniproof.registry import Fit
from omniproof.transcription.model import Claim

Found = TypeVar("Found")


def judge_fit(claim: Claim, fit: Fit, context: Context) -> Row:
    """Judge a printed number of a set-up, or one that follows from it."""
    row = start(claim, context).model_copy(update={"derived": context.spelling.latex(fit.value)})
    others = (context.claims[name] for name in fit.cells if name != claim.id)
    cells = [_cell(other, context.derive(other.id)) for other in others]
    try:
        wrong = contradicting(_sure(check_setup(cells, fit.setup)), Reading.EITHER)
        cells = [cell for cell in cells if cell.name not in wrong]
        return _Question(row, _cell(claim, fit), cells, fit).judged()
    except UnsupportedError as reason:
        return answered(row, Undecided(str(reason)), context)


def _cell(claim: Claim, fit: Fit) -> Cell:
    return Cell(claim.id, str(claim.printed), fit.value)


def _sure(found: Found | Undecided) -> Found:
    if isinstance(found, Undecided):
        raise UnsupportedError(found.reason)
    return found


@dataclass(frozen=True)
class _Question:
    """A printed number beside the other cells of its set-up."""

    row: Row
    own: Cell
    others: list[Cell]
    fit: Fit

    @cached_property
    def finding(self) -> DecimalFinding:
        """The number in the set-up that the derivation names."""
        value = self.fit.value.xreplace(dict(self.fit.setup))
        return _sure(confirmed_class(value, self.own.printed))

    def judged(self) -> Row:
        rounded = self.solved(Reading.ROUNDED)
        if rounded.pieces:
            return self.decided(Verdict.VERIFIED, rounded)
        truncated = self.solved(Reading.TRUNCATED)
        if truncated.pieces:
            row = self.decided(Verdict.MISROUNDED, truncated)
            return self.mended(row, "truncated in every set-up that gives all cells")
        row = self.decided(Verdict.INCONSISTENT, self.solved(None))
        against = tuple(name for name in rounded.contradiction if name != self.own.name)
        row = row.model_copy(update={"against": against})
        return self.mended(row, f"differs from {', '.join(against)}")

    def solved(self, reading: Reading | None) -> Solution:
        """Solve the cells with this number, rounded or truncated, or without it."""
        cells = [*self.others, replace(self.own, reading=reading)] if reading else self.others
        return _sure(solve(cells, next(iter(self.fit.setup))))

    def decided(self, verdict: Verdict, solution: Solution) -> Row:
        interval = Interval(
            **decimal_range(self.own.interval).model_dump(),
            value=self.finding.digits,
            setup=solution.record(),
            included=verdict is not Verdict.INCONSISTENT,
        )
        update = {"verdict": verdict, "interval": interval, "engines": "flint"}
        return self.row.model_copy(update=update)

    def mended(self, row: Row, note: str) -> Row:
        """Show a set-up that gives the other cells, and what it gives here."""
        used = self.fit.value.free_symbols
        point = {key.name: str(x) for key, x in self.fit.setup.items() if key in used}
        mended = {
            "witness": Counterexample(
                point=point, printed=self.own.printed, derived=self.finding.digits
            ),
            "correction": self.finding.correction,
            "repair": Repair.MANUAL,
        }
        return with_note(row.model_copy(update=mended), note)
