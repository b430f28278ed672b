"""What these theorems are made of: papers by key, obligations, one roller at any place."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from sympy import Expr, ImmutableMatrix, Integer, MatrixBase, Symbol, pi, symbols

from omniproof.kinematics import sphere
from omniproof.kinematics.frames import UNIT
from omniproof.registry import Obligation
from omniproof.transcription.model import Form

TWO, THREE, BALLBOT = "two-roller-sphere", "three-roller-sphere", "ballbot"
ARRANGEMENT, TRAJECTORY = "omni-arrangement", "omni-trajectory"

RADIUS = Symbol("r", positive=True)
SPIN = ImmutableMatrix(symbols("omega_x omega_y omega_z", real=True))
REGULAR = (pi / 6, 5 * pi / 6, 3 * pi / 2)
"""Azimuths 30, 150 and 270 degrees: those of both papers on three rollers or wheels."""

UP = UNIT["z"]


def equal(*values: Expr) -> Obligation:
    """Oblige the engines to prove that expressions agree."""
    return Obligation(Form.EQUAL, values)


def same(first: MatrixBase, second: MatrixBase) -> list[Obligation]:
    """Oblige the engines to prove that matrices agree, entry by entry."""
    return [equal(*pair) for pair in zip(first, second, strict=True)]


def vanish(matrix: MatrixBase) -> list[Obligation]:
    """Oblige the engines to prove that all entries are zero."""
    return [equal(entry, Integer(0)) for entry in matrix]


def joined(*groups: Sequence[Obligation]) -> list[Obligation]:
    """Obligations of several groups."""
    return list(chain(*groups))


def roller(name: str) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Contact and axis of one roller at any place; its three angles are named after it."""
    azimuth, elevation, angle = symbols(f"a_{name} b_{name} psi_{name}", real=True)
    base = sphere.tangent_base(azimuth, elevation)
    return sphere.contact_direction(azimuth, elevation), sphere.roller_axis(*base, angle)
