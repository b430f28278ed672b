"""The model of the ballbot, compiled by MuJoCo and measured: places, senses, the closed shell."""

from math import cos, radians, sin

import mujoco
import numpy as np
import pytest

from omniproof.simulation.ballbot_model import (
    BALL_RADIUS,
    WHEEL_RADIUS,
    Ballbot,
    facet_gap,
    facet_normals,
    mjcf,
)

AZIMUTHS_DEG = {1: 180, 2: -60, 3: 60}
SEED = 20250101


def compiled(robot):
    model = mujoco.MjModel.from_xml_string(mjcf(robot))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def contact_by_hand(azimuth_deg, zenith_deg, below):
    """From the centre of the ball to a contact, and counter-clockwise along the parallel."""
    azimuth, zenith = radians(azimuth_deg), radians(zenith_deg)
    level = np.array([cos(azimuth), sin(azimuth), 0])
    upward = np.array([0, 0, -1 if below else 1])
    tangent = np.array([-sin(azimuth), cos(azimuth), 0])
    return sin(zenith) * level + cos(zenith) * upward, tangent


@pytest.mark.parametrize("number", [1, 2, 3])
@pytest.mark.parametrize(
    ("inside", "distance"),
    [
        pytest.param(True, BALL_RADIUS - WHEEL_RADIUS, id="inside"),
        pytest.param(False, BALL_RADIUS + WHEEL_RADIUS, id="on top"),
    ],
)
def test_wheels_stand_on_their_zenith_angle(number, inside, distance):
    """Hubs on the line from the centre; a positive rate drives the platform counter-clockwise."""
    model, data = compiled(Ballbot(inside, 40, facets=50))
    outward, tangent = contact_by_hand(AZIMUTHS_DEG[number], 40, inside)
    centre = data.body("ball").xpos
    assert data.body(f"wheel-{number}").xpos - centre == pytest.approx(distance * outward, abs=1e-8)
    jacobian = np.zeros((3, model.nv))
    place, wheel = centre + BALL_RADIUS * outward, model.body(f"wheel-{number}").id
    mujoco.mj_jac(model, data, jacobian, None, place, wheel)
    rim = jacobian[:, model.joint(f"wheel-{number}").dofadr[0]]
    assert rim == pytest.approx(-WHEEL_RADIUS * tangent, abs=1e-8)


@pytest.mark.parametrize("angle_deg", [0, 90, 120])
def test_wheels_that_move_no_ball_are_refused(angle_deg):
    message = f"expected a zenith angle between 0 and 90 degrees, got {angle_deg}"
    with pytest.raises(ValueError, match=message):
        Ballbot(inside=True, zenith_angle_deg=angle_deg)


@pytest.mark.parametrize("inside", [True, False])
def test_the_platform_stays_level_and_is_free_otherwise(inside):
    """Three translations, one turn about the vertical; the ball has all six freedoms."""
    model, _ = compiled(Ballbot(inside, 45, facets=50))
    platform = model.body("platform")
    start, count = platform.jntadr[0], platform.jntnum[0]
    kinds = model.jnt_type[start : start + count].tolist()
    slide, hinge = int(mujoco.mjtJoint.mjJNT_SLIDE), int(mujoco.mjtJoint.mjJNT_HINGE)
    assert kinds == [slide, slide, slide, hinge]
    assert model.jnt_axis[start + 3] == pytest.approx([0, 0, 1])
    assert model.body("ball").dofnum[0] == 6
    assert model.body("ball").mass[0] == pytest.approx(0.5)


@pytest.mark.parametrize("inside", [True, False])
def test_rollers_touch_the_running_surface_only(inside):
    """Once dropped, contacts are ball with floor and rollers with what they run on."""
    model, data = compiled(Ballbot(inside, 45))
    for _ in range(100):
        mujoco.mj_step(model, data)
    ball = model.body("ball").id
    pairs = {tuple(sorted(model.geom_bodyid[pair])) for pair in data.contact.geom}
    assert (0, ball) in pairs
    assert {pair[0] for pair in pairs} == {0, ball}
    touching = {model.body_parentid[pair[1]] for pair in pairs if pair[0] == ball}
    assert touching == {model.body(f"wheel-{number}").id for number in (1, 2, 3)}


@pytest.mark.parametrize("count", [1000, 4000])
def test_the_shell_is_closed(count):
    """Along any direction from the centre there is a facet, and none nearer than the sphere."""
    model, data = compiled(Ballbot(inside=True, zenith_angle_deg=45, facets=count))
    facets = model.geom_type == mujoco.mjtGeom.mjGEOM_BOX
    frames = data.geom_xmat.reshape(-1, 3, 3)[facets]
    normals, side = frames[:, :, 2], model.geom_size[facets][0, 0]
    directions = np.random.default_rng(SEED).normal(size=(2000, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    cosines = directions @ normals.T
    nearest = np.argsort(-cosines, axis=1)[:, :8]
    distances = BALL_RADIUS / np.take_along_axis(cosines, nearest, axis=1)
    points = distances[:, :, None] * directions[:, None, :]
    offsets = np.einsum("dki,dkij->dkj", points, frames[nearest])[:, :, :2]
    hit = (np.abs(offsets) <= side).all(axis=2)
    assert hit.any(axis=1).all()
    depth = np.where(hit, distances, np.inf).min(axis=1) - BALL_RADIUS
    assert depth.min() >= 0
    assert depth.max() <= facet_gap(count)


def test_facets_are_spread_evenly():
    """Of an even spread, sums of x, y, z vanish and their squares have the mean 1/3."""
    normals = facet_normals(4000)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1)
    assert normals.mean(axis=0) == pytest.approx(0, abs=1e-3)
    assert normals.T @ normals / 4000 == pytest.approx(np.eye(3) / 3, abs=1e-3)
