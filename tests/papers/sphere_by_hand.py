"""Sphere and rollers in plain numbers, written without the package: bodies and least squares."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from by_hand import cross, length
from mpmath import cos, lu_solve, matrix, mpf, radians, sin

Vector = list[Any]
Roller = tuple[Vector, Vector, Any]
"""Contact direction, axis, rim speed."""


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def scaled(factor: Any, a: Sequence[Any]) -> Vector:
    return [factor * x for x in a]


def less(a: Sequence[Any], b: Sequence[Any]) -> Vector:
    return [x - y for x, y in zip(a, b, strict=True)]


def added(*vectors: Sequence[Any]) -> Vector:
    return [sum(column) for column in zip(*vectors, strict=True)]


def in_plane(azimuth: Any, angle: Any, speed: Any) -> Roller:
    """Roller on the equator; its axis is turned out of the equator by its angle."""
    contact = [cos(azimuth), sin(azimuth), mpf(0)]
    axis = [-sin(azimuth) * cos(angle), cos(azimuth) * cos(angle), sin(angle)]
    return contact, axis, speed


def drives(roller: Roller) -> Vector:
    """Velocity of the rim: a roller turns about its axis, and drives across it."""
    contact, axis, speed = roller
    return scaled(speed, cross(contact, axis))


def slip(spin: Sequence[Any], roller: Roller, radius: Any) -> Vector:
    return less(scaled(radius, cross(list(spin), roller[0])), drives(roller))


def best_spin(rollers: Sequence[Roller], radius: Any) -> Vector:
    """Spin with the least sum of squared slips: slips are linear in it."""
    rows, right = [], []
    units = [[mpf(i == k) for i in range(3)] for k in range(3)]
    for roller in rollers:
        columns = [scaled(radius, cross(unit, roller[0])) for unit in units]
        rows += [[column[i] for column in columns] for i in range(3)]
        right += drives(roller)
    slips = matrix(rows)
    return list(lu_solve(slips.T * slips, slips.T * matrix(right)))


def in_the_world(case: int) -> list[Roller]:
    """Both rollers with unit rim speed, as Section 3 places them."""
    contacts = [
        [cos(radians(60)) * cos(radians(a)), cos(radians(60)) * sin(radians(a)), sin(radians(60))]
        for a in (215, 325)
    ]
    normal = cross(*contacts)
    normal = scaled(1 / length(normal), normal)
    rollers = []
    for contact, side in zip(contacts, (1, -1), strict=True):
        angle = radians(10 * case * side)
        across = cross(normal, contact)
        rollers.append((contact, added(scaled(cos(angle), across), scaled(sin(angle), normal)), 1))
    return rollers


def motion(case: int, phi: Any) -> tuple[Vector, Vector, list[Vector]]:
    """Rim speeds, spin and slips with which the sphere travels along phi (r = V = 1)."""
    both_rollers = in_the_world(case)
    columns = [
        best_spin(
            [
                (contact, axis, int(k == chosen))
                for k, (contact, axis, _) in enumerate(both_rollers)
            ],
            1,
        )
        for chosen in (0, 1)
    ]
    rows = [[columns[0][k], columns[1][k], -mpf(k == 2)] for k in range(3)]
    *speeds, vertical = lu_solve(matrix(rows), matrix([-sin(phi), cos(phi), 0]))
    spin = [-sin(phi), cos(phi), vertical]
    slips = [
        slip(spin, (contact, axis, speed), 1)
        for (contact, axis, _), speed in zip(both_rollers, speeds, strict=True)
    ]
    return speeds, spin, slips  # fmt: skip
