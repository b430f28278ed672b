"""Intervals of printed decimals, and their arithmetic, ends included."""

import pytest
import sympy as sp

from omniproof.audit.ranges import (
    POSITIVE,
    REAL_LINE,
    Reading,
    add,
    contains,
    meet,
    root,
    scale,
    show,
    stands_for,
)
from omniproof.decide.order.intervals import Piece

Q = sp.Rational


def piece(text: str) -> Piece:
    """Read an interval such as `[1/2, 3)`."""
    lower, upper = (sp.oo * (-1) ** ("-" in e) if "oo" in e else Q(e) for e in _ends(text))
    return Piece(lower, upper, text[0] == "[", text[-1] == "]")


def _ends(text: str) -> list[str]:
    return [end.strip() for end in text[1:-1].split(",")]


@pytest.mark.parametrize(
    ("printed", "rounded", "truncated", "either"),
    [
        pytest.param("20.8", "[20.75, 20.85]", "[20.8, 20.9)", "[20.75, 20.9)", id="positive"),
        pytest.param("-10.3", "[-10.35,-10.25]", "(-10.4,-10.3]", "(-10.4,-10.25]", id="negative"),
        pytest.param("0", "[-1/2, 1/2]", "(-1, 1)", "(-1, 1)", id="zero of either sign"),
        pytest.param("1.84", "[1.835, 1.845]", "[1.84, 1.85)", "[1.835, 1.85)", id="two places"),
    ],
)
def test_what_a_decimal_stands_for(printed, rounded, truncated, either):
    found = [stands_for(printed, reading) for reading in Reading]
    assert found == [piece(rounded), piece(truncated), piece(either)]


@pytest.mark.parametrize(
    ("left", "right", "common"),
    [
        pytest.param("[0, 2]", "[1, 3]", "[1, 2]", id="overlap"),
        pytest.param("[0, 1]", "[1, 2]", "[1, 1]", id="a common end"),
        pytest.param("[0, 1)", "[1, 2]", None, id="touching, one end open"),
        pytest.param("[0, 1]", "(0, 1]", "(0, 1]", id="an open end wins"),
        pytest.param("(0, 3)", "[1, 2]", "[1, 2]", id="inside"),
        pytest.param("[0, 1]", "[2, 3]", None, id="apart"),
        pytest.param("(-oo, oo)", "(0, oo)", "(0, oo)", id="unbounded"),
    ],
)
def test_common_part(left, right, common):
    wanted = piece(common) if common else None
    assert meet(piece(left), piece(right)) == meet(piece(right), piece(left)) == wanted


def test_an_irrational_end_is_compared_exactly():
    """tan(pi/8) = sqrt(2) - 1, written in two ways."""
    end = sp.sqrt(2) - 1
    assert contains(Piece(sp.Integer(0), end, True, True), sp.sin(sp.pi / 8) / sp.cos(sp.pi / 8))
    assert not contains(Piece(sp.Integer(0), end, True), sp.sin(sp.pi / 8) / sp.cos(sp.pi / 8))


def test_scaling_by_a_negative_number_turns_the_interval():
    assert scale(piece("[1, 2)"), Q(-3), Q(1)) == piece("(-5, -2]")
    assert scale(POSITIVE, Q(-3), Q(1)) == piece("(-oo, 1)")


def test_sums_reach_an_end_when_both_parts_do():
    assert add(piece("[1, 2)"), piece("[10, 20]")) == piece("[11, 22)")
    assert add(piece("[1, 2)"), REAL_LINE) == REAL_LINE


@pytest.mark.parametrize(
    ("interval", "power", "roots"),
    [
        pytest.param("[4, 9)", Q(2), "[2, 3)", id="square"),
        pytest.param("[4, 5)", Q(-1), "(1/5, 1/4]", id="inverse turns"),
        pytest.param("(-1, 4]", Q(-2), "[1/2, oo)", id="inverse square from zero"),
        pytest.param("[-1, 9]", Q(2), "[0, 3]", id="zero is its own square"),
        pytest.param("[2, 3]", Q(1, 2), "[4, 9]", id="power one half"),
        pytest.param("[-2, -1]", Q(-1), None, id="no positive member"),
    ],
)
def test_roots(interval, power, roots):
    assert root(piece(interval), power) == (piece(roots) if roots else None)


def test_writing():
    pieces = (piece("(-oo, -1/3]"), Piece(sp.pi, sp.oo, True))
    assert show(pieces, "V", 3) == "-∞ < V ≤ -0.333 or 3.14 ≤ V < ∞"
