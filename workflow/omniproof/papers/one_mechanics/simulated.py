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


EQUATOR = (
    "contacts, start",
    "off least squares",
    "off the triangle",
    "sum of slips",
    "slips",
)
"""Heads of `equator`: spins in rad/s, slips in m/s."""

ON_EQUATOR = {
    "viscous": "viscous, from rest",
    "dry": "dry, from rest",
    "dry-from-aside": "dry, let go turning slowly",
    "dry-from-far-0": "dry, let go turning fast about 0°",
    "dry-from-far-60": "dry, about 60°",
    "dry-from-far-180": "dry, about 180°",
}
"""Cases of level rollers on the equator, in words."""

DRY_CREEP = 0.001
"""Creep of dry contacts, m/s: a roller that sticks slips by less."""

LIMIT = 0.99
"""Friction above this part of its limit is at its limit, but for round-off."""

LAST_DIGIT = 1e-6
"""What runs are rounded to, rad/s."""


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
    dry = _three_dry(summary)
    return f"{min(case['error_least_squares'] / case['error_dry'] for case in dry):.0f}"


def dry_circles(summary: pd.DataFrame) -> str:
    """Radii (rad/s) of the circles of three dry rollers, from the least to the greatest."""
    radii = [case["circle_radius"] for case in _three_dry(summary)]
    return " to ".join(dict.fromkeys(f"{end:.3f}" for end in (min(radii), max(radii))))


def sticking(summary: pd.DataFrame) -> str:
    """How many of three dry rollers stick: friction below its limit, and no slip but the creep."""
    counts = {
        sum(case[f"grip_{k}"] < LIMIT and case[f"slip_{k}"] < 2 * DRY_CREEP for k in (1, 2, 3))
        for case in _three_dry(summary)
    }
    return " or ".join(str(count) for count in sorted(counts))


def share_between(summary: pd.DataFrame, start: str) -> str:
    """Share of the way between two lines at which dry friction stops the sphere, over all tilts."""
    numbers = _by_case(summary)
    shares = [numbers[f"two-{tilt}-dry{start}"]["share"] for tilt in TILTS_DEG if tilt]
    return " to ".join(dict.fromkeys(f"{end:.3f}" for end in (min(shares), max(shares))))


def over_creep(summary: pd.DataFrame) -> str:
    """Distance from the dry theorem over the creep, below a tenth of the viscous one, in 1/m."""
    numbers = _by_case(summary)
    ratios = [
        1000 * numbers[case]["error_dry"] / creep
        for case, (creep, _) in CREEPS.items()
        if creep <= 100
    ]
    return f"{min(ratios):.2f} to {max(ratios):.2f}"


def change_by_step(summary: pd.DataFrame) -> str:
    """How much a finer step changes the distance from the dry theorem, in rad/s."""
    numbers = _by_case(summary)
    found = [numbers[case]["error_dry"] for case, (creep, _) in CREEPS.items() if creep == 1]
    change = max(found) - min(found)
    return f"{change:.6f}" if change >= LAST_DIGIT else f"less than {LAST_DIGIT:.6f}"


def equator(summary: pd.DataFrame) -> list[list[str]]:
    """Rollers on the equator, viscous and dry from several starts; `EQUATOR`."""
    numbers = _by_case(summary)
    rows = []
    for case, words in ON_EQUATOR.items():
        found = numbers[f"three-equator-{case}"]
        slips = ", ".join(_short(found[f"slip_{k}"]) for k in (1, 2, 3))
        off = (found[name] for name in ("error_least_squares", "error_dry", "sum_of_slips"))
        rows.append([words, *map(_short, off), slips])
    return rows


def _three_dry(summary: pd.DataFrame) -> list[Mapping[str, float]]:
    numbers = _by_case(summary)
    return [numbers[f"three-{e}-{p}-dry"] for e, p in product(ELEVATIONS_DEG, PHASES_DEG)]


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
