"""A third opinion on small formulas: z3 looks for real numbers at which two sides differ.

The question is put as mechanics would: cos u and sin u are numbers with c^2 + s^2 = 1, and a
difference of fractions is multiplied out (left as fractions, most are answered "unknown"). The
procedure behind it, nlsat, is a cylindrical algebraic decomposition; there are no random points, no
prime fields and no balls. It grows doubly exponentially, so only small formulas without roots of
variables are asked, with a limit on z3's own count of steps: the answer does not depend on the
speed of the machine. z3 is imported when the first such formula comes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import lcm
from typing import Any, NamedTuple

import sympy as sp

from omniproof.formula.sympy_terms import CIRCULAR_FUNCTIONS

STEPS = 100_000
LAST_RESORT_MS = 10_000
"""Steps do not count the arithmetic of large polynomials, so a clock stands behind them."""
MOST_OPERATIONS, MOST_VARIABLES, LARGEST_MULTIPLE, LARGEST_POWER = 80, 9, 6, 8

SIGNS: tuple[tuple[str, Callable[[Any], Any]], ...] = (
    ("is_nonnegative", lambda variable: variable >= 0),
    ("is_nonpositive", lambda variable: variable <= 0),
    ("is_nonzero", lambda variable: variable != 0),
)
"""What SymPy may assume of a symbol, and how z3 is told."""


@dataclass(frozen=True)
class Equal:
    """There are no real numbers at which the sides differ and are defined."""


@dataclass(frozen=True)
class Different:
    """At these numbers (cosines, sines and symbols, as z3 writes them) the sides differ."""

    model: Mapping[str, str]


@dataclass(frozen=True)
class NoAnswer:
    """z3 was not asked, or found nothing within its limit of steps."""

    reason: str


SmtAnswer = Equal | Different | NoAnswer


class OutsideError(ValueError):
    """The formula is not a small rational one; its text says why."""


class Fraction(NamedTuple):
    """A quotient of two polynomials of z3."""

    above: Any
    below: Any


@lru_cache(maxsize=1024)
def differ_somewhere(printed: sp.Expr, derived: sp.Expr, steps: int = STEPS) -> SmtAnswer:
    """Ask z3 for a real point at which both sides are defined and differ."""
    try:
        _refuse_large(printed, derived)
        return _Question(printed, derived).answer(steps)
    except OutsideError as reason:
        return NoAnswer(str(reason))


@lru_cache
def _context() -> Any:
    """Return the one context: to make one takes longer than most answers.

    nlsat keeps nothing from question to question; steps are counted from the start of each.
    """
    import z3

    return z3.Context()


def _refuse_large(*sides: sp.Expr) -> None:
    if sum(side.count_ops() for side in sides) > MOST_OPERATIONS:
        raise OutsideError(f"it has more than {MOST_OPERATIONS} operations")


class Translation:
    """Formulas as polynomials: numerators, denominators, and the conditions under which they hold.

    Raises `OutsideError` for what is no small rational formula.
    """

    def __init__(self, *formulas: sp.Expr) -> None:
        import z3

        self.z3 = z3
        self.context = _context()
        self.one = self._number(sp.Integer(1))
        self.conditions: list[Any] = []
        self.numbers: dict[sp.Expr, Any] = {}
        self.circles: dict[sp.Expr, tuple[Any, Any]] = {}
        self.points: dict[sp.Expr, tuple[Fraction, Fraction]] = {}
        self.denominators = _denominators(formulas)

    @property
    def is_mixed(self) -> bool:
        """Whether a symbol is both angle and number: what z3 finds then may be no point."""
        return bool(self.circles.keys() & self.numbers.keys())

    def refuse_many_variables(self) -> None:
        """Raise `OutsideError` when there are too many variables for an answer."""
        if len(self.numbers) + 2 * len(self.circles) > MOST_VARIABLES:
            raise OutsideError(f"it has more than {MOST_VARIABLES} variables")

    def check(self, steps: int, *conditions: Any) -> tuple[Any, Any]:
        """Return z3's verdict on all conditions together, and its model if there is one."""
        solver = self.z3.Tactic("qfnra-nlsat", ctx=self.context).solver()
        solver.set("rlimit", steps)
        solver.set("timeout", LAST_RESORT_MS)
        solver.add(*self.conditions, *conditions)
        verdict = solver.check()
        return verdict, solver.model() if verdict == self.z3.sat else None

    def fraction(self, node: sp.Expr) -> Fraction:
        """Translate a formula into numerator and denominator."""
        if node.is_Rational:
            return Fraction(self._number(node), self.one)
        if node.is_Symbol:
            return Fraction(self._symbol(node), self.one)
        if node.is_Add:
            return self._sum(node)
        if node.is_Mul:
            return self._product(*map(self.fraction, node.args))
        if node.is_Pow:
            return self._power(node)
        if isinstance(node, CIRCULAR_FUNCTIONS):
            return self._circular(node)
        raise OutsideError(f"{node} is no rational formula")

    def _number(self, value: sp.Rational) -> Any:
        return self.z3.Q(int(value.p), int(value.q), ctx=self.context)

    def _variable(self, name: str) -> Any:
        return self.z3.Real(name, ctx=self.context)

    def _symbol(self, symbol: sp.Symbol) -> Any:
        if symbol not in self.numbers:
            variable = self.numbers[symbol] = self._variable(f"{symbol.name} ({len(self.numbers)})")
            self.conditions += [says(variable) for name, says in SIGNS if getattr(symbol, name)]
        return self.numbers[symbol]

    def _sum(self, node: sp.Expr) -> Fraction:
        above, below = self.fraction(node.args[0])
        for part in map(self.fraction, node.args[1:]):
            if below is self.one and part.below is self.one:
                above = above + part.above
            else:
                above = above * part.below + part.above * below
                below = self._times(below, part.below)
        return Fraction(above, below)

    def _product(self, *parts: Fraction) -> Fraction:
        above = below = self.one
        for part in parts:
            above, below = self._times(above, part.above), self._times(below, part.below)
        return Fraction(above, below)

    def _times(self, left: Any, right: Any) -> Any:
        if left is self.one:
            return right
        return left if right is self.one else left * right

    def _power(self, node: sp.Expr) -> Fraction:
        if node.base.is_Rational and node.exp == sp.Rational(1, 2) and node.base > 0:
            return Fraction(self._root(node), self.one)
        if not node.exp.is_Integer or abs(node.exp) > LARGEST_POWER:
            raise OutsideError(f"{node} is not a small integer power")
        return self._integer_power(self.fraction(node.base), int(node.exp))

    def _integer_power(self, base: Fraction, exponent: int) -> Fraction:
        power = self._product(*[base] * abs(exponent))
        if exponent > 0:
            return power
        self.conditions.append(power.below != 0)
        return Fraction(power.below, power.above)

    def _root(self, node: sp.Expr) -> Any:
        if node not in self.numbers:
            root = self.numbers[node] = self._variable(sp.sstr(node))
            self.conditions += [root * root == self._number(node.base), root > 0]
        return self.numbers[node]

    def _circular(self, node: sp.Expr) -> Fraction:
        cosine, sine = self._point(node.args[0])
        match node:
            case sp.cos():
                return cosine
            case sp.sin():
                return sine
            case sp.tan():
                above, below = sine, cosine
            case sp.cot():
                above, below = cosine, sine
            case sp.sec():
                above, below = Fraction(self.one, self.one), cosine
            case _:
                above, below = Fraction(self.one, self.one), sine
        return self._product(above, Fraction(below.below, below.above))

    def _point(self, argument: sp.Expr) -> tuple[Fraction, Fraction]:
        """Return cosine and sine of an angle by addition, one atom after the other."""
        if argument in self.points:
            return self.points[argument]
        cosine, sine = Fraction(self.one, self.one), Fraction(self._number(sp.S.Zero), self.one)
        for term in sp.Add.make_args(sp.expand(argument)):
            cosine, sine = self._turned(cosine, sine, *self._of_term(term))
        self.points[argument] = cosine, sine
        return cosine, sine

    def _of_term(self, term: sp.Expr) -> tuple[Fraction, Fraction]:
        factor, atom = term.as_coeff_Mul()
        if atom is sp.pi:
            return self._constant(sp.cos(term)), self._constant(sp.sin(term))
        steps = int(factor * self.denominators[atom])
        if abs(steps) > LARGEST_MULTIPLE:
            raise OutsideError(f"{steps} times an angle is too often")
        cosine, sine = self._circle(atom)
        turn = Fraction(cosine, self.one), Fraction(sine if steps > 0 else -sine, self.one)
        total = turn
        for _ in range(abs(steps) - 1):
            total = self._turned(*total, *turn)
        return total

    def _constant(self, value: sp.Expr) -> Fraction:
        if value.has(*CIRCULAR_FUNCTIONS):
            raise OutsideError(f"{value} is no expression in square roots")
        return self.fraction(sp.expand(value))

    def _circle(self, atom: sp.Expr) -> tuple[Any, Any]:
        if not atom.is_Symbol:
            raise OutsideError(f"{atom} in an angle is no symbol")
        if atom not in self.circles:
            name = f"{atom.name}/{self.denominators[atom]} ({len(self.circles)})"
            cosine, sine = self._variable(f"cos {name}"), self._variable(f"sin {name}")
            self.conditions.append(cosine * cosine + sine * sine == 1)
            self.circles[atom] = cosine, sine
        return self.circles[atom]

    def _turned(
        self, cosine: Fraction, sine: Fraction, c: Fraction, s: Fraction
    ) -> tuple[Fraction, Fraction]:
        """Add two angles; their cosines and sines have no denominators."""
        return (
            Fraction(cosine.above * c.above - sine.above * s.above, self.one),
            Fraction(cosine.above * s.above + sine.above * c.above, self.one),
        )


class _Question(Translation):
    def __init__(self, *sides: sp.Expr) -> None:
        super().__init__(*sides)
        self.left, self.right = map(self.fraction, sides)
        self.refuse_many_variables()

    def answer(self, steps: int) -> SmtAnswer:
        """Ask for a model of: both sides defined, and different when multiplied out."""
        left, right = self.left, self.right
        defined = [side.below != 0 for side in (left, right) if side.below is not self.one]
        differ = left.above * right.below != right.above * left.below
        verdict, model = self.check(steps, *defined, differ)
        if verdict == self.z3.unsat:
            return Equal()
        if verdict != self.z3.sat:
            return NoAnswer(f"no answer within {steps} steps")
        if self.is_mixed:
            return NoAnswer("a symbol is both angle and number: its point may not exist")
        return Different({str(name): str(model[name]) for name in sorted(model, key=str)})


def _denominators(sides: tuple[sp.Expr, ...]) -> dict[sp.Expr, int]:
    """Return the common denominator of the multiples of each atom."""
    found: dict[sp.Expr, int] = {}
    for node in set().union(*(side.atoms(*CIRCULAR_FUNCTIONS) for side in sides)):
        for term in sp.Add.make_args(sp.expand(node.args[0])):
            factor, atom = term.as_coeff_Mul()
            found[atom] = lcm(found.get(atom, 1), int(factor.q))
    return found
