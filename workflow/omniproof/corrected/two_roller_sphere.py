"""Corrected formulas of the paper on a sphere driven by two rollers, for NumPy.

Rim speeds in m/s, radius of the sphere in m; arrays are broadcast.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from omniproof.corrected.formula import Array, Formula, Functions


def spin_about_roller_axis(nu: ArrayLike, r: ArrayLike) -> Array:
    """Return the part of the sphere's spin about the roller's axis, rad/s: the sum of Section 2.1.

    nu: speed of the roller's rim, m/s; r: radius of the sphere, m.
    """
    return _SPIN(nu_i=nu, r=r)


_SPIN = Formula("two-roller-sphere", "sec:2.1/sum")

FUNCTIONS: Functions = {"sec:2.1/sum": spin_about_roller_axis}
