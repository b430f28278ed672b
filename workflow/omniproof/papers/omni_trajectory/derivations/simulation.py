"""Section 3: inputs of the simulations. The printed speed does not give the printed inputs.

The inputs are judged on the set-ups that give them: one speed V for both tables, and a rim speed
u = L phi-dot for each circle, which the paper does not print. 0.05 m/s is the only decimal of up to
three places among the solutions.
"""

from __future__ import annotations

from functools import cache

from sympy import Abs, Expr, ImmutableMatrix, Integer, Rational, Symbol, cos, pi, sin

from omniproof.kinematics import trajectory
from omniproof.papers.omni_trajectory.derivations.quantities import REGISTRY, matrix
from omniproof.papers.omni_trajectory.setup import CIRCLES, LINES, ROLLER_RADIUS, Case, twist
from omniproof.papers.omni_trajectory.symbols import BODY_RADIUS
from omniproof.registry import Fit, Relation

SPEED = Symbol("V", real=True)
RIM_SPEEDS = {case.name: Symbol(f"u_{case.name}", real=True) for case in CIRCLES}
NONE = Integer(0)
RPM = 30 / (pi * ROLLER_RADIUS)
"""Rotational speed (rpm) of a roller over its rim speed (m/s)."""

SETUP = {
    SPEED: Rational("0.05"),
    RIM_SPEEDS["left"]: Rational("22.6") / RPM,
    RIM_SPEEDS["clockwise"]: Rational("-22.56") / RPM,
}
"""One set-up that gives all cells, rounded or truncated."""

PRINTED_ERRORS = (
    *("0.02", "0.03", "0.03", "0.02"),  # Simulation 1: text, Table 3
    *("0.01", "0.02", "0.02", "0.02"),  # Simulation 2: text
    *("0.03", "0.03", "0.02", "0.01"),  # Table 4
)
"""All errors that the paper prints."""


def rates(direction: Expr, rim_speed: Expr = NONE) -> ImmutableMatrix:
    """Rotational speeds (rpm) of the rollers for a direction (rad) and a rim speed (m/s): 3x1."""
    moving = [SPEED * cos(direction), SPEED * sin(direction), rim_speed / BODY_RADIUS]
    return ImmutableMatrix(RPM * matrix() * ImmutableMatrix(moving))


@cache
def _inputs() -> dict[str, Expr]:
    """Derive the cells of Tables 3 and 4 by their ids."""
    found = {}
    for table, cases in ((3, CIRCLES), (4, LINES)):
        for case in cases:
            rim_speed = RIM_SPEEDS.get(case.name, NONE)
            for k, rate in enumerate(rates(case.direction, rim_speed), 1):
                found[f"tab:{table}[{case.name.rstrip('°')},N_{k}]"] = rate
    return found


def _cells() -> tuple[str, ...]:
    """The cells that depend on the set-up."""
    return tuple(name for name, rate in _inputs().items() if rate.free_symbols)


def _input(name: str) -> Expr | Fit:
    rate = _inputs()[name]
    return Fit(rate, SETUP, _cells()) if rate.free_symbols else rate


for _name, _rate in _inputs().items():
    # A roller that stands still does so at every speed, the printed one too.
    REGISTRY.derives(_name, rests_on=["tab:2[V]"] if _rate.free_symbols else [])(
        lambda name=_name: _input(name)
    )


@REGISTRY.derives("tab:2[V]")
def speed() -> Fit:
    """Speed of the simulations, by their inputs."""
    return Fit(SPEED, SETUP, _cells())


@REGISTRY.derives("sec:3.2/speed-circular", "sec:3.2/speed-linear", rests_on=["tab:2[V]"])
def speed_again() -> Fit:
    """Speed of the simulations, where the text repeats it."""
    return speed()


def _twist(case: Case) -> ImmutableMatrix:
    """Twist that the printed inputs give: 3x1; L stays a symbol."""
    return twist(case, BODY_RADIUS)


@REGISTRY.derives("sec:3.2/initial-direction")
def across_the_target() -> tuple[Expr, ...]:
    """Velocities across the target direction for the printed inputs of Table 3."""
    across = ((trajectory.rotation(-case.direction) * _twist(case)[:2, :])[1] for case in CIRCLES)
    return (*across, Integer(0))


@REGISTRY.derives("sec:3.2/circular")
def squared_rotations() -> tuple[Expr, ...]:
    """Squared yaw rates (L = 1 m) for the printed inputs of Table 3."""
    return tuple(_twist(case)[2].subs(BODY_RADIUS, 1) ** 2 for case in CIRCLES)


def _yaw_rate(case: Case) -> tuple[Expr, ...]:
    """Yaw rate (L = 1 m) for the printed inputs of a row of Table 3."""
    return (_twist(case)[2].subs(BODY_RADIUS, 1),)


for _case in CIRCLES:
    REGISTRY.derives(f"tab:3/{_case.name}")(lambda case=_case: _yaw_rate(case))


@REGISTRY.derives("sec:3.2/zero-sum", rests_on=["tab:4[0,N_1]"])
def sums() -> tuple[Expr, ...]:
    """Sum of the rotational speeds without rotation, for the four directions."""
    return (*(sum(rates(case.direction)) for case in LINES), Integer(0))


@REGISTRY.derives("sec:3.2/four-patterns")
def symmetries() -> tuple[Expr, ...]:
    """What is left of the speeds of three rollers when those of others are taken away or added."""
    angle = Symbol("psi", real=True)
    first, second, third = rates(angle)
    turned, mirrored = rates(angle + pi / 3), rates(-angle)
    return (
        *(a + b for a, b in zip(turned, (second, third, first), strict=True)),
        *(a - b for a, b in zip(mirrored, (second, first, third), strict=True)),
        Integer(0),
    )


@REGISTRY.derives("sec:3.2/first-quadrant")
def outside_the_first_quadrant() -> tuple[Expr, ...]:
    """What is left of each component of a direction when its absolute value is taken away."""
    components = (f(case.direction) for case in LINES for f in (cos, sin))
    return (*(Abs(x) - x for x in components), Integer(0))


@REGISTRY.derives("sec:4/error-within")
def below_the_bound() -> Relation:
    """The bound less each printed error."""
    return Relation(tuple(Rational("0.05") - Rational(error) for error in PRINTED_ERRORS))
