"""The formulas of the chapter on first principles against forms written down by hand."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from omniproof.papers.one_mechanics import principles


def bare(latex: str) -> str:
    """Leave out blanks and the words for brackets of matrices."""
    for word in (" ", r"\left(", r"\right)", r"\begin{matrix}", r"\end{matrix}"):
        latex = latex.replace(word, "")
    return latex


@pytest.mark.parametrize(
    ("shown", "part"),
    [
        pytest.param(
            principles.wheels_from_twist,
            r"-\sin{\alpha_{2}}&\cos{\alpha_{2}}&L\\",
            id="a row of the wheel matrix",
        ),
        pytest.param(
            principles.twist_from_wheels,
            r"\frac{1}{3}-1&-1&2\\\sqrt{3}&-\sqrt{3}&0\\\frac{1}{L}&\frac{1}{L}&\frac{1}{L}",
            id="the inverse of the equilateral arrangement",
        ),
        pytest.param(
            principles.path,
            r"V_{x}\sin{\omegat}+V_{y}\cos{\omegat}-V_{y}",
            id="integral of the turn",
        ),
        pytest.param(principles.radius, r"\frac{\sqrt{V_{x}^{2}+V_{y}^{2}}}{\omega}", id="radius"),
        pytest.param(
            principles.centre,
            r"-\frac{V_{y}}{\omega}\\\frac{V_{x}}{\omega}",
            id="centre: on the left",
        ),
        pytest.param(
            principles.spin_of_ball,
            r"-\frac{V_{y}}{\rho}\\\frac{V_{x}}{\rho}\\\sigma",
            id="a ball rolls along",
        ),
        pytest.param(
            principles.wheel_in_ball,
            r"\frac{L\cos{\alpha_{k}}\cos{\phi}}{\rho}&L\sin{\phi}&-L\sin{\phi}",
            id="the ball's spin counts against the yaw rate",
        ),
        pytest.param(
            principles.term_of_normal_matrix,
            r"p_{y}^{2}+p_{z}^{2}&-p_{x}p_{y}&-p_{x}p_{z}",
            id="identity less the direction of the contact",
        ),
    ],
)
def test_shown_formula(shown: Callable[[], str], part: str) -> None:
    assert part in bare(shown())
