"""The tables of the simulated robot, from numbers made up for the purpose."""

import pandas as pd
import pytest

from omniproof.papers.omni_trajectory import setup
from omniproof.papers.omni_trajectory.simulated import (
    CASES,
    CONTROLS,
    ENGINES,
    SETUPS,
    STARTS,
    VARIATIONS,
    agreement,
    controls_in_simulation,
    engines_in_simulation,
    errors_in_simulation,
    most_sensitive,
    off_mixed_radii,
    off_printed_speed,
    printed_path_off,
    setups_in_simulation,
    worst,
)
from omniproof.simulation import omni_robot
from omniproof.simulation.omni_model import Robot

OURS = {"length_error": 0.0005, "mean_error": 0.001, "direction_error": 1e-9}
PRINTED = dict.fromkeys(CONTROLS, 0.667)
CIRCLE = {"radius_error": 2e-5, "centre_error": 0.0009}


def long(cases, model="omni-robot"):
    rows = [
        (model, case, quantity, value, "1")
        for case, found in cases.items()
        for quantity, value in found.items()
    ]
    return pd.DataFrame(rows, columns=["model", "case", "quantity", "value", "unit"])


@pytest.fixture
def summary():
    lines = {k: v for k, v in PRINTED.items() if k.split("_")[0] not in {"radius", "centre"}}
    cases = {
        f"{case}-{start}": {
            **OURS,
            **(PRINTED | CIRCLE if case.startswith("circle") else lines),
        }
        for case in CASES
        for start in STARTS
    }
    cases["line-60-standing"] |= {"length_error": 0.0042, "mean_error": 0.021}
    cases["line-30-flying"] |= {"mean_error": 0.0099, "direction_error_eq_14": 29.9}
    others = long({"circle-left-flying": {"length_error": 9.0}}, "ballbot")
    return pd.concat([others, long(cases)])


def test_errors_stand_beside_the_printed_ones(summary):
    claims = {claim: claim[-2:] for _, *both in CASES.values() for claim in both}
    rows = {row[0]: row[1:] for row in errors_in_simulation(summary, claims)}
    assert list(rows) == [words for words, *_ in CASES.values()]
    assert rows["line, 60°"] == ["60", "60", "0.00050", "0.0010", "0.0042", "0.021"]


def test_worst_of_one_start(summary):
    assert worst(summary, "mean_error", "flying") == "0.0099"
    assert worst(summary, "mean_error", "standing") == "0.021"


def test_printed_formulas_at_their_best_and_corrected_ones_at_their_worst(summary):
    rows = {row[0]: row[1:] for row in controls_in_simulation(summary)}
    assert rows["path, Eqs. (8) and (9), by Eq. (17)"] == ["0.0099", "0.67"]
    assert rows["radius, Eq. (13)"] == ["< 0.0001", "0.67"]


def printed_as(text):
    """Errors printed at every place: 0.03 in the tables, and `text` in the text."""
    return {claim: value for _, *both in CASES.values()
            for claim, value in zip(both, ("0.03", text), strict=True)}  # fmt: skip


def test_an_error_is_printed_if_it_rounds_to_the_printed_digits(summary):
    """Of the standing ones 0.021 rounds to 0.02, and 0.001 to 0.00; one of the flying is 0.0099."""
    rows = {row[0]: row[1:] for row in agreement(summary, printed_as("0.02"))}
    assert rows["standing, Eq. (17)"] == ["0.0010 to 0.021", "0 of 6", "1 of 6"]
    rows = {row[0]: row[1:] for row in agreement(summary, printed_as("0.01"))}
    assert rows["flying, Eq. (17)"] == ["0.0010 to 0.0099", "0 of 6", "1 of 6"]
    assert rows["flying, length"] == ["0.00050", "0 of 6", "0 of 6"]
    rows = {row[0]: row[1:] for row in agreement(summary, printed_as("0.001"))}
    assert rows["standing, Eq. (17)"][2] == "5 of 6"


@pytest.fixture
def setups():
    """Circles with either body, and slow lines: speeds, turns and errors that tell them apart."""
    usual = OURS | {"speed": 0.05, "turn": 86.4, "length_error_tab_2": 1.27}
    other = usual | {"turn": 108.1, "mean_error": 0.029}
    slow = usual | {"speed": 0.022, "turn": 38.1, "mean_error": 0.011, "length_error_tab_2": 0.001}
    cases = {f"{case}-{start}": usual for case in CASES for start in STARTS}
    cases["line-0-flying"] = usual | {"length_error_tab_2": 1.2, "length_error_eq_8_9": 0.65}
    for start in STARTS:
        for circle in ("circle-left", "circle-clockwise"):
            cases[f"{circle}-{start}"] = usual | {"mean_error_other_body": 0.11}
            cases[f"{circle}-{start}-body-86-mm"] = other | {"mean_error_other_body": 0.09}
        for case in CASES:
            cases[f"{case}-{start}-speed-22-mm"] = slow | {"mean_error_other_body": 0.04}
    return long(cases)


def test_set_ups_stand_beside_each_other(setups):
    """0.011 rounds to 0.01, 0.029 to 0.03."""
    first, other, slow = setups_in_simulation(setups, printed_as("0.01"))
    assert first[1:] == ["0.050", "86°", "0.0010", "0 of 6"]
    assert other[1:] == ["0.050", "108°", "0.029", "0 of 2"]
    assert slow[1:] == ["0.022", "38°", "0.011", "6 of 6"]
    assert setups_in_simulation(setups, printed_as("0.03"))[1][-1] == "2 of 2"


def test_what_the_tables_can_rule_out(setups):
    """The slow robot has the speed of Table 2; a slow one beside another radius does not count."""
    assert off_printed_speed(setups) == "1.2"
    assert off_mixed_radii(setups) == "0.090"


def test_the_least_error_of_the_printed_path():
    cases = {f"{case}-flying": {"length_error_eq_8_9": 0.67} for case in CASES}
    cases["line-0-flying"] = {"length_error_eq_8_9": 0.65}
    assert printed_path_off(long(cases)) == "0.65"


def test_the_change_that_matters_most():
    cases = {f"circle-clockwise-flying{name}": OURS for name in VARIATIONS}
    cases["circle-clockwise-flying-heavy"] = OURS | {"mean_error": 0.0049}
    found = most_sensitive(long(cases), "mean_error", "flying")
    assert found == (VARIATIONS["-heavy"], "0.0049")


def test_engines_stand_beside_each_other_and_may_be_missing():
    circle = OURS | {"radius": 0.09916, "turn": 86.44}
    cases = {f"circle-left-{start}": circle for start in STARTS}
    rows = engines_in_simulation(long(cases | {"circle-left-flying-drake": circle}))
    assert rows[0] == ["MuJoCo, flying", "99.2", "86.4", "0.00050", "0.0010"]
    assert rows[1] == ["Drake, flying", *rows[0][1:]]
    assert rows[3] == ["Drake, standing", "—", "—", "—", "—"]
    assert {len(row) for row in rows} == {len(ENGINES)}


def test_words_belong_to_the_cases_that_are_run():
    assert [f"-{name}" for name in omni_robot.VARIATIONS] == list(VARIATIONS)[1:]
    assert list(SETUPS) == ["", f"-{omni_robot.OTHER_BODY}", f"-{omni_robot.AT_TABLE_SPEED}"]


def test_the_robot_has_the_printed_set_up():
    robot = Robot()
    assert robot.wheel.rollers == setup.PASSIVE_ROLLERS
    assert robot.wheel.radius == float(setup.ROLLER_RADIUS)
    assert robot.body_radius == float(setup.RADII["Table 1"])


def test_numbers_without_the_robot_are_an_error():
    with pytest.raises(KeyError, match="no simulation of the robot"):
        worst(long({"x": {"margin": 1.0}}, "sphere"), "mean_error", "flying")
