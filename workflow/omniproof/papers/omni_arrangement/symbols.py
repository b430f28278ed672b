"""What the symbols of the paper are; `paper.yaml` says how the paper writes them."""

from __future__ import annotations

from sympy import Symbol, symbols

from omniproof.registry import Symbols

ANGLES = symbols("alpha_1:4", real=True)
ANGLE = Symbol("alpha_k", real=True)
"""Position angles of wheels 1 to 3, and of any wheel (rad)."""

THETA = Symbol("theta", real=True)
"""Angle of the isosceles family (rad)."""

RADIUS = Symbol("L", positive=True)
"""Radius of the body (m)."""

VELOCITY = V_X, V_Y = symbols("V_x V_y", real=True)
YAW_RATE = Symbol("phi_dot", real=True)
SPEEDS = symbols("v_1:4", real=True)
"""Speeds of wheels 1 to 3 (m/s)."""

SYMBOLS = Symbols(
    (*ANGLES, ANGLE, THETA, RADIUS, *VELOCITY, YAW_RATE, *SPEEDS),
    undefined=(Symbol("theta_1", real=True),),
)
