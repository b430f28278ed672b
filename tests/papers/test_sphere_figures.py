"""The figures of both papers on spheres show what is true; see `test_every_figure` for the rest."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pandas as pd
import pytest
import sphere_oracle as oracle

from omniproof.report.drawing import load_figures
from omniproof.report.figure import points

TWO, THREE = "two-roller-sphere", "three-roller-sphere"
CASES = [pytest.param(k, 10 * k, id=f"{10 * k} degrees") for k in range(4)]
PATTERNS = [pytest.param(k, 10 * (k - 1), id=f"pattern {k}") for k in range(1, 5)]


@cache
def frame(paper: str, number: int) -> pd.DataFrame:
    return load_figures(paper)[number].data()


def at(curve: Any, x: float) -> float:
    """Value of a curve at one of its samples."""
    (found,) = curve[curve[:, 0] == x]
    return float(found[1])


@pytest.mark.parametrize(("paper", "numbers"), [(TWO, [1, 2, 3, 4, 5]), (THREE, [1, 2, 3])])
def test_figures_are_those_of_the_paper(paper: str, numbers: list[int]) -> None:
    assert list(load_figures(paper)) == numbers


# Two rollers


def test_one_roller_allows_the_spins_drawn() -> None:
    """They obey the printed Eq. (3), <eta, omega> = -nu / r, and lie in the plane of eta and P."""
    data = frame(TWO, 1)
    p, eta = (points(data, "sphere", name)[0] for name in ("P", "eta"))
    for k in (1, 2, 3):
        spin = points(data, "sphere", f"omega {k}")[0]
        assert eta @ spin == pytest.approx(-0.8)
        assert np.cross(p, eta) @ spin == pytest.approx(0)


@pytest.mark.parametrize("panel", ["meeting", "skew"])
def test_spin_of_two_rollers_is_half_way_between_the_lines(panel: str) -> None:
    data = frame(TWO, 2)
    spin = points(data, panel, "omega")[0]
    near = [points(data, panel, f"near {k}")[0] for k in (1, 2)]
    lines = [np.diff(points(data, panel, f"line {k}"), axis=0)[0] for k in (1, 2)]
    contacts = [points(data, panel, f"P {k}")[0] for k in (1, 2)]
    assert sum(near) / 2 == pytest.approx(spin)
    for line, p in zip(lines, contacts, strict=True):
        assert np.cross(line, p) == pytest.approx(0)
        assert (near[1] - near[0]) @ line == pytest.approx(0)
    apart = np.linalg.norm(near[1] - near[0])
    assert apart == pytest.approx(0, abs=1e-12) if panel == "meeting" else apart > 0.5


@pytest.mark.parametrize(("k", "angle_deg"), CASES)
@pytest.mark.parametrize("place", range(0, 73, 7))
def test_simulation_of_two_rollers_is_least_squares(k: int, angle_deg: int, place: int) -> None:
    data = frame(TWO, 3)
    direction = points(data, "rho", f"k {k}")[place, 0]
    speeds, spin, slips = oracle.travel(angle_deg, direction)
    assert points(data, "omega", f"k {k}")[place] == pytest.approx(spin)
    axis = np.degrees(np.arctan2(spin[2], np.hypot(spin[0], spin[1])))
    assert points(data, "rho", f"k {k}")[place, 1] == pytest.approx(axis)
    for i in (1, 2):
        name = f"roller {i}, k {k}"
        assert at(points(data, "nu", name), direction) == pytest.approx(speeds[i - 1])
        assert at(points(data, "S", name), direction) == pytest.approx(slips[i - 1], abs=1e-12)


def test_no_point_has_a_smaller_sum_of_squares() -> None:
    data = frame(TWO, 4)
    best, place = points(data, "skew", "omega")[0], points(data, "skew", "Q")[0]
    least = points(data, "distances", "least")[0]
    distances = points(data, "distances", "Q")[0]
    near = [points(data, "skew", f"near {k}")[0] for k in (1, 2)]
    assert [np.linalg.norm(best - point) for point in near] == pytest.approx(least)
    feet = [points(data, "skew", f"foot {k}")[0] for k in (1, 2)]
    assert [np.linalg.norm(place - foot) for foot in feet] == pytest.approx(distances)
    assert distances.sum() > least.sum()
    radii = np.linalg.norm(points(data, "distances", "circle"), axis=1)
    assert radii**2 == pytest.approx(least.sum() ** 2 / 2)


def test_projected_lines_meet_at_the_projected_spin() -> None:
    data = frame(TWO, 5)
    spin = points(data, "plane", "omega t")[0]
    for k in (1, 2):
        start, end = points(data, "plane", f"line {k}")
        foot, p = points(data, "plane", f"foot {k}")[0], points(data, "plane", f"P {k}")[0]
        for point in (spin, foot):
            assert np.linalg.det([end - start, point - start]) == pytest.approx(0, abs=1e-12)
        assert foot @ p == pytest.approx(0)


# Three rollers


def test_arrangements_stand_where_the_text_says() -> None:
    data = frame(THREE, 1)
    heights = {panel: points(data, panel, "P 1")[0, 2] for panel in data["panel"].unique()}
    assert [height > 0 for height in heights.values()] == [False, True, False, True]
    counts = [data[data["panel"] == p]["series"].str.startswith("P ").sum() for p in heights]
    assert counts == [2, 2, 3, 3]


def test_best_point_of_three_lines_has_no_slope() -> None:
    """The feet of the perpendiculars from it have it as their centroid."""
    data = frame(THREE, 2)
    best = points(data, "lines", "Q_o")[0]
    middles = [points(data, "lines", f"line {k}").mean(axis=0) for k in (1, 2, 3)]
    assert sum(middles) / 3 == pytest.approx(best)


@pytest.mark.parametrize(("k", "elevation_deg"), PATTERNS)
@pytest.mark.parametrize("place", range(0, 73, 7))
def test_simulation_of_three_rollers_is_least_squares(
    k: int, elevation_deg: int, place: int
) -> None:
    data = frame(THREE, 3)
    parameter = points(data, "slip", f"roller 1, k {k}")[place, 0]
    spin, slips = oracle.pattern(elevation_deg, parameter)
    assert points(data, "omega", f"k {k}")[place] == pytest.approx(spin, abs=1e-12)
    for i, slipping in enumerate(slips, 1):
        size = at(points(data, "slip", f"roller {i}, k {k}"), parameter)
        assert size == pytest.approx(np.linalg.norm(slipping), abs=1e-12)
