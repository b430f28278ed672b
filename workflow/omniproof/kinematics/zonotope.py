"""Image of the cube |v_k| <= bound under a linear map: a zonotope, exact and for drawing.

A zonotope is the sum of segments [-g_k, g_k], one a column of the map. Its volume is a sum over
d-subsets of columns and its width along an axis a sum of absolute values, so both stay exact for
any number of wheels, and no hull of the 2^N corner images is ever formed. For drawing, its faces
come from pairs of generators (the generators in the plane of a pair span the face, the others shift
it), which needs no general hull code and treats parallel and coplanar generators rightly.

Sources: Shephard, Combinatorial properties of associated zonotopes (1974), for the volume;
Ziegler, Lectures on Polytopes, 7.3, for the faces.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cmp_to_key
from itertools import combinations, pairwise, product
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray
from sympy import Abs, Expr, ImmutableMatrix, Integer, MatrixBase, Rational, radsimp

Floats: TypeAlias = NDArray[np.float64]

DIGITS = 60
"""Working precision of exact comparisons; values below 10^-40 count as equal."""

TOLERANCE = 1e-12
"""Relative size below which a numeric generator counts as zero or as lying in a plane."""


def volume(generators: MatrixBase, bound: Expr | int = 1) -> Expr:
    """Volume (area for d = 2) of the image: (2 bound)^d sum |det of d columns|.

    `generators`: d x N, exact; `bound` of each |v_k|. Unit: that of the generators' rows times
    `bound`, to the power d. Raises `ValueError` for N < d, where the image is flat.
    """
    dimension, count = generators.shape
    if count < dimension:
        raise ValueError(f"expected at least {dimension} generators, got {count}")
    subsets = combinations(range(count), dimension)
    minors = (generators[:, list(chosen)].det(method="berkowitz") for chosen in subsets)
    return (2 * bound) ** dimension * sum((Abs(minor) for minor in minors), Integer(0))


def half_widths(generators: MatrixBase, bound: Expr | int = 1) -> tuple[Expr, ...]:
    """Greatest value along each axis: bound * sum_k |g_k[i]|, a tuple of d expressions."""
    rows, columns = generators.shape
    return tuple(
        bound * sum((Abs(generators[i, k]) for k in range(columns)), Integer(0))
        for i in range(rows)
    )


def projection(generators: MatrixBase, axes: Sequence[int] = (0, 1)) -> ImmutableMatrix:
    """Generators of the orthographic projection on `axes`: len(axes) x N, exact."""
    return ImmutableMatrix(generators[list(axes), :])


def section(matrix: MatrixBase, axis: int = 2, bound: int = 1) -> tuple[ImmutableMatrix, ...]:
    """Twists without motion along `axis` that keep all wheel speeds within `bound`.

    `matrix` A: N x 3, exact numbers. The polygon {V : |A (V, 0)|_inf <= bound} in the plane of the
    other two axes, as its vertices (2x1, exact), counter-clockwise, the first at the least
    direction in (-pi, pi]. Raises `ValueError` where it is unbounded.
    """
    kept = [column for column in range(matrix.shape[1]) if column != axis]
    rows = matrix[:, kept]
    corners: list[ImmutableMatrix] = []
    for i, j in combinations(range(rows.shape[0]), 2):
        pair = rows[[i, j], :]
        determinant = pair.det()
        if _sign(determinant) == 0:
            continue
        inverse = pair.adjugate() / determinant
        for signs in product((bound, -bound), repeat=2):
            point = (inverse * ImmutableMatrix(signs)).applyfunc(radsimp)
            if _within(rows, point, bound) and not any(_equal(point, old) for old in corners):
                corners.append(ImmutableMatrix(point))
    if not corners:
        raise ValueError("the section is unbounded: the driven directions are parallel")
    return tuple(sorted(corners, key=cmp_to_key(_by_direction)))


def polygon_area(vertices: Sequence[MatrixBase]) -> Expr:
    """Area of a simple polygon, exact (shoelace); positive for counter-clockwise `vertices`."""
    closed = [*vertices, vertices[0]]
    twice = sum((a[0] * b[1] - a[1] * b[0] for a, b in pairwise(closed)), Integer(0))
    return Rational(1, 2) * twice


def vertices(generators: Floats, bound: float = 1.0) -> Floats:
    """Vertices of the zonotope of d x N numeric `generators`, d = 2 or 3: M x d.

    In the plane counter-clockwise. Raises `ValueError` for another d, or a flat image.
    """
    scaled = bound * np.asarray(generators, dtype=np.float64)
    if scaled.shape[0] == 2:
        return _planar(scaled)
    corners: list[Floats] = []
    for face in faces(scaled):
        for corner in face:
            if not any(np.allclose(corner, old, rtol=0, atol=_small(scaled)) for old in corners):
                corners.append(corner)
    return np.array(corners)


def faces(generators: Floats) -> tuple[Floats, ...]:
    """Faces of the zonotope of 3 x N numeric `generators`, each m x 3 in order around it.

    Counter-clockwise seen from outside; six parallelograms for N = 3. Raises `ValueError` for
    another dimension and for coplanar generators.
    """
    columns = np.asarray(generators, dtype=np.float64)
    if columns.shape[0] != 3:
        raise ValueError(f"expected generators in 2 or 3 dimensions, got {columns.shape[0]}")
    if np.linalg.matrix_rank(columns) < 3:
        raise ValueError("the generators lie in one plane: the image has no volume")
    return tuple(_face(columns, normal) for normal in _normals(columns))


def bounded_projection(generators: Floats, limit: float) -> Floats:
    """Projection on the first two axes of the part with |third coordinate| <= `limit`: M x 2.

    `generators`: 3 x N, numeric; the polygon is counter-clockwise. With the twist's matrix these
    are the velocities a platform reaches while its rotation stays within `limit`. Raises
    `ValueError` for a limit that is not positive (for no rotation at all see `section`).
    """
    if not limit > 0:
        raise ValueError(f"expected a positive limit, got {limit}")
    points: list[Floats] = []
    for face in faces(generators):
        for start, end in zip(face, np.roll(face, -1, axis=0), strict=True):
            points.extend(_clipped(start, end, limit))
    return _hull(np.array(points)[:, :2])


def _clipped(start: Floats, end: Floats, limit: float) -> list[Floats]:
    """End points of the part of an edge between the two planes."""
    rise = end[2] - start[2]
    if rise == 0:
        return [start, end] if abs(start[2]) <= limit else []
    low, high = sorted(((-limit - start[2]) / rise, (limit - start[2]) / rise))
    low, high = max(low, 0.0), min(high, 1.0)
    return [start + t * (end - start) for t in (low, high)] if low <= high else []


def _planar(generators: Floats) -> Floats:
    """Walk around a planar zonotope: its edges are twice the generators, by rising direction."""
    flipped = np.array([g if (g[1], g[0]) > (0, 0) else -g for g in generators.T])
    size = _small(generators)
    kept = [g for g in flipped if np.linalg.norm(g) > size]
    merged: list[Floats] = []
    for g in sorted(kept, key=lambda g: float(np.arctan2(g[1], g[0]))):
        if merged and abs(merged[-1][0] * g[1] - merged[-1][1] * g[0]) <= size * np.linalg.norm(g):
            merged[-1] = merged[-1] + g
        else:
            merged.append(g)
    if len(merged) < 2:
        raise ValueError("the generators are parallel: the image has no area")
    steps = [-np.sum(merged, axis=0), *(2 * g for g in merged), *(-2 * g for g in merged)]
    return np.array(np.cumsum(steps, axis=0)[:-1])


def _normals(columns: Floats) -> list[Floats]:
    """Outward unit normals of the faces, each once."""
    found: list[Floats] = []
    for i, j in combinations(range(columns.shape[1]), 2):
        cross = np.cross(columns[:, i], columns[:, j])
        length = np.linalg.norm(cross)
        if length <= _small(columns) ** 2:
            continue
        for normal in (cross / length, -cross / length):
            if not any(normal @ old > 1 - TOLERANCE for old in found):
                found.append(normal)
    return found


def _face(columns: Floats, normal: Floats) -> Floats:
    """Face of greatest n . x: generators across the normal span it, the others shift it."""
    heights = normal @ columns
    within = np.abs(heights) <= _small(columns)
    offset = columns[:, ~within] @ np.sign(heights[~within])
    flat = columns[:, within]
    first = flat[:, int(np.argmax(np.linalg.norm(flat, axis=0)))]
    first = first / np.linalg.norm(first)
    basis = np.array([first, np.cross(normal, first)])
    return np.array(offset + _planar(basis @ flat) @ basis)


def _hull(points: Floats) -> Floats:
    """Convex hull in the plane, counter-clockwise (Andrew's monotone chain)."""
    size = _small(points.T)
    ordered = sorted({(round(x / size) * size, round(y / size) * size) for x, y in points})
    halves = []
    for sequence in (ordered, ordered[::-1]):
        chain: list[tuple[float, float]] = []
        for point in sequence:
            while len(chain) >= 2 and _turn(chain[-2], chain[-1], point) <= size:
                chain.pop()
            chain.append(point)
        halves.extend(chain[:-1])
    return np.array(halves)


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _small(columns: Floats) -> float:
    return TOLERANCE * float(np.max(np.linalg.norm(columns, axis=0)))


def _sign(number: Expr) -> int:
    """Sign of an exact real number; -1, 0 or 1."""
    value = (Integer(0) + number).evalf(DIGITS)
    if abs(value) < Rational(1, 10**40):
        return 0
    return 1 if value > 0 else -1


def _within(rows: MatrixBase, point: MatrixBase, bound: int) -> bool:
    return all(_sign(abs(speed) - bound) <= 0 for speed in rows * point)


def _equal(a: MatrixBase, b: MatrixBase) -> bool:
    return all(_sign(difference) == 0 for difference in a - b)


def _by_direction(a: MatrixBase, b: MatrixBase) -> int:
    """Order of two points around the origin, exactly, from just beyond the negative x-axis."""
    half = _lower(b) - _lower(a)
    return half if half else -_sign(a[0] * b[1] - a[1] * b[0])


def _lower(point: MatrixBase) -> int:
    """1 for directions in (-pi, 0), 0 for [0, pi]: the lower half plane comes first."""
    return int(_sign(point[1]) < 0)
