r"""Formulas as LaTeX that reads back as the same tree."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from omniproof.formula.writers.boxes import Box, Row, is_tall, layout, walk
from omniproof.formula.writers.code import Formula
from omniproof.formula.writers.printable import printable
from omniproof.transcription import tree


def latex(formula: Formula) -> str:
    r"""Write a formula as LaTeX, matrices as `pmatrix`.

    Function arguments always get brackets, since `\sin x y` needs a convention.
    """
    node = formula if isinstance(formula, tree.Node) else printable(formula)
    return _written(layout(node), RULES)


def display(row: Row) -> str:
    """Write boxes as LaTeX for a page, where brackets grow with what is in them."""
    return _written(row, RULES | {"fence": _growing})


def _written(row: Row, rules: Mapping[str, Callable[..., str]]) -> str:
    text = ""
    for place, box in enumerate(row):
        apart = place > 0 and row[place - 1].kind != "prefix" and box.text != ","
        parts = (_written(part, rules) for part in box.parts)
        text += " " * apart + rules[box.kind](box, *parts)
    return text


def _scripts(box: Box, base: str, below: str, above: str) -> str:
    written = (
        f"{sign}{_braced(text)}" for sign, text in zip("_^", (below, above), strict=True) if text
    )
    return base + "".join(written)


def _braced(text: str) -> str:
    return text if len(text) == 1 else f"{{{text}}}"


def _fence(box: Box, inside: str) -> str:
    left, right = box.text.split(" ")
    if "|" in left and any("|" in inner.text for row in box.parts for inner in walk(row)):
        return f"\\left{left}{inside}\\right{right}"  # bars that show their direction
    blank = " " * (left == "\\langle")
    return f"{left}{blank}{inside}{blank}{right}"


def _growing(box: Box, inside: str) -> str:
    left, right = box.text.split(" ")
    return f"\\left{left} {inside} \\right{right}" if is_tall(box) else _fence(box, inside)


def _grid(box: Box, *cells: str) -> str:
    width, brackets = box.text.split(" ", 1)
    name = GRIDS[brackets]
    size = int(width)
    rows = (" & ".join(cells[k : k + size]) for k in range(0, len(cells), size))
    lines = " \\\\ ".join(rows)
    return f"\\begin{{{name}}} {lines} \\end{{{name}}}"


def _mark(box: Box, inside: str) -> str:
    """Mark a row by the macro of the book; what is marked keeps the space around it."""
    ((first, *others),) = box.parts
    mark = f"{{\\changed{{{inside}}}}}"
    if others:
        return mark
    if first.kind == "sign" and first.text in BINARY:
        return f"\\mathbin{mark}"
    return f"\\mathop{mark}\\nolimits" if first.kind == "word" else mark


BINARY = frozenset({"+", "-", "*", "\\cdot", "\\times"})
GRIDS = {"( )": "pmatrix", "[ ]": "bmatrix", "| |": "vmatrix", "": "matrix", "cases": "cases"}
RULES: dict[str, Callable[..., str]] = {
    **dict.fromkeys(("letter", "sign", "prefix", "word"), lambda box: box.text),
    **dict.fromkeys(("accent", "font"), lambda box, inside: f"{box.text}{{{inside}}}"),
    "name": lambda box, inside: box.text,
    "degrees": lambda box, number: f"{number}^\\circ",
    "differential": lambda box, variable: f"d{variable}",
    "root": lambda box, inside: f"\\sqrt{{{inside}}}",
    "fraction": lambda box, above, below: f"\\frac{{{above}}}{{{below}}}",
    "integral": lambda box, lower, upper: f"\\int_{{{lower}}}^{{{upper}}}",
    "call": lambda box, head, argument: f"{head}{' ' * argument[:1].isalnum()}{argument}",
    "scripts": _scripts,
    "fence": _fence,
    "grid": _grid,
    "mark": _mark,
}
