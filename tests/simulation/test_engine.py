"""The frame of a run: mechanics that is known by heart, and every way to leave physics behind."""

import math

import numpy as np
import pytest

from omniproof.simulation.engine import ImplausibleRunError, Limits, run

BALL = """<mujoco><worldbody>{floor}<body name="ball" pos="0 0 {height}"><freejoint/>
<geom type="sphere" size=".1" mass="{mass}"/></body></worldbody></mujoco>"""
PENDULUM = """<mujoco><option integrator="RK4"/><worldbody><body name="bob">
<joint type="hinge" axis="0 1 0"/><geom type="sphere" size=".01" pos=".3 0 0" mass="1"/>
</body></worldbody></mujoco>"""
FLOOR = '<geom type="plane" size="1 1 1"/>'


def ball(height=1.0, floor="", mass=1.0):
    return BALL.format(height=height, floor=floor, mass=mass)


def leave_alone(model, data):
    """No actuator, no force."""


def place(model, data):
    return dict(zip("xyz", data.body("ball").xpos, strict=True))


def record(xml, **changed):
    given = {"duration": 0.3, "step": 1e-3, "control": leave_alone, "observe": place, "every": 0.01}
    return run(xml, **(given | changed))


def test_a_ball_falls():
    """A first-order integrator falls behind by g t h / 2: 1.5 mm after 0.3 s with h = 1 ms."""
    fall = record(ball())
    assert fall.time == pytest.approx(np.arange(31) / 100, abs=1e-12)
    expected = 1 - 9.81 * fall.time**2 / 2
    assert fall.columns["z"] == pytest.approx(expected, abs=9.81 * 0.3 * 1e-3 / 2 * 1.01)
    assert np.abs(fall.columns["x"]).max() == 0


def test_a_pendulum_speeds_up_as_its_height_says():
    """Let go horizontally, at angle q the energy gives (q')^2 = 2 g l sin q / (l^2 + 2 r^2 / 5)."""
    swing = record(
        PENDULUM,
        observe=lambda model, data: {"angle": data.qpos[0], "rate": data.qvel[0]},
    )
    square = 2 * 9.81 * 0.3 * np.sin(swing.columns["angle"]) / (0.3**2 + 0.4 * 0.01**2)
    assert swing.columns["angle"][-1] > 1
    assert swing.columns["rate"] ** 2 == pytest.approx(square, abs=1e-4 * square.max())


def test_a_run_may_begin_before_it_is_recorded():
    seen = []
    fall = record(
        ball(), start=-0.1, duration=0.1, control=lambda model, data: seen.append(data.time)
    )
    assert seen[0] == -0.1
    assert len(seen) == 200
    assert fall.time[0] == 0
    assert fall.columns["z"][0] == pytest.approx(1 - 9.81 * 0.01 / 2, abs=1e-3)


def test_control_acts():
    def push(model, data):
        data.qfrc_applied[0] = 2.0

    pushed = record(ball(), control=push)
    assert pushed.columns["x"][-1] == pytest.approx(2 * 0.3**2 / 2, rel=0.01)


def test_two_runs_are_equal_to_the_last_bit():
    one, two = (record(ball(height=0.1001, floor=FLOOR)) for _ in range(2))
    assert one.columns["z"].tobytes() == two.columns["z"].tobytes()


@pytest.mark.parametrize(
    ("xml", "limits", "reason"),
    [
        pytest.param(
            ball(height=0.08, floor=FLOOR),
            Limits(),
            "at t = 0 s a contact is 0.02 m deep, more than 0.001",
            id="sunk",
        ),
        pytest.param(
            ball(),
            Limits(speed=1),
            "at t = 0.11 s a body moves at 1.08 m/s, more than 1",
            id="fast",
        ),
        pytest.param(
            ball(mass=2),
            Limits(energy=1),
            "at t = 0.11 s the kinetic energy is 1.16 J, more than 1",
            id="energetic",
        ),
    ],
)
def test_an_implausible_run_says_why_and_how_to_see_it_again(xml, limits, reason):
    with pytest.raises(ImplausibleRunError) as caught:
        record(xml, limits=limits, parameters={"mass": 2.5, "start": "flying"})
    assert str(caught.value) == f"{reason}\n    to reproduce: mass=2.5, start=flying, step=0.001"
    assert caught.value.parameters == {"mass": 2.5, "start": "flying", "step": 1e-3}


def test_a_state_that_diverged_is_not_reset_in_silence():
    def explode(model, data):
        data.qfrc_applied[0] = math.inf

    with pytest.raises(ImplausibleRunError, match=r"^at t = 0.01 s the engine warned: .*unstable"):
        record(ball(), control=explode)


@pytest.mark.parametrize(
    ("times", "message"),
    [
        pytest.param({"step": 3e-3}, "every to be a multiple of step = 0.003, got 0.01", id="step"),
        pytest.param(
            {"duration": 0.305}, "duration to be a multiple of every = 0.01, got 0.305", id="end"
        ),
        pytest.param(
            {"start": -0.005}, "start to be a multiple of every = 0.01, got -0.005", id="start"
        ),
    ],
)
def test_times_fit(times, message):
    with pytest.raises(ValueError, match=f"^expected {message}$"):
        record(ball(), **times)


def test_a_model_that_mujoco_rejects():
    with pytest.raises(ValueError, match="XML"):
        record("<mujoco><nothing/></mujoco>")
