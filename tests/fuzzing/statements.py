"""Random statements with parts that cancel, and their truth at a point by mpmath alone.

A part that was written before is likely to come again: that is how factors, nested fractions and
roots cancel. The value is made from the same structure as the LaTeX: the reader has no part in it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from random import Random
from typing import Any

from mpmath import mp, mpf

DIGITS, TINY = 60, mpf(10) ** -35
SYMBOLS = ("x", "y", r"\theta")
SIGNS = ("=", r"\neq", "<", ">", r"\leq", r"\geq")
Point = Mapping[str, Any]


class Undefined(ArithmeticError):  # noqa: N818 - no error, a fact
    """A part has no real value at a point."""


@dataclass(frozen=True)
class Part:
    """An expression: how it is written, and its value at a point."""

    latex: str
    at: Callable[[Point], Any]


@dataclass(frozen=True)
class Statement:
    """Two parts and the sign between them."""

    left: Part
    sign: str
    right: Part

    @property
    def latex(self) -> str:
        return f"{self.left.latex} {self.sign} {self.right.latex}"

    def holds(self, point: Point) -> bool | None:
        """Whether it is true at a point; None where a part has no value."""
        with mp.workdps(DIGITS):
            try:
                left, right = self.left.at(point), self.right.at(point)
            except Undefined:
                return None
            if abs(left - right) <= TINY * (1 + abs(left) + abs(right)):
                return self.sign in {"=", r"\leq", r"\geq"}
            if self.sign in {"=", r"\neq"}:
                return self.sign == r"\neq"
            return bool(left < right) is (self.sign in {"<", r"\leq"})


def _over(above: Any, below: Any) -> Any:
    if abs(below) < TINY:
        raise Undefined
    return above / below


def _root(radicand: Any) -> Any:
    if radicand < -TINY:
        raise Undefined
    return mp.sqrt(radicand) if radicand > TINY else mpf(0)


def _arc(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    def arc(value: Any) -> Any:
        if abs(value) > 1 + TINY:
            raise Undefined
        return function(min(max(value, mpf(-1)), mpf(1)))

    return arc


CALLS: dict[str, Callable[[Any], Any]] = {
    "sin": mp.sin, "cos": mp.cos, "arctan": mp.atan,
    "tan": lambda a: _over(mp.sin(a), mp.cos(a)), "cot": lambda a: _over(mp.cos(a), mp.sin(a)),
    "sec": lambda a: _over(mpf(1), mp.cos(a)), "csc": lambda a: _over(mpf(1), mp.sin(a)),
    "arcsin": _arc(mp.asin), "arccos": _arc(mp.acos),
}  # fmt: skip


class Writer:
    """Writes random statements, the same for the same seed."""

    def __init__(self, seed: int) -> None:
        self.chance = Random(seed)
        self.written: list[Part] = []

    def statement(self) -> Statement:
        self.written = []
        left = self.part(3)
        right = Part("0", lambda _: mpf(0)) if self.chance.random() < 0.45 else self.part(2)
        return Statement(left, self.chance.choice(SIGNS), right)

    def point(self) -> dict[str, Any]:
        """Draw a number for each symbol: whole, small or any, where things happen."""
        chance = self.chance
        draws = (lambda: chance.randint(-3, 3), lambda: chance.uniform(-3, 3), chance.random)
        return {name: mpf(chance.choice(draws)()) for name in SYMBOLS}

    def part(self, depth: int) -> Part:
        if self.written and self.chance.random() < 0.2:
            return self.chance.choice(self.written)
        found = self.leaf() if depth == 0 or self.chance.random() < 0.15 else self.joined(depth)
        self.written.append(found)
        return found

    def leaf(self) -> Part:
        if self.chance.random() < 0.6:
            name = self.chance.choice(SYMBOLS)
            return Part(name, lambda point: point[name])
        number = self.chance.choice("01123")
        return Part(number, lambda _: mpf(number))

    def joined(self, depth: int) -> Part:
        make = self.chance.choice(
            (self.quotient, self.quotient, self.product, self.sum, self.power, self.one, self.call)
        )
        return make(self.part(depth - 1), depth)

    def quotient(self, a: Part, depth: int) -> Part:
        b = self.part(depth - 1)
        return Part(rf"\frac{{{a.latex}}}{{{b.latex}}}", lambda p: _over(a.at(p), b.at(p)))

    def product(self, a: Part, depth: int) -> Part:
        b = self.part(depth - 1)
        return Part(rf"({a.latex}) \cdot ({b.latex})", lambda p: a.at(p) * b.at(p))

    def sum(self, a: Part, depth: int) -> Part:
        b, sign = self.part(depth - 1), self.chance.choice((1, -1))
        operator = "+" if sign > 0 else "-"
        return Part(f"(({a.latex}) {operator} ({b.latex}))", lambda p: a.at(p) + sign * b.at(p))

    def power(self, a: Part, _depth: int) -> Part:
        n = self.chance.choice((2, 2, 3, 4, -1, -2))
        if n > 0:
            return Part(f"({a.latex})^{{{n}}}", lambda p: a.at(p) ** n)
        return Part(f"({a.latex})^{{{n}}}", lambda p: _over(mpf(1), a.at(p)) ** -n)

    def one(self, a: Part, _depth: int) -> Part:
        if self.chance.random() < 0.5:
            return Part(rf"\sqrt{{{a.latex}}}", lambda p: _root(a.at(p)))
        return Part(f"|({a.latex})|", lambda p: abs(a.at(p)))

    def call(self, a: Part, _depth: int) -> Part:
        name = self.chance.choice(tuple(CALLS))
        return Part(rf"\{name}({a.latex})", lambda p: CALLS[name](a.at(p)))
