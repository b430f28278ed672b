"""Repairs of a formula by itself: relations, matrices by their parts, what comes first."""

import pytest

from omniproof.audit.check import Finding, check
from omniproof.audit.setting import Assumptions


def first_repair(text: str, *between: str) -> str:
    found = check(text, Assumptions(between=between))
    assert found.verdict is Finding.ERRATUM
    return found.repairs[0].text if found.repairs else ""


@pytest.mark.parametrize(
    ("printed", "right"),
    [
        pytest.param("x^2 + 1 < 0", "x^2 + 1 > 0", id="turned"),
        pytest.param("(x - 1)^2 > 0", r"(x - 1)^2 \geq 0", id="equality lost"),
        pytest.param("x^2 < 0", r"x^2 \geq 0", id="turned, with the equality"),
        pytest.param(r"x^2 + y^2 \leq 2xy", r"x^2 + y^2 \geq 2xy", id="turned, equality kept"),
        pytest.param(r"a^2 + b^2 \geq 3ab", r"a^2 + b^2 \geq 2ab", id="a coefficient"),
        pytest.param(r"\sin x + \cos x \leq 1", r"\sin x + \cos x \leq 2", id="the nearest bound"),
        pytest.param(r"|a + b| \geq |a| + |b|", r"|a + b| \leq |a| + |b|", id="bars"),
        pytest.param(r"0 < x^2 \leq x^2 + y^2", r"0 \leq x^2 \leq x^2 + y^2", id="in a chain"),
        pytest.param(r"(x + y)^2 \neq x^2 + 2xy + y^2", "(x + y)^2 = x^2 + 2xy + y^2", id="equal"),
        pytest.param("0 < x^2 + 1 < 1", "", id="no chain turns in the middle"),
        pytest.param(r"2x \leq x^2", "", id="no quantity is held against itself"),
    ],
)
def test_a_false_relation_is_mended(printed, right):
    assert first_repair(printed) == right


def test_a_relation_is_mended_on_its_range():
    ranged = r"0 < x < \frac{\pi}{2}"
    assert first_repair(r"\sin x > x", ranged) == r"\sin x < x"


TURN = r"\begin{bmatrix} \cos %s & -\sin %s & 0 \\ \sin %s & \cos %s & 0 \\ 0 & 0 & 1 \end{bmatrix}"
A, B = (TURN % ((letter,) * 4) for letter in "ab")
BOTH = (
    r"\begin{bmatrix} \cos(a + b) & -\sin(a + b) & 0 \\ "
    r"\sin(a + b) & \cos(a + b) & 0 \\ 0 & 0 & 1 \end{bmatrix}"
)
LINK = r"""
\begin{bmatrix} \cos\theta & -\sin\theta & 0 & 0 \\ \sin\theta & \cos\theta & 0 & 0 \\
0 & 0 & 1 & d \\ 0 & 0 & 0 & 1 \end{bmatrix}
\begin{bmatrix} 1 & 0 & 0 & a \\ 0 & \cos\alpha & -\sin\alpha & 0 \\
0 & \sin\alpha & \cos\alpha & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} =
\begin{bmatrix} \cos\theta & -\sin\theta\cos\alpha & \sin\theta\sin\alpha & a\cos\theta \\
\sin\theta & \cos\theta\cos\alpha & -\cos\theta\sin\alpha & a\sin\theta \\
0 & \sin\alpha & \cos\alpha & d \\ 0 & 0 & 0 & 1 \end{bmatrix}
"""


@pytest.mark.parametrize(
    ("right", "old", "new"),
    [
        pytest.param(f"{A} {B} = {BOTH}", r"& -\sin(a", r"& \sin(a", id="an entry of the product"),
        pytest.param(f"{A} {B} = {BOTH}", r"\sin b & \cos b", r"-\sin b & \cos b",
                     id="an entry of a factor, wrong in two rows"),
        pytest.param(LINK.strip(), r"& -\cos\theta\sin", r"& \cos\theta\sin",
                     id="a Denavit-Hartenberg matrix of 200 tokens"),
        pytest.param(LINK.strip(), r"& d \\", r"& a \\", id="a letter of a factor"),
    ],
)  # fmt: skip
def test_a_matrix_is_mended_in_its_wrong_part(right, old, new):
    printed = right.replace(old, new, 1)
    assert check(right).verdict is Finding.VERIFIED
    assert right in [edit.text for edit in check(printed).repairs]


@pytest.mark.parametrize(
    ("printed", "right"),
    [
        pytest.param(
            r"\det\begin{bmatrix} \cos x & \sin x \\ \sin x & \cos x \end{bmatrix} = 1",
            r"\det\begin{bmatrix} \cos x & -\sin x \\ \sin x & \cos x \end{bmatrix} = 1",
            id="before the number that it is held against"),
        pytest.param(r"\cos^2 x - \sin^2 x = 1", r"\cos^2 x + \sin^2 x = 1", id="a sum of 1"),
        pytest.param("a + b = a + a", "", id="never into what says nothing"),
    ],
)  # fmt: skip
def test_the_likeliest_repair_comes_first(printed, right):
    assert first_repair(printed) == right


def test_where_one_edit_does_not_do_two_are_tried():
    found = check(r"\sin(a + b) = \cos a \cos b - \cos a \sin b")
    assert r"\sin(a + b) = \sin a \cos b + \cos a \sin b" in [edit.text for edit in found.repairs]
    assert "; the repair takes two edits" in found.message


@pytest.mark.parametrize("text", ["x^2 + 1 < 0", r"\sin 2x = \sin x \cos x", r"a^2 \leq 2a^2 - 1"])
def test_every_repair_is_true_by_its_engines(text):
    for edit in check(text).repairs:
        again = check(edit.text)
        assert again.verdict is Finding.VERIFIED
        assert {"flint", *again.engines} <= {"flint", *edit.engines}
