"""Measures of paths, by hand."""

import math

import numpy as np
import pytest

from omniproof.simulation.measures import (
    angle_between,
    circle,
    first_direction,
    length_error,
    mean_error,
    path_length,
    seen_from_start,
)


def arc(turn, radius=2.0, start=0.0):
    """Return an arc that begins in the origin in a direction and turns left by `turn`."""
    angles = np.linspace(0, turn, 101)
    places = radius * np.column_stack([np.sin(angles), 1 - np.cos(angles)])
    return places @ [[np.cos(start), np.sin(start)], [-np.sin(start), np.cos(start)]]


STAIRS = np.array([[0, 0], [3, 0], [3, 4]], float)


def test_length():
    assert path_length(STAIRS) == 7
    assert length_error(STAIRS, 1.25 * STAIRS) == pytest.approx(0.25)
    assert length_error(1.25 * STAIRS, STAIRS) == pytest.approx(0.2)


def test_mean_error_of_another_scale_is_constant():
    time = np.array([0, 0.5, 2])
    assert mean_error(time, STAIRS, 1.25 * STAIRS) == pytest.approx(0.25)


def test_mean_error_is_weighed_by_time():
    """Relative distances: 1 at time 1, taken for time 0 too, and 0 at time 3."""
    line = np.array([[0, 0], [1, 0], [3, 0]], float)
    late = np.array([[0, 0], [0, 0], [3, 0]], float)
    assert mean_error(np.array([0.0, 1, 3]), line, late) == pytest.approx((1 + 1) / 3)


def test_circle():
    centre, radius = circle(arc(1.2))
    assert centre == pytest.approx([0, 2])
    assert radius == pytest.approx(2)


@pytest.mark.parametrize("turn", [-2.0, 0.5, 3.0])
def test_first_direction_of_an_arc(turn):
    path = arc(abs(turn)) * [1, np.sign(turn)] @ [[0.6, 0.8], [-0.8, 0.6]]
    assert first_direction(path, turn) == pytest.approx(math.atan2(0.8, 0.6))


def test_angle_between_goes_the_short_way():
    assert angle_between(math.radians(175), math.radians(-175)) == pytest.approx(math.radians(10))


def test_seen_from_start():
    """Facing up from (1, 1), what lies above is ahead, and what lies to the left is left."""
    heading = np.array([math.pi / 2, 3.1, -3.1])
    seen = seen_from_start(np.array([1.0, 1, 0]), np.array([1.0, 2, 2]), heading)
    assert seen[:, :2] == pytest.approx(np.array([[0, 0], [1, 0], [1, 1]]), abs=1e-12)
    assert seen[:, 2] == pytest.approx([0, 3.1 - math.pi / 2, 2 * math.pi - 3.1 - math.pi / 2])
