"""Abstract and introduction: rollers on the equator, rollers that constrain and that do not."""

from __future__ import annotations

from sympy import Expr, Integer, Symbol, pi, symbols

from omniproof.kinematics import sphere
from omniproof.papers.three_roller_sphere.derivations.quantities import (
    REGISTRY,
    squared_distance,
)
from omniproof.papers.three_roller_sphere.rollers import ROLLERS, Roller
from omniproof.papers.three_roller_sphere.symbols import POINT, RADIUS
from omniproof.registry import Family, Obligation, Relation
from omniproof.transcription.model import Form

ON_X = Roller(*map(Integer, (0, 0, 0, 0)))
"""A roller on the x-axis, axis along y."""
APART = Symbol("epsilon", real=True)
"""Way round the equator from one contact to the other."""


def gap_between_lines(first: Roller, second: Roller) -> Expr:
    """How far the lines of two rollers pass by each other, times the sine of their angle.

    Where it is zero and the contacts are apart and not opposite, one spin slips at neither roller.
    """
    (foot_1, p_1), (foot_2, p_2) = first.line(), second.line()
    return (foot_2 - foot_1).dot(p_1.cross(p_2))


def on_equator(angle_1: Expr, angle_2: Expr) -> tuple[Roller, Roller]:
    """Two rollers on the equator, at any places and speeds, with these angles of their axes."""
    a_1, a_2, v_1, v_2 = symbols("theta_1_1 theta_1_2 v_1 v_2", real=True)
    level = Integer(0)
    return Roller(a_1, level, angle_1, v_1), Roller(a_2, level, angle_2, v_2)


@REGISTRY.derives("sec:1/equator")
def lines_of_the_equator() -> Relation:
    """Gap between the lines of two rollers on the equator: it asks for level axes.

    Opposite contacts have parallel lines, which do not meet for all speeds.
    """
    tilted = on_equator(*symbols("psi_1 psi_2", real=True))
    level = on_equator(Integer(0), Integer(0))
    sides = ((Integer(0), pi), (pi, 2 * pi))
    return Relation(
        (Integer(0), gap_between_lines(*tilted)),
        condition=r"\psi_1 = \psi_2 = 0^\circ \text{ (the axes lie in the plane of the equator) "
        r"and the contacts are not opposite to each other}",
        proof=(
            Obligation(Form.EQUAL, (Integer(0), gap_between_lines(*level))),
            *(Obligation(Form.POSITIVE, Family(_crossing(), {APART: side})) for side in sides),
        ),
    )


def _crossing() -> Expr:
    """Squared sine of the angle between two lines, by the way round the equator between them."""
    first, second = (sphere.contact_direction(a, 0) for a in (Integer(0), APART))
    across = first.cross(second)
    return across.dot(across)


@REGISTRY.derives("sec:1/two-degrees")
def rank_of_spin_map() -> Expr:
    """Dimension of the spins that two rollers on the equator can make, a quarter turn apart."""
    rollers = (ON_X, Roller(pi / 2, Integer(0), Integer(0), Integer(0)))
    contacts, axes = [r.contact for r in rollers], [r.axis for r in rollers]
    return Integer(sphere.spin_map(contacts, axes, Integer(1)).rank())


@REGISTRY.derives("sec:1/different-dimensions", "sec:1/less-diversity")
def dimensions_left() -> tuple[Expr, ...]:
    """Dimensions of the spins that a roller leaves, its speed given.

    A constraint roller prescribes the whole velocity of the surface, the rim of an omni-wheel its
    part along the driven direction.
    """
    surface = sphere.surface_map(ON_X.contact)
    driven = sphere.driven_direction(ON_X.contact, ON_X.axis)
    return tuple(Integer(3 - matrix.rank()) for matrix in (surface, driven.T * surface))


@REGISTRY.derives("sec:abstract/slip-at-each-contact")
def squared_slips() -> tuple[Expr, ...]:
    """Squared slips of three rollers less the squared distances, over the radius: all zero."""
    slips = [roller.slip(POINT) for roller in ROLLERS]
    pairs = zip(slips, ROLLERS, strict=True)
    return (
        Integer(0),
        *(s.dot(s) - RADIUS**2 * squared_distance(roller, POINT) for s, roller in pairs),
    )
