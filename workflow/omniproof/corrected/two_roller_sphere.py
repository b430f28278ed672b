"""Corrected formulas of the paper on a sphere driven by two rollers, for NumPy.

Rim speeds in m/s, radius of the sphere in m, angles in rad; arrays are broadcast.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from omniproof.corrected.answer import Answer, Answers, Line
from omniproof.corrected.formula import Array, Formula, Functions


def spin_about_roller_axis(nu: ArrayLike, r: ArrayLike) -> Array:
    """Return the part of the sphere's spin about the roller's axis, rad/s: the sum of Section 2.1.

    nu: speed of the roller's rim, m/s; r: radius of the sphere, m.
    """
    return _SPIN(nu_i=nu, r=r)


def slip_along_normal(spin: ArrayLike, nu: ArrayLike, alpha: ArrayLike, r: ArrayLike) -> Array:
    """Return the slip at a roller along the normal of the rollers' plane, m/s: Eq. (26).

    spin: component of the sphere's spin along the tangent X in that plane, rad/s; nu, r: as in
    `spin_about_roller_axis`; alpha: angle of the roller's axis from X, rad. It vanishes for the
    spin that the paper chooses, and not for others.
    """
    # The third component of the slip; the spin along the normal is no part of it.
    return _SLIP(w_2=spin, w_3=0.0, nu_i=nu, alpha_i=alpha, r=r)[..., 2]


def sum_of_squares(d_1: ArrayLike, d_2: ArrayLike) -> Array:
    """Return the sum that the optimal spin makes least, by both distances: Appendix (A)."""
    return _SUM(d_1=d_1, d_2=d_2)


_PAPER = "two-roller-sphere"
_SPIN = Formula(_PAPER, "sec:2.1/sum")
# What is derived for Eq. (26) itself is the 0 at its end; Eq. (23) has the slip for any spin.
_SLIP = Formula(_PAPER, "eq:23")
_SUM = Formula(_PAPER, "app:A/sum-of-squares")

FUNCTIONS: Functions = {
    "sec:2.1/sum": spin_about_roller_axis,
    "eq:26": slip_along_normal,
    "app:A/sum-of-squares": sum_of_squares,
}

ANSWERS: Answers = {
    "eq:26": Answer(
        "slip along the normal",
        (
            Line(
                "<eq:26>",
                function=slip_along_normal,
                call="slip_along_normal(spin=-0.2, nu=0.3, alpha=0.5, r=0.2)",
            ),
        ),
        "Slip is the speed of the sphere less that of the roller, as the next side has it.",
    ),
    "sec:2.1/sum": Answer(
        "part of the spin about the roller's axis",
        (
            Line(
                "<sec:2.1/sum>",
                function=spin_about_roller_axis,
                call="spin_about_roller_axis(nu=0.3, r=0.2)",
            ),
        ),
        "The sphere turns the other way round than the roller, as Eq. (3) has it.",
    ),
    "app:A/sum-of-squares": Answer(
        "what is made least",
        (
            Line(
                "<app:A/sum-of-squares>",
                function=sum_of_squares,
                call="sum_of_squares(d_1=0.3, d_2=0.4)",
            ),
        ),
        "One distance is to each of the two lines.",
    ),
}
