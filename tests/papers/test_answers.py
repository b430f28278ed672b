"""Every numbered equation has an answer, and what it offers to paste does what mechanics says.

Each paste is run as it stands. What it gives is compared, at random points, with the derivation of
the claims it is made of, evaluated by SymPy to thirty digits.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
import pytest
from audited import audited_once
from sympy import Abs, Integral, Matrix, MatrixBase, Rational

from omniproof.corrected.answer import Line
from omniproof.report.answers import Equations, Shown
from omniproof.transcription.ids import whole
from omniproof.transcription.reader import read_with

ROOT = Path(__file__).parents[2]
PAPERS = sorted(path.parent.name for path in (ROOT / "paper_data").glob("*/paper.yaml"))
BROAD = re.compile(r"\\begin\{(\w+)\}.*?\\end\{\1\}", re.DOTALL)


@cache
def equations(paper: str) -> Equations:
    """Return the equations of a paper as it is audited now."""
    return Equations(audited_once(ROOT / "paper_data" / paper))


def lines(paper: str) -> Iterator[tuple[str, Line, Shown]]:
    """Yield every formula of every answer, ready to show."""
    own = equations(paper)
    for place, answer in own.answers.items():
        for line in answer.lines:
            yield place, line, own.shown(place, line)


def run(text: str) -> dict[str, Any]:
    """Run a paste in an empty namespace."""
    names: dict[str, Any] = {}
    exec(text, names)
    return names


def exact(own: Equations, line: Line) -> Any:
    """Return the product of what mechanics derives for the claims of a line."""
    found: Any = 1
    for claim in line.factors:
        found = found * own.context.derive_by_mechanics(claim)
    return found / own.context.derive_by_mechanics(line.per) if line.per else found


def entries(value: Any) -> list[Any]:
    """Return the entries of a matrix, or a number as the only one."""
    return list(value.flat()) if isinstance(value, MatrixBase) else [value]


def point(*values: Any) -> dict[Any, Rational]:
    """Return a number for each symbol, the same for the same name."""
    found = {symbol for value in values for symbol in value.free_symbols}
    return {s: Rational(Random(str(s)).randint(20, 120), 97) for s in found}


def with_code(kind: str) -> list[Any]:
    """Return every formula that has such a paste, but for integrals, as test cases."""
    return [
        pytest.param(paper, line, shown.pastes[kind], id=f"{paper} {place} {line.display[:40]}")
        for paper in PAPERS
        for place, line, shown in lines(paper)
        if kind in shown.pastes and not exact(equations(paper), line).has(Integral)
    ]


@pytest.mark.parametrize("paper", PAPERS)
def test_every_numbered_equation_has_an_answer(paper: str) -> None:
    ledger = equations(paper).ledger
    numbered = {whole(row.id) for row in ledger.rows if row.id.startswith("eq:")}
    assert numbered <= equations(paper).answers.keys()


@pytest.mark.parametrize("paper", PAPERS)
def test_what_is_pasted_reads_back_as_what_mechanics_gives(paper: str) -> None:
    assert list(equations(paper).unproved()) == []


@pytest.mark.parametrize("paper", PAPERS)
def test_latex_stands_alone_and_is_read(paper: str) -> None:
    context = equations(paper).context
    for _, _, shown in lines(paper):
        latex = shown.pastes.get("LaTeX", "0")
        assert not latex.startswith(("=", "&"))
        assert "&" not in BROAD.sub("", latex)
        read_with(latex, context.loaded.paper.notation, context.names)


@pytest.mark.parametrize("paper", PAPERS)
def test_every_faulty_formula_can_be_pasted(paper: str) -> None:
    for _, line, shown in lines(paper):
        mended = any(row.correction for row in shown.rows)
        assert not mended or "LaTeX" in shown.pastes, line.display


def test_sympy_pastes_give_the_derivation() -> None:
    for case in with_code("SymPy"):
        paper, line, text = case.values
        found = list(run(text).values())[-1]
        derived = exact(equations(paper), line)
        at = point(Matrix([found]), Matrix([derived]))
        for own, right in zip(entries(found), entries(derived), strict=True):
            assert Abs((own - right).subs(at).evalf(30)) < 1e-25, case.id


def test_numpy_pastes_give_the_derivation() -> None:
    for case in with_code("NumPy"):
        paper, line, text = case.values
        function = list(run(text).values())[-1]
        derived = exact(equations(paper), line)
        at = {str(s): float(v) for s, v in point(Matrix([derived])).items()}
        named = function.__code__.co_varnames[: function.__code__.co_argcount]
        values = [at.get(name, float(Random(name).randint(20, 120) / 97)) for name in named]
        right = [float(e.subs(point(Matrix([derived]))).evalf(20)) for e in entries(derived)]
        np.testing.assert_allclose(np.ravel(function(*values)), right, err_msg=str(case.id))


def test_calls_of_omniproof_run() -> None:
    found = [shown.pastes["omniproof"] for p in PAPERS for *_, shown in lines(p)
             if "omniproof" in shown.pastes]  # fmt: skip
    assert len(found) > 10
    for text in found:
        *head, call = text.splitlines()
        names = run("\n".join(head))
        assert np.all(np.isfinite(eval(call, names)))
