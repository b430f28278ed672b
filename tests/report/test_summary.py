from __future__ import annotations

from omniproof.audit.ledger import Ledger, Row
from omniproof.report.summary import HEIGHT, WIDTH, summary

EXPECTED = """\
omni-arrangement: 11 claims, 16 rows
  7 verified, 1 conditional, 4 erratum, 1 misrounded, 1 inconsistent,
  1 editorial, 1 uncheckable
1 theorem that no paper prints

most consequential findings
  ✗ Eq. (6), row 1, column 2: sin α₁ + sin α₂ should read sin α₁ - sin α₂
  ≈ Table 2, Z, D_A: 13.85 should read 13.86
  ◐ Eq. (C.6): det A = sin A + sin B + sin C holds only when α₁ < α₂ < α₃

report  book/_build/html/index.html
"""


def test_summary(ledger: Ledger) -> None:
    """What follows from another fault, what is doubtful and what is mere text stay out."""
    assert summary([ledger], ["thm:one-measure"]) == EXPECTED


def test_summary_fits_a_screen(ledger: Ledger) -> None:
    fault = next(row for row in ledger.rows if row.id == "eq:6[1,2]")
    rows: list[Row] = [
        fault.model_copy(update={"id": f"eq:{i}", "correction": "x + " * 60}) for i in range(90)
    ]
    many = [ledger.model_copy(update={"paper": f"p{i}", "rows": tuple(rows)}) for i in range(5)]
    lines = summary(many, []).splitlines()
    assert len(lines) <= HEIGHT
    assert max(map(len, lines)) <= WIDTH
    assert lines[-1].startswith("report ")
