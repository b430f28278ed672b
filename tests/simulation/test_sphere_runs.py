"""A sphere between rollers: what it does under either friction, against numbers of our own.

Expected spins share no code with the package: least squares by NumPy, the dry spin as a least sum
of slips, sizes by hand.

Tolerances. Contacts are 0.016 mm deep, and MuJoCo takes the middle of the overlap as the place of
contact: a rim of 200 mm is slower by 4e-5 and the sphere's lever shorter by 0.8e-5. `RIM` is twice
their sum. Where dry friction holds a roller, that one still slips, by up to the creep: so much the
spin is off across its contact, and about as much along it, where only the others guide it: `HELD`.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from omniproof.simulation import sphere, sphere_model
from omniproof.simulation.engine import ImplausibleRunError, Recording
from omniproof.simulation.sphere_model import LOAD
from omniproof.simulation.sphere_rollers import equator_rollers, three_rollers, two_rollers

CASES = {case.name: case for case in sphere.MODEL.cases}
RIM = 1e-4
HELD = 2 * sphere.DRY
NARROW = np.sqrt((1 + np.cos(np.radians(60)) ** 2 * np.cos(np.radians(110)) + 0.75) / 2)
"""Cosine of half the angle between the contacts of two rollers: their dot product by hand."""


@pytest.fixture(scope="module")
def runs() -> Any:
    """Recordings and summaries by the name of the case, each made once."""
    made: dict[str, tuple[Recording, Any]] = {}

    def run(name: str) -> tuple[Recording, Any]:
        if name not in made:
            case = CASES[name]
            recording = sphere.MODEL.simulate(case)
            made[name] = recording, sphere.MODEL.summarise(case, recording)
        return made[name]

    return run


def last_spin(recording: Recording) -> Any:
    return np.array([recording.columns[f"spin_{axis}"][-1] for axis in "xyz"])


def raised(elevation: float, phase: float) -> tuple[Any, Any, Any]:
    """Contacts, driven directions and speeds as the three-roller paper has them."""
    azimuths, up = np.radians([30, 150, 270]), np.array([0, 0, 1])
    level = np.array([np.cos(azimuths), np.sin(azimuths), 0 * azimuths]).T
    contacts = np.cos(np.radians(elevation)) * level + np.sin(np.radians(elevation)) * up
    speeds = np.sin(np.radians(phase + np.array([240, 120, 0])))
    return contacts, np.cross(contacts, np.cross(up, level)), speeds


def slips(spin: Any, contacts: Any, driven: Any, speeds: Any) -> Any:
    return np.linalg.norm(np.cross(spin, contacts) - speeds[:, None] * driven, axis=1)


def least_squares(contacts: Any, driven: Any, speeds: Any) -> Any:
    columns = np.array([np.cross(unit, contacts).ravel() for unit in np.eye(3)]).T
    return np.linalg.lstsq(columns, (speeds[:, None] * driven).ravel(), rcond=None)[0]


RAISED = [
    pytest.param(elevation, phase, id=f"elevation {elevation}, phase {phase}")
    for elevation in (10, 20, 30)
    for phase in (17, 55)
]


@pytest.mark.parametrize(("elevation", "phase"), RAISED)
def test_viscous_contacts_lead_three_rollers_to_least_squares(
    elevation: int, phase: int, runs: Any
) -> None:
    recording, summary = runs(f"three-{elevation}-{phase}-viscous")
    expected = least_squares(*raised(elevation, phase))
    np.testing.assert_allclose(last_spin(recording), expected, atol=RIM)
    radius = 1 / (1 + np.sin(np.radians(elevation)) ** 2)
    assert summary["circle_radius"] == pytest.approx(radius, abs=RIM)


@pytest.mark.parametrize(("elevation", "phase"), RAISED)
def test_dry_contacts_do_not(elevation: int, phase: int, runs: Any) -> None:
    """They hold one roller, by sqrt(3) sin(elevation) of the limit; the circle has radius 1."""
    recording, summary = runs(f"three-{elevation}-{phase}-dry")
    spin, setting = last_spin(recording), raised(elevation, phase)
    found = slips(spin, *setting)
    held = int(np.argmin(found))
    assert found[held] < sphere.DRY
    grips = [summary[f"grip_{number}"] for number in (1, 2, 3)]
    limit = np.sqrt(3) * np.sin(np.radians(elevation))
    expected = [limit if number == held else 1 for number in range(3)]
    np.testing.assert_allclose(grips, expected, atol=HELD)
    assert summary["circle_radius"] == pytest.approx(1, abs=HELD)
    away = np.linalg.norm(spin - least_squares(*setting))
    assert away > 20 * HELD
    assert away == pytest.approx(summary["error_least_squares"], abs=1e-6)


@pytest.mark.parametrize(("elevation", "phase"), RAISED)
def test_dry_contacts_lead_to_the_least_sum_of_slips(elevation: int, phase: int, runs: Any) -> None:
    """No spin nearby has a lesser sum, but for what the creep leaves."""
    recording, summary = runs(f"three-{elevation}-{phase}-dry")
    spin, setting = last_spin(recording), raised(elevation, phase)
    here = slips(spin, *setting).sum()
    for way in np.random.default_rng(6).normal(size=(200, 3)):
        for size in (0.003, 0.03, 0.3):
            moved = spin + size * way / np.linalg.norm(way)
            assert slips(moved, *setting).sum() > here - sphere.DRY
    assert summary["sum_of_slips"] == pytest.approx(here, abs=RIM)
    assert here == pytest.approx(summary["least_sum_of_slips"], abs=sphere.DRY)


@pytest.mark.parametrize("tilt", [0, 10, 20, 30])
def test_viscous_contacts_lead_two_rollers_to_the_midpoint(tilt: int, runs: Any) -> None:
    """Both slips are those that the two-roller paper computes: cos(beta/2) tan(alpha)."""
    recording, summary = runs(f"two-{tilt}-viscous")
    slip = NARROW * np.tan(np.radians(tilt))
    assert [summary["slip_1"], summary["slip_2"]] == pytest.approx([slip, slip], abs=RIM)
    np.testing.assert_allclose(last_spin(recording), [-1, 0, 0], atol=RIM)
    assert summary["error_least_squares"] < RIM


@pytest.mark.parametrize(
    ("name", "low", "high"),
    [
        pytest.param("two-30-dry", 0.499, 0.501, id="from rest: half-way, as both are mirrored"),
        pytest.param("two-30-dry-from-aside", 0.6, 0.9, id="from aside: farther out"),
        pytest.param("two-30-dry-from-far", 0.99, 1, id="from far: at the end"),
        pytest.param("two-10-dry-from-far", 0.99, 1, id="from far, lines nearer: at the end"),
    ],
)
def test_dry_contacts_leave_two_rollers_anywhere_between_the_lines(
    name: str, low: float, high: float, runs: Any
) -> None:
    _, summary = runs(name)
    assert low < summary["share"] <= high
    assert summary["error_dry"] < RIM
    assert summary["sum_of_slips"] == pytest.approx(summary["least_sum_of_slips"], abs=RIM)


EQUATOR = np.array([0.2, 0.5, 1.0])


def upward_slips(spin: Any) -> Any:
    """Slips along z at three contacts on the equator, of a level spin."""
    contacts, up, _ = raised(0, 0)
    return np.einsum("ij,ij->i", np.cross(spin, contacts), up) - EQUATOR


@pytest.mark.parametrize(
    ("name", "held"),
    [
        pytest.param("dry", 0, id="from rest: inside the triangle"),
        pytest.param("dry-from-aside", 0, id="turning, inside: it stays inside"),
        pytest.param("dry-from-far-0", 2, id="from beyond a corner: two rollers stick"),
        pytest.param("dry-from-far-60", 1, id="from beyond a side: one sticks"),
        pytest.param("dry-from-far-180", 1, id="from beyond another side: one sticks"),
    ],
)
def test_dry_contacts_on_the_equator_leave_a_triangle(name: str, held: int, runs: Any) -> None:
    """Level spins at which all slip one way: the sizes add up to what the speeds do."""
    recording, summary = runs(f"three-equator-{name}")
    spin = last_spin(recording)
    slips = upward_slips(spin)
    assert spin[2] == pytest.approx(0, abs=RIM)
    assert slips.max() < HELD
    assert (np.abs(slips) < HELD).sum() == held
    assert summary["error_dry"] < HELD
    assert summary["sum_of_slips"] == pytest.approx(EQUATOR.sum(), rel=RIM)
    assert summary["error_least_squares"] > 100 * HELD


def test_viscous_contacts_on_the_equator_lead_to_the_centre_of_the_triangle(runs: Any) -> None:
    recording, summary = runs("three-equator-viscous")
    mean = EQUATOR.mean()
    assert upward_slips(last_spin(recording)) == pytest.approx([-mean] * 3, abs=RIM)
    assert summary["error_least_squares"] < RIM


def test_lines_that_meet_leave_one_spin_from_anywhere(runs: Any) -> None:
    for name in ("two-0-viscous", "two-0-dry", "two-0-dry-from-far"):
        recording, summary = runs(name)
        np.testing.assert_allclose(last_spin(recording), [-1, 0, 0], atol=RIM)
        assert summary["sum_of_slips"] < RIM


def test_the_heavier_roller_sticks(runs: Any) -> None:
    """It bears what the other one asks for, 1/1.3 of its limit; the other one has all slip."""
    _, summary = runs("two-30-dry-heavier")
    assert summary["slip_1"] < HELD
    assert summary["grip_1"] == pytest.approx(1 / 1.3, abs=HELD)
    whole = 2 * NARROW * np.tan(np.radians(30))
    assert summary["slip_2"] == pytest.approx(whole, abs=HELD)


def test_the_dry_spin_is_approached_in_proportion_to_the_creep(runs: Any) -> None:
    """Below all other slips: the error over the creep is one number, within a tenth."""
    creeps = {"creep-30-mm": 0.03, "creep-10-mm": 0.01, "creep-3-mm": 0.003, "dry": 0.001}
    errors = [runs(f"three-30-17-{name}")[1]["error_dry"] for name in creeps]
    ratios = np.array(errors) / list(creeps.values())
    np.testing.assert_allclose(ratios, ratios.mean(), rtol=0.1)
    above = [runs(f"three-30-17-{name}")[1]["error_dry"] for name in ("viscous", "creep-300-mm")]
    assert above[0] > above[1] > errors[0]


def test_the_steady_spin_depends_on_no_step(runs: Any) -> None:
    names = ("dry", "dry-step-500-us", "dry-step-250-us")
    spins = [last_spin(runs(f"three-30-17-{name}")[0]) for name in names]
    np.testing.assert_allclose(spins, [spins[0]] * 3, atol=1e-8)


def test_what_is_left_of_the_viscous_error_is_the_depth_of_the_contacts(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Depth goes with the square of the contacts' time constant, and so does the error."""
    case = CASES["three-30-17-viscous"]
    errors = []
    for settle in (0.005, 0.01, 0.02):
        monkeypatch.setattr(sphere_model, "SETTLE", settle)
        recording = sphere.MODEL.simulate(case)
        errors.append(sphere.MODEL.summarise(case, recording)["error_least_squares"])
    np.testing.assert_allclose(errors, errors[0] * np.array([1, 4, 16]), rtol=0.1)


def test_rollers_start_as_deep_as_their_loads_press_them(runs: Any) -> None:
    """From the first row after the start, where nothing presses yet: so no roller flies off."""
    recording, _ = runs("two-20-viscous")
    for number in (1, 2):
        np.testing.assert_allclose(recording.columns[f"load_{number}"][1:], LOAD, rtol=1e-4)


def test_contacts_bear_their_loads_and_slip_as_rim_and_sphere_do(runs: Any) -> None:
    """What MuJoCo says about its contacts, against the spin and the speeds asked for."""
    recording, summary = runs("three-20-55-viscous")
    expected = slips(last_spin(recording), *raised(20, 55))
    found = [summary[f"slip_{number}"] for number in (1, 2, 3)]
    np.testing.assert_allclose(found, expected, atol=RIM)
    loads = [recording.columns[f"load_{number}"][-1] for number in (1, 2, 3)]
    np.testing.assert_allclose(loads, LOAD, rtol=1e-6)
    # Viscous: friction over its limit is slip over creep.
    grips = [summary[f"grip_{number}"] for number in (1, 2, 3)]
    np.testing.assert_allclose(grips, np.array(found) / sphere.VISCOUS, atol=1e-5)


def changed(name: str, **parameters: float) -> Any:
    case = CASES[name]
    return replace(case, parameters={**case.parameters, **parameters})


@pytest.mark.parametrize(
    ("parameters", "reason"),
    [
        pytest.param({"step": 0.002}, "the spin changes by", id="step too long: rollers bounce"),
        pytest.param({"step": 0.02}, "more than", id="step far too long"),
        pytest.param({"start": 1000.0}, "more than", id="a start out of all bounds"),
    ],
)
def test_an_implausible_run_raises_with_what_reproduces_it(
    parameters: dict[str, float], reason: str
) -> None:
    with pytest.raises(ImplausibleRunError, match=reason) as failure:
        sphere.MODEL.simulate(changed("three-20-17-dry", **parameters))
    for name, value in parameters.items():
        assert f"{name}={value}" in str(failure.value)


def test_a_load_that_is_not_borne_raises(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sphere, "BORNE", -1.0)
    with pytest.raises(ImplausibleRunError, match=r"roller 1 bears 2 N at last instead of 2 N"):
        sphere.MODEL.simulate(CASES["three-20-17-dry"])


def test_cases_have_names_of_their_own_and_quantities_have_units(runs: Any) -> None:
    assert len(CASES) == len(sphere.MODEL.cases)
    assert all(re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", name) for name in CASES)
    for name in ("three-10-17-dry", "two-20-viscous", "three-equator-dry"):
        assert set(runs(name)[1]) <= set(sphere.MODEL.units)


@pytest.mark.parametrize(
    ("name", "parameters", "message"),
    [
        pytest.param(
            "three-20-17-dry",
            {"elevation_deg": 36.0},
            "expected an elevation from 0 to 35.26 degrees, got 36.0",
            id="no dry spin is known",
        ),
        pytest.param(
            "two-30-dry-heavier",
            {"heavier": 0.5},
            "expected roller 1 to bear the greater load, got 0.5 of roller 2's",
            id="the other roller would stick",
        ),
        pytest.param(
            "three-equator-dry",
            {"speeds": "1 -1 0"},
            "expected three speeds that do not add up to zero, got '1 -1 0'",
            id="the triangle is a point",
        ),
        pytest.param(
            "two-30-dry", {"creep": 0.0}, "expected a positive creep, got 0.0 m/s", id="no creep"
        ),
    ],
)
def test_parameters_out_of_range_are_refused(
    name: str, parameters: dict[str, float], message: str
) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        sphere.MODEL.simulate(changed(name, **parameters))


def test_the_least_sum_of_slips_of_two_rollers_by_hand() -> None:
    """The difference of the heights of both lines, at each spin between them."""
    setting = two_rollers(20)
    whole = 2 * NARROW * np.tan(np.radians(20))
    first, last = setting.dry_corners
    for share in (0, 0.3, 1):
        spin = first + share * (last - first)
        assert setting.slips(spin).sum() == pytest.approx(whole)
        nearest, found = setting.nearest_dry(spin)
        np.testing.assert_allclose(nearest, spin, atol=1e-12)
        assert found == pytest.approx((1 - share, share))
    beyond, shares = setting.nearest_dry(2 * last - first)
    np.testing.assert_allclose(beyond, last, atol=1e-12)
    assert shares == (0, 1)


def test_three_raised_rollers_by_hand() -> None:
    """At 30 degrees and phase 90, V = (1, 0): roller 3 has the middle value of V.h, zero."""
    setting = three_rollers(30, 90)
    np.testing.assert_allclose(setting.least_squares, [-0.8, 0, 0], atol=1e-12)
    dry, shares = setting.nearest_dry(np.zeros(3))
    np.testing.assert_allclose(dry, [-1, 0, 0], atol=1e-12)
    assert shares == (1,)
    # The outer two slip by sin(30) cos(30).
    np.testing.assert_allclose(setting.slips(dry), [np.sqrt(3) / 4] * 2 + [0], atol=1e-12)


def test_the_triangle_on_the_equator_by_hand() -> None:
    """Equal speeds: corners at twice the distance of the sides, which are 1 rad/s from the middle.

    Slip k is none where spin is 1 across the contact k, at azimuths 30, 150, 270 degrees less 90.
    """
    setting = equator_rollers("1 1 1")
    azimuths = sorted(
        np.degrees(np.arctan2(*corner[1::-1])) % 360 for corner in setting.dry_corners
    )
    assert np.linalg.norm(setting.dry_corners, axis=1) == pytest.approx([2, 2, 2])
    assert azimuths == pytest.approx([0, 120, 240])
    nearest, shares = setting.nearest_dry(np.array([0.1, 0.2, 5]))
    assert nearest == pytest.approx([0.1, 0.2, 0])
    assert min(shares) > 0
    beyond, shares = setting.nearest_dry(np.array([-7, 0.3, 0]))
    assert beyond == pytest.approx([-1, 0.3, 0])
    assert sorted(shares)[0] == 0
