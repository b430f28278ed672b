r"""Formulas as they are printed, read to be shown: on paper, on a terminal, aloud.

For showing a formula it does not matter what its symbols mean, or how far a slash or an argument
without brackets reaches: it is laid out as it is printed. So no list of symbols is needed here. In
a cell of the ledger formulas stand among words, `\text{…}`; each is read by itself. What the reader
refuses is shown as its LaTeX, by whoever shows it.
"""

from __future__ import annotations

import re
from functools import lru_cache

from omniproof.formula.writers.boxes import Box, Row, layout
from omniproof.transcription.conventions import Conventions, Names
from omniproof.transcription.functions import WORDS
from omniproof.transcription.reader import Reader
from omniproof.transcription.tokens import LatexError

_ANY = Names(alone=True, shown=True)
_SLASH = Conventions(slash="first")
_BETWEEN = re.compile(
    r"(\\(?:text|mbox|textrm)\s*\{[^{}]*\}(?:\s*\^\{?\d\}?)?"
    rf"|\\operatorname\s*\{{(?!(?:{'|'.join(WORDS)})\}})\w+\}}"
    r"|\\in(?![A-Za-z])|∈|\^\{?\\perp\}?)"
)
"""Words, functions that are not read, signs of sets."""


@lru_cache(maxsize=4_096)
def shown(latex: str) -> Row | None:
    """Lay out a formula, or formulas among words; `None` for what the reader refuses."""
    try:
        return sum((_piece(piece) for piece in _BETWEEN.split(latex)), ())
    except LatexError:
        return None


def _piece(latex: str) -> Row:
    if _BETWEEN.fullmatch(latex):
        return _between(latex)
    stripped = latex.strip(" ,;.")
    if not stripped:
        return tuple(Box("sign", ",") for sign in latex if sign == ",")
    start = tuple(Box("sign", ",") for _ in range(latex.lstrip().startswith(",")))
    end = tuple(Box("sign", ",") for _ in range(latex.rstrip().endswith(",")))
    node = Reader(stripped, _ANY, _SLASH, {}).document()
    return (*start, *layout(node, stripped), *end)


def _between(latex: str) -> Row:
    base, _, above = (part.strip() for part in latex.partition("^"))
    word: Row = ()
    if base:
        word = (Box("word", base) if "{" in base else Box("sign", "\\in"),)
    above = above.strip("{}")
    return (Box("scripts", parts=(word, (), (Box("letter", above),))),) if above else word
