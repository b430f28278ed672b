"""Formulas that hypothesis makes up, and a point at which they may have a value."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st
from sympy import Rational

from omniproof.transcription import tree

POINT = {
    "a": Rational(2, 7), "b_1": Rational(-5, 3), "\\theta": Rational(11, 13),
    "\\dot{\\phi}": Rational(9, 4), "v_k^T": Rational(-3, 11), "\\det A": Rational(7, 5),
}  # fmt: skip
LEAVES = st.one_of(
    st.integers(0, 99).map(lambda number: tree.Number(str(number))),
    st.integers(0, 999).map(lambda number: tree.Number(f"{number / 100:.2f}")),
    st.integers(0, 360).map(lambda number: tree.Degrees(str(number))),
    st.just(tree.Pi()),
    st.sampled_from(sorted(POINT)).map(tree.Name),
)


def _branches(parts: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    some = st.lists(parts, min_size=2, max_size=3).map(tuple)
    functions = st.sampled_from(["sin", "cos", "arctan", "sqrt"])
    return st.one_of(
        some.map(tree.Sum),
        some.map(tree.Product),
        parts.map(tree.Negative),
        parts.map(tree.Absolute),
        parts.map(tree.Norm),
        st.builds(tree.Dot, parts, parts),
        st.builds(tree.Cross, parts, parts),
        st.builds(tree.Quotient, parts, parts),
        st.builds(tree.Power, parts, st.integers(-2, 3)),
        st.builds(tree.Call, functions, parts),
    )


TREES = st.recursive(LEAVES, _branches, max_leaves=10)
