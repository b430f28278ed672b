"""Pictures of the models against their parameters; pictures of numbers against made-up numbers."""

from __future__ import annotations

import math

import numpy as np
import pandas as pd
import pytest
from recorded import frame_of, numbers

from omniproof.papers.omni_trajectory.simulated import VARIATIONS
from omniproof.papers.one_mechanics.figures.spins import RUNS, SPINS
from omniproof.papers.simulation.figures import FIGURES
from omniproof.papers.simulation.figures import solids as outlines
from omniproof.report.figure import points
from omniproof.report.sketch import projected, toward_viewer
from omniproof.simulation.omni_robot import VARIATIONS as VARIED

LEAN = np.array([[0.6, 0.0, 0.8], [0.0, 1.0, 0.0], [-0.8, 0.0, 0.6]])
"""A turn about y, exact in decimals."""


def one_geom(attributes: str) -> dict[str, np.ndarray]:
    """Outlines of a model with one solid at the origin, leaning by 53 degrees about y."""
    quaternion = f"{math.sqrt(0.8)} 0 {math.sqrt(0.2)} 0"
    xml = f'<mujoco><worldbody><geom quat="{quaternion}" {attributes}/></worldbody></mujoco>'
    return {part.name: part.points for part in outlines.solids(*outlines.at_rest(xml))}


def reach(outline: np.ndarray, angle: float) -> float:
    """How far an outline extends on the picture in a direction."""
    return float((projected(outline) @ [math.cos(angle), math.sin(angle)]).max())


def support_of_ellipsoid(direction: np.ndarray) -> float:
    """max n.x over the ellipsoid is |S R^T n|, with the half-axes S."""
    return float(np.linalg.norm(np.diag([0.1, 0.2, 0.5]) @ LEAN.T @ direction))


def support_of_cylinder(direction: np.ndarray) -> float:
    """Of radius 0.3 and half-length 0.5: r |n across the axis| + h |n along it|."""
    along = direction @ LEAN[:, 2]
    return float(0.3 * math.sqrt(1 - along**2) + 0.5 * abs(along))


def on_picture(angle: float) -> np.ndarray:
    """Direction in space that shows on the picture at full length, at an angle."""
    right, up = np.linalg.svd(toward_viewer()[None])[2][1:]
    basis = projected(np.array([right, up])).T
    return np.array([right, up]).T @ np.linalg.solve(basis, [math.cos(angle), math.sin(angle)])


@pytest.mark.parametrize("angle", np.radians(range(0, 360, 30)))
@pytest.mark.parametrize(
    ("attributes", "name", "support"),
    [
        pytest.param(
            'type="ellipsoid" size=".1 .2 .5"', "passive 1", support_of_ellipsoid, id="ellipsoid"
        ),
        pytest.param('type="cylinder" size=".3 .5"', "body", support_of_cylinder, id="cylinder"),
        pytest.param('type="sphere" size=".7"', "body", lambda _: 0.7, id="sphere"),
    ],
)
def test_an_outline_reaches_as_far_as_its_solid(attributes, name, support, angle) -> None:
    """A convex outline is right if it reaches as far as its solid in every direction."""
    expected = support(on_picture(angle))
    # A polygon falls short of its curve by 1 - cos of half a step.
    assert reach(one_geom(attributes)[name], angle) == pytest.approx(expected, rel=0.013)


def test_the_face_of_a_cylinder_is_the_one_that_is_seen() -> None:
    face = one_geom('type="cylinder" size=".3 .5"')["body, face"]
    axis = LEAN[:, 2] * np.sign(LEAN[:, 2] @ toward_viewer())
    assert face @ axis == pytest.approx(0.5)
    assert np.linalg.norm(face - 0.5 * axis, axis=1) == pytest.approx(0.3)


def parts(name: str, panel: str, kind: str) -> dict[str, np.ndarray]:
    """Outlines of the parts of a kind in the order in which they are drawn."""
    frame = frame_of(FIGURES[name])
    names = frame[frame["panel"] == panel]["series"].drop_duplicates()
    return {one: points(frame, panel, one) for one in names if one.split()[0] == kind}


def test_the_robot_has_the_printed_parts() -> None:
    """Three wheels at 30, 150 and 270 degrees, 0.108 m from the middle, of 18 rollers each."""
    rims = parts("robot", "robot", "rim")
    middles = np.array([rim[:-1].mean(axis=0) for rim in rims.values()])
    assert np.hypot(*middles[:, :2].T) == pytest.approx([0.108] * 3)
    angles = sorted(np.degrees(np.arctan2(middles[:, 1], middles[:, 0])) % 360)
    assert angles == pytest.approx([30, 150, 270])
    assert {len(rim) - 1 for rim in rims.values()} == {18}
    assert len(parts("robot", "robot", "passive")) == 54


def test_the_nearest_is_drawn_last() -> None:
    found = parts("robot", "robot", "passive").values()
    depths = [float(outline.mean(axis=0) @ toward_viewer()) for outline in found]
    assert depths == sorted(depths)


@pytest.mark.parametrize(("panel", "far"), [("inside", 0.08), ("on top", 0.12)])
def test_the_hubs_are_a_wheel_away_from_the_surface(panel: str, far: float) -> None:
    """Ball of 0.1 m, wheels of 0.02 m, at 30 degrees from the pole."""
    (hubs,) = parts("ball", panel, "platform").values()
    from_middle = hubs - [0, 0, 0.1]
    assert np.linalg.norm(from_middle, axis=1) == pytest.approx(far)
    cosine = math.cos(math.radians(30)) * (-1 if panel == "inside" else 1)
    assert from_middle[:, 2] / far == pytest.approx(cosine)


@pytest.mark.parametrize(("panel", "count"), [("two rollers", 2), ("three rollers", 3)])
def test_rollers_touch_the_sphere_with_their_sides(panel: str, count: int) -> None:
    """Radii 1 and 0.2 m: axes are 1.2 m from the middle, but for the depth at rest."""
    rollers = parts("sphere", panel, "roller")
    middles = [outline.mean(axis=0) for name, outline in rollers.items() if "," not in name]
    assert len(middles) == count
    assert np.linalg.norm(middles, axis=1) == pytest.approx(1.2, abs=1e-4)


# Numbers -----------------------------------------------------------------------------------------


def test_points_of_the_ball_are_the_numbers_of_its_cases() -> None:
    """Cases that only turn have no share, and no point."""
    summary = numbers("ballbot")
    moving = ~summary["case"].str.contains("turning") | ~summary["quantity"].isin(["share"])
    frame = FIGURES["ball-law"].data(summary[moving])
    for side, aside in (("inside", -0.8), ("on-top", 0.8)):
        found = points(frame, "share", side)
        assert sorted(found[:, 0]) == pytest.approx(np.repeat([30, 45, 60], 3) + aside)
        assert set(found[:, 1]) == {0.5}
        assert len(points(frame, "error", f"printed, {side}")) == 9
    assert points(frame, "share", "rolling")[60] == pytest.approx([60, 0.5])


def test_what_is_said_of_the_law_is_measured() -> None:
    """All shares one half: off cos 30 degrees by 0.366."""
    made = FIGURES["ball-law"]
    assert "at most 0.3660 off" in made.describe(frame_of(made))


def test_every_change_of_the_robot_has_its_errors() -> None:
    assert [name.removeprefix("-") for name in VARIATIONS] == ["", *VARIED]
    summary = numbers("omni-robot").copy()
    place = (summary["case"] == "circle-clockwise-standing-slippery") & (
        summary["quantity"] == "mean_error"
    )
    summary.loc[place, "value"] = 0.75
    frame = FIGURES["sensitivity"].data(summary)
    slippery = list(VARIATIONS).index("-slippery")
    words = VARIATIONS["-slippery"]
    assert points(frame, "mean_error", f"{words}, standing") == pytest.approx(
        np.array([[0.75, slippery]])
    )
    assert points(frame, "mean_error", f"{words}, flying") == pytest.approx(
        np.array([[0.5, slippery]])
    )
    assert f"0.5000 to 0.7500 ({words})" in FIGURES["sensitivity"].describe(frame)


def spinning(x: float, y: float) -> pd.DataFrame:
    """A run that comes to a level spin; its first row is before the sphere is let go."""
    return pd.DataFrame({"spin_x": [0, 2, x], "spin_y": [0, 2, y], "spin_z": 0.0})


@pytest.mark.parametrize(
    ("end", "outside"),
    [
        pytest.param((0.6, 0.17), "0.0000", id="inside, beside a corner"),
        pytest.param((-1.02, 0.0), "0.0200", id="left of the side at x = -1"),
    ],
)
def test_the_triangle_on_the_equator(end: tuple[float, float], outside: str) -> None:
    """By hand: roller k at azimuth a does not slip on n.w = -v, n = (sin a, -cos a).

    Azimuths 30, 150, 270 degrees and speeds 0.2, 0.5, 1: the lines have the distances 0.2, 0.5, 1
    from the origin, the third is x = -1 or x = 1; an equilateral triangle, whose height is
    |v_1 + v_2 + v_3| = 1.7.
    """
    made = FIGURES["equator"]
    runs = [spinning(-0.4, 0.2) for _ in made.needs]
    frame = made.data(*runs[:-1], spinning(*end))
    triangle = points(frame, "level", "triangle")
    sides = np.linalg.norm(triangle - np.roll(triangle, 1, axis=0), axis=1)
    assert sides == pytest.approx([2 * 1.7 / math.sqrt(3)] * 3)
    assert sorted(triangle[:, 0])[:2] == pytest.approx([-1, -1])
    assert points(frame, "level", "viscous") == pytest.approx(np.array([[2, 2], [-0.4, 0.2]]))
    assert f"at most {outside} rad/s outside" in made.describe(frame)


def test_marks_of_the_spins_are_the_ends_of_the_runs() -> None:
    """The second of two rows counts; of the height, Pattern IV alone."""
    runs = [
        pd.DataFrame({"spin_x": [9, 0.8], "spin_y": [9, 0], "spin_z": [9, k / 100]})
        for k, _ in enumerate(RUNS)
    ]
    frame = SPINS.data(*runs)
    for law, first in (("viscous", 8), ("dry", 9)):
        assert points(frame, "level", f"simulated {law}") == pytest.approx(np.array([[0.8, 0]] * 6))
        heights = points(frame, "height", f"simulated {law}")
        assert heights == pytest.approx(np.array([[17, first / 100], [55, (first + 2) / 100]]))
    # 0.8 is the circle of viscous Pattern IV, and 0.2 off the dry one.
    assert "at most 0.2000 rad/s off" in SPINS.describe(frame)
