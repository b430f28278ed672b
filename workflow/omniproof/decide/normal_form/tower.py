"""The tower of rings of a formula: radicals in the order in which they are nested."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial

from omniproof.decide.normal_form.angles import CircleChart
from omniproof.decide.normal_form.conversion import Converter
from omniproof.decide.normal_form.quotient_ring import Fraction, Polynomial, QuotientRing
from omniproof.decide.normal_form.radicals import (
    Basis,
    Extension,
    Factored,
    generators_of,
    primes_under_roots,
)
from omniproof.decide.normal_form.separation import Constants
from omniproof.decide.normal_form.survey import Survey, is_positive
from omniproof.formula.term import Call, Power, Product, Term

MOST_TERMS_OF_NORM = 100


def build(found: Survey, chart: type[CircleChart]) -> tuple[Converter, Basis]:
    """Build the ring that has all roots and signs of a formula, level by level.

    Raises `UnsupportedError` where no real point can exist, or too many factors arise.
    """
    converter = Converter(found, chart)
    basis = Basis(converter.ring, found.is_independent)
    factored: dict[Call, Factored | None] = {}
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
    nodes: list[Call],
    factored: dict[Call, Factored | None],
) -> None:
    """Factor the arguments of radicals; one that was met in another spelling is not factored."""
    ring = converter.ring
    met: list[tuple[Fraction, Factored | None]] = []
    for node in nodes:
        value = _reduced(converter, node.arguments[0])
        same = [known for other, known in met if _are_equal(ring, value, other)]
        if same or value.numerator == 0:
            known = same[0] if same else None
        else:
            known = basis.factor_product(_parts(converter, node.arguments[0]))
        met.append((value, known))
        factored[node] = known
        if node.function == "sqrt" and known is not None:
            basis.require_positive(known)


def _reduced(converter: Converter, term: Term) -> Fraction:
    return Fraction(*(converter.ring.reduce(part) for part in converter.convert(term)))


def _parts(converter: Converter, term: Term) -> Iterator[tuple[Fraction, int]]:
    """Yield the factors that are printed, as bases with integer exponents."""
    match term:
        case Product(factors=factors):
            for factor in factors:
                yield from _parts(converter, factor)
        case Power(base=base, exponent=exponent):
            for value, count in _parts(converter, base):
                yield value, count * exponent
        case _:
            yield _reduced(converter, term), 1


def _are_equal(ring: QuotientRing, left: Fraction, right: Fraction) -> bool:
    (a, b), (c, d) = left, right
    return bool(a == c if b == d else ring.times(a, d) == ring.times(c, b))


def _extend(
    converter: Converter, basis: Basis, factored: Mapping[Call, Factored | None]
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


def _value(extension: Extension, node: Call, factored: Factored | None) -> Fraction:
    """Return what a radical is; nothing is known of the sign of what is zero."""
    ring = extension.ring
    if factored is None:
        return ring.whole(ring.zero)
    known = {"sqrt": extension.root, "sign": extension.sign, "abs": extension.absolute}
    return known[node.function](factored)


def constants_of(converter: Converter, basis: Basis) -> Constants:
    """Collect the constants of a ring, with the constant roots among the factors."""
    names = set(converter.constant_names)
    radicands = {}
    for place, factor in enumerate(basis.factors):
        name = f"p{place}"
        if name in converter.ring.place and generators_of(factor) <= names:
            radicands[name] = (basis.signs[place] or 1) * factor
            names.add(name)
    return converter.constants(radicands)


def _definite_sign(converter: Converter, basis: Basis, factor: Polynomial) -> int | None:
    """Return the sign of a factor where it is plain, or where the larger part of A + B p has one.

    The norm A^2 - B^2 p^2 tells which part is larger: sqrt(x^2 + y^2) - x has the norm -y^2.
    """
    plain = _sign_of_terms(converter, basis, factor)
    roots = [int(name[1:]) for name in generators_of(factor) if name.startswith("p")]
    if plain is not None or not roots or len(factor) > MOST_TERMS_OF_NORM:
        return plain
    root = f"p{max(roots)}"  # the outermost: its square has no root further out
    rest, rate = _in_root(converter.ring, factor, root)
    square = converter.ring.generators[root] ** 2
    norm = converter.ring.reduce(rest**2 - rate**2 * square)
    sign = _definite_sign(converter, basis, norm)
    return None if sign is None else _definite_sign(converter, basis, rest if sign > 0 else rate)


def _in_root(ring: QuotientRing, factor: Polynomial, root: str) -> tuple[Polynomial, Polynomial]:
    """Return A and B of A + B p, of which p is a root."""
    generator = ring.generators[root]
    reduced = ring.reduce(factor)
    rest = reduced.subs({root: 0})
    return rest, (reduced - rest) / generator


def _sign_of_terms(converter: Converter, basis: Basis, factor: Polynomial) -> int | None:
    """Return the sign that all terms have: squares, positive symbols and roots are positive."""
    constants = constants_of(converter, basis)
    known = converter.found.positive
    positive = {name for term, name in converter.symbols.items() if is_positive(term, known)}
    names = list(converter.ring.place)
    signs = set()
    for monomial, coefficient in constants.coefficients(factor).items():
        odd = (names[place] for place, exponent in enumerate(monomial) if exponent % 2)
        if any(name not in positive and not name.startswith("p") for name in odd):
            return None
        signs.add(constants.sign(coefficient))
    return signs.pop() if signs in ({1}, {-1}) else None
