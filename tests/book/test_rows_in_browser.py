"""What a reader does with the rows of a paper: filter them, open one, follow a link to it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect
from small_report import RESULTS

from omniproof.audit.ledger import Verdict, read_ledgers
from omniproof.report.anchors import anchor
from omniproof.report.fragments.rows import is_trivial

ROWS = read_ledgers(RESULTS)[0].rows


@pytest.fixture
def chapter(page: Page, small: Path) -> Page:
    page.goto(f"{small.as_uri()}/omni-arrangement.html")
    return page


def shown(page: Page) -> list[str]:
    """The rows in view; one whose address its answer bears is known by `data-row`."""
    rows = page.locator("tr.claim:visible")
    return list(rows.evaluate_all("rows => rows.map((row) => row.id || row.dataset.row)"))


def addresses(wanted: object) -> list[str]:
    assert callable(wanted)
    return [anchor(row.id) for row in ROWS if wanted(row)]


def test_faults_come_first_and_trivia_are_closed(chapter: Page) -> None:
    faults = addresses(lambda row: row.verdict.is_fault and not is_trivial(row))
    assert shown(chapter) == faults
    assert 0 < len(faults) < len(ROWS)
    status = chapter.locator(".rows [role=status]")
    expect(status).to_have_text(f"{len(faults)} of {len(ROWS)} rows")


@pytest.mark.parametrize(
    ("choice", "wanted"),
    [
        pytest.param("all", lambda row: True, id="every row"),
        pytest.param("remarks", lambda row: row.verdict.is_fault, id="with remarks on wording"),
        pytest.param("verified", lambda row: row.verdict is Verdict.VERIFIED, id="one verdict"),
    ],
)
def test_rows_are_filtered_by_verdict(chapter: Page, choice: str, wanted: object) -> None:
    chapter.get_by_label("show", exact=True).select_option(choice)
    assert shown(chapter) == addresses(wanted)


def test_rows_are_filtered_by_kind_and_words(chapter: Page) -> None:
    chapter.get_by_label("show", exact=True).select_option("all")
    chapter.get_by_label("kind", exact=True).select_option("identity")
    assert shown(chapter) == addresses(lambda row: row.kind == "identity")
    chapter.get_by_label("words", exact=True).fill("(5), ROW 1, COLUMN 2")
    assert shown(chapter) == ["eq-5-1-2"]
    chapter.get_by_role("button", name="Reset").click()
    assert "eq-5-1-2" not in shown(chapter)


def test_details_are_made_when_a_row_opens(chapter: Page) -> None:
    assert chapter.locator(".details").count() == 0
    button = chapter.locator("#eq-6-1-2 button.more")
    expect(button).to_have_attribute("aria-expanded", "false")
    button.press("Enter")
    expect(chapter.locator("#eq-6-1-2 dl.facts")).to_contain_text("counterexample")
    expect(button).to_have_attribute("aria-expanded", "true")
    button.press("Enter")
    expect(chapter.locator("#eq-6-1-2 dl.facts")).not_to_be_visible()


@pytest.mark.parametrize(
    "address",
    [
        pytest.param("eq-6-1-2", id="a fault"),
        pytest.param("eq-5-1-1", id="a row that is filtered out"),
    ],
)
def test_a_link_opens_its_row(page: Page, small: Path, address: str) -> None:
    page.goto(f"{small.as_uri()}/omni-arrangement.html#{address}")
    facts = page.locator(f"#{address} dl.facts")
    expect(facts).to_contain_text("decided by")
    expect(facts).to_be_in_viewport()


def test_a_link_to_an_equation_shows_all_its_rows(page: Page, small: Path) -> None:
    page.goto(f"{small.as_uri()}/omni-arrangement.html#rows-eq-5")
    expect(page.locator("#rows-eq-5")).to_be_in_viewport()
    assert {"eq-5-1-1", "eq-5-2-2"} <= set(shown(page))


def test_a_link_inside_the_page_opens_its_row(chapter: Page) -> None:
    chapter.locator("#eq-10-a3-2 a[href='#eq-6-1-2']").click()
    expect(chapter.locator("#eq-6-1-2 dl.facts")).to_be_in_viewport()


def test_only_rows_in_view_have_a_button(chapter: Page) -> None:
    assert chapter.locator("tr.claim button").count() == len(shown(chapter))


def test_paper_has_every_row_that_stands_in_no_matrix(chapter: Page) -> None:
    chapter.emulate_media(media="print")
    sound = re.compile(r"(eq|tab):[\w/.]+\[")
    entries = {
        anchor(row.id) for row in ROWS if row.verdict is Verdict.VERIFIED and sound.match(row.id)
    }
    assert shown(chapter) == [a for a in addresses(lambda row: True) if a not in entries]
    assert chapter.locator(".filters:visible").count() == 0
