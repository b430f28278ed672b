"""The quantities of Section 2 for one roller, and for three; all angles and speeds are free.

The roller is a body of its own: it turns about its axis, right-handed where its rim speed is
positive, and its rim is what the sphere touches. That gives the direction in which it drives.
"""

from __future__ import annotations

from functools import cache

from sympy import Expr, ImmutableMatrix, Integer, Symbol, sqrt, zeros

from omniproof.kinematics import rolling, sphere
from omniproof.papers.three_roller_sphere.rollers import ROLLERS, Roller, optimum
from omniproof.papers.three_roller_sphere.symbols import ALONG, ANY_ROLLER, POINT, RADIUS, SYMBOLS
from omniproof.registry import Registry

REGISTRY = Registry("three-roller-sphere", symbols=SYMBOLS)
ROLLER = Roller(*ANY_ROLLER)
ROLLER_RADIUS = Symbol("rho", positive=True)
COEFFICIENTS = {k: Symbol(f"C_{k}", real=True) for k in range(1, 11)}
"""Free coefficients of a quadratic form in three variables, in the paper's order."""


def turning_roller(rate: Expr) -> rolling.Twist:
    """Motion of a roller about its axis at a rate (rad/s); its centre stands still."""
    return rolling.Twist(zeros(3, 1), rate * ROLLER.axis)


@cache
def driven_direction() -> ImmutableMatrix:
    """Velocity of the rim at the contact, for a roller of unit radius at unit rate: 3x1, unit."""
    return turning_roller(Integer(1)).at(-ROLLER.contact)


@cache
def velocity_of_roller() -> ImmutableMatrix:
    """Velocity of the rim at the contact (3x1, m/s): it moves at the rim speed."""
    rate = ROLLER.speed / ROLLER_RADIUS
    return turning_roller(rate).at(-ROLLER_RADIUS * ROLLER.contact)


@cache
def spin_without_slip() -> ImmutableMatrix:
    """Any spin (3x1, rad/s) that leaves the roller without slip."""
    foot, direction = ROLLER.line()
    return ImmutableMatrix(foot + ALONG * direction)


def velocity_of_sphere(spin: ImmutableMatrix) -> ImmutableMatrix:
    """Velocity (3x1, m/s) of the sphere at the contact."""
    return ImmutableMatrix(RADIUS * sphere.surface_map(ROLLER.contact) * spin)


def squared_distance(roller: Roller, point: ImmutableMatrix) -> Expr:
    """Squared distance (rad/s)^2 of a point from the line of a roller, by its cross product."""
    foot, direction = roller.line()
    across = (point - foot).cross(direction)
    return across.dot(across)


@cache
def sum_at(*place: Expr) -> Expr:
    """Sum of the squared distances of a point (three coordinates, rad/s)."""
    point = ImmutableMatrix(place)
    return sum((squared_distance(roller, point) for roller in ROLLERS), Integer(0))


REGISTRY.quantity("omega")(spin_without_slip)
REGISTRY.quantity("P_i")(lambda: RADIUS * ROLLER.contact)
REGISTRY.quantity("eta_i")(lambda: ROLLER.axis)
REGISTRY.quantity("e_i")(driven_direction)
REGISTRY.quantity("v_S")(lambda: velocity_of_sphere(spin_without_slip()))
REGISTRY.quantity("v_R")(velocity_of_roller)
REGISTRY.quantity("X_i")(lambda: ImmutableMatrix(ROLLER.frame[:, 1]))
REGISTRY.quantity("Y_i")(lambda: ImmutableMatrix(ROLLER.frame[:, 2]))
REGISTRY.quantity("Q")(lambda: POINT)
REGISTRY.quantity("d_i")(lambda: sqrt(squared_distance(ROLLER, POINT)))
for _k, _roller in enumerate(ROLLERS, 1):
    REGISTRY.quantity(f"d_{_k}")(lambda roller=_roller: sqrt(squared_distance(roller, POINT)))
REGISTRY.quantity("L", of=list(POINT))(lambda: sum_at(*POINT))
for _k, _axis in enumerate("xyz"):
    REGISTRY.quantity(f"{_axis}_0")(lambda k=_k: optimum(ROLLERS)[k])
