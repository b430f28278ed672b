r"""Formulas as Unicode text, for a terminal and for those who hear a page: `sin²α₁ + L·φ̇`."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from omniproof.formula.writers.boxes import Box, Row
from omniproof.transcription.functions import FUNCTIONS

_GREEK = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau "
    "upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
SIGNS = {
    **dict(zip([f"\\{name}" for name in _GREEK.split()], "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΥΦΨΩ",
               strict=True)),
    "\\varphi": "φ", "\\varepsilon": "ε", "\\vartheta": "θ", "\\varrho": "ρ", "\\ell": "ℓ",
    "\\nabla": "∇", "\\in": "∈", "\\angle": "∠", "\\prime": "′", "\\top": "T",
    "\\perp": "⊥", "\\circ": "°",
    "*": "·", "\\cdot": "·", "\\times": "×", "\\leq": "≤", "\\geq": "≥", "\\neq": "≠",
    "\\Leftrightarrow": "⇔", "\\mid": "|", "\\{": "{", "\\}": "}", "\\|": "‖",
    "\\langle": "⟨", "\\rangle": "⟩",
}  # fmt: skip
WORDS = {row.latex: row.text for row in FUNCTIONS.values()} | {"\\det": "det"}
ACCENTS = {
    "\\dot": "\u0307", "\\ddot": "\u0308", "\\hat": "\u0302", "\\widehat": "\u0302",
    "\\bar": "\u0304", "\\overline": "\u0305", "\\tilde": "\u0303", "\\widetilde": "\u0303",
    "\\vec": "\u20d7", "\\overrightarrow": "\u20d7", "\\underline": "\u0332",
}  # fmt: skip
"""Marks that combine with the letter before them."""
_LETTER = re.compile("[^\\W_][\u0300-\u036f\u20d7]*")
ABOVE = str.maketrans("0123456789+-−()T′", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁽⁾ᵀ′")
BELOW = str.maketrans("0123456789,+-−()aeijkmnoprstuvxhl", "₀₁₂₃₄₅₆₇₈₉,₊₋₋₍₎ₐₑᵢⱼₖₘₙₒₚᵣₛₜᵤᵥₓₕₗ")


def text(row: Row) -> str:
    """Write boxes as text on one line."""
    written = ""
    for place, box in enumerate(row):
        part = RULES[box.kind](box, *map(text, box.parts))
        written += " " * (place > 0 and _apart(row[place - 1], box)) + part
    return " ".join(written.split())


def _apart(one: Box, other: Box) -> bool:
    """Whether a blank stands between two boxes; `2α` and `a/b` have none."""
    if one.kind == "prefix" or "/" in (one.text, other.text) or other.text == ",":
        return False
    number = one.kind == "letter" and one.text[0].isdigit()
    return not (number and other.kind in {"name", "scripts", "root"})


def _letter(box: Box) -> str:
    return SIGNS.get(box.text, box.text)


def _word(box: Box) -> str:
    return WORDS.get(box.text) or box.text.partition("{")[2].removesuffix("}").strip()


def _accent(box: Box, inside: str) -> str:
    return _LETTER.sub(rf"\g<0>{ACCENTS[box.text]}", inside)


def _scripts(box: Box, base: str, below: str, above: str) -> str:
    return base + _script("_", below, BELOW) + _script("^", above, ABOVE)


def _script(sign: str, script: str, small: Mapping[int, int | str]) -> str:
    """Write a script in small letters where there are such, else behind a sign."""
    script = script.replace(" ", "")
    if all(ord(letter) in small for letter in script):
        return script.translate(small)
    return f"{sign}{script}" if len(script) == 1 else f"{sign}({script})"


def _grouped(box_row: Row, written: str) -> str:
    """Put brackets around a numerator or denominator that has more than one part."""
    return f"({written})" if len(box_row) > 1 else written


def _grid(box: Box, *cells: str) -> str:
    width, brackets = box.text.split(" ", 1)
    rows = (", ".join(cells[k : k + int(width)]) for k in range(0, len(cells), int(width)))
    left, right = brackets.split(" ") if " " in brackets else ("{", "}") if brackets else ("(", ")")
    return f"{left}{'; '.join(rows)}{right}"


def _fence(box: Box, inside: str) -> str:
    left, right = (SIGNS.get(bracket, bracket) for bracket in box.text.split(" "))
    return f"{left}{inside}{right}"


def _call(box: Box, head: str, argument: str) -> str:
    bracketed = box.parts[1][0].kind == "fence"
    return f"{head}{'' if bracketed else ' '}{argument}"


RULES: dict[str, Callable[..., str]] = {
    **dict.fromkeys(("letter", "sign", "prefix"), _letter),
    "word": _word,
    "accent": _accent,
    "font": lambda box, inside: inside,
    "name": lambda box, inside: inside,
    "degrees": lambda box, number: f"{number}°",
    "differential": lambda box, variable: f"d{variable}",
    "root": lambda box, inside: f"√{_grouped(box.parts[0], inside)}",
    "fraction": lambda box, above, below: (
        f"{_grouped(box.parts[0], above)}/{_grouped(box.parts[1], below)}"
    ),
    "integral": lambda box, lower, upper: f"∫[{lower}, {upper}]",
    "call": _call,
    "scripts": _scripts,
    "fence": _fence,
    "grid": _grid,
    "mark": lambda box, inside: f"[{inside}]",
}
