"""The tables of the simulated sphere: rows, order and words, from numbers made up for the purpose.

That the real runs agree with theory is tested where they are made.
"""

from __future__ import annotations

from typing import Any

import pandas as pd
import pytest

from omniproof.papers.one_mechanics import simulated
from omniproof.simulation.sphere import MODEL

NUMBERS = {
    "error_least_squares": 0.2,
    "error_dry": 0.001,
    "circle_radius": 0.75,
    "sum_of_slips": 0.5,
    "share": 0.25,
    "slip_1": 0.125,
    "slip_2": 0.125,
    "slip_3": 0.125,
    "grip_1": 1.0,
    "grip_2": 0.3,
    "grip_3": 1.0,
}


def long(changes: dict[tuple[str, str], float], model: str = "sphere") -> pd.DataFrame:
    """Numbers of all cases, alike but for some changes by case and quantity."""
    rows = [
        (model, case.name, quantity, changes.get((case.name, quantity), value), "1")
        for case in MODEL.cases
        for quantity, value in NUMBERS.items()
    ]
    return pd.DataFrame(rows, columns=["model", "case", "quantity", "value", "unit"])


def test_three_rollers_beside_theory() -> None:
    """At 30 degrees 1/(1 + 1/4) and sqrt(3)/2; friction that holds is the least one."""
    rows = simulated.three_rollers(long({("three-30-17-viscous", "error_least_squares"): 3.1e-5}))
    assert [row[0] for row in rows] == [f"{e}°, {p}°" for e in (10, 20, 30) for p in (17, 55)]
    cells = [r"$3\cdot10^{-5}$", "0.750", "0.800", "0.00100", "0.200", "0.750", "0.300", "0.866"]
    assert rows[4][1:] == cells
    assert all(len(row) == len(simulated.RAISED) for row in rows)


def test_two_rollers_beside_theory() -> None:
    """Slips cos(24.18°) tan(alpha) by hand; no share where the lines meet."""
    rows = simulated.two_rollers(long({("two-10-dry-from-far", "share"): 0.997}))
    assert [row[3] for row in rows] == ["0.000", "0.161", "0.332", "0.527"]
    assert [row[4:6] for row in rows[:2]] == [["", ""], ["0.250", "0.997"]]
    assert all(len(row) == len(simulated.PAIR) for row in rows)


def test_the_ladder_of_creeps() -> None:
    rows = simulated.creeps(long({("three-30-17-creep-100-mm", "error_dry"): 0.08}))
    assert [row[0] for row in rows] == ["1000", "300", "100", "30", "10", "3", *["1"] * 3]
    assert [row[1] for row in rows[-3:]] == ["1", "0.5", "0.25"]
    assert rows[2] == ["100", "1", "0.200", "0.080", "0.800"]
    assert all(len(row) == len(simulated.LADDER) for row in rows)


def test_the_least_margin_is_that_of_three_dry_rollers() -> None:
    changes: Any = {
        ("three-10-55-dry", "error_dry"): 0.005,
        ("three-10-55-viscous", "error_dry"): 0.1,
        ("three-30-17-dry-step-500-us", "error_dry"): 0.1,
        ("two-10-dry", "error_dry"): 0.1,
    }
    assert simulated.margin(long(changes)) == "40"


def test_the_heavier_roller() -> None:
    found = simulated.heavier(long({("two-30-dry-heavier", "slip_2"): 1.05}))
    assert found == {"slip_1": "0.125", "slip_2": "1.050", "grip_1": "1.000"}


def test_the_radii_of_dry_circles() -> None:
    assert simulated.dry_circles(long({})) == "0.750"
    changes: Any = {
        ("three-20-17-dry", "circle_radius"): 0.9,
        ("three-20-17-viscous", "circle_radius"): 2.0,
    }
    assert simulated.dry_circles(long(changes)) == "0.750 to 0.900"


def test_a_roller_sticks_if_friction_holds_it_and_it_creeps_only() -> None:
    """Roller 2 has grip 0.3; its slip decides."""
    crept: Any = {(case.name, "slip_2"): 0.0009 for case in MODEL.cases}
    assert simulated.sticking(long({})) == "0"
    assert simulated.sticking(long(crept)) == "1"
    both: Any = {("three-30-55-dry", f"{name}_1"): 0.0009 for name in ("slip", "grip")}
    assert simulated.sticking(long(crept | both)) == "1 or 2"


def test_the_share_between_the_lines() -> None:
    """Lines that meet, at 0 degrees, have none between them."""
    changes: Any = {("two-0-dry", "share"): 0.9, ("two-20-dry", "share"): 0.5}
    assert simulated.share_between(long(changes), "") == "0.250 to 0.500"
    assert simulated.share_between(long(changes), "-from-far") == "0.250"


def test_what_creep_and_step_do() -> None:
    """1 mm/s: 0.001 over 0.001; 100 mm/s: 0.08 over 0.1. Creeps above 0.1 m/s do not count."""
    creeps: Any = {
        (case, "error_dry"): 0.0009 * creep for case, (creep, _) in simulated.CREEPS.items()
    }
    creeps |= {("three-30-17-creep-100-mm", "error_dry"): 0.08}
    assert simulated.over_creep(long(creeps)) == "0.80 to 0.90"
    assert simulated.change_by_step(long({})) == "less than 0.000001"
    changes: Any = {("three-30-17-dry-step-250-us", "error_dry"): 0.003}
    assert simulated.change_by_step(long(changes)) == "0.002000"


def test_rollers_on_the_equator() -> None:
    rows = simulated.equator(long({("three-equator-dry-from-far-60", "slip_2"): 1.5}))
    assert [row[0] for row in rows] == list(simulated.ON_EQUATOR.values())
    assert rows[4][1:] == ["0.200", "0.00100", "0.500", "0.125, 1.500, 0.125"]
    assert {len(row) for row in rows} == {len(simulated.EQUATOR)}
    run = {case.name for case in MODEL.cases if "equator" in case.name}
    assert run == {f"three-equator-{case}" for case in simulated.ON_EQUATOR}


def test_numbers_without_the_sphere_are_an_error() -> None:
    with pytest.raises(KeyError, match="no simulation of the sphere"):
        simulated.margin(long({}, "ballbot"))
