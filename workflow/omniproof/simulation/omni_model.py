"""A robot on omni wheels as a MuJoCo model.

No sideways freedom is put in by hand, as a contact without friction across the wheel would: that
would be the very formula under test. Every passive roller is a body of its own (`omni_wheel`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from math import cos, radians, sin
from typing import Any

from omniproof.simulation import omni_wheel
from omniproof.simulation.engine import Parameters
from omniproof.simulation.omni_wheel import Wheel, lines


@dataclass(frozen=True)
class Robot:
    """A robot: wheels at angles on its body (degrees, from x), driven along its tangents.

    `body_radius` (m) reaches to the contacts, `mass` (kg) is the body's alone.
    """

    wheel_angles_deg: str = "30 150 270"
    body_radius: float = 0.108
    mass: float = 1.0
    wheel: Wheel = field(default_factory=lambda: Wheel(radius=0.023))

    @property
    def parameters(self) -> dict[str, float | str]:
        """All that the robot is built from, by name; `radius` is the wheels'."""
        values = asdict(self)
        return {**values.pop("wheel"), **values}


def robot_from(parameters: Parameters) -> Robot:
    """Return the robot of `parameters`, which may name more than a robot has."""
    return Robot(
        wheel=Wheel(**_chosen(Wheel, parameters)),
        **{name: value for name, value in _chosen(Robot, parameters).items() if name != "wheel"},
    )


def _chosen(record: type[Wheel] | type[Robot], parameters: Parameters) -> Mapping[str, Any]:
    return {x.name: parameters[x.name] for x in fields(record) if x.name in parameters}


def mjcf(robot: Robot) -> str:
    """Return a robot on its floor as MuJoCo's XML.

    Joints and motors are `wheel-1`, `wheel-2`, … in the order of the angles; the body is `robot`.
    Raises `ValueError` where the rollers cannot be shared out evenly to the rows.
    """
    wheel = robot.wheel
    angles = [radians(float(angle)) for angle in robot.wheel_angles_deg.split()]
    numbered = list(enumerate(angles, 1))
    return f"""<mujoco>
<option integrator="implicitfast" cone="elliptic" impratio="10"/>
<default>
{omni_wheel.roller_class(wheel)}
</default>
<worldbody>
<geom name="floor" type="plane" size="2 2 .1" contype="0" conaffinity="1"
 {omni_wheel.contact(wheel.friction, wheel.contact_time)}/>
<body name="robot" pos="0 0 {wheel.radius}">
<freejoint/>
<geom type="cylinder" size="{robot.body_radius} .01" mass="{robot.mass}"
 contype="0" conaffinity="0"/>
{lines(_wheel(robot, number, angle) for number, angle in numbered)}
</body>
</worldbody>
<actuator>
{lines(omni_wheel.motor(wheel, f"wheel-{number}") for number, _ in numbered)}
</actuator>
</mujoco>"""


def _wheel(robot: Robot, number: int, angle: float) -> str:
    """Return a wheel that drives along the counter-clockwise tangent."""
    x, y = cos(angle), sin(angle)
    hub = (robot.body_radius * x, robot.body_radius * y, 0.0)
    return omni_wheel.body(robot.wheel, f"wheel-{number}", hub, (-y, x, 0.0), (0.0, 0.0, 1.0))
