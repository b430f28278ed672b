"""Formulas that are easily misread: none is called true or false that is not, none is guessed."""

from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from omniproof.audit.check import check

FILE = Path(__file__).with_name("misreadings.yaml")
VERDICTS = {
    "true": "verified",
    "false": "erratum",
    "conditional": "conditional",
    "definition": "definition",
    "refused": "invalid",
    "unproved": "undecided",
}


def formulas() -> Iterator[tuple[str, str]]:
    """Yield each formula with the verdict that is due to it."""
    kinds = yaml.load(FILE.read_text(encoding="utf-8"), Loader=yaml.BaseLoader)
    for groups in kinds.values():
        for truth, listed in groups.items():
            for formula in listed:
                yield formula, VERDICTS[truth]


@pytest.mark.parametrize(("formula", "verdict"), list(formulas()))
def test_no_formula_is_misread(formula: str, verdict: str) -> None:
    found = check(formula)
    assert found.verdict == verdict
    assert found.repairs == () or found.verdict == "erratum"
    # A refusal shows where, and what to write instead.
    assert found.verdict != "invalid" or "^" in found.message


def test_there_are_enough_and_each_once() -> None:
    found = [formula for formula, _ in formulas()]
    assert len(found) == len(set(found)) >= 400
