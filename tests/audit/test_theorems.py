"""Theorems are proved step by step; a false step stops the build and is named."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import pytest
from sympy import Expr, Integer, cos, sin, symbols

from omniproof import papers
from omniproof.audit.theorems import UnprovedError, prove, prove_all, write_theorems
from omniproof.registry import Obligation, Step, Theorem
from omniproof.transcription.model import Form

x, y = symbols("x y", real=True)


def step(says: str, *sides: Expr) -> Step:
    def obligations() -> Sequence[Obligation]:
        return [Obligation(Form.EQUAL, sides)]

    return Step(says, obligations)


TRUE = step("The circle.", sin(x) ** 2 + cos(x) ** 2, Integer(1))
DOUBLE = step("The double angle.", sin(2 * x), 2 * sin(x) * cos(x))
FALSE = step("The freshman's dream.", (x + y) ** 2, x**2 + y**2)


def theorem(*steps: Step) -> Theorem:
    return Theorem("thm:one", "One", "It is **so**: $x$ – “ü”.", ("a-paper",), steps)


def test_a_proved_theorem_is_recorded_with_its_steps() -> None:
    assert prove(theorem(TRUE, DOUBLE)) == {
        "id": "thm:one",
        "title": "One",
        "statement": "It is **so**: $x$ – “ü”.",
        "papers": ["a-paper"],
        "engines": "flint+modular+z3",
        "proof": [
            {"step": "The circle.", "engines": "flint+modular+z3"},
            {"step": "The double angle.", "engines": "flint+modular+z3"},
        ],
    }


@pytest.mark.parametrize("steps", [(FALSE,), (TRUE, FALSE), (FALSE, TRUE)])
def test_a_false_step_is_named(steps: tuple[Step, ...]) -> None:
    with pytest.raises(UnprovedError) as error:
        prove(theorem(*steps))
    assert (error.value.theorem, error.value.step) == ("thm:one", "The freshman's dream.")
    assert str(error.value) == (
        f'thm:one: the step "The freshman\'s dream." is not proved: {error.value.answer}'
    )


def test_a_paper_without_theorems_adds_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "bare_paper").mkdir()
    (tmp_path / "bare_paper" / "__init__.py").touch()
    monkeypatch.setattr(papers, "__path__", [*papers.__path__, str(tmp_path)])
    assert prove_all(["bare-paper"]) == []


def test_the_file_is_json_in_plain_letters(tmp_path: Path) -> None:
    records = [prove(theorem(TRUE))]
    write_theorems(records, tmp_path / "theorems.json")
    text = (tmp_path / "theorems.json").read_text(encoding="utf-8")
    assert json.loads(text) == records
    assert "“ü”" in text
    assert text.endswith("]\n")


def test_theorems_of_omni_arrangement_are_all_proved() -> None:
    records = prove_all(["omni-arrangement"])
    ids = [record["id"] for record in records]
    assert "thm:area-by-volume" in ids
    assert len(ids) == len(set(ids))
    assert all(name.startswith("thm:") for name in ids)
    assert all(record["proof"] and record["engines"] for record in records)
