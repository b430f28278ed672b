"""The quantities of the paper from first principles, and the symbols they are written in.

Everything that rests on mechanics starts from `omni.velocity_matrix`, hence from the rolling
constraint. The paper's A is that matrix: the third unknown is L times the yaw rate.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from sympy import (
    Abs,
    Expr,
    ImmutableMatrix,
    cancel,
    expand,
    eye,
    factor,
    ones,
    pi,
    sqrt,
    symbols,
)

from omniproof.kinematics import omni, zonotope
from omniproof.papers.omni_arrangement.arrangements import isosceles
from omniproof.papers.omni_arrangement.symbols import (
    ANGLE,
    ANGLES,
    RADIUS,
    SYMBOLS,
    THETA,
    V_X,
    V_Y,
    VELOCITY,
    YAW_RATE,
)
from omniproof.registry import Registry

REGISTRY = Registry("omni-arrangement", symbols=SYMBOLS)


@dataclass(frozen=True)
class Platform:
    """Wheel matrix A of an arrangement with its determinant, adjugate and inverse (3 x 3 each)."""

    matrix: ImmutableMatrix
    determinant: Expr
    adjugate: ImmutableMatrix
    inverse: ImmutableMatrix


@cache
def platform(angles: tuple[Expr, ...]) -> Platform:
    """Derive the matrices of the arrangement with the wheels at `angles` (rad)."""
    return invert(omni.velocity_matrix(angles))


def general() -> Platform:
    """Three wheels anywhere on the circle."""
    return platform(ANGLES)


@cache
def any_directions() -> Platform:
    """Three wheels with free driven directions: columns 1 and 2 are six free symbols.

    What holds here holds for every arrangement, and is rational in the symbols. The third column
    is that of the platform: every wheel turns the body with the same lever.
    """
    free = ImmutableMatrix(3, 2, symbols("n_1x n_1y n_2x n_2y n_3x n_3y", real=True))
    return invert(ImmutableMatrix.hstack(free, general().matrix[:, 2]))


def invert(matrix: ImmutableMatrix) -> Platform:
    """Adjugate and determinant of a 3 x 3 matrix by cross products of its rows."""
    first, second, third = (matrix[k, :] for k in range(3))
    adjugate = ImmutableMatrix.hstack(
        second.cross(third).T, third.cross(first).T, first.cross(second).T
    )
    determinant = first.dot(second.cross(third))
    return Platform(matrix, determinant, adjugate, adjugate / determinant)


def image_volume(determinant: Expr) -> Expr:
    """Volume of the image of the wheel-speed cube |v_k| <= 1 m/s, in (m/s)^3.

    A linear map multiplies volumes by |det|; that of A^-1 is 1 / |det A|.
    """
    return zonotope.volume(eye(3)) / Abs(determinant)


def image_area(determinant: Expr) -> Expr:
    """Area of the image's projection on the velocity plane, in (m/s)^2.

    The projection is a zonotope of the three projected columns, with |v_k| <= 1 m/s.
    """
    return 4 * sum(Abs(product) for product in cross_products()) / Abs(determinant)


@cache
def cross_products() -> tuple[Expr, Expr, Expr]:
    """Return det A times (a_2 x a_3)_z, (a_1 x a_3)_z and (a_1 x a_2)_z, for free directions."""
    free = any_directions()
    columns = [free.inverse[:, k] for k in range(3)]
    pairs = ((1, 2), (0, 2), (0, 1))
    return tuple(cancel(columns[i].cross(columns[k])[2] * free.determinant) for i, k in pairs)


def free_vectors(dimension: int = 3) -> tuple[ImmutableMatrix, ...]:
    """Return three vectors with free entries, for lemmas on any vectors."""
    names = [[f"a_{axis}{k}" for axis in range(1, dimension + 1)] for k in (1, 2, 3)]
    return tuple(ImmutableMatrix(symbols(column, real=True)) for column in names)


def norm(vector: ImmutableMatrix) -> Expr:
    """Length of a vector (n x 1)."""
    return sqrt(sum(entry**2 for entry in vector))


@REGISTRY.quantity("q_k")
def contact() -> ImmutableMatrix:
    """Contact point of wheel k."""
    return omni.contact_position(ANGLE, RADIUS)


@REGISTRY.quantity("n_k")
def direction() -> ImmutableMatrix:
    """Driven direction of wheel k: the counter-clockwise tangent."""
    return omni.tangential_direction(ANGLE)


@REGISTRY.quantity("v_k")
def speed() -> Expr:
    """Speed of wheel k, by the rolling constraint."""
    return omni.rolling_speed(direction(), contact(), ImmutableMatrix(VELOCITY), YAW_RATE)


@REGISTRY.quantity("v_k_translation")
def translational_speed() -> Expr:
    """Speed of wheel k when the platform does not turn."""
    return speed().subs(YAW_RATE, 0)


@REGISTRY.quantity("v_k_rotation")
def rotational_speed() -> Expr:
    """Speed of wheel k when the platform turns on the spot."""
    return speed().subs({V_X: 0, V_Y: 0})


@REGISTRY.quantity("det_A")
def determinant() -> Expr:
    """Determinant of A."""
    return general().determinant


@REGISTRY.quantity("D_V", of=[THETA])
def volume_of_family() -> Expr:
    """Image volume of the isosceles family."""
    return image_volume(factor(expand(platform(isosceles(THETA)).determinant)))


@REGISTRY.quantity("D_A")
def area() -> Expr:
    """Area of the projection."""
    return image_area(general().determinant)


@REGISTRY.quantity("OH")
def height() -> Expr:
    """Height of the parallelepiped of three free vectors over the plane of the first two."""
    first, second, third = free_vectors()
    columns = ImmutableMatrix.hstack(first, second, third)
    return Abs(invert(columns).determinant) / norm(first.cross(second))


for _k in range(3):
    REGISTRY.quantity(f"a_{_k + 1}")(lambda k=_k: general().inverse[:, k])
    REGISTRY.quantity(f"a_hat_{_k + 1}")(lambda k=_k: projected(k))
    for _i in range(3):
        REGISTRY.quantity(f"adj_{_i + 1}{_k + 1}")(lambda i=_i, k=_k: general().adjugate[i, k])
for _k in range(2):
    REGISTRY.quantity(f"projected_{_k + 1}")(lambda k=_k: projected(k))


def projected(k: int) -> ImmutableMatrix:
    """Column k of the inverse with its third component put to zero: 3 x 1."""
    first, second, _ = general().inverse[:, k]
    return ImmutableMatrix([first, second, 0])


@REGISTRY.quantity("arc_A")
def first_arc() -> Expr:
    """Arc from wheel 1 to wheel 2."""
    return ANGLES[1] - ANGLES[0]


@REGISTRY.quantity("arc_B")
def second_arc() -> Expr:
    """Arc from wheel 2 to wheel 3."""
    return ANGLES[2] - ANGLES[1]


@REGISTRY.quantity("arc_C")
def third_arc() -> Expr:
    """Arc from wheel 3 on to wheel 1."""
    return 2 * pi - (ANGLES[2] - ANGLES[0])


@REGISTRY.quantity("vector_a")
def any_vector() -> ImmutableMatrix:
    """Any vector in space."""
    return free_vectors()[0]


@REGISTRY.quantity("vector_b")
def any_other_vector() -> ImmutableMatrix:
    """Any other vector in space."""
    return free_vectors()[1]


@cache
def sum_of_columns() -> ImmutableMatrix:
    """Twist for three equal wheel speeds of 1 m/s: the sum of the columns of the inverse, 3 x 1."""
    return (any_directions().inverse * ones(3, 1)).applyfunc(cancel)


REGISTRY.abbreviations[r"\det \mathbf{A}"] = determinant
