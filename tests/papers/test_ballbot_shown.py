"""What the ballbot's chapter shows: figures, the table and theorems, against plain numbers."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pandas as pd
import pytest
from sympy import Expr

from omniproof.audit.theorems import UnprovedError, prove
from omniproof.kinematics import rolling
from omniproof.papers.ballbot.answers import best_zenith_angle, speeds_by_zenith_angle
from omniproof.papers.ballbot.figures import FIGURES
from omniproof.papers.ballbot.theorems import THEOREMS
from omniproof.report.figure import points

ROOT2 = math.sqrt(2)
AZIMUTHS_DEG = (180, -60, 60)
WHEELS = [pytest.param(k, id=f"wheel {k}") for k in (1, 2, 3)]
BY_ID = {theorem.id: theorem for theorem in THEOREMS}


@cache
def frame(number: int | str) -> pd.DataFrame:
    return FIGURES[number].data()


def vector(number: int, panel: str, series: str) -> Any:
    start, end = points(frame(number), panel, series)
    return end - start


def law(angle: float, inner: float, rolls: bool) -> Any:
    """Both laws for a ball of radius 1 m, written out in floats."""
    scale = inner * math.cos(angle) if rolls else 1.0
    azimuths = np.radians(AZIMUTHS_DEG)
    lever = np.full(3, inner * math.sin(angle))
    return np.column_stack([-scale * np.sin(azimuths), scale * np.cos(azimuths), lever])


def test_figures_are_those_of_the_paper_and_one_more() -> None:
    assert list(FIGURES) == [1, 2, 3, 4, 5, "laws"]


@pytest.mark.parametrize(
    ("panel", "radius", "side"),
    [pytest.param("cylinder", 1, 1, id="on top"), pytest.param("sphere", 0.9, -1, id="inside")],
)
def test_figure_1_wheels_touch_the_ball(panel: str, radius: float, side: int) -> None:
    for k, azimuth in enumerate(np.radians(AZIMUTHS_DEG), 1):
        level = radius / ROOT2 * np.array([math.cos(azimuth), math.sin(azimuth)])
        contact = points(frame(1), panel, f"C {k}")[0]
        assert contact == pytest.approx([*level, side * radius / ROOT2])
        rim = points(frame(1), panel, f"wheel {k}")
        gaps = np.linalg.norm(rim, axis=1) - radius
        nearest = rim[np.argmin(np.abs(gaps))]
        assert nearest == pytest.approx(contact, abs=1e-9)
        assert (side * gaps).min() == pytest.approx(0, abs=1e-9)


def test_figure_2_pendulum_keeps_its_length() -> None:
    lengths = [np.linalg.norm(vector(2, "pendulum", name)) for name in ("rod", "swung", "rest")]
    assert lengths == pytest.approx([0.6] * 3)
    assert vector(2, "pendulum", "rod")[2] < 0


def test_figure_3_motions_differ_by_the_turn_times_the_lever() -> None:
    place = points(frame(3), "frames", "C")[0]
    turn = vector(3, "frames", "delta B")
    assert vector(3, "frames", "delta C") == pytest.approx(turn)
    expected = vector(3, "frames", "d B") + np.cross(turn, place)
    assert vector(3, "frames", "d C") == pytest.approx(expected)


@pytest.mark.parametrize("k", WHEELS)
def test_figure_4_frames_stand_on_the_inner_surface(k: int) -> None:
    start = points(frame(4), "frames", f"C {k}")[0]
    tips = np.array([points(frame(4), "frames", f"C {k} {axis}")[0] for axis in "xyz"])
    x, y, z = (tips - start) / np.linalg.norm(tips - start, axis=1)[:, None]
    assert np.linalg.norm(start) == pytest.approx(0.9)
    assert z == pytest.approx(-start / 0.9)
    assert y[2] == pytest.approx(0)
    assert np.cross(start, y)[2] > 0, "counter-clockwise as seen from above"
    assert x == pytest.approx(np.cross(y, z))


def test_figure_4_zenith_angle_goes_from_the_vertical_to_the_first_wheel() -> None:
    arc = points(frame(4), "frames", "phi")
    first = points(frame(4), "frames", "C 1")[0]
    assert arc[0][:2] == pytest.approx([0, 0])
    assert arc[0][2] < 0
    assert np.cross(arc[-1], first) == pytest.approx([0, 0, 0])
    assert arc[-1] @ first > 0


def test_figure_5_ball_rests_at_the_ground_and_is_twice_as_fast_on_top() -> None:
    speeds = [vector(5, "side", f"ball {k}") for k in (1, 2, 3, 4)]
    expected = [(1.2, 0), (0.9, 0), (0.6, 0), (0, 0)]
    np.testing.assert_allclose(speeds, expected, atol=1e-12)


def test_figure_5_surface_follows_the_platform_more_slowly() -> None:
    assert vector(5, "side", "platform") == pytest.approx([0.6, 0])
    assert vector(5, "side", "surface") == pytest.approx([0.6 * (1 - 0.9 / ROOT2), 0])


@pytest.mark.parametrize("k", WHEELS)
@pytest.mark.parametrize(("series", "rolls"), [("rolling", True), ("printed", False)])
def test_figure_5_wheel_speeds_follow_their_law(k: int, series: str, rolls: bool) -> None:
    speed = (law(math.pi / 4, 0.9, rolls) @ [0.6, 0, 0.25])[k - 1]
    azimuth = math.radians(AZIMUTHS_DEG[k - 1])
    driven = np.array([-math.sin(azimuth), math.cos(azimuth)])
    assert vector(5, "above", f"{series} {k}") == pytest.approx(speed * driven)


LAWS = [
    pytest.param("printed", 1.0, False, id="printed"),
    pytest.param("rolling", 1.0, True, id="rolling"),
    pytest.param("rolling in a wall", 0.9, True, id="rolling in a wall"),
]


@pytest.mark.parametrize(("series", "inner", "rolls"), LAWS)
def test_laws_show_the_speed_by_the_printed_inverse(series: str, inner: float, rolls: bool) -> None:
    for degrees, share in points(frame("laws"), "speed", series)[::20]:
        angle = math.radians(degrees)
        speeds = law(angle, inner, rolls) @ [1, 0, 0]
        assert share == pytest.approx(np.linalg.solve(law(angle, inner, False), speeds)[0])


@pytest.mark.parametrize(("series", "inner", "rolls"), LAWS)
def test_laws_show_the_ratio_of_singular_values(series: str, inner: float, rolls: bool) -> None:
    for degrees, ratio in points(frame("laws"), "isotropy", series)[::20]:
        values = np.linalg.svd(law(math.radians(degrees), inner, rolls), compute_uv=False)
        assert ratio == pytest.approx(values[-1] / values[0], abs=1e-9)


def test_laws_are_isotropic_at_their_angles_and_only_one_is_singular_at_the_equator() -> None:
    curves = {name: points(frame("laws"), "isotropy", name) for name in ("printed", "rolling")}
    best = {name: curve[np.argmax(curve[:, 1])] for name, curve in curves.items()}
    at_90 = {name: curve[curve[:, 0] == 90][0, 1] for name, curve in curves.items()}
    assert best["rolling"] == pytest.approx([math.degrees(math.atan(1 / ROOT2)), 1])
    assert best["printed"] == pytest.approx([45, 1])
    assert at_90["rolling"] == pytest.approx(0)
    assert at_90["printed"] == pytest.approx(1 / ROOT2)


TABLE = [
    pytest.param(3, ["60°", "0.500", "0.450", "2.000"], id="half the speed"),
    pytest.param(5, ["90°", "0.000", "0.000", "–"], id="no motion"),
    pytest.param(6, ["135°", "−0.707", "−0.636", "−1.414"], id="backwards"),
]


@pytest.mark.parametrize(("place", "row"), TABLE)
def test_table_of_speeds(place: int, row: list[str]) -> None:
    assert speeds_by_zenith_angle()[place] == row


@pytest.mark.parametrize("name", BY_ID)
def test_theorems_are_proved(name: str) -> None:
    record = prove(BY_ID[name])
    assert record["papers"] == ["ballbot"]
    assert all(step["engines"] for step in record["proof"])


def still_surface(n: Any, q: Any, body: Any, surface: Any = rolling.REST) -> Expr:
    """The paper's premise: whatever a wheel stands on is at rest."""
    return n.dot(body.at(q))


@pytest.mark.parametrize(
    "name", ["thm:rolling-ball", "thm:speed-of-ball", "thm:two-yaws", "thm:ballbot-inverse"]
)
def test_theorems_fail_where_the_surface_stands_still(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(rolling, "rolling_speed", still_surface)
    with pytest.raises(UnprovedError):
        prove(BY_ID[name])


def test_best_angle_by_hand() -> None:
    """3/2 cos^2 = 3 sin^2: tangent 1/sqrt(2), half the angle between faces of a tetrahedron."""
    assert best_zenith_angle() == f"{math.degrees(math.acos(1 / 3) / 2):.2f}°"
