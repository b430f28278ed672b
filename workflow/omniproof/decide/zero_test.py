"""The exact zero test: proved, refuted by a witness, true on a branch, or undecided with a reason.

The order is what makes it fast. Balls at a few rational points of the domain refute almost every
false formula in a fraction of a millisecond, before polynomials could grow. What they cannot tell
from zero goes to the normal form, which decides, unless both sides are written alike. Only where
absolute values or roots make the truth depend on signs are the sign patterns looked at, and
compared with the domain.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, repeat
from typing import TYPE_CHECKING

from flint import ctx

from omniproof.decide.answer import (
    Answer,
    DisagreementError,
    OnBranch,
    Proved,
    Refuted,
    Undecided,
    Witness,
)
from omniproof.decide.balls import Ball, Program, compile_balls, format_ball, rational_ball
from omniproof.decide.domain import REALS, Domain
from omniproof.decide.normal_form.form import NormalForm, normal_form
from omniproof.decide.normal_form.recurring import vanishes_in_parts
from omniproof.decide.normal_form.survey import is_radical
from omniproof.decide.sampling import REACH, Sample, sample_points
from omniproof.formula.errors import UnsupportedError, WorkLimitError
from omniproof.formula.monomials import expand
from omniproof.formula.term import Term, symbols, walk
from omniproof.formula.where_defined import radicands

if TYPE_CHECKING:
    from omniproof.decide.branches import Branches, Condition

ENGINE = ("flint",)
FIRST_LOOK, SECOND_LOOK, BRANCH_LOOK = 3, 60, 32
LOW, HIGH = 128, 1_024
FAR = (8, 80, 800)  # the first is more than a turn of the slowest angle


def decide_equal(printed: Term, derived: Term, domain: Domain = REALS) -> Answer:
    """Decide whether two terms agree wherever both are defined; a witness shows both values.

    Never raises for a formula: what is outside of the class is `Undecided`.
    """
    try:
        answer = _Question(printed, derived, domain).answer()
        if isinstance(answer, Refuted | OnBranch) and (idle := _cancelled(printed, derived)):
            answer = _Question(printed, derived, domain, idle).answer()
        return answer
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)
    except RecursionError:
        return Undecided("the formula is nested too deeply", ENGINE)


@dataclass(frozen=True)
class _Probe:
    """A rational point, and both sides there, enclosed."""

    point: Sample
    printed: Ball
    derived: Ball

    @property
    def defined(self) -> bool:
        return bool(self.printed.is_finite() and self.derived.is_finite())

    @property
    def differs(self) -> bool:
        return self.defined and not self.printed.overlaps(self.derived)

    def witness(self) -> Witness:
        """Write the point and both values, with as many digits as it takes to see a difference."""
        point = {name: str(value) for name, value in self.point.items()}
        for digits in (4, 8, 16, 32, 64, 128):
            sides = format_ball(self.printed, digits), format_ball(self.derived, digits)
            if sides[0] != sides[1]:
                break
        return Witness(point, *sides)


def _cancelled(*sides: Term) -> frozenset[str]:
    """Names of symbols that multiplying out cancels: a witness does without their values."""
    try:
        left = (part for side in sides for monomial in expand(side) for part, _ in monomial)
        kept = set().union(*map(symbols, left))
    except UnsupportedError:
        return frozenset()
    return frozenset().union(*map(symbols, sides)) - kept


class _Question:
    def __init__(
        self, printed: Term, derived: Term, domain: Domain, idle: frozenset[str] = frozenset()
    ) -> None:
        self.terms, self.domain, self.idle = (printed, derived), domain, sorted(idle)
        self.names = sorted((symbols(printed) | symbols(derived)) - idle)
        self.program: Program = compile_balls(self.terms, self.names + self.idle)

    def form(self) -> NormalForm:
        """Bring the difference of the sides into normal form."""
        return normal_form(*self.terms, self.domain.nonnegative)

    @cached_property
    def branches(self) -> Branches:
        """What puts conditions into words; most formulas need none."""
        from omniproof.decide.branches import Branches

        return Branches(self.terms, self.domain)

    def answer(self) -> Answer:
        """Decide; sides written alike are equal wherever they are defined, if that is anywhere."""
        if self.terms[0] == self.terms[1]:
            return self.proved([])
        # One point where both are defined tells almost all false formulas; the rest take algebra.
        if any(map(_may_branch, chain(*map(walk, self.terms)))):
            return self.answer_with_branches()
        probe = next((probe for probe in self.probes(FIRST_LOOK) if probe.defined), None)
        if probe is None or not probe.differs:
            if self.is_zero():
                return self.proved([probe] if probe else [])
            again = self.probes(SECOND_LOOK, HIGH)
            probe = next((probe for probe in again if probe.differs), None)
        if probe is None:
            return Undecided("no point shows a difference, but no proof was found", ENGINE)
        return Refuted(ENGINE, probe.witness())

    def is_zero(self) -> bool:
        """Ask the normal form; where that grows too large, with symbols for parts that recur."""
        try:
            return self.form().is_zero
        except WorkLimitError:
            if vanishes_in_parts(*self.terms):
                return True
            raise

    def answer_with_branches(self) -> Answer:
        probes = [probe for probe in self.probes(BRANCH_LOOK) if probe.defined]
        differing = [probe for probe in probes if probe.differs]
        if probes and len(differing) == len(probes):
            return Refuted(ENGINE, differing[0].witness())
        form = self.form()
        for radicand in radicands(*self.terms):
            form.presume(radicand, 1)
        if self.is_settled(form):
            if differing:
                raise DisagreementError(f"zero by normal form, not at {differing[0].witness()}")
            return self.proved(probes)
        return self.on_branch(form, probes)

    def is_settled(self, form: NormalForm) -> bool:
        """Whether a form is zero for all signs that its parts can have in the domain."""
        if form.is_zero or all(true for _, true in form.patterns()):
            return True
        if self.domain.is_orthant:
            return False
        self.branches.settle(form)
        return all(true for _, true in form.patterns())

    def on_branch(self, form: NormalForm, probes: list[_Probe]) -> Answer:
        """Answer where the truth depends on signs, that the domain may or may not settle."""
        condition = self.branches.condition(form)
        settled = condition is not None and not condition.parts
        if not settled and not any(probe.differs for probe in probes):
            probes = [*probes, *self.far_probes(form)]
        differing = [probe for probe in probes if probe.differs]
        if not differing:
            return self.without_counterexample(condition)
        witness = differing[0].witness()
        if condition is None or not _is_exact(condition, probes):
            # Sides that agree at a single point, as for L = 1, do so for no choice of signs.
            partly = any(true for _, true in form.patterns())
            return Refuted(ENGINE, witness, "it holds in a part of the domain" if partly else "")
        return OnBranch(ENGINE, condition.latex, witness, relations=condition.relations)

    def far_probes(self, form: NormalForm) -> list[_Probe]:
        """Look further and further out for a difference: cos(x/2) is positive within half a turn.

        Not everywhere, as a witness near zero is easier to check.
        """
        slowest = max(form.converter.found.denominators.values(), default=1)
        probes: list[_Probe] = []
        for reach in FAR:
            probes = [p for p in self.probes(BRANCH_LOOK, reach=reach * slowest) if p.defined]
            if any(probe.differs for probe in probes):
                break
        return probes

    @staticmethod
    def without_counterexample(condition: Condition | None) -> Answer:
        """Answer where no point shows a difference: proved if nothing is left to assume."""
        if condition is None:
            return Undecided("it holds at every point tried, but no proof was found", ENGINE)
        if condition.parts:
            return Undecided(f"it holds where {condition.latex}: not proved for the domain", ENGINE)
        return Proved(ENGINE)

    def proved(self, probes: list[_Probe]) -> Answer:
        """Report a proof, unless the formula is not defined anywhere in the domain."""
        if any(p.defined for p in probes) or any(p.defined for p in self.probes(SECOND_LOOK, HIGH)):
            return Proved(ENGINE)
        return Undecided("no point of the domain was found at which both sides are defined", ENGINE)

    def probes(self, count: int, precision: int = LOW, reach: int = REACH) -> Iterator[_Probe]:
        points = sample_points(self.names, self.domain, count=count, reach=reach)
        others = sample_points(self.idle, Domain(self.domain.ranges), count=count)
        for point, rest in zip(points, others if self.idle else repeat({}), strict=False):
            with ctx.workprec(precision):
                values = [rational_ball(value) for value in (*point.values(), *rest.values())]
                yield _Probe(point, *self.program.run(values))


def _is_exact(condition: Condition, probes: list[_Probe]) -> bool:
    """Whether the sides differ at just those points that miss the condition."""
    return all(probe.differs == condition.is_missed_at(probe.point) for probe in probes)


def _may_branch(term: Term) -> bool:
    """Whether a part is a root or an absolute value of something variable."""
    return is_radical(term) and bool(symbols(term))
