"""Take the picture of the README from the built report: a matrix with a misprint, as it is judged.

    make && .venv/bin/python tests/book/picture.py

Not part of the build: letters look a little different on every machine.
"""

from __future__ import annotations

import shutil

from built_report import BUILT, ROOT
from playwright.sync_api import sync_playwright

PAGE, ANSWER = "omni-arrangement.html", "#eq-6"
WIDTH, SCALE = 680, 1.75
HIDDEN = ".pastes, .answer .quiet, .bd-header-article { display: none !important; }"


def take() -> None:
    """Write `report.png`; raises `AssertionError` without Chromium."""
    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    assert chromium, "no chromium on this machine"
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        page = browser.new_page(
            viewport={"width": WIDTH, "height": 1200}, device_scale_factor=SCALE
        )
        page.goto(f"{BUILT.as_uri()}/{PAGE}")
        page.add_style_tag(content=HIDDEN)
        page.locator(ANSWER).screenshot(path=ROOT / "report.png")
        browser.close()


if __name__ == "__main__":
    take()
