"""Our engines on the corpus: nothing wrong, nothing undecided, every condition the right one."""

import pytest
from mpmath import mp
from numerics import holds, with_definitions
from questions import ask, decision, verdict
from test_truth import points

from corpus import Record, load
from omniproof.decide.answer import OnBranch
from omniproof.decide.digits import DIGITS

RECORDS = [pytest.param(record, id=record.id) for record in load()]
BRANCHES = [pytest.param(r, id=r.id) for r in load() if r.expected == "branch"]
AND = r" \text{ and } "


@pytest.mark.parametrize("record", RECORDS)
def test_the_engines_say_what_mathematics_says(record: Record) -> None:
    question = ask(record)
    assert verdict(question, decision(question, confirmed=True)) == record.expected


@pytest.mark.parametrize("record", BRANCHES)
def test_a_branch_has_the_condition_of_the_record(record: Record) -> None:
    """The engines word it in their own way; at each of 20 points it says the same."""
    answer = decision(ask(record))
    assert isinstance(answer, OnBranch)
    with mp.workdps(DIGITS):
        for point in points(record):
            values = with_definitions(record.where, point)
            ours = all(holds(part, values) for part in answer.condition.split(AND))
            assert ours == holds(record.condition, values)
