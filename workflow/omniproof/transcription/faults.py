"""Faults of data: what is wrong, where, and what to write instead.

Bad data is never a traceback: every check returns or collects `Fault`s, and all faults of one
folder are reported together, in file order.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from difflib import get_close_matches

from omniproof.visible import one_line

SHOWN = 50
"""So many faults are printed in full; a file with more is broken in one place, many times."""


@dataclass(frozen=True, order=True)
class Fault:
    """One fault at one place of a data file; lines and columns count from 1."""

    file: str
    line: int
    column: int
    path: str
    message: str
    cure: str = ""

    def __str__(self) -> str:
        """Write `file:line:column: path: message`, and the cure on a line of its own."""
        place = f"{one_line(self.file)}:{self.line}:{self.column}: "
        path = f"{one_line(self.path)}: " if self.path else ""
        cure = f"\n    {self.cure}" if self.cure else ""
        return f"{place}{path}{self.message}{cure}"


class BadInput(Exception):  # noqa: N818 - it reports data, it is no failure of the program
    """Data that cannot be audited, with all its faults in file order."""

    def __init__(self, faults: Iterable[Fault]) -> None:
        self.faults = tuple(sorted(set(faults)))
        super().__init__(report(self.faults))


def report(faults: tuple[Fault, ...]) -> str:
    """Print the faults below each other, with a count at the end."""
    lines = [str(fault) for fault in faults[:SHOWN]]
    if len(faults) > SHOWN:
        lines.append(f"and {len(faults) - SHOWN} more")
    files = sorted({fault.file for fault in faults})
    word = "fault" if len(faults) == 1 else "faults"
    lines.append(f"{len(faults)} {word} in {', '.join(files)}")
    return "\n".join(lines)


def shorten(text: str, limit: int = 60) -> str:
    """Cut a long value for a message; line breaks and control characters become visible."""
    shown = repr(text if len(text) <= limit else text[: limit - 1] + "…")
    return shown if len(text) <= limit else f"{shown} ({len(text)} characters)"


def nearest(word: str, known: Iterable[str], otherwise: str = "") -> str:
    """The cure "did you mean …?" for a word that is almost a known one."""
    near = get_close_matches(word[:80], list(known), n=1)
    return f"did you mean `{near[0]}`?" if near else otherwise
