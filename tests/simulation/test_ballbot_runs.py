"""Which law the simulated ball obeys, and that the comparison could have come out otherwise."""

from dataclasses import fields, replace
from functools import cache
from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from omniproof.simulation.ballbot import (
    INPUTS,
    MODEL,
    START,
    UNITS,
    allowance,
    case_of,
    drive,
    motion_matrix,
    printed_law,
    relative_error,
    robot_of,
    rolling_law,
    simulate,
    summarise,
)
from omniproof.simulation.ballbot_model import BALL_INERTIA, PLATFORM_INERTIA, Ballbot
from omniproof.simulation.engine import ImplausibleRunError, Recording

SIDES = [pytest.param("inside", id="inside"), pytest.param("on-top", id="on top")]
AZIMUTHS = np.radians([180, -60, 60])


@cache
def recorded(side, angle_deg, input_name, **more):
    case = case_of(side, angle_deg, input_name, **more)
    return case, simulate(case)


def summary(*given, **more):
    return summarise(*recorded(*given, **more))


def law_by_hand(scale, lever):
    """Rows (scale e_k, lever) for the tangents e_k at the azimuths."""
    return np.column_stack([-scale * np.sin(AZIMUTHS), scale * np.cos(AZIMUTHS), np.full(3, lever)])


@pytest.mark.parametrize(
    ("law", "inside", "scale"),
    [
        pytest.param(rolling_law, True, 1 / 2, id="rolling, inside: cos 60"),
        pytest.param(rolling_law, False, -1 / 2, id="rolling, on top: the ball goes backwards"),
        pytest.param(printed_law, True, 1, id="Eq. (10)"),
        pytest.param(printed_law, False, -1, id="Eq. (10), reversed in its favour"),
    ],
)
def test_the_laws_that_are_compared(law, inside, scale):
    inverse = motion_matrix(law, Ballbot(inside, 60))
    expected = law_by_hand(scale, 0.1 * sqrt(3) / 2)
    assert inverse @ expected == pytest.approx(np.eye(3), abs=1e-12)


@pytest.mark.parametrize("side", SIDES)
def test_the_ball_obeys_the_law_of_rolling(side):
    """Within what soft contacts excuse, less than 1 %; Eq. (10) is off by 1 - cos 45."""
    found = summary(side, 45, "mixed")
    assert found["rolling_error"] < found["allowance"] < 0.01
    assert found["yaw_error"] < found["allowance"]
    assert found["printed_error"] == pytest.approx(1 - cos(pi / 4), abs=found["allowance"])
    assert found["share"] == pytest.approx(cos(pi / 4), abs=found["allowance"])
    assert found["margin"] > 10


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize(
    "factor",
    [
        pytest.param(1, id="no factor, as printed"),
        pytest.param(-cos(pi / 4), id="the wrong way"),
        pytest.param(cos(pi / 4) ** 2, id="cosine squared"),
        pytest.param(1 + cos(pi / 4), id="ball that turns the wrong way under the platform"),
        pytest.param(0.93, id="halfway between the laws for a smaller angle"),
    ],
)
def test_an_altered_law_is_refuted(side, factor):
    """By an error more than five times as large as soft contacts excuse."""
    case, recording = recorded(side, 45, "mixed")
    found = summarise(case, recording)
    mean = {name: column.mean() for name, column in recording.columns.items()}
    wheels = np.array([mean[f"wheel_{k}"] for k in (1, 2, 3)])
    scale = factor if side == "inside" else -factor
    said = np.linalg.solve(law_by_hand(scale, 0.1 * sin(pi / 4)), wheels)
    error = relative_error(np.array([mean["v_x"], mean["v_y"]]), said[:2])
    assert error > 5 * found["allowance"]


def test_the_wheels_have_the_speeds_they_were_set_to():
    """A servo that gave way would show here; the law is given what they really had."""
    _, recording = recorded("on-top", 45, "mixed")
    means = [recording.columns[f"wheel_{k}"].mean() for k in (1, 2, 3)]
    assert means == pytest.approx(INPUTS["mixed"], rel=1e-3)
    assert len(recording.time) == 101


def test_wheels_at_one_speed_turn_ball_and_platform_against_each_other():
    """On a point of contact nothing holds the ball: no angular momentum about the vertical.

    The wheels' own share of it, a few per cent, is left out.
    """
    found = summary("on-top", 45, "turning")
    assert found["yaw_rate"] - found["spin"] == pytest.approx(0.03 / 0.1 / sin(pi / 4), rel=0.005)
    assert PLATFORM_INERTIA * found["yaw_rate"] == pytest.approx(
        -BALL_INERTIA * found["spin"], rel=0.1
    )
    assert abs(found["v_x"]) + abs(found["v_y"]) < 1e-6
    assert "rolling_error" not in found


def test_on_a_floor_that_holds_the_ball_the_platform_turns_alone():
    """The same wheels, the same relative turn, another pair of turns."""
    found = summary("on-top", 45, "turning", floor_torsion=0.1)
    assert abs(found["spin"]) < 1e-3 * found["yaw_rate"]
    assert found["yaw_rate"] == pytest.approx(0.03 / 0.1 / sin(pi / 4), rel=0.005)


def test_velocities_are_those_in_the_turning_frame_of_the_platform():
    """The ball of a platform that turns goes along a circle; in its frame it goes straight."""
    _, recording = recorded("on-top", 45, "mixed")
    columns = recording.columns
    assert abs(columns["yaw_rate"].mean()) > 0.02
    assert columns["v_x"][-20:].mean() == pytest.approx(columns["v_x"][:20].mean(), rel=0.01)
    assert columns["v_y"][-20:].mean() == pytest.approx(columns["v_y"][:20].mean(), rel=0.01)


def recording_of(**columns):
    zero = {"v_x": 0.0, "v_y": 0.0, "yaw_rate": 0.0, "spin": 0.0, "sinking": 0.0}
    values = zero | columns
    return Recording(np.zeros(2), {name: np.full(2, value) for name, value in values.items()})


def test_a_summary_by_hand():
    """Wheels (0, a, -a) mean 2 a / sqrt 3 along x by Eq. (10), and twice that at 60 degrees."""
    case = case_of("inside", 60, "along-x")
    found = summarise(case, recording_of(v_x=0.1, wheel_1=0.0, wheel_2=0.03, wheel_3=-0.03))
    assert found["printed_v_x"] == pytest.approx(0.06 / sqrt(3))
    assert found["rolling_v_x"] == pytest.approx(0.12 / sqrt(3))
    assert found["share"] == pytest.approx(0.6 / sqrt(3))
    assert found["printed_error"] == pytest.approx(1 - 0.6 / sqrt(3))
    assert found["rolling_error"] == pytest.approx(1 - 1.2 / sqrt(3))
    assert found["allowance"] == 0
    assert "yaw_error" not in found


@pytest.mark.parametrize("angle_deg", [30, 45, 60])
def test_the_allowance_is_the_worst_that_soft_contacts_do(angle_deg):
    """Let wheel, surface and ball give way by 0.01 mm, lower the platform, and solve again."""
    depth, angle = 1e-5, radians(angle_deg)
    level, height = 0.08 * sin(angle), 0.08 * cos(angle) + depth
    cosine = height / np.hypot(level, height)
    spin = (0.02 - depth) / ((0.1 + depth) * cosine)
    slowest = spin * (0.1 - depth) / (0.02 / cos(angle))
    assert 1 - slowest == pytest.approx(allowance(Ballbot(True, angle_deg), depth), rel=1e-3)


def test_wheels_start_from_rest_and_reach_their_rates_smoothly():
    class Data:
        time = START
        ctrl = np.full(3, np.nan)

    rates, data, shares = np.array([1.0, -2.0, 3.0]), Data(), []
    times = np.arange(START, 0.1, 0.01)
    for data.time in times:
        drive(rates, None, data)
        shares.append(data.ctrl / rates)
    gains = np.diff(shares, axis=0)
    assert (shares[0] == 0).all()
    assert (np.array(shares)[times >= 0] == 1).all()
    assert gains.min() >= 0
    # A smooth step of 30 samples is steepest in the middle, 3/2 of its mean.
    assert gains.max() == pytest.approx(1.5 / 30, rel=0.01)


def test_wheels_that_run_away_are_reported_with_their_parameters():
    case = case_of("on-top", 45, "along-x")
    wild = replace(case, parameters={**case.parameters, "speed_2": 60})
    with pytest.raises(ImplausibleRunError, match="speed_2=60,"):
        simulate(wild)


def test_a_side_that_a_ball_has_not_is_refused():
    case = case_of("on-top", 45, "along-x")
    aside = replace(case, parameters={**case.parameters, "side": "aside"})
    with pytest.raises(ValueError, match="expected side inside or on-top, found 'aside'"):
        simulate(aside)


def test_a_case_says_all_that_its_run_depends_on():
    """Else a run that failed could not be seen again from its message."""
    parameters = case_of("on-top", 45, "mixed", facets=99).parameters
    numbers = {field.name: parameters[field.name] for field in fields(Ballbot)[1:]}
    assert robot_of(case_of("on-top", 45, "mixed", facets=99)) == Ballbot(False, **numbers)
    assert numbers["facets"] == 99


def test_the_cases_cover_both_sides_three_angles_and_all_inputs():
    cases = {case.name: case.parameters for case in MODEL.cases}
    assert len(cases) == len(MODEL.cases) == 2 * 3 * 4 + 1
    assert cases["inside-30-along-x"]["side"] == "inside"
    assert cases["on-top-45-turning-floor-torsion"]["floor_torsion"] == 0.1


def test_every_quantity_has_a_unit():
    assert set(summary("on-top", 45, "mixed")) == set(UNITS)


@pytest.mark.slow
@pytest.mark.parametrize("case", [pytest.param(case, id=case.name) for case in MODEL.cases])
def test_every_case_answers_the_question(case):
    found = summarise(case, simulate(case))
    for error in {"rolling_error", "yaw_error"} & set(found):
        assert found[error] < found["allowance"] < 0.015
    assert found.get("margin", np.inf) > 10


@pytest.mark.slow
@pytest.mark.parametrize("angle_deg", [30, 60])
def test_the_shell_converges(angle_deg):
    """Four times the facets halve their sides: the platform sits higher, the velocity settles."""
    found = [summary("inside", angle_deg, "along-y", facets=count) for count in (1000, 4000, 16000)]
    coarse, usual, fine = (each["v_y"] for each in found)
    assert abs(usual - fine) < abs(coarse - fine) / 2
    assert usual == pytest.approx(fine, rel=0.003)
    assert found[0]["sinking"] > found[1]["sinking"] > found[2]["sinking"]
    assert found[-1]["rolling_error"] < found[-1]["allowance"]


@pytest.mark.slow
@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize(
    "more",
    [
        pytest.param({"step": 0.0005}, id="half the step"),
        pytest.param({"contact_time": 0.002}, id="stiffer contacts"),
        pytest.param({"friction": 0.4}, id="half the friction"),
    ],
)
def test_nothing_else_decides(side, more):
    usual, other = (summary(side, 60, "along-y", **given) for given in ({}, more))
    assert other["v_y"] == pytest.approx(usual["v_y"], rel=0.003)
    assert other["margin"] > 10
