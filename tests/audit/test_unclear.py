"""What a formula that stands alone does not tell: refused, with the place and the cure."""

from __future__ import annotations

import pytest

from omniproof.audit.check import Finding, check
from omniproof.audit.setting import Assumptions

NONE = Assumptions()
DERIVATIVES = "derivatives are not read: write out what they are"
ENTRIES = "    write the entries of vectors and matrices out"

REFUSED = [
    pytest.param("e = 1", NONE, [
        "`e` may be Euler's number or a symbol",
        "    e = 1",
        "    ^",
        "    give a symbol an index: `e_1`; exponentials and complex numbers are not read"],
        id="Euler's number"),
    pytest.param("2 i = 1", NONE, [
        "`i` may be the imaginary unit or a symbol",
        "    2 i = 1",
        "      ^",
        "    give a symbol an index: `i_1`; exponentials and complex numbers are not read"],
        id="imaginary unit"),
    pytest.param(r"\det A = 1", NONE, [
        r"`\det A` needs the entries of the matrix",
        r"    \det A = 1",
        "    ~~~~~^",
        "    write the matrix out"], id="matrix without entries"),
    pytest.param("c 2x = c(x)", Assumptions(functions={"c": "cos"}), [
        r"`c` stands for `\cos`, and here for a symbol",
        "    c 2x = c(x)",
        "    ^",
        "    write `c(…)` for the function"], id="letter of a function"),
    pytest.param(r"\frac{dy}{dx} = \frac{y}{x}", NONE, [
        r"`\frac{dy}{dx}` may be a derivative or a quotient",
        r"    \frac{dy}{dx} = \frac{y}{x}",
        "    ~~~~~~~~~~~~^",
        rf"    {DERIVATIVES}; write `d \cdot x` for a product"], id="derivative"),
    pytest.param(r"\frac{\mathrm{d}}{\mathrm{d}t} t = 1", NONE, [
        r"`\frac{\mathrm{d}}{\mathrm{d}t}` may be a derivative or a quotient",
        r"    \frac{\mathrm{d}}{\mathrm{d}t} t = 1",
        "    ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~^",
        rf"    {DERIVATIVES}; write `d \cdot x` for a product"], id="upright derivative"),
    pytest.param(r"\frac{\partial f}{\partial x} = 2x", NONE, [
        r"`\partial` is not read",
        r"    \frac{\partial f}{\partial x} = 2x",
        "          ~~~~~~~^",
        f"    {DERIVATIVES}"], id="partial derivative"),
    pytest.param("dy = 2x dx", NONE, [
        "`dy` may be a differential or a product",
        "    dy = 2x dx",
        "    ~^",
        r"    write `d \cdot y` for the product"], id="differential"),
    pytest.param(r"\mathrm{d}(x + y) = 0", NONE, [
        r"`\mathrm{d}` is an operator",
        r"    \mathrm{d}(x + y) = 0",
        "    ~~~~~~~~~^",
        f"    {DERIVATIVES}"], id="operator"),
    pytest.param(r"\Delta x = x \Delta", NONE, [
        r"`\Delta x` may be a difference or a product",
        r"    \Delta x = x \Delta",
        "    ~~~~~~~^",
        r"    write `\Delta \cdot …` for the product"], id="difference"),
    pytest.param(r"\vec a \times \vec b = \vec b \times \vec a", NONE, [
        r"`\vec a \times \vec b` may be of vectors or matrices, which do not commute",
        r"    \vec a \times \vec b = \vec b \times \vec a",
        "    ~~~~~~~~~~~~~~~~~~~^",
        rf"{ENTRIES}; write `\cdot` between numbers"], id="vectors by name"),
    pytest.param(r"R^T R = I", NONE, [
        "`R^T R` may be of vectors or matrices, which do not commute",
        "    R^T R = I",
        "    ~~~~^", ENTRIES], id="matrix by its transposed"),
    pytest.param(r"\|u v\| = \|u\| \|v\|", NONE, [
        r"`\|u v\|` may be of vectors or matrices, which do not commute",
        r"    \|u v\| = \|u\| \|v\|",
        "    ~~~~~~^", ENTRIES], id="vector by its norm"),
    pytest.param(r"\mathbf a - a = 0", NONE, [
        r"`\mathbf a` and `a` would be read as one symbol",
        r"    \mathbf a - a = 0",
        "                ^",
        "    give one another letter"], id="two fonts"),
    pytest.param(r"2\overrightarrow{AB} = -2\overrightarrow{BA}", NONE, [
        r"what `\overrightarrow{AB}` has to do with other points is not known",
        r"    2\overrightarrow{AB} = -2\overrightarrow{BA}",
        "     ~~~~~~~~~~~~~~~~~~^",
        "    give it a letter of its own"], id="points"),
    pytest.param(r"2\mathrm{d}W = 2F\,\mathrm{d}s", NONE, [
        r"what `\mathrm{d}W` has to do with other differentials is not known",
        r"    2\mathrm{d}W = 2F\,\mathrm{d}s",
        "     ~~~~~~~~~~^",
        f"    {DERIVATIVES}"], id="differentials"),
    pytest.param("BM = 2BF", NONE, [
        "`BM` may be one symbol or a product",
        "    BM = 2BF",
        "    ~^",
        "    write `B M` for the product, a letter with an index for one symbol"], id="segment"),
    pytest.param(r"R^{-1}(\theta) = \frac{\theta}{R}", NONE, [
        r"`R^{-1}(\theta)` may be a function or a product",
        r"    R^{-1}(\theta) = \frac{\theta}{R}",
        "    ~~~~~~~~~~~~~^",
        r"    write `R^{-1} \cdot (\theta)` for the product"], id="inverse function"),
    pytest.param("f(x + 1) = x + 1", NONE, [
        "`f(x + 1)` may be a function or a product",
        "    f(x + 1) = x + 1",
        "    ~~~~~~~^",
        r"    write `f \cdot (x + 1)` for the product"], id="function of a sum"),
    pytest.param(r"\cos{a + b} = \cos a + b", NONE, [
        r"braces do not print: it is not clear what `\cos` is taken of",
        r"    \cos{a + b} = \cos a + b",
        "    ~~~~~~~~~~^",
        r"    write `\cos(…)`"], id="braces"),
    pytest.param("x1 + x2 = x2", NONE, [
        "an index or a factor stands behind the symbol",
        "    x1 + x2 = x2",
        "    ~^",
        "    write `x_1` for an index, or the number first"], id="index on the line"),
    pytest.param("1E-3 = 0.001", NONE, [
        "expected a number without `e`, found `E`",
        "    1E-3 = 0.001",
        "     ^",
        r"    write `\cdot 10^{…}` for a power of ten"], id="number with a power of ten"),
    pytest.param("sqrt(x + 1) = 1", NONE, [
        "`sqrt` is a product of letters",
        "    sqrt(x + 1) = 1",
        "    ~~~^",
        r"    write `\sqrt{…}` for the root"], id="root in letters"),
    pytest.param(r"1/2 \cdot x = x", NONE, [
        "it is not clear what the slash divides by",
        r"    1/2 \cdot x = x",
        "    ~~~~~~~~^",
        r"    write `\frac{…}{…}`, or settle it with `--slash first` or `--slash all`"],
        id="slash before a dot"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "assumptions", "lines"), REFUSED)
def test_refused_with_place_and_cure(text, assumptions, lines):
    found = check(text, assumptions)
    assert found.verdict is Finding.INVALID
    assert found.message.splitlines() == lines
