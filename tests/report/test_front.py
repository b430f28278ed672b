"""The first page: words of ours stand only while the ledger bears them out; bars are to scale."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from omniproof.audit.ledger import Ledger, Row
from omniproof.report.fragments import Overview
from omniproof.report.fragments.counts import bar_html, legend_html, verdict_counts
from omniproof.report.fragments.front import told

ROOT = Path(__file__).parents[2]


@pytest.fixture
def row(ledger: Ledger) -> Row:
    return next(row for row in ledger.rows if row.id == "eq:6[1,2]")


def test_a_bar_is_true_to_scale(ledger: Ledger) -> None:
    shares = [float(width) for width in re.findall(r"width:([\d.]+)%", bar_html(ledger))]
    counts = sorted(verdict_counts(ledger).values())
    assert sorted(shares) == pytest.approx([100 * n / len(ledger.rows) for n in counts], abs=1e-3)


def test_a_legend_says_every_number(ledger: Ledger) -> None:
    legend = legend_html(ledger)
    for verdict, count in verdict_counts(ledger).items():
        assert re.search(rf"v-{verdict}\b[^/]*</span> {count} ", legend)


def test_a_sentence_links_its_finding_and_writes_what_is_right(row: Row) -> None:
    html = told("a paper", "Wrong in {eq:6[1,2]}, right: {eq:6[1,2]:correct}.", lambda _: row)
    assert f'<a href="{row.paper}.html#eq-6-1-2">{row.where}</a>' in html
    assert row.correction in html


def test_a_sentence_without_its_finding_stops_the_build(overview: Overview) -> None:
    with pytest.raises(ValueError, match=r"eq:1 is no finding whose source is clear"):
        overview.picture("omni-arrangement eq:1", "sign")
    with pytest.raises(ValueError, match=r"eq:1 is no finding whose source is clear"):
        Overview(overview.ledgers, (), ROOT / "results").papers(
            {"omni-arrangement": "Wrong in {eq:1}."}
        )


def test_a_typed_number_stops_the_build(row: Row) -> None:
    with pytest.raises(ValueError, match=r"write what the ledger has for 3\.5"):
        told("a paper", "Off by 3.5 metres.", lambda _: row)


def test_a_question_about_what_is_right_stops_the_build(overview: Overview) -> None:
    with pytest.raises(ValueError, match="is as it should be"):
        overview.questions({"omni-arrangement eq:5": "What is the wheel matrix?"})
