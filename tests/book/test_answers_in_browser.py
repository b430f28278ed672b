"""Answers in a browser: one click to the right formula, and text to paste in every tab."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from built_report import BUILT, is_fresh
from playwright.sync_api import Browser, BrowserContext, Page

from omniproof.audit.ledger import read_json
from omniproof.report.anchors import anchor, rows_anchor
from omniproof.transcription.ids import whole

COPIED = "navigator.clipboard.writeText = async (text) => { window.copied = text; };"
RIGHT = r"\sin \alpha_1 - \sin \alpha_2"


@pytest.fixture
def context(chromium: Browser) -> Iterator[BrowserContext]:
    found = chromium.new_context(viewport={"width": 1280, "height": 900})
    found.add_init_script(COPIED)
    yield found
    found.close()


def opened(context: BrowserContext, folder: Path, name: str) -> Page:
    page = context.new_page()
    page.set_default_timeout(10_000)
    page.goto(f"{folder.as_uri()}/{name}")
    return page


@pytest.fixture
def built() -> Path:
    if not is_fresh():
        pytest.skip("book/_build/html is missing or older than its sources: run `make`")
    return BUILT


def test_the_address_of_an_equation_leads_to_its_answer(
    context: BrowserContext, small: Path
) -> None:
    page = opened(context, small, "omni-arrangement.html#eq-6")
    block = page.locator("#eq-6")
    assert RIGHT in block.locator("code").first.inner_text()
    block.get_by_role("button", name="Copy LaTeX of Eq. (6)").click()
    assert RIGHT in page.evaluate("window.copied")


def test_tabs_need_no_script(chromium: Browser, small: Path) -> None:
    context = chromium.new_context(java_script_enabled=False)
    page = opened(context, small, "omni-arrangement.html#eq-6")
    panels = page.locator("#eq-6 .pastes").first.locator(".panel")
    page.locator("#eq-6").get_by_role("radio", name="SymPy").first.check(force=True)
    assert panels.locator("visible=true").count() == 1
    assert "from sympy import" in panels.locator("visible=true").inner_text()
    context.close()


def test_rows_can_be_reached_from_the_answer(context: BrowserContext, small: Path) -> None:
    page = opened(context, small, "omni-arrangement.html#eq-6")
    page.locator("#eq-6").get_by_role("link", name="Row by row").click()
    assert page.url.endswith("#rows-eq-6")
    assert page.locator("#rows-eq-6").count() == 1


@pytest.mark.parametrize(
    "paper", [path.parent.name for path in Path("paper_data").glob("*/*.yaml")]
)
def test_every_numbered_equation_has_its_addresses(
    context: BrowserContext, built: Path, paper: str
) -> None:
    ledger = read_json(Path("results/ledger") / f"{paper}.json")
    numbered = {whole(row.id) for row in ledger.rows if row.id.startswith("eq:")}
    page = opened(context, built, f"{paper}.html")
    for place in numbered:
        assert page.locator(f"[id='{anchor(place)}'].answer").count() == 1
        assert page.locator(f"[id='{rows_anchor(place)}']").count() == 1


@pytest.mark.parametrize(
    ("address", "formula"),
    [
        pytest.param("omni-arrangement.html#eq-6", RIGHT, id="inverse of the wheel matrix"),
        pytest.param("omni-trajectory.html#eq-13", r"= L\frac{\sqrt{2}}", id="radius"),
        pytest.param("omni-trajectory.html#eq-16", r"\frac{L}{a+b+c}", id="centre"),
        pytest.param("ballbot.html#eq-10", r"- \cos {\phi}", id="law of the ballbot"),
    ],
)
def test_the_formula_to_use_is_in_view_at_once(
    context: BrowserContext, built: Path, address: str, formula: str
) -> None:
    page = opened(context, built, address)
    block = page.locator(f"#{address.partition('#')[2]}")
    assert formula in block.locator("code").first.inner_text()
    assert block.evaluate("(e) => Math.abs(e.getBoundingClientRect().top) < innerHeight")


@pytest.mark.parametrize(
    "paper", [path.parent.name for path in Path("paper_data").glob("*/*.yaml")]
)
def test_the_first_answer_is_on_the_first_screens(
    context: BrowserContext, built: Path, paper: str
) -> None:
    """A false one, where there is any: those come first."""
    page = opened(context, built, f"{paper}.html")
    assert page.locator("details.answer ~ section.answer").count() == 0
    top = page.locator(".answer").first.evaluate("(e) => e.getBoundingClientRect().top")
    assert top < 3 * 900


def test_a_derivation_leads_back_to_its_chapter(context: BrowserContext, built: Path) -> None:
    page = opened(context, built, "code/papers/omni_arrangement/derivations/kinematics.html")
    assert page.locator("a:not([href]), a:empty").count() == 0
    page.get_by_role("link", name="omni-arrangement").click()
    assert re.search(r"omni-arrangement\.html$", page.url)


@pytest.mark.parametrize(
    "paper", [path.parent.name for path in Path("paper_data").glob("*/*.yaml")]
)
def test_what_sympy_shows_is_set(context: BrowserContext, built: Path, paper: str) -> None:
    page = opened(context, built, f"{paper}.html")
    shown = page.locator(".output.text_latex")
    assert shown.count() == page.locator(".output.text_latex math").count() > 3
