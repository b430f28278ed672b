"""Set-ups of both sphere papers as numbers, and the steady spins that theory gives them.

Two theories compete. Both say where the torques of the contacts balance: viscous friction at the
least sum of squared slips, the papers' point; dry friction under equal loads at the least sum of
slips (the theorems of `papers.one_mechanics.friction`). That is one spin for three raised rollers,
and for two rollers any spin between both of their lines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import combinations
from math import cos, radians, sin

import numpy as np
from sympy import ImmutableMatrix, MatrixBase

from omniproof.kinematics import sphere
from omniproof.papers.one_mechanics import friction, platforms
from omniproof.papers.one_mechanics.statements import RADIUS as SYMBOL
from omniproof.papers.one_mechanics.statements import REGULAR
from omniproof.simulation.engine import Parameters
from omniproof.simulation.sphere_model import LOAD, RADIUS, Roller

TWO_CONTACTS = ((215, 60), (325, 60))
"""Azimuths and elevations in the simulation of the two-roller paper, degrees."""

SAME = 1e-9
"""Spins (rad/s), or speeds (m/s), that differ by less are equal but for rounding."""


@dataclass(frozen=True)
class SetUp:
    """Some rollers, and the steady spins of dry friction.

    These are all between the `dry_corners`, (3,) each in rad/s: a point, a segment, a triangle.
    """

    rollers: tuple[Roller, ...]
    dry_corners: tuple[np.ndarray, ...]

    @cached_property
    def least_squares(self) -> np.ndarray:
        """Spin with the least sum of squared slips: (3,), in rad/s."""
        return _floats(sphere.least_squares_spin(*_columns(self.rollers), RADIUS))

    def slips(self, spin: np.ndarray) -> np.ndarray:
        """Sizes of the slips at a spin (rad/s): (N,), in m/s."""
        squares = sphere.squared_distances(
            ImmutableMatrix(spin), *_columns(self.rollers), radius=RADIUS
        )
        return RADIUS * np.sqrt(np.array(squares, dtype=float).clip(0))

    def nearest_dry(self, spin: np.ndarray) -> tuple[np.ndarray, tuple[float, ...]]:
        """Steady spin of dry friction nearest to a spin, and the shares of the corners in it."""
        shares = _nearest(np.array(self.dry_corners), spin)
        return shares @ np.array(self.dry_corners), tuple(map(float, shares))


@cache
def three_rollers(elevation_deg: float, phase_deg: float) -> SetUp:
    """Pattern of the three-roller paper: one elevation, inputs of one phase.

    Raises `ValueError` from 35.26 degrees on, where dry friction holds no roller. Source: Kimura,
    Ogata, Hirai, Ueda, Ishii, "A Modeling of Sphere Considering Slipping Adapted Three-Rollers",
    section 3.
    """
    if not 0 <= radians(elevation_deg) < friction.STICKS_BELOW:
        raise ValueError(f"expected an elevation from 0 to 35.26 degrees, got {elevation_deg}")
    # The inputs sin(phi + 240), sin(phi + 120), sin(phi) are those of this velocity (m/s).
    phase = radians(phase_deg)
    point = {
        platforms.ELEVATION: radians(elevation_deg),
        **dict(zip(platforms.VELOCITY[:2], (sin(phase), -cos(phase)), strict=True)),
        SYMBOL: RADIUS,
    }
    rollers = tuple(
        Roller(_floats(contact.subs(point)), _floats(axis), float(speed.subs(point)), LOAD)
        for contact, axis, speed in platforms.raised_triangle()
    )
    outward = [platforms.VELOCITY.dot(friction.outward(k)).subs(point) for k in range(len(rollers))]
    middle = sorted(range(len(rollers)), key=lambda k: float(outward[k]))[1]
    dry = _floats(friction.dry_spin(middle).subs(point))
    return SetUp(rollers, (dry,))


@cache
def two_rollers(tilt_deg: float, heavier: float = 1.0) -> SetUp:
    """Symmetric arrangement of the two-roller paper, driven so that the sphere travels at 1 m/s.

    Roller 1 has the angle `tilt_deg` and `heavier` times the load of roller 2; both have one speed,
    which is travel towards 90 degrees. Raises `ValueError` for `heavier` below 1. Source: Kimura,
    Ogata, Ishii, "Novel Mathematical Modeling and Motion Analysis of a Sphere Considering
    Slipping", Eqs. (5), (6) and section 3.
    """
    if heavier < 1:
        raise ValueError(f"expected roller 1 to bear the greater load, got {heavier} of roller 2's")
    contacts = [sphere.contact_direction(*map(radians, place)) for place in TWO_CONTACTS]
    normal = contacts[0].cross(contacts[1]).normalized()
    axes = [
        sphere.roller_axis(normal.cross(contact), normal, sign * radians(tilt_deg))
        for sign, contact in zip((1, -1), contacts, strict=True)
    ]
    spin = _floats(sphere.least_squares_spin(contacts, axes, [1.0, 1.0], RADIUS))
    speed = 1 / float(RADIUS * np.hypot(spin[0], spin[1]))
    rollers = tuple(
        Roller(_floats(contact), _floats(axis), speed, load)
        for contact, axis, load in zip(contacts, axes, (heavier * LOAD, LOAD), strict=True)
    )
    first, last = _ends(rollers)
    # Unequal loads leave one end: there the roller with the greater load sticks (thm:dry-two).
    one_spin = heavier > 1 or np.linalg.norm(last - first) < SAME
    return SetUp(rollers, (first,) if one_spin else (first, last))


@cache
def equator_rollers(speeds: str) -> SetUp:
    """Regular triangle on the equator, its rollers lying level, driven at `speeds` (m/s).

    Under dry friction any spin is steady at which all slip one way (thm:dry-equator); its corners
    are where two of the rollers do not slip. Source: as for `three_rollers`, Pattern I, whose
    speeds add up to zero, so that the triangle is a point. Raises `ValueError` for such speeds, and
    for others than three.
    """
    given = [float(speed) for speed in speeds.split()]
    if len(given) != len(REGULAR) or abs(sum(given)) < SAME:
        raise ValueError(f"expected three speeds that do not add up to zero, got {speeds!r}")
    rollers = tuple(
        Roller(
            _floats(sphere.contact_direction(azimuth, 0)),
            _floats(sphere.tangent_base(azimuth, 0)[0]),
            speed,
            LOAD,
        )
        for azimuth, speed in zip(REGULAR, given, strict=True)
    )
    pairs = combinations(rollers, 2)
    corners = (_floats(sphere.least_squares_spin(*_columns(pair), RADIUS)) for pair in pairs)
    return SetUp(rollers, tuple(corners))


def _ends(rollers: Sequence[Roller]) -> list[np.ndarray]:
    """Ends of the common perpendicular: where the spin half-way stands above each line."""
    middle = _floats(sphere.least_squares_spin(*_columns(rollers), RADIUS))
    ends = []
    for contact, axis, speed in zip(*_columns(rollers), strict=True):
        foot, direction = map(_floats, sphere.constraint_line(contact, axis, speed, RADIUS))
        ends.append(foot + (middle - foot) @ direction * direction)
    return ends


def set_up(parameters: Parameters) -> SetUp:
    """Set-up of a case by its parameters; `ValueError` for one that theory says nothing about."""
    if "elevation_deg" in parameters:
        return three_rollers(float(parameters["elevation_deg"]), float(parameters["phase_deg"]))
    if "speeds" in parameters:
        return equator_rollers(str(parameters["speeds"]))
    return two_rollers(float(parameters["tilt_deg"]), float(parameters["heavier"]))


def _nearest(corners: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Return the shares (n,) of `corners` (n, 3) in the place of their hull nearest to a `point`.

    On every face (corner, side, whole) the foot of the perpendicular: of those inside, the nearest.
    """
    best, least = np.zeros(len(corners)), np.inf
    for size in range(1, len(corners) + 1):
        for face in map(list, combinations(range(len(corners)), size)):
            first, *others = corners[face]
            ways = np.array(others).reshape(-1, 3) - first
            along = np.linalg.lstsq(ways.T, point - first, rcond=None)[0]
            shares = np.array([1 - along.sum(), *along])
            distance = float(np.linalg.norm(point - shares @ corners[face]))
            if (shares >= 0).all() and distance < least:
                best, least = np.zeros(len(corners)), distance
                best[face] = shares
    return best


def _columns(rollers: Sequence[Roller]) -> tuple[list[MatrixBase], list[MatrixBase], list[float]]:
    return (
        [ImmutableMatrix(roller.contact) for roller in rollers],
        [ImmutableMatrix(roller.axis) for roller in rollers],
        [roller.speed for roller in rollers],
    )


def _floats(vector: MatrixBase) -> np.ndarray:
    return np.array(vector.evalf().tolist(), dtype=float).ravel()
