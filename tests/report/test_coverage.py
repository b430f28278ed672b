"""What was looked at, and who decided, counted from the ledger and an inventory."""

from __future__ import annotations

from pathlib import Path

import pytest

from omniproof.audit.ledger import Ledger
from omniproof.report.fragments import Coverage

INVENTORY = """line,item,text,claim,reason
1,numeral-1,7,,page
2,numeral-1,3,tab:1[3],
2,numeral-2,4,tab:1[4],
3,equation-1,(1),eq:1,
"""


@pytest.fixture
def coverage(tmp_path: Path, ledger: Ledger) -> Coverage:
    folder = tmp_path / ledger.paper
    folder.mkdir()
    (folder / "inventory.csv").write_text(INVENTORY)
    return Coverage((ledger,), tmp_path)


def test_items_are_counted_by_kind(coverage: Coverage, outline: type) -> None:
    page = outline(coverage.inventory().html)
    assert "omni-arrangement1/12/3" in page.text
    counts = [coverage.count(what).html for what in ("items", "claimed", "left out")]
    assert counts == ["4", "3", "1"]


def test_each_row_has_one_decider(coverage: Coverage, ledger: Ledger, outline: type) -> None:
    shown = coverage.engines().html
    numbers = [int(part.partition("<")[0]) for part in shown.split('class="number">')[1:]]
    assert sum(numbers) == len(ledger.rows)
    assert numbers == sorted(numbers, reverse=True)
    assert "nobody: uncheckable" in outline(shown).text


def test_every_verdict_is_explained(coverage: Coverage, outline: type) -> None:
    assert outline(coverage.verdicts().html).tags.count("tr") == 1 + 9
