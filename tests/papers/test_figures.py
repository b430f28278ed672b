"""The figures of the arrangement paper show what is true; see `test_every_figure` for the rest."""

from __future__ import annotations

import math
from functools import cache
from itertools import combinations, product
from typing import Any

import numpy as np
import pandas as pd
import pytest

from omniproof.papers.omni_arrangement.arrangements import (
    CORRECTED,
    PARAMETER,
    PRINTED,
    isosceles,
)
from omniproof.papers.omni_arrangement.figures import FIGURES
from omniproof.report.figure import points

TYPES = [pytest.param(kind, id=f"type {kind}") for kind in CORRECTED]


@cache
def frame(number: int) -> pd.DataFrame:
    return FIGURES[number].data()


def numeric(kind: str) -> Any:
    """Wheel matrix of a type in plain floats, and its inverse by NumPy."""
    angles = [float(angle) for angle in CORRECTED[kind]]
    matrix = np.array([[-math.sin(a), math.cos(a), 1.0] for a in angles])
    return matrix, np.linalg.inv(matrix)


def as_set(polygon: Any) -> set[tuple[float, ...]]:
    return {tuple(float(value) + 0.0 for value in np.round(point, 9)) for point in polygon}


def shoelace(polygon: Any) -> float:
    x, y = polygon.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def test_figures_are_those_of_the_paper() -> None:
    assert list(FIGURES) == [1, 2, 3, 4, 5, 6, 7, 8, "sign"]


def test_printed_and_corrected_types_differ_in_one_wheel() -> None:
    degrees = {kind: [round(math.degrees(a)) for a in angles] for kind, angles in PRINTED.items()}
    assert degrees == {"X": [30, 150, 270], "Y": [0, 180, 270], "Z": [210, 270, 300]}
    changed = [kind for kind in PRINTED if PRINTED[kind] != CORRECTED[kind]]
    assert changed == ["Z"]
    assert [round(math.degrees(a)) for a in CORRECTED["Z"]] == [210, 270, 330]


@pytest.mark.parametrize("kind", TYPES)
def test_each_type_is_isosceles(kind: str) -> None:
    member = {round(math.degrees(a)) % 360 for a in isosceles(PARAMETER[kind])}
    assert member == {round(math.degrees(a)) for a in CORRECTED[kind]}


def test_figure_1_strikes_out_the_printed_wheel() -> None:
    data = frame(1)
    ghosts = data[data["series"].str.startswith("printed")]
    assert list(ghosts["panel"]) == ["Z"]
    assert math.degrees(math.atan2(ghosts["y"].iloc[0], ghosts["x"].iloc[0])) == pytest.approx(-60)


def test_figure_2_shares_add_up_along_n() -> None:
    start, tip = points(frame(2), "wheel", "v")
    n = np.diff(points(frame(2), "wheel", "n"), axis=0)[0]
    velocity = np.diff(points(frame(2), "wheel", "V"), axis=0)[0]
    share = np.diff(points(frame(2), "wheel", "v^T"), axis=0)[0]
    rotation = points(frame(2), "wheel", "v^R")
    assert np.linalg.norm(n) == pytest.approx(1)
    assert n @ start == pytest.approx(0)
    assert share == pytest.approx((velocity @ n) * n)
    assert rotation[0] == pytest.approx(start + share)
    assert rotation[1] == pytest.approx(tip)


@pytest.mark.parametrize("kind", TYPES)
def test_figure_4_bodies_are_the_images_of_the_corners(kind: str) -> None:
    _, inverse = numeric(kind)
    data = frame(4)
    corners = data[data["panel"] == kind][["x", "y", "z"]].to_numpy(dtype=float)
    images = [inverse @ signs for signs in product((-1, 1), repeat=3)]
    assert as_set(corners) == as_set(images)


def test_figure_3_maps_the_cube_onto_the_body() -> None:
    matrix, _ = numeric("X")
    data = frame(3)
    twists = data[(data["panel"] == "twists") & data["series"].str.startswith("face")]
    speeds = twists[["x", "y", "z"]].to_numpy(dtype=float) @ matrix.T
    assert as_set(speeds) == as_set(product((-1, 1), repeat=3))


@pytest.mark.parametrize("kind", TYPES)
def test_figure_5_hexagons_have_the_corners_twice_a_k(kind: str) -> None:
    _, inverse = numeric(kind)
    flat = inverse[:2].T
    expected = [sign * 2 * column for column in flat for sign in (1, -1)]
    assert as_set(points(frame(5), kind, "projection")) == as_set(expected)


@pytest.mark.parametrize("kind", TYPES)
def test_figure_5_sections_use_the_wheels_fully_without_rotation(kind: str) -> None:
    matrix, _ = numeric(kind)
    for corner in points(frame(5), kind, "section"):
        speeds = np.abs(matrix[:, :2] @ corner)
        assert speeds.max() == pytest.approx(1)
        assert np.isclose(speeds, 1).sum() >= 2


def test_figure_5_types_x_and_z_have_one_section_but_not_one_projection() -> None:
    x, z = (as_set(points(frame(5), kind, "section")) for kind in "XZ")
    assert x == z
    assert shoelace(points(frame(5), "X", "section")) == pytest.approx(2 * math.sqrt(3))
    areas = [shoelace(points(frame(5), kind, "projection")) for kind in "XZ"]
    assert areas[1] == pytest.approx(3 * areas[0])


@pytest.mark.parametrize(("panel", "factor"), [("D_V", 8), ("D_A", 12)])
def test_figure_6_curves_follow_the_determinant(panel: str, factor: int) -> None:
    theta_deg, values = points(frame(6), panel, "curve").T
    theta = np.radians(theta_deg)
    determinant = 2 * np.cos(theta) + np.sin(2 * theta)
    np.testing.assert_allclose(values, factor / np.abs(determinant), rtol=1e-9)
    assert theta_deg.min() > -90
    assert theta_deg.max() < 90
    assert theta_deg[np.argmin(values)] == 30
    assert points(frame(6), panel, "minimum")[0] == pytest.approx(
        [30, factor / (1.5 * math.sqrt(3))]
    )


def test_figure_7_base_times_height_is_the_volume() -> None:
    columns = np.array([points(frame(7), "volume", f"a {k}")[0] for k in (1, 2, 3)])
    base, height = points(frame(7), "volume", "base"), points(frame(7), "volume", "H")[0]
    _, inverse = numeric("Y")
    assert base[:, 2] == pytest.approx(0)
    assert height[:2] == pytest.approx([0, 0])
    volume = shoelace(base[:, :2]) * height[2]
    assert volume == pytest.approx(abs(np.linalg.det(inverse)))
    for i, j in combinations(range(3), 2):
        assert columns[i] @ columns[j] == pytest.approx(inverse[:, i] @ inverse[:, j])


def test_figure_8_case_1_always_and_the_sweep_fills_the_hexagon() -> None:
    flat = [points(frame(8), "case 1", f"a {k}")[0] for k in (1, 2, 3)]
    assert sum(flat) == pytest.approx([0, 0])
    hexagon = points(frame(8), "sweep", "hexagon")
    ends = ("P-", "P+", "Q+", "R+", "R-", "S-")
    corners = [points(frame(8), "sweep", name)[0] for name in ends]
    assert as_set(hexagon) == as_set(corners)
    band = [points(frame(8), "sweep", name)[0] for name in ("R+", "P+", "P", "R")]
    tip = [points(frame(8), "sweep", name)[0] for name in ("Q+", "P+", "R+")]
    half = abs(shoelace(np.array(band))) + abs(shoelace(np.array(tip)))
    assert 2 * half == pytest.approx(shoelace(hexagon))
