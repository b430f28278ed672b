"""What an expression is made of, before any algebra: angles, constants, radicals, free symbols.

The rings of the normal form need all generators at once, so one walk over the expression collects
them. Whatever is not algebraic or trigonometric (exp(x), atan2(y, x), x**(1/3)) becomes an
independent *symbol* of its own: proofs stay sound, and what would need its special relations stays
undecided.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from math import lcm
from typing import Any

import sympy as sp

from omniproof.audit.angles import TRIGONOMETRIC, Angle, read_angle
from omniproof.audit.balls import UnsupportedError, WorkLimitError
from omniproof.audit.constant_field import field_order, square_free_part

MOST_NODES = 20_000
HALF = sp.Rational(1, 2)


@dataclass
class Survey:
    """Everything that needs a generator, in the order in which it is met (inner ones first)."""

    angles: dict[sp.Expr, Angle] = field(default_factory=dict)
    denominators: dict[sp.Expr, int] = field(default_factory=dict)
    order: int = 1
    primes: set[int] = field(default_factory=set)
    symbols: dict[sp.Expr, None] = field(default_factory=dict)
    constant_roots: dict[sp.Expr, None] = field(default_factory=dict)
    radicals: dict[sp.Expr, frozenset[sp.Expr]] = field(default_factory=dict)  # with inner ones
    trigonometric_radicals: bool = False

    @property
    def is_independent(self) -> bool:
        """Whether the generators without roots are algebraically independent as functions.

        Symbols and the sines and cosines of different monomials are (Ax, Annals of Mathematics 93,
        1971); x, sin x and sin |x| are not, nor are x and x**(1/3).
        """
        plain = all(node.is_Symbol or node is sp.pi for node in self.symbols)
        return plain and all(_is_monomial(atom) for atom in self.denominators)


def _is_monomial(atom: sp.Expr) -> bool:
    """Whether an angle is a product of integer powers of symbols, perhaps times pi."""
    powers = [factor.as_base_exp() for factor in sp.Mul.make_args(atom) if factor is not sp.pi]
    return bool(powers) and all(base.is_Symbol and count.is_Integer for base, count in powers)


def survey(expressions: Iterable[sp.Expr]) -> Survey:
    """Collect the generators of expressions.

    Raises `UnsupportedError` for what is not a real formula.
    """
    surveyor = _Surveyor()
    for expression in expressions:
        surveyor.visit(expression)
    found = surveyor.found
    order = lcm(found.order, 4) if found.radicals else found.order
    found.order = field_order(order, found.primes)
    return found


def is_root(node: sp.Expr) -> bool:
    """Whether a node is an odd power of a square root, or of a root of such a root."""
    if not (node.is_Pow and node.exp.is_Rational):
        return False
    order = int(node.exp.q)
    return order > 1 and order & (order - 1) == 0


def argument_of(node: sp.Expr) -> sp.Expr:
    """Return the radicand of a square root, or the argument of an absolute value."""
    if node.is_Pow:
        return sp.Pow(node.base, sp.Rational(2, node.exp.q))
    return node.args[0]


def opaque_core(node: sp.Expr) -> tuple[sp.Expr, int]:
    """Write x**(p/q) as a power of the symbol x**(1/q); anything else is a symbol itself."""
    if node.is_Pow and node.exp.is_Rational:
        return sp.Pow(node.base, sp.Rational(1, node.exp.q)), int(node.exp.p)
    return node, 1


class _Surveyor:
    def __init__(self) -> None:
        self.found = Survey()
        self.seen: set[sp.Expr] = set()

    def visit(self, node: sp.Expr) -> None:
        if node in self.seen:
            return
        if len(self.seen) > MOST_NODES:
            raise WorkLimitError(f"the formula has more than {MOST_NODES} different parts")
        if isinstance(node, TRIGONOMETRIC):
            self.trigonometric(node)
        elif is_root(node) or isinstance(node, (sp.Abs, sp.sign)):
            self.radical(node)
        elif node.is_Add or node.is_Mul or (node.is_Pow and node.exp.is_Integer):
            for argument in node.args:
                self.visit(argument)
        elif not node.is_Rational:
            self.opaque(node)
        self.seen.add(node)

    def trigonometric(self, node: sp.Expr) -> None:
        angle = self.found.angles[node.args[0]] = read_angle(node.args[0])
        self.found.order = lcm(self.found.order, int(angle.turns.q))
        for atom, factor in angle.multiples.items():
            self.refuse(atom)
            known = self.found.denominators.get(atom, 1)
            self.found.denominators[atom] = lcm(known, int(factor.q))

    def radical(self, node: sp.Expr) -> None:
        argument = argument_of(node)
        if argument.is_Rational:
            self.found.primes.update(square_free_part(abs(argument))[1] if argument else ())
            return
        self.visit(argument)
        if not argument.free_symbols:
            if node.is_Pow:
                self.found.constant_roots[argument] = None
        else:
            parts = frozenset(sp.preorder_traversal(argument))
            self.found.radicals[node] = parts & self.found.radicals.keys()
            self.found.trigonometric_radicals |= argument.has(*TRIGONOMETRIC)

    def opaque(self, node: sp.Expr) -> None:
        self.refuse(node)
        self.found.symbols[opaque_core(node)[0]] = None

    @staticmethod
    def refuse(node: Any) -> None:
        """Raise `UnsupportedError` for what is not an exact real quantity."""
        if node.is_Symbol and node.is_commutative:
            return
        if not isinstance(node, sp.Expr):
            raise UnsupportedError(f"{type(node).__name__} is not a formula")
        if node.has(sp.nan, sp.zoo, sp.oo, -sp.oo):
            raise UnsupportedError("it contains a division by zero or another undefined value")
        if node.has(sp.I):
            raise UnsupportedError("it contains the imaginary unit")
        if node.has(sp.Float):
            raise UnsupportedError(f"{node} is a floating-point number, not an exact one")
        if node.is_commutative is False:
            raise UnsupportedError(f"{node} does not commute")
