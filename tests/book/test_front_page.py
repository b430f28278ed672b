"""The first page and what it leads to: one click to the right formula, bars true to scale."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import COMMON_PHONE, DESK, visit, width
from built_report import BUILT, is_fresh
from playwright.sync_api import Browser, Page

from omniproof.report.book import read_ledgers
from omniproof.report.fragments.counts import verdict_counts

QUESTIONS = 6
PAPERS = 5


@pytest.fixture(scope="module")
def built() -> Path:
    if not is_fresh():
        pytest.skip("book/_build/html is missing or older than its sources: run `make`")
    return BUILT


@pytest.fixture
def front(chromium: Browser, built: Path) -> Iterator[Page]:
    context = chromium.new_context(viewport={"width": DESK, "height": 900})
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = context.new_page()
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    visit(page, f"{built.as_uri()}/index.html")
    yield page
    context.close()
    assert [url for url in asked if not url.startswith(("file:", "data:", "blob:"))] == []


def pasted(page: Page) -> str:
    return str(page.evaluate("() => navigator.clipboard.readText()"))


def test_one_click_copies_the_inverse_as_latex(front: Page) -> None:
    front.get_by_role("button", name=re.compile("Copy LaTeX: .*inverse of three wheels")).click()
    front.get_by_role("button", name=re.compile("Copy LaTeX: .*inverse")).get_by_text("Copied")
    text = pasted(front)
    assert text.count(r"\begin{pmatrix}") == text.count(r"\end{pmatrix}") > 0
    assert r"\sin \alpha_1 - \sin \alpha_2" in text
    assert r"\sin \alpha_1 + \sin \alpha_2" not in text


def test_the_inverse_as_numpy_undoes_the_wheel_matrix(front: Page) -> None:
    front.get_by_role("button", name=re.compile("Copy NumPy: .*inverse of three wheels")).click()
    check = (
        "a = np.radians([30, 150, 270]); A = np.column_stack([-np.sin(a), np.cos(a), np.ones(3)])\n"
        "found = inverse(*a) @ A\n"
        "assert np.allclose(found, np.eye(3)), found"
    )
    exec(f"{pasted(front)}\n{check}", {})


def test_every_question_has_a_formula_to_copy_and_a_way_to_its_chapter(front: Page) -> None:
    items = front.locator("ol.questions > li")
    assert items.count() == QUESTIONS
    for item in items.all():
        assert item.locator("button", has_text="Copy LaTeX").count() == 1
        assert re.match(r"[\w-]+\.html#\S+", item.locator("a").first.get_attribute("href") or "")


def test_is_equation_16_right(front: Page) -> None:
    """Ctrl-K, the question, the first hit: printed and right form stand there."""
    front.keyboard.press("Control+k")
    front.keyboard.type("Eq. (16)")
    front.keyboard.press("Enter")
    front.wait_for_url("**/search.html?q=*")
    front.locator("ol.hits a").first.click()
    front.wait_for_url("**/omni-trajectory.html#eq-16")
    block = front.locator("#eq-16")
    assert block.is_visible()
    assert "erratum" in block.inner_text()


def test_bars_are_true_to_scale(front: Page, built: Path) -> None:
    ledgers = {ledger.paper: ledger for ledger in read_ledgers(built.parents[2] / "results")}
    papers = front.locator("section.paper")
    assert papers.count() == PAPERS == len(ledgers)
    for paper in papers.all():
        key = (paper.locator("a").first.get_attribute("href") or "").removesuffix(".html")
        whole = paper.locator(".bar").bounding_box()
        for verdict, count in verdict_counts(ledgers[key]).items():
            part = paper.locator(f".bar .v-{verdict}").bounding_box()
            share = part["width"] / whole["width"]
            assert share == pytest.approx(count / len(ledgers[key].rows), abs=0.002)


def test_the_picture_has_its_numbers_in_words(front: Page) -> None:
    alt = front.locator("#figure-sign svg").get_attribute("aria-label") or ""
    assert re.search(r"up to 0\.\d+ m apart", alt)
    script = front.locator("#figure-sign a", has_text="script").get_attribute("href") or ""
    assert (BUILT / script.partition("#")[0]).is_file()


@pytest.mark.parametrize("screen", [COMMON_PHONE, DESK])
def test_nothing_is_wider_than_the_screen(front: Page, screen: int) -> None:
    assert width(front, screen) <= screen


def test_a_claim_can_be_cited(front: Page, built: Path) -> None:
    front.goto(f"{built.as_uri()}/omni-arrangement.html#eq-6-2-3")
    front.get_by_role("button", name=re.compile(r"citation of Eq. \(6\).*BibTeX")).click()
    text = pasted(front)
    assert text.startswith("@misc{omniproof:omni-arrangement:eq-6-2-3,")
    assert "erratum" in text
    assert text.count("{") == text.count("}")


@pytest.mark.parametrize(
    ("reports", "start"),
    [
        pytest.param("https://host.invalid/issues/new", "?title=Dispute", id="issue"),
        pytest.param("mailto:a@host.invalid", "?subject=Dispute", id="mail"),
    ],
)
def test_a_wrong_verdict_is_reported_prefilled(
    front: Page, built: Path, reports: str, start: str
) -> None:
    front.goto(f"{built.as_uri()}/omni-arrangement.html#eq-6-2-3")
    front.evaluate("(reports) => { window.PROJECT.reports = reports; }", reports)
    front.locator("#eq-6-2-3 button", has_text="Dispute").click()
    link = front.locator("dialog.dispute a").get_attribute("href") or ""
    assert link.startswith(reports + start)
    assert "eq%3A6%5B2%2C3%5D" in link


def test_what_changed_leads_to_each_row(front: Page, built: Path) -> None:
    front.goto(f"{built.as_uri()}/edition.html")
    links = [a.get_attribute("href") or "" for a in front.locator("main table a").all()]
    assert len(links) > 0
    for link in links:
        page, _, place = link.partition("#")
        assert f'id="{place}"' in (built / page).read_text(encoding="utf-8")
