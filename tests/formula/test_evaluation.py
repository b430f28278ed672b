"""Values against hand-derived ones; shapes that do not fit are refused."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sympy import (
    Abs,
    And,
    Eq,
    Equivalent,
    ImmutableMatrix,
    Integer,
    Integral,
    Lt,
    Matrix,
    Or,
    Piecewise,
    Rational,
    Symbol,
    atan,
    atan2,
    cos,
    pi,
    sin,
    sqrt,
    symbols,
)

from omniproof.formula.evaluation import Function, evaluate
from omniproof.transcription.reader import read
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Applied, names

a, b, c, x, theta = symbols("a b c x theta", real=True)
u = ImmutableMatrix([1, 2, 2])
v = ImmutableMatrix([0, 3, 4])
p = ImmutableMatrix([1, 2])
q = ImmutableMatrix([3, 5])
M = ImmutableMatrix([[1, 2], [3, 4]])
MEANINGS: dict[str, Any] = {
    "a": a, "b": b, "c": c, "x": x, "\\theta": theta,
    "u": u, "v": v, "p": p, "q": q, "M": M,
    "D_V": 8 / a,
}  # fmt: skip

VALUES = [
    pytest.param("3.08", Rational(77, 25), id="decimals are exact"),
    pytest.param("0.1 + 0.2", Rational(3, 10), id="no floats on the way"),
    pytest.param(r"30^\circ", pi / 6, id="degrees become radians"),
    pytest.param(r"22.5^\circ", pi / 8, id="decimal degrees"),
    pytest.param("a - b - c", a - b - c, id="differences"),
    pytest.param(r"2\int_{1}^{b} (a + \theta) d\theta", 2 * Integral(a + theta, (theta, 1, b)),
                 id="an integral stays one"),
    pytest.param("-a^2", -(a**2), id="a sign binds less than a power"),
    pytest.param("a/b/c", a / (b * c), id="slashes from the left"),
    pytest.param(r"\tan^{-1}\frac{a}{b} + \sqrt{2}", atan(a / b) + sqrt(2), id="inverse function"),
    pytest.param(r"\operatorname{atan2}(a, b)", atan2(a, b), id="function of two"),
    pytest.param(r"\sin 2\theta \cos \theta", sin(2 * theta) * cos(theta), id="functions"),
    pytest.param(r"\langle u, v \rangle", Integer(14), id="inner product"),
    pytest.param(r"u \cdot v", Integer(14), id="dot of vectors"),
    pytest.param(r"3 \cdot a", 3 * a, id="dot of numbers"),
    pytest.param(r"u \times v", Matrix([2, -4, 3]), id="cross product"),
    pytest.param(r"p \times q", Matrix([0, 0, -1]), id="cross product in the plane"),
    pytest.param(r"(p \times q)_z", Integer(-1), id="its component"),
    pytest.param(r"2 \times a", 2 * a, id="times between numbers"),
    pytest.param(r"\|u\|", Integer(3), id="norm of a vector"),
    pytest.param(r"|a|\|b\|", Abs(a) * Abs(b), id="norm of a number"),
    pytest.param(r"\det[u, v, u \times v]", Integer(29), id="determinant of columns"),
    pytest.param(r"\det M", Integer(-2), id="determinant of a declared matrix"),
    pytest.param(r"\det(M^{-1})", Rational(-1, 2), id="determinant of an inverse"),
    pytest.param("M^{-1}", Matrix([[-2, 1], [Rational(3, 2), -Rational(1, 2)]]), id="inverse"),
    pytest.param("M^{-2}M^2", Matrix([[1, 0], [0, 1]]), id="powers of a matrix"),
    pytest.param("M^T", Matrix([[1, 3], [2, 4]]), id="transpose"),
    pytest.param("p^T q", Integer(13), id="row times column is a number"),
    pytest.param("p q^T", Matrix([[3, 5], [6, 10]]), id="column times row is a matrix"),
    pytest.param("(a, b)^T", Matrix([a, b]), id="a tuple on its side is a column"),
    pytest.param("(a, b)", Matrix([a, b]), id="and so it is as printed"),
    pytest.param("a(1, b)", Matrix([a, a * b]), id="a number times a vector"),
    pytest.param("(p, q)", Matrix([[1, 3], [2, 5]]), id="a tuple of columns is a matrix"),
    pytest.param(r"\begin{bmatrix} p & q \end{bmatrix}", Matrix([[1, 3], [2, 5]]), id="blocks"),
    pytest.param(r"\begin{pmatrix} a & 1 \\ 0 & b \end{pmatrix}(x, 2)",
                 Matrix([a * x + 2, 2 * b]), id="matrix times vector"),
    pytest.param(r"\frac{p}{2}", Matrix([Rational(1, 2), 1]), id="vector over number"),
    pytest.param(r"\{30^\circ, a\}", (pi / 6, a), id="a set is a list"),
    pytest.param("a = b = 2", (a, b, Integer(2)), id="a chain is its sides"),
    pytest.param("= b", (b,), id="a continued chain"),
    pytest.param("a = 1, b = 2", ((a, Integer(1)), (b, Integer(2))), id="equations"),
    pytest.param("a < b", Lt(a, b), id="comparison"),
    pytest.param("0 < a < b", And(Lt(0, a), Lt(a, b)), id="comparisons in a row"),
    pytest.param(r"a < b \text{ or } a = c", Or(Lt(a, b), Eq(a, c)), id="equation in a condition"),
    pytest.param(r"a < b \Leftrightarrow c < x", (Lt(a, b), Lt(c, x)), id="equivalence"),
    pytest.param(r"(a < b \Leftrightarrow c < x) \text{ or } a > 0",
                 Or(Equivalent(Lt(a, b), Lt(c, x)), a > 0), id="equivalence in a statement"),
    pytest.param(r"\{a p \mid |a| < 1\}", (a * p, Lt(Abs(a), 1)), id="set by a condition"),
    pytest.param(r"\begin{cases} a & x > 0 \\ b & x < 0 \end{cases}",
                 Piecewise((a, x > 0), (b, x < 0)), id="cases"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "value"), VALUES)
def test_value(text: str, value: Any) -> None:
    assert evaluate(read(text), MEANINGS, text) == value


def test_the_printed_form_is_not_evaluated() -> None:
    tree = read("-a + a")
    assert evaluate(tree, MEANINGS) == 0
    assert len(names(tree)) == 1
    assert tree == read("-a + a") != read("a - a")


FUNCTIONS = {
    **MEANINGS,
    "g": Function(ImmutableMatrix([a, b]), ("a",)),
    "h": Function(a / b, ("a", "b")),
    "k": Function(Integral(a**2, (a, 0, a)), ("a",)),
    "l": Function(Integral(a**2, (a, 0, b)), ("a",)),
    "turn": lambda times, angle: int(times) * angle,
}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        pytest.param("g(a)", ImmutableMatrix([a, b]), id="printed as it is defined"),
        pytest.param("g", ImmutableMatrix([a, b]), id="without arguments, the same"),
        pytest.param("g(x)", ImmutableMatrix([x, b]), id="another argument"),
        pytest.param(r"g(30^\circ)", ImmutableMatrix([pi / 6, b]), id="a number"),
        pytest.param("g(2a + 1)", ImmutableMatrix([2 * a + 1, b]), id="an expression"),
        pytest.param("h(b, a)", b / a, id="arguments that change places"),
        pytest.param("h(h(x, 2), 3)", x / 6, id="one inside another"),
        pytest.param("k(2b + 1)", Integral(a**2, (a, 0, 2 * b + 1)), id="the end of an integral"),
        pytest.param("l(2b + 1)", Integral(a**2, (a, 0, b)), id="no argument: integrated over"),
        pytest.param("turn(2, -a)", -2 * a, id="an operator is called"),
        pytest.param("c(2a + 1)", c * (2 * a + 1), id="no function: a product"),
    ],
)
def test_arguments_take_the_place_of_what_a_function_is_of(text: str, value: Any) -> None:
    tree = read(text, None, [*"abcx", "turn"], ["turn", *"ghkl"], list("ghkl"))
    assert evaluate(tree, FUNCTIONS, text) == value


@pytest.mark.parametrize(
    ("text", "message", "cure"),
    [
        ("D_V(b)", "`D_V` has arguments, and is declared no function",
         r"say of what `D_V` is a function: `of: ['\theta']` beside its `role`"),
        ("g(a, b)", "expected 1 arguments of `g`", ""),
        ("turn(a)", "`turn` has no such arguments", ""),
        ("g(u)", "expected a number, found a vector of 3", ""),
    ],
)  # fmt: skip
def test_arguments_that_are_refused(text: str, message: str, cure: str) -> None:
    tree = read(text, None, ["a", "b", "u", "turn"], ["D_V", "g", "turn"], ["g"])
    assert isinstance(tree, Applied)
    with pytest.raises(LatexError) as caught:
        evaluate(tree, FUNCTIONS, text)
    assert (caught.value.message, caught.value.cure) == (message, cure)


REFUSED = [
    pytest.param(r"\int_0^1 a dp", [
        "expected a number, found a vector of 2",
        r"    \int_0^1 a dp",
        "                ^"], id="integral over a vector"),
    pytest.param("a + D_W", [
        "unknown symbol `D_W`",
        "    a + D_W",
        "        ~~^",
        "    did you mean `D_V`?"], id="almost a symbol"),
    pytest.param("a + k", [
        "unknown symbol `k`",
        "    a + k",
        "        ^",
        "    declare it among the symbols of the paper"], id="no symbol"),
    pytest.param("a + p", [
        "cannot add a vector of 2 to a number",
        "    a + p",
        "    ~~~~^"], id="number and vector"),
    pytest.param("p + u", [
        "cannot add a vector of 3 to a vector of 2",
        "    p + u",
        "    ~~~~^"], id="vectors of two lengths"),
    pytest.param("M u", [
        "cannot multiply a 2×2 matrix by a vector of 3",
        "    M u",
        "    ~~^"], id="matrix and vector"),
    pytest.param("p q", [
        "cannot multiply a vector of 2 by a vector of 2",
        "    p q",
        "    ~~^"], id="two columns"),
    pytest.param(r"\langle p, u \rangle", [
        "no inner product of a vector of 2 and a vector of 3",
        r"    \langle p, u \rangle",
        "    ~~~~~~~~~~~~~~~~~~~^"], id="inner product"),
    pytest.param(r"2\sin p", [
        "expected a number, found a vector of 2",
        r"    2\sin p",
        "          ^"], id="sine of a vector"),
    pytest.param("a/(b - b)", [
        "cannot divide by 0",
        "    a/(b - b)",
        "      ~~~~~~^"], id="division by zero"),
    pytest.param("(p, p)^{-1}", [
        "cannot invert a singular matrix",
        "    (p, p)^{-1}",
        "    ~~~~~~~~~~^"], id="singular"),
    pytest.param("u^{-1}", [
        "expected a square matrix, found a vector of 3",
        "    u^{-1}",
        "    ^"], id="inverse of a vector"),
    pytest.param("a^T", [
        "cannot transpose a number",
        "    a^T",
        "    ~~^"], id="transposed number"),
    pytest.param("|M|", [
        "expected a number, found a 2×2 matrix",
        "    |M|",
        "     ^"], id="absolute value of a matrix"),
    pytest.param("(p)_z", [
        "no component z in a vector of 2",
        "    (p)_z",
        "    ~~~~^"], id="component"),
    pytest.param("(p, u)", [
        "expected numbers only, or vectors of one length only",
        "    (p, u)",
        "    ~~~~~^"], id="columns of two lengths"),
    pytest.param(r"\begin{matrix} p & u \end{matrix}", [
        "the parts of the matrix do not fit together",
        r"    \begin{matrix} p & u \end{matrix}",
        "    ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~^"], id="blocks"),
    pytest.param(r"\|M\|", [
        "expected a vector, found a 2×2 matrix",
        r"    \|M\|",
        "      ^"], id="norm of a matrix"),
    pytest.param(r"\{a, b\} x", [
        "cannot multiply a list",
        r"    \{a, b\} x",
        "    ~~~~~~~~~^"], id="factor that is a list"),
    pytest.param(r"(a, b, c, x) \times u", [
        "no cross product of a vector of 4 and a vector of 3",
        r"    (a, b, c, x) \times u",
        "    ~~~~~~~~~~~~~~~~~~~~^"], id="cross product in four dimensions"),
    pytest.param("(a - a)^{-1}", [
        "cannot divide by 0",
        "    (a - a)^{-1}",
        "    ~~~~~~~~~~~^"], id="inverse of zero"),
    pytest.param(r"\operatorname{atan2}(a)", [
        "expected two arguments of `atan2`",
        r"    \operatorname{atan2}(a)",
        "    ~~~~~~~~~~~~~~~~~~~~~~^"], id="one argument of two"),
    pytest.param(r"\begin{matrix} \{a, b\} \end{matrix}", [
        "expected a number, found a list",
        r"    \begin{matrix} \{a, b\} \end{matrix}",
        "                   ~~~~~~~^"], id="list in a matrix"),
    pytest.param(r"\sqrt{-1} < 1", [
        "cannot compare numbers that are not real",
        r"    \sqrt{-1} < 1",
        "    ~~~~~~~~~~~~^"], id="imaginary"),
    pytest.param(r"a < 1 \text{ or } b", [
        "expected a statement, found a number",
        r"    a < 1 \text{ or } b",
        "                      ^"], id="half a statement"),
    pytest.param(r"\det[p, q, p]", [
        "expected 3 vectors of 3",
        r"    \det[p, q, p]",
        "    ~~~~~~~~~~~~^"], id="determinant"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "lines"), REFUSED)
def test_message(text: str, lines: list[str]) -> None:
    with pytest.raises(LatexError) as refused:
        evaluate(read(text), MEANINGS, text)
    assert str(refused.value).split("\n") == lines


PIECES = """ a
b 1 2 0 - + = < ( ) [ ] , / u v p M ^T ^2 ^{-1} ^{99} | \\| \\sqrt { } \\sin \\tan 90^\\circ \\pi _z
& \\det \\times \\cdot \\langle \\rangle \\{ \\} \\mid \\frac \\\\ \\begin{pmatrix} \\end{pmatrix}
\\begin{cases} \\end{cases} \\text{or} \\Leftrightarrow \\cos^{-1} \\operatorname{atan2} \\neq
"""


@settings(deadline=None, max_examples=400, suppress_health_check=[HealthCheck.filter_too_much])
@given(st.lists(st.sampled_from(PIECES.split()), min_size=1, max_size=14).map(" ".join))
def test_what_is_read_has_a_value_or_is_refused(text: str) -> None:
    with suppress(LatexError):
        evaluate(read(text), MEANINGS, text)


def test_huge_powers_are_refused() -> None:
    with pytest.raises(LatexError, match="expected a smaller power of a number"):
        evaluate(read("((9^{99999})^{99999})^{99999}"), {})
    with pytest.raises(LatexError, match="expected a power of a matrix up to 8"):
        evaluate(read("M^{9}"), MEANINGS)
    with pytest.raises(LatexError, match="expected a number with at most 1000 digits"):
        evaluate(read("9" * 5_000), {})


def symbolic_matrix(size: int) -> tuple[str, dict[str, Symbol]]:
    names = [[f"a_{{{i}{k}}}" for k in range(size)] for i in range(size)]
    text = r"\\".join(" & ".join(row) for row in names)
    meanings = {name: Symbol(name, real=True) for row in names for name in row}
    return rf"\begin{{pmatrix}}{text}\end{{pmatrix}}", meanings


def test_determinants_of_symbols_have_the_permutations_as_terms() -> None:
    text, meanings = symbolic_matrix(6)
    determinant = evaluate(read(rf"\det {text}"), meanings).expand()
    assert len(determinant.args) == 720
    identity = {s: int(s.name[3] == s.name[4]) for s in determinant.free_symbols}
    assert determinant.subs(identity) == 1


def test_larger_determinants_of_symbols_are_refused() -> None:
    text, meanings = symbolic_matrix(7)
    with pytest.raises(LatexError, match="expected a determinant with at most 6 rows"):
        evaluate(read(rf"\det {text}"), meanings)


@pytest.mark.parametrize("power", [0, 1, 2, 3, -1, -2])
def test_powers_of_a_matrix(power: int) -> None:
    matrix = ImmutableMatrix([[2, 1], [1, 1]])
    assert evaluate(read(f"N^{{{power}}}"), {"N": matrix}) == matrix**power


def test_without_the_source_a_message_shows_the_part() -> None:
    with pytest.raises(LatexError) as refused:
        evaluate(read("b + (a + p)"), MEANINGS)
    assert str(refused.value).split("\n")[1] == "    a + p"


def test_symbols_of_any_assumption_serve() -> None:
    assert (
        evaluate(read("a^2"), {"a": Symbol("a", positive=True)}) == Symbol("a", positive=True) ** 2
    )
