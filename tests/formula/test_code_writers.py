"""What is written as code runs when it is pasted, and has the exact value of the formula."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
import pytest
import sympy as sp
from generated_trees import POINT, TREES
from hypothesis import assume, given, settings
from mpmath import mp

from omniproof.decide import digits
from omniproof.formula import writers
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.grid import Grid
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.writers.identifiers import identifier
from omniproof.transcription import tree
from omniproof.transcription.reader import read

SYMBOLS = {r"\theta": "2/3", r"\alpha_1": "1/5", "x": "3/7", "y": "5/4", "L": "7/3",
           r"\dot{\phi}": "-9/4", r"\lambda": "1/9", "v_k^T": "2"}  # fmt: skip
VALUES = {name: sp.Rational(value) for name, value in SYMBOLS.items()}


def pasted(code: str, **names: Any) -> Any:
    """Run code as a reader who pastes it would, and return what it leaves in its last line."""
    *_, last = code.split("\n")
    target, sign, _ = last.partition(" = ")
    if not (sign and target.isidentifier()):
        target, code = "result", f"result = {code}"
    space = {"np": np, "sp": sp, **names}
    exec(code, space)
    return space[target]


def floats(values: Mapping[str, Any] = VALUES) -> dict[str, Any]:
    return {identifier(name): float(value) for name, value in values.items()}


@mp.workdps(60)
def exact(node: tree.Node, values: Mapping[str, Any] = VALUES) -> list[Any]:
    """Evaluate a tree to 60 digits, by code that shares nothing with the writers."""
    points = {name: mp.mpf(int(v.p)) / int(v.q) for name, v in values.items()}
    found = digits.value(node, lambda symbol, bound: points[symbol.name])
    return list(found) if isinstance(found, mp.matrix) else [found]


@mp.workdps(60)
def close(found: Any, expected: list[Any], digits: int) -> bool:
    parts = np.ravel(np.array(found.tolist() if isinstance(found, sp.MatrixBase) else found))
    pairs = zip(parts, expected, strict=True)
    return all(abs(mp.mpmathify(sp.N(a, 50)) - b) <= (1 + abs(b)) * 10.0**-digits for a, b in pairs)


FORMULAS = [
    pytest.param(r"\frac{1}{2} x - x^{-2}", id="whole numbers stay exact"),
    pytest.param(r"\frac{1 + 2}{4}", id="sums of whole numbers, too"),
    pytest.param(r"2^{-3} + \frac{2^{2}}{3 \cdot 5}", id="and powers and products of them"),
    pytest.param("-x^2 - (-y)^3 (-L)", id="signs"),
    pytest.param(r"x - (y - L) - \frac{x}{y L}", id="brackets"),
    pytest.param(r"\frac{\frac{x}{y}}{\frac{y}{L}}", id="nested fractions"),
    pytest.param(r"3.08 \sin\theta - 0.5", id="decimals"),
    pytest.param(r"30^\circ + \frac{\pi}{3}", id="degrees and pi"),
    pytest.param(r"\dot{\phi} \cos(\theta + \alpha_1) - \lambda", id="names"),
    pytest.param(r"\tan\theta + \cot\theta + \sec\theta + \csc\theta", id="circular functions"),
    pytest.param(r"\arcsin x + \arccos x + \arctan y", id="inverse functions"),
    pytest.param(r"\operatorname{atan2}(x, -y)", id="the angle of a point"),
    pytest.param(r"\max(x, y, L) - \min(x, -y)", id="maximum of three"),
    pytest.param(r"\exp x + \ln y + \sinh x \cosh y \tanh L", id="exponentials"),
    pytest.param(r"|x - y| \operatorname{sgn}(x - y) + \sqrt{y}", id="size, sign, root"),
    pytest.param(r"\sqrt{2} \sqrt{\frac{1}{3}}", id="roots of numbers"),
    pytest.param(r"\begin{pmatrix} x & 1 \\ 0 & y \end{pmatrix}", id="matrix"),
    pytest.param(r"\begin{pmatrix} x & 1 \\ 0 & y \end{pmatrix}^{-1} (x, 2)", id="inverse"),
    pytest.param(r"\begin{pmatrix} x \\ y \end{pmatrix} + 2 (1, L)", id="columns"),
    pytest.param(r"\begin{pmatrix} x & y \end{pmatrix} \begin{pmatrix} 1 \\ L \end{pmatrix}",
                 id="row times column"),
    pytest.param(r"\begin{pmatrix} x \\ y \end{pmatrix} \begin{pmatrix} 1 & L \end{pmatrix}",
                 id="column times row"),
    pytest.param(r"\begin{pmatrix} x \\ y \end{pmatrix}^T \begin{pmatrix} x & 1 \\ 0 & y"
                 r"\end{pmatrix}^2 \begin{pmatrix} x \\ y \end{pmatrix}", id="quadratic form"),
    pytest.param(r"(1, 2, x) \times (y, 0, L)", id="cross product"),
    pytest.param(r"(1, 2, x) \cdot (y, 0, L) + \langle (x, 1), (y, 2) \rangle", id="inner"),
    pytest.param(r"\|(x, y, 1)\| - \|x\|", id="norms"),
    pytest.param(r"\det[(1, x), (y, 2)] + \det\begin{pmatrix} x & 1 \\ 0 & y \end{pmatrix}",
                 id="determinants"),
    pytest.param(r"((1, x, 3) \times (y, 0, 1))_z", id="component"),
    pytest.param(r"[(1, x), (y, 2)]", id="a matrix by its columns"),
    pytest.param(r"\begin{pmatrix} \begin{pmatrix} x & 1 \\ 0 & y \end{pmatrix} & (x, 2) \\"
                 r"\begin{pmatrix} 0 & 0 \end{pmatrix} & 1 \end{pmatrix}", id="blocks"),
]  # fmt: skip


@pytest.mark.parametrize("text", FORMULAS)
def test_pasted_code_has_the_exact_value(text: str) -> None:
    node = read(text, symbols=list(SYMBOLS))
    expected = exact(node)
    assert close(pasted(writers.numpy(node), **floats()), expected, digits=12)
    symbols = {identifier(name): sp.Symbol(identifier(name)) for name in SYMBOLS}
    found = sp.sympify(pasted(writers.sympy(node), **symbols))
    assert not found.has(sp.Float), "the numbers of SymPy stay exact"
    point = {symbols[identifier(name)]: value for name, value in VALUES.items()}
    assert close(found.subs(point), expected, digits=45)


@settings(max_examples=200, deadline=None)
@given(TREES)
def test_generated_formulas_have_their_exact_value(node: tree.Node) -> None:
    try:
        expected = exact(node, POINT)
    except digits.UndefinedError:
        assume(False)
    assume(abs(expected[0]) < 10**9)
    with np.errstate(all="ignore"):
        assert close(pasted(writers.numpy(node), **floats(POINT)), expected, digits=5)
    values = {identifier(name): value for name, value in POINT.items()}
    assert close(sp.sympify(pasted(writers.sympy(node), **values)), expected, digits=30)


@pytest.mark.parametrize(
    ("text", "numpy", "sympy"),
    [
        pytest.param(r"\dot{\theta}_1 = \frac{v}{2}", "theta_dot_1 = v / 2", "theta_dot_1 = v / 2",
                     id="a symbol is assigned"),
        pytest.param("a = b = 1.5", "a = 1.5", 'a = sp.Rational("1.5")', id="the last side"),
        pytest.param("= a b", "a * b", "a * b", id="a line that goes on"),
        pytest.param(r"\cos a = b", "np.allclose(np.cos(a), b)", "sp.Eq(sp.cos(a), b)",
                     id="an equation is tested"),
        pytest.param("a = 1, b = 2", "a = 1\nb = 2", "a = 1\nb = 2", id="a line each"),
        pytest.param(r"a \leq b", "np.less_equal(a, b)", "sp.Le(a, b)", id="an inequality"),
        pytest.param(r"\begin{cases} a & a > 0 \\ -a & a < 0 \end{cases}",
                     "np.select([np.greater(a, 0), np.less(a, 0)], [a, -a], np.nan)",
                     "sp.Piecewise((a, sp.Gt(a, 0)), (-a, sp.Lt(a, 0)))", id="cases"),
        pytest.param("D(a)", "D(a)", "D(a)", id="a quantity with its argument"),
    ],
)  # fmt: skip
def test_statements(text: str, numpy: str, sympy: str) -> None:
    node = read(text, symbols=["a", "b", r"\dot{\theta}_1"], quantities=["D"])
    assert writers.numpy(node) == numpy
    assert writers.sympy(node) == sympy


@pytest.mark.parametrize("write", [writers.numpy, writers.sympy])
def test_symbols_that_are_said_to_be_arrays(write: Any) -> None:
    node = read(r"A^{-1} v \cdot w + \|v\|", symbols="Avw")
    ranks = {"A": 2, "v": 1, "w": 1}
    values = {"A": [[2, 1], [0, 4]], "v": [3, 4], "w": [5, 6]}
    make = sp.Matrix if write is writers.sympy else partial(np.array, dtype=float)
    found = pasted(write(node, ranks), **{name: make(value) for name, value in values.items()})
    assert float(found) == pytest.approx(16)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        pytest.param(r"\alpha_1", "alpha_1", id="Greek"),
        pytest.param(r"\dot{\theta}", "theta_dot", id="dot"),
        pytest.param(r"\hat{a}_{12}", "a_hat_12", id="accent before the index"),
        pytest.param(r"\lambda", "lambda_", id="a word of Python"),
        pytest.param("sp", "sp_", id="a library"),
        pytest.param("v_k^T", "v_k_T", id="superscript"),
        pytest.param("x'", "x_prime", id="prime"),
        pytest.param(r"\det A", "det_A", id="determinant"),
        pytest.param(r"\Delta x_{i+1}", "Delta_x_i_plus_1", id="difference"),
        pytest.param(r"\angle ABC", "angle_ABC", id="angle"),
        pytest.param(r"\hat{\bar{a}}", "a_bar_hat", id="two accents"),
        pytest.param("a_{i,j}", "a_i_j", id="two indices"),
    ],
)
def test_identifiers(name: str, expected: str) -> None:
    assert identifier(name) == expected
    assert expected.isidentifier()


def test_two_symbols_never_share_a_name() -> None:
    node = read("a_{1,2} + a_{1_2}", symbols=["a_{1,2}", "a_{1_2}"])
    message = "`a_{1,2}` and `a_{1_2}` would both be called `a_1_2`"
    with pytest.raises(UnsupportedError, match=re.escape(message)):
        writers.numpy(node)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        pytest.param(r"\int_0^1 x dx", "NumPy has no integrals", id="integral"),
        pytest.param(r"\{x \mid x > 0\}", "no code is written of a setbuilder", id="set"),
        pytest.param(r"(1, 2) \times (x, 3)",
                     "no code is written of a cross product of vectors in the plane", id="plane"),
    ],
)  # fmt: skip
def test_what_has_no_code_is_refused(text: str, message: str) -> None:
    with pytest.raises(UnsupportedError, match=message):
        writers.numpy(read(text, symbols="x"))


X, Y = sp.symbols("x y", real=True)


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        pytest.param(-X / 3 + 1 / (2 * Y**2), "1 / (2 * y**2) - x / 3", id="signs and quotients"),
        pytest.param(sp.sqrt(X) * abs(Y), "np.sqrt(x) * np.abs(y)", id="root and size"),
        pytest.param(sp.cbrt(X), "np.power(x, 1 / 3)", id="any power"),
        pytest.param(sp.pi * sp.atan2(Y, X), "np.pi * np.arctan2(y, x)", id="two arguments"),
    ],
)
def test_terms_of_derivations_are_written_as_well(expression: sp.Expr, expected: str) -> None:
    term = term_of(expression)
    assert writers.numpy(term) == expected
    assert writers.numpy(Grid.column((term, term))) == f"np.array([{expected}, {expected}])"


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        pytest.param(sp.cbrt(X), r"x^{\frac{1}{3}}", id="any power"),
        pytest.param(sp.sin(X) ** Y, r"\sin(x)^y", id="a power of a function"),
        pytest.param(-abs(X) / sp.sqrt(Y), r"-\frac{|x|}{\sqrt{y}}", id="size over root"),
        pytest.param(sp.sign(X) * sp.log(Y), r"\ln(y) \operatorname{sgn}(x)", id="sign, logarithm"),
    ],
)
def test_terms_are_written_as_latex(expression: sp.Expr, expected: str) -> None:
    assert writers.latex(term_of(expression)) == expected
