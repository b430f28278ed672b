"""Spheres on rollers in plain NumPy, by least squares and cross products: an independent check."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np


def contact(azimuth_deg: float, elevation_deg: float) -> Any:
    a, b = np.radians([azimuth_deg, elevation_deg])
    return np.array([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)])


def map_of(contacts: Sequence[Any], axes: Sequence[Any]) -> Any:
    """Matrix from rim speeds to the spin with the least squares, for a sphere of radius 1."""
    rows = np.vstack([_skew(p) for p in contacts])
    columns = [
        np.concatenate(
            [np.cross(p, eta) if i == k else np.zeros(3) for i, p in enumerate(contacts)]
        )
        for k, (p, eta) in enumerate(zip(contacts, axes, strict=True))
    ]
    return np.linalg.lstsq(rows, np.column_stack(columns), rcond=None)[0]


def slip(spin: Any, p: Any, eta: Any, speed: float) -> Any:
    return np.cross(spin, p) - speed * np.cross(p, eta)


def _skew(p: Any) -> Any:
    """Matrix of the map from a spin to spin x p."""
    return np.column_stack([np.cross(unit, p) for unit in np.eye(3)])


def symmetric_pair(angle_deg: float) -> tuple[list[Any], list[Any], list[Any]]:
    """Contacts, axes and tangents of the two-roller simulation."""
    contacts = [contact(215, 60), contact(325, 60)]
    normal = np.cross(*contacts)
    normal /= np.linalg.norm(normal)
    tangents = [np.cross(normal, p) for p in contacts]
    turned = np.radians([angle_deg, -angle_deg])
    axes = [x * np.cos(a) + normal * np.sin(a) for x, a in zip(tangents, turned, strict=True)]
    return contacts, axes, tangents


def travel(angle_deg: float, direction_deg: float) -> tuple[Any, Any, list[float]]:
    """Rim speeds, spin and slips along the tangents with which the sphere travels at 1 m/s."""
    contacts, axes, tangents = symmetric_pair(angle_deg)
    turning = map_of(contacts, axes)
    phi = np.radians(direction_deg)
    speeds = np.linalg.solve(turning[:2], [-np.sin(phi), np.cos(phi)])
    spin = turning @ speeds
    slips = [
        float(slip(spin, p, eta, speed) @ x)
        for p, eta, speed, x in zip(contacts, axes, speeds, tangents, strict=True)
    ]
    return speeds, spin, slips


def pattern(elevation_deg: float, parameter_deg: float) -> tuple[Any, list[Any]]:
    """Spin and slips of a pattern of the three-roller simulation."""
    azimuths = (30, 150, 270)
    contacts = [contact(a, elevation_deg) for a in azimuths]
    axes = [contact(a + 90, 0) for a in azimuths]
    speeds = np.sin(np.radians([parameter_deg + shift for shift in (240, 120, 0)]))
    spin = map_of(contacts, axes) @ speeds
    return spin, [slip(spin, *roller) for roller in zip(contacts, axes, speeds, strict=True)]
