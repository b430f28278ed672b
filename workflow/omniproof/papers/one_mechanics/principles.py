"""The formulas of the chapter on first principles, computed when the page is made.

A formula that is typed into a chapter can be misprinted, as this report shows page after page.
These are results of the very functions that the verdicts rest on.
"""

from __future__ import annotations

from sympy import ImmutableMatrix, Rational, pi, simplify, symbols

from omniproof.audit.printing import Spelling
from omniproof.kinematics import ballbot, omni, sphere, trajectory
from omniproof.kinematics.scalars import tidy

BODY_RADIUS, BALL_RADIUS = symbols("L rho", positive=True)
TIME = symbols("t", nonnegative=True)
# The sign matters to a circle's radius only, and is said in the chapter.
YAW_RATE = symbols("omega", positive=True)
V_X, V_Y, SPIN, ZENITH, ANGLE = symbols("V_x V_y sigma phi alpha_k", real=True)
WHEELS = symbols("alpha_1:4", real=True)
SPEEDS = symbols("nu_1:4", real=True)
REGULAR = (pi / 6, 5 * pi / 6, 3 * pi / 2)
CONTACT = ImmutableMatrix(symbols("p_x p_y p_z", real=True))
TWIST = ImmutableMatrix([V_X, V_Y, YAW_RATE])
_write = Spelling({}, {}).latex


def wheels_from_twist() -> str:
    """Return the wheel speeds of a platform on three omni wheels: matrix times twist."""
    matrix = omni.wheel_matrix(WHEELS, BODY_RADIUS)
    return f"{_write(ImmutableMatrix(SPEEDS))} = {_write(matrix)} {_write(TWIST)}"


def twist_from_wheels() -> str:
    """Return the inverse for wheels at 30, 150 and 270 degrees, a third taken out."""
    inverse = omni.twist_matrix(omni.wheel_matrix(REGULAR, BODY_RADIUS))
    third = Rational(1, 3)
    inside = (inverse / third).applyfunc(simplify)
    return f"{_write(TWIST)} = {_write(third)} {_write(inside)} {_write(ImmutableMatrix(SPEEDS))}"


def path() -> str:
    """Return the place after a time with a constant twist that turns, from the origin."""
    place = trajectory.constant_speed_path(TWIST, TIME)
    inside = (place * YAW_RATE).applyfunc(tidy)
    return rf"\begin{{pmatrix}} X \\ Y \end{{pmatrix}} = {_write(1 / YAW_RATE)} {_write(inside)}"


def centre() -> str:
    """Return the centre of that circle."""
    return _write(trajectory.circle_centre(TWIST))


def radius() -> str:
    """Return the radius of that circle."""
    return _write(trajectory.circle_radius(TWIST))


def spin_of_ball() -> str:
    """Return the rotation of a ball that rolls along, and spins about the vertical besides."""
    return _write(ballbot.ball_twist(V_X, V_Y, SPIN, BALL_RADIUS).rotation)


def wheel_in_ball() -> str:
    """Return the speed of one wheel of a platform in a rolling ball."""
    law = ballbot.wheel_law(ZENITH, BODY_RADIUS, BALL_RADIUS, azimuths=[ANGLE])
    motion = ImmutableMatrix([V_X, V_Y, YAW_RATE, SPIN])
    return rf"\nu_k = {_write(law)} {_write(motion)}"


def term_of_normal_matrix() -> str:
    """Return what one roller adds to the matrix of the normal equations."""
    return _write(sphere.normal_matrix([CONTACT]))
