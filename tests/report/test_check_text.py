"""A checked statement as a terminal and as a program see it, to the letter."""

from __future__ import annotations

import json

import pytest

from omniproof.audit.check import CheckResult, Finding
from omniproof.decide.answer import Witness
from omniproof.door import Said, say
from omniproof.repair.kinds import Edit, Repair
from omniproof.report.check_text import COLOURS, check_json, check_text

SINE = r"\sin 2\theta = \sin\theta\cos\theta"
FALSE = CheckResult(
    Finding.ERRATUM,
    SINE,
    Witness({"theta": "2/7"}, "0.5406", "0.2703"),
    repairs=(
        Repair(Edit.FACTOR, (15, 15), "insert 2", r"\sin 2\theta = 2\sin\theta\cos\theta"),
        Repair(Edit.CONSTANT, (5, 6), "drop 2", r"\sin \theta = \sin\theta"),
    ),
    engines=("flint", "modular"),
    message="false",
)
TRUE = CheckResult(Finding.VERIFIED, "a = a", engines=("flint",), message="true")
CONDITIONAL = CheckResult(
    Finding.CONDITIONAL,
    "|x| = x",
    Witness({"x": "-26/9"}, "2.889", "-2.889"),
    condition=r"x \geq 0",
    engines=("flint", "modular"),
)
UNDECIDED = CheckResult(
    Finding.UNDECIDED,
    r"\begin{pmatrix} x & y \end{pmatrix} = \begin{pmatrix} y & x \end{pmatrix}",
    message="not decided in row 1, column 1: no proof was found without a bounded range",
)
INVALID = CheckResult(Finding.INVALID, "a =", message="expected a symbol\n    a =\n      ^")


@pytest.mark.parametrize(
    ("result", "width", "text"),
    [
        pytest.param(
            FALSE, 80,
            r"""
ERRATUM  \sin 2\theta = \sin\theta\cos\theta
    witness   theta = 2/7; left = 0.5406; right = 0.2703
    repair    \sin 2\theta = 2\sin\theta\cos\theta
    engines   flint, modular
    note      false
""", id="false"),
        pytest.param(
            TRUE, 80,
            """
VERIFIED  a = a
    engines   flint
    note      true
""", id="true"),
        pytest.param(
            CONDITIONAL, 80,
            r"""
CONDITIONAL  |x| = x
    holds for x \geq 0
    witness   x = -26/9; left = 2.889; right = -2.889
    engines   flint, modular
""", id="on a branch"),
        pytest.param(
            UNDECIDED, 50,
            r"""
UNDECIDED  \begin{pmatrix} x & y \end{pmatrix} =
    \begin{pmatrix} y & x \end{pmatrix}
    note      not decided in row 1, column 1: no
              proof was found without a bounded
              range
""", id="narrow"),
        pytest.param(
            UNDECIDED, 10,
            r"""
UNDECIDED  \begin{pmatrix} x & y
    \end{pmatrix} = \begin{pmatrix} y &
    x \end{pmatrix}
    note      not decided in row 1,
              column 1: no proof was
              found without a bounded
              range
""", id="never narrower than 40"),
    ],
)  # fmt: skip
def test_text(result: CheckResult, width: int, text: str) -> None:
    assert check_text(result, width) == text.strip("\n")


def test_no_line_is_wider_than_the_terminal() -> None:
    for width in (40, 57, 80, 120):
        for result in (FALSE, TRUE, CONDITIONAL, UNDECIDED):
            lines = check_text(result, width).splitlines()
            assert max(map(len, lines)) <= width, (width, result.verdict)


def test_a_word_is_never_cut() -> None:
    formula = "x=" + "+".join(["x"] * 100)
    assert formula in check_text(CheckResult(Finding.VERIFIED, formula), 40)


@pytest.mark.parametrize("result", [FALSE, TRUE, CONDITIONAL, UNDECIDED, INVALID])
def test_only_the_verdict_is_coloured(
    result: CheckResult, capsys: pytest.CaptureFixture[str]
) -> None:
    plain = check_text(result, 80)
    say(Said(0, plain, colour=COLOURS[result.verdict]), failed=2)
    coloured = capsys.readouterr().out.removesuffix("\n")
    start, end = coloured.index("\x1b["), coloured.index("\x1b[0m")
    assert coloured[start:end].endswith(f"m{result.verdict.upper()}")
    assert coloured[start + 5 : end] + coloured[end + 4 :] == plain


@pytest.mark.parametrize(
    ("result", "record"),
    [
        pytest.param(
            FALSE,
            {
                "verdict": "erratum",
                "printed": SINE,
                "witness": "theta=2/7; printed=0.5406; derived=0.2703",
                "condition": "",
                "repair": r"\sin 2\theta = 2\sin\theta\cos\theta",
                "engines": "flint+modular",
                "message": "false",
            },
            id="false",
        ),
        pytest.param(
            CONDITIONAL,
            {
                "verdict": "conditional",
                "printed": "|x| = x",
                "witness": "x=-26/9; printed=2.889; derived=-2.889",
                "condition": r"x \geq 0",
                "repair": "",
                "engines": "flint+modular",
                "message": "",
            },
            id="on a branch",
        ),
        pytest.param(
            INVALID,
            {
                "verdict": "invalid",
                "printed": "a =",
                "witness": "",
                "condition": "",
                "repair": "",
                "engines": "",
                "message": "expected a symbol\n    a =\n      ^",
            },
            id="invalid",
        ),
    ],
)
def test_json_is_one_object_with_all_keys(result: CheckResult, record: dict[str, str]) -> None:
    text = check_json(result)
    assert text.isascii()
    assert list(json.loads(text).items()) == list(record.items())
