"""omni-trajectory: figures, answers and theorems against plain arithmetic, by hand and by NumPy."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pandas as pd
import pytest
from recorded import frame_of, recording
from sympy import Rational

from omniproof.audit.relations import judge
from omniproof.papers.omni_trajectory import answers
from omniproof.papers.omni_trajectory.figures import FIGURES
from omniproof.papers.omni_trajectory.setup import CIRCLES, LINES, RADII
from omniproof.papers.omni_trajectory.theorems import THEOREMS
from omniproof.registry import Theorem
from omniproof.report.figure import points

CASES = {case.name: case for case in (*CIRCLES, *LINES)}
SOLID, DASHED = RADII
EVERY_PATH = [
    pytest.param(name, place, id=f"{name}, L of {place}") for name in CASES for place in RADII
]


@pytest.fixture(scope="module")
def frames() -> dict[int, pd.DataFrame]:
    return {number: frame_of(FIGURES[number]) for number in (1, 2, 3, 4, 5)}


def twist(name: str, place: str) -> Any:
    """Twist of a case by NumPy's inverse of the wheel matrix, from rpm."""
    angles = np.radians([30, 150, 270])
    matrix = np.column_stack([-np.sin(angles), np.cos(angles), np.full(3, float(RADII[place]))])
    rates = np.array([float(rate) for rate in CASES[name].rates_rpm])
    return np.linalg.inv(matrix) @ (0.023 * rates * 2 * math.pi / 60)


def driven(name: str, place: str, steps: int = 3000) -> Any:
    """Place after 3 s by the midpoint rule."""
    v_x, v_y, rate = twist(name, place)
    times = (np.arange(steps) + 0.5) * 3 / steps
    c, s = np.cos(rate * times), np.sin(rate * times)
    return np.array([np.sum(c * v_x - s * v_y), np.sum(s * v_x + c * v_y)]) * 3 / steps


# Figures


@pytest.mark.parametrize(("name", "place"), EVERY_PATH)
def test_paths_end_where_numeric_integration_does(
    name: str, place: str, frames: dict[int, pd.DataFrame]
) -> None:
    circle = CASES[name] in CIRCLES
    panel, series = ("path", f"{name}, L of {place}") if circle else (name, f"path, L of {place}")
    path = points(frames[3 if circle else 5], panel, series)
    assert len(path) == 61
    assert path[0] == pytest.approx([0, 0])
    assert path[-1] == pytest.approx(driven(name, place), abs=1e-7)


def test_both_circles_start_at_60_degrees(frames: dict[int, pd.DataFrame]) -> None:
    for case in CIRCLES:
        first, second = points(frames[3], "path", f"{case.name}, L of {SOLID}")[:2]
        start = math.degrees(math.atan2(*(second - first)[::-1]))
        assert start == pytest.approx(60, abs=1)


@pytest.mark.parametrize(
    ("name", "place", "millimetres"),
    [
        pytest.param("0°", SOLID, 0.5845, id="0 degrees, to the left"),
        pytest.param("0°", DASHED, 0.6273, id="0 degrees, smaller body"),
        pytest.param("30°", SOLID, 0, id="30 degrees, straight"),
        pytest.param("60°", SOLID, -0.5845, id="60 degrees, to the right"),
        pytest.param("90°", DASHED, 0, id="90 degrees, straight"),
    ],
)
def test_figure_5_shows_how_far_lines_are_bent(
    name: str, place: str, millimetres: float, frames: dict[int, pd.DataFrame]
) -> None:
    """By hand: V sin(0.159 degrees) t + V w t^2 / 2 = 0.417 mm + 0.167 or 0.210 mm."""
    time, aside = points(frames[5], "across", f"{name}, L of {place}")[-1]
    assert time == 3
    assert aside == pytest.approx(millimetres, abs=5e-4)


def test_simulated_marks_are_the_recording_and_their_distance_is_in_mm(
    frames: dict[int, pd.DataFrame],
) -> None:
    """The made-up robot goes 150 mm along x; the theory's ends are known from NumPy."""
    for name, place in [param.values for param in EVERY_PATH]:
        if CASES[name] in CIRCLES:
            found = points(frames[3], "path", f"simulated {name}, L of {place}")
            apart = points(frames[3], "distance", f"{name}, L of {place}, standing")
        else:
            found = points(frames[5], name, "simulated")
            apart = points(frames[5], "distance", f"{name}, standing")
        assert found == pytest.approx(np.column_stack([np.linspace(0, 0.15, 61), np.zeros(61)]))
        if CASES[name] in CIRCLES or place == SOLID:
            missed = 1000 * math.dist((0.15, 0), driven(name, place))
            assert apart[-1] == pytest.approx([3, missed], abs=1e-3)


def test_figure_5_shows_the_simulation_beside_the_line_too(
    frames: dict[int, pd.DataFrame],
) -> None:
    """A robot that goes along x leaves the line at 30 degrees to the right: sin 30 x 150 mm."""
    assert points(frames[5], "across", "30°, simulated")[-1] == pytest.approx([3, -75])


@pytest.mark.parametrize(
    "shorter",
    [
        pytest.param(recording().iloc[:151], id="half of the time"),
        pytest.param(recording().iloc[::10], id="too few rows"),
    ],
)
def test_a_recording_of_other_times_is_an_error(shorter: pd.DataFrame) -> None:
    with pytest.raises(ValueError, match=r"expected a recording of 3 s"):
        FIGURES[5].data(*[shorter] * len(FIGURES[5].needs))


def test_figure_1_has_one_velocity_in_two_frames(frames: dict[int, pd.DataFrame]) -> None:
    velocity = points(frames[1], "robot", "V")[1]
    for name in "mW":
        parts = [points(frames[1], "robot", f"V_{axis}_{name}")[1] for axis in "XY"]
        assert sum(parts) == pytest.approx(velocity)
        assert parts[0] @ parts[1] == pytest.approx(0)


def test_figure_1_wheel_speeds_are_those_of_the_contacts(frames: dict[int, pd.DataFrame]) -> None:
    """Along the rim the contact moves with n . V + w, w being common to all."""
    velocity = points(frames[1], "robot", "V")[1]
    rates = []
    for k in (1, 2, 3):
        contact, tip = points(frames[1], "robot", f"v {k}")
        tangent = np.array([-contact[1], contact[0]])
        assert (tip - contact) @ contact == pytest.approx(0)
        rates.append((tip - contact) @ tangent - tangent @ velocity)
    assert rates == pytest.approx([rates[0]] * 3)


def test_figure_2_centre_is_across_the_velocity(frames: dict[int, pd.DataFrame]) -> None:
    """a = c = 5/6, b = -2/3, L = 1/2: V = 1 m/s at 60 degrees, w = 2/3 rad/s, so R = 3/2 m."""
    centre = points(frames[2], "orbit", "O")[0]
    assert centre == pytest.approx([-1.5 * math.sin(math.pi / 3), 1.5 * math.cos(math.pi / 3)])
    distances = np.linalg.norm(points(frames[2], "orbit", "path") - centre, axis=1)
    assert distances == pytest.approx(1.5)


def test_figure_2_robot_turns_as_the_radius_does(frames: dict[int, pd.DataFrame]) -> None:
    centre = points(frames[2], "orbit", "O")[0]
    turns = []
    for series in ("V", "X_m"):
        (s0, e0), (s1, e1) = (
            points(frames[2], "orbit", f"{series} at {t} s") for t in ("0", "3.3")
        )
        turns.append(angle_between(e0 - s0, e1 - s1))
    start, end = points(frames[2], "orbit", "path")[[0, -1]]
    turns.append(angle_between(start - centre, end - centre))
    assert turns == pytest.approx([2.2] * 3)


def angle_between(first: Any, second: Any) -> float:
    cross = first[0] * second[1] - first[1] * second[0]
    return math.atan2(cross, first @ second) % (2 * math.pi)


def test_figure_4_is_built_from_the_parameters(frames: dict[int, pd.DataFrame]) -> None:
    data = frames[4]
    for k, angle in enumerate((30, 150, 270), 1):
        contact = points(data, "robot", f"P {k}")[0]
        expected = 0.108 * np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])
        assert contact[:2] == pytest.approx(expected)
        rollers = data["series"].str.startswith(f"wheel {k} roller")
        assert rollers.sum() == 2 * 18


def test_figure_4_rollers_reach_the_rim_and_the_floor(frames: dict[int, pd.DataFrame]) -> None:
    along, thick = points(frames[4], "roller", "profile").T
    hub = points(frames[4], "robot", "hub 1")[0]
    ends = points(frames[4], "robot", "wheel 1 roller 1")
    middle, axis = ends.mean(axis=0), (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    out = (middle - hub) / np.linalg.norm(middle - hub)
    rim = middle + np.outer(along, axis) + np.outer(thick, out)
    assert np.linalg.norm(rim - hub, axis=1) == pytest.approx(0.023)
    assert rim[:, 2].min() == pytest.approx(0, abs=1e-12)
    assert np.linalg.norm(ends[1] - ends[0]) < 2 * 0.023 * math.sin(math.pi / 18)  # none overlap


# Answers


def interval(text: str) -> list[float]:
    """Read `0.1 ≤ V < 0.2`."""
    low, *_, high = text.strip("$").replace("≤", "<").split("<")
    return [float(low), float(high)]


def rpm(speed: float) -> float:
    return speed / 0.023 * 60 / (2 * math.pi)


@pytest.mark.parametrize(
    ("cells", "column", "expected"),
    [
        pytest.param("Table 4", 3, (20.75 / rpm(1), 18 / rpm(math.sqrt(3) / 2)),
                     id="Table 4: N = 20.8 from below, 17.9 cut off from above"),
        pytest.param("30°", 1, (17.85 / rpm(math.sqrt(3) / 2),
                                        17.95 / rpm(math.sqrt(3) / 2)), id="30 degrees, rounded"),
        pytest.param("90°", 2, (17.9 / rpm(math.sqrt(3) / 2),
                                        18 / rpm(math.sqrt(3) / 2)), id="90 degrees, cut off"),
        pytest.param("both", 3, (20.75 / rpm(1), (33 - 1.835) / rpm(1.5)),
                     id="both: N_1 - N_2 = 3/2 V of the left circle from above"),
    ],
)  # fmt: skip
def test_speeds_by_hand(cells: str, column: int, expected: Any) -> None:
    found = {row[0]: row for row in answers.speeds_by_reading()}[cells][column]
    assert interval(found) == pytest.approx(expected, rel=2e-5)


@pytest.mark.parametrize("column", [1, 2], ids=["all rounded", "all cut off"])
def test_no_single_reading_gives_table_4(column: int) -> None:
    found = {row[0]: row[column] for row in answers.speeds_by_reading()}
    assert found["Table 4"].startswith("none")
    assert found["both"].startswith("none")


def test_yaw_rates_of_both_radii_are_one_rim_speed() -> None:
    rates = [interval(row[1]) for row in answers.yaw_rates_by_radius()]
    rims = [[radius * rate for rate in pair]
            for radius, pair in zip((0.108, 0.086), rates, strict=True)]  # fmt: skip
    assert rims[0] == pytest.approx(rims[1], rel=1e-5)


def test_at_the_round_speed_each_cell_reads_as_the_others_allow() -> None:
    for row in answers.cells_by_reading():
        case, wheel, printed, exact, digits = (text.replace("\N{MINUS SIGN}", "-") for text in row)
        if exact == "—":
            continue
        value, places = float(exact), len(printed.partition(".")[2])
        rounded = f"{value:.{places}f}" == printed or value == 0
        cut = math.trunc(value * 10**places) / 10**places == float(printed)
        assert {"either": rounded and cut, "rounded only": rounded and not cut,
                "cut off only": cut and not rounded}[digits], (case, wheel)  # fmt: skip


def test_closed_forms_and_quadrature_show_the_same_digits() -> None:
    rows = answers.changing_speeds()
    solved = [row for row in rows if row[1] != "none known"]
    assert len(solved) == 6
    assert all(closed == enclosed for _, closed, enclosed, _ in solved)


def test_paths_in_the_chapter_are_those_of_the_figures(frames: dict[int, pd.DataFrame]) -> None:
    rows = [row for row in answers.paths_of_printed_rates() if row[0] == "left"]
    for (_, _, _, turn, radius, *_), place in zip(rows, RADII, strict=True):
        v_x, v_y, rate = twist("left", place)
        assert float(turn) == pytest.approx(math.degrees(3 * rate), rel=1e-3)
        assert float(radius) == pytest.approx(math.hypot(v_x, v_y) / rate, rel=1e-3)


# Theorems


@pytest.mark.parametrize("theorem", THEOREMS, ids=[theorem.id for theorem in THEOREMS])
def test_each_step_needs_what_it_says(theorem: Theorem) -> None:
    """Each step has obligations, and with its values altered it is not proved any more."""
    for step in theorem.steps:
        obligations = step.obligations()
        assert obligations
        wrong = [altered(obligation) for obligation in obligations]
        assert any(type(judge(item)).__name__ != "Proved" for item in wrong if item)


def altered(obligation: Any) -> Any:
    """The same question with the first value enlarged by one half, or the sign turned."""
    subject = obligation.subject
    if isinstance(subject, tuple):
        return replace(obligation, subject=(subject[0] + Rational(1, 2), *subject[1:]))
    return replace(obligation, subject=replace(subject, expression=-subject.expression))


def test_radius_that_the_printed_speed_would_need() -> None:
    """20.76 rpm are 2.174 rad/s: 0.022 m/s over that."""
    radius = float(answers.roller_radius_for("0.022"))
    assert radius == pytest.approx(0.022 / (20.7593 * 2 * math.pi / 60), rel=1e-3)
    assert answers.roller_radius_for("0.05") == "0.02300"
