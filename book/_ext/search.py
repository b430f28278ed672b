"""The search of the report, in place of Sphinx': it finds claims, numbers and words of formulas.

Sphinx indexes running text, a page a hit. What readers look for here stands in claims, and has an
address of its own. The claims come from the ledger (`omniproof.report.search_index`); sections,
theorems and figures are read here, from the pages.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from html import unescape
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx_proof.nodes import theorem_node

from omniproof.report.latexfmt import plain
from omniproof.report.search_index import places_script

PAGE, INDEX = "search", "search-places.js"
SCRIPTS = ("search-claims.js", INDEX, "search-words.js", "search-rank.js", "search.js")
EXCERPT = 110
"""Letters of a section that are kept, to be found and shown: a line or two."""

_FIGURE = re.compile(
    r'<figure class="drawn" id="([\w-]+)">.*?<figcaption>(.*?)</figcaption>', re.DOTALL
)
_TAG = re.compile(r"<[^>]+>|\\[()]")

Place = tuple[str, str, str, str]


def replace_search(app: Sphinx) -> None:
    """Keep Sphinx from indexing the pages."""
    if app.builder.format == "html":
        app.builder.search = False  # type: ignore[attr-defined]


def pages(app: Sphinx) -> Iterator[tuple[str, dict[str, Any], str]]:
    """Give the page of the search, and write what it looks through beside the claims."""
    found = [place for name in sorted(app.env.found_docs) for place in _places(app, name)]
    # Jupyter Book asks on every page for each script that lies in `_static` of the sources.
    static = Path(app.outdir) / "_static"
    shutil.copytree(Path(app.srcdir) / "_search", static, dirs_exist_ok=True)
    (static / INDEX).write_text(places_script(found), encoding="utf-8")
    yield PAGE, {"title": "Search"}, "search.html"


def _places(app: Sphinx, name: str) -> Iterator[Place]:
    """Yield sections, theorems and figures of one page: kind, address, title and text."""
    tree = app.env.get_doctree(name)
    for section in tree.findall(nodes.section):
        title = section.next_node(nodes.title)
        if title is not None:
            below = [child for child in section.children if isinstance(child, nodes.paragraph)]
            yield "section", f"{name}.html#{section['ids'][0]}", _text(title), _opening(below)
    for theorem in tree.findall(theorem_node):
        statement = _opening(theorem.children[1:])
        yield "theorem", f"{name}.html#{theorem['label']}", _bare(theorem["title"]), statement
    for raw in tree.findall(nodes.raw):
        for address, caption in _FIGURE.findall(raw.astext()):
            title, _, text = _bare(caption).partition(". ")
            yield "figure", f"{name}.html#{address}", title, text[:EXCERPT]


def _opening(parts: list[Any]) -> str:
    return " ".join(map(_text, parts))[:EXCERPT]


def _text(node: nodes.Node | None) -> str:
    return _bare(node.astext()) if node is not None else ""


def _bare(text: str) -> str:
    """Return text without markup, formulas as they are typed."""
    return plain(unescape(_TAG.sub("", text)))


def ask_for_index(
    app: Sphinx, page: str, template: str, context: dict[str, Any], tree: Any
) -> None:
    """Load index and ranking on the one page that searches."""
    if page == PAGE:
        for script in SCRIPTS:
            app.add_js_file(script, loading_method="defer")
        app.add_css_file("search.css")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("builder-inited", replace_search)
    app.connect("html-collect-pages", pages)
    app.connect("html-page-context", ask_for_index)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
