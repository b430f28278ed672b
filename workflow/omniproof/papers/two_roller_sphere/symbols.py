"""What the symbols of the paper are; `paper.yaml` says how the paper writes them."""

from __future__ import annotations

from sympy import Integer, Symbol, pi, symbols

from omniproof.registry import Symbols

RADIUS = Symbol("r", positive=True)
"""Radius of the sphere (m)."""

ANGLES = symbols("alpha_i alpha_1 alpha_2", real=True)
RIM_SPEEDS = symbols("nu_i nu_1 nu_2", real=True)
"""Angles (rad) and rim speeds (m/s) of the i-th roller, and of rollers 1 and 2."""

PLACE = symbols("theta_1i theta_2i", real=True)
"""Azimuth and elevation of a contact (rad)."""

DIRECTION = Symbol("phi", real=True)
"""Direction of travel, from the x-axis (rad)."""

AXIS_ANGLE = Symbol("rho", real=True)
"""Angle of the sphere's axis against the ground, rad."""

BETWEEN = Symbol("delta", real=True)
"""Angle from contact 1 to contact 2 (rad)."""

ALONG = Symbol("k", real=True)
"""Place on a constraint line, rad/(m s): multiple of the contact. In Appendix A the sum of both
distances (rad/s)."""

LEAST = Symbol("k_0", positive=True)
DISTANCES = symbols("d_1 d_2", positive=True)
"""Least sum of both distances, and the distances (rad/s)."""

SYMBOLS = Symbols(
    (
        *(RADIUS, *ANGLES, *RIM_SPEEDS, *PLACE, DIRECTION, AXIS_ANGLE, BETWEEN),
        *(ALONG, LEAST, *DISTANCES),
    ),
    ranges={BETWEEN: (Integer(0), pi), AXIS_ANGLE: (-pi / 2, pi / 2)},
)
