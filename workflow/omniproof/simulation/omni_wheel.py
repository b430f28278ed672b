"""A wheel with passive rollers as a part of MuJoCo models: each roller is a body on its own hinge.

A wheel on a plane and a wheel on a ball are one wheel, so they are written once. What was measured
about its shape: rollers that are capsules make the rim a polygon; ellipsoids whose outline has the
rim's curvature where they touch (half-length sqrt(r b)) roll on a circle to the third order.

Lengths in m, masses in kg, angles in rad.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, pi, sin, sqrt, tau


@dataclass(frozen=True)
class Wheel:
    """A driven wheel. `rollers` are shared out to `rows` side by side, `row_distance` apart.

    `friction` and `contact_time` (s, how soft) are those of the rollers' contacts. The speed servo
    has `servo_gain` (N m s) against `armature` (kg m^2), the inertia of a geared motor: where gain
    times step over inertia exceeds about 1/4, it acts a step late and makes the robot jump.
    """

    radius: float
    rollers: int = 18
    rows: int = 1
    row_distance: float = 0.01
    roller_radius: float = 0.004
    roller_mass: float = 5e-4
    friction: float = 0.5
    contact_time: float = 4e-3
    servo_gain: float = 5.0
    armature: float = 0.01


def contact(friction: float, contact_time: float, torsion: float = 0.0) -> str:
    """Write the attributes of a geom that decide its contacts.

    Coulomb friction, time constant (s) of the contact, `torsion` (m): the lever of the load against
    a spin about the normal, 0 for contact in a point.
    """
    return (
        f'condim="{4 if torsion else 3}" friction="{friction} {torsion} 0"'
        f' solref="{contact_time} 1"'
    )


def roller_class(wheel: Wheel) -> str:
    """Write the default class `roller`, for the top of a model: rollers touch no other roller."""
    across, along = wheel.roller_radius, sqrt(wheel.radius * wheel.roller_radius)
    return f"""<default class="roller">
<joint type="hinge" axis="0 0 1" damping="1e-7" armature="1e-8"/>
<geom type="ellipsoid" size="{vector([across, across, along])}" mass="{wheel.roller_mass}"
 contype="1" conaffinity="0" {contact(wheel.friction, wheel.contact_time)}/>
</default>"""


def body(
    wheel: Wheel, name: str, hub: Iterable[float], running: Iterable[float], up: Iterable[float]
) -> str:
    """Write a wheel and its joint `name`: x along its running direction, y `up` to the hub.

    A positive rate of the joint is the wheel's body over the surface, along `running`. Raises
    `ValueError` where the rollers cannot be shared out evenly to the rows.
    """
    if wheel.rollers % wheel.rows:
        raise ValueError(f"expected rollers in {wheel.rows} equal rows, got {wheel.rollers}")
    places = range(wheel.rollers // wheel.rows)
    rollers = [_roller(wheel, row, place) for row in range(wheel.rows) for place in places]
    # Turned about +z = running x up, the rim would push its hub backwards.
    return f"""<body name="{name}" pos="{vector(hub)}" xyaxes="{vector([*running, *up])}">
<joint name="{name}" axis="0 0 -1" armature="{wheel.armature}"/>
<inertial pos="0 0 0" mass="0.02" diaginertia="4e-6 4e-6 5e-6"/>
{lines(rollers)}
</body>"""


def motor(wheel: Wheel, name: str) -> str:
    """Write the speed servo of a wheel's joint."""
    return f'<velocity name="{name}" joint="{name}" kv="{wheel.servo_gain}"/>'


def _roller(wheel: Wheel, row: int, place: int) -> str:
    """Write a roller, its hinge a tangent of the rim. At rest the wheel stands between two."""
    gap = tau / (wheel.rollers // wheel.rows)
    turn = gap * (place + 1 / 2 + row / wheel.rows) - pi / 2
    x, y = cos(turn), sin(turn)
    lever = wheel.radius - wheel.roller_radius
    sideways = wheel.row_distance * (row - (wheel.rows - 1) / 2)
    return f"""<body pos="{vector([lever * x, lever * y, sideways])}" zaxis="{vector([-y, x, 0])}">
<joint class="roller"/><geom class="roller"/></body>"""


def vector(numbers: Iterable[float]) -> str:
    """Write numbers as MuJoCo's attributes want them."""
    return " ".join(f"{number:.9g}" for number in numbers)


def lines(parts: Iterable[str]) -> str:
    """Write parts below each other."""
    return "\n".join(parts)
