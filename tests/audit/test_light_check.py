"""What an equation on the command line costs: no algebra system is imported for it."""

from __future__ import annotations

import subprocess
import sys

import pytest

SCRIPT = """
import sys
from omniproof.audit.check import check
print(check(sys.argv[1]).verdict, *sorted({"sympy", "z3", "numpy"} & sys.modules.keys()))
"""


def said(formula: str) -> str:
    """Check a formula in a fresh interpreter; return the verdict and the slow modules it loads."""
    command = [sys.executable, "-c", SCRIPT, formula]
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
    assert said(formula) == verdict
