r"""A number as it is printed: exact, real, and nothing in it is simplified.

An engine that is given `x - x` or `x/x` sees just that. SymPy would hand it 0 and 1, and what the
print leaves undefined, or what SymPy gets wrong, would be lost before the first engine is asked.
Equal terms are written alike; whether two terms have one value is what engines decide.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from math import prod
from typing import Any, TypeVar

T = TypeVar("T")


class Term:
    """A term; it remembers its hash, since engines keep what they know of each part by part."""

    _hash: int

    def __hash__(self) -> int:
        """Hash what is written."""
        try:
            return self._hash
        except AttributeError:
            object.__setattr__(self, "_hash", hash((type(self).__name__, *self._content)))
            return self._hash

    def __eq__(self, other: object) -> bool:
        """Whether two terms are written alike."""
        if self is other:
            return True
        return (
            isinstance(other, Term)
            and type(self) is type(other)
            and hash(self) == hash(other)
            and self._content == other._content
        )

    @property
    def _content(self) -> tuple[Any, ...]:
        return tuple(getattr(self, item.name) for item in fields(self))  # type: ignore[arg-type]

    @property
    def parts(self) -> tuple[Term, ...]:
        """The terms directly below, in printed order."""
        return ()

    def with_parts(self, parts: tuple[Term, ...]) -> Term:
        """The same with other terms below."""
        return self


@dataclass(frozen=True, eq=False)
class Number(Term):
    """A rational number."""

    value: Fraction


@dataclass(frozen=True, eq=False)
class Pi(Term):
    """The ratio of circumference and diameter."""


@dataclass(frozen=True, eq=False)
class Symbol(Term):
    """A free real number; what is assumed of it stands beside the formula, by its name."""

    name: str


@dataclass(frozen=True, eq=False)
class Sum(Term):
    """`a + b + c`."""

    terms: tuple[Term, ...]

    @property
    def parts(self) -> tuple[Term, ...]:
        """The terms."""
        return self.terms

    def with_parts(self, parts: tuple[Term, ...]) -> Term:
        """A sum of other terms."""
        return Sum(parts)


@dataclass(frozen=True, eq=False)
class Product(Term):
    """`a b c`; a quotient is a product with an inverse."""

    factors: tuple[Term, ...]

    @property
    def parts(self) -> tuple[Term, ...]:
        """The factors."""
        return self.factors

    def with_parts(self, parts: tuple[Term, ...]) -> Term:
        """A product of other factors."""
        return Product(parts)


@dataclass(frozen=True, eq=False)
class Power(Term):
    """A whole power; with a negative exponent it is defined where the base is not zero."""

    base: Term
    exponent: int

    @property
    def parts(self) -> tuple[Term, ...]:
        """The base."""
        return (self.base,)

    def with_parts(self, parts: tuple[Term, ...]) -> Term:
        """The same power of another base."""
        return Power(parts[0], self.exponent)


@dataclass(frozen=True, eq=False)
class Call(Term):
    """A function of the table, or one that nobody knows, such as a wheel speed over time."""

    function: str
    arguments: tuple[Term, ...]

    @property
    def parts(self) -> tuple[Term, ...]:
        """The arguments."""
        return self.arguments

    def with_parts(self, parts: tuple[Term, ...]) -> Term:
        """The same function of other arguments."""
        return Call(self.function, parts)


@dataclass(frozen=True, eq=False)
class Integral(Term):
    """A definite integral; its variable is bound, and may be written like another symbol."""

    integrand: Term
    variable: Symbol
    lower: Term
    upper: Term

    @property
    def parts(self) -> tuple[Term, ...]:
        """Integrand and ends."""
        return self.integrand, self.lower, self.upper

    def with_parts(self, parts: tuple[Term, ...]) -> Term:
        """The integral of another integrand between other ends."""
        return replace(self, integrand=parts[0], lower=parts[1], upper=parts[2])


ZERO, ONE, MINUS_ONE, PI = Number(Fraction(0)), Number(Fraction(1)), Number(Fraction(-1)), Pi()


def number(value: int | Fraction) -> Number:
    """Return a rational number as a term."""
    return Number(Fraction(value))


def add(*parts: Term) -> Term:
    """Return a sum; of one term, the term."""
    return parts[0] if len(parts) == 1 else Sum(parts)


def multiply(*parts: Term) -> Term:
    """Return a product; of one factor, the factor."""
    return parts[0] if len(parts) == 1 else Product(parts)


def negative(term: Term) -> Term:
    """Return `-a`."""
    return Product((MINUS_ONE, term))


def subtract(left: Term, right: Term) -> Term:
    """Return `a - b`."""
    return Sum((left, negative(right)))


def divide(above: Term, below: Term) -> Term:
    """Return `a / b`."""
    return Product((above, Power(below, -1)))


def root(radicand: Term) -> Term:
    """Return the square root that is not negative."""
    return Call("sqrt", (radicand,))


def walk(term: Term) -> Iterator[Term]:
    """Yield each different part once, what is inside before what is outside."""
    seen: set[Term] = set()

    def visit(part: Term) -> Iterator[Term]:
        if part not in seen:
            seen.add(part)
            for inner in part.parts:
                yield from visit(inner)
            yield part

    return visit(term)


def fold(term: Term, rule: Callable[[Term, tuple[T, ...]], T]) -> T:
    """Compute something of a term from the inside out, of each different part once.

    `rule` gets a part and what its own parts gave.
    """
    found: dict[Term, T] = {}
    for part in walk(term):
        found[part] = rule(part, tuple(found[inner] for inner in part.parts))
    return found[term]


def symbols(term: Term) -> set[str]:
    """Return the names of the free symbols."""

    def rule(part: Term, inside: tuple[frozenset[str], ...]) -> frozenset[str]:
        if isinstance(part, Symbol):
            return frozenset([part.name])
        if isinstance(part, Integral):
            inside = (inside[0] - {part.variable.name}, *inside[1:])
        return frozenset[str]().union(*inside)

    found: frozenset[str] = fold(term, rule)
    return set(found)


def rebuild(term: Term, change: Callable[[Term], Term | None]) -> Term:
    """Return a term with other parts: `change` gives what stands for a part, or None to go in."""
    known: dict[Term, Term] = {}

    def made(part: Term) -> Term:
        if part not in known:
            new = change(part)
            if new is None:
                parts = tuple(made(inner) for inner in part.parts)
                new = part if parts == part.parts else part.with_parts(parts)
            known[part] = new
        return known[part]

    return made(term)


def substitute(term: Term, values: Mapping[str, Term]) -> Term:
    """Put terms in the place of free symbols, all at once; a bound variable is none."""

    def change(part: Term) -> Term | None:
        if isinstance(part, Symbol):
            return values.get(part.name, part)
        if isinstance(part, Integral) and part.variable.name in values:
            rest = {name: new for name, new in values.items() if name != part.variable.name}
            ends = (substitute(end, values) for end in (part.lower, part.upper))
            return part.with_parts((substitute(part.integrand, rest), *ends))
        return None

    return rebuild(term, change)


def rational(term: Term) -> Fraction | None:
    """Return the value of a term that is made of numbers, + and · alone; None for any other.

    None, too, where it divides by zero.
    """
    if isinstance(term, Number):
        return term.value
    values = [value for part in term.parts if (value := rational(part)) is not None]
    if not values or len(values) != len(term.parts):
        return None
    match term:
        case Sum():
            return sum(values, Fraction(0))
        case Product():
            return prod(values, start=Fraction(1))
        case Power(exponent=exponent) if values[0] or exponent >= 0:
            return Fraction(values[0] ** exponent)
    return None
