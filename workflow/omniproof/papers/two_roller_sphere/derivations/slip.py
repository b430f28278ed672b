"""Section 2.4: the slip of the two rollers."""

from __future__ import annotations

from sympy import Expr, ImmutableMatrix

from omniproof.papers.two_roller_sphere.arrangement import POLE
from omniproof.papers.two_roller_sphere.derivations.quantities import (
    ANY_SPIN,
    OTHER,
    REGISTRY,
    ROLLER,
    Vanishing,
    allowed_spin,
    any_spin,
    height,
    spin,
    vanishing,
)
from omniproof.papers.two_roller_sphere.symbols import RADIUS


@REGISTRY.derives("eq:23", "eq:25", meanings=any_spin)
def slip_velocity() -> ImmutableMatrix:
    """Velocity of the sphere over the roller, for any spin."""
    return ROLLER.slip(ANY_SPIN)


@REGISTRY.derives("eq:24/sphere", meanings=any_spin)
def velocity_of_sphere() -> ImmutableMatrix:
    """Velocity of the sphere at the contact, for any spin."""
    return ROLLER.surface_velocity(ANY_SPIN)


@REGISTRY.derives("eq:24/roller")
def velocity_of_roller() -> ImmutableMatrix:
    """Velocity of the roller: that of a sphere that does not slip on it."""
    return ROLLER.surface_velocity(allowed_spin())


# The next sides of (26) have the right sign.
@REGISTRY.derives("eq:26", idle=True)
def slip_along_normal() -> Expr:
    """Component along the normal of the slip that the least-squares spin leaves."""
    return ROLLER.slip(spin()).dot(POLE)


@REGISTRY.derives("sec:2.4/parallel")
def slip_across_tangent() -> Vanishing:
    """Cross product of that slip with the tangent in the plane of the rollers."""
    return vanishing(ROLLER.slip(spin()).cross(ROLLER.tangent))


@REGISTRY.derives("eq:27")
def slip() -> ImmutableMatrix:
    """Slip that the least-squares spin leaves."""
    return ROLLER.slip(spin())


@REGISTRY.derives("eq:28")
def component_of_slip() -> Expr:
    """Half the gap between both lines, in m/s: the spin lies in the middle."""
    return RADIUS * (height(OTHER) - height(ROLLER)) / 2
