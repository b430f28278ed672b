"""Formulas to paste need nothing but the line that imports what they use."""

from __future__ import annotations

import numpy as np
import pytest
from sympy import Abs, Function, Integral, Matrix, Symbol, cos, sqrt, symbols

from omniproof.report.pastes import LONGEST, Product, latex_paste, numpy_paste, sympy_paste

x, y = symbols("x y", real=True)
L = Symbol("L", positive=True)
t = Symbol("t", real=True)
v = Function("v", real=True)(t)


def run(text: str) -> dict[str, object]:
    """Run a paste in an empty namespace."""
    names: dict[str, object] = {}
    exec(text, names)
    return names


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        pytest.param(r"a &= b", "a = b", id="a mark of alignment"),
        pytest.param(r"a &\leq b", r"a \leq b", id="before a comparison, too"),
        pytest.param("= b", "b", id="a sign without left side"),
        pytest.param(r"&= b \tag{4}", "b", id="both, and a tag"),
        pytest.param("a = b,", "a = b", id="the comma of a sentence"),
        pytest.param(
            r"\begin{pmatrix} a & b \end{pmatrix}",
            r"\begin{pmatrix} a & b \end{pmatrix}",
            id="columns stay",
        ),
        pytest.param(
            r"\operatorname{atan}_{2}{\left(y,x \right)}",
            r"\operatorname{atan2}\left(y,x \right)",
            id="the arc tangent of two arguments",
        ),
    ],
)
def test_latex_stands_in_a_display_of_its_own(latex: str, expected: str) -> None:
    assert latex_paste(latex) == expected


def test_sympy_declares_its_symbols_and_imports_what_it_calls() -> None:
    text = sympy_paste("radius", Product((sqrt(x**2) * L / Abs(y),)))
    assert text.splitlines() == [
        "from sympy import Abs, symbols",
        "",
        'L = symbols("L", positive=True)',
        'x, y = symbols("x y", real=True)',
        "",
        "radius = L*Abs(x)/Abs(y)",
    ]
    assert run(text)["radius"] == L * Abs(x) / Abs(y)


def test_factors_stay_apart() -> None:
    product = Product((L / x, Matrix([[y], [1]])), cos(y))
    assert sympy_paste("centre", product).endswith(
        "centre = (L/x) * Matrix([\n    [y],\n    [1],\n]) / (cos(y))"
    )
    assert run(sympy_paste("centre", product))["centre"] == product.value


def test_numpy_is_a_function_of_the_symbols() -> None:
    text = numpy_paste("centre", Product((L / x, Matrix([[y], [1]])), cos(y)))
    centre = run(text)["centre"]
    assert callable(centre)
    np.testing.assert_allclose(centre(2.0, 4.0, 0.5), [0.25 / np.cos(0.5), 0.5 / np.cos(0.5)])


def test_numpy_takes_samples_for_an_integral_over_time() -> None:
    turned = Integral(v, (t, 0, t))
    text = numpy_paste("path", Product((Integral(v * cos(turned), (t, 0, t)) / 3,)))
    path = run(text)["path"]
    assert callable(path)
    time = np.linspace(0, 1, 2001)
    np.testing.assert_allclose(path(time, np.ones_like(time)), np.sin(time) / 3, atol=1e-7)


@pytest.mark.parametrize("paste", [sympy_paste, numpy_paste])
@pytest.mark.parametrize(
    "formula",
    [
        pytest.param(sum(symbols(f"a:{LONGEST}")), id="too long to read"),
        pytest.param(Symbol("x^e", real=True) ** 2, id="a name that no program can have"),
        pytest.param(Symbol("lambda", real=True) ** 2, id="a word of the language"),
    ],
)
def test_what_cannot_be_pasted_is_not_offered(paste: object, formula: object) -> None:
    assert callable(paste)
    assert paste("f", Product((formula,))) == ""
