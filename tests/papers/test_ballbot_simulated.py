"""The tables of the simulated ball, from numbers made up for the purpose."""

import pandas as pd
import pytest

from omniproof.papers.ballbot.simulated import (
    ANGLES_DEG,
    LAWS,
    SIDES,
    TURNING,
    TURNS,
    deepest,
    fastest_turning,
    laws_in_simulation,
    least_margin,
    turns_in_simulation,
    worst_share,
)

MOVING = {
    "share": 0.9,
    "sinking": 7.6e-5,
    "rolling_error": 0.001,
    "printed_error": 0.1,
    "margin": 100.0,
}
MOVING_MORE = {
    "share": 0.91,
    "sinking": 1.21e-4,
    "rolling_error": 0.0025,
    "printed_error": 0.09,
    "margin": 36.0,
}
TURNED = {"yaw_rate": 0.1, "spin": -0.3, "law_yaw_rate": 0.401}


def long(cases, model="ballbot"):
    rows = [
        (model, case, quantity, value, "1")
        for case, found in cases.items()
        for quantity, value in found.items()
    ]
    return pd.DataFrame(rows, columns=["model", "case", "quantity", "value", "unit"])


@pytest.fixture
def summary():
    places = [f"{side}-{angle}" for side in SIDES for angle in ANGLES_DEG]
    moving = {f"{place}-along-x": MOVING for place in places}
    more = {"on-top-30-mixed": MOVING_MORE}
    held = {"on-top-45-turning-floor-torsion": TURNED | {"yaw_rate": 0.4, "spin": -1e-9}}
    turning = dict.fromkeys(TURNS, TURNED) | held
    others = long({"inside-30-along-x": {"margin": 1.0, "share": 0.0}}, "omni-robot")
    return pd.concat([others, long(moving | more | turning)])


def test_worst_numbers_of_each_set_up(summary):
    """The greatest error of rolling, the least of the printed law; other models do not count."""
    rows = laws_in_simulation(summary)
    assert len(rows) == 6
    assert rows[0] == ["inside the ball", "30°", "0.900", "0.866", "0.10%", "10.0%", "100"]
    assert rows[3] == ["on top of it", "30°", "0.900 to 0.910", "0.866", "0.25%", "9.0%", "36"]
    assert least_margin(summary) == "36"
    assert deepest(summary) == "0.12 mm"


def test_the_share_that_is_farthest_from_the_cosine():
    """cos 30 = 0.8660, cos 60 = 0.5: 0.004 is more than 0.002; a case that only turns has none."""
    shares = {"inside-30-along-x": 0.8640, "on-top-60-mixed": 0.504}
    cases = {case: {"share": share} for case, share in shares.items()}
    assert worst_share(long(cases | {"inside-60-turning": {"spin": 1.0}})) == "0.0040"


def test_how_fast_the_ball_moves_while_wheels_turn_alike():
    """3 and 4 make 5; what is meant to move does not count."""
    still, moving = {"v_x": 3e-5, "v_y": -4e-5}, {"v_x": 0.05, "v_y": 0.0}
    cases = {"inside-30-turning": still, "on-top-45-turning-floor-torsion": {"v_x": 0, "v_y": 0}}
    assert fastest_turning(long(cases | {"inside-30-mixed": moving})) == "0.05 mm/s"


def test_which_body_turns(summary):
    point, _, held = turns_in_simulation(summary)
    assert point == ["inside, point of contact", "0.100", "\N{MINUS SIGN}0.300", "0.400", "0.401"]
    assert held[1:] == ["0.400", "0.000", "0.400", "0.401"]


def test_heads_fit_their_tables(summary):
    assert {len(row) for row in laws_in_simulation(summary)} == {len(LAWS)}
    assert {len(row) for row in turns_in_simulation(summary)} == {len(TURNING)}


def test_numbers_without_the_ballbot_are_an_error():
    with pytest.raises(KeyError, match="no simulation of the ballbot"):
        least_margin(long({"line": {"margin": 1.0}}, "omni-robot"))
