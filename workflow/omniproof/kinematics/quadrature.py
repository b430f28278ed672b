"""Pose after any smooth wheel speeds, enclosed: for paths without a closed form.

Taylor's formula on short steps, in ball arithmetic: the coefficients at the middle of a step give
the integral, the coefficient of the next order over the whole step encloses what is left out. So
the result is certain to contain the pose, and its radius is an error bound, not an estimate. The
heading is integrated along with the path, which asks for no antiderivative of the yaw rate.

Taylor rather than Gauss: Gauss and Legendre's rule needs a bound on a high derivative as well, and
the series give it anyway. Paths of a few seconds take 4 to 16 steps, a few milliseconds.

Sources: Moore, Kearfott, Cloud, Introduction to Interval Analysis, 9.4; Johansson, Arb (2017).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_series, ctx
from sympy import MatrixBase, Symbol

from omniproof.decide.balls import Ball, Program, rational_ball
from omniproof.decide.in_sympy.balls import compile_balls
from omniproof.kinematics.scalars import Scalar, exact

ORDER = 16
"""Order of Taylor's formula; even, so that the odd terms cancel over a step."""

PRECISION = 128
MOST_STEPS = 4096
TOLERANCE = 1e-12


@dataclass(frozen=True)
class Pose:
    """Balls that contain X, Y (m) and the heading (rad) in the world."""

    x: Ball
    y: Ball
    heading: Ball

    @property
    def error(self) -> float:
        """Largest radius of the three balls."""
        return max(float(ball.rad()) for ball in (self.x, self.y, self.heading))


def pose(twist: MatrixBase, time: Symbol, end: Scalar, *, tolerance: float = TOLERANCE) -> Pose:
    """Enclose the pose at time `end` (s, rational, positive), from the origin at time 0.

    `twist`: 3x1 in the body's frame, exact, smooth functions of `time` and nothing else. The radius
    of each ball is at most `tolerance` (m, rad). Raises `ValueError` where `MOST_STEPS` steps do
    not reach it, as at a singularity of the speeds, and `UnsupportedError` for other functions.
    """
    program = compile_balls([exact(entry) for entry in twist], (time,))
    length, steps, cap = rational_ball(exact(end)), 1, ctx.cap
    try:
        with ctx.workprec(PRECISION):
            ctx.cap = ORDER + 1
            while steps <= MOST_STEPS:
                found = _driven(program, length / steps, steps)
                if found.error <= tolerance:  # false for balls that are not finite
                    return found
                steps *= 2
    finally:
        ctx.cap = cap
    raise ValueError(f"no bound of {tolerance:g} on the error with {MOST_STEPS} steps")


def _driven(program: Program, step: Ball, steps: int) -> Pose:
    """Go through equal steps one by one."""
    here = Pose(arb(0), arb(0), arb(0))
    for count in range(steps):
        here = _advanced(program, here, (2 * count + 1) * step / 2, step / 2)
    return here


def _advanced(program: Program, start: Pose, middle: Ball, half: Ball) -> Pose:
    """Pose after one step: from the Taylor coefficients at its middle and over all of it."""
    whole = middle + half * arb(0, 1)
    at_middle, over_step = (program.taylor([at], [1], ORDER) for at in (middle, whole))
    rate, rate_over = at_middle[2], over_step[2]
    heading = start.heading + _integral(rate, rate_over, -half, arb(0))
    heading_over = heading + half * arb(0, 1) * rate_over[0]
    speeds = _world(at_middle, heading), _world(over_step, heading_over)
    x, y = (_integral(inner, over, -half, half) for inner, over in zip(*speeds, strict=True))
    turned = _integral(rate, rate_over, -half, half)
    return Pose(start.x + x, start.y + y, start.heading + turned)


def _world(twist: Sequence[Sequence[Ball]], heading: Ball) -> tuple[list[Ball], list[Ball]]:
    """Taylor coefficients of (X', Y') from those of the twist, and the heading there."""
    v_x, v_y, rate = (arb_series(entry, ORDER + 1) for entry in twist)
    phi = rate.integral() + heading
    c, s = phi.cos(), phi.sin()
    both = c * v_x - s * v_y, s * v_x + c * v_y
    x, y = ([line[k] for k in range(ORDER + 1)] for line in both)
    return x, y


def _integral(inner: Sequence[Ball], over: Sequence[Ball], low: Ball, high: Ball) -> Ball:
    """Integral over [low, high] about 0, with Lagrange's remainder of the last order."""
    terms = (*inner[:ORDER], over[ORDER])
    powers = ((high ** (k + 1) - low ** (k + 1)) / (k + 1) for k in range(ORDER + 1))
    return sum((term * power for term, power in zip(terms, powers, strict=True)), arb(0))
