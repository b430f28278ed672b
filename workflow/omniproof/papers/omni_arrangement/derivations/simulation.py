"""Section 4 and the conclusions: the three types, Table 2, and what the figures show."""

from __future__ import annotations

from collections.abc import Callable

from sympy import Abs, Expr, Integer, Rational, pi

from omniproof.kinematics import omni, zonotope
from omniproof.papers.omni_arrangement.arrangements import CORRECTED, PRINTED, isosceles
from omniproof.papers.omni_arrangement.derivations.quantities import (
    REGISTRY,
    image_area,
    image_volume,
    platform,
)
from omniproof.papers.omni_arrangement.symbols import THETA
from omniproof.registry import Family, Obligation, Relation
from omniproof.transcription.model import Form

TYPE_Z = "sec:4/type-z-angles"


def by_type(value: Callable[[tuple[Expr, ...]], Expr]) -> dict[str, Expr]:
    """Evaluate a function of the three angles for each type."""
    return {name: value(angles) for name, angles in CORRECTED.items()}


def volume_of(angles: tuple[Expr, ...]) -> Expr:
    """Image volume of an arrangement, (m/s)^3."""
    return image_volume(platform(angles).determinant)


def area_of(angles: tuple[Expr, ...]) -> Expr:
    """Area of the projection of an arrangement, (m/s)^2."""
    return image_area(platform(angles).determinant)


def section_of(angles: tuple[Expr, ...]) -> Expr:
    """Area of the velocities without rotation, (m/s)^2."""
    return zonotope.polygon_area(zonotope.section(platform(angles).matrix))


def half_widths(axis: int) -> tuple[Expr, ...]:
    """Greatest value along an axis of the image, for the three types, m/s."""
    return tuple(
        by_type(lambda angles: zonotope.half_widths(platform(angles).inverse)[axis]).values()
    )


def differences_of_sides(angles: tuple[Expr, ...]) -> Expr:
    """Product of the differences of the squared sides: zero for an isosceles triangle."""
    first, second, third = (omni.contact_position(angle, 1) for angle in angles)
    sides = [(a - b).dot(a - b) for a, b in ((first, second), (second, third), (third, first))]
    return (sides[0] - sides[1]) * (sides[1] - sides[2]) * (sides[2] - sides[0])


@REGISTRY.derives("sec:2.1/angle-range", rests_on=[TYPE_Z])
def angles_in_range() -> Relation:
    """What a reduction to [0, 360) degrees takes away from each angle."""
    angles = [angle for triple in CORRECTED.values() for angle in triple]
    return Relation((*(angle - angle % (2 * pi) for angle in angles), Integer(0)))


@REGISTRY.derives("sec:4/symmetric-triangles", rests_on=[TYPE_Z])
def isosceles_types() -> Relation:
    """Products that vanish for isosceles triangles."""
    return Relation((*by_type(differences_of_sides).values(), Integer(0)))


@REGISTRY.derives("sec:4/type-x-angles", "sec:4/type-y-angles")
def family_of_types() -> Relation:
    """Position angles of the isosceles family."""
    return Relation(isosceles(THETA))


@REGISTRY.derives(TYPE_Z)
def family_of_type_z() -> Relation:
    """The member of the isosceles family that Table 2 belongs to, by the volume printed there."""
    volume = volume_of(CORRECTED["Z"])
    printed, half = Rational("9.24"), Rational("0.005")
    return Relation(
        isosceles(THETA),
        correction=r"\{210^\circ, 270^\circ, 330^\circ\}",
        proof=(
            Obligation(Form.EQUAL, (differences_of_sides(CORRECTED["Z"]), Integer(0))),
            Obligation(Form.POSITIVE, (volume - (printed - half), printed + half - volume)),
            Obligation(Form.POSITIVE, (volume_of(PRINTED["Z"]) - (printed + half),)),
            Obligation(Form.POSITIVE, (differences_of_sides(PRINTED["Z"]) ** 2,)),
        ),
    )


for _name in CORRECTED:
    _rests = [TYPE_Z] if _name == "Z" else []
    REGISTRY.derives(f"tab:2[{_name},D_V]", rests_on=_rests)(
        lambda name=_name: volume_of(CORRECTED[name])
    )
    REGISTRY.derives(f"tab:2[{_name},D_A]", rests_on=_rests)(
        lambda name=_name: area_of(CORRECTED[name])
    )


@REGISTRY.derives("fig:4/parallelepiped", rests_on=[TYPE_Z])
def volumes_of_images() -> Relation:
    """Volumes of the three images: none is flat."""
    return Relation(tuple(by_type(volume_of).values()))


@REGISTRY.derives("fig:4/stretched-along-vx", "fig:5/stretched-along-vx", rests_on=[TYPE_Z])
def widths_along_vx() -> Relation:
    """Half-widths along V_x of the three images, and so of their projections."""
    return Relation(half_widths(0))


@REGISTRY.derives("fig:4/stretched-along-lphi", rests_on=[TYPE_Z])
def widths_along_lphi() -> Relation:
    """Half-widths along L phi-dot; between 30 and 0 degrees they do not change."""
    x, y, z = half_widths(2)
    return Relation(
        (x, y, z),
        correction=r"\text{stretched along } L\dot\phi \text{ from Type (Y) to Type (Z) only}",
        proof=(
            Obligation(Form.EQUAL, (x, y)),
            Obligation(Form.INCREASING, (y, z)),
            Obligation(
                Form.POSITIVE,
                Family(_slope_of_width(), {THETA: (-pi / 2, Integer(0))}),
            ),
        ),
    )


def _slope_of_width() -> Expr:
    """Minus the slope of the half-width along L phi-dot over the angle, times det A squared.

    For -90 < theta < 0 the wheels 1 and 2 turn against wheel 3 to turn the body fastest; the signs
    of the three entries of the row are those at theta = -30 degrees.
    """
    family = platform(isosceles(THETA))
    row = family.adjugate[2, :]
    signs = [entry.subs(THETA, -pi / 6) / Abs(entry.subs(THETA, -pi / 6)) for entry in row]
    width = sum(sign * entry for sign, entry in zip(signs, row, strict=True))
    determinant = family.determinant
    return width * determinant.diff(THETA) - width.diff(THETA) * determinant


@REGISTRY.derives("fig:5/hexagons", rests_on=[TYPE_Z])
def no_parallel_edges() -> Relation:
    """Squared cross products of the projected columns: no two edges of a hexagon are parallel."""
    products = []
    for angles in CORRECTED.values():
        plane = zonotope.projection(platform(angles).inverse)
        products += [plane[:, pair].det() ** 2 for pair in ([0, 1], [0, 2], [1, 2])]
    return Relation(tuple(products))


@REGISTRY.derives(
    "sec:4/type-x-smallest-volume",
    "sec:4/type-z-largest-volume",
    rests_on=[TYPE_Z],
)
def volumes() -> Relation:
    """Image volumes of the three types."""
    return Relation(by_type(volume_of))


@REGISTRY.derives("sec:4/type-x-smallest-area", "sec:4/type-z-largest-area", rests_on=[TYPE_Z])
def areas() -> Relation:
    """Areas of the projections of the three types."""
    return Relation(by_type(area_of))


def _translation() -> Relation:
    """Areas of the velocities that are reached without rotation.

    Types (X) and (Z) have the same driven lines, so they reach the same velocities; Type (Y)
    reaches more. Only where rotation is left free does Type (Z) come first.
    """
    return Relation(
        by_type(section_of),
        condition=r"\text{the yaw rate is left free while the platform translates}",
        proof=(Obligation(Form.LARGEST, by_type(area_of), member="Z"),),
    )


@REGISTRY.derives("sec:4/type-z-translation")
def range_of_velocities() -> Relation:
    """Range of velocities of the three types."""
    return _translation()


@REGISTRY.derives("sec:4#2/type-z-most-efficient", rests_on=["sec:4/type-z-translation"])
def efficiency_for_translation() -> Relation:
    """Range of velocities of the three types, as the conclusions take it up."""
    return _translation()
