"""The report in a browser: quiet, typeset, as wide as the screen, and open to every reader."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import (
    COMMON_PHONE,
    DESK,
    PAPER,
    PHONE,
    Sight,
    barriers,
    look,
    names,
    served,
    unfolded,
    unseen_formulas,
    visit,
    width,
)
from playwright.sync_api import Browser, BrowserContext, Page
from small_report import ROOT

CONTENTS = (ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
# A test a page, so that two processes can share them: the longest pages take ten seconds each.
CHAPTERS = re.findall(r"(?:root|file): (\S+)", CONTENTS)
PAGES = sorted(f"{name}.html" for name in (*CHAPTERS, "genindex", "search"))
FULL_OF_FORMULAS = "omni-arrangement.html"
PRINTED = ("index.html", FULL_OF_FORMULAS)


@pytest.fixture(scope="module")
def address(report: Path) -> Iterator[str]:
    with served(report) as address:
        yield address


@pytest.fixture(scope="module")
def desk(chromium: Browser) -> Iterator[BrowserContext]:
    """Give a browser whose pages share a cache."""
    context = chromium.new_context(viewport={"width": DESK, "height": 800})
    yield context
    context.close()


@pytest.fixture(scope="module", params=PAGES)
def from_disk(
    request: pytest.FixtureRequest, chromium: Browser, report: Path
) -> Iterator[tuple[Page, Sight]]:
    """Give a page, opened once, from disk on a phone, and what was to be seen of it there.

    The tests below then change the screen.
    """
    page = chromium.new_page(viewport={"width": PHONE, "height": 800})
    yield page, look(page, f"{report.as_uri()}/", request.param)
    page.close()


def file_of(page: Page) -> str:
    return page.url.rpartition("/")[2]


def check(seen: Sight, screen: int, name: str) -> None:
    """No message, no failed or outside request, every formula set, nothing beyond the screen."""
    assert (seen.said, seen.bare) == ([], [])
    assert seen.width <= screen
    assert seen.formulas > 20 or name != FULL_OF_FORMULAS


def test_every_page_is_looked_at(report: Path) -> None:
    assert names(report) == PAGES


@pytest.mark.parametrize("name", PAGES)
def test_page_over_http(desk: BrowserContext, address: str, name: str) -> None:
    page = desk.new_page()
    check(look(page, address, name), DESK, name)
    page.close()


def test_page_on_a_phone(from_disk: tuple[Page, Sight]) -> None:
    page, seen = from_disk
    check(seen, PHONE, file_of(page))
    assert unseen_formulas(page) == []


def test_page_in_print(from_disk: tuple[Page, Sight]) -> None:
    """On paper there is no navigation, and nothing is cut off; what is folded stays so."""
    page, _ = from_disk
    page.emulate_media(media="print")
    page.evaluate("() => window.dispatchEvent(new Event('beforeprint'))")
    assert not page.locator(".bd-sidebar-primary").is_visible()
    assert width(page, PAPER) <= PAPER
    assert unseen_formulas(page) == []
    page.evaluate("() => window.dispatchEvent(new Event('afterprint'))")
    assert file_of(page) not in PRINTED or page.pdf().startswith(b"%PDF")
    page.emulate_media(media="screen")


def test_page_on_a_desk(from_disk: tuple[Page, Sight]) -> None:
    page, seen = from_disk
    assert width(page, DESK) <= DESK
    assert seen.said == []  # in print and here, too


def test_every_formula_can_be_seen(from_disk: tuple[Page, Sight]) -> None:
    """Everything unfolded, none is cut that does not scroll; the page as a whole never scrolls."""
    page, _ = from_disk
    with unfolded(page):
        for screen in (COMMON_PHONE, DESK):
            assert width(page, screen) <= screen
            assert (screen, unseen_formulas(page)) == (screen, [])


def test_page_has_no_barrier(from_disk: tuple[Page, Sight]) -> None:
    """axe-core finds nothing serious: contrast, names, roles, what the keyboard reaches.

    The last test of a page: it takes most of its cards away.
    """
    page, _ = from_disk
    page.set_viewport_size({"width": DESK, "height": 800})
    assert [fault for mode in ("light", "dark") for fault in barriers(page, mode)] == []


def test_the_tests_see_what_is_wrong(page: Page, small: Path, tmp_path: Path) -> None:
    """The test above can fail, in each of its parts; and so can that for barriers."""
    shutil.copytree(small, tmp_path / "html")
    file = tmp_path / "html" / "index.html"
    wrong = (
        '<span class="math">x</span>'
        '<div style="width: 1900px">wide</div><script>console.error("trouble")</script>'
        '<p style="color: #ddd; background: #fff">pale</p><img src="https://host.invalid/x.png">'
        "</article>"
    )
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("</article>", wrong, 1), encoding="utf-8")
    seen = look(page, f"{file.parent.as_uri()}/", "index.html")
    assert seen.bare == ["x"]
    assert seen.width > DESK
    assert {"trouble", "asks: https://host.invalid/x.png"} <= set(seen.said)
    found = barriers(page, "light")
    assert any(fault.startswith("color-contrast") for fault in found)
    assert any(fault.startswith("image-alt") for fault in found)


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
