"""Section 3 and the frames of Section 4: where the wheels stand, and what moves with what."""

from __future__ import annotations

from sympy import Expr, ImmutableMatrix, Integer, Max, Symbol, acos, cos, pi, sin, symbols

from omniproof.kinematics import ballbot, frames
from omniproof.papers.ballbot.derivations.motion import Vanishing, vanishing
from omniproof.papers.ballbot.derivations.quantities import (
    REGISTRY,
    WHEELS,
    at_wheel_1,
    wheel_frame,
)
from omniproof.papers.ballbot.laws import BALL_RADIUS
from omniproof.papers.ballbot.symbols import PHI, RUNNING_RADIUS, V_X, V_Y, YAW_RATE
from omniproof.registry import Obligation, Relation
from omniproof.transcription.model import Form

TIME = Symbol("t", real=True)
SPIN = Symbol("sigma", real=True)
"""Spin of the ball about the vertical, rad/s."""

MISPRINTED_AXIS = "eq:5-1[1,3]"


@REGISTRY.derives("sec:3/spacing")
def spacing() -> Expr:
    """Return the widest angle between neighbours (degrees): 120 exactly if all are alike."""
    places = [frames.origin(ballbot.contact_frame(a, pi / 2, 1)) for a in ballbot.AZIMUTHS]
    pairs = zip(places, [*places[1:], places[0]], strict=True)
    return Max(*(acos(a.dot(b)) for a, b in pairs)) * 180 / pi


@REGISTRY.derives("sec:3/wheels-normal-to-surface", rests_on=[MISPRINTED_AXIS])
def wheels_and_surface() -> Vanishing:
    """Components of each contact across its z-axis, and along the axle of its wheel."""
    found = []
    for wheel in WHEELS:
        axes, contact = frames.axes(wheel_frame(wheel)), frames.origin(wheel_frame(wheel))
        found += [*axes[:, 2].cross(contact), axes[:, 0].dot(contact)]
    return vanishing(found)


@REGISTRY.derives("sec:3/frame-at-centre", "sec:3/frames-at-contacts")
def distances() -> tuple[Expr, ...]:
    """Squared distance of each contact from the origin of B, and that of the inner surface."""
    contacts = (frames.origin(wheel_frame(wheel)) for wheel in WHEELS)
    return (RUNNING_RADIUS**2, *(contact.dot(contact) for contact in contacts))


@REGISTRY.derives("sec:3/inertial-frame")
def acceleration() -> Relation:
    """Acceleration of a point at rest in B, along its radius: zero in an inertial frame."""
    point = ImmutableMatrix([*symbols("x y", real=True), 0, 1])
    moved = frames.translation("x", V_X * TIME) * frames.translation("y", V_Y * TIME)
    path = moved * frames.rotation("z", YAW_RATE * TIME) * point
    found = path.diff(TIME, 2).subs(TIME, 0)[0]
    return Relation(
        (Integer(0), found),
        condition=r"\omega_z^B = 0",
        proof=(Obligation(Form.EQUAL, (found.subs(YAW_RATE, 0), Integer(0))),),
    )


@REGISTRY.derives("sec:3/platform-stays-level")
def tilt() -> Relation:
    """Moment (N m) about the ground contact of a level platform: it tilts unless that is zero.

    A platform that is tilted by t has the moment of its weight, depth h below the centre, as well.
    """
    resistance, tilted = symbols("M t", real=True)
    weight, depth = symbols("W h", positive=True)
    moment = resistance - weight * depth * sin(tilted)
    level = moment.subs(tilted, 0)
    return Relation(
        (Integer(0), level),
        condition=r"\text{nothing resists the rolling}",
        proof=(Obligation(Form.EQUAL, (level.subs(resistance, 0), Integer(0))),),
    )


@REGISTRY.derives("sec:3/velocity-at-ground-contact")
def velocity_at_contact() -> Relation:
    """Velocity of the ball's point on the ground, and that of the place of contact below B."""
    lowest = -BALL_RADIUS * frames.UNIT["z"]
    material = ballbot.ball_twist(V_X, V_Y, SPIN, BALL_RADIUS).at(lowest)
    centre = ballbot.platform_twist(V_X, V_Y, YAW_RATE).velocity * TIME
    place = (centre + lowest).diff(TIME)
    return Relation(
        (V_X, material[0]),
        condition=r"G \text{ is the place of contact; the ball's own point there is at rest}",
        proof=(
            Obligation(Form.EQUAL, (place[0], V_X)),
            Obligation(Form.EQUAL, (place[1], V_Y)),
        ),
    )


@REGISTRY.derives("sec:3/yaw-at-ground-contact")
def yaw_at_contact() -> Relation:
    """Spin of the ball and yaw of the platform; the wheels feel their difference only."""
    ball = ballbot.ball_twist(V_X, V_Y, SPIN, BALL_RADIUS)
    platform = ballbot.platform_twist(V_X, V_Y, YAW_RATE)
    law = ballbot.wheel_law(PHI, RUNNING_RADIUS, BALL_RADIUS)
    return Relation(
        (platform.rotation[2], ball.rotation[2]),
        condition=r"\omega_z^G \text{ is the yaw rate of the platform, not the spin of the ball}",
        proof=tuple(Obligation(Form.EQUAL, (law[k, 2], -law[k, 3])) for k in range(law.rows)),
    )


for _wheel in WHEELS:
    REGISTRY.derives(f"eq:5-{_wheel}", f"eq:5-{_wheel}/product")(
        lambda wheel=_wheel: wheel_frame(wheel)
    )


@REGISTRY.derives("sec:4/radius-of-ball")
def radii() -> Relation:
    """Distance of the lowest contact from the centre, and radius of a ball with a wall."""
    wall = Symbol("w", positive=True)
    found = -frames.origin(wheel_frame(1)).subs(PHI, 0)[2]
    outside = RUNNING_RADIUS + wall
    return Relation(
        (found, outside),
        condition=r"\text{the wall of the ball has no thickness}",
        proof=(Obligation(Form.EQUAL, (found, outside.subs(wall, 0))),),
    )


@REGISTRY.derives("sec:4/zenith-angle")
def angles_of_axes() -> tuple[Expr, ...]:
    """Cosine of the zenith angle, and of the angle between the z-axes of B and of each wheel."""
    poses = (ballbot.contact_frame(a, PHI, RUNNING_RADIUS) for a in ballbot.AZIMUTHS)
    return (cos(PHI), *(frames.axes(pose)[2, 2] for pose in poses))


@REGISTRY.derives("sec:4/sine")
def sine() -> Expr:
    """Distance of contact 1 from the vertical axis, over the radius; wheel 1 is on minus x."""
    return -frames.origin(wheel_frame(1))[0] / RUNNING_RADIUS


@REGISTRY.derives("sec:4/cosine")
def cosine() -> Expr:
    """Depth of contact 1 below the centre, over the radius."""
    return -frames.origin(wheel_frame(1))[2] / RUNNING_RADIUS


@REGISTRY.derives("sec:4/no-vertical-motion")
def vertical_velocity() -> Vanishing:
    """Vertical velocity of the rolling ball, at its centre and at the ground."""
    ball = ballbot.ball_twist(V_X, V_Y, SPIN, BALL_RADIUS)
    return vanishing([ball.velocity[2], ball.at(-BALL_RADIUS * frames.UNIT["z"])[2]])


@REGISTRY.derives("sec:4/no-tilting")
def level_rotation() -> Vanishing:
    """Rotation about x and y of a platform whose axis z stays vertical."""
    turned = frames.rotation("z", YAW_RATE * TIME)
    rate = (turned.diff(TIME) * frames.inverse(turned)).subs(TIME, 0)
    return vanishing(frames.components(rate)[0][:2])


@REGISTRY.derives("eq:6-1/components", "eq:6-1")
def rotational_part_at_wheel() -> ImmutableMatrix:
    """Rotation of a level platform along the axes of wheel 1."""
    return at_wheel_1()[0]


@REGISTRY.derives("eq:6-2/components", "eq:6-2")
def translational_part_at_wheel() -> ImmutableMatrix:
    """Velocity of the contact of wheel 1, as a point of a level platform, along its axes."""
    return at_wheel_1()[1]


@REGISTRY.derives("eq:6-2[3]", rests_on=[MISPRINTED_AXIS])
def normal_motion_at_wheel() -> Expr:
    """Velocity along the normal of the surface: it rests on the third axis of wheel 1."""
    return at_wheel_1()[1][2]
