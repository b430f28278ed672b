"""The derivations as pages that a card can link to, line by line: a verdict rests on this code.

A browser does not open a `.py` file at a line, and not from disk at all. So each file of
derivations becomes one page without scripts, in the colours of the report.
"""

from __future__ import annotations

from html import escape
from pathlib import Path

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import PythonLexer

import omniproof

FOLDER = "code"
SHOWN = (
    "papers/*/derivations/[!_]*.py", "papers/*/figures/[!_]*.py", "report/architecture_figures.py",
)  # fmt: skip
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
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{escape(name)}'
        '</title><meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<style>{_style()}</style></head><body><main><h1>{escape(name)}</h1>"
        f'<p><a href="{up}index.html">omniproof</a></p>{body}</main></body></html>\n'
    )


def _formatter(style: str) -> HtmlFormatter[str]:
    return HtmlFormatter(style=style, lineanchors="L", linespans="line", anchorlinenos=True)


def _style() -> str:
    """Return the style sheet of both modes; the line that a link leads to has a bar."""
    light, dark = (_formatter(name).get_style_defs(".highlight") for name in (LIGHT, DARK))
    return (
        ":root{color-scheme:light dark}body{margin:0 auto;max-width:60rem;padding:1rem;"
        "font-family:sans-serif}h1{font-size:1.2rem;overflow-wrap:anywhere}"
        "pre{overflow-x:auto;line-height:1.4}span:has(>a:target){border-left:3px solid;"
        f"padding-left:.4rem}}{light}@media (prefers-color-scheme:dark){{{dark}}}"
    )
