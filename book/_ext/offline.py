"""Make the report readable from disk: MathJax from the book itself, nothing from a network.

One file, `tex-svg-full.js`: it needs no fonts and loads no further part (the smaller bundles fetch
extensions on demand, and a missing one costs the mathematics of a whole page).
"""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.util.fileutil import copy_asset_file

BUNDLE = "tex-svg-full.js"
PACKAGE = "sphinx-mathjax-offline"


def use_bundle(app: Sphinx, config: Config) -> None:
    """Point Sphinx to the bundle, on every page: claims hold formulas that Sphinx cannot see."""
    config.mathjax_path = f"mathjax/{BUNDLE}"
    app.set_html_assets_policy("always")


def copy_bundle(app: Sphinx, failure: Exception | None) -> None:
    """Copy the bundle beside the pages."""
    if failure is not None or app.builder.format != "html":
        return
    package = importlib.util.find_spec(PACKAGE)
    if package is None or package.origin is None:
        raise ModuleNotFoundError(f"{PACKAGE} is not installed: run `make`")
    source = Path(package.origin).parent / "static" / "mathjax" / BUNDLE
    target = Path(app.outdir) / "_static" / "mathjax"
    target.mkdir(parents=True, exist_ok=True)
    copy_asset_file(source, target)


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
    app.connect("config-inited", use_bundle)
    app.connect("html-page-context", drop_thebe, priority=900)
    app.connect("html-page-context", mend_roles)
    app.connect("build-finished", copy_bundle)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
