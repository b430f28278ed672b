"""A fault whose card lacks something is found, whatever it is."""

from __future__ import annotations

import pytest

from omniproof.audit.ledger import Ledger
from omniproof.report.cards import card_faults, opened
from omniproof.report.derived import Derived
from omniproof.report.finish import set_formulas
from omniproof.report.fragments import Chapter
from omniproof.report.fragments.rows import details_script, read_details

PAGE = "omni-arrangement.html"


@pytest.fixture
def text(chapter: Chapter) -> str:
    """A page with every row, as if all were opened."""
    details = read_details(details_script(chapter.ledger))
    page = chapter.table("tab:2[").html + chapter.every_row().html
    return set_formulas([opened(page, details)])[0]


def test_nothing_is_lacking(text: str, ledger: Ledger) -> None:
    assert sum(row.verdict.is_fault for row in ledger.rows) > 0
    assert list(card_faults(PAGE, text, ledger, Derived(ledger))) == []


@pytest.mark.parametrize(
    ("old", "new", "lacking"),
    [
        pytest.param("counterexample", "example", "counterexample", id="witness"),
        pytest.param("should read", "reads", "should read", id="correction"),
        pytest.param("Adjugate of", "Of", "its whole note", id="note"),
        pytest.param("decided by", "by", "decided by", id="engines"),
        pytest.param("<dt>change</dt>", "<dt>?</dt>", "what changes", id="what changes"),
        pytest.param("data-latex", "data-tex", "LaTeX to copy", id="LaTeX"),
        pytest.param("data-sympy", "data-cas", "SymPy to copy", id="SymPy"),
        pytest.param("derivations", "code", "the source of its derivation", id="derivation"),
        pytest.param('"ledger.csv"', '"x.csv"', "a link to the data", id="data"),
        pytest.param("✗", "", "the shape of its verdict", id="shape"),
        pytest.param(" erratum</span>", "</span>", "its verdict in words", id="word"),
        pytest.param('class="facts"', 'class="x"', "a card", id="the whole card"),
    ],
)
def test_what_a_card_lacks_is_named(
    text: str, ledger: Ledger, old: str, new: str, lacking: str
) -> None:
    assert old in text
    found = list(card_faults(PAGE, text.replace(old, new), ledger, Derived(ledger)))
    assert any(fault.endswith(f" lacks {lacking}") for fault in found)
    assert all(fault.startswith(f"{PAGE}: ") for fault in found)
