"""Printed terms as polynomials of z3.

cos u and sin u are numbers with c^2 + s^2 = 1, u the smallest part of an angle that is met, and a
fraction is a numerator and a denominator that is not 0. So the conditions under which a term is
defined are read from the print, and nothing is cancelled.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction as Rational
from functools import lru_cache, reduce
from itertools import chain
from math import lcm
from typing import Any, NamedTuple, TypeAlias

from omniproof.decide.z3.corners import corner
from omniproof.formula.angle import angle_of, circular, inverse_function
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.monomials import Monomial
from omniproof.formula.term import (
    Call,
    Power,
    Product,
    Sum,
    Symbol,
    Term,
    rational,
    walk,
)

LAST_RESORT_MS = 10_000
"""Steps do not count the arithmetic of large polynomials, so a clock stands behind them."""
MOST_OPERATIONS, MOST_VARIABLES, LARGEST_MULTIPLE, LARGEST_POWER = 127, 9, 6, 8
"""Within these, a question of the five papers takes nlsat a few milliseconds, or all of its steps.
What it takes beyond is doubly exponential, and not known before."""
RELATIONS: dict[str, Callable[[Any], Any]] = {
    "<": lambda value: value < 0,
    "\\leq": lambda value: value <= 0,
    ">": lambda value: value > 0,
    "\\geq": lambda value: value >= 0,
    "=": lambda value: value == 0,
    "\\neq": lambda value: value != 0,
}
"""How a number may stand to 0."""


LACKING = dict.fromkeys(("sign", "exp", "log"), "no root of a polynomial: it is not asked")
"""Why functions of the table are not translated; roots and powers are for orders."""


class OutsideError(ValueError):
    """The formula is not a small rational one; its text says why."""


class Fraction(NamedTuple):
    """A quotient of two polynomials of z3."""

    above: Any
    below: Any


Point: TypeAlias = tuple[Fraction, Fraction]
"""Cosine and sine of an angle."""


@lru_cache
def _context() -> Any:
    """Return the one context: to make one takes longer than most answers.

    nlsat keeps nothing from question to question; steps are counted from the start of each.
    """
    import z3

    return z3.Context()


def refuse_large(*terms: Term) -> None:
    """Raise `OutsideError` for terms that have too many operations between them."""
    if sum(map(operations, terms)) > MOST_OPERATIONS:
        raise OutsideError(f"it has more than {MOST_OPERATIONS} operations")


def operations(term: Term) -> int:
    """Count what polynomials are made of a term by; in numbers, nothing is.

    A power counts as the products for which it stands, and a function twice: cosine and sine are
    two variables.
    """
    counts: dict[Term, int] = {}
    for part in walk(term):
        plain = rational(part) is not None
        counts[part] = 0 if plain else _own(part) + sum(counts[inner] for inner in part.parts)
    return counts[term]


def _own(part: Term) -> int:
    match part:
        case Sum() | Product():
            return len(part.parts) - 1
        case Power(exponent=exponent):
            return abs(exponent)
        case Call():
            return 2
    return 0


class Translation:
    """Terms as polynomials: numerators, denominators, and the conditions under which they hold.

    `assumed` says how symbols stand to 0, as pairs of a name and one of `RELATIONS`.
    Raises `OutsideError` for what is no small rational term, `UnsupportedError` for an angle that
    divides by zero.
    """

    def __init__(self, terms: Iterable[Term], assumed: Iterable[tuple[str, str]] = ()) -> None:
        import z3

        self.z3 = z3
        self.context = _context()
        self.one = self._number(Rational(1))
        self.assumed = sorted(assumed)
        self.conditions: list[Any] = []
        self.numbers: dict[str, Any] = {}
        self.roots: dict[tuple[Term, int], Any] = {}
        self.circles: dict[str, tuple[Any, Any]] = {}
        self.known: dict[Term, Fraction] = {}
        self.points: dict[Term, Point] = {}
        self.denominators = _denominators(terms)

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

    def fraction(self, term: Term) -> Fraction:
        """Translate a term into numerator and denominator."""
        if term not in self.known:
            value = rational(term)
            found = self._translated(term) if value is None else self._constant(value)
            self.known[term] = found
        return self.known[term]

    def _translated(self, term: Term) -> Fraction:
        match term:
            case Symbol(name=name):
                return self._whole(self._symbol(name))
            case Sum(terms=parts):
                return self._sum(*map(self.fraction, parts))
            case Product(factors=parts):
                return self._product(*map(self.fraction, parts))
            case Power(base=base, exponent=exponent):
                return self._power(self.fraction(base), exponent)
            case Call():
                return self._call(term)
        raise OutsideError(f"{type(term).__name__} is no rational formula")

    def _call(self, call: Call) -> Fraction:
        if call.function in CIRCULAR:
            return self._circular(call)
        if call.function == "sqrt" and rational(call.arguments[0]) is not None:
            return self._root(call.arguments[0], 2)
        raise OutsideError(f"{call.function} is no rational function")

    def _number(self, value: Rational) -> Any:
        return self.z3.Q(value.numerator, value.denominator, ctx=self.context)

    def _constant(self, value: Rational) -> Fraction:
        return self._whole(self._number(value))

    def _whole(self, value: Any) -> Fraction:
        return Fraction(value, self.one)

    def _variable(self, name: str) -> Any:
        return self.z3.Real(name, ctx=self.context)

    def _symbol(self, name: str) -> Any:
        if name not in self.numbers:
            variable = self.numbers[name] = self._variable(f"{name} ({len(self.numbers)})")
            signs = (relation for known, relation in self.assumed if known == name)
            self.conditions += [RELATIONS[relation](variable) for relation in signs]
        return self.numbers[name]

    def _sum(self, *parts: Fraction) -> Fraction:
        above, below = parts[0]
        for part in parts[1:]:
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

    def _power(self, base: Fraction, exponent: int) -> Fraction:
        """Return a whole power; the base has to be defined for the powers 0 and below, too."""
        if abs(exponent) > LARGEST_POWER:
            raise OutsideError(f"the power {exponent} is not small")
        power = self._product(*[base] * abs(exponent))
        if exponent > 0:
            return power
        self._ask_defined(base)
        return Fraction(power.below, power.above)

    def _root(self, radicand: Term, index: int) -> Fraction:
        """Return the root that is not negative, where there is one, as a number of its own."""
        key = (radicand, index)
        if key not in self.roots:
            inside = self.fraction(radicand)
            self._ask_defined(inside)
            root = self.roots[key] = self._variable(f"root {len(self.roots)}")
            power = self._power(self._whole(root), index).above
            self.conditions += [root >= 0, self._times(power, inside.below) == inside.above]
        return self._whole(self.roots[key])

    def _circular(self, call: Call) -> Fraction:
        cosine, sine = self._point(call.arguments[0])
        above, below = circular(call.function, self._whole(self.one), cosine, sine)
        return self._product(above, self._power(below, -1))

    def _point(self, argument: Term) -> Point:
        """Return cosine and sine of an angle by addition, one atom after the other."""
        if argument not in self.points:
            self._define_parts(argument)
            multiples, turns = angle_of(argument)
            total = self._corner(turns)
            for atom, factor in multiples.items():
                total = self._turned(total, self._multiple(atom, factor))
            self.points[argument] = total
        return self.points[argument]

    def _define_parts(self, argument: Term) -> None:
        """Ask that what cancels in an angle is defined, too."""
        for part in walk(argument):
            if isinstance(part, Call) or (isinstance(part, Power) and part.exponent < 0):
                point = inverse_function(frozenset({(part, 1)}))
                for value in point or (part,):
                    self._ask_defined(self.fraction(value))

    def _ask_defined(self, value: Fraction) -> None:
        if value.below is not self.one:
            self.conditions.append(value.below != 0)

    def _corner(self, turns: Rational) -> Point:
        found = corner(turns)
        if found is None:
            raise OutsideError(f"the cosine of {turns} pi is no expression in square roots")
        return self.fraction(found[0]), self.fraction(found[1])

    def _multiple(self, atom: Monomial, factor: Rational) -> Point:
        steps = int(factor * self.denominators[atom])
        if abs(steps) > LARGEST_MULTIPLE:
            raise OutsideError(f"{steps} times an angle is too often")
        cosine, sine = map(self._whole, self._circle(atom))
        return self._repeated((cosine, sine), steps)

    def _repeated(self, turn: Point, steps: int) -> Point:
        """Add an angle to itself; `steps` may be negative."""
        if steps < 0:
            turn = turn[0], self._product(self._constant(Rational(-1)), turn[1])
        return reduce(self._turned, [turn] * abs(steps))

    def _circle(self, atom: Monomial) -> tuple[Any, Any]:
        match tuple(atom):
            case ((Symbol(name=name), 1),):
                pass
            case _:
                raise OutsideError("a part of an angle is no symbol")
        if name not in self.circles:
            label = f"{name}/{self.denominators[atom]} ({len(self.circles)})"
            cosine, sine = self._variable(f"cos {label}"), self._variable(f"sin {label}")
            self.conditions.append(cosine * cosine + sine * sine == 1)
            self.circles[name] = cosine, sine
        return self.circles[name]

    def _turned(self, angle: Point, turn: Point) -> Point:
        """Add two angles."""
        (cosine, sine), (c, s) = angle, turn
        minus = self._constant(Rational(-1))
        return (
            self._sum(self._product(cosine, c), self._product(minus, sine, s)),
            self._sum(self._product(cosine, s), self._product(sine, c)),
        )


def _denominators(terms: Iterable[Term]) -> dict[Monomial, int]:
    """Return the common denominator of the multiples of each atom of an angle."""
    found: dict[Monomial, int] = {}
    for part in chain.from_iterable(map(walk, terms)):
        if isinstance(part, Call) and part.function in CIRCULAR:
            for atom, factor in angle_of(part.arguments[0]).multiples.items():
                found[atom] = lcm(found.get(atom, 1), factor.denominator)
    return found
