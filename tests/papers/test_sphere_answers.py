"""Tables and theorems on spheres: exact values against plain least squares."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np
import pytest
import sphere_oracle as oracle

from omniproof.audit.relations import judge
from omniproof.audit.theorems import prove_all
from omniproof.decide.answer import Proved
from omniproof.papers.three_roller_sphere.answers import (
    elevations_of_printed,
    patterns,
    places,
    shift_that_serves_all,
)
from omniproof.papers.two_roller_sphere.answers import (
    angles_of_printed,
    cases,
    failing_directions,
    near_the_singular_angle,
)
from omniproof.papers.two_roller_sphere.theorems import THEOREMS

NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


def numbers(text: str) -> list[float]:
    return [float(number) for number in NUMBER.findall(text)]


@pytest.mark.parametrize("k", range(4))
def test_cases_have_the_extrema_of_least_squares(k: int) -> None:
    directions = np.arange(0, 180, 1.0)
    found = [oracle.travel(10 * k, direction) for direction in directions]
    speeds = np.array([abs(speeds[0]) for speeds, _, _ in found])
    spins = [float(np.linalg.norm(spin)) for _, spin, _ in found]
    slips = [abs(slips[0]) for _, _, slips in found]
    _, lean, spin, speed, slip = cases()[k]
    assert numbers(lean)[0] == pytest.approx(np.degrees(np.arccos(1 / max(spins))), abs=0.005)
    assert numbers(spin)[0] == pytest.approx(max(spins), abs=5e-4)
    fastest, direction = numbers(speed)
    assert fastest == pytest.approx(speeds.max(), abs=8e-4)
    assert direction == pytest.approx(directions[speeds.argmax()], abs=0.55)
    assert numbers(slip)[0] == pytest.approx(max(slips), abs=5e-5)


@pytest.mark.parametrize(
    ("name", "printed"),
    [
        pytest.param("nu", {0: "0.91", 1: "0.93", 2: "0.96", 3: "1.03"}, id="rim speeds"),
        pytest.param("S", {1: "0.16", 2: "0.32", 3: "0.52"}, id="slips"),
    ],
)
def test_angles_give_the_printed_decimals(name: str, printed: Mapping[int, str]) -> None:
    for (angle, decimal, exact, found), k in zip(
        angles_of_printed(name, printed), printed, strict=True
    ):
        assert (angle, decimal) == (f"{10 * k}°", printed[k])
        assert float(exact) == pytest.approx(_ahead(name, 10 * k), abs=5e-5)
        low, high = numbers(found)
        assert f"{_ahead(name, (low + high) / 2):.2f}" == decimal
        assert _ahead(name, high + 0.02) > float(decimal) + 0.005
        assert low == 0 or _ahead(name, low - 0.02) < float(decimal) - 0.005


def _ahead(name: str, angle_deg: float) -> float:
    speeds, _, slips = oracle.travel(angle_deg, 90)
    return float(abs(speeds[0] if name == "nu" else slips[0]))


@pytest.mark.parametrize("link", range(3))
@pytest.mark.parametrize("roller", [1, 2])
def test_a_link_fails_between_the_given_directions_only(link: int, roller: int) -> None:
    low, high, *opposite = numbers(failing_directions()[link][roller])
    assert opposite == pytest.approx([low + 180, high + 180])

    def holds(direction: float) -> bool:
        sizes = [abs(oracle.travel(10 * k, direction)[0][roller - 1]) for k in (link, link + 1)]
        return bool(sizes[0] < sizes[1])

    inside = np.linspace(low + 0.02, high - 0.02, 25)
    outside = np.linspace(high + 0.02, low + 180 - 0.02, 45)
    assert not any(holds(direction) for direction in inside)
    assert all(holds(direction) for direction in outside)


def test_travel_across_ends_at_the_singular_angle() -> None:
    *near, (end, *_) = near_the_singular_angle()
    for angle, lean, spin, speed in near:
        speeds, turning, _ = oracle.travel(numbers(angle)[0], 0)
        assert numbers(spin)[0] == pytest.approx(abs(turning[2]), abs=0.006)
        assert numbers(speed)[0] == pytest.approx(abs(speeds[0]), abs=0.006)
        assert numbers(lean)[0] == pytest.approx(np.degrees(np.arctan(abs(turning[2]))), abs=0.006)
    turning = oracle.opposite(numbers(end)[0])
    assert np.hypot(turning[0], turning[1]) < 2e-4 * abs(turning[2])


@pytest.mark.parametrize(
    ("paper", "expected"),
    [
        ("two-roller-sphere", {"thm:symmetric-pair", "thm:leaning-plane", "thm:sine-of-slip",
                               "thm:sideways"}),
        ("three-roller-sphere", {"thm:pivots-of-elimination", "thm:level-axes"}),
    ],
)  # fmt: skip
def test_theorems_are_proved(paper: str, expected: set[str]) -> None:
    assert {record["id"] for record in prove_all([paper])} == expected


def test_every_step_of_the_motion_rests_on_rolling(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a roller that turns the other way, no closed form is proved any more."""
    from omniproof.kinematics import sphere

    right = sphere.driven_direction
    monkeypatch.setattr(sphere, "driven_direction", lambda p, eta: -right(p, eta))
    steps = {theorem.id: theorem.steps for theorem in THEOREMS}["thm:symmetric-pair"]
    answers = [judge(obligation) for obligation in steps[0].obligations()]
    assert not all(isinstance(answer, Proved) for answer in answers)


@pytest.mark.parametrize("elevation_deg", [0, 10, 20, 30, 60])
def test_slips_of_a_pattern_add_up_to_one_number(elevation_deg: int) -> None:
    """The statement of thm:level-axes: 3 sin^2 / (2 (1 + sin^2)), and no vertical spin."""
    raised = np.sin(np.radians(elevation_deg)) ** 2
    for parameter in range(0, 360, 15):
        spin, slips = oracle.pattern(elevation_deg, parameter)
        assert sum(s @ s for s in slips) == pytest.approx(1.5 * raised / (1 + raised), abs=1e-12)
        assert spin[2] == pytest.approx(0, abs=1e-12)


# Three rollers

TURN = range(0, 360, 6)


def _slips(elevation_deg: float, roller: int) -> list[float]:
    return [
        float(np.linalg.norm(oracle.pattern(elevation_deg, parameter)[1][roller - 1]))
        for parameter in TURN
    ]


@pytest.mark.parametrize("k", range(1, 5))
def test_patterns_have_the_extrema_of_least_squares(k: int) -> None:
    elevation = 10 * (k - 1)
    name, radius, least, greatest = patterns()[k - 1]
    assert name.endswith(f"({elevation}°)")
    spin, _ = oracle.pattern(elevation, 25)
    assert float(radius) == pytest.approx(np.linalg.norm(spin), abs=5e-5)
    slips = _slips(elevation, 2)
    assert [float(least), float(greatest)] == pytest.approx([min(slips), max(slips)], abs=5e-5)


@pytest.mark.parametrize("roller", [1, 2, 3])
def test_places_of_least_and_greatest_slip(roller: int) -> None:
    _, *found = places()[roller - 1]
    slips = dict(zip(TURN, _slips(20, roller), strict=True))
    for text, end in zip(found, (min(slips.values()), max(slips.values())), strict=True):
        assert [slips[int(place)] for place in numbers(text)] == pytest.approx([end, end])


def test_elevations_give_the_printed_slips() -> None:
    printed = {"least": {2: "0.03", 4: "0.19"}, "greatest": {3: "0.30"}}
    for _, name, decimal, _, found in elevations_of_printed(printed):
        middle = sum(numbers(found)) / 2
        slips = _slips(middle, 1)
        assert f"{min(slips) if name == 'least' else max(slips):.2f}" == decimal


PRINTED_SLIPS = {
    "least": {2: "0.03", 3: "0.10", 4: "0.19"},
    "greatest": {2: "0.16", 3: "0.30", 4: "0.40"},
}


def _printed_at(shift: float) -> dict[str, dict[int, str]]:
    """Slips to two decimals, by least squares, with elevations that are smaller by a shift."""
    sizes = {k: _slips(10 * (k - 1) - shift, 1) for k in (2, 3, 4)}
    return {
        name: {k: f"{pick(found):.2f}" for k, found in sizes.items()}
        for name, pick in (("least", min), ("greatest", max))
    }


def test_one_shift_of_the_elevations_gives_all_printed_slips() -> None:
    low, high = numbers(shift_that_serves_all(PRINTED_SLIPS))
    assert _printed_at(low + 0.01) == _printed_at(high - 0.01) == PRINTED_SLIPS
    assert _printed_at(low - 0.02) != PRINTED_SLIPS != _printed_at(high + 0.02)
    assert _printed_at(0) != PRINTED_SLIPS


def test_slips_of_no_one_shift_are_refused() -> None:
    """The exact greatest slip of Pattern IV beside a least one that is far too small."""
    with pytest.raises(ValueError, match="no shift"):
        shift_that_serves_all({"least": {4: "0.10"}, "greatest": {4: "0.40"}})
