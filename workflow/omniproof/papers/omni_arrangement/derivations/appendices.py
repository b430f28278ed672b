"""Appendices (A) to (D): cofactors, volume, minimum, area of the projection."""

from __future__ import annotations

from functools import cache

from sympy import (
    Abs,
    Expr,
    ImmutableMatrix,
    Integer,
    Symbol,
    cancel,
    pi,
    sin,
    sqrt,
)

from omniproof.kinematics import omni, zonotope
from omniproof.papers.omni_arrangement.arrangements import isosceles
from omniproof.papers.omni_arrangement.derivations.evaluation import (
    ARCS,
    VOLUME_RATIO,
    planar_columns,
    sign_of_product,
    volume_by_arcs,
)
from omniproof.papers.omni_arrangement.derivations.quantities import (
    REGISTRY,
    Platform,
    any_directions,
    cross_products,
    first_arc,
    free_vectors,
    general,
    height,
    image_volume,
    invert,
    norm,
    platform,
    projected,
    second_arc,
    third_arc,
)
from omniproof.papers.omni_arrangement.symbols import ANGLES, RADIUS, SPEEDS, THETA, V_X, V_Y
from omniproof.registry import Convention, Family, Obligation, Relation
from omniproof.transcription.model import Form

MATRIX = "app:A/matrix"
COLUMN_OF_ONES = "the unknown is L times the yaw rate: third column 1"
COLUMN_OF_RADII = "the unknown is the yaw rate: third column L"
REGISTRY.conventions[MATRIX] = Convention(COLUMN_OF_ONES, (COLUMN_OF_RADII,))


@cache
def platform_by(convention: str) -> Platform:
    """Return the platform with the third column of its matrix as the convention has it."""
    lever = RADIUS if convention == COLUMN_OF_RADII else Integer(1)
    return invert(omni.wheel_matrix(ANGLES, lever))


@REGISTRY.derives("app:A/cofactor-of")
def cofactor_and_entry() -> Relation:
    """The adjugate is the transpose of the matrix of cofactors: entry (1, 2) of both."""
    matrix, adjugate = general().matrix, general().adjugate
    return Relation(
        (matrix.cofactor(0, 1), adjugate[0, 1]),
        correction=r"\widetilde{a}_{i,j} \text{ is the cofactor of } a_{j,i}",
        proof=tuple(
            Obligation(Form.EQUAL, (matrix.cofactor(j, i), adjugate[i, j]))
            for i in range(3)
            for j in range(3)
        ),
    )


@REGISTRY.derives("eq:A.1", rests_on=["app:A/cofactor-of"])
def inverse_by_cofactors() -> ImmutableMatrix:
    """Inverse of A times its determinant."""
    return general().adjugate


for _i, _k in ((1, 1), (2, 2), (1, 2), (2, 1), (1, 3), (2, 3)):
    REGISTRY.derives(f"eq:A.2/a{_i}{_k}", convention=MATRIX)(
        lambda convention, i=_i, k=_k: platform_by(convention).adjugate[i - 1, k - 1]
    )


@REGISTRY.derives("eq:A.3", "eq:C.6", convention=MATRIX)
def determinant_of_a(convention: str) -> Expr:
    """Determinant of the matrix of Appendix (A)."""
    return platform_by(convention).determinant


for _k in (1, 2, 3):
    REGISTRY.derives(f"eq:A.4/a3{_k}-line-1", f"eq:A.4/a3{_k}-line-2")(
        lambda k=_k: general().adjugate[2, k - 1]
    )


def _any_columns() -> dict[str, ImmutableMatrix]:
    return {f"a_{k}": vector for k, vector in enumerate(free_vectors(), 1)}


@REGISTRY.derives("app:B/spanned")
def volume_of_domain() -> Relation:
    """Volume of the domain that three free vectors span, and of their parallelepiped."""
    columns = ImmutableMatrix.hstack(*free_vectors())
    return Relation((zonotope.volume(columns), 8 * Abs(invert(columns).determinant)))


@REGISTRY.derives("app:B/image-volume")
def volume_and_image_volume() -> Relation:
    """Volume that the columns of the inverse span, and the image volume: wheels turn both ways."""
    determinant = general().determinant
    spanned, image = 1 / Abs(determinant), image_volume(determinant)
    return Relation(
        (spanned, image),
        correction=r"D_V = 8 \left|\det[\mathbf{a}_1, \mathbf{a}_2, \mathbf{a}_3]\right|",
        proof=(Obligation(Form.EQUAL, (8 * spanned, image)),),
    )


@REGISTRY.derives("app:B/area-of-base", meanings=_any_columns)
def area_of_base() -> Expr:
    """Area of a parallelogram by its sides and their inner product (Lagrange's identity)."""
    first, second, _ = free_vectors()
    return sqrt(first.dot(first) * second.dot(second) - first.dot(second) ** 2)


@REGISTRY.derives("app:B/unit-normal")
def length_of_normal() -> Relation:
    """Length of the normal after division by its norm."""
    first, second, _ = free_vectors()
    base = first.cross(second)
    normal = base / norm(base)
    return Relation((normal.dot(normal), Integer(1)))


@REGISTRY.derives("app:B/normal")
def products_with_normal() -> Relation:
    """Inner products of the normal with the edges of the base."""
    first, second, _ = free_vectors()
    base = first.cross(second)
    return Relation((base.dot(first), base.dot(second), Integer(0)))


@REGISTRY.derives("eq:B.2", rests_on=[VOLUME_RATIO], meanings=_any_columns)
def height_over_base() -> Expr:
    """Height of the parallelepiped: the length of the projection of a_3 on the normal."""
    return height()


@REGISTRY.derives("eq:B.3", rests_on=["eq:B.2"], meanings=_any_columns)
def volume_by_height() -> Expr:
    """Volume of the parallelepiped of three vectors."""
    return Abs(triple_product())


@REGISTRY.derives("eq:B.3#2/volume", rests_on=[VOLUME_RATIO], meanings=_any_columns)
def volume_by_triple_product() -> Expr:
    """Volume of the parallelepiped of three vectors."""
    return volume_by_height()


@REGISTRY.derives("eq:B.3#2/determinant", meanings=_any_columns)
def triple_product() -> Expr:
    """Determinant of three vectors."""
    return invert(ImmutableMatrix.hstack(*free_vectors())).determinant


@REGISTRY.derives("eq:C.4/arc-a")
def arc_a() -> Expr:
    """Arc from wheel 1 to wheel 2."""
    return first_arc()


@REGISTRY.derives("eq:C.4/arc-b")
def arc_b() -> Expr:
    """Arc from wheel 2 to wheel 3."""
    return second_arc()


@REGISTRY.derives("eq:C.4/arc-c")
def arc_c() -> Expr:
    """Arc from wheel 3 on to wheel 1."""
    return third_arc()


@REGISTRY.derives("app:C/sum-of-two-arcs")
def two_arcs() -> Expr:
    """Sum of the first two arcs."""
    return first_arc() + second_arc()


@REGISTRY.derives("eq:C.5")
def sine_of_third_arc() -> Expr:
    """Sine of the third arc."""
    return sin(third_arc())


@REGISTRY.derives("eq:C.6/condition")
def full_turn() -> Expr:
    """Sum of all arcs."""
    return first_arc() + second_arc() + third_arc()


@REGISTRY.derives("app:C/mean-arc")
def mean_arc() -> Expr:
    """Mean of all arcs."""
    return full_turn() / 3


@REGISTRY.derives("app:C/sine-concave")
def sine_over_arcs() -> Relation:
    """Sine over every arc that two wheels can leave between them."""
    arc = Symbol("t", real=True)
    return Relation(Family(sin(arc), {arc: (Integer(0), 2 * pi)}))


def determinant_by_arcs() -> Family:
    """Determinant of A over all arrangements, by two arcs (rad)."""
    first, second = ARCS
    determinant = platform((Integer(0), first, first + second)).determinant
    return Family(determinant, dict.fromkeys(ARCS, (Integer(0), 2 * pi)))


@REGISTRY.derives("app:C/sine-maximal-at-120")
def maximum_of_sine() -> Relation:
    """The sine itself is largest at 90 degrees; the sum of three is largest at 120 degrees each."""
    arc = Symbol("t", real=True)
    return Relation(
        Family(sin(arc), {arc: (Integer(0), 2 * pi)}),
        correction=r"\sin A + \sin B + \sin C \text{ is largest at } A = B = C = 120^\circ",
        proof=(Obligation(Form.MAXIMUM, determinant_by_arcs(), at=((2 * pi / 3,) * 2,)),),
    )


@REGISTRY.derives("app:C/inverse-maximal")
def inverse_of_determinant() -> Relation:
    """1/det A over the isosceles family with det A > 0."""
    family = Family(1 / platform(isosceles(THETA)).determinant, {THETA: (-pi / 2, pi / 2)})
    return Relation(
        family,
        correction=r"1/\det \mathbf{A} \text{ is smallest there, where } \det \mathbf{A} > 0",
        proof=(Obligation(Form.MINIMUM, family, at=((pi / 6,),)),),
    )


@REGISTRY.derives("app:C/volume-minimised", rests_on=[VOLUME_RATIO])
def least_volume() -> Relation:
    """Image volume over all arrangements."""
    return Relation(volume_by_arcs())


@REGISTRY.derives("app:D/linear-combination")
def velocity() -> ImmutableMatrix:
    """Velocity part of the image of the wheel speeds of a twist, for free driven directions."""
    free = any_directions()
    image = free.inverse * (free.matrix * ImmutableMatrix([V_X, V_Y, RADIUS]))
    return image.applyfunc(cancel)[:2, :]


@REGISTRY.derives("eq:D.1", rests_on=["eq:D.1/vector-names"])
def point_of_parallelogram() -> ImmutableMatrix:
    """Velocity for given speeds of wheels 1 and 2 while wheel 3 stands."""
    return projected(0) * SPEEDS[0] + projected(1) * SPEEDS[1]


@REGISTRY.derives("app:D/u-is-parallelogram")
def edges_of_parallelogram() -> Relation:
    """(det A)^2 times the squared cross product of the edges of U."""
    *_, first_second = cross_products()
    return Relation((first_second**2,))


@REGISTRY.derives("app:D/case-2-occurs", rests_on=["sec:3/two-cases"])
def sign_in_case_2() -> Relation:
    """(det A)^2 times the product that Case 2 needs to be positive."""
    return sign_of_product()


def _corners() -> tuple[ImmutableMatrix, ...]:
    """Corners of the hexagon in order: the columns taken with the signs that lie outermost."""
    first, second, third = planar_columns().values()
    signs = ((1, 1, -1), (1, -1, -1), (1, -1, 1), (-1, -1, 1), (-1, 1, 1), (-1, 1, -1))
    return tuple(a * first + b * second + c * third for a, b, c in signs)


@REGISTRY.derives("app:D/opposite-sides-parallel")
def opposite_sides() -> Relation:
    """Cross products of opposite sides of the hexagon."""
    corners = _corners()
    sides = [corners[(k + 1) % 6] - corners[k] for k in range(6)]
    return Relation((*(sides[k].cross(sides[k + 3])[2] for k in range(3)), Integer(0)))


@REGISTRY.derives("app:D/half-of-the-hexagon")
def half_of_hexagon() -> Relation:
    """Half the area of the hexagon, and the parallelogram and the triangle that make it up."""
    first, second, third = planar_columns().values()
    parallelogram = norm((2 * (first - second)).cross(third))
    triangle = norm((2 * first).cross(2 * second)) / 2
    hexagon = zonotope.volume(ImmutableMatrix.hstack(first, second, third)[:2, :])
    return Relation((hexagon / 2, parallelogram + triangle))


REGISTRY.abbreviations[r"\det[\mathbf{a}_1, \mathbf{a}_2, \mathbf{a}_3]"] = triple_product
REGISTRY.abbreviations[r"\|\mathbf{a}_1 \times \mathbf{a}_2\|"] = lambda: norm(
    free_vectors()[0].cross(free_vectors()[1])
)
