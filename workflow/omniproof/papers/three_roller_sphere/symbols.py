"""What the symbols of the paper are; `paper.yaml` says how the paper writes them."""

from __future__ import annotations

from sympy import ImmutableMatrix, Symbol, symbols

from omniproof.registry import Symbols

RADIUS = Symbol("r", positive=True)
"""Radius of the sphere (m)."""

ANY_ROLLER = symbols("theta_1_i theta_2_i psi_i v_i", real=True)
"""Azimuth and elevation of a contact, angle of the axis there (rad), rim speed (m/s)."""

ALONG = Symbol("t", real=True)
"""Place of a spin on the line of a roller (rad/s)."""

POINT = ImmutableMatrix(symbols("x y z", real=True))
"""Any spin, as a point (rad/s)."""

PHI = Symbol("phi", real=True)
"""Parameter of the inputs of the simulation (rad)."""

SYMBOLS = Symbols((RADIUS, *ANY_ROLLER, ALONG, *POINT, PHI))
