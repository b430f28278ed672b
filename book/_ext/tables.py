"""Give the list of findings a library that sorts and filters: DataTables, as itables brings it.

The bundle is an ES module, which a browser does not load from disk (`file://`). Its one export
statement is turned into a global, and the file is asked for by the one page that needs it.
"""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

PAGE = "findings"
FILE = "datatables.js"
_EXPORT = re.compile(r"\bexport\{(?P<names>[^{}]*)\};?")
_DEFAULT = re.compile(r"(?:^|,)(?P<local>[\w$]+) as default(?:,|$)")


def as_script(module: str) -> str:
    """Return the bundle as a classic script that defines `DataTable`.

    Raises `ValueError` when it does not end in one export of a default, as it does now.
    """
    exports = list(_EXPORT.finditer(module))
    default = _DEFAULT.search(exports[-1]["names"]) if exports else None
    if default is None:
        raise ValueError("itables' bundle has no default export: see book/_ext/tables.py")
    begin, end = exports[-1].span()
    body = f"{module[:begin]}window.DataTable={default['local']};{module[end:]}"
    return f"(()=>{{{body}\n}})();\n"


def bundle() -> str:
    """Return DataTables with its extensions, as an ES module."""
    package = importlib.util.find_spec("itables")
    if package is None or package.origin is None:
        raise ModuleNotFoundError("itables is not installed: run `make`")
    return (Path(package.origin).parent / "html" / "dt_bundle.js").read_text(encoding="utf-8")


def ask_for_library(
    app: Sphinx, page: str, template: str, context: dict[str, Any], tree: Any
) -> None:
    """Load the library on the one page with a long list."""
    if page == PAGE:
        app.add_js_file(FILE, loading_method="defer")
        app.add_js_file("findings.js", loading_method="defer")


def write_library(app: Sphinx, failure: Exception | None) -> None:
    """Write the library beside the pages."""
    if failure is None and app.builder.format == "html":
        path = Path(app.outdir) / "_static" / FILE
        path.write_text(as_script(bundle()), encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("html-page-context", ask_for_library)
    app.connect("build-finished", write_library)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
