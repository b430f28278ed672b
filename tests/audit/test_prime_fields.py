"""The modular engine: its fields, its bounds, and its answers against 50-digit arithmetic."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from random import Random

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from identity_table import ROWS, a, b, x, y, z

from omniproof.decide.prime_fields.field import BITS, is_prime, prime_factors, prime_field
from omniproof.decide.prime_fields.growth import Bounds, Growth
from omniproof.decide.prime_fields.parts import Parts, is_plainly_positive, sign_of_constant
from omniproof.decide.prime_fields.zero import (
    WANTED,
    Mixed,
    ModularAnswer,
    NonZero,
    Unsupported,
    Zero,
    vanishes,
)
from omniproof.formula.sympy_terms import positive_names, term_of
from omniproof.formula.term import PI, Call, Number, Product

ORDERS = [4, 24, 4 * 5 * 7, 4 * 11, 4 * 13]


def vanishes_modulo(formula: sp.Expr, nonnegative: Sequence[sp.Expr] = ()) -> ModularAnswer:
    """Ask of an expression of SymPy, and of what it assumes of its symbols."""
    return vanishes(term_of(formula), [*map(term_of, nonnegative)], positive_names(formula))


def growth_of(formula: sp.Expr) -> Growth:
    parts = Parts()
    parts.note([term_of(formula)])
    return Bounds(parts).of(term_of(formula))


@pytest.mark.parametrize("order", ORDERS)
def test_a_field_has_a_root_of_unity_of_its_order(order: int) -> None:
    field = prime_field(order, 0)
    assert field.prime.bit_length() == BITS
    assert sp.isprime(field.prime)
    powers = {pow(field.zeta, k, field.prime) for k in range(order)}
    assert len(powers) == order
    assert field.unit(1, 2) ** 2 % field.prime == field.prime - 1


@pytest.mark.parametrize("prime", [2, 3, 5, 7, 11, 13, 31])
def test_roots_of_primes_agree_with_cosines(prime: int) -> None:
    """The square is right, and the sign is that of the Gauss sum, where a cosine tells it."""
    field = prime_field(8 * prime, 0)
    root = field.root_of_prime(prime)
    assert root * root % field.prime == prime
    cosines = {2: (1, 4, 0), 3: (1, 6, 0), 5: (1, 5, 1)}  # sqrt(5) = 4 cos(pi/5) - 1
    if prime in cosines:
        field = prime_field(120, 0)
        above, below, less = cosines[prime]
        twice = field.unit(above, below) + field.unit(-above, below)
        expected = 2 * twice - less if less else twice
        assert (field.root_of_prime(prime) - expected) % field.prime == 0


@given(st.integers(0, 2**130), st.sampled_from(ORDERS))
def test_square_roots(value: int, order: int) -> None:
    field = prime_field(order, 1)
    root = field.square_root(value * value)
    assert root is not None
    assert (root * root - value * value) % field.prime == 0
    other = field.square_root(value)
    assert (other is None) == (sp.jacobi_symbol(value % field.prime, field.prime) == -1)


def test_zero_has_no_inverse() -> None:
    with pytest.raises(ZeroDivisionError):
        prime_field(4, 0).inverse(0)


@pytest.mark.parametrize("number", [10**9 + 7, 2**61 - 1, 2**127 - 1])
def test_primes_pass(number: int) -> None:
    assert is_prime(number, Random(1))


@pytest.mark.parametrize("number", [(10**9 + 7) * (10**9 + 9), 3215031751, 2**67 - 1])
def test_composites_do_not_pass(number: int) -> None:
    assert not is_prime(number, Random(1))


def test_factors() -> None:
    assert prime_factors(360 * 997) == {2: 3, 3: 2, 5: 1, 997: 1}


def test_every_zero_has_a_bound_below_the_wanted_one() -> None:
    found = [vanishes_modulo(row.left - row.right) for row in ROWS]
    bounds = [answer.bound for answer in found if isinstance(answer, Zero)]
    assert len(bounds) > 40
    assert WANTED == 1e-30
    assert all(0 < bound < WANTED for bound in bounds)


@pytest.mark.parametrize(
    ("formula", "degrees"),
    [
        pytest.param(x * y + 1, (2, 0), id="a product"),
        pytest.param(1 / x + 1 / y, (1, 2), id="a sum of fractions"),
        pytest.param((x + 1) ** -3, (0, 3), id="an inverse power"),
        pytest.param(sp.sin(2 * x + y), (6, 6), id="(z^2 w - 1/(z^2 w)) / 2i over z^2 w"),
        pytest.param(sp.sin(x / 2) * sp.cos(x), (6, 6), id="z = e^(ix/2)"),
        pytest.param(sp.sqrt(x**2 + 1), (1, 0), id="the root of a square is linear"),
        pytest.param(sp.sqrt(1 + 1 / x), (1, 1), id="the root of a fraction"),
        pytest.param(sp.Abs(x * y), (2, 0), id="an absolute value"),
        pytest.param(sp.sign(x), (1, 1), id="a sign is a quotient"),
    ],
)
def test_degrees(formula: sp.Expr, degrees: tuple[int, int]) -> None:
    assert growth_of(formula)[:2] == degrees


@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(0, 3), st.integers(0, 3)), min_size=1))
def test_bounds_hold_for_polynomials(terms: list[tuple[int, int, int]]) -> None:
    """Degree and sum of the sizes of coefficients, against SymPy's polynomials."""
    formula = sp.Mul(sp.Add(*(n * x**i * y**j for n, i, j in terms)), x + y - 1, evaluate=False)
    growth = growth_of(formula)
    polynomial = sp.Poly(formula, x, y)
    assert polynomial.is_zero or polynomial.total_degree() <= growth.degree
    assert sum(map(abs, polynomial.coeffs())) <= 2 ** Fraction(growth.bits)


@pytest.mark.parametrize(
    ("formula", "reason"),
    [
        pytest.param(sp.exp(x) - x, "relations of exp are", id="exp may be related"),
        pytest.param(sp.sin(1) - 1, "relations of angles that are plain", id="e^i, pi"),
        pytest.param(sp.sqrt(sp.Integer(10007)), "square root", id="10007"),
        pytest.param(sp.cos(sp.pi / 10**7), "order", id="a fine angle"),
        pytest.param(1 / (sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1), "points", id="zero below"),
        pytest.param(sum(sp.Abs(x - k) for k in range(8)), "more than 6", id="many signs"),
    ],
)  # fmt: skip
def test_what_is_not_tested_says_why(formula: sp.Expr, reason: str) -> None:
    found = vanishes_modulo(formula)
    assert isinstance(found, Unsupported)
    assert re.search(reason, found.reason), found.reason


def test_unknown_functions_still_cancel() -> None:
    unknown = sp.log(a)
    assert isinstance(vanishes_modulo((unknown + 1) ** 2 - unknown**2 - 2 * unknown - 1), Zero)


@pytest.mark.parametrize(
    ("formula", "non_negative", "kind"),
    [
        pytest.param(sp.Abs(x) - x, [], Mixed, id="the sign of x is open"),
        pytest.param(sp.Abs(x) - x, [x], Zero, id="x is positive"),
        pytest.param(sp.Abs(x) - x, [-x], NonZero, id="x is negative"),
        pytest.param(sp.Abs(a) - a, [], Zero, id="a is positive by assumption"),
        pytest.param(sp.sign(x) * x - sp.Abs(x), [], Zero, id="sign"),
        pytest.param(sp.sqrt(x) + sp.sqrt(y) + 1, [], NonZero, id="a sum of roots is not zero"),
        pytest.param(sp.sqrt(4 * x) - 2 * sp.sqrt(x), [], Zero, id="a rational ratio"),
        pytest.param(sp.sqrt(a**2 + 2 * a * b + b**2) - a - b, [], Zero, id="a positive sum"),
        pytest.param(sp.sqrt((a - b) ** 2) - a + b, [], Mixed, id="the sign of a difference"),
    ],
)
def test_signs(formula: sp.Expr, non_negative: list[sp.Expr], kind: type) -> None:
    assert isinstance(vanishes_modulo(formula, non_negative), kind)


@pytest.mark.parametrize("twelfths", range(-30, 31))
def test_signs_of_constants(twelfths: int) -> None:
    for function, exact in (("sin", mpmath.sin), ("cos", mpmath.cos)):
        node = Call(function, (Product((Number(Fraction(twelfths, 12)), PI)),))
        value = exact(mpmath.mpf(twelfths) / 12 * mpmath.pi)
        assert sign_of_constant(node) == (0 if abs(value) < 1e-12 else mpmath.sign(value))


@pytest.mark.parametrize(
    ("formula", "plain"),
    [(a + b, True), (a - b, False), (x**2 + 1, True), (x + 1, False), (sp.sqrt(x) * a, True),
     (sp.cos(sp.pi / 7) + a, True), (sp.cos(5 * sp.pi / 7) * a, False), (a**-3, True)],
)  # fmt: skip
def test_plainly_positive(formula: sp.Expr, plain: bool) -> None:
    assert is_plainly_positive(term_of(formula), positive_names(formula)) is plain


FUNCTIONS = [f(k * s) for f in (sp.sin, sp.cos, sp.tan) for s in (x, y) for k in (1, 2)]
FUNCTIONS += [x, z, sp.cos(x / 2 - y), sp.sin(x + sp.pi / 7), sp.Abs(sp.sin(x)), sp.sqrt(1 + x**2)]
POINTS = [("0.7", "1.9", "-2.3"), ("-1.1", "0.3", "0.9"), ("2.9", "-0.8", "1.7")]


@st.composite
def formulas(draw: st.DrawFn) -> sp.Expr:
    """A sum of products of functions with small coefficients."""
    pair = st.tuples(st.integers(-4, 4), *[st.integers(0, len(FUNCTIONS) - 1)] * 2)
    terms = draw(st.lists(pair, min_size=1, max_size=3))
    return sp.Add(*(n * FUNCTIONS[i] * FUNCTIONS[j] for n, i, j in terms))


def vanishes_numerically(formula: sp.Expr) -> bool:
    """Whether a formula is zero at three points, to 40 of 50 digits."""
    function = sp.lambdify(sp.symbols("x y z", real=True), formula, "mpmath")
    with mpmath.workdps(50):
        return all(abs(function(*map(mpmath.mpf, point))) < 1e-40 for point in POINTS)


@settings(max_examples=80, deadline=None)
@given(formulas(), formulas())
def test_rewritten_formulas_are_zero(p: sp.Expr, q: sp.Expr) -> None:
    rewritten = sp.expand_trig(sp.expand(p * q)).rewrite(sp.sin)
    assert vanishes_numerically(p * q - rewritten)
    assert isinstance(vanishes_modulo(p * q - rewritten), Zero)


@settings(max_examples=80, deadline=None)
@given(formulas(), formulas())
def test_answers_agree_with_50_digits(p: sp.Expr, q: sp.Expr) -> None:
    found = vanishes_modulo(p - q)
    if isinstance(found, Mixed):  # sin^2 x against sin x |sin x|: it depends on a sign
        assert (p - q).has(sp.Abs)
        return
    assert isinstance(found, (Zero, NonZero))
    assert isinstance(found, Zero) == vanishes_numerically(p - q)


@settings(max_examples=40, deadline=None)
@given(formulas())
def test_the_root_of_a_square_is_the_absolute_value(p: sp.Expr) -> None:
    square = sp.Pow(sp.expand(p**2), sp.Rational(1, 2), evaluate=False)
    found = vanishes_modulo(square - sp.Abs(p))
    assert isinstance(found, (Zero, Unsupported))


@settings(max_examples=40, deadline=None)
@given(formulas())
def test_answers_repeat(p: sp.Expr) -> None:
    assert vanishes_modulo(p) == vanishes_modulo(p)
