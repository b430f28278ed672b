"""Introduction: degrees of freedom, symmetry, the determinant as a measure."""

from __future__ import annotations

from sympy import Abs, Expr, Integer, cos, pi

from omniproof.papers.omni_arrangement.arrangements import CORRECTED
from omniproof.papers.omni_arrangement.derivations.quantities import (
    REGISTRY,
    any_directions,
    cross_products,
    general,
    invert,
    platform,
)
from omniproof.registry import Relation


@REGISTRY.derives("sec:abstract/omnidirectional", rests_on=["sec:4/type-z-angles"])
def squared_determinants() -> tuple[Expr, ...]:
    """Squared determinants of the three types: wheel speeds reach every twist unless it is zero."""
    return tuple(platform(angles).determinant ** 2 for angles in CORRECTED.values())


@REGISTRY.derives("sec:1/degrees-of-freedom")
def degrees_of_freedom() -> Expr:
    """Return the number of unknowns of the twist."""
    return Integer(general().matrix.cols)


@REGISTRY.derives("sec:1/translations")
def translations() -> Expr:
    """Count the unknowns that do not turn the body: their column depends on the angles."""
    return Integer(sum(bool(column.free_symbols) for column in _columns()))


@REGISTRY.derives("sec:1/rotations")
def rotations() -> Expr:
    """Count the unknowns that turn the body: every wheel has the same entry there."""
    return Integer(sum(not column.free_symbols for column in _columns()))


def _columns() -> list[Expr]:
    matrix = general().matrix
    return [matrix[:, k] for k in range(matrix.cols)]


@REGISTRY.derives("sec:1/type-x-regular", "sec:4#2/type-x-equilateral", "app:C/type-x-equilateral")
def sides_of_type_x() -> tuple[Expr, ...]:
    """Squared distances between the wheels of Type (X), in units of the body radius."""
    first, second, third = CORRECTED["X"]
    return tuple(2 - 2 * cos(a - b) for a, b in ((first, second), (second, third), (third, first)))


@REGISTRY.derives("sec:1/most-symmetric", rests_on=["sec:4/type-z-angles"])
def symmetries() -> dict[str, Expr]:
    """Count the rotations and reflections that map the set of wheels to itself."""
    return {name: Integer(_count_symmetries(angles)) for name, angles in CORRECTED.items()}


def _count_symmetries(angles: tuple[Expr, ...]) -> int:
    wheels = {angle % (2 * pi) for angle in angles}
    first = angles[0]
    return sum(
        {(target + turn * (angle - first)) % (2 * pi) for angle in angles} == wheels
        for target in angles
        for turn in (1, -1)
    )


@REGISTRY.derives("sec:1/determinant-as-measure", "sec:4#2/determinant-as-measure")
def measures_by_determinant() -> Relation:
    """|det A| times the volume over 8, and times the area over 12, for free driven directions."""
    free = any_directions()
    volume = Abs(invert(free.inverse).determinant * free.determinant)
    area = sum(Abs(product) for product in cross_products()) / 3
    return Relation((volume, area, Integer(1)))
