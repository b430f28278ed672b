"""What a correction changes is marked: as little as is whole, and nothing else is touched."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omniproof.formula.writers import difference, text
from omniproof.formula.writers.boxes import Box, Row
from omniproof.report.shown import shown


def row(latex: str) -> Row:
    found = shown(latex)
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("printed", "corrected", "old", "new"),
    [
        pytest.param(r"\sin a + b", r"\sin a - b", "sin a [+] b", "sin a [-] b", id="sign"),
        pytest.param("-a b", "a b", "[-] a b", "a b", id="a sign too many"),
        pytest.param("a b", "a b c", "a b", "a b [c]", id="something is missing"),
        pytest.param("x_1 y", "x_2 y", "[x₁] y", "[x₂] y", id="an index, with its symbol"),
        pytest.param(r"\cos x y", r"\sin x y", "[cos] x y", "[sin] x y", id="function"),
        pytest.param(r"r \sqrt{a b}", r"r \sqrt{a c}", "r √(a [b])", "r √(a [c])", id="in a root"),
        pytest.param("a (b + c)", "a (b - c)", "a (b [+] c)", "a (b [-] c)", id="in brackets"),
        pytest.param(r"a \frac{b}{2}", r"a \frac{b}{3}", "a b/[2]", "a b/[3]", id="in a fraction"),
        pytest.param(r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}",
                     r"\begin{pmatrix} a & b \\ c & -d \end{pmatrix}",
                     "(a, b; c, d)", "(a, b; c, [-] d)", id="in a matrix"),
    ],
)  # fmt: skip
def test_marks(printed: str, corrected: str, old: str, new: str) -> None:
    found = difference(row(printed), row(corrected))
    assert (text(found.one), text(found.other)) == (old, new)


PIECES = st.sampled_from(["a", "b_1", "x^2", r"\sin x", r"\frac{a}{b}", "(a - b)", r"\sqrt{c}"])
FORMULAS = st.lists(PIECES, min_size=1, max_size=6).map(" + ".join)


def unmarked(row: Row) -> Row:
    """A row without its marks."""
    found: Row = ()
    for box in row:
        parts = tuple(map(unmarked, box.parts))
        found += parts[0] if box.kind == "mark" else (Box(box.kind, box.text, parts),)
    return found


@given(FORMULAS, FORMULAS)
def test_marks_change_nothing_else(printed: str, corrected: str) -> None:
    found = difference(row(printed), row(corrected))
    assert unmarked(found.one) == row(printed)
    assert unmarked(found.other) == row(corrected)
    assert bool(found.pairs) == (row(printed) != row(corrected))
