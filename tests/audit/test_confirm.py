"""Every engine through the table of textbook identities, and each engine broken on purpose."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from identity_table import BRANCH, ROWS, Row, x
from sympy import Abs, Integer, StrictGreaterThan, cos, pi, sin

from omniproof.decide import balls, confirm, zero_test
from omniproof.decide.answer import DisagreementError, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.in_sympy.domain import Domain
from omniproof.decide.in_sympy.equality import confirmed_equal, decide_equal
from omniproof.decide.prime_fields import point, zero
from omniproof.decide.prime_fields.field import PrimeField
from omniproof.decide.prime_fields.zero import Mixed, NonZero, Zero, vanishes
from omniproof.decide.z3 import equation
from omniproof.decide.z3.equation import Different, Equal, SmtAnswer, differ_somewhere
from omniproof.formula.sympy_terms import assumed_signs, positive_names, term_of
from omniproof.formula.term import subtract

BY_NAME = {row.name: row for row in ROWS}
WITH_ID = [pytest.param(row, id=row.name) for row in ROWS]
WORDS: dict[type, str] = {
    Proved: "true", Refuted: "false", OnBranch: "branch",
    Zero: "true", NonZero: "false", Mixed: "branch",
    Equal: "true", Different: "false",
}  # fmt: skip


def by_z3(row: Row) -> SmtAnswer:
    assumed = assumed_signs(row.left, row.right)
    return differ_somewhere(term_of(row.left), term_of(row.right), assumed)


ENGINES: dict[str, Callable[[Row], object]] = {
    "flint": lambda row: decide_equal(row.left, row.right, row.domain),
    "modular": lambda row: vanishes(
        subtract(term_of(row.left), term_of(row.right)),
        positive=positive_names(row.left, row.right),
    ),
    "z3": by_z3,
}
SIGNS_STAY_OPEN = {
    "viete",
    "heptadecagon",
    "root-sine",
    "inradius",
    "longer-than-a-leg",
    "shorter-than-a-leg",
}
"""Rows whose roots have signs that no product settles: for the modular engine, a branch."""


@pytest.mark.parametrize("row", WITH_ID)
@pytest.mark.parametrize("engine", ENGINES)
def test_every_engine_says_what_the_textbook_says(engine: str, row: Row) -> None:
    said = WORDS.get(type(ENGINES[engine](row)), "unsupported")
    allowed = {
        "flint": {row.expected},
        "modular": {"branch" if row.name in SIGNS_STAY_OPEN else row.expected},
        "z3": {row.expected, "unsupported"},
    }
    assert said in allowed[engine]


def test_z3_decides_what_is_small_and_rational() -> None:
    decided = {row.name for row in ROWS if isinstance(by_z3(row), Equal | Different)}
    assert {"pythagoras", "tangent-of-sum", "chebyshev", "pentagon", "triple-product"} <= decided
    assert decided.isdisjoint({"half-sine", "morrie", "small-angle", "heron"})


@pytest.mark.parametrize("row", WITH_ID)
def test_confirmation_keeps_the_verdict_and_names_who_decided(row: Row) -> None:
    found = confirmed_equal(row.left, row.right, row.domain)
    first = decide_equal(row.left, row.right, row.domain)
    assert WORDS[type(found)] == row.expected
    assert found.engines[0] == "flint"
    assert list(found.engines) == [e for e in ("flint", "modular", "z3") if e in found.engines]
    assert getattr(found, "witness", None) == getattr(first, "witness", None)


@pytest.mark.parametrize(
    ("name", "engines"),
    [
        pytest.param("pythagoras", "flint+modular+z3", id="rational: all three"),
        pytest.param("double-sine-factor", "flint+modular+z3", id="false: all three"),
        pytest.param("half-sine", "flint+modular", id="a root is nothing for z3"),
        pytest.param("small-angle", "flint+modular", id="z3 cannot tell angle and number"),
        pytest.param("viete", "flint", id="open signs: the first engine alone"),
        pytest.param("root-of-square", "flint+modular", id="a condition that suffices"),
        pytest.param("two-signs", "flint+modular", id="two conditions that suffice"),
        pytest.param("root-sine", "flint", id="a domain is known to the first engine only"),
    ],
)
def test_only_who_decided_is_named(name: str, engines: str) -> None:
    row = BY_NAME[name]
    assert "+".join(confirmed_equal(row.left, row.right, row.domain).engines) == engines


def test_every_condition_of_the_table_is_confirmed() -> None:
    """In each of these rows the condition that FLINT finds makes the difference vanish modulo p."""
    for row in BRANCH:
        assert confirmed_equal(row.left, row.right, row.domain).engines[:2] == ("flint", "modular")


def test_what_is_undecided_stays_so() -> None:
    found = confirmed_equal(x / 0, x / 0)
    assert isinstance(found, Undecided)


def test_numbers_of_python_are_formulas() -> None:
    assert confirmed_equal(1, Integer(1)).engines == ("flint", "modular", "z3")
    assert isinstance(confirmed_equal(0, 1), Refuted)


def test_a_counterexample_outside_of_the_domain_contradicts_nothing() -> None:
    half = Domain({"x": (Integer(0), pi)})
    assert confirmed_equal(Abs(sin(x)), sin(x), half).engines == ("flint",)


def test_a_disagreement_shows_both_sides(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(confirm, "vanishes", lambda *_: NonZero(101, {"x": 7}))
    with pytest.raises(DisagreementError) as caught:
        confirmed_equal(sin(x) ** 2 + cos(x) ** 2, Integer(1))
    assert str(caught.value) == (
        "modular contradicts flint on sin(x)**2 + cos(x)**2 = 1: "
        "Proved(engines=('flint',), note='')"
    )


def test_a_condition_that_does_not_suffice_is_a_disagreement(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The identity |x| = x under the condition x < 0 that a broken engine might give."""
    witness = decide_equal(x, Abs(x)).witness
    wrong = OnBranch(
        ("flint",), "-x > 0", witness, relations=(StrictGreaterThan(-x, 0, evaluate=False),)
    )
    monkeypatch.setattr(confirm, "decide_equal", lambda *_: wrong)
    with pytest.raises(DisagreementError, match="modular contradicts flint on Abs"):
        confirmed_equal(Abs(x), x)


def first_only(places: tuple[int, ...]) -> Any:
    return lambda memory: memory[places[0]]


FLINT = [
    pytest.param(balls.FUNCTIONS, "sin", lambda v: v.cos(), "pythagoras", id="cos for sin"),
    pytest.param(balls.FUNCTIONS, "cos", lambda v: -v.cos(), "half-tangent", id="sign of cos"),
    pytest.param(balls, "_multiply", first_only, "double-cosine", id="factors lost"),
    pytest.param(balls, "_add", first_only, "sine-of-sum", id="terms lost"),
    pytest.param(balls.FUNCTIONS, "sqrt", lambda v: -v.sqrt(), "ramanujan", id="the other root"),
    pytest.param(
        zero_test._Probe, "differs", property(lambda probe: probe.printed.overlaps(probe.derived)),
        "chebyshev", id="what may be equal differs",
    ),
    pytest.param(
        zero_test.NormalForm, "is_zero", property(lambda _: True), "double-sine-factor",
        id="all is zero, and the balls are blunt",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "broken", "caught"), FLINT)
def test_a_broken_first_engine_is_caught_by_the_second(
    monkeypatch: pytest.MonkeyPatch, owner: Any, name: Any, broken: Any, caught: str
) -> None:
    row = BY_NAME[caught]
    replace(monkeypatch, owner, name, broken)
    if name == "is_zero":
        monkeypatch.setattr(zero_test._Probe, "differs", property(lambda _: False))
    with pytest.raises(DisagreementError, match=r"^modular contradicts flint on "):
        confirmed_equal(row.left, row.right, row.domain)


def replace(monkeypatch: pytest.MonkeyPatch, owner: Any, name: Any, broken: Any) -> None:
    if isinstance(owner, dict):
        monkeypatch.setitem(owner, name, broken)
    else:
        monkeypatch.setattr(owner, name, broken)


def other_ratios(prime: int) -> frozenset[int]:
    return frozenset({1, 2})


MODULAR = [
    pytest.param(PrimeField, "unit", lambda *_: 1, "pythagoras", id="no imaginary unit"),
    pytest.param(
        PrimeField, "root_of_prime", lambda *_: 3, "heptagon-product", id="root of a prime"
    ),
    pytest.param(PrimeField, "square_root", lambda _, v: v, "leg", id="root of a value"),
    pytest.param(PrimeField, "inverse", lambda _, v: v, "pythagoras", id="inverse"),
    pytest.param(point.RandomPoint, "value", lambda *_: 0, "double-sine-factor", id="all is zero"),
    pytest.param(point.RandomPoint, "_turned", lambda *_: 2, "sine-of-sum", id="one angle"),
    pytest.param(point.RandomPoint, "_product", lambda *_: 1, "double-sine", id="products"),
    pytest.param(zero, "_negative_ratios", other_ratios, "abs-product", id="signs that can be"),
]


@pytest.mark.parametrize(("owner", "name", "broken", "caught"), MODULAR)
def test_a_broken_second_engine_is_caught_by_the_first(
    monkeypatch: pytest.MonkeyPatch, owner: Any, name: str, broken: Any, caught: str
) -> None:
    row = BY_NAME[caught]
    monkeypatch.setattr(owner, name, broken)
    with pytest.raises(DisagreementError, match=r"^modular contradicts flint on "):
        confirmed_equal(row.left, row.right, row.domain)


def no_product(_: Any, *parts: Any) -> Any:
    return parts[0]


Z3 = [
    pytest.param("_turned", lambda _, angle, turn: turn, "cosine-of-sum", id="last angle only"),
    pytest.param("_product", no_product, "double-sine", id="factors lost"),
    pytest.param("_number", lambda q, v: q.z3.RealVal(3, ctx=q.context), "double-sine", id="three"),
    pytest.param("_root", lambda q, *_: q._whole(q.one), "triple-product", id="all roots are one"),
]


@pytest.mark.parametrize(("name", "broken", "caught"), Z3)
def test_a_broken_third_engine_is_caught(
    monkeypatch: pytest.MonkeyPatch, name: str, broken: Any, caught: str
) -> None:
    row = BY_NAME[caught]
    differ_somewhere.cache_clear()
    monkeypatch.setattr(equation._Question, name, broken)
    with pytest.raises(DisagreementError, match=r"^z3 contradicts flint\+modular on "):
        confirmed_equal(row.left, row.right, row.domain)
    differ_somewhere.cache_clear()


def test_answers_are_the_same_in_any_order() -> None:
    """Neither fields nor z3's context carry anything from question to question."""
    rows = [row for row in ROWS if row.name not in {"heron", "fourth-root", "heron-factor"}]
    there = [confirmed_equal(row.left, row.right, row.domain) for row in rows]
    differ_somewhere.cache_clear()
    back = [confirmed_equal(row.left, row.right, row.domain) for row in reversed(rows)]
    assert there == back[::-1]


@pytest.mark.parametrize("engine", ["modular", "z3"])
def test_the_command_line_stops_on_a_disagreement(
    engine: str, monkeypatch: pytest.MonkeyPatch, tiny_folder: Any, capsys: Any
) -> None:
    from omniproof.cli import INTERNAL, main

    monkeypatch.setitem(confirm.ENGINES, engine, lambda *_: False)
    assert main(["audit", str(tiny_folder)]) == INTERNAL == 4
    assert f"{engine} contradicts flint" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("enough", "engines"),
    [
        (None, ("flint", "modular", "z3")),
        (2, ("flint", "modular", "z3")),
        (1, ("flint", "modular")),
    ],
)
def test_no_more_engines_are_asked_than_are_enough(
    enough: int | None, engines: tuple[str, ...]
) -> None:
    assert confirmed_equal(sin(x) ** 2 + cos(x) ** 2, Integer(1), enough=enough) == Proved(engines)
