"""What an equation on the command line costs: no algebra system is imported for it.

A true one needs neither arrays nor z3; the search for the repair of a false one tries its edits in
arrays, and asks z3 about them.
"""

from __future__ import annotations

import subprocess
import sys

import pytest

SCRIPT = """
import sys
from omniproof.audit.check import check
found = check(sys.argv[1])
repairs = [edit.text for edit in found.repairs[:1]]
witness = ["with a witness"] if found.witness else []
print(found.verdict, *witness, *repairs, *sorted({*sys.argv[2:]} & sys.modules.keys()), sep="; ")
"""


def said(formula: str, *slow: str) -> str:
    """Check a formula in a fresh interpreter.

    Return the verdict, whether there is a witness, the first repair, and the slow modules in use.
    """
    command = [sys.executable, "-c", SCRIPT, formula, *slow]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        pytest.param(r"\sin(2a) = 2 \sin a \cos a", "verified", id="an identity of angles"),
        pytest.param(r"\sqrt{x^2 + 1} \sqrt{x^2 + 1} = x^2 + 1", "verified", id="with roots"),
        pytest.param(r"\begin{pmatrix} 1 & a \\ 0 & 1 \end{pmatrix}^{-1}"
                     r" = \begin{pmatrix} 1 & -a \\ 0 & 1 \end{pmatrix}",
                     "verified", id="an inverse matrix"),
        pytest.param(r"v = \omega r", "definition", id="a definition"),
        pytest.param(r"\frac{x}{2", "invalid", id="no formula"),
        pytest.param(r"\frac{d x}{d t} = 3", "invalid", id="a derivative"),
    ],
)  # fmt: skip
def test_an_equation_needs_no_algebra_system(formula: str, verdict: str) -> None:
    assert said(formula, "sympy", "z3", "numpy") == verdict


@pytest.mark.parametrize(
    ("formula", "repair"),
    [
        pytest.param("(a + b)^2 = a^2 + ab + b^2", "(a + b)^2 = a^2 + 2ab + b^2",
                     id="a polynomial"),
        pytest.param(r"\cos(a + b) = \cos a \cos b + \sin a \sin b",
                     r"\cos(a + b) = \cos a \cos b - \sin a \sin b", id="angles"),
        pytest.param(r"\begin{pmatrix} 1 & a \\ 0 & 1 \end{pmatrix}^{-1}"
                     r" = \begin{pmatrix} 1 & a \\ 0 & 1 \end{pmatrix}",
                     r"\begin{pmatrix} 1 & a \\ 0 & 1 \end{pmatrix}^{-1}"
                     r" = \begin{pmatrix} 1 & -a \\ 0 & 1 \end{pmatrix}", id="an inverse matrix"),
        pytest.param(r"\sqrt{x^2 + 1} \sqrt{x^2 + 1} = x^2 - 1",
                     r"\sqrt{x^2 + 1} \sqrt{x^2 + 1} = x^2 + 1", id="roots"),
    ],
)  # fmt: skip
def test_the_repair_of_an_equation_needs_no_algebra_system(formula: str, repair: str) -> None:
    assert said(formula, "sympy") == f"erratum; with a witness; {repair}"
