"""Formulas as code for NumPy: vectors are arrays of one dimension, matrices of two."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from omniproof.formula.errors import UnsupportedError
from omniproof.formula.writers.code import (
    ATOM,
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
    "pi": "np.pi", "degrees": "np.radians({0})", "cross": "np.cross({0}, {1})",
    "norm": "np.linalg.norm({0})", "determinant": "np.linalg.det({0})",
    "matrix_power": "np.linalg.matrix_power({0}, {1})", "and": "np.logical_and({0}, {1})",
    "or": "np.logical_or({0}, {1})", "equal": "np.allclose({0}, {1})",
    "equivalent": "np.equal({0}, {1})", "less": "np.less({0}, {1})",
    "greater": "np.greater({0}, {1})", "less_equal": "np.less_equal({0}, {1})",
    "greater_equal": "np.greater_equal({0}, {1})", "not_equal": "np.not_equal({0}, {1})",
}  # fmt: skip


def numpy(formula: Formula, ranks: Mapping[str, int] = {}) -> str:
    r"""Write a formula as code that runs after `import numpy as np`.

    `ranks` says which symbols are arrays: 1 for vectors, 2 for matrices, by canonical name. An
    equation with a symbol on its left side is an assignment of its last side, another one a test.
    Raises `UnsupportedError` for an integral, a set with conditions, and a cross product in the
    plane.
    """
    return written(_NumPy(ranks), formula)


class _NumPy(CodeWriter):
    def number(self, text: str) -> Code:
        return Code(text)

    def call(self, function: str, *arguments: Code) -> Code:
        return Code(FUNCTIONS[function].numpy.format(*(each.text for each in arguments)))

    def spelled(self, name: str, *arguments: str) -> Code:
        if name == "inner":
            return Code(f"{arguments[0]} @ {arguments[1]}", PRODUCT)
        return Code(SPELLED[name].format(*arguments))

    def array_product(self, left: Code, right: Code) -> Code:
        ranks = left.rank, right.rank
        if ranks == (COLUMN, ROW):
            return Code(f"np.outer({left.text}, {right.text})", rank=MATRIX)
        text = f"{left.within(PRODUCT)} @ {right.within(POWER)}"
        return Code(text, PRODUCT, JOINED.get(ranks, MATRIX))

    def array(self, rows: Sequence[Sequence[Code]]) -> Code:
        if any(entry.rank for row in rows for entry in row):
            lines = (", ".join(map(_block, row)) for row in rows)
            return Code(f"np.block([{', '.join(f'[{line}]' for line in lines)}])", rank=MATRIX)
        if len(rows) == 1 or len(rows[0]) == 1:
            entries = ", ".join(entry.text for row in rows for entry in row)
            return Code(f"np.array([{entries}])", rank=COLUMN if len(rows[0]) == 1 else ROW)
        lines = (", ".join(entry.text for entry in row) for row in rows)
        return Code(f"np.array([{', '.join(f'[{line}]' for line in lines)}])", rank=MATRIX)

    def columns(self, vectors: Sequence[Code]) -> Code:
        return Code(f"np.column_stack([{', '.join(v.text for v in vectors)}])", rank=MATRIX)

    def cases(self, branches: Sequence[tuple[Code, Code]]) -> Code:
        conditions = ", ".join(condition.text for _, condition in branches)
        values = ", ".join(value.text for value, _ in branches)
        return Code(f"np.select([{conditions}], [{values}], np.nan)")

    def integral(self, lower: Code, upper: Code, integrand: Code, variable: Code) -> Code:
        raise UnsupportedError("NumPy has no integrals")


def _block(entry: Code) -> str:
    """Write a block; a vector in one has to say which way it stands."""
    places = {COLUMN: "[:, None]", ROW: "[None, :]"}
    return entry.within(ATOM) + places[entry.rank] if entry.rank in places else entry.text
