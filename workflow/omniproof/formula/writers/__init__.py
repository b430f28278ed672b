"""Writers: one tree, and what it looks like in LaTeX, in code, on a terminal and on paper."""

from omniproof.formula.writers.numpy_code import numpy
from omniproof.formula.writers.sympy_code import sympy

__all__ = ["numpy", "sympy"]
