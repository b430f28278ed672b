"""z3 on order: a point of a box at which some formulas have given signs, or none.

To prove `f >= 0` is to ask for a point with `f < 0` and to be told that there is none. Besides what
`smt` translates, roots and absolute values are fresh numbers r >= 0 with r^q = radicand, and the
range of an angle is one or two half planes for (cos u, sin u). Ranges that are not expressible are
left out: then the question is about more points than were meant, so "none" remains a proof, and a
point is only a candidate. An algebraic decision procedure needs no bounded box and has no trouble
with equality inside of it, where branch and bound gives up (x^4 y^2 + x^2 y^4 + 1 >= 3 x^2 y^2).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction as Rational
from typing import Any, TypeAlias

import sympy as sp

from omniproof.audit.balls import evaluate
from omniproof.audit.exact import sign, subtract
from omniproof.audit.smt import (
    LARGEST_POWER,
    MOST_OPERATIONS,
    Fraction,
    NoAnswer,
    OutsideError,
    Translation,
)
from omniproof.audit.sympy_domain import REAL_LINE
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import CIRCULAR_FUNCTIONS

STEPS = 100_000
DIGITS = 20
Point: TypeAlias = tuple[Any, ...]


@dataclass(frozen=True)
class Region:
    """Where a point is looked for: a range for each symbol, its closed ends, and conditions.

    A symbol without a range is any real number; `closed` tells for (lower, upper) whether the end
    belongs to the range.
    """

    ranges: Mapping[sp.Symbol, tuple[Any, Any]]
    closed: Mapping[sp.Symbol, tuple[bool, bool]] = field(default_factory=dict)
    conditions: tuple[Any, ...] = ()
    apart: tuple[Point, ...] = ()
    """Points that do not count; coordinates in the order of `ranges`."""


@dataclass(frozen=True)
class Nowhere:
    """There is no such point."""


@dataclass(frozen=True)
class Somewhere:
    """There is a point, close to this one; when the question was not `exact`, there may be none."""

    point: Mapping[sp.Symbol, Rational]
    exact: bool


OrderAnswer = Nowhere | Somewhere | NoAnswer


def find_point(
    signs: Sequence[tuple[sp.Expr, str]], region: Region, *, steps: int = STEPS
) -> OrderAnswer:
    """Ask for a point at which all formulas are defined and stand in their relation to zero.

    `signs` are formulas with one of `<`, `<=`, `>`, `>=`, `==`, `!=`. Never raises for formulas.
    """
    formulas = [formula for formula, _ in signs]
    try:
        if sum(formula.count_ops() for formula in formulas) > MOST_OPERATIONS:
            raise OutsideError(f"it has more than {MOST_OPERATIONS} operations")
        return _Search(signs, region).answer(steps)
    except (OutsideError, UnsupportedError) as reason:
        return NoAnswer(str(reason))


class _Search(Translation):
    def __init__(self, signs: Sequence[tuple[sp.Expr, str]], region: Region) -> None:
        stated = (condition.lhs - condition.rhs for condition in region.conditions)
        super().__init__(*(formula for formula, _ in signs), *stated)
        self.region = region
        self.exact = True
        self.roots: dict[tuple[sp.Expr, int], Fraction] = {}
        self.sizes: dict[sp.Expr, Fraction] = {}
        self.wanted = [self._relation(formula, symbol) for formula, symbol in signs]
        self._add_ranges()
        self._add_conditions()
        self.wanted += [self._is_apart(point) for point in region.apart]
        self.refuse_many_variables()

    def answer(self, steps: int) -> OrderAnswer:
        verdict, model = self.check(steps, *self.wanted)
        if verdict == self.z3.unsat:
            return Nowhere()
        if verdict != self.z3.sat:
            return NoAnswer(f"no answer within {steps} steps")
        return Somewhere(self._place(model), self.exact and not self.is_mixed)

    def fraction(self, node: sp.Expr) -> Fraction:
        if isinstance(node, sp.Abs):
            return self._absolute(node)
        return super().fraction(node)

    def _power(self, node: sp.Expr) -> Fraction:
        """Translate a rational power of what is not negative."""
        exponent = node.exp
        if not exponent.is_Rational or exponent.is_Integer:
            return super()._power(node)
        if exponent.q > LARGEST_POWER:
            raise OutsideError(f"{node} is not a small root")
        root = self._principal_root(node.base, int(exponent.q))
        return self._integer_power(root, int(exponent.p))

    def _absolute(self, node: sp.Abs) -> Fraction:
        """Translate |x| as one of x and -x; as a root of x^2 it would double all degrees."""
        if node not in self.sizes:
            above, below = self.fraction(node.args[0])
            size = self._variable(f"size {len(self.sizes)}")
            either = self.z3.Or(size * below == above, size * below == -above)
            self.conditions += [size >= 0, below != 0, either]
            self.sizes[node] = Fraction(size, self.one)
        return self.sizes[node]

    def _principal_root(self, radicand: sp.Expr, index: int) -> Fraction:
        key = (radicand, index)
        if key not in self.roots:
            above, below = self.fraction(radicand)
            root = self._variable(f"root {len(self.roots)}")
            power = self._integer_power(Fraction(root, self.one), index).above
            self.conditions += [root >= 0, below != 0, power * below == above]
            self.roots[key] = Fraction(root, self.one)
        return self.roots[key]

    def _relation(self, formula: sp.Expr, symbol: str) -> Any:
        """Say that a fraction is defined and has a sign: its product with the denominator's."""
        above, below = self.fraction(formula)
        if below is not self.one:
            self.conditions.append(below != 0)
            above = above if symbol in {"==", "!="} else above * below
        return RELATIONS[symbol](above)

    def _add_ranges(self) -> None:
        for symbol, ends in self.region.ranges.items():
            closed = self.region.closed.get(symbol, (False, False))
            if symbol in self.numbers:
                self._bound(self.numbers[symbol], ends, closed)
            if symbol in self.circles:
                self._bound_angle(symbol, ends, closed)

    def _bound(self, variable: Any, ends: tuple[Any, Any], closed: tuple[bool, bool]) -> None:
        for end, belongs, towards in zip(ends, closed, (1, -1), strict=True):
            if not sp.sympify(end).is_infinite:
                inside = towards * (variable - self._end(end, -towards))
                self.conditions.append(inside >= 0 if belongs else inside > 0)

    def _end(self, end: Any, outward: int) -> Any:
        """Translate the end of a range; a transcendental one is rounded outwards."""
        try:
            return self._value(end)
        except OutsideError:
            self.exact = False
            ball = evaluate(end)
            bound = (ball.lower() if outward < 0 else ball.upper()).fmpq()
            return self._number(sp.Rational(int(bound.p), int(bound.q)))

    def _bound_angle(
        self, symbol: sp.Symbol, ends: tuple[Any, Any], closed: tuple[bool, bool]
    ) -> None:
        """Keep the point of u = symbol / N on its arc.

        The arc from a to b is where sin(u - a) > 0 and sin(b - u) > 0, for arcs of more than half a
        turn: or; without an end that is a full turn long, just another point than a.
        """
        if any(sp.sympify(end).is_infinite for end in ends):
            return
        first, last = (end / self.denominators[symbol] for end in map(sp.sympify, ends))
        length = subtract(last, first)
        beyond = sign(subtract(length, 2 * sp.pi))
        if beyond > 0 or (beyond == 0 and any(closed)):
            return
        try:
            start, end = self._direction(first), self._direction(last)
        except OutsideError:
            self.exact = False
            return
        u = self.circles[symbol]
        if beyond == 0:
            self.conditions.append(self._differs(u, start))
        else:
            half = sign(subtract(length, sp.pi))
            self.conditions.append(self._arc(u, start, end, half, closed))

    def _arc(self, u: Any, start: Any, end: Any, half: int, closed: tuple[bool, bool]) -> Any:
        """Say that a point lies on an arc; `half` compares the length of the arc with pi."""
        after, before = _cross(start, u), _cross(u, end)
        z3 = self.z3
        inside = [after > 0, before > 0]
        on_arc = z3.Or(*inside) if half > 0 else z3.And(*inside) if half < 0 else inside[0]
        points = [p for p, belongs in zip((start, end), closed, strict=True) if belongs]
        return z3.Or(on_arc, *(z3.Not(self._differs(u, point)) for point in points))

    def _direction(self, angle: sp.Expr) -> tuple[Any, Any]:
        return self._value(sp.cos(angle)), self._value(sp.sin(angle))

    def _differs(self, u: Any, v: Any) -> Any:
        return self.z3.Or(u[0] != v[0], u[1] != v[1])

    def _value(self, number: Any) -> Any:
        """Translate a number in roots, without a denominator."""
        number = sp.radsimp(sp.sympify(number))
        if number.has(sp.cos, sp.sin):
            raise OutsideError(f"{number} is no expression in square roots")
        above, below = self.fraction(number)
        if below is not self.one:
            raise OutsideError(f"{number} has a denominator that is no rational number")
        return above

    def _add_conditions(self) -> None:
        for condition in self.region.conditions:
            difference = condition.lhs - condition.rhs
            try:
                if _outside_of_calls(difference) & self.circles.keys():
                    raise OutsideError("a condition on an angle itself is not algebraic")
                self.wanted.append(self._relation(difference, condition.rel_op))
            except OutsideError:
                self.exact = False

    def _is_apart(self, point: Point) -> Any:
        """Say that a place is not this point; an angle has one place if its range is one turn."""
        if self.region.ranges.keys() - self.numbers.keys() - self.circles.keys():
            raise OutsideError("it is constant in a symbol, so that no point stands alone")
        differs = []
        for (symbol, (lower, upper)), value in zip(self.region.ranges.items(), point, strict=True):
            if symbol in self.numbers:
                differs.append(self.numbers[symbol] != self._value(value))
            if symbol in self.circles:
                turn = 2 * sp.pi * self.denominators[symbol]
                ends = self.region.closed.get(symbol, (False, False))
                beyond = sign(subtract(subtract(upper, lower), turn))
                if beyond > 0 or (beyond == 0 and all(ends)):
                    raise OutsideError(f"{symbol} takes more than one turn")
                direction = self._direction(value / self.denominators[symbol])
                differs.append(self._differs(self.circles[symbol], direction))
        return self.z3.Or(*differs)

    def _place(self, model: Any) -> dict[sp.Symbol, Rational]:
        """Read a model: exact where its numbers are rational, else to 20 digits."""
        place = {}
        for symbol, (cosine, sine) in self.circles.items():
            number = self.denominators[symbol]
            u = math.atan2(*(float(_approximate(model, v)) for v in (sine, cosine)))
            lower = sp.sympify(self.region.ranges.get(symbol, REAL_LINE)[0])
            turns = 0 if lower.is_infinite else math.ceil((float(lower) / number - u) / math.tau)
            place[symbol] = Rational((u + turns * math.tau) * number)
        for symbol, variable in self.numbers.items():
            if symbol.is_Symbol:
                place[symbol] = _approximate(model, variable)
        return place


RELATIONS = {
    "<": lambda value: value < 0,
    "<=": lambda value: value <= 0,
    ">": lambda value: value > 0,
    ">=": lambda value: value >= 0,
    "==": lambda value: value == 0,
    "!=": lambda value: value != 0,
}


def _outside_of_calls(formula: sp.Expr) -> set[sp.Symbol]:
    """Return the symbols of a formula that are more than angles of sines and the like."""
    calls = {call: sp.Dummy() for call in formula.atoms(*CIRCULAR_FUNCTIONS)}
    return set(formula.xreplace(calls).free_symbols)


def _cross(u: tuple[Any, Any], v: tuple[Any, Any]) -> Any:
    """Return the sine of the angle from u to v."""
    return u[0] * v[1] - u[1] * v[0]


def _approximate(model: Any, variable: Any) -> Rational:
    value = model.eval(variable, model_completion=True)
    return (value if hasattr(value, "as_fraction") else value.approx(DIGITS)).as_fraction()
