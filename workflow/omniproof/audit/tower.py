"""The tower of rings of a formula: radicals in the order in which they are nested."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial

import sympy as sp

from omniproof.audit.angles import CircleChart
from omniproof.audit.conversion import Converter
from omniproof.audit.quotient_ring import Fraction, Polynomial, QuotientRing
from omniproof.audit.radicals import Basis, Extension, Factored, primes_under_roots
from omniproof.audit.separation import Constants
from omniproof.audit.survey import Survey, argument_of


def build(found: Survey, chart: type[CircleChart]) -> tuple[Converter, Basis]:
    """Build the ring that has all roots and signs of a formula, level by level.

    Raises `UnsupportedError` where no real point can exist, or too many factors arise.
    """
    converter = Converter(found, chart)
    basis = Basis(converter.ring)
    factored: dict[sp.Expr, Factored | None] = {}
    while len(factored) < len(found.radicals):
        basis.sign_of = partial(_definite_sign, converter, basis)
        ready = [n for n, inner in found.radicals.items() if inner <= factored.keys()]
        _factor(converter, basis, [node for node in ready if node not in factored], factored)
        basis.settle()
        converter = _extend(converter, basis, factored)
    basis.sign_of = partial(_definite_sign, converter, basis)
    return converter, basis


def _factor(
    converter: Converter,
    basis: Basis,
    nodes: list[sp.Expr],
    factored: dict[sp.Expr, Factored | None],
) -> None:
    """Factor the arguments of radicals; one that was met in another spelling is not factored."""
    ring = converter.ring
    met: list[tuple[Fraction, Factored | None]] = []
    for node in nodes:
        value = _reduced(converter, argument_of(node))
        same = [known for other, known in met if _are_equal(ring, value, other)]
        if same or value.numerator == 0:
            known = same[0] if same else None
        else:
            known = basis.factor_product(_parts(converter, argument_of(node)))
        met.append((value, known))
        factored[node] = known
        if node.is_Pow and known is not None:
            basis.require_positive(known)


def _reduced(converter: Converter, expression: sp.Expr) -> Fraction:
    return Fraction(*(converter.ring.reduce(part) for part in converter.convert(expression)))


def _parts(converter: Converter, product: sp.Expr) -> Iterator[tuple[Fraction, int]]:
    """Yield the factors that are printed, as bases with integer exponents."""
    for factor in sp.Mul.make_args(product):
        if factor.is_Pow and factor.exp.is_Integer:
            yield _reduced(converter, factor.base), int(factor.exp)
        else:
            yield _reduced(converter, factor), 1


def _are_equal(ring: QuotientRing, left: Fraction, right: Fraction) -> bool:
    (a, b), (c, d) = left, right
    return bool(a == c if b == d else ring.times(a, d) == ring.times(c, b))


def _extend(
    converter: Converter, basis: Basis, factored: Mapping[sp.Expr, Factored | None]
) -> Converter:
    """Build a ring with all roots and signs so far, and give every radical its value there."""
    primes = frozenset[int]().union(*(primes_under_roots(f) for f in factored.values() if f))
    found, chart = converter.found, type(converter.chart)
    larger = Converter(found, chart, extra=basis.names(), primes=primes)
    basis.move(larger.ring)
    extension = Extension(basis, larger.field.root)
    for node, known in factored.items():
        larger.radicals[node] = _value(extension, node, known)
    return larger


def _value(extension: Extension, node: sp.Expr, factored: Factored | None) -> Fraction:
    ring = extension.ring
    if factored is None:
        return ring.power(ring.whole(ring.zero), int(node.exp.p) if node.is_Pow else 1)
    if node.is_Pow:
        return ring.power(extension.root(factored), int(node.exp.p))
    if isinstance(node, sp.sign):
        return extension.sign(factored)
    return extension.absolute(factored)


def constants_of(converter: Converter, basis: Basis) -> Constants:
    """Collect the constants of a ring, with the constant roots among the factors."""
    names = set(converter.constant_names)
    radicands = {}
    for place, factor in enumerate(basis.factors):
        name = f"p{place}"
        if name in converter.ring.place and _generators(factor) <= names:
            radicands[name] = (basis.signs[place] or 1) * factor
            names.add(name)
    return converter.constants(radicands)


def _generators(polynomial: Polynomial) -> set[str]:
    """Name the generators that a polynomial contains."""
    names = polynomial.context().names()
    degrees = zip(names, polynomial.degrees(), strict=True)
    return {name for name, degree in degrees if degree}


def _definite_sign(converter: Converter, basis: Basis, factor: Polynomial) -> int | None:
    """Return the sign of a factor where it is plain: squares and positive symbols, one sign."""
    constants = constants_of(converter, basis)
    positive = {name for node, name in converter.symbols.items() if node.is_nonnegative}
    names = list(converter.ring.place)
    signs = set()
    for monomial, coefficient in constants.coefficients(factor).items():
        odd = (names[place] for place, exponent in enumerate(monomial) if exponent % 2)
        if any(name not in positive and not name.startswith("p") for name in odd):
            return None
        signs.add(constants.sign(coefficient))
    return signs.pop() if len(signs) == 1 else None
