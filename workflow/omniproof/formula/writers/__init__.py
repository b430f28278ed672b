"""Writers: one tree, and what it looks like in LaTeX, in code, on a terminal and on paper.

`latex`, `numpy` and `sympy` write a tree, a term or a grid of terms. A notation for people is
written from boxes, which are laid out once for all of them (`boxes`); `display`, `typst` and `text`
write boxes.
"""

from omniproof.formula.writers.difference import difference, in_common
from omniproof.formula.writers.latex_text import display, latex
from omniproof.formula.writers.numpy_code import numpy
from omniproof.formula.writers.plain_text import text
from omniproof.formula.writers.sympy_code import sympy
from omniproof.formula.writers.typst_text import typst, words

__all__ = [
    "difference",
    "display",
    "in_common",
    "latex",
    "numpy",
    "sympy",
    "text",
    "typst",
    "words",
]
