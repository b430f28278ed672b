"""The theorems across the papers: all proved, and what they say held against numbers of our own.

The numeric side shares no code with `kinematics`: NumPy's cross products, least squares by `lstsq`,
dry friction by iterated reweighting.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from omniproof.audit.theorems import UnprovedError, prove
from omniproof.kinematics import ballbot, rolling
from omniproof.papers.one_mechanics import friction, notation, platforms
from omniproof.papers.one_mechanics.theorems import THEOREMS

REGULAR = np.radians([30, 150, 270])
IN_PROSE = {("omni-trajectory", "P_i")}
"""Symbols that stand in running text only, which is not transcribed."""

ALL_PAPERS = {
    "omni-arrangement",
    "omni-trajectory",
    "ballbot",
    "two-roller-sphere",
    "three-roller-sphere",
}


@pytest.mark.parametrize("theorem", THEOREMS, ids=lambda theorem: theorem.id)
def test_it_is_proved(theorem: Any) -> None:
    record = prove(theorem)
    assert all(step["engines"] for step in record["proof"])


def test_they_concern_all_papers_and_have_names_of_their_own() -> None:
    ids = [theorem.id for theorem in THEOREMS]
    assert len(ids) == len(set(ids))
    assert {paper for theorem in THEOREMS for paper in theorem.papers} == ALL_PAPERS


def rollers(azimuths: Any, elevation: float, angle: float) -> tuple[Any, Any]:
    """Contacts and driven directions in floats."""
    cos, sin = np.cos(azimuths), np.sin(azimuths)
    level = np.array([cos, sin, 0 * cos]).T
    up = np.array([0, 0, 1])
    contacts = np.cos(elevation) * level + np.sin(elevation) * up
    east = np.cross(up, level)
    north = np.cross(contacts, east)
    axes = np.cos(angle) * east + np.sin(angle) * north
    return contacts, np.cross(contacts, axes)


def slips(spin: Any, contacts: Any, driven: Any, speeds: Any) -> Any:
    return np.cross(spin, contacts) - speeds[:, None] * driven


def weighted(contacts: Any, driven: Any, speeds: Any, weights: Any) -> Any:
    """Spin with the least weighted sum of squared slips, radius 1."""
    roots = np.repeat(np.sqrt(weights), 3)
    columns = [np.cross(unit, contacts).ravel() for unit in np.eye(3)]
    wanted = (speeds[:, None] * driven).ravel()
    return np.linalg.lstsq(roots[:, None] * np.array(columns).T, roots * wanted, rcond=None)[0]


def dry(contacts: Any, driven: Any, speeds: Any, start: Any) -> Any:
    """Spin with the least sum of slips (Weiszfeld), from a start, each slip rounded off at 1e-5."""
    spin = start
    for rounding in (1e-1, 1e-2, 1e-3, 1e-4, 1e-5):
        for _ in range(2000):
            sizes = np.linalg.norm(slips(spin, contacts, driven, speeds), axis=1)
            weights = 1 / np.hypot(sizes, rounding)
            following = weighted(contacts, driven, speeds, weights)
            moved, spin = np.abs(following - spin).max(), following
            if moved < 1e-12:
                break
    return spin


def velocity_and_speeds(angle: float) -> tuple[Any, Any]:
    velocity = np.array([np.sin(angle), -np.cos(angle), 0])
    return velocity, np.sin(angle + np.radians([240, 120, 0]))


def evaluated(spin: Any, velocity: Any, elevation: float) -> Any:
    """Numbers of an exact spin of the raised triangle, radius 1."""
    point = {
        platforms.ELEVATION: elevation,
        platforms.VELOCITY[0]: velocity[0],
        platforms.VELOCITY[1]: velocity[1],
        platforms.RADIUS: 1,
    }
    return np.array(spin.subs(point).evalf().tolist(), dtype=float).ravel()


@pytest.mark.parametrize("elevation", [10, 20, 30])
@pytest.mark.parametrize("angle", [0, 17, 30, 55, 90, 200])
def test_the_raised_triangle_by_numbers(elevation: int, angle: int) -> None:
    """Both closed forms against minima that were found by iteration."""
    raised = np.radians(elevation)
    velocity, speeds = velocity_and_speeds(np.radians(angle))
    contacts, driven = rollers(REGULAR, raised, 0)
    square = weighted(contacts, driven, speeds, np.ones(3))
    np.testing.assert_allclose(
        evaluated(platforms.raised_spin(), velocity, raised), square, atol=1e-12
    )
    outward = [float(np.dot(velocity[:2], [np.cos(a), np.sin(a)])) for a in REGULAR]
    middle = int(np.argsort(outward)[1])
    found = dry(contacts, driven, speeds, square)
    expected = evaluated(friction.dry_spin(middle), velocity, raised)
    np.testing.assert_allclose(found, expected, atol=2e-4)


def test_beyond_35_degrees_dry_friction_holds_no_roller() -> None:
    """So the theorem's bound is needed: at 50 degrees another spin slips less in sum."""
    raised = np.radians(50)
    velocity, speeds = velocity_and_speeds(0.3)
    contacts, driven = rollers(REGULAR, raised, 0)
    outward = [float(np.dot(velocity[:2], [np.cos(a), np.sin(a)])) for a in REGULAR]
    stuck = evaluated(friction.dry_spin(int(np.argsort(outward)[1])), velocity, raised)
    better = dry(contacts, driven, speeds, stuck)
    losses = [
        np.linalg.norm(slips(spin, contacts, driven, speeds), axis=1).sum()
        for spin in (better, stuck)
    ]
    assert losses[0] < losses[1] - 1e-3


def test_two_rollers_under_dry_friction_stop_anywhere_between_the_lines() -> None:
    """Equal losses along the segment, more outside; contacts of the two-roller paper's kind."""
    contacts, driven = rollers(np.array([0, 1.2]), 0, 0)
    tilts, speeds = (0.4, -0.7), np.array([1.0, 0.6])
    driven = np.array(
        [rollers(np.array([a]), 0, t)[1][0] for a, t in zip((0, 1.2), tilts, strict=True)]
    )
    middle = weighted(contacts, driven, speeds, np.ones(2))
    heights = -speeds * np.sin(tilts)
    assert middle[2] == pytest.approx(heights.mean())

    def loss(height: float) -> float:
        spin = np.array([*middle[:2], height])
        return float(np.linalg.norm(slips(spin, contacts, driven, speeds), axis=1).sum())

    low, high = sorted(heights)
    inside = [loss(h) for h in np.linspace(low, high, 7)]
    np.testing.assert_allclose(inside, high - low)
    assert min(loss(low - 0.1), loss(high + 0.1)) > high - low + 0.1
    assert loss(float(middle[2])) <= min(
        float(np.linalg.norm(slips(middle + side, contacts, driven, speeds), axis=1).sum())
        for side in 0.05 * np.array([[1, 0, 0], [0, 1, 0], [-1, 1, 0]])
    )


def growing(contacts: Any, driven: Any, speeds: Any, power: float) -> Any:
    """Steady spin where friction is the slip to a power: least squares, weighted repeatedly."""
    spin = weighted(contacts, driven, speeds, np.ones(len(speeds)))
    for _ in range(3000):
        sizes = np.linalg.norm(slips(spin, contacts, driven, speeds), axis=1)
        following = weighted(contacts, driven, speeds, sizes ** (power - 1))
        spin = spin + 0.3 * (following - spin)
    return spin


@pytest.mark.parametrize("power", [0.5, 2])
def test_two_rollers_stop_half_way_under_any_friction_that_grows(power: float) -> None:
    """And three do not stop at the least-squares point, unless the power is one."""
    tilts, speeds = (0.4, -0.7), np.array([1.0, 0.6])
    pairs = [rollers(np.array([a]), 0, t) for a, t in zip((0, 1.2), tilts, strict=True)]
    contacts, driven = (np.array([pair[k][0] for pair in pairs]) for k in (0, 1))
    middle = weighted(contacts, driven, speeds, np.ones(2))
    np.testing.assert_allclose(growing(contacts, driven, speeds, power), middle, atol=1e-9)
    _, three = velocity_and_speeds(0.3)
    raised = rollers(REGULAR, np.pi / 6, 0)
    apart = growing(*raised, three, power) - weighted(*raised, three, np.ones(3))
    assert np.abs(apart).max() > 0.01
    forces = slips(growing(*raised, three, power), *raised, three)
    sizes = np.linalg.norm(forces, axis=1)[:, None]
    torque = np.cross(raised[0], forces * sizes ** (power - 1)).sum(axis=0)
    np.testing.assert_allclose(torque, np.zeros(3), atol=1e-9)


def test_on_one_line_no_input_is_without_slip_but_rest() -> None:
    """Why the theorem excludes it: the driven directions are dependent, yet no speeds fit."""
    pairs = [rollers(np.array([a]), 0, t) for a, t in ((0, 0), (np.pi, 0.5), (0, 1.3))]
    contacts, driven = (np.array([pair[k][0] for pair in pairs]) for k in (0, 1))
    assert np.linalg.det(driven) == pytest.approx(0)
    assert np.linalg.matrix_rank(driven) == 2
    free = np.cross(driven[0], driven[1])
    axes = np.cross(driven, contacts)
    np.testing.assert_allclose(axes @ free, np.zeros(3), atol=1e-12)


def test_viscous_friction_leads_to_the_least_squares_point() -> None:
    """A sphere that is let go from any spin, step by step, with unequal coefficients too."""
    contacts, driven = rollers(np.array([0.1, 1.9, 4.0]), 0.3, 0.8)
    speeds = np.array([1.0, -0.4, 0.7])
    for coefficients in (np.ones(3), np.array([1.0, 2.0, 0.5])):
        spin = np.array([3.0, -2.0, 1.0])
        for _ in range(4000):
            forces = -coefficients[:, None] * slips(spin, contacts, driven, speeds)
            spin = spin + 0.02 * np.cross(contacts, forces).sum(axis=0)
        expected = weighted(contacts, driven, speeds, coefficients)
        np.testing.assert_allclose(spin, expected, atol=1e-9)


@pytest.mark.parametrize(
    ("angle", "dimension"),
    [
        pytest.param(0, 2, id="axes level: two-dimensional"),
        pytest.param(np.pi / 2, 1, id="axes upright: equal speeds"),
        pytest.param(0.5, 0, id="between: none"),
    ],
)
def test_inputs_without_slip_on_the_equator(angle: float, dimension: int) -> None:
    """Kernel of all 9 equations on (spin, speeds), by its singular values."""
    contacts, driven = rollers(REGULAR, 0, angle)
    spins = [np.cross(unit, contacts).ravel() for unit in np.eye(3)]
    inputs = [-(unit[:, None] * driven).ravel() for unit in np.eye(3)]
    values = np.linalg.svd(np.array(spins + inputs), compute_uv=False)
    assert int((values < 1e-9).sum()) == dimension


def test_patterns_of_the_paper_by_hand() -> None:
    """At 30 degrees: circle of radius 1 / (1 + 1/4), slips from 1/5 to 2/5."""
    contacts, driven = rollers(REGULAR, np.pi / 6, 0)
    sizes = []
    for angle in np.linspace(0, 2 * np.pi, 361):
        _, speeds = velocity_and_speeds(angle)
        spin = weighted(contacts, driven, speeds, np.ones(3))
        assert np.linalg.norm(spin) == pytest.approx(0.8)
        sizes.append(np.linalg.norm(slips(spin, contacts, driven, speeds), axis=1))
    assert np.min(sizes) == pytest.approx(0.2)
    assert np.max(sizes) == pytest.approx(0.4)
    assert all(np.abs(after - before).max() < 0.01 for before, after in pairwise(sizes))


def test_equal_drive_by_numbers() -> None:
    """Least squares and least sum of slips agree: -sin(psi) / cos(theta) about z."""
    elevation, angle = 0.4, 0.9
    contacts, driven = rollers(REGULAR, elevation, angle)
    square = weighted(contacts, driven, np.ones(3), np.ones(3))
    expected = [0, 0, -np.sin(angle) / np.cos(elevation)]
    np.testing.assert_allclose(square, expected, atol=1e-12)
    start = np.array([0.3, -0.2, 0.1])
    np.testing.assert_allclose(dry(contacts, driven, np.ones(3), start), expected, atol=1e-6)


def doubled_speed(n: Any, q: Any, body: Any, surface: Any = rolling.REST) -> Any:
    """A broken constraint: spins count twice, velocities once."""
    turn = (body.rotation - surface.rotation).cross(q)
    return n.dot(body.velocity - surface.velocity + 2 * turn)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param("thm:two-rollers", id="the spin of two rollers"),
        pytest.param("thm:no-slip", id="the speeds without slip"),
        pytest.param("thm:one-wheel-matrix", id="the lever of the yaw"),
        pytest.param("thm:rollers-on-equator", id="the wheel matrix"),
        pytest.param("thm:two-simulations", id="the radius of the circles"),
        pytest.param("thm:dry-raised", id="the spin under dry friction"),
    ],
)
def test_it_rests_on_the_rolling_constraint(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    (theorem,) = (theorem for theorem in THEOREMS if theorem.id == name)
    monkeypatch.setattr(rolling, "rolling_speed", doubled_speed)
    with pytest.raises(UnprovedError):
        prove(theorem)


def cells() -> list[Any]:
    """Paper and symbol of each cell of the table of notation that holds a formula."""
    return [
        pytest.param(paper, part.strip("$"), id=f"{paper} {row.head} {part}")
        for row in notation.QUANTITIES
        for paper, cell in zip(notation.PAPERS, row.cells, strict=True)
        for part in cell.split(notation.PART)
        if part.startswith("$")
    ]


@pytest.mark.parametrize(("paper", "symbol"), cells())
def test_each_symbol_stands_in_the_transcription_of_its_paper(
    root: Path, paper: str, symbol: str
) -> None:
    printed = root / "paper_data" / paper / "paper.yaml"
    if not printed.is_file():
        pytest.skip(f"{paper} is not transcribed here")
    if (paper, symbol) in IN_PROSE:
        return
    text = printed.read_text(encoding="utf-8")
    assert f"'{symbol}'" in text or f"'{symbol} " in text or f" {symbol} " in text


def test_every_row_of_the_notation_has_a_cell_a_paper() -> None:
    rows = notation.table([*notation.QUANTITIES, *notation.LETTERS])
    assert {len(row) for row in rows} == {1 + len(notation.HEADS)}
    assert not any(notation.PART in cell for row in rows for cell in row)
    heads = [row[0] for row in rows]
    assert len(heads) == len(set(heads))


def test_the_first_axis_of_a_wheel_of_the_ballbot_is_a_rollers_axis() -> None:
    """Why the table of notation has it in one row with eta."""
    zenith, azimuth = 0.7, 2.1
    place = np.array(
        [np.sin(zenith) * np.cos(azimuth), np.sin(zenith) * np.sin(azimuth), -np.cos(zenith)]
    )
    frame = np.array(ballbot.contact_frame(azimuth, zenith, 1).tolist(), dtype=float)
    first, driven = frame[:3, 0], frame[:3, 1]
    np.testing.assert_allclose(np.cross(place, -first), driven, atol=1e-12)
