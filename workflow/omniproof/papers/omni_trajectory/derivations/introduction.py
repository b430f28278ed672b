"""Introduction and conclusion: degrees of freedom, and whether every motion can be driven."""

from __future__ import annotations

from sympy import Expr, Integer, Integral

from omniproof.kinematics import omni, trajectory
from omniproof.papers.omni_trajectory.derivations.quantities import (
    CHANGING_SPEEDS,
    REGISTRY,
    matrix,
    twist,
)
from omniproof.papers.omni_trajectory.symbols import BODY_RADIUS, FREE_ANGLES, TIME


@REGISTRY.derives("sec:1/degrees-of-freedom", "sec:2/three-speeds")
def degrees_of_freedom() -> Expr:
    """Count the unknowns of the twist: as many speeds fix it."""
    return Integer(matrix().cols)


@REGISTRY.derives("sec:1/translations", "sec:3.1/two-coordinates")
def translations() -> Expr:
    """Count the unknowns that do not turn the body: their column depends on the angles."""
    return Integer(sum(bool(column.free_symbols - {BODY_RADIUS}) for column in _columns()))


@REGISTRY.derives("sec:1/rotations")
def rotations() -> Expr:
    """Count the unknowns that turn the body: every wheel has the same entry there."""
    return Integer(sum(not column.free_symbols - {BODY_RADIUS} for column in _columns()))


def _columns() -> list[Expr]:
    general = omni.wheel_matrix(FREE_ANGLES, BODY_RADIUS)
    return [general[:, k] for k in range(general.cols)]


@REGISTRY.derives("sec:3.1/three-wheels")
def number_of_wheels() -> Expr:
    """Count the rows of the wheel matrix."""
    return Integer(matrix().rows)


@REGISTRY.derives("sec:1/omnidirectional", "sec:4/derived")
def squared_determinant() -> tuple[Expr, ...]:
    """Squared determinant for L = 1: wheel speeds reach every twist unless it is zero."""
    return (matrix().subs(BODY_RADIUS, 1).det() ** 2,)


@REGISTRY.derives("sec:1/arbitrary-speeds", rests_on=["eq:8"])
def velocity_along_the_path() -> tuple[Expr, ...]:
    """Velocity of the path for any speeds less the velocity in the world, both coordinates."""
    moving = twist(CHANGING_SPEEDS)
    path = trajectory.path_integrands(moving, TIME).applyfunc(
        lambda integrand: Integral(integrand, (TIME, 0, TIME))
    )
    turned = trajectory.world_velocity(moving, trajectory.heading(moving[2], TIME))
    return (*(path.diff(TIME) - turned[:2, :]), Integer(0))
