"""Sphere at a fixed centre, driven by N rollers that touch it: constraint lines, spin, slip.

A roller asks for one velocity at its contact, its rim speed along the driven direction and nothing
along its axis. That leaves the sphere the spins on one line, parallel to the contact. N lines
need not meet; the papers take the point with the least sum of squared distances to them. A
distance is slip over radius, so that point is the spin with the least sum of squared slips.

Mechanics enters by `surface_map` only, the Jacobian of `rolling.rolling_speed` by the spin: lines,
normal equations and slip are written with it and not with cross products of their own. The normal
equations are solved by adjugate over determinant: placements with free angles stay short enough to
be read, and the determinant says by itself which placements have no unique optimum.

Conventions: SI units and radians; all vectors are 3x1, the sphere's centre is the origin. Contact
p and roller axis eta are unit vectors, eta is tangent at p, the driven direction is e = p x eta. A
rim speed nu is positive where it moves the sphere's surface along e; so <eta, omega> = -nu / r.
Azimuth from x towards y, elevation from the xy-plane towards z.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from typing import TypeAlias

from sympy import Add, Dummy, Expr, ImmutableMatrix, MatrixBase, cos, sin, zeros

from omniproof.kinematics import rolling
from omniproof.kinematics.frames import UNIT
from omniproof.kinematics.scalars import Scalar, exact, tidy, vanishes

Vector: TypeAlias = MatrixBase
"""3x1."""


def contact_direction(azimuth: Scalar, elevation: Scalar) -> ImmutableMatrix:
    """Unit vector p from the centre to a contact: 3x1; angles in rad."""
    a, b = exact(azimuth), exact(elevation)
    return ImmutableMatrix([cos(b) * cos(a), cos(b) * sin(a), sin(b)])


def tangent_base(azimuth: Scalar, elevation: Scalar) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Tangents X (east) and Y (north) at a contact, X x Y = p: 3x1 each; angles in rad.

    Source: Kimura, Ogata, Hirai, Ueda, Ishii, "A Modeling of Sphere Considering Slipping Adapted
    Three-Rollers", Eq. (4).
    """
    a, b = exact(azimuth), exact(elevation)
    east = ImmutableMatrix([-sin(a), cos(a), 0])
    north = ImmutableMatrix([-sin(b) * cos(a), -sin(b) * sin(a), cos(b)])
    return east, north


def roller_axis(first: Vector, second: Vector, angle: Scalar) -> ImmutableMatrix:
    """Axis eta = X cos + Y sin of a roller, from the tangents X, Y and its `angle` (rad): 3x1."""
    turn = exact(angle)
    return ImmutableMatrix(first * cos(turn) + second * sin(turn))


def driven_direction(contact: Vector, axis: Vector) -> ImmutableMatrix:
    """Direction e = p x eta in which a roller drives the surface: 3x1, unit."""
    return ImmutableMatrix(contact.cross(axis))


def surface_map(contact: Vector) -> ImmutableMatrix:
    """Matrix S from the spin to the surface's velocity at a contact, for radius 1: 3x3.

    Row k is the rolling constraint along the k-th coordinate. S is skew, and its kernel is p.
    """
    return _surface_map(ImmutableMatrix(contact), rolling.rolling_speed)


def constraint_line(
    contact: Vector, axis: Vector, speed: Scalar, radius: Scalar
) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Line of the spins (rad/s) that slip nowhere on one roller: foot -(nu/r) eta, direction p.

    `speed` nu (m/s), `radius` r (m); 3x1 each. The foot is the spin of least size. Source: the
    same paper, Eq. (2).
    """
    return _foot(contact, axis, exact(speed) / exact(radius)), ImmutableMatrix(contact)


def normal_matrix(contacts: Sequence[Vector]) -> ImmutableMatrix:
    """Matrix of the normal equations, the sum of I - p p^T over N contacts: 3x3.

    Regular unless all contacts lie on one line through the centre. Raises `ValueError` for N = 0.
    """
    if not contacts:
        raise ValueError("expected at least 1 contact, got 0")
    maps = [surface_map(contact) for contact in contacts]
    total = sum((slip.T * slip for slip in maps), zeros(3, 3))
    return ImmutableMatrix(total).applyfunc(tidy)


def right_side(
    contacts: Sequence[Vector], axes: Sequence[Vector], speeds: Sequence[Scalar], radius: Scalar
) -> ImmutableMatrix:
    """Right side of the normal equations, the sum of the lines' feet -(nu/r) eta: 3x1, in rad/s.

    Raises `ValueError` unless there are as many axes and speeds as contacts.
    """
    return ImmutableMatrix(sum(_feet(contacts, axes, speeds, radius), zeros(3, 1)))


def least_squares_spin(
    contacts: Sequence[Vector], axes: Sequence[Vector], speeds: Sequence[Scalar], radius: Scalar
) -> ImmutableMatrix:
    """Spin (rad/s) with the least sum of squared slips: 3x1, the only one.

    `speeds` nu (m/s), `radius` r (m). Raises `ValueError` where it is not unique: all contacts on
    one line through the centre. Errors of `normal_matrix` and `right_side` too.
    """
    feet = right_side(contacts, axes, speeds, radius)
    return _product(_inverse(normal_matrix(contacts)), feet)


def spin_map(contacts: Sequence[Vector], axes: Sequence[Vector], radius: Scalar) -> ImmutableMatrix:
    """Matrix from N rim speeds (m/s) to `least_squares_spin` (rad/s): 3xN. Errors as there."""
    feet = _feet(contacts, axes, [1] * len(axes), radius)
    return _product(_inverse(normal_matrix(contacts)), ImmutableMatrix.hstack(*feet))


def slip_velocity(
    spin: Vector, contact: Vector, axis: Vector, speed: Scalar, radius: Scalar
) -> ImmutableMatrix:
    """Velocity of the surface over the roller at a contact: 3x1, in m/s.

    `spin` omega (3x1, rad/s), `speed` nu (m/s), `radius` r (m). It is omega x (r p) - nu e.
    """
    rim = exact(speed) * driven_direction(contact, axis)
    return ImmutableMatrix(exact(radius) * surface_map(contact) * spin - rim)


def squared_distances(
    spin: Vector,
    contacts: Sequence[Vector],
    axes: Sequence[Vector],
    speeds: Sequence[Scalar],
    radius: Scalar,
) -> tuple[Expr, ...]:
    """Squared distance (rad/s)^2 of a spin to each roller's line: its squared slip over r^2.

    Raises `ValueError` unless there are as many axes and speeds as contacts.
    """
    slips = [
        slip_velocity(spin, p, eta, speed, radius) / exact(radius)
        for p, eta, speed in _rollers(contacts, axes, speeds)
    ]
    return tuple(slip.dot(slip) for slip in slips)


@lru_cache(maxsize=64)
def _surface_map(contact: ImmutableMatrix, law: Callable[..., Expr]) -> ImmutableMatrix:
    """Surface map under a law of rolling: matrix, feet and slips ask for the same few contacts."""
    spin = tuple(Dummy(f"w_{axis}") for axis in UNIT)
    turning = rolling.Twist(zeros(3, 1), ImmutableMatrix(spin))
    speeds = [law(unit, contact, turning) for unit in UNIT.values()]
    return ImmutableMatrix(speeds).jacobian(spin)


def _feet(
    contacts: Sequence[Vector], axes: Sequence[Vector], speeds: Sequence[Scalar], radius: Scalar
) -> list[ImmutableMatrix]:
    return [
        _foot(p, eta, exact(speed) / exact(radius))
        for p, eta, speed in _rollers(contacts, axes, speeds)
    ]


def _foot(contact: Vector, axis: Vector, rate: Expr) -> ImmutableMatrix:
    """Least spin that gives the surface the speed `rate` along e: S^T inverts S, since |p| = 1."""
    turning = surface_map(contact).T * driven_direction(contact, axis)
    return ImmutableMatrix(rate * turning.applyfunc(tidy))


def _inverse(matrix: ImmutableMatrix) -> ImmutableMatrix:
    determinant = matrix.det(method="berkowitz")
    if vanishes(determinant):
        raise ValueError("the contacts lie on one line through the centre: spin about it is free")
    return ImmutableMatrix(matrix.adjugate(method="berkowitz") / determinant)


def _product(left: MatrixBase, right: MatrixBase) -> ImmutableMatrix:
    """Product of matrices of finite entries: before 0 x, SymPy proves x finite, however long."""
    return ImmutableMatrix(
        left.rows,
        right.cols,
        lambda i, j: Add(*(left[i, k] * right[k, j] for k in range(left.cols) if right[k, j] != 0)),
    )


def _rollers(
    contacts: Sequence[Vector], axes: Sequence[Vector], speeds: Sequence[Scalar]
) -> Iterator[tuple[Vector, Vector, Scalar]]:
    """Yield contact, axis and speed of each roller."""
    if not len(contacts) == len(axes) == len(speeds):
        counts = f"{len(contacts)} contacts, {len(axes)} axes, {len(speeds)} speeds"
        raise ValueError(f"expected one axis and one speed a contact, got {counts}")
    return zip(contacts, axes, speeds, strict=True)
