"""MuJoCo model of a sphere between driven rollers: real contacts, pressed by a load each.

The sphere turns about its centre, which a ball joint holds. A roller is a cylinder on a slide along
its contact direction; a constant force presses it, so that every contact bears just that load once
the slide rests. A flywheel and a speed servo keep the roller turning.

One friction law serves both theories. A soft contact of MuJoCo resists slip s at rest by the force
(b / R) s, as viscous friction does, up to the limit mu N, and by mu N beyond it, as dry friction
does. The slip where one goes over into the other, creep = mu N R / b, is the parameter of a case:
far above all slips the contact is viscous with one coefficient for all rollers, far below them it
is Coulomb's, rounded off where a roller sticks.

What to avoid, by measurement. MuJoCo's contact model couples normal force and slip: a stiff contact
that slides throws its roller off. This sphere with three rollers at 30 degrees and MuJoCo's default
contacts (step 1 ms) is touched 30 % of the time, jitters by 0.05 rad/s, and its mean spin is 0.11
from the dry one; with contacts of 2 ms it is nearer to least squares (0.08) than to the dry spin
(0.26), and looks viscous. No contact is lost while the normal compliance can bear what friction
asks for, N R_n > mu b s; so contacts here are soft (`GIVE`) and friction answers slowly (`RATE`).
The time constant `SETTLE` keeps them shallow still.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

RADIUS = 1.0
ROLLER_RADIUS = 0.2
"""Radii of the sphere and of the rollers, m."""

INERTIA = 0.1
"""Of the sphere about its centre, kg m^2."""

ROLLER_MASS = 1.0
FLYWHEEL = 10.0
SERVO = 2500.0
"""Mass (kg), inertia about the axis (kg m^2) and servo (N m s) of a roller.

SERVO * step / FLYWHEEL stays below 1, else the servo swings; friction of 1 N slows the rim by
ROLLER_RADIUS^2 / SERVO = 0.02 mm/s.
"""

FRICTION = 0.5
LOAD = 2.0
"""Coefficient of friction; force that presses a roller, N."""

SETTLE = 0.005
IMPEDANCE = 0.05
RATE = 10.0
"""Of a contact: time constant (s), MuJoCo's impedance d, rate b at which slip is taken off (1/s).

At twice the usual step the time constant is too short: the rollers bounce, and the run is refused.
"""

GIVE = (1 - IMPEDANCE) / IMPEDANCE / (3 * ROLLER_MASS)
"""Compliance R_n of a contact (1/kg): MuJoCo's (1 - d) / d times its estimate of the inverse mass.

The estimate is a mean over three directions; the roller yields in one, the sphere's centre in none.
"""

DEPTH = LOAD * GIVE * IMPEDANCE * SETTLE**2
"""Depth (m) at which a contact at rest bears `LOAD`: 0.016 mm. The rollers start so deep, since to
touch all at once is a matter of the last bit, and one that touches first sets the sphere off.
"""


@dataclass(frozen=True)
class Roller:
    """Where a roller touches and how it turns: unit vectors (3,), rim speed (m/s), load (N)."""

    contact: np.ndarray
    axis: np.ndarray
    speed: float
    load: float


def xml(rollers: Sequence[Roller], creep: float) -> str:
    """Write the model of a sphere with some rollers; `creep` (m/s) belongs to the load `LOAD`.

    Raises `ValueError` for a creep that is not positive.
    """
    if creep <= 0:
        raise ValueError(f"expected a positive creep, got {creep} m/s")
    # MuJoCo's friction has the compliance R = R_n / impratio.
    ratio = FRICTION * LOAD * GIVE / (RATE * creep)
    numbers = range(1, len(rollers) + 1)
    bodies = "".join(_body(number, roller) for number, roller in enumerate(rollers, 1))
    pairs = "".join(_pair(number) for number in numbers)
    drives = "".join(
        f'<motor joint="slide {number}"/><velocity joint="hinge {number}" kv="{SERVO}"/>'
        for number in numbers
    )
    # Inertia 2/5 m r^2.
    mass = INERTIA / (0.4 * RADIUS**2)
    return f"""
<mujoco>
  <option gravity="0 0 0" cone="elliptic" impratio="{ratio}" integrator="implicitfast"
    iterations="200" tolerance="1e-12"/>
  <worldbody>
    <body name="sphere">
      <joint type="ball"/>
      <geom name="sphere" type="sphere" size="{RADIUS}" mass="{mass}" contype="0" conaffinity="0"/>
    </body>
    {bodies}
  </worldbody>
  <contact>{pairs}</contact>
  <actuator>{drives}</actuator>
</mujoco>"""


def commands(rollers: Sequence[Roller]) -> np.ndarray:
    """Push (N, inward is negative) and turning rate (rad/s) of each roller in turn: (2N,)."""
    return np.array(
        [value for roller in rollers for value in (-roller.load, roller.speed / ROLLER_RADIUS)]
    )


def _body(number: int, roller: Roller) -> str:
    """Write a roller; in its frame x is the contact direction, z the axis."""
    across = np.cross(roller.axis, roller.contact)
    reach = RADIUS + ROLLER_RADIUS - DEPTH
    return f"""
    <body name="roller {number}" pos="{_listed(roller.contact * reach)}"
        xyaxes="{_listed(roller.contact)} {_listed(across)}">
      <joint name="slide {number}" type="slide" axis="1 0 0"/>
      <joint name="hinge {number}" type="hinge" axis="0 0 1" armature="{FLYWHEEL}"/>
      <geom name="roller {number}" type="cylinder" size="{ROLLER_RADIUS} {ROLLER_RADIUS / 2}"
        mass="{ROLLER_MASS}" contype="0" conaffinity="0"/>
    </body>"""


def _pair(number: int) -> str:
    """Write a contact. Two negative numbers mean stiffness and damping, the latter over d."""
    return f"""
    <pair geom1="sphere" geom2="roller {number}" condim="3"
      friction="{FRICTION} {FRICTION} 0 0 0" solref="{SETTLE} 1"
      solreffriction="-1 {-RATE * IMPEDANCE}" solimp="{IMPEDANCE} {IMPEDANCE} 1"/>"""


def _listed(vector: np.ndarray) -> str:
    return " ".join(repr(float(entry)) for entry in vector)
