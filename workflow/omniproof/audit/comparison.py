r"""Order between two formulas: `<`, `\leq`, `>`, `\geq`, `\neq`, wherever both are defined.

Points refute first. What they do not refute is proved on a box by branch and bound (`signs`), with
one variable also on the whole line: a periodic function on a little more than a period, a rational
one after x = a + t/(1 - t). Everything else is undecided, and says that a range would help.

Values, signs and what z3 is asked come from the printed terms. Conditions, and the forms in which
a proof is tried, are still SymPy's; such a form counts when it is proved to be what is printed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from itertools import compress, islice, product
from math import lcm
from typing import Any, TypeAlias

import sympy as sp
from sympy.core.relational import Relational

from omniproof.audit.balls import exact_number
from omniproof.audit.confirm_order import confirmed_order, region_of
from omniproof.audit.exact import subtract
from omniproof.audit.quotient import OnBox
from omniproof.audit.sampling import sample_points
from omniproof.audit.sign_chart import recognise
from omniproof.audit.signs import guarded, not_on_faces, sign_on
from omniproof.audit.sympy_domain import REALS, Domain
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided, Witness
from omniproof.decide.balls import compile_balls, enclose, format_ball, rational_ball, sign_of
from omniproof.decide.direct import NOWHERE
from omniproof.decide.exact import sign
from omniproof.decide.normal_form.angles import read_angle
from omniproof.decide.normal_form.form import normal_form
from omniproof.decide.order.evident import is_evident
from omniproof.decide.z3.order import Nowhere, Region, Somewhere, find_point
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import CIRCULAR_FUNCTIONS, positive_names, term_of
from omniproof.formula.term import Symbol, Term, substitute, symbols
from omniproof.formula.term import subtract as difference_of
from omniproof.formula.value import Comparison

ENGINE = ("flint",)
WANTED = {"<": -1, "\\leq": -1, ">": 1, "\\geq": 1}
FAILS = {"<": "\\geq", "\\leq": ">", ">": "\\leq", "\\geq": "<", "\\neq": "="}
STEPS = 300_000
"""More than a confirmation is given: here z3 is the only one left."""
MOST_CANDIDATES = 30
ADVICE = "no proof was found without a bounded range for each symbol"
ELSEWHERE = "it was found to fail only where a printed part is not defined"
PROBES = 60
LARGEST_SHORT = 10**100
"""Beyond it no short number is near, and its square would soon be beyond floats."""
Point: TypeAlias = Mapping[sp.Symbol, Any]
Terms: TypeAlias = tuple[Term, Term]


def compare(
    left: sp.Expr,
    operator: str,
    right: sp.Expr,
    domain: Domain = REALS,
    terms: Terms | None = None,
) -> Answer:
    r"""Decide whether `left operator right` holds at every point where both sides are defined.

    `terms` are the sides as they are printed, before SymPy had an idea of them.
    With one variable on a bounded range, what holds in parts is `OnBranch` with the exact set.
    What is not decided is `Undecided`. Raises `DisagreementError` when z3 contradicts the balls.
    """
    return guarded(lambda: _Comparison(left, operator, right, domain, terms).confirmed())


class _Comparison:
    def __init__(
        self, left: sp.Expr, operator: str, right: sp.Expr, domain: Domain, terms: Terms | None
    ) -> None:
        self.left, self.operator, self.right = left, operator, right
        self.terms = terms or (term_of(left), term_of(right))
        self.printed = difference_of(*self.terms)
        self.domain = domain
        self.difference = subtract(left, right)
        self.symbols = sorted(self.difference.free_symbols, key=str)
        self.box = {s: domain.interval(s.name) for s in self.symbols}
        self.closed = {s: domain.closed.get(s.name, (False, False)) for s in self.symbols}
        self.bounded = all(sp.oo not in (-a, b) for a, b in self.box.values())

    def confirmed(self) -> Answer:
        answer = self.where_asserted(self.answer())
        return confirmed_order(answer, [self.failure], self.region)

    def where_asserted(self, answer: Answer) -> Answer:
        """Look for another witness, or a proof, where a witness is outside of the conditions."""
        if not isinstance(answer, Refuted | OnBranch):
            return answer
        if self.meets_conditions(self.place(answer.witness)):
            return answer
        if wrong := self.counterexample():
            return replace(answer, witness=self.witness(wrong))
        if self.is_evident():
            return Proved(ENGINE)
        return self.by_algebra() or Undecided(ELSEWHERE, ENGINE)

    @property
    def failure(self) -> Comparison:
        """How the printed sides stand at a counterexample."""
        left, right = self.terms
        return Comparison(left, FAILS[self.operator], right)

    @cached_property
    def region(self) -> Region:
        """Where z3 looks for one."""
        sides = self.left, self.right
        return region_of(self.box, self.closed, self.domain.conditions, sides)

    @cached_property
    def cancelled(self) -> dict[str, Term]:
        """Values of the symbols that are printed and cancel, so that nothing is said of them."""
        others = symbols(self.printed).difference(symbol.name for symbol in self.symbols)
        drawn = sample_points([sp.Symbol(name, real=True) for name in others], self.domain, count=1)
        point = next(drawn, None)
        if point is None:
            raise UnsupportedError(NOWHERE)
        return {symbol.name: term_of(exact_number(x)) for symbol, x in point.items()}

    def answer(self) -> Answer:
        if not self.symbols:
            return self.of_numbers()
        if self.operator == "\\neq":
            return Proved(ENGINE) if self.is_evident() else self.unequal()
        return self.bounded_order() if self.bounded else self.unbounded_order()

    def bounded_order(self) -> Answer:
        family = OnBox(self.difference, self.box, self.printed)
        wanted = WANTED[self.operator]
        answer = sign_on(family, wanted, zero=self.may_vanish, closed=self.closed)
        if not isinstance(answer, Undecided):
            return self.with_sides(answer)
        return self.refuted() or self.by_algebra() or answer

    def unbounded_order(self) -> Answer:
        answer = self.refuted() or (Proved(ENGINE) if self.is_evident() else self.on_the_line())
        if isinstance(answer, Proved):
            family = OnBox(self.difference, self.box, self.printed)
            faces = not_on_faces(family, WANTED[self.operator], self.may_vanish, self.closed)
            answer = answer if faces is None else self.with_sides(faces)
        return self.by_algebra() or answer if isinstance(answer, Undecided) else answer

    def refuted(self) -> Refuted | None:
        wrong = self.counterexample()
        return None if wrong is None else Refuted(ENGINE, self.witness(wrong))

    @property
    def may_vanish(self) -> bool:
        return self.operator in {"\\leq", "\\geq"}

    def of_numbers(self) -> Answer:
        true = self.holds_at({})
        return Proved(ENGINE) if true else Refuted(ENGINE, self.witness({}))

    def holds_at(self, point: Point) -> bool:
        """Whether the statement is true at an exact point; raises `UnsupportedError` at a pole."""
        found = sign(self.at(self.printed, point))
        if self.operator == "\\neq":
            return found != 0
        return found == WANTED[self.operator] or (found == 0 and self.may_vanish)

    def at(self, term: Term, point: Point) -> Term:
        """Put an exact point into a printed term, all coordinates at once."""
        values = {symbol.name: term_of(value) for symbol, value in point.items()}
        return substitute(term, self.cancelled | values)

    def counterexample(self) -> Point | None:
        """Look for a point where the statement is false: 0 and 1 first, where equality hides."""
        for value in (sp.S.Zero, sp.S.One):
            point = dict.fromkeys(self.symbols, value)
            if self.is_counterexample(point):
                return point
        if self.operator == "\\neq":
            return None
        names = [symbol.name for symbol in self.symbols]
        program = compile_balls([substitute(self.printed, self.cancelled)], names)
        wrong = -WANTED[self.operator]
        for sample in sample_points(self.symbols, self.domain, count=PROBES):
            if sign_of(program.run([rational_ball(x) for x in sample.values()])[0]) == wrong:
                return {symbol: exact_number(x) for symbol, x in sample.items()}
        return None

    def is_inside(self, symbol: sp.Symbol, value: Any) -> bool:
        lower, upper = self.box[symbol]
        if value in compress((lower, upper), self.closed[symbol]):
            return True
        return bool(lower < value) and bool(value < upper)

    def witness(self, point: Point) -> Witness:
        """Write a point with the values of both sides, in as many digits as tell them apart."""
        balls = [enclose(self.at(side, point)) for side in self.terms]
        shown = [[format_ball(ball, digits) for ball in balls] for digits in (4, 8, 16, 32)]
        values = next((pair for pair in shown if pair[0] != pair[1]), shown[0])
        exact = {symbol.name: value for symbol, value in point.items()}
        return Witness({name: str(value) for name, value in exact.items()}, *values, exact=exact)

    def with_sides(self, answer: Answer) -> Answer:
        """Show both sides instead of their difference, at the point of a witness."""
        if not isinstance(answer, Refuted | OnBranch):
            return answer
        place = self.place(answer.witness)
        # Outside of the conditions a side may have no value; another witness is looked for later.
        met = self.meets_conditions(place)
        return replace(answer, witness=self.witness(place)) if met else answer

    def place(self, witness: Witness) -> Point:
        """Read the point of a witness; a symbol that does not matter to it gets any value."""
        known = witness.exact
        others = {}
        if any(symbol.name not in known for symbol in self.symbols):
            others = next(sample_points(self.symbols, self.domain, count=1), {})
        return {
            symbol: known.get(symbol.name, exact_number(others.get(symbol, 1)))
            for symbol in self.symbols
        }

    def is_evident(self) -> bool:
        """Prove the sign from the form: of what is printed, multiplied out, or as a product.

        SymPy proposes the other forms; that they are the same is proved before they count.
        """
        divisors = (c.lhs for c in self.domain.conditions if isinstance(c, sp.Ne) and c.rhs == 0)
        apart = frozenset(map(term_of, divisors))
        relation, assumed = self.operator, self.region.assumed
        if is_evident(self.printed, relation, assumed, apart):
            return True
        forms = (form(self.left - self.right) for form in (sp.expand, sp.factor))
        return any(
            is_evident(form, relation, assumed, apart) and self.is_printed(form)
            for form in map(term_of, forms)
        )

    def is_printed(self, form: Term) -> bool:
        """Whether a form has the value of the printed difference, wherever that is defined."""
        positive = positive_names(self.left, self.right)
        return normal_form(self.printed, form, positive).is_zero

    def on_the_line(self) -> Answer:
        """Decide for one variable without bounds, on an interval that covers all its values."""
        family, place = self.compact() if len(self.symbols) == 1 else (None, None)
        if family is None or place is None:
            return Undecided(ADVICE, ENGINE)
        answer = sign_on(family, WANTED[self.operator], zero=self.may_vanish)
        if not isinstance(answer, Refuted | OnBranch):
            return answer
        ((own, _),) = family.box.items()
        value = place.subs(own, answer.witness.exact[own.name])
        point = {self.symbols[0]: value}
        if not self.meets_conditions(point):
            return Undecided(ELSEWHERE, ENGINE)
        return Refuted(ENGINE, self.witness(point))

    def by_algebra(self) -> Answer | None:
        """Ask z3 for a counterexample; a point counts only where it is confirmed exactly."""
        found = find_point([self.failure], self.region, steps=STEPS)
        if isinstance(found, Nowhere):
            return Proved(("z3",))
        if isinstance(found, Somewhere):
            near = _points_near({symbol: found.point[symbol.name] for symbol in self.symbols})
            for point in islice(near, MOST_CANDIDATES):
                if self.is_counterexample(point):
                    return Refuted((*ENGINE, "z3"), self.witness(point))
        return None

    def is_counterexample(self, point: Point) -> bool:
        """Whether an exact point is in the domain, and the statement certainly false there."""
        try:
            inside = all(self.is_inside(symbol, value) for symbol, value in point.items())
            return inside and self.meets_conditions(point) and not self.holds_at(point)
        except UnsupportedError:
            return False

    def meets_conditions(self, point: Point) -> bool:
        """Whether all conditions certainly hold at an exact point; of other symbols, none does."""
        return all(_is_met(condition, point) for condition in self.domain.conditions)

    def compact(self) -> tuple[OnBox | None, sp.Expr | None]:
        """Put the variable on a bounded interval; returns also what it is there."""
        (symbol,), (range_,) = self.symbols, self.box.values()
        calls = self.difference.atoms(*CIRCULAR_FUNCTIONS)
        if not calls:
            t = sp.Symbol("t", real=True)
            place, side = _compact(t, *range_)
            printed = substitute(self.printed, {symbol.name: term_of(place)})
            return OnBox(self.difference.subs(symbol, place), {t: side}, printed), place
        rest = self.difference.xreplace({call: sp.Dummy() for call in calls})
        angles = [read_angle(term_of(call.args[0])).multiples for call in calls]
        only = frozenset({(Symbol(symbol.name), 1)})
        if symbol in rest.free_symbols or any(set(angle) != {only} for angle in angles):
            return None, None
        period = 2 * sp.pi * lcm(*(angle[only].denominator for angle in angles))
        return OnBox(self.difference, {symbol: (-sp.S.One, period)}, self.printed), symbol

    def unequal(self) -> Answer:
        """Decide `a != b`: one sign throughout, or the zeros in closed form."""
        if not self.bounded:
            return self.by_algebra() or Undecided(ADVICE, ENGINE)
        family = OnBox(self.difference, self.box, self.printed)
        answers = [sign_on(family, wanted, closed=self.closed) for wanted in (1, -1)]
        if any(isinstance(answer, Proved) for answer in answers):
            return Proved(ENGINE)
        (symbol, *others) = self.symbols
        parts = [answer for answer in answers if isinstance(answer, OnBranch)]
        if others or not parts:
            missed = Undecided("the points where both sides agree were not found", ENGINE)
            return self.by_algebra() or missed
        zeros = sorted(self.zeros(symbol, parts), key=float)
        if not zeros:
            return Proved(ENGINE)
        condition = ",\\; ".join(f"{sp.latex(symbol)} \\neq {sp.latex(zero)}" for zero in zeros)
        witness = self.witness({symbol: zeros[0]})
        relations = tuple(sp.Ne(symbol, zero) for zero in zeros)
        return OnBranch(ENGINE, condition, witness, relations=relations)

    def zeros(self, symbol: sp.Symbol, parts: list[OnBranch]) -> set[Any]:
        ends = {
            end
            for part in parts
            for relation in part.relations
            for inequality in relation.atoms(Relational)
            for end in inequality.args
            if not end.free_symbols and (end not in self.box[symbol] or self.is_inside(symbol, end))
        }
        return {end for end in ends if self.vanishes_at({symbol: end})}

    def vanishes_at(self, point: Point) -> bool:
        try:
            return self.meets_conditions(point) and sign(self.at(self.printed, point)) == 0
        except UnsupportedError:
            return False


def _is_met(condition: Relational, point: Point) -> bool:
    difference = (condition.lhs - condition.rhs).xreplace(dict(point))
    if difference.free_symbols:
        return True
    try:
        return bool(condition.func(sign(term_of(difference)), 0))
    except UnsupportedError:
        return False


def _points_near(point: Mapping[sp.Symbol, Fraction]) -> Iterator[Point]:
    """Yield exact points: with coordinates in closed form first, then rational ones."""
    choices = [[*_closed_forms(value), sp.Rational(value)] for value in point.values()]
    return (dict(zip(point, values, strict=True)) for values in product(*choices))


def _closed_forms(value: Fraction) -> Iterator[sp.Expr]:
    """Yield multiples of pi, short rationals, and roots of them, where a short one can be close."""
    if abs(value) > LARGEST_SHORT:
        return
    yield from recognise(float(value))
    if value != 0:
        yield from (sp.sign(value) * sp.sqrt(square) for square in recognise(float(value) ** 2))
    yield sp.Rational(value.limit_denominator(1000))


def _compact(t: sp.Symbol, lower: Any, upper: Any) -> tuple[sp.Expr, tuple[Any, Any]]:
    """Write an unbounded variable as a function of t on a bounded interval."""
    one, zero = sp.Integer(1), sp.Integer(0)
    if lower == -sp.oo and upper == sp.oo:
        return t / (1 - t**2), (-one, one)
    return (upper - t / (1 - t) if lower == -sp.oo else lower + t / (1 - t)), (zero, one)
