"""Make the report readable from disk: nothing from a network, formulas left for later.

A formula stays LaTeX in Sphinx, as the formulas of claims do, which Sphinx cannot see; all of them
are set when the pages are finished (`omniproof.report.finish`).
"""

from __future__ import annotations

import re
from typing import Any

from sphinx.application import Sphinx
from sphinx.ext.mathjax import html_visit_displaymath, html_visit_math


def drop_thebe(app: Sphinx, page: str, template: str, context: dict[str, Any], tree: Any) -> None:
    """Take sphinx-thebe's scripts off the page: always on in Jupyter Book 1, and from a CDN."""
    files = context.get("script_files")
    if files:
        files[:] = [file for file in files if not _is_thebe(file)]


def _is_thebe(file: Any) -> bool:
    body = dict(getattr(file, "attributes", {})).get("body") or ""
    return "sphinx-thebe" in str(getattr(file, "filename", file)) or "THEBE_JS_URL" in str(body)


def mend_roles(app: Sphinx, page: str, template: str, context: dict[str, Any], tree: Any) -> None:
    """Take roles off the bibliography: docutils promises a list there and puts no items into it."""
    if 'class="citation-list"' in context.get("body", ""):
        context["body"] = re.sub(r' role="(?:list|doc-biblioentry)"', "", context["body"])


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.add_html_math_renderer("later", (html_visit_math, None), (html_visit_displaymath, None))
    app.connect("html-page-context", drop_thebe, priority=900)
    app.connect("html-page-context", mend_roles)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
