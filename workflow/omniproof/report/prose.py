r"""Numbers that were typed into the prose of a page, where a program could have computed them.

A typed number goes stale without a sound. In the prose (not in code, formulas, or what a cell of a
notebook made) a number is either computed, and marked as such by `in_text`, or it is a choice and
no result, marked `[30°]{.given}`. Labels are no numbers: Eq. (5-1), Tables 3 and 4, [9].
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

ARTICLE = "bd-article"
"""Class that the theme gives to what a page says, without its frame."""

_VOID = frozenset({"br", "col", "hr", "img", "input", "link", "meta", "source", "wbr"})
_APART = frozenset({"script", "style", "pre", "code", "svg", "a", "nav", "footer"})
_MARKED = frozenset({"value", "given", "math", "eqno", "cell", "citation", "citation-list"})
_LABEL = re.compile(
    r"\b(?:Eqs?\.|Equations?|Tables?|Figures?|Sections?|Appendix|Simulation|Part)"
    r"\s*\(?[A-Z]?[\d.-]+[a-z]?\)?(?:\s*(?:,|–|to|and|or|, and)\s*\(?[\d.-]+[a-z]?\)?)*"
    r"|\([A-Z]?[,.]?\d+(?:-\d+)?\)|\[\d+\]"
)
_NAME = re.compile(r"[A-Za-z]+[-_]?\d+\w*|\b\dD\b")
_NUMBER = re.compile(r"\d[\d.,/]*(?:\d|°|\s?%)?°?")


class Prose:
    """Collects the prose of the article of one page while its tags go by."""

    def __init__(self) -> None:
        self._inside: list[tuple[str, bool]] = []
        self._parts: list[str] = []

    def enter(self, tag: str, found: Mapping[str, str]) -> None:
        """Note that an element begins."""
        self._parts.append(" " if tag in _VOID else "")
        classes = set(found.get("class", "").split())
        if ARTICLE in classes or (self._inside and tag not in _VOID):
            marked = bool(_MARKED & classes)
            self._inside.append((tag, tag in _APART or marked))

    def leave(self, tag: str) -> None:
        """Note that an element ends, and what it left open with it."""
        if any(name == tag for name, _ in self._inside):
            while self._inside.pop()[0] != tag:
                pass

    def add(self, text: str) -> None:
        """Note text; what stands in an element that is marked or set apart becomes a dash."""
        if self._inside:
            self._parts.append("–" if any(apart for _, apart in self._inside) else text)

    def typed_numbers(self) -> Iterator[str]:
        """Give each number of the prose that is neither marked nor part of a label or name."""
        yield from numbers_in("".join(self._parts))


def numbers_in(text: str) -> Iterator[str]:
    """Give each number of a plain text that is no part of a label or name, once."""
    text = " ".join(text.split())
    for pattern in (_LABEL, _NAME):
        text = pattern.sub(" ", text)
    yield from dict.fromkeys(_NUMBER.findall(text))
