r"""What the ledger holds as Typst markup, for what is typeset without a TeX installation.

Formulas are laid out and written by the language (`formula.writers`); here they get into the text.
A formula that cannot be read is shown as code (`raw`): ugly, but visible, and never run.
"""

from __future__ import annotations

from collections.abc import Callable

from omniproof.formula.writers import difference, in_common, typst, words
from omniproof.formula.writers.boxes import Row
from omniproof.report.latexfmt import PIECE, is_latex, plain
from omniproof.report.shown import shown
from omniproof.transcription.model import ID


def math(latex: str) -> str:
    """Return Typst markup of a formula; of one that cannot be read, its LaTeX as code."""
    row = shown(latex)
    return _code(latex) if row is None else _equation(row, latex)


def is_formula(text: str) -> bool:
    """Whether a ledger cell is one formula that can be set."""
    return is_latex(text) and not ID.fullmatch(text) and bool(shown(text))


def contrasted(printed: str, corrected: str) -> tuple[str, str]:
    """Return Typst markup of two formulas, with what differs in `old(…)` and in `new(…)`.

    Formulas that share nothing, or cannot be set, are not marked.
    """
    one, other = shown(printed), shown(corrected)
    if one is None or other is None or not in_common(one, other):
        return math(printed), math(corrected)
    found = difference(one, other)
    return _equation(found.one, printed), _equation(found.other, corrected)


def _equation(row: Row, latex: str) -> str:
    """Return an equation with its text for those who hear it (PDF/UA asks for one)."""
    return f"#math.equation(alt: {words(plain(latex))}, ${typst(row)}$);"


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
