r"""What a correction changes: the differing parts of two formulas, marked in both and named.

The mark is the macro `\changed`, which the book defines for MathJax (`book/_config.yml`).
"""

from __future__ import annotations

from dataclasses import dataclass
from difflib import SequenceMatcher

from omniproof.formula.writers import difference, display, in_common
from omniproof.formula.writers.boxes import Row, walk
from omniproof.report.latexfmt import is_latex
from omniproof.report.shown import shown

LEAST_ALIKE = 0.4
"""Formulas with less in common are two formulas, and marking all of them says nothing."""

MOST = 3
"""With more changes than this a list of them is no help."""


@dataclass(frozen=True)
class Changes:
    """Both formulas with their differing parts marked, and the parts: printed, corrected."""

    printed: str
    corrected: str
    parts: tuple[tuple[str, str], ...]


def changes(printed: str, corrected: str) -> Changes | None:
    """Return what differs, or None where marks would not help a reader."""
    one, other = (shown(text) if is_latex(text) else None for text in (printed, corrected))
    if one is None or other is None or not in_common(one, other):
        return None
    found = difference(one, other)
    if not 0 < len(found.pairs) <= MOST or _likeness(one, other) < LEAST_ALIKE:
        return None
    parts = tuple((display(old), display(new)) for old, new in found.pairs)
    return Changes(display(found.one), display(found.other), parts)


def _likeness(one: Row, other: Row) -> float:
    """The part of the boxes that two formulas share."""
    left, right = ([(box.kind, box.text) for box in walk(row)] for row in (one, other))
    return SequenceMatcher(a=left, b=right, autojunk=False).ratio()
