"""What changed since the first edition: every verdict that is another one, and nothing else."""

from __future__ import annotations

from omniproof.audit.ledger import Ledger, Verdict
from omniproof.report.fragments.edition import changes_since, edition_html, read_first


def test_the_same_verdicts_are_no_change(ledger: Ledger) -> None:
    first = {(row.paper, row.id): row.verdict for row in ledger.rows}
    assert [*changes_since(first, [ledger])] == []
    assert "No verdict has changed" in edition_html([], {})


def test_another_a_new_and_a_lost_row_are_changes(ledger: Ledger) -> None:
    paper, rows = ledger.paper, ledger.rows
    first = {(row.paper, row.id): row.verdict for row in rows[1:]}
    first[paper, rows[2].id] = Verdict.MISROUNDED
    first[paper, "eq:99"] = Verdict.ERRATUM
    found = [(change.id, change.before, change.now) for change in changes_since(first, [ledger])]
    assert found == [
        (rows[0].id, None, rows[0]),
        (rows[2].id, Verdict.MISROUNDED, rows[2]),
        ("eq:99", Verdict.ERRATUM, None),
    ]


def test_a_change_is_shown_with_both_verdicts_and_a_link(ledger: Ledger) -> None:
    row = next(row for row in ledger.rows if row.verdict is Verdict.ERRATUM)
    (change,) = changes_since({(row.paper, row.id): Verdict.CONDITIONAL},
                              [ledger.model_copy(update={"rows": (row,)})])  # fmt: skip
    html = edition_html([change], {row.paper: lambda _: None})
    assert html.index(" conditional</span>") < html.index(" erratum</span>")
    assert f'href="{row.paper}.html#' in html


def test_the_first_edition_had_five_papers_and_no_row_twice() -> None:
    first = read_first()
    assert len({paper for paper, _ in first}) == 5
    assert first["omni-arrangement", "eq:6[2,3]"] is Verdict.ERRATUM
