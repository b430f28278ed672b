"""Corrected formulas of the paper on three omni rollers on a circle, for NumPy.

Angles of the wheels in rad, counter-clockwise from x; arrays are broadcast. The matrix of
Eq. (A.2) has the body radius L (m) in its third column, where that of Eq. (5) has 1.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from omniproof.corrected.formula import Array, Formula, Functions


def inverse_times_determinant(alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike) -> Array:
    """Return the inverse of A times its determinant, `(..., 3, 3)`: Eq. (6)."""
    return _INVERSE(alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3)


def image_volume(alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike) -> Array:
    """Return the image volume D_V of wheels numbered in any order, in (m/s)^3: Eq. (11)."""
    return _VOLUME(alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3)


def image_volume_isosceles(theta: ArrayLike) -> Array:
    """Return D_V of the isosceles family by its angle theta, at any theta: Eq. (12)."""
    return _ISOSCELES(theta=theta)


def cofactor_22(alpha_1: ArrayLike, alpha_3: ArrayLike, L: ArrayLike) -> Array:
    """Return the cofactor of entry (2, 2) of A with L in its third column, m: Eq. (A.2)."""
    return _COFACTOR_22(alpha_1=alpha_1, alpha_3=alpha_3, L=L)


def cofactor_13(alpha_1: ArrayLike, alpha_2: ArrayLike, L: ArrayLike) -> Array:
    """Return the cofactor of entry (1, 3), as it stands in the inverse, m: Eq. (A.2)."""
    return _COFACTOR_13(alpha_1=alpha_1, alpha_2=alpha_2, L=L)


def determinant(alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike) -> Array:
    """Return det A of Eq. (5), whose third column is 1, as Eq. (7) has it: Eq. (C.6)."""
    return _DETERMINANT(alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3)


def height(columns: Array) -> Array:
    """Return the height of a parallelepiped over its first two edges, a length: Eq. (B.2).

    columns: the edges, `(3, 3)`, each a column.
    """
    return _HEIGHT(**_edges(columns))


def volume(columns: Array) -> Array:
    """Return the volume of a parallelepiped, never negative: Eq. (B.3). columns: as in `height`."""
    return _PARALLELEPIPED(**_edges(columns))


def _edges(columns: Array) -> dict[str, ArrayLike]:
    # In the derivation, the first index is that of the axis.
    return {f"a_{i + 1}{k + 1}": columns[i, k] for i in range(3) for k in range(3)}


_PAPER = "omni-arrangement"
_INVERSE = Formula(_PAPER, "eq:6")
_VOLUME = Formula(_PAPER, "eq:11")
_ISOSCELES = Formula(_PAPER, "eq:12")
_L_IN_COLUMN = "the unknown is the yaw rate: third column L"
_COFACTOR_22 = Formula(_PAPER, "eq:A.2/a22", _L_IN_COLUMN)
_COFACTOR_13 = Formula(_PAPER, "eq:A.2/a13", _L_IN_COLUMN)
_DETERMINANT = Formula(_PAPER, "eq:C.6", "the unknown is L times the yaw rate: third column 1")
_HEIGHT = Formula(_PAPER, "eq:B.2")
_PARALLELEPIPED = Formula(_PAPER, "eq:B.3#2/volume")

FUNCTIONS: Functions = {
    "eq:6": inverse_times_determinant,
    "eq:11": image_volume,
    "eq:12": image_volume_isosceles,
    "eq:A.2/a22": cofactor_22,
    "eq:A.2/a13": cofactor_13,
    "eq:B.2": height,
    "eq:B.3#2/volume": volume,
    "eq:C.6": determinant,
}
