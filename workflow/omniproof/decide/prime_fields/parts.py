"""What a term needs in a prime field: letters, angles, roots.

Letters (symbols, and functions that the test knows nothing of) get random values. An angle is split
into atoms: sin(x/2 + y) needs e^(ix/2) and e^(iy). A root or an absolute value is a number with
known square and open sign. An inverse function in an angle is one, too: e^(i arccos u) is
u + i sqrt(1 - u^2).
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm

from omniproof.decide.prime_fields.field import prime_factors
from omniproof.formula.angle import Angle, angle_of, inverse_function, is_independent
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.monomials import Monomial
from omniproof.formula.term import (
    PI,
    Call,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    Term,
    negative,
    rational,
    walk,
)

NONNEGATIVE = frozenset({"sqrt", "abs"})
"""Functions of which a field knows the square, and no sign."""
SIGNED = NONNEGATIVE | {"sign"}
LACKING = dict.fromkeys(("exp", "log", "power"), "no function of a prime field: a letter")
"""Why functions of the table have no value here."""
LARGEST_ORDER, LARGEST_RADICAND, LARGEST_PRIME = 10**6, 10**9, 1_000


@dataclass
class Parts:
    """Everything that needs a value, inner roots before outer ones."""

    letters: dict[Term, None] = field(default_factory=dict)
    unknown: set[str] = field(default_factory=set)
    """What has relations that the test knows nothing of, in words."""
    angles: dict[Term, Angle] = field(default_factory=dict)
    denominators: dict[Monomial, int] = field(default_factory=dict)
    turned: dict[Monomial, tuple[Term, Term]] = field(default_factory=dict)
    """Cosine and sine of the atoms that are inverse functions."""
    roots: dict[Call, None] = field(default_factory=dict)
    inside: dict[Term, None] = field(default_factory=dict)
    """All parts that are evaluated."""
    order: int = 4

    def note(self, terms: Iterable[Term]) -> None:
        """Collect the parts of terms; raises `UnsupportedError` for what no field has."""
        for term in terms:
            self._visit(term)
        if self.order > LARGEST_ORDER:
            raise UnsupportedError(f"a root of unity of order {self.order} is needed")

    def _visit(self, term: Term) -> None:
        if term in self.inside:
            return
        match term:
            case Number():
                pass
            case Sum() | Product() | Power():
                self.note(term.parts)
            case Call(function=function, arguments=(argument,)) if function in CIRCULAR:
                self._angle(argument)
            case Call(function="sign", arguments=(argument,)):
                self._visit(Call("abs", (argument,)))
            case Call(function=function) if function in NONNEGATIVE:
                self._root(term)
            case _:
                self.letters[term] = None
                if not isinstance(term, Symbol | Pi):
                    self.unknown.add(term.function if isinstance(term, Call) else "integrals")
        self.inside[term] = None

    def _root(self, term: Call) -> None:
        radicand = term.parts[0]
        value = rational(radicand)
        if term.function == "sqrt" and value is not None:
            self.order = lcm(self.order, *(4 * prime for prime in radicand_primes(value)))
            return
        self._visit(radicand)
        self.roots[term] = None

    def _angle(self, argument: Term) -> None:
        multiples, turns = self.angles[argument] = angle_of(argument)
        self.order = lcm(self.order, 2 * turns.denominator)
        for atom, ratio in multiples.items():
            self.denominators[atom] = lcm(self.denominators.get(atom, 1), ratio.denominator)
            self._atom(atom)

    def _atom(self, atom: Monomial) -> None:
        turned = inverse_function(atom)
        if turned is None:
            if not is_independent(atom):
                plain = "plain numbers" if not atom else "no products of symbols"
                self.unknown.add(f"angles that are {plain}")
        elif atom not in self.turned:
            self.turned[atom] = turned
            self.note(turned)


def radicand_primes(number: Fraction) -> dict[int, int]:
    """Factor a rational number, prime -> exponent; raises `UnsupportedError` below 0."""
    if number < 0 or number.numerator * number.denominator > LARGEST_RADICAND:
        raise UnsupportedError(f"the square root of {number} is outside of what is tested")
    primes = prime_factors(number.numerator) if number else {}
    primes |= {prime: -count for prime, count in prime_factors(number.denominator).items()}
    if any(prime > LARGEST_PRIME for prime in primes):
        raise UnsupportedError(f"the square root of {number} is outside of what is tested")
    return primes


def is_plainly_positive(term: Term, positive: Collection[str]) -> bool:
    """Whether a term cannot be negative, as one sees from its signs.

    `positive` names the symbols that are not negative.
    """
    match term:
        case Number(value=value):
            plain = value >= 0
        case Symbol(name=name):
            plain = name in positive
        case Call(function=function):
            plain = function in NONNEGATIVE or sign_of_constant(term) == 1
        case Power(base=base, exponent=exponent):
            plain = exponent % 2 == 0 or is_plainly_positive(base, positive)
        case Sum() | Product():
            plain = all(is_plainly_positive(part, positive) for part in term.parts)
        case _:
            plain = isinstance(term, Pi)
    return plain


def sign_of_constant(term: Term) -> int:
    """Return the sign of the sine or cosine of a rational multiple of pi; 0 if it has none."""
    if not (isinstance(term, Call) and term.function in {"sin", "cos"}):
        return 0
    multiples, turns = angle_of(term.parts[0])
    turns += Fraction(1, 2) if term.function == "cos" else 0
    if multiples or turns.denominator == 1:
        return 0
    return 1 if turns % 2 < 1 else -1


def signed_terms(term: Term, sign: int = 1) -> Iterator[tuple[int, Term]]:
    """Yield the terms of a sum of sums, each with the sign before it."""
    match term:
        case Sum(terms=parts):
            for part in parts:
                yield from signed_terms(part, sign)
        case Product(factors=(Number(value=value), Sum() as inner)) if value == -1:
            yield from signed_terms(inner, -sign)
        case Product(factors=parts):
            minus = sum(isinstance(part, Number) and part.value < 0 for part in parts)
            sizes = (Number(abs(x.value)) if isinstance(x, Number) else x for x in parts)
            yield (-sign if minus % 2 else sign), Product(tuple(sizes))
        case _:
            yield sign, term


def constants_of_angles(parts: Parts) -> list[Term]:
    """Return the sines and cosines of the fractions of pi that occur, with the sign they have."""
    fractions = sorted({a.turns for a in parts.angles.values() if 2 % a.turns.denominator})
    angles = (Product((Number(turns), PI)) for turns in fractions)
    found = [Call(name, (angle,)) for angle in angles for name in ("cos", "sin")]
    signs = [sign_of_constant(each) for each in found]
    return [e if s > 0 else negative(e) for e, s in zip(found, signs, strict=True) if s]


def even_powers(terms: Iterable[Term]) -> list[Term]:
    """Return the even powers in terms."""
    every = (part for term in terms for part in walk(term))
    return [part for part in every if isinstance(part, Power) and part.exponent % 2 == 0]
