"""The second engine: mechanics known by heart by both engines, and what keeps them comparable."""

import math
from functools import cache

import mujoco
import numpy as np
import pytest

from omniproof.simulation import omni_robot
from omniproof.simulation.case import Case
from omniproof.simulation.engine import ImplausibleRunError, Limits, run
from omniproof.simulation.engines import is_installed
from omniproof.simulation.omni_model import Robot, mjcf

if not is_installed("drake"):
    pytest.skip("Drake has no package for this platform", allow_module_level=True)

from omniproof.simulation.drake_engine import STICTION, contact_depth, contact_stiffness

BOTH = pytest.mark.parametrize("engine", ["mujoco", "drake"])
GRAVITY = 9.81
WIDE = Limits(speed=100, energy=1e4)


def leave_alone(model, data):
    """No actuator, no force."""


def record(xml, engine, **changed):
    given = {"duration": 0.3, "step": 1e-3, "every": 0.01, "limits": WIDE, "engine": engine}
    return run(xml, **({"control": leave_alone} | given | changed))


def place(model, data):
    return dict(zip("xyz", data.body("ball").xpos, strict=True))


# Dynamics

FALLING = """<mujoco><option cone="elliptic"/><worldbody><body name="ball" pos="0 0 1"><freejoint/>
<geom type="sphere" size=".1" mass="1"/></body></worldbody></mujoco>"""


@BOTH
def test_a_ball_falls(engine):
    """A first-order integrator falls behind by g t h / 2, whichever engine has it."""
    fall = record(FALLING, engine, observe=place)
    expected = 1 - GRAVITY * fall.time**2 / 2
    assert fall.columns["z"] == pytest.approx(expected, abs=GRAVITY * 0.3 * 1e-3 / 2 * 1.01)
    assert np.abs(fall.columns["x"]).max() == 0


PENDULUM = """<mujoco><option cone="elliptic"/><worldbody>
<body pos="1 2 3" euler="0 0 90"><joint axis="1 0 0"/>
<geom type="sphere" size=".01" pos="0 .3 0" mass="1"/></body></worldbody></mujoco>"""


@BOTH
def test_a_pendulum_swings_down_about_a_hinge_whose_frame_is_turned(engine):
    """Let go horizontally, at angle q the energy gives (q')^2 = 2 g l sin q / (l^2 + 2 r^2 / 5)."""

    def observe(model, data):
        return {"angle": data.qpos[0], "rate": data.qvel[0]}

    swing = record(PENDULUM, engine, observe=observe, step=1e-4)
    square = 2 * GRAVITY * 0.3 * np.sin(-swing.columns["angle"]) / (0.3**2 + 0.4 * 0.01**2)
    assert swing.columns["angle"][-1] < -1
    assert swing.columns["rate"] ** 2 == pytest.approx(square, abs=2e-3 * square.max())


SERVO = """<mujoco><option cone="elliptic" gravity="0 0 0"/><worldbody>
<body name="wheel"><joint name="axle" axis="0 0 1" armature=".02" damping="{damping}"/>
<inertial pos="0 0 0" mass="1" diaginertia=".02 .02 .03"/></body></worldbody>
<actuator><velocity joint="axle" kv=".5"/></actuator></mujoco>"""


@BOTH
@pytest.mark.parametrize("damping", [0.0, 0.5])
def test_a_servo_speeds_up_a_wheel_and_its_armature(engine, damping):
    """I w' = k (u - w) - c w, with I = 0.03 + 0.02 kg m^2."""

    def ask(model, data):
        data.ctrl[0] = 4.0

    run_up = record(
        SERVO.format(damping=damping),
        engine,
        control=ask,
        observe=lambda model, data: {"rate": data.qvel[0]},
    )
    resistance = 0.5 + damping
    expected = 4 * 0.5 / resistance * (1 - np.exp(-run_up.time * resistance / 0.05))
    assert run_up.columns["rate"] == pytest.approx(expected, abs=0.05)


@BOTH
def test_an_engine_that_gives_up_is_heard(engine):
    """MuJoCo goes on after a warning, Drake stops."""

    def push(model, data):
        data.ctrl[0] = math.nan

    def rate(model, data):
        return {"rate": data.qvel[0]}

    with pytest.raises(ImplausibleRunError, match=r"^at t = 0.01 s the engine warned: "):
        record(SERVO.format(damping=0), engine, control=push, observe=rate)


@BOTH
def test_a_spinning_body_keeps_its_spin_in_the_frame_that_observers_expect(engine):
    """Off one of its own axes, a spin that is no longer the body's x is still the world's."""
    xml = """<mujoco><option cone="elliptic" gravity="0 0 0"/><worldbody>
    <body name="ball" euler="0 90 0">
    <freejoint/><geom type="sphere" size=".1" mass="1"/><body><joint name="rotor" axis="0 0 1"/>
    <geom type="sphere" size=".1" mass="1"/></body></body></worldbody>
    <actuator><motor joint="rotor"/></actuator></mujoco>"""

    def push(model, data):
        data.ctrl[0] = 1e-4

    def spin(model, data):
        found = np.zeros(6)
        body = model.body("ball").id
        mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, body, found, 0)
        return dict(zip("xyz", found[:3], strict=True))

    turned = record(
        xml.replace('type="sphere"', 'contype="0" conaffinity="0" type="sphere"'),
        engine,
        control=push,
        observe=spin,
    )
    last = [turned.columns[axis][-1] for axis in "xyz"]
    # The rotor's z is the world's x; what it gains, the ball loses: M t / (2/5 m r^2).
    assert last == pytest.approx([-1e-4 * 0.3 / (0.4 * 0.1**2), 0, 0], rel=1e-3, abs=1e-9)


# Contacts

SLOPE = """<mujoco><option cone="elliptic" gravity="{along} 0 {down}"/><worldbody>
<geom type="plane" size="9 9 1" friction="{friction}" solref=".004 1"/>
<body name="ball" pos="0 0 .1"><freejoint/>
<geom type="sphere" size=".1" mass="1" friction="{friction}" solref=".004 1"/></body>
</worldbody></mujoco>"""


def slope(friction, angle_deg=30):
    angle = math.radians(angle_deg)
    along, down = GRAVITY * math.sin(angle), -GRAVITY * math.cos(angle)
    return SLOPE.format(along=along, down=down, friction=friction)


@BOTH
@pytest.mark.parametrize(
    ("friction", "acceleration"),
    [
        pytest.param(0.5, 5 / 7 * GRAVITY / 2, id="enough friction: it rolls"),
        pytest.param(0.1, GRAVITY / 2 - 0.1 * GRAVITY * 0.75**0.5, id="too little: it slides"),
    ],
)
def test_a_ball_rolls_or_slides_down_a_slope(engine, friction, acceleration):
    """A ball rolls if friction is 2/7 of the slope's tangent, 0.165 here."""
    down = record(slope(friction), engine, observe=place, duration=0.5)
    assert down.columns["x"][-1] == pytest.approx(acceleration * 0.5**2 / 2, rel=0.01)


@BOTH
def test_a_ball_at_rest_sinks_as_deep_in_both_engines(engine):
    """By hand: 9.81 (1 - 0.9) / 0.9 (0.95 * 0.004)^2 = 15.7 micrometres."""
    rest = record(slope(0.5, 0), engine, observe=place, duration=0.5)
    assert contact_depth(mujoco.MjModel.from_xml_string(slope(0.5, 0))) == pytest.approx(
        1.574e-5, rel=1e-3
    )
    assert 0.1 - rest.columns["z"][-1] == pytest.approx(1.574e-5, rel=0.15)


def test_the_wheels_share_the_weight():
    model = mujoco.MjModel.from_xml_string(mjcf(Robot()))
    # A body of 1 kg, three wheels of 20 g with 18 rollers of 0.5 g.
    load = GRAVITY * (1 + 3 * 0.02 + 54 * 5e-4) / 3
    assert contact_stiffness(model) == pytest.approx(load / contact_depth(model))


TWO_BALLS = """<mujoco><option cone="elliptic"/><worldbody>
<body name="ball"><freejoint/><geom type="sphere" size=".1" {bits}/></body>
<body pos=".19995 0 0"><freejoint/><geom type="sphere" size=".1" {bits}/></body>
</worldbody></mujoco>"""


@BOTH
@pytest.mark.parametrize(
    ("bits", "moves"),
    [
        pytest.param('contype="1" conaffinity="1"', True, id="they push each other away"),
        pytest.param('contype="1" conaffinity="2"', False, id="they do not touch"),
    ],
)
def test_only_geoms_that_may_touch_do(engine, bits, moves):
    pushed = record(TWO_BALLS.format(bits=bits), engine, observe=place, duration=0.05)
    assert (pushed.columns["x"][-1] < -1e-6) == moves


# The robot


@cache
def summary(name):
    """Return the summary of a case; a case is run once."""
    chosen = omni_robot.MODEL.case(name)
    return omni_robot.MODEL.summarise(chosen, omni_robot.MODEL.simulate(chosen))


@pytest.mark.parametrize("start", omni_robot.STARTS)
def test_theory_holds_in_the_other_engine_too(start, root, monkeypatch):
    """As tightly as in MuJoCo; the slip that friction is rounded off below is 1/500 of the speed.

    The engines may differ by that slip, and by half of a contact's depth over the wheel's radius.
    """
    monkeypatch.chdir(root)
    usual, other = (summary(f"circle-left-{start}{engine}") for engine in ("", "-drake"))
    assert other["length_error"] < 0.01
    assert other["mean_error"] < (0.01 if start == "flying" else 0.035)
    assert other["radius_error"] < 0.01
    assert other["length_error_eq_8_9"] == pytest.approx(2 / 3, abs=0.01)
    allowed = STICTION / 0.05 + 1.6e-5 / 2 / 0.023
    assert other["length"] == pytest.approx(usual["length"], rel=allowed)
    assert other["radius"] == pytest.approx(usual["radius"], rel=allowed)
    assert other["length"] != usual["length"]


def short(**changed):
    given = {"start": "standing", "rates_rpm": "30 0 -10", "duration": 0.1, "step": 1e-3}
    return Case("omni-robot", "try", {**Robot().parameters, **given, "engine": "drake", **changed})


def test_two_runs_are_equal_to_the_last_bit():
    one, two = (omni_robot.MODEL.simulate(short()) for _ in range(2))
    assert {k: v.tobytes() for k, v in one.columns.items()} == {
        k: v.tobytes() for k, v in two.columns.items()
    }


def test_a_run_that_is_not_plausible_names_its_engine():
    """A servo that acts a step late, at fifty times the inertia over the step."""
    with pytest.raises(ImplausibleRunError, match=r"(?s)to reproduce: case=try, .*engine=drake"):
        omni_robot.MODEL.simulate(short(armature=0.0, servo_gain=50.0))


@pytest.mark.parametrize(
    ("old", "new", "found"),
    [
        pytest.param('cone="elliptic"', "", "friction cones with edges", id="another cone"),
        pytest.param("<freejoint/>", '<joint type="slide"/>', "joints", id="a slide"),
        pytest.param(
            'type="sphere" size=".1"',
            'type="capsule" size=".1 .1"',
            "contacts of other shapes",
            id="a capsule",
        ),
        pytest.param(
            'mass="1" friction="0.5"', 'mass="1" friction="1"', "differ in friction", id="friction"
        ),
        pytest.param(
            "</worldbody>",
            '</worldbody><equality><weld body1="ball"/></equality>',
            "equalities",
            id="a weld",
        ),
    ],
)
def test_what_is_not_translated_is_refused(old, new, found):
    xml = slope(0.5)
    assert old in xml
    with pytest.raises(
        ValueError, match=f"^expected a model that Drake can run too, found .*{found}"
    ):
        record(xml.replace(old, new), "drake", observe=place)
