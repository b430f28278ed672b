"""Mechanics of the three-wheeled platform in plain numbers, written without the package.

Everything starts from a rigid body: the contact point q of a wheel moves with V + w z x q, and the
wheel turns with the component along its driven direction n. Nothing here is symbolic, and nothing
comes from what the paper prints.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from mpmath import cos, det, inverse, matrix, mp, mpf, radians, sin, sqrt

mp.dps = 40
Plane = tuple[mpf, mpf]
ONE = mpf(1)


def speed(angle: mpf, radius: mpf, v_x: mpf, v_y: mpf, yaw_rate: mpf) -> mpf:
    """Speed of the wheel at `angle`: velocity of its contact, along the tangent."""
    q_x, q_y = radius * cos(angle), radius * sin(angle)
    u_x, u_y = v_x - yaw_rate * q_y, v_y + yaw_rate * q_x
    return -sin(angle) * u_x + cos(angle) * u_y


def wheels(angles: Sequence[mpf], lever: mpf = ONE) -> matrix:
    """Matrix on (V_x, V_y, radius / lever * yaw rate), column by column from unit motions."""
    unit = ((1, 0, 0), (0, 1, 0), (0, 0, lever))
    return matrix([[speed(a, ONE, *motion) for motion in unit] for a in angles])


def adjugate(of: matrix) -> matrix:
    """Determinant times inverse."""
    return det(of) * inverse(of)


def hull_area(points: Sequence[Plane]) -> mpf:
    """Area of the convex hull: monotone chain, then the shoelace formula."""
    ordered = sorted(points)
    corners = _chain(ordered)[:-1] + _chain(ordered[::-1])[:-1]
    pairs = zip(corners, corners[1:] + corners[:1], strict=True)
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs) / 2


def _chain(points: Sequence[Plane]) -> list[Plane]:
    chain: list[Plane] = []
    for p in points:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0:
            chain.pop()
        chain.append(p)
    return chain


def _turn(a: Plane, b: Plane, c: Plane) -> mpf:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def images(angles: Sequence[mpf]) -> list[matrix]:
    """Twists of the eight corners of the cube of wheel speeds."""
    back = inverse(wheels(angles))
    return [back * matrix(corner) for corner in product((-1, 1), repeat=3)]


def volume(angles: Sequence[mpf]) -> mpf:
    """Volume of the image: three edges from one corner."""
    low, *_ = corners = images(angles)
    edges = [corners[k] - low for k in (1, 2, 4)]
    return abs(det(matrix([list(edge) for edge in edges])))


def area(angles: Sequence[mpf]) -> mpf:
    """Area of the image's shadow on the velocity plane."""
    return hull_area([(twist[0], twist[1]) for twist in images(angles)])


def half_widths(angles: Sequence[mpf]) -> list[mpf]:
    """Greatest component of the image along each axis."""
    return [max(twist[axis] for twist in images(angles)) for axis in range(3)]


def section(angles: Sequence[mpf]) -> mpf:
    """Area of the velocities without rotation: a large square, cut by six half planes."""
    big = mpf(1000)
    polygon = [(-big, -big), (big, -big), (big, big), (-big, big)]
    for angle in angles:
        for side in (1, -1):
            polygon = _cut(polygon, (-side * sin(angle), side * cos(angle)))
    return hull_area(polygon)


def _cut(polygon: list[Plane], normal: Plane) -> list[Plane]:
    """Keep the part of a polygon where normal . p <= 1."""
    kept: list[Plane] = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1], strict=True):
        at_p, at_q = (normal[0] * a + normal[1] * b - 1 for a, b in (p, q))
        if at_p <= 0:
            kept.append(p)
        if at_p * at_q < 0:
            t = at_p / (at_p - at_q)
            kept.append((p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])))
    return kept


def degrees(*angles_deg: float) -> list[mpf]:
    """Angles in radians."""
    return [radians(mpf(angle)) for angle in angles_deg]


def cross(a: Sequence[mpf], b: Sequence[mpf]) -> list[mpf]:
    """Vector product."""
    return [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]


def length(a: Sequence[mpf]) -> mpf:
    """Euclidean norm."""
    return sqrt(sum(x * x for x in a))
