"""MuJoCo model of a level platform on three omni wheels, inside a ball that rolls or on top of one.

Neither of the laws that the simulation is to decide between is built in: what moves the ball is
friction, between rollers and ball and between ball and floor. Imposed are only the platform's four
joints, which keep it level (the quasi-static motion of Yi, section 3).

MuJoCo has no concave surface, so the inside of the ball is a shell of thin boxes, the facets, each
tangent to the sphere at its middle and spread evenly. Facets lie outside the sphere, by up to
`facet_gap`; so the platform sits deeper by that and by the depth of its contacts, and the zenith
angle is a little smaller than asked for. Half the step, half the side of the facets, or contacts
stiffer by a third change the ball's velocity by less than 0.3 %.

Lengths in m, masses in kg; the numbers of the robot are ours, the paper has none.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, radians, sqrt

import numpy as np
from numpy.typing import NDArray

from omniproof.kinematics.ballbot import AZIMUTHS, contact_frame
from omniproof.simulation import omni_wheel
from omniproof.simulation.omni_wheel import Wheel, contact, lines, vector

BALL_RADIUS = 0.1
BALL_MASS = 0.5
BALL_INERTIA = 2 / 3 * BALL_MASS * BALL_RADIUS**2
"""Of a thin shell: L and rho of the laws are one radius here, as in the paper."""

WHEEL_RADIUS = 0.02
PLATFORM_MASS = 2.0
PLATFORM_INERTIA = 0.01

SERVO = 0.25
ARMATURE = 0.01
"""Gain times step over inertia of a wheel's servo, and that inertia (kg m^2)."""

WHEELS = tuple(f"wheel-{number}" for number in range(1, len(AZIMUTHS) + 1))
GOLDEN_TURN = pi * (1 + sqrt(5))

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Ballbot:
    """A robot and its floor.

    `zenith_angle_deg` (degrees) of the wheels is counted from the pole of the ball next to them:
    the lowest point for a platform `inside`, the highest one for a platform on top. `facets` is how
    many boxes make the inner surface; `floor_torsion` (m) is the floor's friction against the
    ball's spin about the vertical, as a lever of the load: 0 for contact in a point. `friction` is
    Coulomb's, `contact_time` (s) says how soft contacts are, `step` (s) is that of the run. Raises
    `ValueError` for an angle from 90 degrees on, at which the wheels do not move the ball.
    """

    inside: bool
    zenith_angle_deg: float
    facets: int = 4000
    floor_torsion: float = 0.0
    friction: float = 0.8
    contact_time: float = 0.003
    step: float = 0.001

    def __post_init__(self) -> None:
        angle = self.zenith_angle_deg
        if not 0 < angle < 90:
            raise ValueError(f"expected a zenith angle between 0 and 90 degrees, got {angle:g}")

    @property
    def zenith_angle(self) -> float:
        """As in the laws: from the downward vertical, in radians; above pi/2 for wheels on top."""
        angle = radians(self.zenith_angle_deg)
        return angle if self.inside else pi - angle

    @property
    def wheel(self) -> Wheel:
        """One of its wheels."""
        return Wheel(
            WHEEL_RADIUS,
            friction=self.friction,
            contact_time=self.contact_time,
            servo_gain=SERVO * ARMATURE / self.step,
            armature=ARMATURE,
        )

    def contact(self, torsion: float = 0.0) -> str:
        """Write what decides the contacts of a geom."""
        return contact(self.friction, self.contact_time, torsion)


def mjcf(robot: Ballbot) -> str:
    """Write the model of a robot: ball at rest on the floor, three wheels that touch it.

    Sensors, in the frame of the floor: `ball-velocity`, `ball-spin`, `platform-velocity`,
    `platform-spin`, `platform-position`, `platform-heading`; and `wheel-1` ... (rad/s).
    """
    floor = robot.contact(robot.floor_torsion)
    return f"""<mujoco model="ballbot">
<size memory="200M"/>
<option integrator="implicitfast" cone="elliptic" impratio="10"/>
<default>{omni_wheel.roller_class(robot.wheel)}</default>
<worldbody>
<geom name="floor" type="plane" size="3 3 0.1" contype="0" conaffinity="2" {floor}/>
<body name="ball" pos="0 0 {BALL_RADIUS}">
<freejoint/>
<inertial pos="0 0 0" mass="{BALL_MASS}" diaginertia="{vector([BALL_INERTIA] * 3)}"/>
<geom name="ball" type="sphere" size="{BALL_RADIUS}" contype="2" conaffinity="0" {floor}/>
{_surface(robot)}
</body>
{_platform(robot)}
</worldbody>
<actuator>{lines(omni_wheel.motor(robot.wheel, name) for name in WHEELS)}</actuator>
{_sensors()}
</mujoco>"""


def facet_normals(count: int) -> Floats:
    """Directions spread evenly over the sphere, from its centre: count x 3.

    Source: the Fibonacci lattice, Gonzalez, Mathematical Geosciences 42 (2010), 49-64.
    """
    place = np.arange(count) + 0.5
    height = 1 - 2 * place / count
    level = np.sqrt(1 - height**2)
    turn = GOLDEN_TURN * place
    return np.column_stack([level * np.cos(turn), level * np.sin(turn), height])


def facet_half_side(count: int) -> float:
    """Half the side of a facet (m), enough that the shell has no holes.

    Of `count` directions the nearest is nowhere farther than 1.53 sqrt(pi / count), by measurement
    for 1000 to 16000; facets overlap, and since they are tangent none stands out on the inside.
    """
    return 1.6 * BALL_RADIUS * sqrt(pi / count)


def facet_gap(count: int) -> float:
    """How far (m) the surface is from the sphere at most, midway between facets."""
    return sqrt(BALL_RADIUS**2 + facet_half_side(count) ** 2) - BALL_RADIUS


def _surface(robot: Ballbot) -> str:
    """Write what the rollers touch.

    On top it is a second sphere: a contact takes the larger friction of its two geoms, and what
    holds the ball on the floor must not hold the rollers.
    """
    touching = f'contype="0" conaffinity="1" {robot.contact()}'
    if not robot.inside:
        return f'<geom name="surface" type="sphere" size="{BALL_RADIUS}" {touching}/>'
    side, half_thickness = facet_half_side(robot.facets), 0.002
    box = f'<geom type="box" size="{vector([side, side, half_thickness])}" {touching}'
    return lines(
        f'{box} pos="{vector(normal * (BALL_RADIUS + half_thickness))}" zaxis="{vector(normal)}"/>'
        for normal in facet_normals(robot.facets)
    )


def _platform(robot: Ballbot) -> str:
    """Write the platform: it moves along three axes and turns about the vertical only."""
    slides = lines(f'<joint type="slide" axis="{axis}"/>' for axis in ("1 0 0", "0 1 0", "0 0 1"))
    wheels = (_wheel(robot, *named) for named in zip(WHEELS, AZIMUTHS, strict=True))
    return f"""<body name="platform" pos="0 0 {BALL_RADIUS}">
{slides}
<joint type="hinge" axis="0 0 1"/>
<inertial pos="0 0 0" mass="{PLATFORM_MASS}" diaginertia="{vector([PLATFORM_INERTIA] * 3)}"/>
{lines(wheels)}
</body>"""


def _wheel(robot: Ballbot, name: str, azimuth: float) -> str:
    """Write a wheel on its contact frame C: it runs along the y-axis."""
    frame = np.array(contact_frame(azimuth, robot.zenith_angle, BALL_RADIUS), dtype=np.float64)
    running, inward, touching = frame[:3, 1], frame[:3, 2], frame[:3, 3]
    up = inward if robot.inside else -inward
    return omni_wheel.body(robot.wheel, name, touching + WHEEL_RADIUS * up, running, up)


def _sensors() -> str:
    bodies = lines(
        f'<framelinvel name="{body}-velocity" objtype="xbody" objname="{body}"/>\n'
        f'<frameangvel name="{body}-spin" objtype="xbody" objname="{body}"/>'
        for body in ("ball", "platform")
    )
    return f"""<sensor>
{bodies}
<framepos name="platform-position" objtype="xbody" objname="platform"/>
<framexaxis name="platform-heading" objtype="xbody" objname="platform"/>
{lines(f'<jointvel name="{name}" joint="{name}"/>' for name in WHEELS)}
</sensor>"""
