"""Random statements against their truth by mpmath: no verdict is wrong, no witness undefined."""

from __future__ import annotations

import re
from collections import Counter

import pytest
from mpmath import mp, mpf
from statements import SYMBOLS, Statement, Writer

from omniproof.audit.check import CheckResult, Finding, check

PLACES = 20
FALSE = (Finding.ERRATUM, Finding.CONDITIONAL)
NUMBER = re.compile(r"(-?)(?:(\d+)\*?)?(?:(pi)|sqrt\((\d+)\))?(?:/(\d+))?")


def coordinate(text: str) -> mpf:
    """Read a coordinate of a witness: a rational number, times pi or a root."""
    parts = NUMBER.fullmatch(text)
    assert parts is not None, text
    minus, above, pi, radicand, below = parts.groups()
    irrational = +mp.pi if pi else mp.sqrt(int(radicand or 1))
    return (-1 if minus else 1) * mpf(int(above or 1)) * irrational / int(below or 1)


def faults(statement: Statement, found: CheckResult, writer: Writer) -> list[str]:
    """Say what is wrong with a verdict."""
    places = [writer.point() for _ in range(PLACES)]
    if found.verdict is Finding.VERIFIED:
        return ["verified"] if any(statement.holds(p) is False for p in places) else []
    if found.verdict not in FALSE or found.witness is None:
        return []
    with mp.workdps(60):
        point = {name: coordinate(text) for name, text in found.witness.point.items()}
    there = {name: point[name.strip("\\")] for name in SYMBOLS if name.strip("\\") in point}
    told = {statement.holds({**place, **there}) for place in places}
    return [] if False in told and True not in told else [f"witness {found.witness}"]


def study(seed: int, count: int) -> tuple[list[tuple[str, list[str]]], Counter[str]]:
    writer, counted, wrong = Writer(seed), Counter[str](), []
    for _ in range(count):
        statement = writer.statement()
        found = check(statement.latex)  # engines that disagree raise
        counted[found.verdict] += 1
        if bad := faults(statement, found, writer):
            wrong.append((statement.latex, bad))
    return wrong, counted


def test_a_few_hundred_statements() -> None:
    wrong, counted = study(seed=7, count=250)
    assert wrong == []
    assert counted["verified"] >= 10
    assert counted["erratum"] >= 100
    assert counted["undecided"] <= 25


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10, 20))
def test_thousands_of_statements(seed: int) -> None:
    wrong, counted = study(seed, count=600)
    assert wrong == []
    assert counted["verified"] >= 25
    assert counted["undecided"] <= 60
