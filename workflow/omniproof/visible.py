r"""Text that shows what is in it: no character of an input acts on a terminal, or hides there.

Escape sequences (C0, C1) move the cursor and rename the window, marks of direction let a line read
otherwise than it is, tags and zero widths hide words. All are written as Python writes them:
`\x1b`, `\u202e`. Whatever a command prints goes through `visible` or, as JSON, `visible_json`.
"""

from __future__ import annotations

import re
import unicodedata

NO_GLYPH = frozenset({"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"})
"""Categories without a glyph: controls, formats (marks of direction, tags, zero width), lone
surrogates, private use, unassigned, separators of lines and paragraphs."""
_IGNORED = re.compile(
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u2800\u3164\ufe00-\ufe0f\uffa0"
    "\U000e0000-\U000e0fff]"
)
"""Letters and marks that are drawn as nothing (Default_Ignorable_Code_Point, and blank Braille)."""
_ACTING = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff"
    "\U000e0000-\U000e007f]"
)
"""What no text of a paper needs: controls, marks of direction, separators, halves of characters,
tags. (Others without a glyph belong to the words of some scripts, or to damaged fonts.)"""
_CANDIDATE = re.compile(r"[^ -~]")


def visible(text: str, layout: str = "\n\t") -> str:
    """Escape every character of a text that has no glyph, except those of its own layout."""

    def shown(match: re.Match[str]) -> str:
        found = match[0]
        if found in layout or not hidden(found):
            return found
        return found.encode("unicode_escape").decode("ascii")

    return _CANDIDATE.sub(shown, text)


def one_line(text: str) -> str:
    """Escape every character without a glyph, line breaks too: a file's name, a key."""
    return visible(text, layout="")


def visible_json(text: str) -> str:
    """Escape the same characters in a JSON text as JSON does, so that it stays what it says."""

    def shown(match: re.Match[str]) -> str:
        found = match[0]
        if found == "\n" or not hidden(found):
            return found
        units = found.encode("utf-16-be", "surrogatepass").hex()
        return "".join(f"\\u{units[k : k + 4]}" for k in range(0, len(units), 4))

    return _CANDIDATE.sub(shown, text)


def acting(text: str) -> str:
    """Return the first character that acts on what is shown around it, or nothing."""
    found = _ACTING.search(text)
    return found[0] if found else ""


def hidden(character: str) -> bool:
    """Whether a character draws nothing, or acts on what is drawn."""
    return unicodedata.category(character) in NO_GLYPH or bool(_IGNORED.match(character))
