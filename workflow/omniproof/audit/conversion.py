"""From a SymPy expression to a fraction of the ring, node by node."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp
from flint import ctx

from omniproof.audit.angles import TRIGONOMETRIC, CircleChart
from omniproof.audit.balls import Ball, UnsupportedError, evaluate, sign_of
from omniproof.audit.constant_field import ConstantField, generator_names
from omniproof.audit.quotient_ring import Fraction, Polynomial, QuotientRing
from omniproof.audit.separation import Constants
from omniproof.audit.survey import Survey, argument_of, is_root, opaque_core


class Converter:
    """One ring with the generators of a survey, and the expressions in it.

    `extra` are names of generators above all others. `radicals` gives the roots and absolute values
    of variable arguments, node by node; constants of this kind are handled here.
    """

    def __init__(
        self,
        found: Survey,
        chart: type[CircleChart],
        *,
        extra: Sequence[str] = (),
        primes: frozenset[int] = frozenset(),
    ) -> None:
        self.found = found
        self.roots = [f"w{place}" for place in range(len(found.constant_roots))]
        primes = primes | frozenset(found.primes)
        self.symbols = {symbol: f"x{place}" for place, symbol in enumerate(found.symbols)}
        self.ring = QuotientRing(
            [
                *extra,
                *reversed(self.roots),
                *generator_names(found.order, primes),
                *chart.names(len(found.denominators)),
                *self.symbols.values(),
            ]
        )
        self.field = ConstantField(self.ring, found.order, primes)
        self.chart = chart(self.ring, self.field, found.denominators)
        self.known: dict[sp.Expr, Fraction] = {}
        self.radicals: dict[sp.Expr, Fraction] = {}
        self.squares: dict[str, Fraction] = {}
        for radicand, name in zip(found.constant_roots, self.roots, strict=True):
            self.radicals[radicand] = self.adjoin(name, self.convert(radicand))

    def adjoin(self, name: str, square: Fraction) -> Fraction:
        """Let the named generator be root times denominator of a fraction; return the root."""
        generator = self.ring.generators[name]
        self.squares[name] = square
        product = self.ring.times(square.numerator, square.denominator)
        self.ring.relate(name, generator**2 - product)
        return Fraction(generator, square.denominator)

    def constants(self, radicands: Mapping[str, Polynomial] | None = None) -> Constants:
        """Return the numbers of this ring, with further constant roots, the innermost first."""
        more = dict(radicands or {})
        roots = [*reversed(more), *reversed(self.roots)]
        names = self.constant_names.union(more)
        return Constants(self.ring, names, roots, lambda: self._constant_balls(more))

    @property
    def constant_names(self) -> frozenset[str]:
        """Names of the generators that are numbers: pi stands for itself, as a free one."""
        numbers = (name for node, name in self.symbols.items() if not node.free_symbols)
        return frozenset((*self.roots, *self.field.names, *numbers))

    def convert(self, node: sp.Expr) -> Fraction:
        """Return the fraction that an expression is."""
        result = self.known.get(node)
        if result is None:
            result = self.known[node] = self._convert(node)
        return result

    def _convert(self, node: sp.Expr) -> Fraction:
        if node.is_Rational:
            return self.ring.rational(node)
        if node.is_Add or node.is_Mul:
            return self._fold(self.ring.add if node.is_Add else self.ring.multiply, node.args)
        if node.is_Pow and node.exp.is_Integer:
            return self.ring.power(self.convert(node.base), int(node.exp))
        if isinstance(node, TRIGONOMETRIC):
            return self._trigonometric(node)
        if is_root(node) or isinstance(node, (sp.Abs, sp.sign)):
            return self._radical(node)
        core, exponent = opaque_core(node)
        symbol = self.ring.generators[self.symbols[core]]
        return self.ring.power(self.ring.whole(symbol), exponent)

    def _fold(
        self, combine: Callable[[Fraction, Fraction], Fraction], nodes: Sequence[sp.Expr]
    ) -> Fraction:
        result, *rest = (self.convert(node) for node in nodes)
        for other in rest:
            result = combine(result, other)
        return result

    def _trigonometric(self, node: sp.Expr) -> Fraction:
        cosine, sine, common = self.chart.cosine_sine(self.found.angles[node.args[0]])
        pairs = {
            sp.cos: (cosine, common),
            sp.sin: (sine, common),
            sp.tan: (sine, cosine),
            sp.cot: (cosine, sine),
            sp.sec: (common, cosine),
            sp.csc: (common, sine),
        }
        numerator, denominator = pairs[type(node)]
        if denominator == 0:
            raise UnsupportedError("a denominator is identically zero")
        return Fraction(self.ring.reduce(numerator), self.ring.reduce(denominator))

    def _radical(self, node: sp.Expr) -> Fraction:
        argument = argument_of(node)
        if argument.free_symbols:
            return self.radicals[node]
        if not node.is_Pow:
            return self._absolute_constant(node, argument)
        rational = argument.is_Rational
        root = self._rational_root(argument) if rational else self.radicals[argument]
        return self.ring.power(root, int(node.exp.p))

    def _rational_root(self, value: Any) -> Fraction:
        if value < 0:
            raise UnsupportedError(f"the square root of {value} is not real")
        return self.field.root(value) if value else self.ring.whole(self.ring.zero)

    def _absolute_constant(self, node: sp.Expr, argument: sp.Expr) -> Fraction:
        sign = sign_of(evaluate(argument, precision=512))
        if sign is None:
            raise UnsupportedError(f"the sign of {argument} is not clear")
        factor = sp.S.One if node.func is sp.sign else argument
        return self._fold(self.ring.multiply, [sp.Integer(sign), factor])

    def _constant_balls(self, more: Mapping[str, Polynomial]) -> dict[str, Ball]:
        """Enclose all constant generators; a root w of n/d, times d, is d sqrt(n/d)."""
        balls: dict[str, Ball] = self.field.balls()
        for node, name in self.symbols.items():
            if not node.free_symbols:
                balls[name] = evaluate(node, precision=ctx.prec)
        known = Constants(self.ring, frozenset(), (), lambda: balls)
        for name in self.roots:
            square = self.squares[name]
            below = known.enclose(square.denominator, balls)
            balls[name] = below * (known.enclose(square.numerator, balls) / below).sqrt()
        for name, radicand in more.items():
            balls[name] = known.enclose(radicand, balls).sqrt()
        return balls
