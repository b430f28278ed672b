"""A statement is made where all that is printed is defined, also what cancels."""

import pytest

from omniproof.audit.check import Finding, check
from omniproof.audit.setting import Assumptions
from omniproof.formula.sympy_terms import Converter
from omniproof.formula.term import Symbol
from omniproof.formula.unfold import unfold
from omniproof.formula.value import terms_in
from omniproof.formula.where_defined import requirements
from omniproof.transcription.reader import read

NONE = Assumptions()
TRUE = Finding.VERIFIED
FALSE = Finding.ERRATUM


@pytest.mark.parametrize(
    ("statement", "verdict"),
    [
        pytest.param(r"(\sqrt{x})^2 = |x|", TRUE, id="squared: defined for x >= 0 only"),
        pytest.param(r"\sqrt{x}\sqrt{x} = |x|", TRUE, id="times itself"),
        pytest.param(r"\frac{(\sqrt{a - b})^2}{2} = \frac{|a - b|}{2}", TRUE, id="a difference"),
        pytest.param(r"(\sqrt{-x})^2 = |x|", TRUE, id="defined for x <= 0 only"),
        pytest.param(r"(\sqrt{x})^2 = -|x|", FALSE, id="false where it is defined"),
        pytest.param(r"(\sqrt{x})^2 = x^2", FALSE, id="false for most x"),
        pytest.param(r"(\sqrt{x^2 + 1})^2 = x^2 + 1", TRUE, id="never negative"),
        pytest.param(r"x = |x|", Finding.CONDITIONAL, id="without a root nothing is presumed"),
        pytest.param(r"\sqrt{x^2} = x", Finding.CONDITIONAL, id="the root of a square is kept"),
    ],
)
def test_identities_with_roots_that_cancel(statement, verdict):
    assert check(statement).verdict is verdict


def test_a_root_that_is_defined_nowhere_proves_nothing():
    assert check(r"(\sqrt{x})^2 = x", Assumptions(between=("x < 0",))).verdict is Finding.UNDECIDED


def test_conditions_without_an_interior_prove_nothing():
    assumptions = Assumptions(between=("0 < x",))
    assert check(r"(\sqrt{-x})^2 = 5", assumptions).verdict is Finding.UNDECIDED


FAR = Assumptions(between=("-1 < x < 1",))


@pytest.mark.parametrize(
    ("statement", "assumptions", "verdict"),
    [
        pytest.param(r"\frac{x^4}{x^2} > 0", NONE, TRUE, id="a square that cancels"),
        pytest.param(r"\frac{x^4}{x^2} > 0", FAR, TRUE, id="on a range"),
        pytest.param(r"\frac{x^2}{x} \neq 0", NONE, TRUE, id="a factor that cancels"),
        pytest.param(r"\frac{x^2}{x} \neq 0", FAR, TRUE, id="on a range"),
        pytest.param(r"\frac{x^2}{x} > 0", NONE, FALSE, id="false elsewhere, too"),
        pytest.param(r"\frac{1}{\frac1L} \neq 0", NONE, TRUE, id="nested fractions"),
        pytest.param(r"(x^{-1})^{-2} > 0", NONE, TRUE, id="negative powers"),
        pytest.param(r"\left|\frac{\sin^2\theta}{\sin\theta}\right| > 0", NONE, TRUE, id="a sine"),
        pytest.param(r"(\frac xy)^2+y^2 > 0", NONE, TRUE, id="0 over 0 at the origin"),
        pytest.param(r"\frac{(x-y)^2}{x-y} \neq 0", NONE, TRUE, id="a line is left out"),
        pytest.param(r"(\tan x\cos x)^2 < 1", NONE, TRUE, id="poles that cancel"),
        pytest.param(r"(\cot x)^2 \sin^2 x < 1", NONE, TRUE, id="of the cotangent"),
        pytest.param(r"(\sec x)^{-2} > 0", NONE, TRUE, id="of the secant"),
        pytest.param(r"(\csc x)^{-2} > 0", NONE, TRUE, id="of the cosecant"),
        pytest.param(r"\sin(\arcsin x) \leq 1", NONE, TRUE, id="the range of an arc sine"),
        pytest.param(r"\cos(\arccos x) \geq -1", NONE, TRUE, id="of an arc cosine"),
        pytest.param(r"(\sqrt{x})^2 \geq 0", NONE, TRUE, id="a radicand"),
        pytest.param(r"(\sqrt{x})^2 > 0", NONE, FALSE, id="that may be 0"),
        pytest.param(r"\frac{(\sqrt{x})^3}{\sqrt{x}} > 0", NONE, TRUE, id="and here may not"),
        pytest.param(r"\frac{\sin x}{x} = 1", NONE, FALSE, id="what it tends to is not it"),
        pytest.param(r"\begin{pmatrix}x&0\\0&x\end{pmatrix}^{-1} "
                     r"\begin{pmatrix}x&0\\0&x\end{pmatrix} "
                     r"= \begin{pmatrix}1&0\\0&1\end{pmatrix}", NONE, TRUE, id="an inverse"),
    ],
)  # fmt: skip
def test_orders_are_asserted_where_the_print_is_defined(statement, assumptions, verdict):
    assert check(statement, assumptions).verdict is verdict


@pytest.mark.parametrize(
    ("formula", "needed"),
    [
        pytest.param(r"\frac{x^2}{x}", "Ne(x, 0)", id="a denominator that cancels"),
        pytest.param(r"\frac{x}{x + 1}", "Ne(x + 1, 0)", id="a sum"),
        pytest.param(r"\frac{x y}{2 x y^2}", "Ne(x, 0), Ne(y, 0)", id="each factor"),
        pytest.param(r"\frac{1}{\frac{1}{x}}", "Ne(x, 0)", id="each once"),
        pytest.param(r"x^{-2}", "Ne(x, 0)", id="a negative power"),
        pytest.param(r"\sqrt{x}", "x >= 0", id="a root"),
        pytest.param(r"(\sqrt{x})^2", "x >= 0", id="a root that cancels"),
        pytest.param(r"\sin(\arcsin x)", "1 - x >= 0, x + 1 >= 0", id="an arc sine"),
        pytest.param(r"\arccos x", "1 - x >= 0, x + 1 >= 0", id="an arc cosine"),
        pytest.param(r"\tan x \cos x", "Ne(cos(x), 0)", id="a pole"),
        pytest.param(r"\cot x + \csc x", "Ne(sin(x), 0)", id="two with one pole"),
        pytest.param(r"\operatorname{atan2}(y, x)", "Ne(x**2 + y**2, 0)", id="no origin"),
        pytest.param(r"\begin{pmatrix}x&0\\0&y\end{pmatrix}^{-1}", "Ne(x, 0), Ne(y, 0)",
                     id="a matrix that is inverted"),
        pytest.param(r"\int_0^1 \frac{1}{x} d x", "", id="not of an integrand"),
        pytest.param(r"\int_0^{1/y} x d x", "Ne(y, 0)", id="of the ends of an integral"),
        pytest.param(r"\frac{1}{\sqrt{2}}", "", id="nothing of numbers"),
    ],
)  # fmt: skip
def test_what_a_formula_needs_to_be_defined(formula, needed):
    value = unfold(read(formula), {name: Symbol(name) for name in "xy"})
    found = map(Converter().expression, requirements(*terms_in(value)))
    assert ", ".join(map(str, found)) == needed
