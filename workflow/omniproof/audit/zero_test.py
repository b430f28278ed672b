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
from typing import Any, TypeAlias

import sympy as sp
from flint import ctx

from omniproof.audit.balls import evaluate, exact_number
from omniproof.audit.branches import Condition, find_condition
from omniproof.audit.exact import subtract
from omniproof.audit.hypotheses import interior, settle
from omniproof.audit.quotient import OnBox
from omniproof.audit.sampling import REACH, Sample, by_name, sample_points
from omniproof.audit.signs import sign_on
from omniproof.audit.sympy_domain import REALS, Domain
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided, Witness
from omniproof.decide.balls import Ball, Program, compile_balls, format_ball, rational_ball
from omniproof.decide.normal_form.form import NormalForm, normal_form
from omniproof.decide.normal_form.recurring import vanishes_in_parts
from omniproof.decide.normal_form.survey import is_radical
from omniproof.formula.errors import UnsupportedError, WorkLimitError
from omniproof.formula.sympy_terms import positive_names, term_of
from omniproof.formula.term import Term, symbols, walk

ENGINE = ("flint",)
FIRST_LOOK, SECOND_LOOK, BRANCH_LOOK = 3, 60, 32
LOW, HIGH = 128, 1_024
FAR = (8, 80, 800)  # the first is more than a turn of the slowest angle
Terms: TypeAlias = tuple[Term, Term]
UNDEFINED = (sp.nan, sp.zoo, sp.oo, -sp.oo)


def both_terms(left: Any, right: Any) -> Terms | None:
    """Return two sides as a pair of terms; None where one is none, as a number by cases is."""
    return (left, right) if isinstance(left, Term) and isinstance(right, Term) else None


class DisagreementError(RuntimeError):
    """Balls and normal form contradict each other: a defect of the engine, never of a formula."""


def decide(expression: sp.Expr, domain: Domain = REALS) -> Answer:
    """Decide whether a formula is zero at every point of the domain where it is defined.

    Symbols are real. Never raises for a formula: what is outside of the class is `Undecided`.
    """
    return _guarded(exact_number(expression), sp.S.Zero, domain)


def decide_equal(
    printed: sp.Expr, derived: sp.Expr, domain: Domain = REALS, terms: Terms | None = None
) -> Answer:
    """Decide whether two formulas agree wherever both are defined; a witness shows both values.

    `terms` are the sides as they are printed, before SymPy had an idea of them.
    """
    printed, derived = exact_number(printed), exact_number(derived)
    answer = _guarded(printed, derived, domain, terms)
    return (isinstance(answer, Undecided) and _undefined(printed, derived)) or answer


def _undefined(printed: sp.Expr, derived: sp.Expr) -> Answer | None:
    """Answer where a side is undefined as it stands, which balls refuse."""
    undefined = [side.has(*UNDEFINED) for side in (printed, derived)]
    if all(undefined):
        return Undecided("both sides contain a division by zero or another undefined value")
    return _one_side_undefined(printed, derived, undefined[0]) if any(undefined) else None


def _one_side_undefined(printed: sp.Expr, derived: sp.Expr, left: bool) -> Answer:
    words = ["undefined", sp.sstr(derived)] if left else [sp.sstr(printed), "undefined"]
    side = "printed" if left else "derived"
    return Refuted(ENGINE, Witness({}, *words), f"the {side} side is nowhere defined")


def _guarded(
    printed: sp.Expr, derived: sp.Expr, domain: Domain, terms: Terms | None = None
) -> Answer:
    try:
        sides = terms or (term_of(printed), term_of(derived))
        return _Question(printed, derived, domain, sides).answer()
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
        point = {symbol.name: str(value) for symbol, value in self.point.items()}
        for digits in (4, 8, 16, 32, 64, 128):
            sides = format_ball(self.printed, digits), format_ball(self.derived, digits)
            if sides[0] != sides[1]:
                break
        return Witness(point, *sides)


class _Question:
    """The engines look at `terms`; a condition is put into words by SymPy's idea of them."""

    def __init__(self, printed: sp.Expr, derived: sp.Expr, domain: Domain, terms: Terms) -> None:
        self.printed, self.derived, self.domain = printed, derived, interior(domain)
        self.terms = terms
        known = printed.free_symbols | derived.free_symbols
        self.symbols = sorted(known, key=by_name)
        names = [symbol.name for symbol in self.symbols]
        # What cancels is printed and does not matter: it has values, and no place in a witness.
        others = sorted(set().union(*map(symbols, terms)).difference(names))
        self.others = [sp.Symbol(name, real=True) for name in others]
        self.program: Program = compile_balls(terms, names + others)

    @cached_property
    def difference(self) -> sp.Expr:
        """The formula whose parts a condition is written in; not needed where there is none."""
        return subtract(self.printed, self.derived)

    def form(self) -> NormalForm:
        """Bring the difference of the sides into normal form."""
        return normal_form(*self.terms, positive_names(self.printed, self.derived))

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
            return Undecided("it is no identity, but no point shows a difference", ENGINE)
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
        settle(form, self.difference, self.domain)
        if form.is_zero or all(true for _, true in form.patterns()):
            if differing:
                raise DisagreementError(f"zero by normal form, not at {differing[0].witness()}")
            return self.proved(probes)
        return self.on_branch(form, probes)

    def on_branch(self, form: NormalForm, probes: list[_Probe]) -> Answer:
        """Answer where the truth depends on signs, that the domain may or may not settle."""
        condition = self.condition(form)
        settled = condition is not None and not condition.parts
        if not settled and not any(probe.differs for probe in probes):
            probes = [*probes, *self.far_probes(form)]
        differing = [probe for probe in probes if probe.differs]
        if not differing:
            return self.without_counterexample(condition)
        witness = differing[0].witness()
        if condition is None or not self.is_exact(condition, probes):
            # Sides that agree at a single point, as for L = 1, do so for no choice of signs.
            partly = any(true for _, true in form.patterns())
            return Refuted(ENGINE, witness, "it holds in a part of the domain" if partly else "")
        return OnBranch(ENGINE, condition.latex, witness, relations=condition.relations)

    def condition(self, form: NormalForm) -> Condition | None:
        """Find the condition, without the parts of it that the domain settles."""
        condition = find_condition(form, self.difference)
        if condition is None:
            return None
        parts = (part for part in condition.parts if not self.is_positive(part))
        return Condition(tuple(parts), condition.strict)

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

    @staticmethod
    def is_exact(condition: Condition, probes: list[_Probe]) -> bool:
        """Whether the sides differ at just those points that miss the condition."""
        return all(
            probe.differs == any(evaluate(part, probe.point) < 0 for part in condition.parts)
            for probe in probes
        )

    def is_positive(self, part: sp.Expr) -> bool:
        """Prove that a formula is positive everywhere in the domain."""
        sides = {s: self.domain.intervals[s.name] for s in part.free_symbols if self.is_limited(s)}
        rest = part.free_symbols - set(sides)
        shifted = part.subs({symbol: self.shifted(symbol) for symbol in rest})
        if not sides or rest:
            return bool(sp.expand(shifted).is_nonnegative)
        return isinstance(sign_on(OnBox(part, sides), 1), Proved)

    def is_limited(self, symbol: sp.Symbol) -> bool:
        """Whether the domain of a symbol is bounded."""
        lower, upper = self.domain.interval(symbol.name)
        return lower != -sp.oo and upper != sp.oo

    def shifted(self, symbol: sp.Symbol) -> sp.Expr:
        """Write a symbol that is bounded on one side by a positive one."""
        lower, upper = self.domain.interval(symbol.name)
        positive = sp.Symbol(symbol.name, positive=True)
        if lower == -sp.oo:
            return symbol if upper == sp.oo else upper - positive
        return lower + positive

    def proved(self, probes: list[_Probe]) -> Answer:
        """Report a proof, unless the formula is not defined anywhere in the domain."""
        if any(p.defined for p in probes) or any(p.defined for p in self.probes(SECOND_LOOK, HIGH)):
            return Proved(ENGINE)
        return Undecided("no point of the domain was found at which both sides are defined", ENGINE)

    def probes(self, count: int, precision: int = LOW, reach: int = REACH) -> Iterator[_Probe]:
        points = sample_points(self.symbols, self.domain, count=count, reach=reach)
        others = sample_points(self.others, count=count) if self.others else repeat(Sample())
        for point, rest in zip(points, others, strict=False):
            with ctx.workprec(precision):
                values = [rational_ball(value) for value in (*point.values(), *rest.values())]
                yield _Probe(point, *self.program.run(values))


def _may_branch(term: Term) -> bool:
    """Whether a part is a root or an absolute value of something variable."""
    return is_radical(term) and bool(symbols(term))
