"""Angles of a family: in any order, by full turns, for a parameter in its range."""

from __future__ import annotations

from typing import Any

import pytest
from sympy import And, Rational, oo, pi, symbols

from omniproof.audit.angle_family import instance
from omniproof.decide.answer import Proved, Refuted, Undecided
from omniproof.decide.in_sympy.domain import Domain

s, t = symbols("s t", real=True)


def degrees(*angles_deg: int) -> tuple[Any, ...]:
    return tuple(Rational(angle, 180) * pi for angle in angles_deg)


ISOSCELES = (t, pi - t, 3 * pi / 2)
DOUBLE = (2 * t, t)
HALF = (t / 2, 3 * t / 2)


@pytest.mark.parametrize(
    ("printed", "family", "expected"),
    [
        pytest.param((30, 150, 270), ISOSCELES, Proved, id="t = 30"),
        pytest.param((270, 150, 30), ISOSCELES, Proved, id="in another order"),
        pytest.param((210, 270, 330), ISOSCELES, Proved, id="t = 210, by a full turn"),
        pytest.param((390, 150, -90), ISOSCELES, Proved, id="by full turns"),
        pytest.param((210, 270, 300), ISOSCELES, Refuted, id="210 and 300 are not 180 in all"),
        pytest.param((30, 150, 271), ISOSCELES, Refuted, id="the third wheel off"),
        pytest.param((30, 30, 270), ISOSCELES, Refuted, id="one angle twice"),
        pytest.param((0, 180), DOUBLE, Proved, id="t = 180: the double has turned fully"),
        pytest.param((90, 225), DOUBLE, Proved, id="t = 225: the double is 450"),
        pytest.param((90, 90), DOUBLE, Refuted, id="no angle is its double but 0"),
        pytest.param((190, 210), HALF, Proved, id="t = 380: only beyond the first turn"),
    ],
)
def test_instance(printed: tuple[int, ...], family: Any, expected: type) -> None:
    assert isinstance(instance(degrees(*printed), family), expected)


@pytest.mark.parametrize(
    ("angles", "ends", "assumed", "expected"),
    [
        pytest.param((30, 150, 270), (0, 90), [t > 0, t < pi / 2], Proved, id="t = 30"),
        pytest.param((210, 330, 270), (0, 90), [t > 0, t < pi / 2], Refuted, id="t = 210 or 330"),
        pytest.param((210, 330, 270), (-90, 0), [t < 0], Proved, id="t = -30, one turn less"),
        pytest.param((90, 90, 270), (0, 90), [t > 0, t < pi / 2], Refuted, id="the open end"),
        pytest.param((90, 90, 270), (0, 90), [t > 0, t <= pi / 2], Proved, id="a closed end"),
        pytest.param((30, 150, 270), (-oo, oo), [], Proved, id="no bounds"),
        pytest.param((30, 150, 270), (1000, oo), [t > 50 * pi / 9], Proved, id="t = 1110"),
        pytest.param((30, 150, 270), (-oo, -1000), [t < -50 * pi / 9], Proved, id="t = -1050"),
        pytest.param((30, 150, 270), (-oo, oo), [t > s], Undecided, id="another symbol"),
        pytest.param((30, 150, 270), (0, 90), [And(t > pi / 4, t < pi / 2)], Refuted,
                     id="30 is less than 45"),
    ],
)  # fmt: skip
def test_the_parameter_is_in_its_range(
    angles: tuple[int, ...], ends: Any, assumed: Any, expected: type
) -> None:
    domain = Domain({"t": tuple(end * pi / 180 for end in ends)})
    assert isinstance(instance(degrees(*angles), ISOSCELES, domain, assumed), expected)


def test_how_many_angles_fit_is_shown() -> None:
    answer = instance(degrees(210, 270, 300), ISOSCELES)
    assert isinstance(answer, Refuted)
    assert str(answer.witness) == (
        "angle_1=210°; angle_2=270°; angle_3=300°; printed=3 angles; derived=2 in one member"
    )


def test_a_parameter_out_of_range_is_shown() -> None:
    domain = Domain({"t": (pi / 4, pi / 2)})
    answer = instance(degrees(30, 150, 270), ISOSCELES, domain, [t > pi / 4, t < pi / 2])
    assert isinstance(answer, Refuted)
    assert answer.note == "it is out of range"
    assert answer.witness.derived == "t = 30° or 150°"
