"""The tables of the simulated robot, from numbers made up for the purpose."""

import pandas as pd
import pytest

from omniproof.papers.omni_trajectory.simulated import (
    CASES,
    CONTROLS,
    STARTS,
    controls_in_simulation,
    errors_in_simulation,
    worst,
)

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


def test_numbers_without_the_robot_are_an_error():
    with pytest.raises(KeyError, match="no simulation of the robot"):
        worst(long({"x": {"margin": 1.0}}, "sphere"), "mean_error", "flying")
