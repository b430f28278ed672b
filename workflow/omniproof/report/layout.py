"""How anything is laid out on a terminal: a head, then named details, wrapped to its width.

Lines break at blanks only: a LaTeX command that is cut in two could not be copied.
"""

from __future__ import annotations

import shutil
from textwrap import wrap

INDENT = "    "
LABEL = 10
NARROWEST, WIDEST = 40, 120


def terminal_width() -> int:
    """Columns of this terminal; 100 where there is none."""
    return shutil.get_terminal_size((100, 24)).columns


def head(opening: str, text: str, width: int) -> list[str]:
    """Write an opening word or two and a text, further lines indented."""
    return _wrapped(text, f"{opening}  ", INDENT, width)


def detail(name: str, text: str, width: int) -> list[str]:
    """Write a named detail below a head; nothing for an empty text."""
    return _wrapped(text, f"{INDENT}{name:<{LABEL}}", INDENT + " " * LABEL, width) if text else []


def _wrapped(text: str, first: str, others: str, width: int) -> list[str]:
    return wrap(
        " ".join(text.split()),
        max(NARROWEST, min(width, WIDEST)),
        initial_indent=first,
        subsequent_indent=others,
        break_long_words=False,
        break_on_hyphens=False,
    )
