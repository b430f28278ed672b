"""A run that left physics behind fails in every model, and its message brings it about again."""

from dataclasses import replace

import pytest

from omniproof.simulation.case import model
from omniproof.simulation.engine import ImplausibleRunError

ROBOT, BALL, SPHERE = (
    ("omni-robot", "line-30-flying"),
    ("ballbot", "on-top-45-along-x"),
    ("sphere", "three-20-17-dry"),
)


@pytest.mark.parametrize(
    ("place", "changed", "reason"),
    [
        pytest.param(ROBOT, {"contact_time": 0.04}, "deep", id="robot: contacts 100 times as soft"),
        pytest.param(ROBOT, {"mass": 1000.0}, "energy", id="robot: a ton at 0.05 m/s has 1.25 J"),
        pytest.param(ROBOT, {"roller_radius": 5e-4}, "turns", id="robot: thin rollers, 100 rad/s"),
        pytest.param(BALL, {"speed_2": 2.0}, "energy", id="ball: a wheel at 2 m/s"),
        pytest.param(BALL, {"contact_time": 0.02}, "deep", id="ball: contacts 44 times as soft"),
        pytest.param(SPHERE, {"start": 60.0}, "turns", id="sphere: let go at 60 rad/s"),
        pytest.param(SPHERE, {"step": 0.02}, "more than", id="sphere: rollers thrown off"),
    ],
)
def test_an_implausible_run_fails_with_what_reproduces_it(place, changed, reason):
    found = model(place[0])
    case = found.case(place[1])
    parameters = {**case.parameters, **changed}
    with pytest.raises(ImplausibleRunError) as caught:
        found.simulate(replace(case, parameters=parameters))
    why, _, listed = str(caught.value).partition("\n    to reproduce: ")
    assert why.startswith("at t = ")
    assert reason in why
    told = dict(one.split("=", 1) for one in listed.split(", "))
    assert {name: told[name] for name in parameters} == {k: f"{v}" for k, v in parameters.items()}
    with pytest.raises(ImplausibleRunError) as again:
        found.simulate(replace(case, parameters=caught.value.parameters))
    assert str(again.value).startswith(why)
