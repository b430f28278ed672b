"""What the chapter on simulation says in words, held against the numbers that were simulated.

Numbers in its text are computed; sentences are not. Each sentence that rests on how the runs came
out has a test here, which fails when it is no longer so.
"""

from __future__ import annotations

import json

import pandas as pd
import pytest
from built_report import ROOT, is_fresh

from omniproof.papers.omni_trajectory import simulated as robot
from omniproof.papers.one_mechanics import simulated as sphere


@pytest.fixture(scope="module")
def summary() -> pd.DataFrame:
    if not is_fresh():
        pytest.skip("the report is missing or older than its sources: run `make`")
    return pd.read_csv(ROOT / "results/simulation/summary.csv")


@pytest.fixture(scope="module")
def printed() -> dict[str, str]:
    ledger = json.loads((ROOT / "results/ledger/omni-trajectory.json").read_text())
    return {row["id"]: row["printed"] for row in ledger["rows"]}


def numbers(summary: pd.DataFrame, model: str) -> pd.DataFrame:
    own = summary[summary["model"] == model]
    return own.pivot(index="case", columns="quantity", values="value")


def count(cell: str) -> int:
    """The first number of `5 of 6`."""
    return int(cell.split(maxsplit=1)[0])


def test_printed_errors_are_too_large_for_lengths(summary, printed) -> None:
    rows = {row[0]: row for row in robot.agreement(summary, printed)}
    for start in robot.STARTS:
        assert rows[f"{start}, length"][2:] == ["0 of 6", "0 of 6"]
        assert float(robot.worst(summary, "length_error", start)) < 0.01


def test_errors_of_the_text_are_like_those_of_a_standing_start(summary, printed) -> None:
    *others, standing = robot.agreement(summary, printed)
    assert standing[0] == "standing, Eq. (17)"
    assert count(standing[3]) > 3 > max(count(cell) for row in others for cell in row[2:])


def test_a_slow_robot_has_fewer_errors_of_the_text(summary, printed) -> None:
    usual, _, slow = robot.setups_in_simulation(summary, printed)
    assert count(slow[-1]) < count(usual[-1])


def test_errors_are_alike_for_both_bodies(summary) -> None:
    errors = numbers(summary, "omni-robot")["mean_error"]
    for case in ("circle-left-standing", "circle-clockwise-standing"):
        assert errors[f"{case}-body-86-mm"] == pytest.approx(errors[case], rel=0.05)


def test_mixed_radii_and_mixed_speeds_are_beyond_what_is_printed(summary, printed) -> None:
    claims = [claim for _, *both in robot.CASES.values() for claim in both]
    most = max(float(printed[claim]) for claim in claims)
    assert float(robot.off_mixed_radii(summary)) > 2 * most
    assert float(robot.off_printed_speed(summary)) > 2 * most


@pytest.mark.parametrize(
    ("start", "change"),
    [
        pytest.param("flying", "-two-rows", id="rollers in two rows"),
        pytest.param("standing", "-slippery", id="friction limits how fast it gathers speed"),
    ],
)
def test_the_change_that_is_explained_is_the_greatest(summary, start, change) -> None:
    assert robot.most_sensitive(summary, "mean_error", start)[0] == robot.VARIATIONS[change]


def test_soft_contacts_excuse_what_is_left_of_the_law_of_rolling(summary) -> None:
    found = numbers(summary, "ballbot").dropna(subset="rolling_error")
    assert (found["rolling_error"] < found["allowance"]).all()


def test_dry_circles_have_one_radius_and_one_roller_sticks(summary) -> None:
    least, *most = map(float, sphere.dry_circles(summary).split(" to "))
    assert all(value == pytest.approx(least, rel=0.005) for value in most)
    assert sphere.sticking(summary) == "1"


def test_the_distance_falls_in_proportion_to_the_creep(summary) -> None:
    least, most = map(float, sphere.over_creep(summary).split(" to "))
    assert most < 1.25 * least


def test_two_lines_stop_the_sphere_half_way_or_at_the_second(summary) -> None:
    assert sphere.share_between(summary, "") == "0.500"
    assert float(sphere.share_between(summary, "-from-far").split()[0]) > 0.99


def test_on_the_equator_all_ends_are_steady_and_slip_alike(summary) -> None:
    found = numbers(summary, "sphere").filter(like="equator", axis="index")
    assert len(found) == len(sphere.ON_EQUATOR)
    assert found["error_dry"].max() < 0.002
    assert found["sum_of_slips"].to_numpy() == pytest.approx(1.7, abs=0.001)
    off_middle = found["error_least_squares"]
    assert off_middle.idxmin() == "three-equator-viscous"


def test_both_engines_draw_one_circle(summary) -> None:
    found = numbers(summary, "omni-robot")
    for start in robot.STARTS:
        other = f"circle-left-{start}-drake"
        if other not in found.index:
            pytest.skip("Drake is not installed here")
        for name in ("radius", "turn"):
            assert found[name][other] == pytest.approx(
                found[name][f"circle-left-{start}"], rel=0.01
            )
