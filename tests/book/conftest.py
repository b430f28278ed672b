"""A small report that is built here, and the one that `make` built."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import DESK
from built_report import BUILT, is_fresh
from playwright.sync_api import Browser, Page, sync_playwright
from small_report import ROOT, small_results

from omniproof.report.book import build, stage

CHROMIUM = os.environ.get("CHROMIUM", shutil.which("chromium") or shutil.which("google-chrome"))


@pytest.fixture(scope="session")
def small(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the book of the project around the small results."""
    folder = tmp_path_factory.mktemp("book")
    stage(ROOT / "book", small_results(folder / "results"), ROOT / "paper_data", folder / "source")
    build(folder / "source", folder / "html")
    return folder / "html"


@pytest.fixture(params=["small", "built"])
def pages(request: pytest.FixtureRequest) -> Path:
    """Give the small report, then the real one where `make` has built it."""
    if request.param == "small":
        return Path(request.getfixturevalue("small"))
    if not is_fresh():
        pytest.skip("book/_build/html is missing or older than its sources: run `make`")
    return BUILT


@pytest.fixture(scope="module")
def chromium() -> Iterator[Browser]:
    if not CHROMIUM:
        pytest.skip("no chromium on this machine, or CHROMIUM is set to none")
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture(scope="module")
def report(request: pytest.FixtureRequest) -> Path:
    """Give the real report where `make` has built it, else the small one: pages take seconds."""
    return BUILT if is_fresh() else Path(request.getfixturevalue("small"))


@pytest.fixture
def page(chromium: Browser) -> Iterator[Page]:
    """Give an empty page, as wide as a desk's screen."""
    context = chromium.new_context(viewport={"width": DESK, "height": 900})
    yield context.new_page()
    context.close()
