"""What the symbols of the paper are; `paper.yaml` says how the paper writes them."""

from __future__ import annotations

from sympy import ImmutableMatrix, Integer, Symbol, pi, symbols

from omniproof.registry import Symbols

PHI = Symbol("phi", real=True)
"""Zenith angle of the wheels, from the lowest point of the inner surface (rad)."""

LOWER_HALF = (Integer(0), pi / 2)
"""Zenith angles of wheels on the lower half of the ball (rad)."""

RUNNING_RADIUS = Symbol("L", positive=True)
"""Radius of the inner running surface (m)."""

ROTATION = ImmutableMatrix(symbols("delta_x delta_y delta_z", real=True))
TRANSLATION = ImmutableMatrix(symbols("d_x d_y d_z", real=True))
"""Parts of any differential motion: 3x1 each, in rad and m."""

ROTATION_B = ImmutableMatrix(symbols("delta_x_B delta_y_B delta_z_B", real=True))
TRANSLATION_B = ImmutableMatrix(symbols("d_x_B d_y_B d_z_B", real=True))
"""Parts of the differential motion of the platform: 3x1 each, in rad and m."""

MOTION = V_X, V_Y, YAW_RATE = symbols("v_x v_y omega_z", real=True)
"""Motion of the platform (m/s, m/s, rad/s)."""

SYMBOLS = Symbols(
    (PHI, RUNNING_RADIUS, *ROTATION, *TRANSLATION, *ROTATION_B, *TRANSLATION_B, *MOTION),
    ranges={PHI: LOWER_HALF},
)
