r"""Formulas as Typst math.

Typst is a programming language, and formulas come from outside: so nothing is passed through. What
is written comes from this module's tables; letters and digits stand for themselves, and all else
becomes a string literal.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from omniproof.formula.writers.boxes import Box, Row, is_tall
from omniproof.transcription.functions import FUNCTIONS
from omniproof.transcription.tokens import GREEK

SYMBOLS = {
    **{f"\\{name}": name for name in GREEK},
    "\\phi": "phi.alt", "\\varphi": "phi", "\\epsilon": "epsilon.alt", "\\varepsilon": "epsilon",
    "\\vartheta": "theta.alt", "\\varrho": "rho.alt", "\\in": "in",
    "\\angle": "angle", "\\prime": "prime", "\\top": "top", "\\perp": "perp", "\\circ": "compose",
    "+": "+", "-": "-", "=": "=", "<": "<", ">": ">", "*": "ast.op", "/": r"\/", ",": r"\,",
    "\\cdot": "dot.op", "\\times": "times", "\\leq": "lt.eq", "\\geq": "gt.eq", "\\neq": "eq.not",
    "\\Leftrightarrow": "arrow.l.r.double", "\\mid": 'class("relation", bar.v)',
    "(": r"\(", ")": r"\)", "[": r"\[", "]": r"\]", "\\{": r"\{", "\\}": r"\}",
    "|": 'class("normal", bar.v)', "\\|": 'class("normal", bar.v.double)',
    "\\langle": "chevron.l", "\\rangle": "chevron.r",
}  # fmt: skip
"""Letters, signs and brackets."""
WORDS = {row.latex: row.typst for row in FUNCTIONS.values()} | {"\\det": "det"}
AROUND = {
    "\\dot": "dot", "\\ddot": "dot.double", "\\hat": "hat", "\\widehat": "hat", "\\bar": "macron",
    "\\overline": "overline", "\\tilde": "tilde", "\\widetilde": "tilde", "\\vec": "arrow",
    "\\overrightarrow": "arrow", "\\underline": "underline", "\\boldsymbol": "bold", "\\bm": "bold",
    "\\mathcal": "cal", "\\mathbb": "bb", "\\mathit": "italic", "\\mathbf": "bold(upright",
    "\\mathrm": "upright", "\\mathsf": "sans", "\\mathfrak": "frak",
}  # fmt: skip
"""Accents and fonts."""


PLAIN = re.compile(r"[A-Za-z]|[0-9]+(?:\.[0-9]+)?")


def words(text: str) -> str:
    """Return a Typst string literal: nothing in it is markup or code."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{" ".join(escaped.split())}"'


def typst(row: Row) -> str:
    """Write boxes as Typst math; of none, an empty string literal."""
    return " ".join(RULES[box.kind](box, *map(typst, box.parts)) for box in row) or '""'


def _letter(box: Box) -> str:
    plain = PLAIN.fullmatch(box.text)
    return SYMBOLS.get(box.text) or (box.text if plain else words(box.text))


def _word(box: Box) -> str:
    if box.text in WORDS:
        return WORDS[box.text]
    return said(box.text.partition("{")[2].removesuffix("}"))


def said(text: str) -> str:
    """Write words with the blanks at their ends; without any, they are an operator."""
    if text == text.strip():
        return f"op({words(text)})"
    left, right = (" " if text[k : k + 1 or None].isspace() else "" for k in (0, -1))
    return f'class("normal", "{left}{words(text)[1:-1]}{right}")'


def _around(box: Box, inside: str) -> str:
    call = AROUND[box.text]
    return f"{call}({inside}{')' * (call.count('(') + 1)}"


def _scripts(box: Box, base: str, below: str, above: str) -> str:
    placed = (f", {place}: {text}" for place, text in (("b", below), ("t", above)) if text != '""')
    return f"attach({base}{''.join(placed)})"


def _fence(box: Box, inside: str) -> str:
    left, right = (SYMBOLS[bracket] for bracket in box.text.split(" "))
    return f"lr({left} {inside} {right})" if is_tall(box) else f"{left} {inside} {right}"


def _grid(box: Box, *cells: str) -> str:
    width, brackets = box.text.split(" ", 1)
    rows = [cells[k : k + int(width)] for k in range(0, len(cells), int(width))]
    if brackets == "cases":
        return f"cases({', '.join(' & '.join(row) for row in rows)})"
    left = words(brackets[0]) if brackets else "#none"
    return f"mat(delim: {left}, {'; '.join(', '.join(row) for row in rows)})"


def _mark(box: Box, inside: str) -> str:
    """Mark a row; a lone sign keeps the space that it has between its sides."""
    kind = {"+": "binary", "-": "binary", "=": "relation"}.get(inside, "")
    text = f"{box.text}({inside})"
    return f'class("{kind}", {text})' if kind else text


RULES: dict[str, Callable[..., str]] = {
    **dict.fromkeys(("letter", "sign", "prefix"), _letter),
    **dict.fromkeys(("accent", "font"), _around),
    "word": _word,
    "name": lambda box, inside: inside,
    "degrees": lambda box, number: f"{number} degree",
    "differential": lambda box, variable: f"d {variable}",
    "root": lambda box, inside: f"sqrt({inside})",
    "fraction": lambda box, above, below: f"frac({above}, {below})",
    "integral": lambda box, lower, upper: f"attach(integral, b: {lower}, t: {upper})",
    "call": lambda box, head, argument: f"{head} {argument}",
    "scripts": _scripts,
    "fence": _fence,
    "grid": _grid,
    "mark": _mark,
}
