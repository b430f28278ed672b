"""What the simulated sphere says about friction, as tables; the runs are in `simulation.sphere`.

The numbers come as the long table of all simulations (model, case, quantity, value, unit), since
chapters show what was recorded and simulate nothing.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from math import cos, radians, sin, sqrt, tan

import pandas as pd

ELEVATIONS_DEG = (10, 20, 30)
PHASES_DEG = (17, 55)
TILTS_DEG = (0, 10, 20, 30)

CREEPS = {
    "three-30-17-viscous": (1000, "1"),
    **{f"three-30-17-creep-{mm}-mm": (mm, "1") for mm in (300, 100, 30, 10, 3)},
    "three-30-17-dry": (1, "1"),
    "three-30-17-dry-step-500-us": (1, "0.5"),
    "three-30-17-dry-step-250-us": (1, "0.25"),
}
"""Cases that differ in the creep (mm/s) and the step (ms) only."""

HALF_BETWEEN = sqrt((1 + cos(radians(60)) ** 2 * cos(radians(110)) + sin(radians(60)) ** 2) / 2)
"""Cosine of half the angle between the two contacts, at azimuths 110 degrees apart."""

RAISED = (
    "elevation, phase",
    "viscous: off least squares",
    "circle",
    r"$1/(1+\sin^2\theta)$",
    "dry: off the theorem",
    "off least squares",
    "circle",
    "friction that holds",
    r"$\sqrt3\sin\theta$",
)
"""Heads of `three_rollers`: spins and radii of circles in rad/s, friction in units of its limit."""

PAIR = (
    r"$\alpha_1$",
    "viscous: off least squares",
    "slip",
    r"$\cos(\beta/2)\tan\alpha_1$",
    "dry: from rest",
    "let go turning",
    "sum of slips",
)
"""Heads of `two_rollers`: spins in rad/s, slips in m/s; dry: share of the way between the lines."""

LADDER = ("creep, mm/s", "step, ms", "off least squares", "off the dry theorem", "over the creep")
"""Heads of `creeps`: spins in rad/s, the last column in 1/m."""


def three_rollers(summary: pd.DataFrame) -> list[list[str]]:
    """Both kinds of friction at each elevation and phase, beside what theory has; `RAISED`."""
    numbers = _by_case(summary)
    rows = []
    for elevation in ELEVATIONS_DEG:
        sine = sin(radians(elevation))
        for phase in PHASES_DEG:
            viscous = numbers[f"three-{elevation}-{phase}-viscous"]
            dry = numbers[f"three-{elevation}-{phase}-dry"]
            held = min(dry[f"grip_{number}"] for number in (1, 2, 3))
            found = [viscous["error_least_squares"], viscous["circle_radius"], 1 / (1 + sine**2)]
            found += [dry[name] for name in ("error_dry", "error_least_squares", "circle_radius")]
            row = [_short(value) for value in (*found, held, sqrt(3) * sine)]
            rows.append([f"{elevation}°, {phase}°", *row])
    return rows


def two_rollers(summary: pd.DataFrame) -> list[list[str]]:
    """Symmetric rollers at each angle: viscous, then dry from two starts; `PAIR`."""
    numbers = _by_case(summary)
    rows = []
    for tilt in TILTS_DEG:
        viscous = numbers[f"two-{tilt}-viscous"]
        rest, turning = (numbers[f"two-{tilt}-dry{start}"] for start in ("", "-from-far"))
        slip = HALF_BETWEEN * tan(radians(tilt))
        found = [viscous["error_least_squares"], viscous["slip_1"], slip]
        # Lines that meet have no way between them.
        shares = [_short(dry["share"]) if tilt else "" for dry in (rest, turning)]
        rows.append([f"{tilt}°", *map(_short, found), *shares, _short(turning["sum_of_slips"])])
    return rows


def creeps(summary: pd.DataFrame) -> list[list[str]]:
    """One set-up from viscous to dry; `LADDER`."""
    numbers = _by_case(summary)
    rows = []
    for case, (creep, step) in CREEPS.items():
        off = [numbers[case][name] for name in ("error_least_squares", "error_dry")]
        rows.append([str(creep), step, *map(_short, (*off, 1000 * off[1] / creep))])
    return rows


def margin(summary: pd.DataFrame) -> str:
    """By how much dry friction is farther from least squares than from its theorem, at least."""
    numbers = _by_case(summary)
    cases = (f"three-{place[0]}-{place[1]}-dry" for place in product(ELEVATIONS_DEG, PHASES_DEG))
    dry = [numbers[case] for case in cases]
    return f"{min(case['error_least_squares'] / case['error_dry'] for case in dry):.0f}"


def heavier(summary: pd.DataFrame) -> Mapping[str, str]:
    """Numbers of the case in which roller 1 bears more: slips in m/s, friction over its limit."""
    found = _by_case(summary)["two-30-dry-heavier"]
    return {name: _short(found[name]) for name in ("slip_1", "slip_2", "grip_1")}


def _by_case(summary: pd.DataFrame) -> Mapping[str, Mapping[str, float]]:
    """Quantities by case of the sphere; raises `KeyError` without any."""
    own = summary[summary["model"] == "sphere"]
    if own.empty:
        raise KeyError("no simulation of the sphere among the numbers")
    found: dict[str, dict[str, float]] = {}
    for case, quantity, value in zip(own["case"], own["quantity"], own["value"], strict=True):
        found.setdefault(case, {})[quantity] = float(value)
    return found


def _short(value: float) -> str:
    """Write three digits; what is below a ten thousandth by its power of ten."""
    if 0 < value < 1e-4:
        digits, power = f"{value:.0e}".split("e")
        return rf"${digits}\cdot10^{{{int(power)}}}$"
    return f"{value:.3f}" if value >= 0.01 or value == 0 else f"{value:.5f}"
