"""What a reader can do with claims: sort and filter findings, copy a formula, dispute a verdict."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page
from small_report import RESULTS

from omniproof.audit.ledger import read_ledgers
from omniproof.transcription.model import Source

COPIED = "navigator.clipboard.writeText = async (text) => { window.copied = text; };"


@pytest.fixture
def context(chromium: Browser) -> Iterator[BrowserContext]:
    found = chromium.new_context(viewport={"width": 1280, "height": 900})
    found.add_init_script(COPIED)
    yield found
    found.close()


def opened(context: BrowserContext, small: Path, name: str) -> Page:
    page = context.new_page()
    page.set_default_timeout(10_000)
    page.goto(f"{small.as_uri()}/{name}")
    return page


@pytest.fixture
def findings(context: BrowserContext, small: Path) -> Page:
    return opened(context, small, "findings.html")


def column(page: Page, number: int) -> list[str]:
    cells = page.locator(f"table.findings tbody tr:visible td:nth-child({number})")
    return [text.strip() for text in cells.all_inner_texts()]


def test_remarks_on_wording_and_references_are_not_shown_at_first(findings: Page) -> None:
    faults = column(findings, 3)
    findings.get_by_label("show", exact=True).select_option(
        "faults, and remarks on wording and references"
    )
    everything = column(findings, 3)
    assert 0 < len(faults) < len(everything)
    assert {"✎ editorial"} & set(faults) == set() != {"✎ editorial"} & set(everything)


def test_findings_are_filtered_by_verdict_and_counted(findings: Page) -> None:
    findings.get_by_label("show", exact=True).select_option("")
    everything = column(findings, 3)
    findings.get_by_label("verdict", exact=True).select_option("erratum")
    found = column(findings, 3)
    assert 0 < len(found) < len(everything)
    assert all(word.endswith("erratum") for word in found)
    count = f"{len(found)} of {len(everything)} findings"
    assert findings.locator(".filters [role=status]").inner_text() == count
    findings.get_by_role("button", name="Reset").click()
    assert len(found) < len(column(findings, 3)) < len(everything)


def test_filters_work_together_with_words(findings: Page) -> None:
    findings.get_by_label("kind", exact=True).select_option("identity")
    findings.get_by_label("words", exact=True).fill("no such word")
    assert findings.locator(".filters [role=status]").inner_text().startswith("0 of ")


def test_heads_sort_by_gravity_and_not_by_the_alphabet(findings: Page) -> None:
    findings.get_by_role("button", name="verdict").click()
    found = [text.split(maxsplit=1)[-1] for text in column(findings, 3)]
    gravity = ["erratum", "inconsistent", "model gap", "misrounded", "conditional", "editorial"]
    places = [gravity.index(word) for word in found]
    assert places == sorted(places)
    assert len(set(places)) > 2
    assert findings.locator("th", has_text="verdict").get_attribute("aria-sort") == "ascending"


def test_findings_are_complete_without_a_script(chromium: Browser, small: Path) -> None:
    context = chromium.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto((small / "findings.html").as_uri())
    rows = read_ledgers(RESULTS)[0].rows
    clear = [row for row in rows if row.verdict.is_fault and row.source is Source.CLEAR]
    assert len(column(page, 1)) == len(clear)
    assert page.locator(".filters").count() == 0
    context.close()


def test_a_card_gives_its_formula_to_copy(context: BrowserContext, small: Path) -> None:
    page = opened(context, small, "omni-arrangement.html#eq-6-1-2")
    page.get_by_role("button", name="Copy LaTeX: eq:6[1,2]").click()
    assert page.evaluate("window.copied") == r"\sin \alpha_1 - \sin \alpha_2"
    page.get_by_role("button", name="Copy SymPy: eq:6[1,2]").click()
    assert page.evaluate("window.copied") == "-cos(alpha_1) + cos(alpha_3)"  # of the real paper
    assert page.locator("#eq-6-1-2 [role=status]").inner_text() == "Copied"


def test_a_verdict_can_be_disputed(context: BrowserContext, small: Path) -> None:
    page = opened(context, small, "omni-arrangement.html#eq-6-1-2")
    page.get_by_role("button", name="Dispute: eq:6[1,2]").click()
    text = page.get_by_label("text of the issue").input_value()
    assert text.startswith("Dispute: omni-arrangement eq:6[1,2]\n")
    assert "Address: omni-arrangement.html#eq-6-1-2" in text
    assert "Verdict: ✗ erratum" in text
    assert "Derivation: omniproof/papers/omni_arrangement/derivations/kinematics.py:" in text
    page.get_by_role("button", name="Copy", exact=True).click()
    assert page.evaluate("window.copied") == text
    page.keyboard.press("Escape")
    assert page.locator("dialog.dispute").count() == 0


def test_the_changed_part_is_marked(context: BrowserContext, small: Path) -> None:
    page = opened(context, small, "omni-arrangement.html#eq-6-1-2")
    assert "becomes" in page.locator("#eq-6-1-2 dl.facts").inner_text()
    assert page.locator("#eq-6-1-2 .changed:visible").count() == 2  # printed, and right
