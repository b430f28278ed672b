"""The table of functions: each row has its mathematics in every engine, and it is right."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from contextlib import nullcontext
from fractions import Fraction
from operator import ge, gt, le, ne
from typing import Any

import pytest
import sympy as sp
from mpmath import mp

from omniproof.audit.check import Finding, check
from omniproof.decide import balls, digits
from omniproof.decide.balls import compile_balls, enclose, rational_ball
from omniproof.decide.in_sympy import counterexample
from omniproof.decide.in_sympy.digits import known_value
from omniproof.decide.normal_form import survey
from omniproof.decide.order import enclosure
from omniproof.decide.prime_fields import parts
from omniproof.decide.z3 import translation
from omniproof.formula.angle import circular
from omniproof.formula.functions import (
    ANGLES,
    CIRCULAR,
    FUNCTIONS,
    Lacks,
    angle,
    derivatives,
    domain,
)
from omniproof.formula.sympy_terms import SYMPY_FUNCTIONS, Converter
from omniproof.formula.term import Number, Symbol, Term
from omniproof.formula.unfold import applied
from omniproof.formula.writers import latex
from omniproof.repair import values
from omniproof.transcription import tree
from omniproof.transcription.functions import COMMANDS, WORDS, Row
from omniproof.transcription.reader import read

ROWS = [pytest.param(row, id=name) for name, row in FUNCTIONS.items()]
DEFINED = {n: "it is defined by others" for n, row in FUNCTIONS.items() if row.definition}
ENGINES: dict[str, tuple[Collection[str], Mapping[str, str]]] = {
    "decide.balls": (balls.FUNCTIONS, DEFINED),
    "decide.normal_form": (
        CIRCULAR | ANGLES | survey.SIGNED | {"exp"},
        survey.LACKING | DEFINED,
    ),
    "decide.prime_fields": (CIRCULAR | ANGLES | parts.SIGNED, parts.LACKING | DEFINED),
    "decide.z3": (CIRCULAR | ANGLES | {"sqrt", "abs", "power"}, translation.LACKING | DEFINED),
    "decide.digits": (digits.FUNCTIONS, {}),
    "repair.values": (values.FUNCTIONS, {}),
    "audit.enclosure": (enclosure.FUNCTIONS, {}),
    "audit.counterexample": (counterexample.FUNCTIONS, counterexample.LACKING),
}
"""The functions that an engine can do, and why it cannot do the others."""


@pytest.fixture(autouse=True)
def sixty_digits() -> Iterator[None]:
    with mp.workdps(60):
        yield


POINTS = (Fraction(1, 3), Fraction(7, 9))
"""Every function of one argument, or of both, is defined and smooth here."""


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("engine", ENGINES)
def test_each_engine_has_each_function_or_says_why_not(engine: str, name: str) -> None:
    known, lacking = ENGINES[engine]
    stated = (name in known) != bool(lacking.get(name))
    assert stated, f"omniproof.{engine}: give `{name}` its mathematics, or the reason for none"


@pytest.mark.parametrize("engine", ENGINES)
def test_no_engine_knows_a_function_that_the_table_lacks(engine: str) -> None:
    known, lacking = ENGINES[engine]
    assert set(known) | set(lacking) <= FUNCTIONS.keys()


@pytest.mark.parametrize("row", ROWS)
def test_a_row_says_all_or_why_not(row: Row) -> None:
    assert isinstance(row.derivative, Lacks) or len(row.derivative) == row.arguments
    assert hasattr(sp, row.sympy)
    assert set(row.neighbours) <= FUNCTIONS.keys() - {row.name}
    assert not row.inverse or row.inverse in FUNCTIONS


def exact(term: Term, **places: Fraction) -> Any:
    """Evaluate a term to 60 digits, by mpmath alone."""
    known = Converter().expression(term)
    return known_value(known, {name: sp.Rational(x) for name, x in places.items()})


@pytest.mark.parametrize("row", ROWS)
def test_engines_that_evaluate_agree(row: Row) -> None:
    arguments = [sp.Rational(x) for x in POINTS][: row.arguments]
    rule = digits.FUNCTIONS[row.name]
    expected = rule(*(mp.mpf(x.numerator) / x.denominator for x in POINTS[: row.arguments]))
    lower, upper = enclosure.enclose(SYMPY_FUNCTIONS[row.name](*arguments)) or (0, 0)
    assert float(lower) == pytest.approx(float(expected)) == float(upper)
    found = values.FUNCTIONS[row.name](*map(float, POINTS[: row.arguments]))
    assert found == pytest.approx(float(expected))
    term = applied(row.name, [Number(x) for x in POINTS[: row.arguments]])
    assert float(enclose(term).mid()) == pytest.approx(float(expected))


@pytest.mark.parametrize("row", ROWS)
def test_a_derivative_is_the_slope(row: Row) -> None:
    places = [Symbol("x"), Symbol("y")][: row.arguments]
    program = compile_balls([applied(row.name, places)], [place.name for place in places])
    found = derivatives(row.name, *places)
    for k, derivative in enumerate(() if isinstance(found, Lacks) else found):
        point = [rational_ball(x) for x in POINTS[: row.arguments]]
        direction = [int(j == k) for j in range(row.arguments)]
        slope = program.taylor(point, direction, 1)[0][1]
        assert slope.overlaps(enclose(derivative, dict(zip("xy", POINTS, strict=True))))


@pytest.mark.parametrize("row", ROWS)
def test_parity_is_what_the_digits_show(row: Row) -> None:
    x = mp.mpf(1) / 3
    rule = digits.FUNCTIONS[row.name]
    if row.arguments == 1 and not row.domain:
        shown = {True: "odd", False: None}[digits.are_equal(rule(-x), -rule(x))]
        shown = "even" if digits.are_equal(rule(-x), rule(x)) else shown
        assert row.parity == shown
    elif row.parity:
        sign = 1 if row.parity == "even" else -1
        assert digits.are_equal(rule(-x), sign * rule(x))


@pytest.mark.parametrize(
    ("name", "number", "defined"),
    [
        pytest.param("sqrt", "0", True, id="root of 0"),
        pytest.param("sqrt", "-0.001", False, id="root of less"),
        pytest.param("arcsin", "-1", True, id="least sine"),
        pytest.param("arcsin", "-1.001", False, id="less than any sine"),
        pytest.param("arccos", "1", True, id="largest cosine"),
        pytest.param("arccos", "1.001", False, id="more than any cosine"),
        pytest.param("log", "0.001", True, id="logarithm"),
        pytest.param("log", "0", False, id="logarithm of 0"),
        pytest.param("cot", "0.001", True, id="beside a pole"),
        pytest.param("cot", "0", False, id="pole of the cotangent"),
        pytest.param("csc", "0", False, id="pole of the cosecant"),
        pytest.param("tan", "0", True, id="no pole of the tangent"),
    ],
)
def test_a_domain_ends_where_the_digits_end(name: str, number: str, defined: bool) -> None:
    compare = {"\\neq": ne, "\\leq": le, "\\geq": ge, ">": gt}
    conditions = domain(name, Number(Fraction(number)))
    held = [compare[c.operator](exact(c.left), exact(c.right)) for c in conditions]
    assert all(held) is defined
    with nullcontext() if defined else pytest.raises(digits.UndefinedError):
        digits.value(tree.Call(name, read(number)), meaning=no_symbol)


def no_symbol(node: tree.Symbolic, bound: digits.Bound) -> digits.Value:
    raise AssertionError(node)


@pytest.mark.parametrize("row", [row for row in ROWS if row.values[0].definition])
def test_a_definition_has_the_value_of_the_function(row: Row) -> None:
    term = applied(row.name, [Number(x) for x in POINTS[: row.arguments]])
    expected = digits.FUNCTIONS[row.name](*map(exact, map(Number, POINTS[: row.arguments])))
    assert digits.are_equal(exact(term), expected)


@pytest.mark.parametrize("name", sorted(ANGLES))
def test_an_angle_lies_at_its_point_of_the_circle(name: str) -> None:
    places = [Number(x) for x in POINTS[: FUNCTIONS[name].arguments]]
    cosine, sine = angle(name, *places)
    value = digits.FUNCTIONS[name](*map(exact, places))
    assert digits.are_equal(exact(cosine), mp.cos(value))
    assert digits.are_equal(exact(sine), mp.sin(value))


@pytest.mark.parametrize("name", sorted(CIRCULAR))
def test_a_circular_function_is_a_quotient_on_the_circle(name: str) -> None:
    x = mp.mpf(1) / 3
    above, below = circular(name, 1, mp.cos(x), mp.sin(x))
    assert digits.are_equal(above / below, digits.FUNCTIONS[name](x))


SPELLED = [(f"\\{word}", name) for word, name in COMMANDS.items()] + [
    (f"\\{style}{{{word}}}", name)
    for word, name in WORDS.items()
    for style in ("operatorname", "mathrm")
]


@pytest.mark.parametrize(("spelled", "name"), SPELLED)
def test_a_function_is_read_and_written_as_the_table_says(spelled: str, name: str) -> None:
    node = read(f"{spelled}({'x, y' if FUNCTIONS[name].arguments == 2 else 'x'})", symbols="xy")
    assert isinstance(node, tree.Call)
    assert node.function == name
    assert latex(node).startswith(FUNCTIONS[name].latex)
    assert read(latex(node), symbols="xy") == node


@pytest.mark.parametrize(
    "text",
    [
        pytest.param(r"\exp(x + y) = \exp x \exp y", id="exponential of a sum"),
        pytest.param(r"\cosh^2 x - \sinh^2 x = 1", id="hyperbola"),
        pytest.param(r"\tanh 2x = \frac{2\tanh x}{1 + \tanh^2 x}", id="double argument"),
        pytest.param(r"\exp(2\ln x) = x^2", id="power"),
        pytest.param(r"\ln(\exp x) = x", id="logarithm of an exponential"),
        pytest.param(r"\max(x, y) + \min(x, y) = x + y", id="larger and smaller"),
        pytest.param(r"\max(x, y) - \min(x, y) = |x - y|", id="distance"),
        pytest.param(r"\operatorname{sgn}(x) |x| = x", id="sign and size"),
    ],
)
def test_rows_with_mathematics_are_decided(text: str) -> None:
    assert check(text).verdict is Finding.VERIFIED
