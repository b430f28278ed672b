"""Whether the corpus is right about mathematics: every record at 20 points, with 60 digits.

A true record holds at all of them, a false one fails at some, a branch holds just where its
condition does. That tells nothing of engines, and no engine is asked.
"""

import random
from collections.abc import Iterator

import pytest
from mpmath import mp, mpf
from numerics import holds, parsed, value, with_definitions

from corpus import Record, load
from omniproof.decide.digits import DIGITS, UndefinedError
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tree import Chain, names

POINTS = 20
RECORDS = load()


def symbols(record: Record) -> list[str]:
    """Return the names that a point has to give a number, in a fixed order."""
    defined: set[str] = set()
    found: set[str] = set()
    for text in record.where:
        node = parsed(text)
        assert isinstance(node, Chain)
        found |= names(node.sides[1]) - defined
        defined |= names(node.sides[0])
    used = {name.removeprefix("\\det ") for name in names(parsed(record.latex))}
    return sorted(found | (used - defined))


def points(record: Record) -> Iterator[dict[str, mpf]]:
    """Yield points of the domain, the same in every run."""
    chance = random.Random(record.id)
    positive = {symbol_name(name) for name in record.positive}
    ranges = {symbol_name(name): ends for name, ends in record.ranges.items()}
    for _ in range(POINTS if symbols(record) else 1):
        point = {}
        for name in symbols(record):
            share = mpf(chance.randrange(1, 10**15)) / 10**15
            low, high = (mpf(0), mpf(5)) if name in positive else (mpf(-5), mpf(5))
            if name in ranges:
                low, high = (value(end, {}) for end in ranges[name])
            point[name] = low + (high - low) * share
        yield point


def truths(record: Record) -> list[tuple[bool, bool]]:
    """Return whether the formula and its condition hold, where the formula is defined."""
    found = []
    with mp.workdps(DIGITS):
        for point in points(record):
            values = with_definitions(record.where, point)
            try:
                here = holds(record.latex, values)
            except UndefinedError:
                continue
            wanted = record.condition == "" or holds(record.condition, values)
            found.append((here, wanted))
    return found


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.id)
def test_the_record_is_right(record: Record) -> None:
    found = truths(record)
    assert len(found) >= (5 if symbols(record) else 1)
    if record.expected == "refuted":
        assert not all(here for here, _ in found)
    else:
        assert all(here == wanted for here, wanted in found)
        assert (record.expected == "branch") == (not all(wanted for _, wanted in found))


def test_there_are_enough_of_each() -> None:
    expected = [record.expected for record in RECORDS]
    assert len(expected) >= 130
    assert expected.count("refuted") >= 35
    assert expected.count("branch") >= 10
