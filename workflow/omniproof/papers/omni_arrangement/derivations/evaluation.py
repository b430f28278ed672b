"""Section 3: the image of the wheel-speed cube, its volume and the area of its projection."""

from __future__ import annotations

from sympy import Expr, ImmutableMatrix, Integer, Symbol, eye, pi, symbols

from omniproof.kinematics import omni, zonotope
from omniproof.papers.omni_arrangement.arrangements import CORRECTED, isosceles
from omniproof.papers.omni_arrangement.derivations.quantities import (
    REGISTRY,
    any_directions,
    cross_products,
    free_vectors,
    general,
    image_area,
    image_volume,
    invert,
    platform,
    projected,
    sum_of_columns,
    volume_of_family,
)
from omniproof.papers.omni_arrangement.symbols import ANGLES, RADIUS, SPEEDS, THETA
from omniproof.registry import Family, Obligation, Relation
from omniproof.transcription.model import Form

ARCS = symbols("A B", real=True)

VOLUME_RATIO = "sec:3/volume-ratio"
"""Where the paper first takes a determinant, which has a sign, for a volume."""


@REGISTRY.derives("sec:3/cube-edge")
def edge_of_cube() -> Expr:
    """Edge of the cube |v_k| <= 1 m/s: the length of its image under the identity, along x."""
    return 2 * zonotope.half_widths(eye(3))[0]


@REGISTRY.derives("eq:8")
def bound_of_cube() -> Expr:
    """Greatest wheel speed in a cube whose volume is that of an edge of 2 m/s."""
    return edge_of_cube() / 2


@REGISTRY.derives("sec:3/image-is-parallelepiped")
def image_is_solid() -> Relation:
    """Product of the determinants of A and its inverse, for free driven directions."""
    free = any_directions()
    return Relation((invert(free.inverse).determinant * free.determinant, Integer(1)))


@REGISTRY.derives("eq:9")
def point_of_image() -> ImmutableMatrix:
    """Twist for given wheel speeds."""
    return general().inverse * ImmutableMatrix(SPEEDS)


@REGISTRY.derives("eq:10/a1")
def first_column() -> ImmutableMatrix:
    """Column 1 of the inverse."""
    return general().inverse[:, 0]


@REGISTRY.derives("eq:10/a2")
def second_column() -> ImmutableMatrix:
    """Column 2 of the inverse."""
    return general().inverse[:, 1]


@REGISTRY.derives("eq:10/a3")
def third_column() -> ImmutableMatrix:
    """Column 3 of the inverse."""
    return general().inverse[:, 2]


@REGISTRY.derives("sec:3/det-of-inverse")
def determinant_of_inverse() -> Relation:
    """Determinant of the inverse, for free driven directions."""
    free = any_directions()
    return Relation((invert(free.inverse).determinant, 1 / free.determinant))


@REGISTRY.derives(VOLUME_RATIO)
def ratio_of_volumes() -> Relation:
    """Determinant of three free vectors, and the volume ratio of their image and the cube.

    A determinant has a sign; a ratio of volumes has none.
    """
    columns = ImmutableMatrix.hstack(*free_vectors())
    ratio = zonotope.volume(columns) / zonotope.volume(eye(3))
    return Relation((invert(columns).determinant, ratio))


@REGISTRY.derives("eq:11", rests_on=[VOLUME_RATIO])
def volume() -> Expr:
    """Image volume of any arrangement."""
    return image_volume(general().determinant)


@REGISTRY.derives("eq:11/unit", "tab:2/unit-of-volume", "fig:6/unit-of-volume")
def volume_by_speed_limit() -> Relation:
    """Image volume for a speed limit of s m/s, for Type (Y)."""
    limit = Symbol("s", positive=True)
    generators = platform(CORRECTED["Y"]).inverse
    return Relation((zonotope.volume(generators, limit), limit**3 * zonotope.volume(generators)))


@REGISTRY.derives("tab:2/unit-of-area", "fig:6/unit-of-area")
def area_by_speed_limit() -> Relation:
    """Area of the projection for a speed limit of s m/s, for Type (Y)."""
    limit = Symbol("s", positive=True)
    generators = zonotope.projection(platform(CORRECTED["Y"]).inverse)
    return Relation((zonotope.volume(generators, limit), limit**2 * zonotope.volume(generators)))


@REGISTRY.derives("sec:3/isosceles")
def sides_at_apex() -> Relation:
    """Squared distances from wheel 3 to wheels 1 and 2 in the isosceles family."""
    first, second, third = (omni.contact_position(a, RADIUS) for a in isosceles(THETA))
    return Relation(tuple((q - third).dot(q - third) for q in (first, second)))


@REGISTRY.derives("sec:3/three-parameters")
def change_with_each_angle() -> Relation:
    """Squared derivatives of det A by the three angles, at the angles 0, pi/2 and pi/3."""
    determinant = general().determinant
    place = dict(zip(ANGLES, (Integer(0), pi / 2, pi / 3), strict=True))
    return Relation(tuple(determinant.diff(angle).subs(place) ** 2 for angle in ANGLES))


@REGISTRY.derives("eq:12", "eq:12/name", rests_on=[VOLUME_RATIO])
def volume_in_family() -> Expr:
    """Image volume of the isosceles family."""
    return volume_of_family()


def volume_by_arcs() -> Family:
    """Image volume over all arrangements, by the arcs from wheel 1 to 2 and from 2 to 3 (rad).

    Turning all wheels together changes nothing, so that two arcs are all there is to choose.
    """
    first, second = ARCS
    determinant = platform((Integer(0), first, first + second)).determinant
    box = dict.fromkeys(ARCS, (Integer(0), 2 * pi))
    return Family(image_volume(determinant), box)


@REGISTRY.derives(
    "sec:3/minimum-equilateral", "sec:4#2/minimised-at-type-x", rests_on=[VOLUME_RATIO]
)
def least_volume() -> Relation:
    """Image volume over all arrangements."""
    return Relation(volume_by_arcs())


@REGISTRY.derives("eq:13")
def point_of_projection() -> ImmutableMatrix:
    """Velocity for given wheel speeds, as a vector in space."""
    return sum(
        (projected(k) * speed for k, speed in enumerate(SPEEDS)), ImmutableMatrix.zeros(3, 1)
    )


@REGISTRY.derives("eq:14/a1")
def first_projection() -> ImmutableMatrix:
    """Projection of column 1."""
    return projected(0)


@REGISTRY.derives("eq:14/a2")
def second_projection() -> ImmutableMatrix:
    """Projection of column 2."""
    return projected(1)


@REGISTRY.derives("eq:14/a3")
def third_projection() -> ImmutableMatrix:
    """Projection of column 3."""
    return projected(2)


@REGISTRY.derives("sec:3/two-cases")
def sign_of_product() -> Relation:
    """(det A)^2 times the product that distinguishes the cases: it is -1 for every arrangement."""
    second_third, first_third, _ = cross_products()
    product = second_third * first_third
    return Relation(
        (product,),
        correction=(
            r"(\hat{\mathbf{a}}_2 \times \hat{\mathbf{a}}_3)_z "
            r"(\hat{\mathbf{a}}_1 \times \hat{\mathbf{a}}_3)_z = -1/(\det \mathbf{A})^2 < 0"
        ),
        proof=(Obligation(Form.NEGATIVE, (product,)),),
    )


def planar_columns() -> dict[str, ImmutableMatrix]:
    """Projected columns of any arrangement: two free vectors, and the third by `sum_of_columns`."""
    (x_1, y_1), (x_2, y_2) = symbols("x_1 y_1", real=True), symbols("x_2 y_2", real=True)
    first, second = ImmutableMatrix([x_1, y_1, 0]), ImmutableMatrix([x_2, y_2, 0])
    total = sum_of_columns()
    third = ImmutableMatrix([total[0], total[1], 0]) - first - second
    return {"a_hat_1": first, "a_hat_2": second, "a_hat_3": third}


def _area(columns: dict[str, ImmutableMatrix]) -> Expr:
    return zonotope.volume(ImmutableMatrix.hstack(*columns.values())[:2, :])


@REGISTRY.derives("eq:15/case-1", meanings=planar_columns)
def area_of_case_1() -> Expr:
    """Area of the projection of any arrangement, by its projected columns."""
    return _area(planar_columns())


@REGISTRY.derives("eq:15/name")
def area_by_determinant() -> Expr:
    """Area of the projection of any arrangement, by its determinant."""
    return image_area(general().determinant)


def columns_of_case_2() -> dict[str, ImmutableMatrix]:
    """Three plane vectors of which the third lies between the first and minus the second."""
    (x_1, y_1), (x_2, y_2) = symbols("x_1 y_1", real=True), symbols("x_2 y_2", real=True)
    share, other = symbols("p q", positive=True)
    first, second = ImmutableMatrix([x_1, y_1, 0]), ImmutableMatrix([x_2, y_2, 0])
    return {"a_hat_1": first, "a_hat_2": second, "a_hat_3": share * first - other * second}


@REGISTRY.derives("eq:15/case-2", meanings=columns_of_case_2)
def area_of_case_2() -> Expr:
    """Area of the zonotope of three such vectors; no arrangement has them (see `two-cases`)."""
    return _area(columns_of_case_2())


def columns_by_shares() -> dict[str, ImmutableMatrix]:
    """Plane vectors with a_3 = p a_1 + q a_2, in coordinates along a_1 and a_2.

    A change of plane coordinates multiplies every cross product by one factor d, which is not zero
    for independent a_1, a_2; it stands here as the second entry of a_2.
    """
    p, q = symbols("p q", real=True)
    d = Symbol("d", real=True, nonzero=True)
    first, second = ImmutableMatrix([1, 0, 0]), ImmutableMatrix([0, d, 0])
    columns = (first, second, p * first + q * second)
    names = [f"{prefix}_{k}" for prefix in ("a", "a_hat") for k in (1, 2, 3)]
    return dict(zip(names, columns * 2, strict=True))


def _between(sign: int) -> Expr:
    """a_3 between a_1 and sign * a_2, or between their opposites: condition on the shares."""
    p, q = symbols("p q", real=True)
    return p * q * sign > 0


@REGISTRY.derives("eq:15/case-1-condition", "eq:D.2", "eq:D.3", meanings=columns_by_shares)
def condition_of_case_1() -> Relation:
    """a_3 lies between a_1 and a_2, or between -a_1 and -a_2."""
    return Relation(_between(1))


@REGISTRY.derives("eq:15/case-2-condition", meanings=columns_by_shares)
def condition_of_case_2() -> Relation:
    """a_3 lies between a_1 and -a_2, or between -a_1 and a_2."""
    return Relation(_between(-1))


@REGISTRY.derives("sec:4/minimum-of-area", rests_on=["eq:12"])
def least_area_in_family() -> Relation:
    """Area of the projection over the isosceles family with det A > 0."""
    determinant = platform(isosceles(THETA)).determinant
    return Relation(Family(image_area(determinant), {THETA: (-pi / 2, pi / 2)}))


@REGISTRY.derives("sec:4/minimum-of-volume", rests_on=["eq:12"])
def least_volume_in_family() -> Relation:
    """Image volume over the isosceles family with det A > 0."""
    return Relation(Family(volume_of_family(), {THETA: (-pi / 2, pi / 2)}))


@REGISTRY.derives("sec:4/body-radius")
def determinant_by_radius() -> Relation:
    """The wheel matrix on (V_x, V_y, L phi-dot) has the same determinant for every L."""
    full = omni.wheel_matrix(ANGLES, RADIUS).det(method="berkowitz") / RADIUS
    return Relation((full, omni.wheel_matrix(ANGLES, 1).det(method="berkowitz")))
