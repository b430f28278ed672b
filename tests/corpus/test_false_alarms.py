"""True identities of textbooks, written in other ways than ours: none may be called false."""

from importlib import import_module
from pathlib import Path

import pytest
from questions import ask, decision

from corpus import load
from omniproof.decide.answer import OnBranch, Refuted
from omniproof.decide.in_sympy.equality import confirmed_equal


@pytest.mark.slow
def test_no_true_identity_is_called_false(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(Path(__file__).parents[1] / "audit")
    rows = import_module("identity_table").TRUE
    answers = {row.name: confirmed_equal(row.left, row.right, row.domain) for row in rows}
    for record in load():
        if record.expected == "proved":
            answers[f"corpus {record.id}"] = decision(ask(record), confirmed=True)
    alarms = {name for name, answer in answers.items() if isinstance(answer, Refuted | OnBranch)}
    assert alarms == set()
    assert len(answers) >= 200
