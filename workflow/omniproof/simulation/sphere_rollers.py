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
from math import cos, radians, sin

import numpy as np
from sympy import ImmutableMatrix, MatrixBase

from omniproof.kinematics import sphere
from omniproof.papers.one_mechanics import friction, platforms
from omniproof.papers.one_mechanics.statements import RADIUS as SYMBOL
from omniproof.simulation.engine import Parameters
from omniproof.simulation.sphere_model import LOAD, RADIUS, Roller

TWO_CONTACTS = ((215, 60), (325, 60))
"""Azimuths and elevations in the simulation of the two-roller paper, degrees."""


@dataclass(frozen=True)
class SetUp:
    """Some rollers, and the steady spins of dry friction: all between two ends, (3,) in rad/s."""

    rollers: tuple[Roller, ...]
    dry_ends: tuple[np.ndarray, np.ndarray]

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

    def nearest_dry(self, spin: np.ndarray) -> tuple[np.ndarray, float]:
        """Steady spin of dry friction nearest to a spin, and its share of the way between the ends.

        The share is 0 where the ends are one spin.
        """
        first, last = self.dry_ends
        way = last - first
        square = float(way @ way)
        share = float(np.clip((spin - first) @ way / square, 0, 1)) if square > 1e-24 else 0.0
        return first + share * way, share


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
    return SetUp(rollers, (dry, dry))


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
    return SetUp(rollers, (first, last) if heavier == 1 else (first, first))


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
    return two_rollers(float(parameters["tilt_deg"]), float(parameters["heavier"]))


def _columns(rollers: Sequence[Roller]) -> tuple[list[MatrixBase], list[MatrixBase], list[float]]:
    return (
        [ImmutableMatrix(roller.contact) for roller in rollers],
        [ImmutableMatrix(roller.axis) for roller in rollers],
        [roller.speed for roller in rollers],
    )


def _floats(vector: MatrixBase) -> np.ndarray:
    return np.array(vector.evalf().tolist(), dtype=float).ravel()
