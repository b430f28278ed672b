"""The report for readers with disabilities, as far as axe-core can tell."""

from __future__ import annotations

from pathlib import Path

from browser import barriers, names
from playwright.sync_api import Page


def test_no_barrier(page: Page, report: Path) -> None:
    """axe-core finds nothing serious: contrast, names, roles, what the keyboard reaches."""
    found = {}
    for name in names(report):
        page.goto(f"{report.as_uri()}/{name}")
        found[name] = [fault for mode in ("light", "dark") for fault in barriers(page, mode)]
    assert {name: faults for name, faults in found.items() if faults} == {}
