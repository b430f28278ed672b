"""Negative controls: formulas of omni-trajectory *as printed*, beside what the simulation did.

A simulation that agreed with every formula would prove nothing. So each printed formula that the
audit refutes, and that predicts a motion, is read from `paper_data` as it stands there, misprints
and all, and has to be off by far more than the corrected one. No formula is typed here again.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from math import degrees, hypot
from pathlib import Path
from typing import Any

import numpy as np
from sympy import Expr, ImmutableMatrix, Symbol, lambdify

from omniproof.audit.context import Context
from omniproof.papers.omni_trajectory.derivations import REGISTRY
from omniproof.papers.omni_trajectory.derivations.quantities import CHANGING_SPEEDS
from omniproof.papers.omni_trajectory.symbols import (
    BODY_RADIUS,
    CONSTANT_SPEEDS,
    HEADING,
    TIME,
    VELOCITY,
)
from omniproof.simulation.measures import (
    angle_between,
    circle,
    first_direction,
    length_error,
    mean_error,
    path_length,
)
from omniproof.transcription.loader import load_paper

PAPER = Path("paper_data/omni-trajectory")


Speeds = tuple[Any, ...]
"""Speeds of the three wheels in m/s, exact."""

UNITS: Mapping[str, str] = {
    "length_error_eq_8_9": "1",
    "mean_error_eq_8_9": "1",
    "direction_error_eq_14": "deg",
    "radius_error_eq_13": "1",
    "centre_error_eq_16": "1",
    "length_error_tab_2": "1",
}


def path_controls(
    time: np.ndarray, places: np.ndarray, speeds: Speeds, twist: ImmutableMatrix, body_radius: Any
) -> dict[str, float]:
    """Errors of the printed path, speed and first direction, for `places` (n, 2) at `time` (n,)."""
    path = printed_path(time, speeds, body_radius)
    printed_length = printed_speed() * time[-1]
    seen = first_direction(places, float(twist[2]) * time[-1])
    return {
        "length_error_eq_8_9": length_error(path, places),
        "mean_error_eq_8_9": mean_error(time, path, places),
        "length_error_tab_2": abs(1 - path_length(places) / printed_length),
        "direction_error_eq_14": degrees(angle_between(seen, _printed_direction(twist))),
    }


def circle_controls(places: np.ndarray, speeds: Speeds, body_radius: Any) -> dict[str, float]:
    """Errors of the printed radius and centre, relative to the printed and the actual radius."""
    centre, radius = circle(places)
    factor, vector = (
        printed(f"eq:16/{part}", speeds, body_radius) for part in ("factor", "line-1")
    )
    off = centre - np.array(factor * vector, dtype=float).ravel()
    return {
        "radius_error_eq_13": abs(1 - radius / float(printed("eq:13", speeds, body_radius))),
        "centre_error_eq_16": hypot(*off) / radius,
    }


def printed_path(time: np.ndarray, speeds: Speeds, body_radius: Any) -> np.ndarray:
    """Return the path (n, 2) in m of Eqs. (8) and (9), as printed."""
    pair = [printed(claim, speeds, body_radius) for claim in ("eq:8", "eq:9")]
    return path_at(time, TIME, pair)


def printed_speed() -> float:
    """Return the speed (m/s) that Table 2 prints."""
    return float(_context().claims["tab:2[V]"].printed or "nan")


def path_at(time: np.ndarray, variable: Symbol, path: Iterable[Expr]) -> np.ndarray:
    """Return places (n, 2) of a path, two expressions of a time `variable`, at `time` (n,)."""
    coordinates = (lambdify(variable, coordinate, "numpy")(time) for coordinate in path)
    return np.column_stack([np.broadcast_to(values, time.shape) for values in coordinates])


def _printed_direction(twist: ImmutableMatrix) -> float:
    value = _context().evaluate("eq:14/velocities")
    moving = dict(zip(VELOCITY, twist[:2, 0], strict=True))
    return float(value.subs({**moving, HEADING: 0}))


@cache
def printed(claim: str, speeds: Speeds, body_radius: Any) -> Any:
    """Return what a printed formula says for constant wheel `speeds` and a body radius (m), exact.

    A path is a function of the time `TIME`; of a chain, the last side counts. Raises `KeyError` for
    a claim that is not there.
    """
    value = _context().evaluate(claim)
    last = value[-1] if isinstance(value, tuple) else value
    known = dict(zip(CHANGING_SPEEDS, speeds, strict=True))
    known |= dict(zip(CONSTANT_SPEEDS, speeds, strict=True))
    return last.subs(known | {BODY_RADIUS: body_radius}).doit()


@cache
def _context() -> Context:
    return Context(load_paper(PAPER), REGISTRY, {})
