"""The quantities of this paper's laws, shared by theorems and figures."""

from __future__ import annotations

from sympy import Expr, ImmutableMatrix, Symbol, atan, diag, sqrt

from omniproof.kinematics import ballbot
from omniproof.papers.ballbot.symbols import PHI, RUNNING_RADIUS

BALL_RADIUS = Symbol("rho", positive=True)
"""Radius of the ball (m); its wall lies between this and the inner running surface."""

ISOTROPIC = atan(1 / sqrt(2))
"""Zenith angle (rad) at which the law of the rolling ball is isotropic; see `thm:zenith-angle`."""


def rolling() -> ImmutableMatrix:
    """Law of the rolling ball on (v_x, v_y, yaw rate relative to the ball): 3x3."""
    return ballbot.relative_law(PHI, RUNNING_RADIUS, BALL_RADIUS)


def at_rest() -> ImmutableMatrix:
    """Law of the same platform over a surface at rest, on (v_x, v_y, yaw rate): 3x3."""
    return ballbot.law_over_surface_at_rest(PHI, RUNNING_RADIUS)


def gram(law: ImmutableMatrix, length: Expr) -> ImmutableMatrix:
    """A^T A of a law on (v_x, v_y, `length` times the yaw rate): 3x3, dimensionless."""
    scaled = law * diag(1, 1, 1 / length)
    return ImmutableMatrix(scaled.T * scaled)
