r"""The speeds of the wheels: the paper's premise, and the mechanics it describes.

The paper takes the velocity of a wheel's frame, which is fixed to the platform, for the speed of
the wheel. That is the speed over a surface at rest. The surface under the wheel is the inside of
the ball, which rolls along: over it the same motion gives $\cos\phi$ times as much.
"""

from __future__ import annotations

from functools import cache

from sympy import Expr, ImmutableMatrix, cancel, cos

from omniproof.kinematics import ballbot, frames, omni
from omniproof.papers.ballbot.derivations.quantities import (
    MOTION,
    REGISTRY,
    WHEELS,
    at_pose,
    azimuth,
    wheel_frame,
)
from omniproof.papers.ballbot.laws import BALL_RADIUS, at_rest, rolling
from omniproof.papers.ballbot.symbols import PHI, RUNNING_RADIUS, V_X, V_Y, YAW_RATE
from omniproof.registry import Modelled, Obligation, Relation
from omniproof.transcription.model import Form

GAP = "sec:3/motion-by-frames"
YAW = "sec:3/yaw-at-ground-contact"
PREMISE = "the inner surface of the ball is at rest under the wheels"
CORRECTION = (
    r"v_y^{C_k} = \cos\phi \, \bar{\mathbf{o}}_k \cdot \bar{\mathbf{v}}^B + L \sin\phi \,"
    r" \omega_z^B \text{ over the inner surface of the rolling ball}"
)


@cache
def law() -> ImmutableMatrix:
    """Law of the rolling ball with a thin wall, whose two radii are both the paper's L: 3x3."""
    return ImmutableMatrix(rolling().subs(BALL_RADIUS, RUNNING_RADIUS))


@cache
def granted_law() -> ImmutableMatrix:
    """Law of the paper's premise: 3x3."""
    return at_rest()


def speeds() -> ImmutableMatrix:
    """Speeds of the three wheels over the inner surface: 3x1, in m/s."""
    return ImmutableMatrix(law() * MOTION)


def speed_of_frame(wheel: int) -> Expr:
    """Velocity of a wheel's frame along its y-axis, in m/s."""
    platform = ballbot.platform_twist(V_X, V_Y, YAW_RATE)
    return at_pose(platform, wheel_frame(wheel))[1][1]


def _corrected(wheel: int) -> Expr:
    driven = omni.tangential_direction(azimuth(wheel))
    lever = RUNNING_RADIUS * frames.rotation("z", PHI)[1, 0]
    return cos(PHI) * driven.dot(ImmutableMatrix([V_X, V_Y])) + lever * YAW_RATE


def _frame_for_wheel() -> Relation:
    """Velocity of the frame of wheel 1, and speed of that wheel.

    By the premise the surface is at rest, and both agree.
    """
    obligations = (
        Obligation(Form.EQUAL, (speeds()[wheel - 1], _corrected(wheel))) for wheel in WHEELS
    )
    return Relation(
        (speed_of_frame(1), speeds()[0]),
        correction=CORRECTION,
        proof=tuple(obligations),
        premises=(speed_of_frame(1), (granted_law() * MOTION)[0]),
    )


@REGISTRY.derives(GAP)
def motion_by_frames() -> Relation:
    """Velocity of a wheel's frame for the speed of the wheel."""
    return _frame_for_wheel()


@REGISTRY.derives(
    "sec:abstract/velocity-relationship",
    "sec:4/motor-makes-motion",
    "sec:4/wheel-and-body",
    "sec:5/velocity-relationship",
    rests_on=[GAP],
)
def motors_and_body() -> Relation:
    """The same premise, at places that draw on it."""
    return _frame_for_wheel()


def _speed(wheel: int) -> Modelled:
    """Speed of a wheel, by mechanics and by the premise."""
    granted = (granted_law() * MOTION)[wheel - 1]
    return Modelled(speeds()[wheel - 1], granted, PREMISE)


for _wheel in WHEELS:
    REGISTRY.quantity(f"v_y_C{_wheel}")(lambda wheel=_wheel: speeds()[wheel - 1])
    REGISTRY.derives(f"eq:{_wheel + 6}", rests_on=[GAP])(lambda wheel=_wheel: _speed(wheel))


@REGISTRY.derives("eq:10/wheel-speeds", "eq:10/solved-wheel-speeds")
def wheel_speeds() -> ImmutableMatrix:
    """Speeds of wheels 1 to 3."""
    return speeds()


@REGISTRY.derives("eq:10/twist", "eq:10/solved-twist")
def twist() -> ImmutableMatrix:
    """Motion of the platform: the unknowns that the law is written for."""
    return MOTION


@REGISTRY.derives("eq:10", rests_on=[GAP])
def matrix() -> Modelled:
    """Law by mechanics and by the premise."""
    return Modelled(law(), granted_law(), PREMISE)


@REGISTRY.derives("eq:10/inverse", rests_on=[GAP])
def inverse() -> Modelled:
    """Inverse of the law, by mechanics and by the premise."""
    solved, granted = (omni.twist_matrix(m).applyfunc(cancel) for m in (law(), granted_law()))
    return Modelled(solved, granted, PREMISE)


# Entries that the premise on the surface does not touch: a zero, and the yaw rate of the platform.
REGISTRY.derives("eq:10[1,1]")(lambda: law()[0, 0])
REGISTRY.derives("eq:10/inverse[1,1]")(lambda: inverse().mechanics[0, 0])
for _k in range(3):
    REGISTRY.derives(f"eq:10[{_k + 1},3]", rests_on=[YAW])(lambda k=_k: law()[k, 2])
    REGISTRY.derives(f"eq:10/inverse[3,{_k + 1}]", rests_on=[YAW])(
        lambda k=_k: inverse().mechanics[2, k]
    )
