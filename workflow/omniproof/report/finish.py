"""Finish the pages that Sphinx wrote: set their formulas, take off what the theme brings unused.

A page is then readable at once, without a script, and asks for nothing that it does not use.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterable, Iterator, Sequence
from html import unescape
from itertools import chain
from pathlib import Path

from omniproof.report.fragments.rows import FOLDER, details_text, read_details
from omniproof.report.latexfmt import TAG
from omniproof.report.mathfont import font_face
from omniproof.report.mathml import Formula, mathml
from omniproof.report.stylesheets import used_rules

FONT = "mathfont.css"

_FORMULA = re.compile(
    r'(?P<open><(?P<tag>span|div) class="(?:output text_latex )?math [^>]*>'
    r'\s*(?:<span class="eqno">.*?</span>)?)\s*'
    r"\\(?P<kind>[\[(])(?P<latex>.*?)\\[\])]\s*(?=</(?P=tag)>)",
    re.DOTALL,
)
_SIGNS = re.compile(r"<math.*?</math>", re.DOTALL)
_TAG = re.compile(r"<[^>]*>")
_CLASSES = re.compile(r'\bclass="([^"]*)"')
_WORD = re.compile(r"[\w-]+")
_SEARCH_PAGE = "search.html"
_OF_SEARCH = re.compile(r'\s*<(?:script[^>]*src|link[^>]*href)="_static/search[^>]*>(?:</script>)?')
_UNUSED_PARTS = re.compile(
    r'\s*<script[^>]*src="_static/(?:scripts/fontawesome|design-tabs|togglebutton)\.js[^>]*></script>'
    r'|\s*<link[^>]*href="_static/(?:sphinx-thebe|togglebutton|sphinx-design\.min)\.css[^>]*>'
    r"|\s*<script>(?:let toggle|var togglebutton)[^<]*</script>"
)
"""Icons as a script, and extensions of Jupyter Book that no page uses."""

_USED_BY = {
    r"(?:rows|claims|project)\.js": '<div class="rows"',
    r"cite\.js": '<div class="rows"|class="copies"',
    r"answers\.js": '<div class="answers"',
    r"findings\.js": '<table class="audit findings',
    r"filters\.js": '<div class="rows"|<table class="audit findings',
    r"(?:clipboard\.min|copybutton)\.js": "<pre>",
}
"""Scripts, and what a page has in it that they work on."""

_UNUSED_FILES = (
    "scripts/*.map", "styles/*.map", "scripts/fontawesome*", "vendor/fontawesome", "locales",
    "design-tabs.js", "togglebutton.*", "sphinx-thebe.*", "sphinx-design.min.css",
    "webpack-macros.html", "sbt-webpack-macros.html", "*.png", "check-solid.svg", "play-solid.svg",
)  # fmt: skip


def finish(html: Path) -> None:
    """Finish all pages in the folder `html`, and what lies beside them."""
    pages = {path: _lightened(path) for path in sorted(html.glob("*.html"))}
    details = {
        path: read_details(path.read_text(encoding="utf-8"))
        for path in sorted((html / FOLDER).glob("*.js"))
    }
    texts = set_formulas([*pages.values(), *chain(*(rows.values() for rows in details.values()))])
    done = iter(texts)
    for path in pages:
        path.write_text(next(done), encoding="utf-8")
    for path, rows in details.items():
        set_ = dict(zip(rows, done, strict=False))
        path.write_text(details_text(path.stem, set_), encoding="utf-8")
    _lighten(html / "_static", texts)


def _lighten(static: Path, texts: Sequence[str]) -> None:
    """Write the font, and take off what the theme brings unused."""
    (static / FONT).write_text(font_face(_signs(texts)), encoding="utf-8")
    for path in {file for pattern in _UNUSED_FILES for file in static.glob(pattern)}:
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    classes = set(_classes(texts, static))
    for path in static.rglob("*.css"):
        path.write_text(used_rules(path.read_text(encoding="utf-8"), classes), encoding="utf-8")


def _classes(texts: Iterable[str], static: Path) -> Iterator[str]:
    """Yield the classes of all elements, and every word of a script, which may make elements."""
    for text in texts:
        for names in _CLASSES.findall(text):
            yield from names.split()
    for script in static.rglob("*.js"):
        yield from _WORD.findall(script.read_text(encoding="utf-8"))


def set_formulas(texts: Iterable[str]) -> list[str]:
    r"""Return HTML with MathML for each `\(…\)` and `\[…\]` in an element of class `math`."""
    pages = list(texts)
    formulas = mathml(_formula(found) for text in pages for found in _FORMULA.finditer(text))
    return [_FORMULA.sub(lambda found: found["open"] + formulas[_formula(found)], t) for t in pages]


def _formula(found: re.Match[str]) -> Formula:
    return Formula(TAG.sub("", unescape(found["latex"])).strip(), found["kind"] == "[")


def _signs(texts: Iterable[str]) -> set[str]:
    """Return the characters of all formulas."""
    shown = (_TAG.sub("", math) for text in texts for math in _SIGNS.findall(text))
    return set().union(*map(unescape, shown))


def _lightened(page: Path) -> str:
    """Return a page without the scripts that it does not use."""
    text = _UNUSED_PARTS.sub("", page.read_text(encoding="utf-8"))
    text = text if page.name == _SEARCH_PAGE else _OF_SEARCH.sub("", text)
    for script, mark in _USED_BY.items():
        if not re.search(mark, text):
            text = re.sub(rf'\s*<script[^>]*src="_static/{script}[^>]*></script>', "", text)
    return text
