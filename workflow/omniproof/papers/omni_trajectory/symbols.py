"""What the symbols of the paper are; `paper.yaml` says how the paper writes them."""

from __future__ import annotations

from sympy import Symbol, symbols

from omniproof.registry import Symbols

FREE_ANGLES = symbols("alpha_1:4", real=True)
BODY_RADIUS = Symbol("L", positive=True)
WHEEL_RADIUS = Symbol("r", positive=True)
SPEEDS = symbols("v_1:4", real=True)
CONSTANT_SPEEDS = symbols("a b c", real=True)
HEADING = Symbol("phi", real=True)
YAW_RATE = Symbol("phi_dot", real=True)
VELOCITY = symbols("X_m Y_m", real=True)
TIME = Symbol("t", real=True)
DURATION = Symbol("T", positive=True)
"""Angles in rad, radii in m, speeds in m/s, times in s."""

SYMBOLS = Symbols(
    (
        *(*FREE_ANGLES, BODY_RADIUS, WHEEL_RADIUS, *SPEEDS, *CONSTANT_SPEEDS),
        *(HEADING, YAW_RATE, *VELOCITY, TIME, DURATION),
    )
)
