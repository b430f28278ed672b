"""N rollers on a sphere against NumPy's least squares in floats, and cases by hand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from in_floats import floats
from sympy import Matrix, Rational, diag, eye, pi, simplify, sin, sqrt, symbols, zeros

from omniproof.kinematics import rolling, sphere

QUICK = settings(deadline=None, max_examples=25)
R = symbols("r", positive=True)
A, B, PSI, NU = symbols("a b psi nu", real=True)
W = Matrix(symbols("w_x:z", real=True))
NUMBER = st.fractions(min_value=-2, max_value=2, max_denominator=8).map(Rational)
ROLLERS = st.lists(st.tuples(NUMBER, NUMBER, NUMBER, NUMBER), min_size=2, max_size=5)
EAST, NORTH, UP = (Matrix(eye(3)[:, k]) for k in range(3))


def placed(azimuth: Any, elevation: Any, angle: Any) -> tuple[Any, Any]:
    """Contact and axis of a roller."""
    base = sphere.tangent_base(azimuth, elevation)
    return sphere.contact_direction(azimuth, elevation), sphere.roller_axis(*base, angle)


def setting(rollers: Any) -> tuple[Any, Any, Any]:
    """Contacts, axes and speeds of rollers (azimuth, elevation, angle, speed)."""
    places = [placed(*roller[:3]) for roller in rollers]
    return [p for p, _ in places], [eta for _, eta in places], [roller[3] for roller in rollers]


def by_hand(azimuth: float, elevation: float, angle: float) -> tuple[Any, Any]:
    """Contact and axis in floats: the x-axis and a turned y-axis, carried by two rotations."""
    c, s = math.cos(azimuth), math.sin(azimuth)
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    c, s = math.cos(elevation), math.sin(elevation)
    about_y = np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])
    carried = about_z @ about_y
    return carried @ [1, 0, 0], carried @ [0, math.cos(angle), math.sin(angle)]


def slip_in_floats(spin: Any, roller: Any, radius: float) -> Any:
    contact, axis = by_hand(*map(float, roller[:3]))
    return np.cross(spin, radius * contact) - float(roller[3]) * np.cross(contact, axis)


def spin_in_floats(rollers: Any, radius: float) -> Any:
    """NumPy's least squares on all 3N components of slip."""
    still = np.concatenate([slip_in_floats(np.zeros(3), roller, radius) for roller in rollers])
    columns = [
        np.concatenate([slip_in_floats(unit, roller, radius) for roller in rollers]) - still
        for unit in np.eye(3)
    ]
    return np.linalg.lstsq(np.array(columns).T, -still, rcond=None)[0]


def well_placed(rollers: Any) -> bool:
    """Whether two contacts are well apart from one line through the centre."""
    contacts = [by_hand(*map(float, roller[:3]))[0] for roller in rollers]
    total = sum(np.eye(3) - np.outer(p, p) for p in contacts)
    return bool(np.linalg.det(total) > 1e-3)


@QUICK
@given(azimuth=NUMBER, elevation=NUMBER, angle=NUMBER)
def test_a_placed_roller_is_a_carried_one(azimuth: Any, elevation: Any, angle: Any) -> None:
    found = [floats(vector).ravel() for vector in placed(azimuth, elevation, angle)]
    expected = by_hand(float(azimuth), float(elevation), float(angle))
    np.testing.assert_allclose(found, expected, atol=1e-12)


@QUICK
@given(rollers=ROLLERS, radius=st.sampled_from([Rational(1, 2), Rational(1), Rational(3)]))
def test_spin_is_that_of_least_squares(rollers: Any, radius: Any) -> None:
    contacts, axes, speeds = setting(rollers)
    if not well_placed(rollers):
        return
    found = sphere.least_squares_spin(contacts, axes, speeds, radius)
    np.testing.assert_allclose(
        floats(found).ravel(), spin_in_floats(rollers, float(radius)), atol=1e-8
    )
    mapped = sphere.spin_map(contacts, axes, radius) * Matrix(speeds)
    np.testing.assert_allclose(floats(mapped), floats(found), atol=1e-10)


@QUICK
@given(rollers=ROLLERS, spin=st.tuples(NUMBER, NUMBER, NUMBER))
def test_distance_is_slip_over_radius(rollers: Any, spin: Any) -> None:
    """Distance from a point to a line by its own formula, |(x - foot) x direction|."""
    contacts, axes, speeds = setting(rollers)
    squares = sphere.squared_distances(Matrix(spin), contacts, axes, speeds, 2)
    place = np.array([float(part) for part in spin])
    for p, eta, speed, roller, square in zip(contacts, axes, speeds, rollers, squares, strict=True):
        foot, direction = (floats(v).ravel() for v in sphere.constraint_line(p, eta, speed, 2))
        distance = np.linalg.norm(np.cross(place - foot, direction))
        slip = slip_in_floats(place, roller, 2.0)
        assert math.sqrt(float(square)) == pytest.approx(distance, abs=1e-9)
        assert distance == pytest.approx(np.linalg.norm(slip) / 2, abs=1e-9)
        found = sphere.slip_velocity(Matrix(spin), p, eta, speed, 2)
        np.testing.assert_allclose(floats(found).ravel(), slip, atol=1e-9)


@pytest.mark.parametrize(
    ("azimuth", "elevation", "angle", "contact", "axis", "driven"),
    [
        pytest.param(0, 0, 0, EAST, NORTH, UP, id="on x, axis level: drives up"),
        pytest.param(0, 0, pi / 2, EAST, UP, -NORTH, id="on x, axis up: drives sideways"),
        pytest.param(pi / 2, 0, 0, NORTH, -EAST, UP, id="on y"),
        pytest.param(0, pi / 2, 0, UP, NORTH, -EAST, id="on top"),
    ],
)
def test_directions_by_hand(
    azimuth: Any, elevation: Any, angle: Any, contact: Any, axis: Any, driven: Any
) -> None:
    p, eta = placed(azimuth, elevation, angle)
    assert (Matrix(p), Matrix(eta)) == (contact, axis)
    assert Matrix(sphere.driven_direction(p, eta)) == driven


def test_surface_of_a_spinning_sphere_moves_as_a_cross_product() -> None:
    p = Matrix(symbols("p_x:z", real=True))
    assert Matrix(sphere.surface_map(p) * W) == W.cross(p)
    assert sphere.surface_map(p) * p == zeros(3, 1)


def test_foot_of_a_line_is_the_axis_at_minus_the_rate() -> None:
    p, eta = placed(A, B, PSI)
    foot, direction = sphere.constraint_line(p, eta, NU, R)
    assert (foot + NU / R * eta).applyfunc(simplify) == zeros(3, 1)
    assert direction == p


def test_normal_matrix_by_hand() -> None:
    assert sphere.normal_matrix([EAST]) == diag(0, 1, 1)
    assert sphere.normal_matrix([EAST, NORTH, UP, -UP]) == diag(3, 3, 2)


def test_two_crossed_rollers_by_hand() -> None:
    """On x and y, axes up, speeds a and b: both ask for a spin about z, -a/r and -b/r; the mean."""
    speeds = symbols("a b", real=True)
    spin = sphere.least_squares_spin([EAST, NORTH], [UP, UP], speeds, R)
    assert spin.applyfunc(simplify) == Matrix([0, 0, -(speeds[0] + speeds[1]) / (2 * R)])


def test_level_axes_on_the_equator_do_not_slip_if_the_speeds_add_up_to_zero() -> None:
    """Regular triangle, speeds -cos: each contact is driven up at the speed of one tilting spin."""
    places = [placed(2 * k * pi / 3, 0, 0) for k in range(3)]
    contacts, axes = [p for p, _ in places], [eta for _, eta in places]
    tilting = Matrix([0, -1, 0])
    speeds = [p[0] * R for p in contacts]
    assert sphere.least_squares_spin(contacts, axes, speeds, R) == tilting
    assert set(sphere.squared_distances(tilting, contacts, axes, speeds, R)) == {0}
    equal = sphere.least_squares_spin(contacts, axes, [1, 1, 1], R)
    assert equal == zeros(3, 1)
    assert sphere.squared_distances(equal, contacts, axes, [1, 1, 1], R) == (R**-2,) * 3


@pytest.mark.parametrize(
    "contacts",
    [
        pytest.param([UP], id="one"),
        pytest.param([UP, -UP], id="opposite"),
        pytest.param([sphere.contact_direction(A, B)] * 2, id="twice one, anywhere"),
    ],
)
def test_contacts_on_one_line_are_refused(contacts: Any) -> None:
    axes = [NORTH] * len(contacts)
    with pytest.raises(ValueError, match="the contacts lie on one line through the centre"):
        sphere.least_squares_spin(contacts, axes, [1] * len(contacts), 1)


def test_numbers_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueError, match="got 2 contacts, 1 axes, 2 speeds"):
        sphere.least_squares_spin([EAST, NORTH], [UP], [1, 2], 1)
    with pytest.raises(ValueError, match="got 0"):
        sphere.normal_matrix([])


def test_all_of_it_rests_on_the_rolling_constraint(monkeypatch: pytest.MonkeyPatch) -> None:
    """Under another constraint (speeds count twice) map, feet, matrix and slip are others."""
    right = rolling.rolling_speed
    (p, eta), (q, zeta) = placed(A, B, PSI), placed(0, 0, 0)
    monkeypatch.setattr(rolling, "rolling_speed", lambda *bodies: 2 * right(*bodies))
    assert Matrix(sphere.surface_map(EAST) * W) == 2 * W.cross(EAST)
    assert sphere.normal_matrix([EAST]) == diag(0, 4, 4)
    assert sphere.constraint_line(q, zeta, NU, R)[0] == Matrix([0, -2 * NU / R, 0])
    assert sphere.slip_velocity(UP, q, zeta, 0, 1) == 2 * NORTH
    changed = sphere.right_side([p, q], [eta, zeta], [NU, NU], R)
    monkeypatch.undo()
    assert changed != sphere.right_side([p, q], [eta, zeta], [NU, NU], R)


def test_a_symmetric_pair_in_closed_form() -> None:
    """Contacts at +-b from x in the xy-plane, axes level: by hand from the two line equations."""
    speeds = symbols("mu lambda", real=True)
    b = symbols("b", positive=True)
    places = [placed(b, 0, 0), placed(-b, 0, 0)]
    spin = sphere.least_squares_spin([p for p, _ in places], [q for _, q in places], speeds, 1)
    assert simplify(spin[0] - (speeds[0] - speeds[1]) / (2 * sin(b))) == 0
    half = spin.subs(b, pi / 4).applyfunc(simplify)
    expected = Matrix([speeds[0] - speeds[1], -speeds[0] - speeds[1], 0]) / sqrt(2)
    assert (half - expected).applyfunc(simplify) == zeros(3, 1)
