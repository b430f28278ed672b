"""Introduction and conclusions: one contact, stability, motion in every direction."""

from __future__ import annotations

from sympy import Expr, Integer, Symbol, diff, pi

from omniproof.kinematics import ballbot, frames
from omniproof.papers.ballbot.derivations.quantities import REGISTRY
from omniproof.papers.ballbot.laws import BALL_RADIUS, rolling
from omniproof.papers.ballbot.symbols import LOWER_HALF, PHI, RUNNING_RADIUS
from omniproof.registry import Family, Obligation, Relation
from omniproof.transcription.model import Form

TILT = Symbol("theta", real=True)
HEIGHT = Symbol("h", real=True)
"""Height of a centre of mass over the centre of the ball, in units of the ball's radius."""


@REGISTRY.derives("sec:abstract/single-contact", "sec:1/single-contact")
def height_of_surface() -> Family:
    """Height of a point of the ball over the ground, by its angle from the lowest point."""
    lowest = frames.rotation("y", TILT) * frames.translation("z", -BALL_RADIUS)
    height = BALL_RADIUS + frames.origin(lowest)[2]
    return Family(height.subs(BALL_RADIUS, 1), {TILT: (-pi, pi)})


def potential_energy(height: Expr) -> Expr:
    """Potential energy of a tilted body, over its weight, by the height of its centre of mass."""
    tilted = frames.rotation("y", TILT) * frames.translation("z", height)
    return frames.origin(tilted)[2]


@REGISTRY.derives("sec:1/unstable-on-top")
def energy_on_top() -> Family:
    """Potential energy at unit height: where it is concave, a body at rest falls over."""
    return Family(potential_energy(Integer(1)), {TILT: (-pi / 2, pi / 2)})


@REGISTRY.derives("sec:1/inherently-stable")
def stiffness() -> Family:
    """Second derivative of the potential energy of an upright body: it stays upright where > 0."""
    bent = diff(potential_energy(HEIGHT), TILT, 2).subs(TILT, 0)
    return Family(bent, {HEIGHT: (-Integer(1), Integer(1))})


@REGISTRY.derives("sec:5/inherently-stable", rests_on=["sec:1/inherently-stable"])
def stiffness_again() -> Family:
    """As in the introduction."""
    return stiffness()


@REGISTRY.derives(
    "sec:abstract/omnidirectional",
    "sec:1/omnidirectional",
    "sec:3/omnidirectional-platform",
    "eq:10/solvable",
    "sec:5/omnidirectional-platform",
)
def determinant_of_law() -> Family:
    """Determinant of the law of the rolling ball, all lengths in units of its radius."""
    law = rolling().subs({RUNNING_RADIUS: 1, BALL_RADIUS: 1})
    return Family(law.det(method="berkowitz"), {PHI: LOWER_HALF})


@REGISTRY.derives("sec:1/three-wheels", "sec:3/three-wheels", "sec:5/three-wheels")
def number_of_wheels() -> Expr:
    """Count the velocities that the wheels have to make."""
    return Integer(rolling().cols)


@REGISTRY.derives("sec:1/no-nonholonomic-constraints")
def bracket_of_rolling() -> Relation:
    """Spin that is left after rolling along x, y, -x and -y by a small length each, per area.

    Rotations about two axes do not commute: the rolling ball returns to its place turned, so that
    its constraint cannot be integrated.
    """
    along_x, along_y = (ballbot.ball_twist(*v, 0, BALL_RADIUS) for v in ((1, 0), (0, 1)))
    left = along_x.rotation.cross(along_y.rotation)
    return Relation(
        (Integer(0), left[2]),
        condition=r"\text{only position and heading of the platform are counted, not the ball's}",
        proof=(Obligation(Form.POSITIVE, determinant_of_law()),),
    )


@REGISTRY.derives(
    "sec:5/no-nonholonomic-constraints", rests_on=["sec:1/no-nonholonomic-constraints"]
)
def bracket_of_rolling_again() -> Relation:
    """As in the introduction."""
    return bracket_of_rolling()
