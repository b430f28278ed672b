"""Numbers read off a path: its length, its distance from another one, its radius, its direction."""

from __future__ import annotations

from math import atan2, cos, sin

import numpy as np


def path_length(path: np.ndarray) -> float:
    """Return the length (m) of a path (n, 2) of places (m), as the polygon through them."""
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


def length_error(theory: np.ndarray, experiment: np.ndarray) -> float:
    """Return |1 - L_e / L_m| of two paths (n, 2): the error in the text of omni-trajectory, 3.2."""
    return abs(1 - path_length(experiment) / path_length(theory))


def mean_error(time: np.ndarray, theory: np.ndarray, experiment: np.ndarray) -> float:
    """Return the mean over `time` (n,) of the distance of two paths, relative to the theory's.

    Source: omni-trajectory, Eq. (17), by trapezoids. Both paths begin in the origin, where the
    integrand is 0/0; it is given the value of the next instant there, which is its limit for an
    experiment that starts with a speed, and close to it (it is 1) for one that starts from rest.
    """
    distance = np.linalg.norm(theory - experiment, axis=1)[1:]
    relative = distance / np.linalg.norm(theory, axis=1)[1:]
    integrand = np.concatenate([relative[:1], relative])
    return float(np.trapezoid(integrand, time) / (time[-1] - time[0]))


def circle(path: np.ndarray) -> tuple[np.ndarray, float]:
    """Return centre (2,) and radius (m) of the circle through a path (n, 2), by least squares.

    Source: I. Kåsa, A circle fitting procedure and its error analysis (1976): linear in the centre
    and in the power of the origin.
    """
    matrix = np.column_stack([2 * path, np.ones(len(path))])
    x, y, power = np.linalg.lstsq(matrix, (path**2).sum(axis=1), rcond=None)[0]
    return np.array([x, y]), float(np.sqrt(power + x**2 + y**2))


def first_direction(path: np.ndarray, turn: float) -> float:
    """Return the direction (rad) in which a path (n, 2) begins that turns by `turn` (rad) in all.

    That of the chord, less half of the turn: exact for an arc, and less noisy than a first step.
    """
    x, y = path[-1] - path[0]
    return atan2(y, x) - turn / 2


def angle_between(one: float, other: float) -> float:
    """Return the angle (rad, from 0 to pi) between two directions (rad)."""
    return abs(atan2(sin(one - other), cos(one - other)))


def seen_from_start(x: np.ndarray, y: np.ndarray, heading: np.ndarray) -> np.ndarray:
    """Return places (n, 2) and heading, unwound, in the frame of the first pose: (n, 3)."""
    turn = heading[0]
    frame = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    places = (np.column_stack([x, y]) - [x[0], y[0]]) @ frame.T
    return np.column_stack([places, np.unwrap(heading) - turn])
