"""The derivations as pages that a card can link to, line by line: a verdict rests on this code.

A browser does not open a `.py` file at a line, and not from disk at all. So each file of
derivations becomes one page, in the colours and the mode of the report, with a way back.
"""

from __future__ import annotations

from html import escape
from pathlib import Path

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import PythonLexer

import omniproof

FOLDER = "code"
SHOWN = ("papers/*/derivations/[!_]*.py", "papers/*/figures/[!_]*.py")
"""What a card or a figure rests on."""

PACKAGE = Path(omniproof.__file__).parent
LIGHT, DARK = "a11y-high-contrast-light", "a11y-high-contrast-dark"


def write_code(folder: Path) -> None:
    """Write a page for every file of derivations and drawings below `folder / "code"`."""
    for file in sorted(file for glob in SHOWN for file in PACKAGE.glob(glob)):
        name = file.relative_to(PACKAGE.parent).as_posix()
        page = folder / code_link(f"{name}:1").partition("#")[0]
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(_page(name, file.read_text(encoding="utf-8")), encoding="utf-8")


def code_link(source: str) -> str:
    """Return the link to a line: `omniproof/papers/a/b.py:7` is at `code/papers/a/b.html#L-7`."""
    file, _, line = source.rpartition(":")
    return f"{FOLDER}/{file.removeprefix('omniproof/').removesuffix('.py')}.html#L-{line}"


def _page(name: str, code: str) -> str:
    body = highlight(code, PythonLexer(), _formatter(LIGHT))
    up = "../" * code_link(f"{name}:1").count("/")
    chapter = Path(name).parts[2].replace("_", "-")
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{escape(name)}'
        '</title><meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<style>{_style()}</style><script>{_THEME}</script></head><body>"
        f'<nav aria-label="way back"><a href="{up}index.html">omniproof</a> › '
        f'<a href="{up}{chapter}.html">{chapter}</a></nav><main><h1>{escape(name)}</h1>'
        "<p>What mechanics gives for claims of this paper, as code: each function is bound to the "
        f"claims that it derives.</p>{body}</main></body></html>\n"
    )


def _formatter(style: str) -> HtmlFormatter[str]:
    # Each line is an element with an address, not a link: nothing of it is in the tab order.
    return HtmlFormatter(style=style, linespans="L")


def _style() -> str:
    """Return the style sheet of both modes; the line that a link leads to has a bar."""
    light, dark = (_formatter(name).get_style_defs(".highlight") for name in (LIGHT, DARK))
    dark = "".join(f"html[data-theme=dark] {rule}\n" for rule in dark.splitlines() if rule)
    return (
        f"{_FRAME}{light}\n{dark}pre{{line-height:1.45}}"
        "[id^=L-]{scroll-margin-top:30vh}[id^=L-]:target{box-shadow:-.5rem 0 0 currentcolor}"
    )


_FRAME = (
    "body{margin:0 auto;max-width:60rem;padding:1rem;font-family:-apple-system,'Segoe UI',Roboto,"
    "'Helvetica Neue',Arial,sans-serif;color:#222832;background:#fff}h1{font-size:1.3rem;"
    "overflow-wrap:anywhere}pre{white-space:pre-wrap;overflow-wrap:anywhere;font-size:.9rem}"
    "nav{position:sticky;top:0;padding:.4rem 0;background:inherit}"
    "a{color:#0a5fa8}html[data-theme=dark] body{color:#ced6dd;background:#14181e}"
    "html[data-theme=dark] a{color:#7fc4ff}"
)
_THEME = 'try{document.documentElement.dataset.theme=localStorage.getItem("theme")||"light"}catch{}'
"""The mode that was chosen in the book, before the first paint; light without storage."""
