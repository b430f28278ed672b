"""Corrected formulas of the paper on trajectories of a platform on three omni rollers, for NumPy.

Speeds of the rollers' rims in m/s, body radius L in m; arrays are broadcast.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from omniproof.corrected.formula import Array, Formula, Functions
from omniproof.corrected.sampled import sampled_integral


def path_x(time: ArrayLike, nu_1: ArrayLike, nu_2: ArrayLike, nu_3: ArrayLike, L: float) -> Array:
    """Return X in the world up to each time, m, `(n,)`, from samples of the speeds: Eq. (8)."""
    return sampled_integral(_X, time, {"v_1": nu_1, "v_2": nu_2, "v_3": nu_3}, L=L)


def path_y(time: ArrayLike, nu_1: ArrayLike, nu_2: ArrayLike, nu_3: ArrayLike, L: float) -> Array:
    """Return Y in the world up to each time, m, `(n,)`, from samples of the speeds: Eq. (9)."""
    return sampled_integral(_Y, time, {"v_1": nu_1, "v_2": nu_2, "v_3": nu_3}, L=L)


def circle_radius(a: ArrayLike, b: ArrayLike, c: ArrayLike, L: ArrayLike) -> Array:
    """Return the radius of the circular path for constant speeds a, b, c, m: Eq. (13)."""
    return _RADIUS(a=a, b=b, c=c, L=L)


def direction(x_velocity: ArrayLike, y_velocity: ArrayLike, phi: ArrayLike) -> Array:
    """Return the direction of travel in the world, rad in (-pi, pi]: Eq. (14).

    x_velocity, y_velocity: in the frame of the platform, m/s; phi: its heading, rad.
    """
    return _DIRECTION(X_m=x_velocity, Y_m=y_velocity, phi=phi)


def initial_direction(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> Array:
    """Return the direction of travel at the start, rad in (-pi, pi]: Eq. (14), right side."""
    return _INITIAL(a=a, b=b, c=c)


def centre_factor(a: ArrayLike, b: ArrayLike, c: ArrayLike, L: ArrayLike) -> Array:
    """Return the factor of `centre_vector`, s: Eq. (16). The product is the centre, in m."""
    return _FACTOR(a=a, b=b, c=c, L=L)


def centre_vector(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> Array:
    """Return three times the initial velocity, turned by 90 degrees, m/s, `(..., 2)`: Eq. (16)."""
    return _VECTOR(a=a, b=b, c=c)


_PAPER = "omni-trajectory"
_X = Formula(_PAPER, "eq:8")
_Y = Formula(_PAPER, "eq:9")
_RADIUS = Formula(_PAPER, "eq:13")
_DIRECTION = Formula(_PAPER, "eq:14/velocities")
_INITIAL = Formula(_PAPER, "eq:14/speeds")
_FACTOR = Formula(_PAPER, "eq:16/factor")
_VECTOR = Formula(_PAPER, "eq:16/line-1")

FUNCTIONS: Functions = {
    "eq:8": path_x,
    "eq:9": path_y,
    "eq:13": circle_radius,
    "eq:14/velocities": direction,
    "eq:14/speeds": initial_direction,
    "eq:16/factor": centre_factor,
    "eq:16/line-1": centre_vector,
}
