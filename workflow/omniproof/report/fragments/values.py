"""Numbers in running text: computed in a cell, named, and set into the prose by that name.

A value is stored the way the book's `glue` role expects it, without importing the book's machinery
into every notebook.
"""

from __future__ import annotations

from dataclasses import dataclass
from html import escape

from IPython.display import display

_PREFIX = "application/papermill.record/"


@dataclass(frozen=True)
class Value:
    """One inline value as finished HTML."""

    html: str


def in_text(**values: Value | int | str) -> None:
    """Name values for the prose: `in_text(claims=161)` and then ``{glue:}`claims` `` in the text.

    Numbers and strings are escaped. Each is marked, so that a reader (and a test) can tell that it
    was computed. The cell itself should have the tag `remove-cell`.
    """
    for name, value in values.items():
        html = value.html if isinstance(value, Value) else escape(str(value))
        display(  # type: ignore[no-untyped-call]
            {_PREFIX + "text/html": f'<span class="value">{html}</span>'},
            raw=True,
            metadata={"scrapbook": {"name": name, "mime_prefix": _PREFIX}},
        )
