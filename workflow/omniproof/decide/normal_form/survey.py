"""What a term is made of, before any algebra: angles, constants, radicals, free symbols.

The rings of the normal form need all generators at once, so one walk over the expression collects
them. Whatever is not algebraic or trigonometric (exp(x), atan2(y, x), x**(1/3)) becomes an
independent *symbol* of its own: proofs stay sound, and what would need its special relations stays
undecided.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from math import lcm

from omniproof.decide.normal_form.angles import read_angle
from omniproof.decide.normal_form.constant_field import field_order, square_free_part
from omniproof.formula.angle import Angle, is_independent
from omniproof.formula.errors import WorkLimitError
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.monomials import Monomial
from omniproof.formula.term import (
    Call,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    Term,
    rational,
    symbols,
    walk,
)

MOST_NODES = 20_000
SIGNED = frozenset({"sqrt", "abs", "sign"})
"""Functions of which squares are known, and signs are to be found out."""
LACKING = {
    "log": "a symbol of its own, but for the logarithm of an exponential",
    "power": "a symbol of its own: a power of another exponent is another one",
}
"""Why functions of the table have no algebra here."""


@dataclass
class Survey:
    """Everything that needs a generator, in the order in which it is met (inner ones first)."""

    angles: dict[Term, Angle] = field(default_factory=dict)
    denominators: dict[Monomial, int] = field(default_factory=dict)
    order: int = 1
    primes: set[int] = field(default_factory=set)
    symbols: dict[Term, None] = field(default_factory=dict)
    constant_roots: dict[Term, None] = field(default_factory=dict)
    radicals: dict[Call, frozenset[Term]] = field(default_factory=dict)  # with inner ones
    trigonometric_radicals: bool = False
    positive: frozenset[str] = frozenset()
    """Names of symbols that are not negative."""

    @property
    def is_independent(self) -> bool:
        """Whether the generators without roots are algebraically independent as functions.

        Symbols and the sines and cosines of different monomials are (Ax, Annals of Mathematics 93,
        1971); x, sin x and sin |x| are not, nor are x and x**(1/3).
        """
        plain = all(isinstance(term, Symbol | Pi) for term in self.symbols)
        return plain and all(map(is_independent, self.denominators))


def survey(terms: Iterable[Term], positive: frozenset[str] = frozenset()) -> Survey:
    """Collect the generators of terms; raises `WorkLimitError` for too many parts."""
    surveyor = _Surveyor(Survey(positive=positive))
    for term in terms:
        surveyor.visit(term)
    found = surveyor.found
    order = lcm(found.order, 4) if found.radicals else found.order
    found.order = field_order(order, found.primes)
    return found


def is_radical(term: Term) -> bool:
    """Whether a term is a square root, an absolute value or a sign."""
    return isinstance(term, Call) and term.function in SIGNED


def is_positive(term: Term, positive: Collection[str]) -> bool:
    """Whether a generator is plainly not negative."""
    match term:
        case Symbol(name=name):
            return name in positive
        case Call(function="power", arguments=(base, _)):
            return is_positive(base, positive)
        case Call(function=function):
            return function == "exp"
    return isinstance(term, Pi)


class _Surveyor:
    def __init__(self, found: Survey) -> None:
        self.found = found
        self.seen: set[Term] = set()

    def visit(self, term: Term) -> None:
        if term in self.seen:
            return
        if len(self.seen) > MOST_NODES:
            raise WorkLimitError(f"the formula has more than {MOST_NODES} different parts")
        match term:
            case Number():
                pass
            case Sum() | Product() | Power():
                for part in term.parts:
                    self.visit(part)
            case Call(function=function) if function in CIRCULAR:
                self.trigonometric(term)
            case Call(function=function) if function in SIGNED:
                self.radical(term)
            case _:
                self.found.symbols[term] = None
        self.seen.add(term)

    def trigonometric(self, term: Call) -> None:
        (argument,) = term.arguments
        angle = self.found.angles[argument] = read_angle(argument)
        self.found.order = lcm(self.found.order, angle.turns.denominator)
        for atom, factor in angle.multiples.items():
            known = self.found.denominators.get(atom, 1)
            self.found.denominators[atom] = lcm(known, factor.denominator)

    def radical(self, term: Call) -> None:
        (argument,) = term.arguments
        value = rational(argument)
        if value is not None:
            self.found.primes.update(square_free_part(abs(value))[1] if value else ())
            return
        self.visit(argument)
        if not symbols(argument):
            if term.function == "sqrt":
                self.found.constant_roots[argument] = None
        else:
            parts = list(walk(argument))
            self.found.radicals[term] = frozenset(parts) & self.found.radicals.keys()
            self.found.trigonometric_radicals |= any(
                isinstance(part, Call) and part.function in CIRCULAR for part in parts
            )
