"""The table that answers the question of the chapter: how far off the printed law is."""

from __future__ import annotations

import math

from sympy import Interval, Rational, pi, solveset

from omniproof.kinematics.omni import twist_matrix
from omniproof.papers.ballbot.laws import BALL_RADIUS, at_rest, gram, rolling
from omniproof.papers.ballbot.symbols import PHI, RUNNING_RADIUS

ANGLES_DEG = (15, 30, 45, 60, 75, 90, 135)
WALL = Rational(9, 10)
"""Zenith angles (degrees) of the table, and L / rho of a ball with a wall."""

NEVER = "–"


def best_zenith_angle() -> str:
    """Zenith angle (degrees) of wheels that move a thin rolling ball equally well in all ways."""
    squares = gram(rolling(), BALL_RADIUS).subs({BALL_RADIUS: 1, RUNNING_RADIUS: 1})
    (angle,) = solveset(squares[0, 0] - squares[2, 2], PHI, Interval(0, pi / 2))
    return f"{math.degrees(float(angle)):.2f}°"


def speeds_by_zenith_angle() -> list[list[str]]:
    """How Eq. (10) fares with the wheel speeds of a rolling ball, by the angle of the wheels.

    Each row: zenith angle, speed by (10) over that of the ball for L = rho and for L = 0.9 rho, and
    how many times as fast as by (10) the ball moves for L = rho.
    """
    share = (twist_matrix(at_rest()) * rolling())[0, 0].subs(BALL_RADIUS, 1)
    rows = []
    for degrees in ANGLES_DEG:
        angle = {PHI: degrees * pi / 180}
        thin, thick = (share.subs(angle | {RUNNING_RADIUS: ratio}) for ratio in (1, WALL))
        times = f"{1 / float(thin):.3f}" if thin else NEVER
        cells = [f"{float(thin):.3f}", f"{float(thick):.3f}", times]
        rows.append([f"{degrees}°", *(cell.replace("-", "\N{MINUS SIGN}") for cell in cells)])
    return rows
