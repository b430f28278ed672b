"""Our engines on the corpus: nothing wrong, nothing undecided; what they cannot do yet is named."""

import pytest
from questions import ask, decision, verdict

from corpus import Record, load
from omniproof.audit.answer import OnBranch

CANNOT = {
    "half-cosine-sign": "no sample point leaves the branch: points stay within half a turn",
}
"""What the engines cannot do, by id; a record that is decided leaves this list."""


def rows() -> list[object]:
    return [
        pytest.param(
            record,
            id=record.id,
            marks=[pytest.mark.xfail(reason=CANNOT[record.id], strict=True)]
            if record.id in CANNOT
            else [],
        )
        for record in load()
    ]


@pytest.mark.parametrize("record", rows())
def test_the_engines_say_what_mathematics_says(record: Record) -> None:
    question = ask(record)
    assert verdict(question, decision(question, confirmed=True)) == record.expected


@pytest.mark.parametrize("name", sorted(CANNOT))
def test_what_cannot_be_decided_is_not_decided_wrongly(name: str) -> None:
    (record,) = (record for record in load() if record.id == name)
    question = ask(record)
    given = verdict(question, decision(question))
    assert given in {"undecided", record.expected}


def test_a_branch_names_its_condition() -> None:
    for record in load():
        if record.expected == "branch" and record.id not in CANNOT:
            answer = decision(ask(record))
            assert isinstance(answer, OnBranch)
            assert answer.condition
