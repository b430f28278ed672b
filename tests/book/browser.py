"""What a browser sees of one page of the report, over http or from disk."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page

PHONE, PAPER, DESK = 360, 794, 1280  # paper: A4 at 96 dots an inch
COMMON_PHONE = 390
USUAL = ("[PST]", "[togglebutton]")  # what the theme tells the console on every page

_LOOK = """() => {
  const all = (query) => [...document.querySelectorAll(query)];
  const text = (element) => element.textContent.slice(0, 80);
  return {
    width: document.documentElement.scrollWidth,
    formulas: all("math").length,
    bare: all(".math").filter((e) => !e.querySelector("math")).map(text),
  };
}"""
_STOPS = """() => [
  ...document.querySelectorAll("a[href], button, input, select, textarea, summary, [tabindex]"),
]
  .filter((e) => e.tabIndex >= 0 && !e.disabled && !(e.type === "radio" && !e.checked))
  .filter((e) => e.checkVisibility({ visibilityProperty: true })).length
"""
_FORMULAS = Path(__file__).with_name("formulas.js").read_text(encoding="utf-8")
_UNFOLD = """() => {
  const folded = [...document.querySelectorAll("details:not([open])")];
  for (const e of folded) { e.open = true; e.dataset.folded = ""; }
}"""
_FOLD = """() => {
  for (const e of document.querySelectorAll("[data-folded]")) {
    e.open = false;
    delete e.dataset.folded;
  }
}"""
# Bars that slide take their formulas along; sizes are told to scripts once a frame.
_STILL = """async () => {
  await Promise.allSettled(document.getAnimations().map((each) => each.finished));
  for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
}"""
# axe takes minutes for a chapter. Shapes of letters and lines have no text of their own; of cards
# and rows that look alike (entries of a matrix, too), the first ones stand for the rest;
# dark mode is about colours alone, and one of a kind has them all.
_PLAIN = """(mode) => {
  const seen = {};
  for (const e of document.querySelectorAll(".rows tbody, table tbody > tr")) {
    if (!e.isConnected) continue;
    const kind = `${e.parentElement.parentElement.className} ${e.className}`;
    seen[kind] = (seen[kind] || 0) + 1;
    if (seen[kind] > (mode === "dark" ? 1 : 4)) e.remove();
  }
  for (const e of document.querySelectorAll("figure.drawn svg")) e.replaceChildren();
  const still = document.createElement("style");
  still.textContent = "* { transition: none !important; }";
  document.head.append(still);
  document.documentElement.dataset.theme = mode;
}"""


@dataclass(frozen=True)
class Sight:
    """One page as a browser shows it; `said`: console, failed and outside requests."""

    width: int
    formulas: int
    bare: list[str]
    said: list[str]


class _Silent(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002 - named by the base class
        """Say nothing: every request would be a line in the tests' output."""

    def copyfile(self, source: Any, outputfile: Any) -> None:
        """Send a file; a page that was closed meanwhile is no fault."""
        with suppress(ConnectionError):
            super().copyfile(source, outputfile)


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """Serve a folder on this machine; give its address."""
    handler = partial(_Silent, directory=str(folder))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


def names(report: Path) -> list[str]:
    """Return the files of all pages of a report."""
    return sorted(path.name for path in report.glob("*.html"))


def width(page: Page, screen: int) -> int:
    """Return how wide an open page is on a screen of this width."""
    page.set_viewport_size({"width": screen, "height": 800})
    return int(page.evaluate("() => document.documentElement.scrollWidth"))


def tab_stops(page: Page) -> int:
    """Return how many elements of an open page the tabulator stops at."""
    return int(page.evaluate(_STOPS))


def unseen_formulas(page: Page) -> list[str]:
    """Return the formulas of an open page that cannot be seen whole: `place: what cuts them`.

    Whatever sets them and whatever they stand in: their ink is held against all that cuts, as far
    as it cannot be scrolled into view by keyboard.
    """
    page.evaluate(_STILL)
    return list(page.evaluate(_FORMULAS)["faults"])


@contextmanager
def unfolded(page: Page) -> Iterator[None]:
    """Open everything on a page that unfolds, for a while."""
    page.evaluate(_UNFOLD)
    yield
    page.evaluate(_FOLD)


def visit(page: Page, address: str) -> None:
    """Open an address."""
    page.goto(address)


def look(page: Page, root: str, name: str) -> Sight:
    """Open one page of the report at `root`; return what is to be seen and heard."""
    said: list[str] = []
    page.on("console", lambda m: None if m.text.startswith(USUAL) else said.append(m.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("requestfailed", lambda request: said.append(f"failed: {request.url}"))
    page.on("response", lambda r: said.append(f"{r.status}: {r.url}") if r.status >= 400 else None)
    page.on("request", lambda r: None if _inside(r.url, root) else said.append(f"asks: {r.url}"))
    visit(page, root + name)
    return Sight(**page.evaluate(_LOOK), said=said)


def _inside(address: str, root: str) -> bool:
    return address.startswith((root, "data:", "blob:"))


def barriers(page: Page, mode: str) -> list[str]:
    """Return what axe-core calls serious or critical on the open page, with one example each.

    `mode`: light or dark. What does not depend on colours is looked for in light mode only.
    """
    page.evaluate(_PLAIN, mode)
    options: dict[str, Any] = {"resultTypes": ["violations"], "preload": False, "iframes": False}
    if mode == "dark":
        options["runOnly"] = ["color-contrast"]
    found = Axe().run(page, options=options).response["violations"]
    return [
        f"{fault['id']} ({len(fault['nodes'])}): {fault['nodes'][0]['html'][:120]}"
        for fault in found
        if fault["impact"] in {"serious", "critical"}
    ]
