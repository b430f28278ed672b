"""z3 on order: a point of a box at which some terms stand so and so to others, or none.

To prove `f >= 0` is to ask for a point with `f < 0` and to be told that there is none. Besides what
an equation may have, roots and absolute values are fresh numbers r >= 0 with r^q = radicand, and
the range of an angle is one or two half planes for (cos u, sin u). Ranges that are not expressible
are left out: then the question is about more points than were meant, so "none" remains a proof, and
a point is only a candidate. An algebraic decision procedure needs no bounded box and has no trouble
with equality inside of it, where branch and bound gives up (x^4 y^2 + x^2 y^4 + 1 >= 3 x^2 y^2).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction as Rational
from typing import Any, TypeAlias

from omniproof.decide.balls import as_float, enclose, sign_of
from omniproof.decide.z3.equation import NoAnswer
from omniproof.decide.z3.translation import (
    LARGEST_MULTIPLE,
    LARGEST_POWER,
    RELATIONS,
    Fraction,
    OutsideError,
    Translation,
    refuse_large,
)
from omniproof.formula.angle import angle_of, inverse_function
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.monomials import Monomial
from omniproof.formula.term import (
    PI,
    ZERO,
    Call,
    Number,
    Symbol,
    Term,
    divide,
    multiply,
    number,
    rebuild,
    subtract,
    symbols,
)
from omniproof.formula.value import Comparison

STEPS = 100_000
DIGITS = 20
Point: TypeAlias = tuple[Term, ...]
Ends: TypeAlias = tuple[Term | None, Term | None]
"""Of a range; None where it has no end."""


@dataclass(frozen=True)
class Region:
    """Where a point is looked for: a range for each symbol, its closed ends, and conditions.

    A symbol without a range is any real number; `closed` tells for (lower, upper) whether the end
    belongs to the range. `assumed` are pairs of a symbol's name and how it stands to 0.
    """

    ranges: Mapping[str, Ends]
    closed: Mapping[str, tuple[bool, bool]] = field(default_factory=dict)
    conditions: tuple[Comparison, ...] = ()
    apart: tuple[Point, ...] = ()
    """Points that do not count; coordinates in the order of `ranges`."""
    assumed: frozenset[tuple[str, str]] = frozenset()


@dataclass(frozen=True)
class Nowhere:
    """There is no such point."""


@dataclass(frozen=True)
class Somewhere:
    """There is a point, close to this one; when the question was not `exact`, there may be none."""

    point: Mapping[str, Rational]
    exact: bool


OrderAnswer = Nowhere | Somewhere | NoAnswer


def find_point(
    statements: Sequence[Comparison], region: Region, *, steps: int = STEPS
) -> OrderAnswer:
    """Ask for a point at which all sides are defined and stand as stated.

    Never raises for terms.
    """
    try:
        refuse_large(*(side for each in statements for side in (each.left, each.right)))
        return _Search(statements, region).answer(steps)
    except (OutsideError, UnsupportedError) as reason:
        return NoAnswer(str(reason))


class _Search(Translation):
    def __init__(self, statements: Sequence[Comparison], region: Region) -> None:
        stated = [*statements, *region.conditions]
        super().__init__((side for each in stated for side in (each.left, each.right)),
                         region.assumed)  # fmt: skip
        self.region = region
        self.exact = True
        self.sizes: dict[Term, Fraction] = {}
        self.wanted = [self._relation(each) for each in statements]
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

    def _call(self, call: Call) -> Fraction:
        """Translate rational powers of what is not negative, too, and absolute values."""
        match call:
            case Call(function="sqrt", arguments=(radicand,)):
                return self._root(radicand, 2)
            case Call(function="power", arguments=(base, Number(value=exponent))):
                if exponent.denominator > LARGEST_POWER:
                    raise OutsideError(f"a root of the order {exponent.denominator} is not small")
                root = self._root(base, exponent.denominator)
                return self._power(root, exponent.numerator)
            case Call(function="abs", arguments=(inside,)):
                return self._absolute(inside)
        return super()._call(call)

    def _absolute(self, inside: Term) -> Fraction:
        """Translate |x| as one of x and -x; as a root of x^2 it would double all degrees."""
        if inside not in self.sizes:
            value = self.fraction(inside)
            self._ask_defined(value)
            size = self._variable(f"size {len(self.sizes)}")
            product = self._times(size, value.below)
            either = self.z3.Or(product == value.above, product == -value.above)
            self.conditions += [size >= 0, either]
            self.sizes[inside] = self._whole(size)
        return self.sizes[inside]

    def _multiple(self, atom: Monomial, factor: Rational) -> tuple[Fraction, Fraction]:
        """Translate an inverse function in an angle by cosine and sine of it."""
        point = inverse_function(atom)
        if point is None:
            return super()._multiple(atom, factor)
        if factor.denominator != 1 or abs(factor) > LARGEST_MULTIPLE:
            raise OutsideError(f"{factor} times an inverse function is not asked")
        cosine, sine = map(self.fraction, point)
        return self._repeated((cosine, sine), int(factor))

    def _relation(self, statement: Comparison) -> Any:
        """Say that a difference is defined and has a sign: its product with the denominator's."""
        sides = statement.left, statement.right
        difference = sides[0] if sides[1] == ZERO else subtract(*sides)
        above, below = self.fraction(difference)
        if below is not self.one:
            self.conditions.append(below != 0)
            above = above if statement.operator in {"=", "\\neq"} else above * below
        return RELATIONS[statement.operator](above)

    def _add_ranges(self) -> None:
        for name, ends in self.region.ranges.items():
            closed = self.region.closed.get(name, (False, False))
            if name in self.numbers:
                self._bound(name, ends, closed)
            if name in self.circles:
                self._bound_angle(name, ends, closed)

    def _bound(self, name: str, ends: Ends, closed: tuple[bool, bool]) -> None:
        for end, belongs, sign in zip(ends, closed, (">", "<"), strict=True):
            if end is not None:
                operator = {">": "\\geq", "<": "\\leq"}[sign] if belongs else sign
                bound = Comparison(Symbol(name), operator, self._end(end, sign))
                self.conditions.append(self._relation(bound))

    def _end(self, end: Term, sign: str) -> Term:
        """Return the end of a range; a transcendental one is rounded outwards."""
        try:
            self.fraction(end)
        except OutsideError:
            self.exact = False
            ball = enclose(end)
            bound = (ball.lower() if sign == ">" else ball.upper()).fmpq()
            return Number(Rational(int(bound.p), int(bound.q)))
        return end

    def _bound_angle(self, name: str, ends: Ends, closed: tuple[bool, bool]) -> None:
        """Keep the point of u = symbol / N on its arc.

        The arc from a to b is where sin(u - a) > 0 and sin(b - u) > 0, for arcs of more than half a
        turn: or; without an end that is a full turn long, just another point than a.
        """
        first, last = (end and divide(end, number(self._divisor(name))) for end in ends)
        if first is None or last is None:
            return
        beyond, half = (_compared(subtract(last, first), turns) for turns in (2, 1))
        if beyond is not None and (beyond > 0 or (beyond == 0 and any(closed))):
            return
        try:
            start, end = self._direction(first), self._direction(last)
        except OutsideError:
            self.exact = False
            return
        u = self.circles[name]
        if beyond == 0:
            self.conditions.append(self._differs(u, start))
        else:
            self.conditions.append(self._arc(u, start, end, half or 0, closed))

    def _arc(self, u: Any, start: Any, end: Any, half: int, closed: tuple[bool, bool]) -> Any:
        """Say that a point lies on an arc; `half` compares the length of the arc with pi."""
        after, before = _cross(start, u), _cross(u, end)
        z3 = self.z3
        inside = [after > 0, before > 0]
        on_arc = z3.Or(*inside) if half > 0 else z3.And(*inside) if half < 0 else inside[0]
        points = [p for p, belongs in zip((start, end), closed, strict=True) if belongs]
        return z3.Or(on_arc, *(z3.Not(self._differs(u, point)) for point in points))

    def _divisor(self, name: str) -> int:
        return self.denominators[frozenset({(Symbol(name), 1)})]

    def _direction(self, angle: Term) -> tuple[Any, Any]:
        multiples, turns = angle_of(angle)
        if multiples:
            raise OutsideError("the end of a range of an angle is no multiple of pi")
        cosine, sine = self._corner(turns)
        return cosine.above, sine.above

    def _differs(self, u: Any, v: Any) -> Any:
        return self.z3.Or(u[0] != v[0], u[1] != v[1])

    def _add_conditions(self) -> None:
        for condition in self.region.conditions:
            difference = subtract(condition.left, condition.right)
            try:
                if _outside_of_calls(difference) & self.circles.keys():
                    raise OutsideError("a condition on an angle itself is not algebraic")
                self.wanted.append(self._relation(condition))
            except OutsideError:
                self.exact = False

    def _is_apart(self, point: Point) -> Any:
        """Say that a place is not this point; an angle has one place if its range is one turn."""
        if self.region.ranges.keys() - self.numbers.keys() - self.circles.keys():
            raise OutsideError("it is constant in a symbol, so that no point stands alone")
        places = zip(self.region.ranges, point, strict=True)
        return self.z3.Or(*(each for name, value in places for each in self._apart(name, value)))

    def _apart(self, name: str, value: Term) -> Iterator[Any]:
        if name in self.numbers:
            yield self._relation(Comparison(Symbol(name), "\\neq", value))
        if name in self.circles:
            divisor = self._divisor(name)
            lower, upper = self.region.ranges[name]
            both = all(self.region.closed.get(name, (False, False)))
            beyond = lower and upper and _compared(subtract(upper, lower), 2 * divisor)
            if not isinstance(beyond, int) or beyond > 0 or (beyond == 0 and both):
                raise OutsideError(f"{name} takes more than one turn")
            direction = self._direction(divide(value, number(divisor)))
            yield self._differs(self.circles[name], direction)

    def _place(self, model: Any) -> dict[str, Rational]:
        """Read a model: exact where its numbers are rational, else to 20 digits."""
        place = {}
        for name, (cosine, sine) in self.circles.items():
            divisor = self._divisor(name)
            u = math.atan2(*(float(_approximate(model, v)) for v in (sine, cosine)))
            lower, _ = self.region.ranges.get(name, (None, None))
            start = u if lower is None else as_float(enclose(lower)) / divisor
            turns = math.ceil((start - u) / math.tau)
            place[name] = Rational((u + turns * math.tau) * divisor)
        numbers = self.numbers.items()
        return place | {name: _approximate(model, variable) for name, variable in numbers}


def _compared(length: Term, turns: int) -> int | None:
    """Compare a length with a multiple of pi; None where it is too close to be told."""
    multiples, own = angle_of(length)
    if not multiples:
        return (own > turns) - (own < turns)
    return sign_of(enclose(subtract(length, multiply(number(turns), PI))))


def _outside_of_calls(term: Term) -> set[str]:
    """Return the symbols of a term that are more than angles of sines and the like."""

    def change(part: Term) -> Term | None:
        return ZERO if isinstance(part, Call) and part.function in CIRCULAR else None

    return symbols(rebuild(term, change))


def _cross(u: tuple[Any, Any], v: tuple[Any, Any]) -> Any:
    """Return the sine of the angle from u to v."""
    return u[0] * v[1] - u[1] * v[0]


def _approximate(model: Any, variable: Any) -> Rational:
    value = model.eval(variable, model_completion=True)
    return (value if hasattr(value, "as_fraction") else value.approx(DIGITS)).as_fraction()
