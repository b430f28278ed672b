"""The verbatim LaTeX of single entries."""

from __future__ import annotations

import pytest

from omniproof.transcription.entries import entry_source
from omniproof.transcription.reader import read

EQUATION = (
    r"\begin{pmatrix} u \\ v \end{pmatrix} = a^{-1}"
    r"\begin{pmatrix} -\sin \alpha & \cos  \alpha \\ (a + b) & 2 \end{pmatrix}(x, y)"
)
ENTRIES = [
    pytest.param(EQUATION, (1, 1), None, r"-\sin \alpha", id="first entry"),
    pytest.param(EQUATION, (1, 2), None, r"\cos  \alpha", id="blanks as printed"),
    pytest.param(EQUATION, (2, 1), None, "(a + b)", id="brackets as printed"),
    pytest.param(EQUATION, (3, 1), None, None, id="no such row"),
    pytest.param(EQUATION, (0, 1), None, None, id="entries count from 1"),
    pytest.param(EQUATION, (1,), None, None, id="two vectors"),
    pytest.param(r"q = L(\cos a, \sin a)^T", (2,), None, r"\sin a", id="tuple"),
    pytest.param(r"[a \ b]^t + c", (1,), None, "a", id="row in square brackets"),
    pytest.param(r"\begin{bmatrix} a & b & c \end{bmatrix}^t", (3,), (3, 1), "c", id="printed row"),
    pytest.param(r"(a, b, c) + (x, y)", (1,), (3, 1), "a", id="the shape chooses"),
    pytest.param(r"(a, b, c) + (x, y)", (1,), None, None, id="no choice without the shape"),
    pytest.param("a + b", (1,), None, None, id="no vector"),
    pytest.param(r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}^{-1}", (1, 2), None, None,
                 id="an inverse has other entries"),
    pytest.param(r"2\binom{a - b}{c}", (1,), None, "a - b", id="a column without its braces"),
    pytest.param(r"\{a, b\}", (1,), None, None, id="a set has no order"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "index", "shape", "entry"), ENTRIES)
def test_entry(
    text: str, index: tuple[int, ...], shape: tuple[int, int] | None, entry: str | None
) -> None:
    assert entry_source(text, read(text), index, shape) == entry
