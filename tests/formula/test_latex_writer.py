"""What is written reads back: as the same tree, and with the same value."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
from generated_trees import POINT, TREES
from hypothesis import assume, given, settings
from sympy import N

from omniproof.formula.evaluation import evaluate
from omniproof.formula.writers import latex
from omniproof.transcription import tree
from omniproof.transcription.model import Notation
from omniproof.transcription.reader import read
from omniproof.transcription.tokens import LatexError


def value(node: tree.Node) -> Any:
    """The value of a tree, by another route than the code under test."""
    match node:
        case tree.Number(text) | tree.Degrees(text):
            factor = mpmath.pi / 180 if isinstance(node, tree.Degrees) else 1
            return mpmath.mpf(text) * factor
        case tree.Pi():
            return mpmath.pi
        case tree.Name(name):
            return mpmath.mpf(int(POINT[name].p)) / int(POINT[name].q)
        case tree.Sum(terms):
            return sum(value(term) for term in terms)
        case tree.Product(factors):
            return mpmath.fprod(value(factor) for factor in factors)
        case tree.Dot(left, right) | tree.Cross(left, right):
            return value(left) * value(right)
        case tree.Quotient(above, below):
            return value(above) / value(below)
        case tree.Negative(inner):
            return -value(inner)
        case tree.Absolute(inner) | tree.Norm(inner):
            return abs(value(inner))
        case tree.Power(base, exponent):
            return value(base) ** exponent
        case tree.Call(name, argument):
            function = {"arctan": "atan"}.get(name, name)
            return getattr(mpmath, function)(value(argument))
    raise AssertionError(node)


@settings(deadline=None, max_examples=150)
@given(TREES)
def test_random_trees_keep_their_value(node: tree.Node) -> None:
    read_back = read(latex(node), Notation(), ["v_k^T"])
    with mpmath.workdps(40):
        try:
            expected = value(node)
        except ZeroDivisionError:
            assume(False)
        assume(mpmath.isfinite(expected) and abs(expected) < 1e30)
        try:
            found = evaluate(read_back, POINT)
        except LatexError:
            assume(False)
        difference = abs(mpmath.mpmathify(N(found, 40)) - expected)
        assert difference <= mpmath.mpf(10) ** -25 * (1 + abs(expected))


FORMS = [
    r"\{a, b\} = \{30^\circ, 150^\circ\}",
    r"\{x \mid |a| \leq 1\}",
    r"\langle \mathbf{a}, (b, c)^T \rangle + L\dot{\phi}",
    r"D_V(\theta_1, \theta_2) = 8 / \det \mathbf{A}",
    r"(\hat{\mathbf{a}}_1 \times \hat{\mathbf{a}}_2)_z (a - b)_x < 0",
    r"\begin{pmatrix} -\sin a & 1 \\ 0 & b \end{pmatrix}^{-1} \begin{pmatrix} x \\ y \end{pmatrix}",
    r"\begin{cases} 4\|a \times b\| & x < 0 \text{ and } y > 0 \\ -b & x > 0 \end{cases}",
    r"a < b \text{ or } (c < x \text{ and } 0 < y)",
    r"= a = b",
    r"\Leftrightarrow a < b",
    r"a = 1, b = 2",
    r"\det[a, b, c] + \det(\mathbf{A}^{-1}) + \operatorname{atan2}(y, x)",
    r"2 \cdot 3 \times (a + b) \cdot (c d)",
    r"-(-a) - (b - c) + (-x)",
    r"(2 (a b) c / 3) 4 (5)(x)^{2}",
    r"\sqrt{2} \sin^2(x) |a||b|",
    r"\frac{1}{2} \int_{0}^{t} a + \sin(b) dt - c",
    r"a (\int_0^x \cos(\int_0^t b dt) dt)^2 \int_0^1 c d\theta",
]


@pytest.mark.parametrize("text", FORMS)
def test_forms_read_back_as_the_same_tree(text: str) -> None:
    node = read(text, Notation(slash="first"), [], ["D_V"])
    assert read(latex(node), Notation(), [], ["D_V"]) == node


WRITTEN = [
    pytest.param("a - b/c", r"a - \frac{b}{c}", id="fractions"),
    pytest.param(r"\sin 2\theta\cos\theta", r"\sin(2 \theta) \cos(\theta)", id="arguments"),
    pytest.param(r"-L \sin\alpha_1 + L \sin\alpha_1",
                 r"-L \sin(\alpha_1) + L \sin(\alpha_1)", id="a misprint stays"),
    pytest.param("2(3)", "2 * 3", id="numbers do not run together"),
    pytest.param("(a + b)^{-1}", "(a + b)^{-1}", id="brackets"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "written"), WRITTEN)
def test_written(text: str, written: str) -> None:
    assert latex(read(text)) == written
