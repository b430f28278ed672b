"""What is read, as which tree; what is refused, with the whole message."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.transcription.model import Notation
from omniproof.transcription.reader import read
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import MAX_DEPTH, MAX_LENGTH, RULES, LatexError
from omniproof.transcription.tree import (
    Absolute,
    Applied,
    Branch,
    Call,
    Cases,
    Chain,
    Comparison,
    Component,
    Cross,
    Degrees,
    Determinant,
    Dot,
    Inner,
    Integral,
    Listing,
    Logic,
    MatrixLiteral,
    Name,
    Negative,
    Node,
    Norm,
    Number,
    Pi,
    Power,
    Product,
    Quotient,
    SetBuilder,
    Sum,
    Transpose,
    Tuple,
    children,
    names,
    walk,
)

A, B, C, X, Y = (Name(letter) for letter in "abcxy")
ONE, TWO, THREE = (Number(digit) for digit in "123")
THETA = Name("\\theta")


def sine(argument: Node) -> Call:
    return Call("sin", argument)


TREES = [
    pytest.param("3.08", Number("3.08"), id="decimals keep their digits"),
    pytest.param(r"30^\circ", Degrees("30"), id="degrees"),
    pytest.param(r"22.5^{\circ}", Degrees("22.5"), id="degrees in braces"),
    pytest.param("30°", Degrees("30"), id="degrees in Unicode"),
    pytest.param(r"\pi", Pi(), id="pi is a number"),
    pytest.param(r"\pi_1", Name("\\pi_1"), id="pi with an index is a symbol"),
    pytest.param("-a + b - c", Sum((Negative(A), B, Negative(C))), id="signs belong to terms"),
    pytest.param("a - (b - c)", Sum((A, Negative(Sum((B, Negative(C)))))), id="brackets"),
    pytest.param("a b c", Product((A, B, C)), id="juxtaposition"),
    pytest.param("a * b", Product((A, B)), id="star"),
    pytest.param(r"a \cdot b", Dot(A, B), id="dot"),
    pytest.param(r"2a \times b c", Product((Cross(Product((TWO, A)), B), C)), id="cross, in order"),
    pytest.param("a/b", Quotient(A, B), id="slash"),
    pytest.param("a b / c", Quotient(Product((A, B)), C), id="a slash divides what was printed"),
    pytest.param(r"\frac{a}{b}c", Product((Quotient(A, B), C)), id="fraction"),
    pytest.param(r"\frac12", Quotient(ONE, TWO), id="fraction without braces, as TeX reads it"),
    pytest.param(r"\frac1{23}", Quotient(ONE, Number("23")), id="fraction with half its braces"),
    pytest.param(r"\dfrac ab", Quotient(A, B), id="fraction of letters"),
    pytest.param("x^2", Power(X, 2), id="power"),
    pytest.param("x^{-12}", Power(X, -12), id="negative power"),
    pytest.param("(a + b)^{2}c", Product((Power(Sum((A, B)), 2), C)), id="power of a bracket"),
    pytest.param(r"\sqrt{x}", Call("sqrt", X), id="root"),
    pytest.param(r"\sqrt2x", Product((Call("sqrt", TWO), X)), id="root without braces"),
    pytest.param(r"\sin x", sine(X), id="function"),
    pytest.param(r"\sin 2\theta", sine(Product((TWO, THETA))), id="juxtaposed argument"),
    pytest.param(
        r"\sin x \cos y", Product((sine(X), Call("cos", Y))), id="an argument ends at a function"
    ),
    pytest.param(
        r"\sin x (a + b)", Product((sine(X), Sum((A, B)))), id="an argument ends at a bracket"
    ),
    pytest.param(r"\sin x + y", Sum((sine(X), Y)), id="an argument ends at a sign"),
    pytest.param(r"\sin(x + y)a", Product((sine(Sum((X, Y))), A)), id="argument in brackets"),
    pytest.param(r"\sin x^2", sine(Power(X, 2)), id="a power in the argument"),
    pytest.param(r"\sin^2 x", Power(sine(X), 2), id="power of a function"),
    pytest.param(r"\tan^{-1} x", Call("arctan", X), id="inverse function"),
    pytest.param(r"\cos^{-1}\frac{a}{b}", Call("arccos", Quotient(A, B)), id="inverse of a ratio"),
    pytest.param(
        r"\sin\frac{1}{2}\theta",
        sine(Product((Quotient(ONE, TWO), THETA))),
        id="a numeric fraction goes on",
    ),
    pytest.param(r"\sin 30^\circ", sine(Degrees("30")), id="function of degrees"),
    pytest.param(r"\operatorname{atan2}(y, x)", Call("atan2", Tuple((Y, X))), id="function of two"),
    pytest.param(r"\mathrm{sin}(x)", sine(X), id="function in roman"),
    pytest.param("(a, b)", Tuple((A, B)), id="tuple"),
    pytest.param("[a, b]^T", Transpose(Tuple((A, B))), id="tuple on its side"),
    pytest.param(r"[a \ b \ c]^t", Transpose(Tuple((A, B, C))), id="blanks in square brackets"),
    pytest.param(r"(a \ b)", Product((A, B)), id="blanks elsewhere"),
    pytest.param(r"\{a, b\}", Tuple((A, B), "set"), id="set"),
    pytest.param(
        r"\{x \mid |a|, |b| \leq 1\}",
        SetBuilder(
            X,
            (Comparison(Absolute(A), "\\leq", ONE), Comparison(Absolute(B), "\\leq", ONE)),
        ),
        id="set by a condition on several",
    ),
    pytest.param(r"\langle a, b \rangle", Inner(A, B), id="inner product"),
    pytest.param(r"\angle P_1OX - a", Sum((Name(r"\angle P_1OX"), Negative(A))), id="angle"),
    pytest.param(r"\|a \times b\|", Norm(Cross(A, B)), id="norm"),
    pytest.param("|a||b|", Product((Absolute(A), Absolute(B))), id="bars side by side"),
    pytest.param(
        "|a|b|c|", Product((Absolute(A), B, Absolute(C))), id="bars open where a factor may"
    ),
    pytest.param(
        "|(|a| - b)c|", Absolute(Product((Sum((Absolute(A), Negative(B))), C))), id="bars"
    ),
    pytest.param(
        "|(a|b|)c|",
        Absolute(Product((Product((A, Absolute(B))), C))),
        id="no bar outside a bracket ends inside",
    ),
    pytest.param(r"\det[a, b, c]", Determinant((A, B, C)), id="determinant of columns"),
    pytest.param(r"\det \mathbf{A}", Name("\\det A"), id="determinant of a symbol is a symbol"),
    pytest.param(r"(\det A)^{-1}", Power(Name("\\det A"), -1), id="its inverse"),
    pytest.param(
        r"\det(\mathbf{A}^{-1})", Call("det", Power(Name("A"), -1)), id="determinant of a matrix"
    ),
    pytest.param(r"(a \times b)_z", Component(Cross(A, B), "z"), id="component"),
    pytest.param(
        r"\begin{pmatrix} a & b \\ c & -1 \\ \end{pmatrix}",
        MatrixLiteral(((A, B), (C, Negative(ONE)))),
        id="matrix, last line ended",
    ),
    pytest.param(r"\binom{a}{b}", MatrixLiteral(((A,), (B,))), id="column of two"),
    pytest.param(r"\begin{array}{cc} a & b \end{array}", MatrixLiteral(((A, B),)), id="array"),
    pytest.param(
        r"\begin{cases} a & x > 1 \\ b & x < 1 \end{cases}",
        Cases((Branch(A, Comparison(X, ">", ONE)), Branch(B, Comparison(X, "<", ONE)))),
        id="cases",
    ),
    pytest.param(
        r"\begin{cases} a \\ \quad [x > 1] \\ b \\ \quad [x < 1] \end{cases}",
        Cases((Branch(A, Comparison(X, ">", ONE)), Branch(B, Comparison(X, "<", ONE)))),
        id="cases with the condition on a line of its own",
    ),
    pytest.param("a = b = c", Chain((A, B, C)), id="chain"),
    pytest.param("= b", Chain((B,), continued=True), id="continued display"),
    pytest.param("&= b = c", Chain((B, C), continued=True), id="continued line"),
    pytest.param(r"a &= b \\ &= c", Chain((A, B, C)), id="chain over two lines"),
    pytest.param(r"a &= b \\ &\quad + c", Chain((A, Sum((B, C)))), id="sum over two lines"),
    pytest.param(r"a = b \\ + c", Chain((A, Sum((B, C)))), id="a line that starts with plus"),
    pytest.param(
        r"a = b \\ -c = x",
        Listing((Chain((A, B)), Chain((Negative(C), X)))),
        id="a line that starts with minus",
    ),
    pytest.param(
        r"\begin{aligned} a &= b, \\ x &= y \end{aligned}",
        Listing((Chain((A, B)), Chain((X, Y)))),
        id="equations below each other",
    ),
    pytest.param("a = 1, b = 2.", Listing((Chain((A, ONE)), Chain((B, TWO)))), id="equations"),
    pytest.param("a < b", Comparison(A, "<", B), id="comparison"),
    pytest.param("a ≤ b", Comparison(A, "\\leq", B), id="comparison in Unicode"),
    pytest.param(
        r"1 \leq a < b",
        Logic("and", (Comparison(ONE, "\\leq", A), Comparison(A, "<", B))),
        id="comparisons in a row",
    ),
    pytest.param(
        r"\{a < b \text{ and } x > y\} \text{ or } a > b",
        Logic(
            "or",
            (
                Logic("and", (Comparison(A, "<", B), Comparison(X, ">", Y))),
                Comparison(A, ">", B),
            ),
        ),
        id="and binds more strongly than or",
    ),
    pytest.param(
        r"\Leftrightarrow a b < 1",
        Chain((Comparison(Product((A, B)), "<", ONE),), "\\Leftrightarrow", continued=True),
        id="equivalent to an earlier display",
    ),
    pytest.param(
        "a = b < c",
        Logic("and", (Chain((A, B)), Comparison(B, "<", C))),
        id="equation and comparison",
    ),
    pytest.param(
        r"a < b \\ \Leftrightarrow b > a",
        Chain((Comparison(A, "<", B), Comparison(B, ">", A)), "\\Leftrightarrow"),
        id="equivalence over two lines",
    ),
    pytest.param(
        r"a < b \\ &= c",
        Listing((Comparison(A, "<", B), Chain((C,), continued=True))),
        id="a line that goes on with what is not there",
    ),
    pytest.param(r"a \\ = c", Chain((A, C)), id="a side on a line of its own"),
    pytest.param(r"\text{or } a < b", Logic("or", (Comparison(A, "<", B),)), id="second half"),
    pytest.param(r"A^{\top}", Transpose(Name("A")), id="another sign for transposition"),
    pytest.param(r"\det A_1^2", Power(Name("\\det A_1"), 2), id="determinant with an index"),
    pytest.param(
        r"\lvert a \rvert \left\|\|b\|c\right\|",
        Product((Absolute(A), Norm(Product((Norm(B), C))))),
        id="bars with a direction",
    ),
    pytest.param(r"a = b \quad (6)", Chain((A, B)), id="the number of a display is read over"),
    pytest.param(r"a = b. \quad (\text{B},3)", Chain((A, B)), id="a number of an appendix"),
    pytest.param(r"a = b, \tag{4-1}", Chain((A, B)), id="a tag"),
    pytest.param(r"8 / a \text{ [m/s]}^3", Quotient(Number("8"), A), id="a unit is read over"),
    pytest.param(r"\left\{ a, \, b \right\}", Tuple((A, B), "set"), id="sized brackets"),
]


@pytest.mark.parametrize(("text", "tree"), TREES)
def test_tree(text: str, tree: Node) -> None:
    assert read(text) == tree


WITH_SYMBOLS = [
    pytest.param("v_k^T", Name("v_k^T"), id="a declared superscript is part of the name"),
    pytest.param("u_k^T", Transpose(Name("u_k")), id="otherwise T transposes"),
    pytest.param("v_k^T^2", Power(Name("v_k^T"), 2), id="power of such a symbol"),
    pytest.param("T_B^{C_1}", Name("T_B^{C_1}"), id="superscript with an index"),
    pytest.param(r"D_V(\theta)", Applied("D_V", (THETA,)), id="function notation"),
    pytest.param(
        r"D_V(\theta, -\frac{\pi}{3})",
        Applied("D_V", (THETA, Negative(Quotient(Pi(), THREE)))),
        id="function of two",
    ),
    pytest.param("D_V(a + b)", Product((Name("D_V"), Sum((A, B)))), id="a sum is a factor"),
    pytest.param(
        r"L(a, b)^T", Product((Name("L"), Transpose(Tuple((A, B))))), id="a variable times a vector"
    ),
    pytest.param("Rot(x, y)", Applied("Rot", (X, Y)), id="declared words"),
    pytest.param(r"\mathrm{Rot}(x, y)", Applied("Rot", (X, Y)), id="declared words in a font"),
    pytest.param("Rt", Product((Name("R"), Name("t"))), id="other letters are factors"),
]


@pytest.mark.parametrize(("text", "tree"), WITH_SYMBOLS)
def test_declared_symbols_decide(text: str, tree: Node) -> None:
    assert read(text, Notation(), ["v_k^T", "T_B^{C_1}", "L"], ["D_V", "Rot"]) == tree


ZERO, T = Number("0"), Name("t")
INTEGRALS = [
    pytest.param(r"\int_0^t a dt", Integral(ZERO, T, A, T), id="plain"),
    pytest.param(r"\int_{0}^{t} a b + c\, dt", Integral(ZERO, T, Sum((Product((A, B)), C)), T),
                 id="a sum up to the variable"),
    pytest.param(r"2 \int_0^1 \sin x dx b", Product((TWO, Integral(ZERO, ONE, sine(X), X), B)),
                 id="the variable ends the argument of a function, and the integral"),
    pytest.param(r"\int_0^t \left\{ a \cos\left( \int_{0}^{t} (b) dt \right) \right\} dt",
                 Integral(ZERO, T, Product((A, Call("cos", Integral(ZERO, T, B, T)))), T),
                 id="one inside another"),
    pytest.param(r"d \int_0^t a d\theta", Product((Name("d"), Integral(ZERO, T, A, THETA))),
                 id="outside, d is a symbol"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "tree"), INTEGRALS)
def test_integrals(text: str, tree: Node) -> None:
    assert read(text) == tree


NOTATIONS = [
    pytest.param(r"\cos{(90 + \psi)}", Notation(angles="degrees"),
                 Call("cos", Sum((Degrees("90"), Name("\\psi")))), id="a bare number in degrees"),
    pytest.param(r"\sin(\psi - 90)", Notation(angles="degrees"),
                 sine(Sum((Name("\\psi"), Negative(Degrees("90"))))), id="less so many degrees"),
    pytest.param(r"\sin 2\psi", Notation(angles="degrees"),
                 sine(Product((TWO, Name("\\psi")))), id="a factor is no angle"),
    pytest.param("1/3L", Notation(slash="first"), Product((Quotient(ONE, THREE), Name("L"))),
                 id="a slash divides by the first factor"),
    pytest.param("1/3L", Notation(slash="all"), Quotient(ONE, Product((THREE, Name("L")))),
                 id="a slash divides by all that follows"),
    pytest.param(r"Ls\phi \omega", Notation(functions={"s": "sin"}),
                 Product((Name("L"), sine(Name("\\phi")), Name("\\omega"))),
                 id="a shorthand takes one symbol"),
    pytest.param("s(a + b)", Notation(functions={"s": "sin"}), sine(Sum((A, B))),
                 id="a shorthand takes a bracket"),
    pytest.param("s + 1", Notation(functions={"s": "sin"}), Sum((Name("s"), ONE)),
                 id="the letter alone is a symbol"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "notation", "tree"), NOTATIONS)
def test_notation_settles(text: str, notation: Notation, tree: Node) -> None:
    assert read(text, notation) == tree


SYMBOLS = [
    pytest.param(r"\mathbf{a}_{1}", "a_1", id="fonts and needless braces are dropped"),
    pytest.param(r"\boldsymbol \omega", "\\omega", id="font without braces"),
    pytest.param(r"\hat{\mathbf{a}}_1", r"\hat{a}_1", id="accents stay"),
    pytest.param(r"\dot\phi", r"\dot{\phi}", id="accent without braces"),
    pytest.param(r"\widetilde{a}_{1,2}", r"\widetilde{a}_{1,2}", id="index of two numbers"),
    pytest.param(r"\overline{\mathbf{OH}}", r"\overline{OH}", id="word under an accent"),
    pytest.param("a'_k", "a'_k", id="prime before the index"),
    pytest.param("a_k^{\\prime}", "a'_k", id="prime as a superscript"),
    pytest.param(r"a^\prime", "a'", id="prime without braces"),
    pytest.param(r"a_\mathbf{b}", "a_b", id="font in an index"),
    pytest.param(r"v^{S}", "v^S", id="superscript"),
    pytest.param(r"D_{\text{Vol}}", "D_{Vol}", id="words as index"),
    pytest.param(r"f_{A^{-1}}'", "f'_{A^{-1}}", id="formula as index"),
    pytest.param(r"\mathbb{T}_{\mathcal{W}m}", "T_{Wm}", id="fonts in an index"),
    pytest.param(r"x_{\alpha k}", r"x_{\alpha k}", id="a command keeps its blank"),
    pytest.param(r"\det \mathbf{A}", "\\det A", id="determinant"),
    pytest.param("α_1", "\\alpha_1", id="Unicode"),
    pytest.param("Rot", "Rot", id="word"),
]


@pytest.mark.parametrize(("latex", "name"), SYMBOLS)
def test_symbol_name(latex: str, name: str) -> None:
    assert symbol_name(latex) == name
    assert symbol_name(name) == name, "the canonical spelling is its own"


SLASH = "write `\\frac{…}{…}`, or settle it with `slash: first` or `slash: all` in the notation"
REFUSED = [
    pytest.param("", [
        "expected a number, a symbol or a bracket, found the end of the formula",
        "    ",
        "    ^"], id="nothing"),
    pytest.param("__import__('os')", [
        "expected a number, a symbol or a bracket, found `_`",
        "    __import__('os')",
        "    ^"], id="code"),
    pytest.param("a = b +", [
        "expected a number, a symbol or a bracket, found the end of the formula",
        "    a = b +",
        "           ^"], id="half a sum"),
    pytest.param("(a + b", [
        "expected `)` to close `(`, found the end of the formula",
        "    (a + b",
        "    ~~~~~~^",
        "    balance the brackets"], id="open bracket"),
    pytest.param("(a + b] c", [
        "expected `)` to close `(`, found `]`",
        "    (a + b] c",
        "    ~~~~~~^",
        "    balance the brackets"], id="wrong bracket"),
    pytest.param(r"\frac{a}{b", [
        "expected `}` to close `{`, found the end of the formula",
        r"    \frac{a}{b",
        "            ~~^",
        "    balance the brackets"], id="open brace"),
    pytest.param("a}", [
        "expected an operator or the end of the formula, found `}`",
        "    a}",
        "     ^"], id="closed without being opened"),
    pytest.param("|a", [
        "expected `|` to close `|`, found the end of the formula",
        "    |a",
        "    ~~^",
        "    balance the brackets"], id="one bar"),
    pytest.param("1/3L", [
        "it is not clear what the slash divides by",
        "    1/3L",
        "    ~~~^",
        "    " + SLASH], id="slash before a product"),
    pytest.param(r"\sin x/2", [
        "the slash may divide the function or its argument",
        r"    \sin x/2",
        "    ~~~~~~~^",
        "    " + SLASH], id="slash after a function"),
    pytest.param(r"\sin 2(a - b)", [
        r"expected the end of the argument of `\sin`, found `(`",
        r"    \sin 2(a - b)",
        "          ^",
        r"    write `\sin(…)`"], id="function of a number and a bracket"),
    pytest.param(r"\sin\frac{a}{b}c", [
        r"it is not clear where the argument of `\sin` ends",
        r"    \sin\frac{a}{b}c",
        "        ~~~~~~~~~~^",
        r"    write `\sin(…)`"], id="function of a fraction and a symbol"),
    pytest.param(r"\sin -x", [
        r"expected the argument of `\sin`, found `-`",
        r"    \sin -x",
        "         ^",
        r"    write `\sin(…)`"], id="function of a sign"),
    pytest.param("2 sin x", [
        "`sin` is a product of letters",
        "    2 sin x",
        "      ~~^",
        r"    write `\sin` for the function"], id="function without backslash"),
    pytest.param("f(x)", [
        "`f(x)` may be a function or a product",
        "    f(x)",
        "    ~~~^",
        "    declare `f` with `role: quantity`, or drop the brackets for a product"],
        id="function of an unknown"),
    pytest.param("x^n", [
        "`^n` is neither a whole power nor part of a declared symbol",
        "    x^n",
        "     ~^",
        "    declare the symbol `x^n`, or write a whole number as the power"],
        id="symbolic power"),
    pytest.param("x^{1/2}", [
        "expected `}` to close the script, found `/`",
        "    x^{1/2}",
        "        ^"], id="fractional power"),
    pytest.param(r"\sin^{--1} x", [
        "expected a whole power",
        r"    \sin^{--1} x",
        "         ~~~~^",
        r"    write roots with `\sqrt`"], id="power with two signs"),
    pytest.param(r"2 \mathbf{AB}", [
        "`AB` may be one symbol or a product",
        r"    2 \mathbf{AB}",
        "      ~~~~~~~~~^",
        r"    declare `AB`, or give each letter its own `\mathbf`"], id="two letters in one font"),
    pytest.param("L = 1,000", [
        "expected a number without zeros before it",
        "    L = 1,000",
        "          ~~^",
        "    write thousands without a comma"], id="comma of thousands"),
    pytest.param("a_1_2", [
        "expected one subscript, found `_`",
        "    a_1_2",
        "       ^",
        "    write both in one pair of braces"], id="two indices"),
    pytest.param("a_{}", [
        "an empty script",
        "    a_{}",
        "      ~^",
        "    leave it out"], id="empty index"),
    pytest.param(r"\sqrt[3]{x}", [
        "expected a square root, found `[`",
        r"    \sqrt[3]{x}",
        "         ^",
        "    only square roots are read"], id="cube root"),
    pytest.param(r"\operatorname{lcm}(x)", [
        "expected a function that is read, found `{`",
        r"    \operatorname{lcm}(x)",
        "                 ^",
        "    write one of acos, arccos, arcsin, arctan, asin, atan, atan2, cos, cosh, cot, csc, "
            "exp, ln, max, min, sec, sgn, sign, sin, sinh, tan, tanh"],
        id="unknown function"),
    pytest.param(r"\cot^{-1} x", [
        "no inverse of `cot` is read",
        r"    \cot^{-1} x",
        "    ~~~~~~~~^",
        "    write it by `\\arctan`"], id="inverse that has no name"),
    pytest.param(r"\{a, b \mid c < 1\}", [
        r"expected one element before `\mid`",
        r"    \{a, b \mid c < 1\}",
        "    ~~~~~~~~~~~~~~~~~~^",
        "    put it into brackets"], id="set of two by a condition"),
    pytest.param(r"\left| a )", [
        r"expected `\right|`, found `)`",
        r"    \left| a )",
        "             ^",
        "    balance the bars"], id="bars of two kinds"),
    pytest.param(r"\langle a, b, c \rangle", [
        "expected two vectors in an inner product",
        r"    \langle a, b, c \rangle",
        "    ~~~~~~~~~~~~~~~~~~~~~~^",
        r"    write `\langle a, b \rangle`"], id="inner product of three"),
    pytest.param("(a)_{left}", [
        "expected a component: x, y, z or a number",
        "    (a)_{left}",
        "    ~~~~~~~~~^"], id="component of no name"),
    pytest.param("(x)^{0.5}", [
        "expected a whole power",
        "    (x)^{0.5}",
        "        ~~~~^",
        r"    write roots with `\sqrt`"], id="decimal power"),
    pytest.param("a_12", [
        "expected one digit, found `12`",
        "    a_12",
        "      ~^",
        "    write {12} with braces"], id="index of two digits"),
    pytest.param(r"\theta^\circ", [
        "expected degrees after a number only, found `^`",
        r"    \theta^\circ",
        "          ^",
        r"    write `\theta \cdot 1^\circ`"], id="degrees of a symbol"),
    pytest.param("2 3", [
        "expected a sign between two numbers, found `3`",
        "    2 3",
        "      ^",
        r"    write `\cdot` between them"], id="two numbers"),
    pytest.param(r"a \cdot -b", [
        "expected a number, a symbol or a bracket, found `-`",
        r"    a \cdot -b",
        "            ^",
        "    put the signed part into brackets"], id="two signs"),
    pytest.param("(a = b) c", [
        "expected a value, found a statement",
        "    (a = b) c",
        "    ~~~~~~~~^",
        "    state it in a claim of its own"], id="an equation as a factor"),
    pytest.param(r"\begin{pmatrix} a & b \\ c \end{pmatrix}", [
        "expected 2 entries in row 2, found 1",
        r"    \begin{pmatrix} a & b \\ c \end{pmatrix}",
        "                             ^",
        "    give every row the same number of entries"], id="ragged matrix"),
    pytest.param(r"\begin{pmatrix} a & b", [
        r"expected `\end{pmatrix}`, found the end of the formula",
        r"    \begin{pmatrix} a & b",
        "                         ^"], id="open matrix"),
    pytest.param(r"\begin{tikz} a \end{tikz}", [
        "the environment `tikz` is not read",
        r"    \begin{tikz} a \end{tikz}",
        "    ~~~~~~~~~~~^",
        "    write one of array, bmatrix, cases, matrix, pmatrix, smallmatrix"],
        id="unknown environment"),
    pytest.param(r"2 \thta", [
        r"`\thta` is not read",
        r"    2 \thta",
        "      ~~~~^",
        r"    did you mean `\theta`?"], id="misspelt command"),
    pytest.param(r"\square \mathbf{R}", [
        r"`\square` is not read",
        r"    \square \mathbf{R}",
        "    ~~~~~~^",
        "    leave it out of the formula"], id="shape"),
    pytest.param(r"\int a dt", [
        "expected the lower limit of the integral, found `a`",
        r"    \int a dt",
        "         ^",
        r"    write `\int_{0}^{t} … dt`"], id="integral without limits"),
    pytest.param(r"\int_0 a dt", [
        "expected the upper limit of the integral, found `a`",
        r"    \int_0 a dt",
        "           ^",
        r"    write `\int_{0}^{t} … dt`"], id="integral without upper limit"),
    pytest.param(r"\int_0^t a + b", [
        "expected the variable of the integral, found the end of the formula",
        r"    \int_0^t a + b",
        "                  ^",
        r"    write `\int_{0}^{t} … dt`"], id="integral without variable"),
    pytest.param(r"\int_0^t a = b dt", [
        "expected the variable of the integral, found `=`",
        r"    \int_0^t a = b dt",
        "               ^",
        r"    write `\int_{0}^{t} … dt`"], id="integral of an equation"),
    pytest.param("a § b", [
        "'§' is no part of a formula",
        "    a § b",
        "      ^",
        "    write it in LaTeX"], id="sign of a text"),
    pytest.param(r"\text{hello}", [
        r"expected a number, a symbol or a bracket, found `\text{hello}`",
        r"    \text{hello}",
        "    ~~~~~~~~~~~^"], id="words"),
    pytest.param("a\n= § + b\n", [
        "'§' is no part of a formula",
        "    a = § + b ",
        "        ^",
        "    write it in LaTeX"], id="line breaks are shown as blanks"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "lines"), REFUSED)
def test_message(text: str, lines: list[str]) -> None:
    with pytest.raises(LatexError) as refused:
        read(text)
    assert str(refused.value).split("\n") == lines
    assert refused.value.source == text


def test_power_behind_a_shorthand() -> None:
    with pytest.raises(LatexError) as refused:
        read(r"s\phi^2", Notation(functions={"s": "sin"}))
    assert str(refused.value).split("\n") == [
        "expected brackets around the argument, found `^`",
        r"    s\phi^2",
        "         ^",
        "    write `s(…)`",
    ]


NOT_SYMBOLS = [
    pytest.param("a b", "expected one symbol, found `b`", id="two"),
    pytest.param("a + b", "expected one symbol, found `+`", id="sum"),
    pytest.param("x^2", "expected one symbol, found `^`", id="power"),
    pytest.param("3", "expected a symbol, found `3`", id="number"),
]


@pytest.mark.parametrize(("latex", "message"), NOT_SYMBOLS)
def test_no_symbol(latex: str, message: str) -> None:
    with pytest.raises(LatexError) as refused:
        symbol_name(latex)
    assert refused.value.message == message


def test_the_excerpt_of_a_long_formula_holds_the_fault() -> None:
    with pytest.raises(LatexError) as refused:
        read("a + " * 50 + "§ + b" * 50)
    _, excerpt, marker, _ = str(refused.value).split("\n")
    assert len(excerpt.removeprefix("    ")) == 70
    assert excerpt[marker.index("^")] == "§"


DEEP = [
    pytest.param("(", ")", 1, id="brackets"),
    pytest.param("{", "}", 1, id="braces"),
    pytest.param("\\{", "\\}", 1, id="sets"),
    pytest.param("a(b + ", ")", 1, id="products"),
    pytest.param("\\begin{matrix}", "\\end{matrix}", 1, id="matrices"),
    pytest.param("\\sqrt{", "}", 2, id="roots"),
    pytest.param("\\frac{", "}{2}", 2, id="fractions"),
    pytest.param("\\sin(", ")", 2, id="functions"),
]


@pytest.mark.parametrize(("opening", "closing", "levels"), DEEP)
def test_depth(opening: str, closing: str, levels: int) -> None:
    deepest = (MAX_DEPTH - 1) // levels
    assert names(read(opening * deepest + "x" + closing * deepest)) >= {"x"}
    for depth in (MAX_DEPTH + 1, 300):
        with pytest.raises(LatexError, match=f"at most {MAX_DEPTH} "):
            read(opening * depth + "x" + closing * depth)


HOSTILE = [
    pytest.param("|" * MAX_LENGTH, id="bars"),
    pytest.param(r"\sqrt" * (MAX_LENGTH // 5), id="roots of roots"),
    pytest.param("-" * MAX_LENGTH, id="signs"),
    pytest.param("a(" * (MAX_LENGTH // 2), id="brackets that never close"),
    pytest.param(r"\text{" * (MAX_LENGTH // 6), id="texts that never end"),
    pytest.param("a'" * (MAX_LENGTH // 2) + "(", id="primes"),
    pytest.param("(" * 1_000_000, id="a million characters"),
]


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_text_is_answered_briefly(text: str) -> None:
    with pytest.raises(LatexError) as refused:
        read(text)
    assert len(str(refused.value)) < 500


PIECES = [
    "a", "x_1", "2", "3.5", "+", "-", "=", "<", "(", ")", "[", "]", "{", "}", "|", "^", "_", "&",
    ",", "/", "'", " ", "\\{", "\\}", "\\|", "\\\\", "\\ ", "\\sin", "\\frac", "\\sqrt", "\\det",
    "\\hat", "\\mathbf", "\\theta", "\\circ", "^2", "^T", "\\cdot", "\\times", "\\langle",
    "\\rangle", "\\begin{pmatrix}", "\\end{pmatrix}", "\\begin{cases}", "\\end{cases}",
    "\\text{ and }", "\\text{ or }", "\\mid", "\\Leftrightarrow", "\\left", "\\quad (6)", "\\binom",
    "\\operatorname{atan2}", "\\pi", "30^\\circ", "s", "D", "é", "\x00",
]  # fmt: skip
TEXTS = st.one_of(st.text(max_size=60), st.lists(st.sampled_from(PIECES), max_size=25).map("".join))


def attempt(text: str) -> Node | LatexError:
    """Read a text for a paper with a few conventions; any other exception is a failure."""
    try:
        return read(text, Notation(functions={"s": "sin"}), ["a", "x_1"], ["D"])
    except LatexError as error:
        return error


@settings(deadline=None, max_examples=400)
@given(TEXTS)
def test_any_text_is_read_or_refused(text: str) -> None:
    answer = attempt(text)
    start, end = answer.span
    assert 0 <= start <= end <= len(text) + isinstance(answer, LatexError)
    if isinstance(answer, LatexError):
        assert len(str(answer).split("\n")[1]) <= 74


@settings(deadline=None, max_examples=200)
@given(TEXTS)
def test_parts_lie_in_their_whole(text: str) -> None:
    answer = attempt(text)
    for node in walk(answer) if isinstance(answer, Node) else ():
        for child in children(node):
            assert node.span[0] <= child.span[0]
            assert child.span[1] <= node.span[1]


def test_places_of_nodes() -> None:
    text = r"x + \frac{a}{b}(c - 1)"
    tree = read(text)
    assert isinstance(tree, Sum)
    product = tree.terms[1]
    assert isinstance(product, Product)
    spans = [text[start:end] for start, end in (f.span for f in product.factors)]
    assert spans == [r"\frac{a}{b}", "(c - 1)"]
    assert text[slice(*product.span)] == r"\frac{a}{b}(c - 1)"


def test_every_token_rule_has_a_name_of_its_own() -> None:
    assert len({kind for kind, _ in RULES}) == len(RULES)
