"""Tables that answer the questions of the chapter: for which angles, and with how much rotation."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
from sympy import Expr

from omniproof.audit.decimals import read_decimal
from omniproof.audit.preimage import solve_for
from omniproof.decide.answer import Undecided
from omniproof.kinematics import zonotope
from omniproof.papers.omni_arrangement.arrangements import CORRECTED, SWEEP, isosceles
from omniproof.papers.omni_arrangement.derivations.quantities import (
    image_area,
    image_volume,
    platform,
)
from omniproof.papers.omni_arrangement.derivations.simulation import area_of, by_type, section_of
from omniproof.papers.omni_arrangement.symbols import THETA

LIMITS = (0.25, 0.5, 1.0, 2.0)
"""Bounds on |L * yaw rate| (m/s) between no rotation and as much as the wheels give."""


def angles_of_table_2(paper_data: Path) -> list[list[str]]:
    """Angles of the isosceles family (degrees) that round to each printed cell of Table 2.

    Each row: type, column, printed decimal, the intervals of the angle.
    """
    determinant = platform(isosceles(THETA)).determinant
    functions = {"D_V": image_volume(determinant), "D_A": image_area(determinant)}
    with (paper_data / "table-2.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return [
        [row["type"], name, row[name], _in_degrees(function, row[name])]
        for row in rows
        for name, function in functions.items()
    ]


def _in_degrees(function: Expr, printed: str) -> str:
    pieces = solve_for(function, THETA, read_decimal(printed).interval, SWEEP)
    if isinstance(pieces, Undecided):
        return f"undecided: {pieces.reason}"
    degrees = (tuple(np.degrees(float(end)) for end in piece) for piece in pieces)
    return " or ".join(f"{low:.3f}° … {high:.3f}°" for low, high in degrees) or "none"


def areas_by_rotation() -> list[list[str]]:
    """Area of the reachable velocities, (m/s)^2: bound on |L * yaw rate| (m/s), then each type."""
    generators = {
        name: np.array(platform(angles).inverse.evalf(17), dtype=float)
        for name, angles in CORRECTED.items()
    }
    between = [
        [f"{limit:g} m/s", *(f"{_area(columns, limit):.3f}" for columns in generators.values())]
        for limit in LIMITS
    ]
    return [
        ["no rotation", *(f"{float(area):.3f}" for area in by_type(section_of).values())],
        *between,
        ["free", *(f"{float(area):.3f}" for area in by_type(area_of).values())],
    ]


def _area(generators: zonotope.Floats, limit: float) -> float:
    x, y = zonotope.bounded_projection(generators, limit).T
    return float(abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))) / 2
