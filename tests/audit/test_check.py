"""One statement: its verdict, the step and entry that fails, its repair, what cannot be read."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.audit.check import CheckResult, Finding, check
from omniproof.audit.setting import Assumptions
from omniproof.decide.answer import DisagreementError

NONE = Assumptions()
ROTATION = r"\begin{pmatrix}\cos a & -\sin a \\ \sin a & \cos a\end{pmatrix}"


@pytest.mark.parametrize(
    ("text", "assumptions"),
    [
        pytest.param(r"\sin 2\theta = 2\sin\theta\cos\theta", NONE, id="identity"),
        pytest.param("a + b = b + a = 2 b + a - b", NONE, id="chain"),
        pytest.param("a + a = 2a, b - b = 0", NONE, id="list"),
        pytest.param(rf"{ROTATION}^T {ROTATION} = \begin{{pmatrix}}1&0\\0&1\end{{pmatrix}}", NONE,
                     id="matrices"),
        pytest.param(r"(1, 2, 3) \times (0, 0, 1) = (2, -1, 0)", NONE, id="vectors"),
        pytest.param(r"\sqrt{L^2} = L", Assumptions(positive=("L",)), id="positive"),
        pytest.param(r"|\cos\theta| = \cos\theta",
                     Assumptions(between=(r"0 < \theta < 90^\circ",)), id="range"),
        pytest.param(r"\sin\theta > 0", Assumptions(between=(r"0 < \theta < \pi",)), id="relation"),
        pytest.param(r"0 < \sin\theta < 1", Assumptions(between=(r"0 < \theta < 90^\circ",)),
                     id="chain of relations"),
        pytest.param(r"-1 \leq \cos\theta \leq 1", NONE, id="for all angles"),
        pytest.param("c(2x) = c(x)^2 - s(x)^2", Assumptions(functions={"c": "cos", "s": "sin"}),
                     id="short functions"),
        pytest.param(r"1/2x = \frac{1}{2x}", Assumptions(slash="all"), id="slash by all"),
        pytest.param(r"1/2x = \frac{x}{2}", Assumptions(slash="first"), id="slash by the first"),
    ],
)  # fmt: skip
def test_verified(text, assumptions):
    found = check(text, assumptions)
    assert found == CheckResult(
        Finding.VERIFIED,
        text,
        engines=found.engines,
        message="true wherever both sides are defined",
    )
    assert "flint" in found.engines


@pytest.mark.parametrize(
    ("text", "message", "repair"),
    [
        pytest.param(
            r"\sin 2\theta = \sin\theta\cos\theta",
            r"false; another single edit gives `\frac{1}{2}\sin 2\theta = \sin\theta\cos\theta`",
            r"\sin 2\theta = 2\sin\theta\cos\theta", id="factor"),
        pytest.param(
            r"\cos(a + b) = \cos a \cos b + \sin a \sin b",
            r"false; another single edit gives `\cos(a - b) = \cos a \cos b + \sin a \sin b`",
            r"\cos(a + b) = \cos a \cos b - \sin a \sin b", id="sign"),
        pytest.param(
            r"\cos 2a = \cos^2 a - \sin^2 a = 1 - 2\cos^2 a",
            r"false in `\cos^2 a - \sin^2 a = 1 - 2\cos^2 a`; another single edit gives "
            r"`\cos 2a = \cos^2 a - \sin^2 a = 2\cos^2 a - 1`",
            r"\cos 2a = \cos^2 a - \sin^2 a = 1 - 2\sin^2 a", id="second step"),
        pytest.param(
            rf"{ROTATION}^{{-1}} = {ROTATION.replace('-', '')}", "false in row 2, column 1",
            rf"{ROTATION}^{{-1}} = "
            r"\begin{pmatrix}\cos a & \sin a \\ -\sin a & \cos a\end{pmatrix}", id="entry"),
        pytest.param("(a, b) = (a, b) = (b, b)", "false in entry 1 of `(a, b) = (b, b)`",
                     "(a, b) = (a, b) = (a, b)", id="entry of a step"),
        pytest.param(r"\sin x > 2", r"false; another single edit gives `\sin x > -2`",
                     r"\sin x < 2", id="relation"),
        pytest.param(r"\sqrt{x} = -y", "false", "", id="beyond repair"),
    ],
)  # fmt: skip
def test_erratum(text, message, repair):
    found = check(text)
    assert (found.verdict, found.message) == (Finding.ERRATUM, message)
    assert found.witness is not None
    assert (found.repairs[0].text if found.repairs else "") == repair
    for edit in found.repairs:
        assert check(edit.text).verdict is Finding.VERIFIED


@pytest.mark.parametrize(
    ("text", "between", "condition", "message"),
    [
        pytest.param("|x| = x", (), r"x \geq 0", "true under a condition only", id="bars"),
        pytest.param(r"|x| = x = \sqrt{x^2}", (), r"x \geq 0",
                     "true under a condition only in `|x| = x`", id="one condition for two steps"),
        pytest.param("|x| = x, |y| = y", (), r"x \geq 0 \text{ and } y \geq 0",
                     "true under a condition only in `|x| = x`", id="two conditions"),
        pytest.param(r"\cos\theta > 0", (r"0 < \theta < \pi",), r"0 < \theta < \frac{\pi}{2}",
                     "true under a condition only: 0° < θ < 90°", id="exact set"),
    ],
)  # fmt: skip
def test_conditional(text, between, condition, message):
    found = check(text, Assumptions(between=between))
    assert found.verdict is Finding.CONDITIONAL
    assert (found.condition, found.message, found.repairs) == (condition, message, ())
    assert found.witness is not None


def test_a_fault_is_graver_than_a_condition():
    found = check("|x| = x, x = 2x")
    assert (found.verdict, found.message) == (Finding.ERRATUM, "false in `x = 2x`")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        pytest.param(r"\sqrt{-1} = -x",
                     "not decided: the square root of -1 is not real", id="complex"),
        pytest.param(r"\sqrt{\sqrt{\cos 2}} = -a",
                     "not decided: a root of the sine or cosine of a number is not read",
                     id="root of a transcendental number"),
        pytest.param(r"a = b \text{ or } a = -b",
                     "not decided: alternatives joined by `or` are not decided here", id="or"),
        pytest.param(r"a = b \Leftrightarrow b = a",
                     "not decided: equivalences are not decided here", id="equivalence"),
        pytest.param(r"\{a, b\} = \{b, a\}",
                     "not decided: only numbers, vectors and matrices are compared here",
                     id="sets"),
        pytest.param(r"\sin x < x^2 + \frac{9}{10}",
                     "not decided: no proof was found without a bounded range for each symbol",
                     id="relation without range"),
        pytest.param(r"x^2 < x^2 + 1, \sin x < x^2 + \frac{9}{10}",
                     r"not decided in `\sin x < x^2 + \frac{9}{10}`: no proof was found without a "
                     "bounded range for each symbol", id="one of two"),
        pytest.param(r"\ln(xy) = \ln x + \ln y",
                     "not decided: no point shows a difference, but no proof was found",
                     id="true, and beyond the engines"),
    ],
)  # fmt: skip
def test_undecided(text, message):
    found = check(text)
    assert (found.verdict, found.message) == (Finding.UNDECIDED, message)
    assert (found.witness, found.condition, found.repairs) == (None, "", ())


@pytest.mark.parametrize(
    "zero",
    [
        pytest.param(r"\sin(\sqrt{0})", id="of a number"),
        pytest.param(r"(\sqrt{2}\sqrt{3} - \sqrt{6})", id="of roots"),
        pytest.param(r"(\sin^2 x + \cos^2 x - 1)", id="of an angle"),
        pytest.param(r"(|x|^2 - x^2)", id="of an absolute value"),
    ],
)
@pytest.mark.parametrize(
    "text",
    [
        pytest.param(r"ZERO = \frac{ZERO^2}{ZERO}", id="equal where the quotient is cancelled"),
        pytest.param(r"2 = \frac{1}{ZERO}", id="a pole"),
        pytest.param(r"x + \frac{1}{ZERO} = x + 1 + \frac{1}{ZERO}", id="a pole on both sides"),
        pytest.param(r"\sqrt{ZERO - 1}^2 = 1", id="the root of a negative number"),
    ],
)
def test_what_is_defined_nowhere_is_neither_true_nor_false(text, zero):
    found = check(text.replace("ZERO", zero))
    assert (found.verdict, found.witness) == (Finding.UNDECIDED, None)


@pytest.mark.parametrize(
    ("text", "defined"),
    [
        pytest.param("x = a + b", "`x`", id="first"),
        pytest.param("a + b = x", "`x`", id="last"),
        pytest.param("x = 3", "`x`", id="by a number"),
        pytest.param("x = y", "`x`, `y`", id="by another one"),
        pytest.param(r"\vec v = \vec\omega \times \vec r", r"`\vec{v}`", id="vector by name"),
        pytest.param(
            r"\mathbf A = \begin{pmatrix} 1 & 2 \end{pmatrix}", "`A`", id="matrix by name"
        ),
        pytest.param("(x, y) = (a + b, a - b)", "`x`, `y`", id="vector of symbols"),
        pytest.param("f(x) = x^2", "`f(x)`", id="function"),
        pytest.param(r"v = \frac{dx}{dt}", "`v`", id="by what is not read"),
        pytest.param("v = a + b, w = v - a", "`v`, `w`", id="one after the other"),
    ],
)
def test_definition(text, defined):
    message = f"a definition of {defined}: nothing to prove"
    assert check(text) == CheckResult(Finding.DEFINITION, text, message=message)


@pytest.mark.parametrize(
    ("text", "verdict", "message"),
    [
        pytest.param("x = a + b = b + a", Finding.VERIFIED,
                     "true wherever both sides are defined; a definition of `x`", id="true"),
        pytest.param("x = a + b = 2a - b", Finding.ERRATUM,
                     "false; a definition of `x`", id="false"),
        pytest.param("x = |a| = a", Finding.CONDITIONAL,
                     "true under a condition only; a definition of `x`", id="on a branch"),
        pytest.param("x = a + b, x - a = b", Finding.UNDECIDED,
                     "not decided: the definition of `x` is not put in", id="used later"),
        pytest.param("(a + b, a - b) = (x, y)", Finding.UNDECIDED,
                     "not decided: it defines `x`, `y`, or is an equation for them",
                     id="or an equation"),
    ],
)  # fmt: skip
def test_what_is_left_beside_a_definition(text, verdict, message):
    found = check(text)
    assert found.verdict is verdict
    assert found.message.startswith(message)


TRUE = "true wherever both sides are defined"


@pytest.mark.parametrize(
    ("text", "verdict", "message"),
    [
        pytest.param(r"\cos\theta\,T = T\cos\theta", Finding.VERIFIED,
                     rf"{TRUE}, if one reads `\cos\theta\,T` as `\cos(\theta)\,T`", id="short"),
        pytest.param(r"\cos{\theta} T = T\cos\theta", Finding.VERIFIED,
                     rf"{TRUE}, if one reads `\cos{{\theta}} T` as `\cos(\theta) T`", id="braces"),
        pytest.param(r"\cos\theta\,T = \cos(\theta T)", Finding.VERIFIED,
                     rf"{TRUE}, if one reads `\cos\theta\,T` as `\cos(\theta\,T)`", id="long"),
        pytest.param(r"\sin\omega t\,A = A\sin(\omega t)", Finding.VERIFIED,
                     rf"{TRUE}, if one reads `\sin\omega t\,A` as `\sin(\omega t)\,A`",
                     id="in between"),
        pytest.param(r"\sin a b + \sin a b = 2\sin a b", Finding.VERIFIED,
                     rf"{TRUE}, if one reads `\sin a b` as `\sin(a b)`", id="the same everywhere"),
        pytest.param(r"\sin 2x = 2\sin x\cos x", Finding.VERIFIED, TRUE, id="nothing to choose"),
        pytest.param(r"|\cos x\,y| = y\cos x", Finding.CONDITIONAL,
                     "true under a condition only, if one reads `\\cos x\\,y` as "
                     "`\\cos(x)\\,y`", id="on a branch"),
        pytest.param(r"\sin x\,y = -y\sin x", Finding.ERRATUM,
                     "false, in each of 2 ways to read it", id="in none"),
        pytest.param(" + ".join([r"\sin a b"] * 6) + "= 0", Finding.UNDECIDED,
                     "not decided: there are too many ways to read arguments without brackets",
                     id="too many"),
        pytest.param(r"(c\theta)^2 + (s\theta)^2 = 1", Finding.VERIFIED,
                     r"true if one reads `c` as `\cos` and `s` as `\sin`", id="short functions"),
    ],
)  # fmt: skip
def test_print_that_can_be_read_in_several_ways(text, verdict, message):
    found = check(text)
    assert found.verdict is verdict
    assert found.message.startswith(message)


LONG = "+".join(["x"] * 500_000)
INVALID = [
    pytest.param("", NONE, [
        "expected a number, a symbol or a bracket, found the end of the formula",
        "    ",
        "    ^"], id="nothing"),
    pytest.param("=", NONE, [
        "expected a number, a symbol or a bracket, found the end of the formula",
        "    =",
        "     ^"], id="equals sign alone"),
    pytest.param("= b", NONE, [
        "expected something before the sign",
        "    = b",
        "    ~~^",
        "    write `a = b`"], id="no left side"),
    pytest.param("a =", NONE, [
        "expected a number, a symbol or a bracket, found the end of the formula",
        "    a =",
        "       ^"], id="no right side"),
    pytest.param("x + 1", NONE, [
        "expected a statement, found an expression",
        "    x + 1",
        "    ~~~~^",
        "    write `a = b`"], id="expression"),
    pytest.param("__import__('os')", NONE, [
        "expected a number, a symbol or a bracket, found `_`",
        "    __import__('os')",
        "    ^"], id="code"),
    pytest.param("(" * 40 + "a" + ")" * 40 + " = a", NONE, [
        "expected at most 32 brackets inside one another",
        "    " + "(" * 40 + "a" + ")" * 29,
        "    " + " " * 32 + "^",
        "    split the formula"], id="nested too deeply"),
    pytest.param(LONG, NONE, [
        "expected at most 10000 characters, found 999999",
        "    x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+",
        "    ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~^",
        "    split the formula"], id="a million characters"),
    pytest.param("f(x) = xf", NONE, [
        "`f(x)` may be a function or a product",
        "    f(x) = xf",
        "    ~~~^",
        r"    write `f \cdot (x)` for the product"], id="unknown function"),
    pytest.param("1/3L = 1", NONE, [
        "it is not clear what the slash divides by",
        "    1/3L = 1",
        "    ~~~^",
        r"    write `\frac{…}{…}`, or settle it with `--slash first` or `--slash all`"],
        id="slash"),
    pytest.param("x^n = 1", NONE, [
        "`^n` is neither a whole power nor part of a declared symbol",
        "    x^n = 1",
        "     ~^",
        "    write a whole number as the power"], id="power"),
    pytest.param("(a, b) = (a, b, c)", NONE, [
        "expected sides of one shape, found a 2×1 matrix and a 3×1 matrix",
        "    (a, b) = (a, b, c)",
        "    ~~~~~~~~~~~~~~~~~^"], id="shapes"),
    pytest.param("(a, b) < 1", NONE, [
        "expected numbers, found a matrix",
        "    (a, b) < 1",
        "    ~~~~~~~~~^",
        "    compare entry by entry"], id="order of vectors"),
    pytest.param("x = 1", Assumptions(positive=("y",)), [
        "the formula has no symbol `y`",
        "    y",
        "    ^",
        "    leave the assumption out"], id="assumption"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "assumptions", "message"), INVALID)
def test_invalid(text, assumptions, message):
    found = check(text, assumptions)
    assert found.verdict is Finding.INVALID
    assert found.message.splitlines()[: len(message)] == message
    assert len(found.printed) < 10_000


def test_engines_that_disagree_are_no_verdict(monkeypatch):
    def disagree(*_args, **_options):
        raise DisagreementError("flint: zero, modular: not")

    monkeypatch.setattr("omniproof.audit.check.confirmed_equal", disagree)
    with pytest.raises(DisagreementError, match="flint: zero, modular: not"):
        check("a = a")


def test_an_engine_is_named_only_where_it_decided_every_step():
    assert check("a = a, a < a + 1").engines == ("flint",)


PIECES = (
    r"x y \theta a_1 2 0 1.5 30^\circ \pi + - * / ( ) [ ] | = < \leq \neq ^2 ^T _1 \sin \sqrt \frac"
)
HOSTILE = [
    *PIECES.split(),
    r"\begin{pmatrix}",
    r"\end{pmatrix}",
    "&",
    r"\\",
    ",",
    "{",
    "}",
    "__",
    "'",
]


@settings(deadline=None, max_examples=150)
@given(st.lists(st.sampled_from(HOSTILE), max_size=12).map(" ".join))
def test_any_text_gets_a_verdict(text):
    assert check(text).verdict in Finding


@settings(deadline=None, max_examples=50)
@given(st.text(max_size=40))
def test_any_characters_get_a_verdict(text):
    assert check(text).verdict in Finding
