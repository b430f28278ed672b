"""Formulas as code for SymPy: exact, with columns and matrices of its own kind."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from omniproof.formula.writers.code import (
    COLUMN,
    JOINED,
    MATRIX,
    POWER,
    PRODUCT,
    ROW,
    Code,
    CodeWriter,
    Formula,
    written,
)
from omniproof.transcription.functions import FUNCTIONS

SPELLED = {
    "pi": "sp.pi", "degrees": "sp.rad({0})", "cross": "{0}.cross({1})", "inner": "{0}.dot({1})",
    "norm": "{0}.norm()", "determinant": "{0}.det()", "and": "sp.And({0}, {1})",
    "or": "sp.Or({0}, {1})", "equal": "sp.Eq({0}, {1})", "equivalent": "sp.Equivalent({0}, {1})",
    "less": "sp.Lt({0}, {1})", "greater": "sp.Gt({0}, {1})", "less_equal": "sp.Le({0}, {1})",
    "greater_equal": "sp.Ge({0}, {1})", "not_equal": "sp.Ne({0}, {1})",
}  # fmt: skip


def sympy(formula: Formula, ranks: Mapping[str, int] = {}) -> str:
    r"""Write a formula as code that runs after `import sympy as sp`; its numbers are exact.

    `ranks` says which symbols are arrays: 1 for columns, 2 for matrices, by canonical name. An
    equation with a symbol on its left side is an assignment of its last side, another one an `Eq`.
    Raises `UnsupportedError` for a set with conditions and a cross product in the plane.
    """
    return written(_SymPy(ranks), formula)


class _SymPy(CodeWriter):
    def number(self, text: str) -> Code:
        return Code(text, whole=True) if text.isdigit() else Code(f'sp.Rational("{text}")')

    def over(self, above: Code, below: Code) -> Code:
        # Python divides whole numbers to floating-point ones.
        if above.whole and below.whole:
            return Code(f"sp.Rational({above.text}, {below.text})")
        return super().over(above, below)

    def call(self, function: str, *arguments: Code) -> Code:
        return self.spelled(f"sp.{FUNCTIONS[function].sympy}", *(each.text for each in arguments))

    def spelled(self, name: str, *arguments: str) -> Code:
        if name == "matrix_power":
            return Code(f"{arguments[0]}**{arguments[1]}", POWER)
        return Code(SPELLED.get(name, f"{name}({', '.join(arguments)})").format(*arguments))

    def array_product(self, left: Code, right: Code) -> Code:
        rank = JOINED.get((left.rank, right.rank), MATRIX)
        text = f"{left.within(PRODUCT)} * {right.within(POWER)}"
        return Code(text, PRODUCT, rank) if rank else Code(f"({text})[0]")

    def array(self, rows: Sequence[Sequence[Code]]) -> Code:
        if any(entry.rank for row in rows for entry in row):
            lines = ", ".join(f"[{', '.join(map(_block, row))}]" for row in rows)
            return Code(f"sp.Matrix([{lines}])", rank=MATRIX)
        if len(rows[0]) == 1:
            return Code(f"sp.Matrix([{', '.join(row[0].text for row in rows)}])", rank=COLUMN)
        lines = ", ".join(f"[{', '.join(entry.text for entry in row)}]" for row in rows)
        return Code(f"sp.Matrix([{lines}])", rank=ROW if len(rows) == 1 else MATRIX)

    def columns(self, vectors: Sequence[Code]) -> Code:
        return Code(f"sp.Matrix.hstack({', '.join(v.text for v in vectors)})", rank=MATRIX)

    def cases(self, branches: Sequence[tuple[Code, Code]]) -> Code:
        pairs = ", ".join(f"({value.text}, {condition.text})" for value, condition in branches)
        return Code(f"sp.Piecewise({pairs})")

    def integral(self, lower: Code, upper: Code, integrand: Code, variable: Code) -> Code:
        ends = ", ".join(part.text for part in (variable, lower, upper))
        return Code(f"sp.Integral({integrand.text}, ({ends}))")


def _block(entry: Code) -> str:
    """Write a block; a number among blocks is one by one."""
    return entry.text if entry.rank else f"sp.Matrix([{entry.text}])"
