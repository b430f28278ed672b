"""From a term to a fraction of the ring, part by part."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction as Rational

from flint import ctx

from omniproof.decide.balls import Ball, enclose, sign_of
from omniproof.decide.normal_form.angles import CircleChart
from omniproof.decide.normal_form.constant_field import ConstantField, generator_names
from omniproof.decide.normal_form.quotient_ring import Fraction, Polynomial, QuotientRing
from omniproof.decide.normal_form.separation import Constants
from omniproof.decide.normal_form.survey import SIGNED, Survey
from omniproof.formula.angle import circular
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.term import Call, Number, Power, Product, Sum, Term, rational, symbols


class Converter:
    """One ring with the generators of a survey, and the terms in it.

    `extra` are names of generators above all others. `radicals` gives the roots and absolute values
    of variable arguments, one by one; constants of this kind are handled here.
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
        self.known: dict[Term, Fraction] = {}
        self.radicals: dict[Call, Fraction] = {}
        self.constant_roots: dict[Term, Fraction] = {}
        self.squares: dict[str, Fraction] = {}
        for radicand, name in zip(found.constant_roots, self.roots, strict=True):
            self.constant_roots[radicand] = self.adjoin(name, self.convert(radicand))

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
        numbers = (name for term, name in self.symbols.items() if not symbols(term))
        return frozenset((*self.roots, *self.field.names, *numbers))

    def convert(self, term: Term) -> Fraction:
        """Return the fraction that a term is."""
        result = self.known.get(term)
        if result is None:
            result = self.known[term] = self._convert(term)
        return result

    def _convert(self, term: Term) -> Fraction:
        match term:
            case Number(value=value):
                result = self.ring.rational(value)
            case Sum(terms=parts):
                result = self._fold(self.ring.add, parts)
            case Product(factors=parts):
                result = self._fold(self.ring.multiply, parts)
            case Power(base=base, exponent=exponent):
                result = self.ring.power(self.convert(base), exponent)
            case Call(function=function) if function in CIRCULAR:
                result = self._trigonometric(term)
            case Call(function=function) if function in SIGNED:
                result = self._radical(term)
            case _:
                result = self.ring.whole(self.ring.generators[self.symbols[term]])
        return result

    def _fold(
        self, combine: Callable[[Fraction, Fraction], Fraction], terms: Sequence[Term]
    ) -> Fraction:
        result, *rest = map(self.convert, terms)
        for other in rest:
            result = combine(result, other)
        return result

    def _trigonometric(self, term: Call) -> Fraction:
        cosine, sine, common = self.chart.cosine_sine(self.found.angles[term.arguments[0]])
        numerator, denominator = circular(term.function, common, cosine, sine)
        if denominator == 0:
            raise UnsupportedError("a denominator is identically zero")
        return Fraction(self.ring.reduce(numerator), self.ring.reduce(denominator))

    def _radical(self, term: Call) -> Fraction:
        (argument,) = term.arguments
        if symbols(argument):
            return self.radicals[term]
        if term.function != "sqrt":
            return self._signed_constant(term.function, argument)
        value = rational(argument)
        return self.constant_roots[argument] if value is None else self._rational_root(value)

    def _rational_root(self, value: Rational) -> Fraction:
        if value < 0:
            raise UnsupportedError(f"the square root of {value} is not real")
        return self.field.root(value) if value else self.ring.whole(self.ring.zero)

    def _signed_constant(self, function: str, argument: Term) -> Fraction:
        sign = sign_of(enclose(argument, precision=512))
        if sign is None:
            raise UnsupportedError("the sign of a number is not clear")
        unit = self.ring.rational(Rational(sign))
        if function == "sign":
            return unit
        return self.ring.multiply(unit, self.convert(argument))

    def _constant_balls(self, more: Mapping[str, Polynomial]) -> dict[str, Ball]:
        """Enclose all constant generators; a root w of n/d, times d, is d sqrt(n/d)."""
        balls: dict[str, Ball] = self.field.balls()
        for term, name in self.symbols.items():
            if not symbols(term):
                balls[name] = enclose(term, precision=ctx.prec)
        known = Constants(self.ring, frozenset(), (), lambda: balls)
        for name in self.roots:
            square = self.squares[name]
            below = known.enclose(square.denominator, balls)
            balls[name] = below * (known.enclose(square.numerator, balls) / below).sqrt()
        for name, radicand in more.items():
            balls[name] = known.enclose(radicand, balls).sqrt()
        return balls
