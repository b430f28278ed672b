"""What a formula needs in a prime field, and how far its numerator can grow there.

Letters (symbols, and functions that the test knows nothing of) get random values. An angle is split
into atoms: sin(x/2 + y) needs e^(ix/2) and e^(iy). A root or an absolute value is a number with
known square and open sign. `Growth` bounds degree and coefficients of the formula as a fraction of
polynomials in all of these: it is what the probability of a wrong "zero" is computed from.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm
from typing import Any, NamedTuple

import sympy as sp

from omniproof.decide.prime_fields.field import prime_factors

CIRCULAR = (sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc)
UNDEFINED = (sp.nan, sp.zoo, sp.oo, -sp.oo, sp.I, sp.Float)
LARGEST_ORDER, LARGEST_RADICAND, LARGEST_PRIME = 10**6, 10**9, 1_000

Root = tuple[sp.Expr, int]
"""(f, k): f^(1/2^k), the non-negative root; (f, 0): the absolute value of f."""


class OutsideError(ValueError):
    """The formula is outside of what this engine tests; its text says why."""


class Angle(NamedTuple):
    """Sum of rational multiples of atoms, plus `turns` times pi."""

    multiples: dict[sp.Expr, Fraction]
    turns: Fraction


class Growth(NamedTuple):
    """Degrees, and bits of the sum of sizes of coefficients, of numerator and denominator."""

    degree: float
    below: float
    bits: float
    bits_below: float

    def times(self, other: Growth) -> Growth:
        """Bound a product."""
        return Growth(*(mine + its for mine, its in zip(self, other, strict=True)))

    def power(self, exponent: int) -> Growth:
        """Bound a power; the inverse for a negative exponent."""
        parts = self if exponent >= 0 else (self.below, self.degree, self.bits_below, self.bits)
        return Growth(*(abs(exponent) * part for part in parts))

    def root(self) -> Growth:
        """Bound a square root, written as sqrt(numerator * denominator) / denominator."""
        return Growth(
            (self.degree + self.below) / 2, self.below,
            (self.bits + self.bits_below) / 2, self.bits_below,
        )  # fmt: skip


NOTHING = Growth(0, 0, 0, 0)


def sum_of(parts: Iterable[Growth]) -> Growth:
    """Bound a sum, written over the product of all denominators."""
    parts = list(parts)
    below, bits_below = sum(part.below for part in parts), sum(part.bits_below for part in parts)
    degree = max(part.degree - part.below for part in parts) + below
    bits = max(part.bits - part.bits_below for part in parts) + bits_below
    return Growth(degree, below, bits + len(parts).bit_length(), bits_below)


@dataclass
class Parts:
    """Everything that needs a value, in the order in which it is met (inner roots first)."""

    letters: dict[sp.Expr, None] = field(default_factory=dict)
    unknown: dict[sp.Expr, None] = field(
        default_factory=dict
    )  # letters with relations of their own
    angles: dict[sp.Expr, Angle] = field(default_factory=dict)
    denominators: dict[sp.Expr, int] = field(default_factory=dict)
    roots: dict[Root, None] = field(default_factory=dict)
    sums: dict[sp.Expr, None] = field(default_factory=dict)
    powers: dict[sp.Expr, None] = field(default_factory=dict)  # with integer exponents
    order: int = 4


def parts_of(formulas: Iterable[sp.Expr]) -> Parts:
    """Collect the parts of formulas; raises `OutsideError` for what has no place in a field."""
    found, seen = Parts(), set[sp.Expr]()
    for formula in formulas:
        if not isinstance(formula, sp.Expr) or formula.has(*UNDEFINED):
            raise OutsideError(f"{formula} is not an exact real formula")
        _visit(formula, found, seen)
    if found.order > LARGEST_ORDER:
        raise OutsideError(f"a root of unity of order {found.order} is needed")
    return found


def _visit(node: sp.Expr, found: Parts, seen: set[sp.Expr]) -> None:
    if node in seen or node.is_Rational:
        return
    seen.add(node)
    if isinstance(node, CIRCULAR):
        _angle(node.args[0], found)
    elif isinstance(node, (sp.Abs, sp.sign)):
        _visit(node.args[0], found, seen)
        found.roots[node.args[0], 0] = None
    elif level := root_level(node):
        _root(node.base, level, found, seen)
    elif node.is_Add or node.is_Mul or (node.is_Pow and node.exp.is_Integer):
        for argument in node.args:
            _visit(argument, found, seen)
        if node.is_Add:
            found.sums[node] = None
        elif node.is_Pow:
            found.powers[node] = None
    else:
        found.letters[node] = None
        if not (node.is_Symbol or node is sp.pi):
            found.unknown[node] = None


def root_level(node: sp.Expr) -> int:
    """Return k for a power with exponent n/2^k, n odd and k > 0; 0 for anything else."""
    if not (node.is_Pow and node.exp.is_Rational):
        return 0
    order = int(node.exp.q)
    return order.bit_length() - 1 if order & (order - 1) == 0 else 0


def is_plainly_positive(node: sp.Expr) -> bool:
    """Whether a formula cannot be negative, as one sees from its signs."""
    if node.is_Rational or node.is_Symbol or node is sp.pi:
        return bool(node.is_nonnegative)
    if isinstance(node, sp.Abs) or root_level(node):
        return True
    if isinstance(node, (sp.sin, sp.cos)):
        return sign_of_constant(node) == 1
    if node.is_Pow and node.exp.is_Integer:
        return node.exp.is_even or is_plainly_positive(node.base)
    return (node.is_Add or node.is_Mul) and all(map(is_plainly_positive, node.args))


def sign_of_constant(node: sp.Expr) -> int:
    """Return the sign of the sine or cosine of a rational multiple of pi; 0 if it has none."""
    turns = node.args[0] / sp.pi + (sp.Rational(1, 2) if isinstance(node, sp.cos) else 0)
    if not turns.is_Rational or turns.is_Integer:
        return 0
    return 1 if turns % 2 < 1 else -1


def _root(base: sp.Expr, level: int, found: Parts, seen: set[sp.Expr]) -> None:
    _visit(base, found, seen)
    if base.is_Rational:
        found.order = lcm(found.order, *(4 * prime for prime in radicand_primes(base)))
    for k in range(2 if base.is_Rational else 1, level + 1):
        found.roots[base, k] = None


def radicand_primes(number: sp.Rational) -> dict[int, int]:
    """Factor a positive rational number, prime -> exponent; raises `OutsideError`."""
    if number.p <= 0 or number.p * number.q > LARGEST_RADICAND:
        raise OutsideError(f"the square root of {number} is outside of what is tested")
    primes = prime_factors(int(number.p))
    primes |= {prime: -exponent for prime, exponent in prime_factors(int(number.q)).items()}
    if any(prime > LARGEST_PRIME for prime in primes):
        raise OutsideError(f"the square root of {number} is outside of what is tested")
    return primes


def _angle(argument: sp.Expr, found: Parts) -> None:
    multiples: dict[sp.Expr, Fraction] = {}
    turns = Fraction(0)
    terms = [term.as_coeff_Mul() for term in sp.Add.make_args(argument)]
    if not all(atom.is_Atom for _, atom in terms):
        terms = [term.as_coeff_Mul() for term in sp.Add.make_args(sp.expand(argument))]
    for factor, atom in terms:
        ratio = Fraction(int(factor.p), int(factor.q))
        if atom is sp.pi:
            turns += ratio
        elif ratio:
            multiples[atom] = multiples.get(atom, Fraction(0)) + ratio
    found.angles[argument] = Angle(multiples, turns)
    found.order = lcm(found.order, 2 * turns.denominator)
    for atom, ratio in multiples.items():
        found.denominators[atom] = lcm(found.denominators.get(atom, 1), ratio.denominator)
        if not _is_monomial(atom):  # such atoms can depend on each other
            found.unknown[atom] = None


def _is_monomial(atom: sp.Expr) -> bool:
    """Whether an atom is a product of integer powers of symbols and pi, with a symbol in it."""
    bases = [factor.as_base_exp() for factor in sp.Mul.make_args(atom)]
    plain = all((base.is_Symbol or base is sp.pi) and power.is_Integer for base, power in bases)
    return plain and bool(atom.free_symbols)


class Bounds:
    """Growth of formulas with the given parts."""

    def __init__(self, parts: Parts) -> None:
        self.parts, self.known = parts, dict[Any, Growth]()

    def of(self, node: sp.Expr) -> Growth:
        """Bound a formula as a fraction of polynomials."""
        if node not in self.known:
            self.known[node] = self._compute(node)
        return self.known[node]

    def _compute(self, node: sp.Expr) -> Growth:
        if node in self.parts.letters:
            return NOTHING._replace(degree=1)
        if node.is_Rational:
            return Growth(0, 0, int(node.p).bit_length(), int(node.q).bit_length())
        if node.is_Add:
            return sum_of(map(self.of, node.args))
        if node.is_Mul:
            return self._product(map(self.of, node.args))
        return self._power(node) if node.is_Pow else self._function(node)

    def _function(self, node: sp.Expr) -> Growth:
        if isinstance(node, CIRCULAR):
            return self._circular(node)
        size = self.of(node.args[0])
        return size.times(size.power(-1)) if isinstance(node, sp.sign) else size

    def _power(self, node: sp.Expr) -> Growth:
        base, level = self.of(node.base), root_level(node)
        for _ in range(level):
            base = base.root()
        return base.power(int(node.exp.p))

    def _circular(self, node: sp.Expr) -> Growth:
        """Bound (z^n + z^-n)/2 and the like by polynomials of degree 2n over 2 z^n."""
        angle = self.parts.angles[node.args[0]]
        steps = sum(abs(int(f * self.parts.denominators[a])) for a, f in angle.multiples.items())
        return Growth(2 * steps, 2 * steps, 1, 1)

    @staticmethod
    def _product(parts: Iterable[Growth]) -> Growth:
        total = NOTHING
        for part in parts:
            total = total.times(part)
        return total
