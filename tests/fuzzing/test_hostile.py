"""Formulas and options that are meant to hurt: `check` answers, and in time, whatever it is given.

Numbers beyond floats and beyond Python's own limit of digits, poles, roots of negative numbers,
conditions without a value, in any place of a formula and of an option, drawn with a seed.
"""

from __future__ import annotations

from random import Random

import pytest

from omniproof import cli

LEAVES = (
    "0", "1", "-1", "x", "y", r"\theta", r"\pi", "10^{9999}", "10^{-9999}", "10^{309}", "10^{-400}",
    r"20^\circ", r"10^{308}^\circ", "9" * 400, f"0.{'0' * 400}1", "(1-10^{-300})", "7^{4000}",
)  # fmt: skip
SHAPES = (
    "({}+{})", "({}-{})", r"{} \cdot {}", r"\frac{{{}}}{{{}}}", r"\sqrt{{{}}}", "|{}|", "{} / {}",
    "({})^{{9999}}", "({})^{{-9999}}", "({})^{{2}}", "({})^{{999999999}}", r"\sin({})", r"\tan({})",
    r"\arcsin({})", r"\cos^{{-1}} {}", r"\operatorname{{atan2}}({},{})", r"\|{}\|",
    r"\int_{{{}}}^{{{}}} {} dx", r"\begin{{pmatrix}}{}\\{}\end{{pmatrix}}",
    r"\det\begin{{pmatrix}}{}&{}\\{}&{}\end{{pmatrix}}",
    r"\begin{{cases}} {} & {} < {} \\ {} & {} \geq {} \end{{cases}}",
)  # fmt: skip
RELATIONS = ("=", "=", "=", "<", ">", r"\leq", r"\geq", r"\neq")
OPTIONS = (
    ("--between", "{} < x < {}"), ("--between", "{} < x"), ("--between", "y < {}"),
    ("--between", r"0 < x < 1 \lor {} < y"), ("--positive", "{}"), ("--function", "c=cos"),
    ("--function", "x=sin"), ("--slash", "first"), ("--slash", "all"),
)  # fmt: skip


def filled(shape: str, draw: Random, depth: int) -> str:
    return shape.format(*(formula(draw, depth) for _ in range(shape.count("{}"))))


def formula(draw: Random, depth: int) -> str:
    return filled(draw.choice(SHAPES), draw, depth - 1) if depth else draw.choice(LEAVES)


def command(draw: Random) -> list[str]:
    statement = formula(draw, draw.randint(1, 3))
    for _ in range(draw.randint(1, 2)):
        statement += f" {draw.choice(RELATIONS)} {formula(draw, draw.randint(0, 2))}"
    chosen = draw.sample(OPTIONS, draw.choice((0, 0, 1, 2)))
    options = [f"{name}={filled(form, draw, draw.randint(0, 1))}" for name, form in chosen]
    return ["check", "--limit", "0.5", *options, "--", statement]


def answers(seeds: range, capsys: pytest.CaptureFixture[str]) -> set[int]:
    found = set()
    for seed in seeds:
        arguments = command(Random(seed))
        status = cli.main(arguments)
        assert (status in {0, 1, 2, 3}, seed, arguments, capsys.readouterr().err)[0]
        found.add(status)
    return found


def test_any_formula_is_answered(capsys: pytest.CaptureFixture[str]) -> None:
    assert answers(range(40), capsys) >= {1, 2}


@pytest.mark.slow
def test_many_formulas_are_answered(capsys: pytest.CaptureFixture[str]) -> None:
    assert answers(range(1_000, 3_000), capsys) == {0, 1, 2, 3}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        pytest.param(
            [r"\cos 20^\circ^{-9999} = 1"], "expected one exponent, found `^`",
            id="two exponents"),
        pytest.param(
            ["x = 1", "--between", "10^{9999} < x"],
            "expected a number below 10^300 as the end of a range", id="a lower end"),
        pytest.param(
            ["x = 1", "--between", "0 < x < 10^{9999}"],
            "expected a number below 10^300 as the end of a range", id="an upper end"),
        pytest.param(
            ["x = 1", "--between", "-10^{9999} < x"],
            "expected a number below 10^300 as the end of a range", id="below all numbers"),
        pytest.param(
            ["x = 1", "--between", r"0 < x < 10^{299} \cdot 10^{299}"],
            "expected a number below 10^300 as the end of a range", id="a product"),
        pytest.param(
            ["x = 1", "--between", "((10^{9999})^{9999})^{9999} < x"],
            "expected a smaller power of a number", id="nested powers"),
        pytest.param(["x = 1", "--between", "1/0 < x"], "cannot divide by 0", id="a pole"),
        pytest.param(
            ["x = 1", "--between", r"\tan 90^\circ < x"],
            "expected a number as the end of a range: it is not a finite real number",
            id="a pole of tan"),
        pytest.param(
            ["x = 1", "--between", r"\sqrt{-1} < x"],
            "expected a number as the end of a range: it is not a finite real number",
            id="no real number"),
        pytest.param(
            ["x = 1", "--between", r"1 < x \lor 2 < x"], "expected a range with `<`", id="or"),
    ],
)  # fmt: skip
def test_what_is_no_number(
    arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["check", *arguments]) == 2
    assert capsys.readouterr().err.startswith(message)


@pytest.mark.parametrize(
    ("statement", "status"),
    [
        pytest.param(r"10^{9999} + x = x + 10^{9999}", 0, id="a number of 10 000 digits"),
        pytest.param(r"\theta < 7^{4000}", 1, id="a bound beyond floats"),
        pytest.param(r"\theta^2 + 1 > 10^{-9999}", 0, id="a bound below floats"),
        pytest.param(r"\cos(20^\circ)^{-9999} = 1", 1, id="a great power of a cosine"),
    ],
)
def test_numbers_beyond_floats(
    statement: str, status: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["check", statement]) == status
    assert len(capsys.readouterr().out) < 20_000
