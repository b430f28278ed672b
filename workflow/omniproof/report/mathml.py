"""Formulas as MathML, set when the book is built: there at once, without a script.

Typst, which typesets the corrigenda too, writes it: `typstmath` reads the LaTeX, so nothing foreign
becomes code here either. All formulas of a book are one document, for a start of Typst costs more
than a thousand formulas. What browsers lack (a box, an underline) is an `mrow` of a class.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape

import typst

from omniproof.report.typstmath import UnsettableError, read, source

WIDE = 20.0
"""Width in em past which a formula says how wide it is: a narrow place can set it smaller."""

_PREAMBLE = """\
#let marked(kind, body) = html.elem("mrow", attrs: (class: kind), body)
#let changed(body) = marked("changed", $body$)
#let boxed(body) = marked("boxed", $body$)
#let overline(body) = marked("overline", $body$)
#let aligned(..rows) = marked("aligned", math.mat(delim: none, ..rows))
"""
_MEASURED = """\
#let changed(body) = body
#let boxed(body) = body
#let aligned(..rows) = math.mat(delim: none, ..rows)
"""
_MATH = re.compile(r"<math.*?</math>", re.DOTALL)
_ACCENTS = str.maketrans("\u0302\u0303\u0304\u0307\u0308", "\u02c6\u02dc\u00af\u02d9\u00a8")
"""Browsers set a combining accent over nothing, left of its letter."""


@dataclass(frozen=True)
class Formula:
    """LaTeX, and whether it stands in a line of its own, in the large style."""

    latex: str
    display: bool = False


def mathml(formulas: Iterable[Formula]) -> dict[Formula, str]:
    """Return the MathML of formulas; of one that cannot be set, its LaTeX as code.

    Raises `typst.TypstError` when Typst refuses the source, which is a defect of `typstmath`.
    """
    found = {formula: _equation(formula) for formula in formulas}
    settable = {formula: text for formula, text in found.items() if text}
    done = {formula: f"<code>{escape(formula.latex)}</code>" for formula in found}
    texts = list(settable.values())
    for formula, text, width in zip(settable, _set(texts), _widths(texts), strict=True):
        style = f' style="--em: {width:.0f}"' if width > WIDE else ""
        done[formula] = text.replace("<math", f"<math{style}", 1)
    return done


def _equation(formula: Formula) -> str:
    """Return the Typst source of a formula; nothing for one that cannot be set."""
    try:
        text = source(read(formula.latex))
    except UnsettableError:
        return ""
    return f"$ {text} $" if formula.display else f"${text}$"


def _set(equations: Sequence[str]) -> list[str]:
    parts = [f'#html.elem("p")[{text}]' for text in equations]
    document = "\n".join([_PREAMBLE, *parts]).encode()
    page = typst.compile(document, format="html", ignore_system_fonts=True).decode()
    return [found.translate(_ACCENTS) for found in _MATH.findall(page)]


def _widths(equations: Sequence[str]) -> list[float]:
    """Return how wide each is, in em."""
    parts = [
        f"#context [#metadata(measure[{text}].width / 1em.to-absolute()) <width>]"
        for text in equations
    ]
    document = "\n".join([_MEASURED, *parts]).encode()
    return json.loads(typst.query(document, "<width>", "value", ignore_system_fonts=True))
