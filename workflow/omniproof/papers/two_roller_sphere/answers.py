"""Tables that answer the questions of the chapter: exact numbers, and where statements fail."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import pairwise

from sympy import Expr, atan, lambdify, pi, rad, sqrt

from omniproof.audit.decimals import read_decimal
from omniproof.audit.preimage import solve_for
from omniproof.decide.answer import Undecided
from omniproof.papers.two_roller_sphere import closed_forms
from omniproof.papers.two_roller_sphere.symbols import DIRECTION
from omniproof.papers.two_roller_sphere.symmetric import ANGLE, ANGLES, in_simulation

AHEAD = {"nu": closed_forms.rim_speed(1), "S": closed_forms.slip(1)}
"""Rim speed and slip of roller 1 in any direction, m/s."""

NEAR_DEG = (0, 10, 20, 30, 35, 38)
RANGE = (pi * 0, pi / 3)
"""Angles (degrees) towards the singular one; range of angles in which a cell is looked for."""


def cases() -> list[list[str]]:
    """What the exact motion has in each case: angle, steepest axis, greatest speed, most slip.

    Each row: angle of roller 1, lean of the plane of spins (degrees), greatest spin, greatest rim
    speed and its direction, greatest slip.
    """
    return [[f"{_degrees(angle):.0f}°", *_case(k)] for k, angle in enumerate(ANGLES)]


def _case(k: int) -> list[str]:
    lean, ahead, aside, slip = (
        in_simulation(value, k)
        for value in (closed_forms.LEAN, closed_forms.AHEAD, closed_forms.ASIDE, _ahead("S"))
    )
    return [
        f"{_degrees(atan(lean)):.2f}°",
        f"{float(sqrt(1 + lean**2)):.3f}",
        f"{float(sqrt(ahead**2 + aside**2)):.3f} at {_degrees(atan(ahead / aside)):.1f}°",
        f"{float(slip):.4f}",
    ]


def _ahead(name: str) -> Expr:
    """Quantity for travel along y."""
    return AHEAD[name].subs(DIRECTION, pi / 2)


def angles_of_printed(name: str, printed: Mapping[int, str]) -> list[list[str]]:
    """Angles of roller 1 (degrees) whose exact value rounds to the printed one, case by case.

    `name` is nu or S, `printed` the decimals by k. Each row: angle of the case, printed, exact, the
    range of angles. The contacts are those of the simulation.
    """
    value = in_simulation(_ahead(name))
    rows = []
    for k, decimal in printed.items():
        exact = f"{float(value.subs(ANGLE, ANGLES[k])):.4f}"
        rows.append([f"{_degrees(ANGLES[k]):.0f}°", decimal, exact, _range(value, decimal)])
    return rows


def _range(value: Expr, decimal: str) -> str:
    pieces = solve_for(value, ANGLE, read_decimal(decimal).interval, RANGE)
    if isinstance(pieces, Undecided):
        return f"undecided: {pieces.reason}"
    ends = (tuple(_degrees(end) for end in piece) for piece in pieces)
    return " or ".join(f"{low:.2f}° … {high:.2f}°" for low, high in ends) or "none"


def _degrees(angle: Expr | str | float) -> float:
    return math.degrees(float(angle))


def failing_directions() -> list[list[str]]:
    """Directions (degrees) in which a link of the chain of rim speeds fails, ends included.

    Each row: the link, the directions for roller 1, those for roller 2. With nu = a sin + b cos the
    difference of two squares is a product of two such forms, and negative between their zeros.
    """
    forms = [
        (in_simulation(closed_forms.AHEAD, k), in_simulation(closed_forms.ASIDE, k))
        for k in range(len(ANGLES))
    ]
    rows = []
    for k, ((a, b), (c, d)) in enumerate(pairwise(forms)):
        low, high = sorted(_degrees(atan(x)) for x in ((b + d) / (a + c), (d - b) / (c - a)))
        first, second = (_with_opposite(*ends) for ends in ((180 - high, 180 - low), (low, high)))
        rows.append([rf"$|\nu_{{i,{k}}}| < |\nu_{{i,{k + 1}}}|$", first, second])
    return rows


def _with_opposite(low: float, high: float) -> str:
    pieces = (f"{low + turn:.2f}° … {high + turn:.2f}°" for turn in (0, 180))
    return ", ".join(pieces)


def near_the_singular_angle() -> list[list[str]]:
    """Travel along x as the roller angle comes near the one at which it ends, and the angle itself.

    Each row: angle, lean of the plane of spins, spin about the vertical (rad/s), rim speed (m/s).
    """
    values = lambdify(
        ANGLE, [in_simulation(value) for value in (closed_forms.LEAN, closed_forms.ASIDE)], "mpmath"
    )
    rows = []
    for degrees in NEAR_DEG:
        lean, speed = (float(value) for value in values(float(rad(degrees))))
        tilt = _degrees(atan(lean))
        rows.append([f"{degrees}°", f"{tilt:.2f}°", f"{lean:.2f}", f"{speed:.2f}"])
    end = _degrees(in_simulation(closed_forms.SINGULAR_ANGLE))
    return [*rows, [f"{end:.2f}°", "90°", "∞", "∞"]]
