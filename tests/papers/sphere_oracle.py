"""Both simulations on spheres in plain numbers, by least squares: nothing of the package."""

from __future__ import annotations

from typing import Any

import numpy as np
from mpmath import radians
from sphere_by_hand import best_spin, in_the_world, motion, slip

Floats = Any


def contact(azimuth_deg: float, elevation_deg: float) -> Floats:
    a, b = np.radians([azimuth_deg, elevation_deg])
    return np.array([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)])


def travel(angle_deg: float, direction_deg: float) -> tuple[Floats, Floats, list[float]]:
    """Rim speeds, spin and slips along the tangents with which the sphere travels at 1 m/s."""
    case = angle_deg / 10
    speeds, spin, slips = motion(case, radians(direction_deg))
    contacts = [np.array(p, dtype=float) for p, _, _ in in_the_world(case)]
    normal = np.cross(*contacts) / np.linalg.norm(np.cross(*contacts))
    along = [
        float(np.array(slipping, dtype=float) @ np.cross(normal, p))
        for slipping, p in zip(slips, contacts, strict=True)
    ]
    return np.array(speeds, dtype=float), np.array(spin, dtype=float), along


def opposite(angle_deg: float) -> Floats:
    """Spin of the two rollers of the simulation with the rim speeds 1 and -1."""
    (first, second) = in_the_world(angle_deg / 10)
    return np.array(best_spin([first, (*second[:2], -1)], 1), dtype=float)


def pattern(elevation_deg: float, parameter_deg: float) -> tuple[Floats, list[Floats]]:
    """Spin and slips of a pattern of the three-roller simulation."""
    speeds = np.sin(np.radians([parameter_deg + shift for shift in (240, 120, 0)]))
    rollers = [
        (list(contact(azimuth, elevation_deg)), list(contact(azimuth + 90, 0)), float(speed))
        for azimuth, speed in zip((30, 150, 270), speeds, strict=True)
    ]
    spin = best_spin(rollers, 1)
    slips = [np.array(slip(spin, roller, 1), dtype=float) for roller in rollers]
    return np.array(spin, dtype=float), slips
