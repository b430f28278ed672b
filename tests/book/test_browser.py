"""The report in a browser: quiet, typeset, as wide as the screen, and open to every reader."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import DESK, PHONE, Sight, barriers, look, names, served, visit
from playwright.sync_api import Browser, Page
from small_report import ROOT

CONTENTS = (ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
# A test a page, so that two processes can share them: the longest pages take ten seconds each.
CHAPTERS = re.findall(r"(?:root|file): (\S+)", CONTENTS)
PAGES = sorted(f"{name}.html" for name in (*CHAPTERS, "genindex", "search"))
FULL_OF_FORMULAS = "omni-arrangement.html"


@pytest.fixture(params=["http", "file"])
def root(request: pytest.FixtureRequest, report: Path) -> Iterator[str]:
    """Give the address of the report, with a slash at its end."""
    if request.param == "file":
        yield f"{report.as_uri()}/"
    else:
        with served(report) as address:
            yield address


@pytest.fixture(scope="module", params=PAGES)
def on_desk(
    request: pytest.FixtureRequest, chromium: Browser, report: Path
) -> Iterator[tuple[Page, Sight]]:
    """Give a page of the report over http, opened once, and what is to be seen of it."""
    page = chromium.new_page(viewport={"width": DESK, "height": 800})
    with served(report) as address:
        yield page, look(page, address, request.param)
    page.close()


def check(seen: Sight, width: int, name: str) -> None:
    """No message, no failed or outside request, every formula set, nothing beyond the screen."""
    assert (seen.said, seen.errors, seen.bare) == ([], [], [])
    assert seen.width <= width
    assert seen.formulas > 20 or name != FULL_OF_FORMULAS


def test_every_page_is_looked_at(report: Path) -> None:
    assert names(report) == PAGES


def test_page_on_a_desk(on_desk: tuple[Page, Sight]) -> None:
    page, seen = on_desk
    check(seen, DESK, page.url.rpartition("/")[2])


def test_page_has_no_barrier(on_desk: tuple[Page, Sight]) -> None:
    """axe-core finds nothing serious: contrast, names, roles, what the keyboard reaches."""
    page, _ = on_desk
    assert [fault for mode in ("light", "dark") for fault in barriers(page, mode)] == []


@pytest.mark.parametrize("name", PAGES)
def test_page_on_a_phone_from_disk(chromium: Browser, report: Path, name: str) -> None:
    page = chromium.new_page(viewport={"width": PHONE, "height": 800})
    seen = look(page, f"{report.as_uri()}/", name)
    page.close()
    check(seen, PHONE, name)


def test_the_tests_see_what_is_wrong(page: Page, small: Path, tmp_path: Path) -> None:
    """The test above can fail, in each of its parts; and so can that for barriers."""
    shutil.copytree(small, tmp_path / "html")
    file = tmp_path / "html" / "index.html"
    wrong = (
        '<span class="math">\\(\\frac{1}\\)</span><span class="math">x</span>'
        '<div style="width: 1900px">wide</div><script>console.error("trouble")</script>'
        '<p style="color: #ddd; background: #fff">pale</p><img src="https://host.invalid/x.png">'
        "</article>"
    )
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("</article>", wrong, 1), encoding="utf-8")
    seen = look(page, f"{file.parent.as_uri()}/", "index.html")
    assert any("frac" in error for error in seen.errors)
    assert seen.bare == ["x"]
    assert seen.width > DESK
    assert {"trouble", "asks: https://host.invalid/x.png"} <= set(seen.said)
    found = barriers(page, "light")
    assert any(fault.startswith("color-contrast") for fault in found)
    assert any(fault.startswith("image-alt") for fault in found)


def test_search_finds_a_chapter(page: Page, root: str) -> None:
    visit(page, f"{root}search.html?q=verdict")
    hit = page.locator("#search-results li a").first
    hit.wait_for(timeout=10_000)
    hit.click()
    page.wait_for_load_state()
    assert not page.url.startswith(f"{root}search")
    assert "verdict" in page.locator("article").inner_text()


STILL = "() => Promise.allSettled(document.getAnimations().map((each) => each.finished))"
"""Colours change slowly."""


def test_dark_mode_is_a_button(page: Page, report: Path) -> None:
    """Light first; the button leads to a dark ground with light words, and back."""
    luminance = """() => [getComputedStyle(document.body).backgroundColor,
      getComputedStyle(document.querySelector("h1")).color]
      .map((c) => c.match(/\\d+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0))"""
    visit(page, f"{report.as_uri()}/index.html")
    seen = []
    for _ in range(3):
        seen.append((page.locator("html").get_attribute("data-theme"), *page.evaluate(luminance)))
        page.locator(".theme-switch-button:visible").first.click()
        page.evaluate(STILL)
    assert {mode for mode, _, _ in seen} == {"light", "dark"}
    for mode, ground, words in seen:
        assert (ground < words) == (mode == "dark")


@pytest.mark.parametrize("name", ["index.html", "omni-arrangement.html"])
def test_print(page: Page, report: Path, name: str) -> None:
    """On paper there is no navigation, all that was folded is open, and nothing is cut off."""
    visit(page, f"{report.as_uri()}/{name}")
    page.emulate_media(media="print")
    page.set_viewport_size({"width": 794, "height": 1123})  # A4 at 96 dots an inch
    page.evaluate("() => window.dispatchEvent(new Event('beforeprint'))")
    assert page.locator("article details:not([open])").count() == 0
    assert not page.locator(".bd-sidebar-primary").is_visible()
    assert page.evaluate("() => document.documentElement.scrollWidth") <= 794
    page.evaluate("() => window.dispatchEvent(new Event('afterprint'))")
    assert page.pdf().startswith(b"%PDF")
