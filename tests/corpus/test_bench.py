"""The comparison on a corpus of three rows, and the elimination: what is said, not how fast."""

import csv
import json
from dataclasses import replace
from mmap import PAGESIZE
from pathlib import Path
from resource import RUSAGE_SELF, getrusage

import bench
import pytest
import rivals
from bench import Row, compare, only_ours
from elimination import direct, staged
from questions import Question
from rivals import CAN_OWN, EASY, SYSTEMS, Timed, timed

from omniproof.audit.sympy_domain import Domain
from omniproof.audit.sympy_equality import decide_equal
from omniproof.decide import zero_test
from omniproof.decide.answer import Proved, Refuted
from omniproof.formula.term import Symbol, add

TINY = r"""
- {id: easy, latex: '\sin^2 x + \cos^2 x = 1', expected: proved, source: standard}
- {id: wrong, latex: '\sin^2 x - \cos^2 x = 1', expected: refuted, source: standard}
- {id: ordered, latex: '\sin x < 2', ranges: {x: ['0', '1']}, expected: proved, source: standard}
"""


def row(name: str, expected: str, ours: tuple[str, float], theirs: tuple[str, float]) -> Row:
    return Row(name, expected, {"flint": Timed(*ours), "simplify": Timed(*theirs)})


def test_a_run_writes_what_each_system_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bench, "elimination_times", dict)
    corpus = tmp_path / "tiny.yaml"
    corpus.write_text(TINY)
    bench.main([str(tmp_path / "out"), "--corpus", str(corpus), "--time-out", "20"])
    summary = json.loads((tmp_path / "out" / "engine.json").read_text())
    assert summary["right"]["flint"] == 3
    assert summary["right"]["simplify"] == 2
    with (tmp_path / "out" / "engine.csv").open() as file:
        said = {(line["id"], line["system"]): line["said"] for line in csv.DictReader(file)}
    assert said["wrong", "equals"] == "refuted"
    assert ("ordered", "simplify") not in said


def test_ratios_count_rows_that_both_decide_rightly() -> None:
    rows = [
        row("both", "proved", ("proved", 1.0), ("proved", 4.0)),
        row("both-again", "refuted", ("refuted", 3.0), ("refuted", 6.0)),
        row("wrong", "branch", ("branch", 1.0), ("refuted", 50.0)),
        row("late", "proved", ("proved", 1.0), ("time-out", 50.0)),
        replace(row("alike", "proved", ("proved", 1.0), ("proved", 50.0)), settled=True),
    ]
    found = compare(rows, "flint", "simplify")
    assert (found.rows, found.median, found.total) == (2, 3.0, 2.5)


def test_what_only_we_decide() -> None:
    row_of_ours = {"flint": Timed("proved", 1.0), "confirmed": Timed("proved", 1.0)}
    rows = [
        Row("ours", "proved", row_of_ours | {"equals": Timed("undecided", 1.0)}),
        Row("shared", "proved", row_of_ours | {"equals": Timed("proved", 1.0)}),
        Row("nobody-else-was-asked", "proved", row_of_ours),
    ]
    assert only_ours(rows) == ["ours"]


def hang(question: Question) -> str:
    while True:
        pass


def fail(question: Question) -> str:
    raise ValueError(question.relation)


@pytest.mark.parametrize(
    ("system", "time_out", "said"),
    [
        pytest.param(hang, 0.5, "time-out", id="a system that hangs is stopped"),
        pytest.param(fail, 60, "error: ValueError", id="a system that fails is no answer"),
    ],
)
def test_a_system_without_an_answer(
    system: object, time_out: float, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(SYSTEMS, "strange", system)
    question = Question(((0, 0),), "=", Domain(), ())
    assert timed("strange", question, time_out=time_out).said == said


BLOCK = bytearray(16 * 2**20)


def copies(question: Question) -> str:
    """Count the copies that it takes to write to the parent's memory, once the clock runs."""
    before = getrusage(RUSAGE_SELF).ru_minflt
    if question is not EASY:
        BLOCK[::PAGESIZE] = bytes(len(BLOCK) // PAGESIZE)
    return str(getrusage(RUSAGE_SELF).ru_minflt - before)


@pytest.mark.skipif(not CAN_OWN, reason="the system copies memory only when it is written to")
def test_memory_is_copied_before_the_clock_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    BLOCK[:] = bytes(len(BLOCK))
    monkeypatch.setitem(SYSTEMS, "copies", copies)
    question = Question(((0, 0),), "=", Domain(), ())
    owned = int(timed("copies", question).said)
    monkeypatch.setattr(rivals, "own_memory", lambda: None)
    assert owned < int(timed("copies", question).said) / 2


def test_the_elimination_is_proved_in_stages() -> None:
    lemmas = staged()
    assert len(lemmas) == 14
    assert all(isinstance(decide_equal(left, right), Proved) for left, right in lemmas)


def test_the_direct_elimination_is_proved() -> None:
    equations = direct()
    assert len(equations) == 3
    assert all(isinstance(zero_test.decide_equal(left, right), Proved) for left, right in equations)


def test_a_misprint_in_the_direct_elimination_is_refuted() -> None:
    (left, right), *_ = direct()
    assert isinstance(zero_test.decide_equal(add(left, Symbol("v_2")), right), Refuted)
