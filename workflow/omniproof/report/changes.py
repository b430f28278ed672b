r"""What a correction changes: the differing parts of two formulas, marked in both and named.

Formulas are compared token by token. What differs grows until it is whole (brackets close, no
command loses its argument, no index its base), because only then can it be marked and set alone.
The mark is the macro `\changed` (see `omniproof.report.mathml`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from itertools import pairwise

from omniproof.report.latexfmt import is_latex, is_settable

LEAST_ALIKE = 0.6
"""Formulas with less in common are two formulas, and marking all of them says nothing."""

MOST = 3
"""With more changes than this a list of them is no help."""

_TOKEN = re.compile(r"\\(?:begin|end)\{\w+\*?\}|\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|[^\s]", re.DOTALL)
_TAKES_MORE = re.compile(
    r"[\^_&]|\\(?:[dt]?frac|binom|sqrt|left|right|text|operatorname|math\w+|boldsymbol|bm|begin.*"
    r"|(?:wide)?(?:tilde|hat)|dot|ddot|bar|vec|overline|underline)"
)
_CONTINUES = frozenset("^_&{}") | {"\\\\"}
_BINARY = frozenset({"+", "-", r"\cdot", r"\times", r"\pm", "*"})
_FUNCTION = re.compile(r"\\(?:arc)?(?:sin|cos|tan)")
_FRAME = re.compile(r"\\(?:left|right|begin|end)(?![a-z])|&|\\\\")

Run = tuple[int, int]


@dataclass(frozen=True)
class Changes:
    """Both formulas with their differing parts marked, and the parts: printed, corrected."""

    printed: str
    corrected: str
    parts: tuple[tuple[str, str], ...]


def changes(printed: str, corrected: str) -> Changes | None:
    """Return what differs, or None where marks would not help a reader."""
    if not all(is_latex(text) and is_settable(text) for text in (printed, corrected)):
        return None
    one, other = (_TOKEN.findall(text) for text in (printed, corrected))
    matcher = SequenceMatcher(a=one, b=other, autojunk=False)
    differing = [((a, b), (c, d)) for tag, a, b, c, d in matcher.get_opcodes() if tag != "equal"]
    if not 0 < len(differing) <= MOST or matcher.ratio() < LEAST_ALIKE:
        return None
    grown = [_whole(one, other, *runs) for runs in differing]
    old, new = [pair[0] for pair in grown], [pair[1] for pair in grown]
    if _overlap(old) or _overlap(new):
        return None
    parts = [(" ".join(one[a:b]), " ".join(other[c:d])) for (a, b), (c, d) in grown]
    return Changes(_marked(one, old), _marked(other, new), tuple(dict.fromkeys(parts)))


def _whole(one: Sequence[str], other: Sequence[str], old: Run, new: Run) -> tuple[Run, Run]:
    """Let a part grow on both sides alike, where it lacks something, until it can stand alone."""
    (a, b), (c, d) = old, new
    while not (_stands_alone(one, (a, b)) and _stands_alone(other, (c, d))):
        leftward = _belongs_to_the_left(one[a:b]) or _belongs_to_the_left(other[c:d])
        if b < len(one) and d < len(other) and not leftward:
            b, d = b + 1, d + 1
        elif a > 0 and c > 0:
            a, c = a - 1, c - 1
        else:
            return (0, len(one)), (0, len(other))
    return (a, b), (c, d)


def _overlap(runs: Sequence[Run]) -> bool:
    return any(first[1] > second[0] for first, second in pairwise(runs))


def _stands_alone(tokens: Sequence[str], run: Run) -> bool:
    start, end = run
    part = tokens[start:end]
    if not part:
        return True
    argument = start > 0 and part[0] == "{" and tokens[start - 1] not in "+-=()"
    return not (
        _closes_more(part)
        or part.count("{") != part.count("}")
        or _TAKES_MORE.fullmatch(part[-1])
        or any(_FRAME.match(token) for token in part)
        or part[0] in _CONTINUES - {"{"}
        or argument
    )


def _belongs_to_the_left(part: Sequence[str]) -> bool:
    return _closes_more(part) or part[:1] in (["^"], ["_"])


def _closes_more(part: Sequence[str]) -> bool:
    depth = 0
    for sign in part:
        depth += (sign == "{") - (sign == "}")
        if depth < 0:
            return True
    return False


def _marked(tokens: Sequence[str], runs: Sequence[Run]) -> str:
    return " ".join(_pieces(tokens, runs))


def _pieces(tokens: Sequence[str], runs: Sequence[Run]) -> Iterator[str]:
    end = 0
    for start, stop in runs:
        yield from tokens[end:start]
        if stop > start:
            yield _mark(tokens[start:stop])
        end = stop
    yield from tokens[end:]


def _mark(part: Sequence[str]) -> str:
    """Mark a part; an operator keeps the space around it."""
    text = " ".join(part)
    mark = rf"{{\changed{{{text}}}}}"
    if text in _BINARY:
        return rf"\mathbin{mark}"
    return rf"\mathop{mark}\nolimits" if _FUNCTION.fullmatch(text) else mark
