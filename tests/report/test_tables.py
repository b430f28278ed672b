from __future__ import annotations

from pathlib import Path

import pytest

from omniproof.report.tables import write_tables

PAPER = """
tables:
  - id: tab:2
    file: table-2.csv
    units: {D_V: (m/s)^3, D_A: (m/s)^2}
"""
NUMBERS = """row,column,printed,unit,interval,computed,verdict
Y,D_V,4.00,(m/s)^3,"[3.995, 4.005]",4,verified
Z,D_A,13.85,(m/s)^2,"[13.845, 13.855]",13.8564,misrounded
"""
NOMENCLATURE = """row,printed,verdict,correction,note
8,\\Sigma - xy,inconsistent,,differs from sec:2/global-frame-name.
"""


@pytest.mark.parametrize(
    ("number", "expected"),
    [
        pytest.param(2, NUMBERS, id="numbers beside computed values"),
        pytest.param(1, NOMENCLATURE, id="nomenclature as a list"),
    ],
)
def test_tables(results: Path, tmp_path: Path, number: int, expected: str) -> None:
    (tmp_path / "paper.yaml").write_text(PAPER)
    target = tmp_path / "out.csv"
    write_tables(tmp_path, results / "ledger" / "omni-arrangement.json", {number: target})
    assert target.read_text(encoding="utf-8") == expected


def test_a_table_without_cells_is_an_error(results: Path, tmp_path: Path) -> None:
    ledger = results / "ledger" / "omni-arrangement.json"
    with pytest.raises(ValueError, match=r"omni-arrangement\.json: no cell of Table 7"):
        write_tables(tmp_path, ledger, {7: tmp_path / "out.csv"})
