"""Zonotopes against brute force over all corners of the cube, and against cases known by hand."""

from __future__ import annotations

from itertools import pairwise, product
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from in_floats import floats
from sympy import Matrix, Rational, diag, pi, sqrt

from omniproof.kinematics import zonotope
from omniproof.kinematics.omni import twist_matrix, velocity_matrix

QUICK = settings(deadline=None, max_examples=25)
ENTRY = st.fractions(min_value=-3, max_value=3, max_denominator=4).map(Rational)


def generators(rows: int, least: int, most: int) -> Any:
    return st.integers(least, most).flatmap(
        lambda n: st.lists(ENTRY, min_size=rows * n, max_size=rows * n).map(
            lambda entries: Matrix(rows, n, entries)
        )
    )


def corners(columns: Any, bound: float = 1.0) -> Any:
    signs = np.array(list(product((-bound, bound), repeat=columns.shape[1])))
    return signs @ columns.T


def shoelace(polygon: Any) -> float:
    x, y = polygon.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def wrapped_area(columns: Any) -> Any:
    """Exact area of the hull of all corners, by gift wrapping."""
    points = {tuple(columns * Matrix(signs)) for signs in product((-1, 1), repeat=columns.shape[1])}
    hull = [min(points)]
    while len(hull) == 1 or hull[-1] != hull[0]:
        best = next(iter(points - {hull[-1]}))
        for point in points - {hull[-1]}:
            ahead, beside = Matrix(best) - Matrix(hull[-1]), Matrix(point) - Matrix(hull[-1])
            turn = ahead[0] * beside[1] - ahead[1] * beside[0]
            if turn < 0 or (turn == 0 and beside.dot(beside) > ahead.dot(ahead)):
                best = point
        hull.append(best)
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in pairwise(hull)) / 2


@settings(QUICK, max_examples=10)
@given(generators(2, 2, 4))
def test_area_equals_the_hull_of_all_corners(columns: Any) -> None:
    assume(any(columns))
    assert zonotope.volume(columns) == wrapped_area(columns)


@QUICK
@given(generators(2, 2, 5))
def test_polygon_runs_counter_clockwise_around_all_corners(columns: Any) -> None:
    assume(zonotope.volume(columns) > 0)
    polygon = zonotope.vertices(floats(columns))
    assert shoelace(polygon) == pytest.approx(float(zonotope.volume(columns)), rel=1e-9)
    for start, end in pairwise([*polygon, polygon[0]]):
        to_corners = corners(floats(columns)) - start
        edge = end - start
        assert (edge[0] * to_corners[:, 1] - edge[1] * to_corners[:, 0] >= -1e-9).all()


@QUICK
@given(generators(3, 3, 5))
def test_faces_bound_all_corners_and_enclose_the_volume(columns: Any) -> None:
    """Divergence theorem: the volume is a third of the sum of height times area of the faces."""
    numeric = floats(columns)
    assume(zonotope.volume(columns) > 0)
    enclosed = 0.0
    for face in zonotope.faces(numeric):
        fan = np.array([np.cross(b - face[0], c - face[0]) for b, c in pairwise(face[1:])])
        area = fan.sum(axis=0) / 2
        heights = corners(numeric) @ area
        assert heights.max() == pytest.approx(face[0] @ area)
        enclosed += float(face[0] @ area) / 3
    assert enclosed == pytest.approx(float(zonotope.volume(columns)))


@pytest.mark.parametrize(
    ("columns", "bound", "expected"),
    [
        pytest.param(diag(1, 1, 1), 1, 8, id="the cube itself"),
        pytest.param(diag(1, 2, 3), 2, 384, id="a brick, bound 2"),
        pytest.param(Matrix([[1, 0, 1], [0, 1, 1]]), 1, 12, id="hexagon of three unit dets"),
        pytest.param(Matrix([[1, 2], [1, 2]]), 1, 0, id="parallel generators"),
    ],
)
def test_volume_by_hand(columns: Any, bound: int, expected: int) -> None:
    assert zonotope.volume(columns, bound) == expected


@QUICK
@given(generators(3, 1, 5))
def test_half_widths_are_the_greatest_coordinates(columns: Any) -> None:
    greatest = corners(floats(columns), 2).max(axis=0)
    widths = [float(width) for width in zonotope.half_widths(columns, 2)]
    np.testing.assert_allclose(widths, greatest, atol=1e-9)


def test_projection_drops_an_axis() -> None:
    columns = Matrix([[1, 2], [3, 4], [5, 6]])
    assert zonotope.projection(columns) == Matrix([[1, 2], [3, 4]])
    assert zonotope.projection(columns, (2, 0)) == Matrix([[5, 6], [1, 2]])


def test_vertices_of_the_cube_are_its_corners() -> None:
    found = {tuple(corner) for corner in zonotope.vertices(np.eye(3), 2.0)}
    assert found == set(product((-2.0, 2.0), repeat=3))


def test_coplanar_generators_give_one_face_with_six_corners() -> None:
    hexagonal_prism = np.array([[1, 0, 1, 0], [0, 1, 1, 0], [0, 0, 0, 1]], dtype=float)
    sizes = sorted(len(face) for face in zonotope.faces(hexagonal_prism))
    assert sizes == [4, 4, 4, 4, 4, 4, 6, 6]
    assert len(zonotope.vertices(hexagonal_prism)) == 12


ARRANGEMENTS = [
    pytest.param([pi / 6, 5 * pi / 6, 3 * pi / 2], 2 * sqrt(3), id="equilateral"),
    pytest.param([0, pi, 3 * pi / 2], 4, id="right-angled: wheels 1 and 2 ask the same of V_y"),
    pytest.param([0, pi / 2, pi, 3 * pi / 2], 4, id="four wheels"),
]


@pytest.mark.parametrize(("angles", "area"), ARRANGEMENTS)
def test_section_touches_exactly_two_limits_at_each_corner(angles: Any, area: Any) -> None:
    matrix = velocity_matrix(angles)
    polygon = zonotope.section(matrix)
    for corner in polygon:
        speeds = matrix[:, :2] * corner
        assert all(abs(speed) <= 1 for speed in speeds)
        tight = {
            frozenset((tuple(row), tuple(-row))) for row, speed in rows_at_limit(matrix, speeds)
        }
        assert len(tight) == 2
    assert zonotope.polygon_area(polygon) == area
    directions = [np.arctan2(float(corner[1]), float(corner[0])) for corner in polygon]
    assert directions == sorted(directions)


def rows_at_limit(matrix: Any, speeds: Any) -> Any:
    return [(matrix[k, :2], speed) for k, speed in enumerate(speeds) if (abs(speed) - 1).equals(0)]


def test_section_of_parallel_directions_is_unbounded() -> None:
    matrix = velocity_matrix([0, 1, 2], directions=[0, 0, pi])
    with pytest.raises(ValueError, match="unbounded"):
        zonotope.section(matrix)


@QUICK
@given(generators(3, 3, 5), st.floats(0.01, 5))
def test_bounded_projection_holds_what_it_should(columns: Any, limit: float) -> None:
    """The clipped body projects into the polygon; without a limit it is the whole projection."""
    numeric = floats(columns)
    assume(zonotope.volume(columns) > 0)
    whole = float(zonotope.volume(zonotope.projection(columns)))
    polygon = zonotope.bounded_projection(numeric, limit)
    assert 0 < shoelace(polygon) <= whole * (1 + 1e-9)
    samples = np.random.default_rng(1).uniform(-1, 1, (200, numeric.shape[1])) @ numeric.T
    inside = samples[np.abs(samples[:, 2]) <= limit][:, :2]
    for start, end in pairwise([*polygon, polygon[0]]):
        edge, rest = end - start, inside - start
        assert (edge[0] * rest[:, 1] - edge[1] * rest[:, 0] >= -1e-8).all()
    everything = zonotope.bounded_projection(numeric, 1e3)
    assert shoelace(everything) == pytest.approx(whole, rel=1e-6)


def test_bounded_projection_tends_to_the_section() -> None:
    matrix = velocity_matrix([pi / 6, 5 * pi / 6, 3 * pi / 2])
    polygon = zonotope.bounded_projection(floats(twist_matrix(matrix)), 1e-9)
    assert shoelace(polygon) == pytest.approx(2 * 3**0.5, rel=1e-6)


REFUSED = [
    pytest.param(lambda: zonotope.volume(Matrix([[1], [2]])), "at least 2", id="too few columns"),
    pytest.param(lambda: zonotope.vertices(np.ones((4, 4))), "2 or 3", id="four dimensions"),
    pytest.param(lambda: zonotope.faces(np.ones((3, 3))), "one plane", id="flat in space"),
    pytest.param(lambda: zonotope.vertices(np.ones((2, 2))), "parallel", id="flat in the plane"),
    pytest.param(lambda: zonotope.bounded_projection(np.eye(3), 0), "positive", id="no limit"),
]


@pytest.mark.parametrize(("call", "message"), REFUSED)
def test_wrong_input_is_refused(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()
