r"""Two long formulas that differ in one place, cut down to that place.

A formula of three lines in a list says nothing: nobody finds the sign in it. What both sides share
is replaced by dots, down to pieces that LaTeX can set and that break no unit apart, such as a base
and its exponent or a command and its arguments.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from omniproof.report.latexfmt import is_settable

LONG = 60
"""Characters of LaTeX that one line of running text holds; shorter formulas stay whole."""

_TOKEN = re.compile(r"(?:\\(?:begin|end)\{\w+\*?\}|\\[A-Za-z]+|\\.|.)\s*", re.DOTALL)
_OPENS = re.compile(
    r"[\^_&]|\\(?:[dt]?frac|sqrt|left|right|text|operatorname|math\w+|tilde|dot|hat)"
)
_CONTINUES = frozenset("^_{}&")


def differing(printed: str, correct: str) -> tuple[str, str]:
    r"""Return both formulas, with `\dots` for what they share if one is long; else unchanged."""
    if max(len(printed), len(correct)) <= LONG:
        return printed, correct
    sides = tuple(_TOKEN.findall(text.strip()) for text in (printed, correct))
    for before, after in _cuts(*_shared(*sides), *sides):
        windows = tuple(side[before : len(side) - after] for side in sides)
        if all(is_settable("".join(window)) for window in windows):
            return _dotted(windows[0], before, after), _dotted(windows[1], before, after)
    return printed, correct


def _shared(one: Sequence[str], other: Sequence[str]) -> tuple[int, int]:
    """Return how many tokens are alike at the beginning, and of the rest how many at the end."""
    bare = [[token.strip() for token in side] for side in (one, other)]
    start = _alike(*bare)
    return start, _alike(*(side[start:][::-1] for side in bare))


def _alike(one: Sequence[str], other: Sequence[str]) -> int:
    pairs = enumerate(zip(one, other, strict=False))
    return next((k for k, (a, b) in pairs if a != b), min(len(one), len(other)))


def _cuts(
    before: int, after: int, one: Sequence[str], other: Sequence[str]
) -> Iterator[tuple[int, int]]:
    """Give what may be cut off in front and behind, most first, one unit of context staying."""
    starts = [k for k in range(before + 1) if k == 0 or (k < before and _parted(one, k))]
    ends = [k for k in range(after + 1) if k == 0 or (k < after and _parted(one, len(one) - k))]
    pairs = [(start, end) for start in starts for end in ends]
    fits = (p for p in pairs if _parted(other, p[0]) and _parted(other, len(other) - p[1]))
    yield from sorted(fits, key=sum, reverse=True)


def _parted(tokens: Sequence[str], place: int) -> bool:
    """Whether no unit of the formula reaches across this place."""
    if not 0 < place < len(tokens):
        return True
    last, following = tokens[place - 1].strip(), tokens[place].strip()
    return not _OPENS.fullmatch(last) and following not in _CONTINUES and last != "{"


def _dotted(window: Sequence[str], before: int, after: int) -> str:
    parts = [r"\dots" if before else "", "".join(window).strip(), r"\dots" if after else ""]
    return " ".join(part for part in parts if part)
