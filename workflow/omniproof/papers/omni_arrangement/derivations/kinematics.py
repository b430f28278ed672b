"""Section 2: inverse and forward kinematics."""

from __future__ import annotations

from sympy import Abs, Expr, ImmutableMatrix, Integer, Symbol, cos, sin

from omniproof.kinematics import omni
from omniproof.papers.omni_arrangement.derivations.quantities import (
    REGISTRY,
    any_other_vector,
    any_vector,
    contact,
    direction,
    general,
    platform,
    rotational_speed,
    speed,
    translational_speed,
)
from omniproof.papers.omni_arrangement.symbols import (
    ANGLE,
    ANGLES,
    RADIUS,
    V_X,
    V_Y,
    VELOCITY,
    YAW_RATE,
)
from omniproof.registry import Obligation, Relation
from omniproof.transcription.model import Form


@REGISTRY.derives("sec:2/three-wheels")
def number_of_wheels() -> Expr:
    """Count the wheels that make the wheel matrix square."""
    return Integer(general().matrix.cols)


@REGISTRY.derives("sec:2/velocity-frame")
def speed_by_frame() -> Relation:
    """Speed of a wheel with V resolved in the robot frame, and with V in the global frame."""
    heading = Symbol("phi", real=True)
    turned = ImmutableMatrix(
        [[cos(heading), sin(heading)], [-sin(heading), cos(heading)]]
    ) * ImmutableMatrix(VELOCITY)
    in_global = omni.rolling_speed(direction(), contact(), turned, YAW_RATE)
    return Relation(
        (speed(), in_global),
        condition=r"\mathbf{V} \text{ is resolved in the robot frame, or } \phi = 0",
        proof=(Obligation(Form.EQUAL, (speed(), in_global.subs(heading, 0))),),
    )


@REGISTRY.derives("eq:1")
def contact_point() -> ImmutableMatrix:
    """Contact point on the circle of the body."""
    return contact()


@REGISTRY.derives("eq:2")
def driven_direction() -> ImmutableMatrix:
    """Counter-clockwise tangent."""
    return direction()


@REGISTRY.derives("sec:2.1/n-is-unit")
def length_of_direction() -> Relation:
    """Squared length of the driven direction."""
    return Relation((direction().dot(direction()), Integer(1)))


@REGISTRY.derives("sec:2.1/n-perpendicular-to-q")
def direction_across_radius() -> Relation:
    """Inner product of the driven direction and the radius."""
    return Relation((direction().dot(contact()), Integer(0)))


@REGISTRY.derives("sec:2.1/n-from-perpendicularity")
def both_perpendicular_directions() -> Relation:
    """Both unit vectors across the radius are opposite: the sense of the wheel is a convention."""
    n, q = direction(), contact()
    return Relation(
        (n[0], -n[0]),
        condition=r"\mathbf{n}_k \text{ points counter-clockwise around the body}",
        proof=(
            Obligation(Form.EQUAL, ((-n).dot(q), n.dot(q), Integer(0))),
            Obligation(Form.EQUAL, (q[0] * n[1] - q[1] * n[0], RADIUS)),
        ),
    )


@REGISTRY.derives("sec:2.1/translation-is-a-length")
def translational_speed_and_length() -> Relation:
    """The translational part has a sign; the length of a projection has none."""
    return Relation((translational_speed(), Abs(translational_speed())))


@REGISTRY.derives("sec:2.1/translational-part")
def translational_part() -> Expr:
    """Speed of a wheel without rotation."""
    return translational_speed()


@REGISTRY.derives("sec:2.1/rotational-part")
def rotational_part() -> Expr:
    """Speed of a wheel on the spot."""
    return rotational_speed()


@REGISTRY.derives("eq:3", "eq:4", rests_on=["sec:2/velocity-frame"])
def wheel_speed() -> Expr:
    """Speed of a wheel by the rolling constraint."""
    return speed()


@REGISTRY.derives("eq:5", rests_on=["sec:2/velocity-frame"])
def wheel_matrix() -> ImmutableMatrix:
    """Wheel matrix on (V_x, V_y, L phi-dot)."""
    return general().matrix


@REGISTRY.derives("eq:5/twist", "eq:6/twist", "sec:3/linear-map", "sec:3/inverse-map")
def twist() -> ImmutableMatrix:
    """Unknowns of the wheel matrix: each part of a wheel speed over its entry in the matrix."""
    parts = (
        speed().subs({V_Y: 0, YAW_RATE: 0}),
        speed().subs({V_X: 0, YAW_RATE: 0}),
        rotational_speed(),
    )
    row = platform((ANGLE, *ANGLES[1:])).matrix[0, :]
    return ImmutableMatrix([part / entry for part, entry in zip(parts, row, strict=True)])


@REGISTRY.derives("sec:2.2/matrix-order")
def order_of_matrix() -> Expr:
    """Count the rows of the wheel matrix."""
    return Integer(general().matrix.rows)


@REGISTRY.derives("eq:6/factor", "eq:A.1/factor")
def factor() -> Expr:
    """Factor that turns the adjugate into the inverse."""
    return 1 / general().determinant


@REGISTRY.derives("eq:6")
def adjugate() -> ImmutableMatrix:
    """Adjugate of the wheel matrix."""
    return general().adjugate


@REGISTRY.derives("eq:7")
def determinant() -> Expr:
    """Determinant of the wheel matrix."""
    return general().determinant


@REGISTRY.derives("tab:1[3]")
def inner_product() -> Expr:
    """Inner product of two vectors."""
    return any_vector().dot(any_other_vector())


@REGISTRY.derives("tab:1[6]")
def third_component() -> Expr:
    """Third component of a vector."""
    return any_vector()[2]
