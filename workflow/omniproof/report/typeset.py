r"""What the ledger holds as Typst markup, for what is typeset without a TeX installation.

A formula that the language reads is laid out and written by its writers. What it refuses is set as
the formulas in the report's prose are (`typstmath`); what that cannot set, either, is shown as code
(`raw`): ugly, but visible, and never run.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from omniproof.formula.writers import difference, in_common, text, typst, words
from omniproof.formula.writers.difference import SMALL
from omniproof.report.latexfmt import PIECE, is_latex, plain
from omniproof.report.shown import shown
from omniproof.report.typstmath import UnsettableError, read, source
from omniproof.transcription.model import ID

WHOLE = SMALL | {"fraction"}
"""In a fraction, marks would grow out of the line."""


def math(latex: str) -> str:
    """Return Typst markup of a formula; of one that cannot be set, its LaTeX as code."""
    row = shown(latex)
    try:
        return _equation(source(read(latex)) if row is None else typst(row), latex)
    except UnsettableError:
        return _code(latex)


def is_formula(text: str) -> bool:
    """Whether a ledger cell is one formula that can be set."""
    return is_latex(text) and not ID.fullmatch(text) and bool(shown(text))


def contrasted(printed: str, corrected: str) -> tuple[str, str]:
    """Return Typst markup of two formulas, with what differs in `old(…)` and in `new(…)`.

    Formulas that share nothing, or cannot be read, are not marked.
    """
    one, other = shown(printed), shown(corrected)
    if one is None or other is None or not in_common(one, other, WHOLE):
        return math(printed), math(corrected)
    found = difference(one, other, WHOLE)
    return _equation(typst(found.one), printed), _equation(typst(found.other), corrected)


def _equation(markup: str, latex: str) -> str:
    """Return an equation with its text for those who hear it (PDF/UA asks for one)."""
    return f"#math.equation(alt: {words(spoken(latex))}, ${markup}$);"


def spoken(cell: str) -> str:
    r"""Return a formula, or words with `$math$` in them, as text: `\sin\alpha_1` gives `sin α₁`."""
    row = shown(cell) if is_latex(cell) else None
    if row is not None:
        return text(row)
    if "$" not in cell:
        return plain(cell)
    return plain(_MATH.sub(lambda found: spoken(found[1]), cell))


_MATH = re.compile(r"\$([^$]+)\$")


def inline(text: str, refer: Callable[[str], str]) -> str:
    """Return Typst markup of words with `$math$`, `code` and claim ids (markup by `refer`)."""
    parts: list[str] = []
    end = 0
    for piece in PIECE.finditer(text):
        latex, code, claim = piece.groups()
        parts += [_spaced(text[end : piece.start()])]
        parts += [math(latex) if latex else _code(code) if code else refer(claim)]
        end = piece.end()
    return "".join([*parts, _spaced(text[end:])])


def cell(text: str, refer: Callable[[str], str]) -> str:
    """Return Typst markup of a ledger cell: a formula, a decimal, or words (see `inline`)."""
    if ID.fullmatch(text) or not (is_latex(text) or ("\\" in text and "$" not in text)):
        return inline(text, refer)
    return math(text)


def _spaced(text: str) -> str:
    """Return words as string literals, with blank space at the ends kept as markup."""
    if not text.strip():
        return " " if text else ""
    left, right = (" " if text[k].isspace() else "" for k in (0, -1))
    return f"{left}#{words(text)};{right}"


def _code(text: str) -> str:
    return f"#raw({words(text)});"
