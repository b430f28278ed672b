"""ballbot: derivations against plain numbers, and against another mechanics."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
from altered import changed, functions, longer_lever
from at_points import Point, digits, random_point, same, uncompared
from by_hand import cross
from mpmath import cos, eye, inverse, matrix, mpf, pi, sin

from omniproof.papers.ballbot.derivations import REGISTRY
from omniproof.registry import Modelled
from omniproof.transcription.loader import load_paper
from omniproof.transcription.model import Kind

SEEDS = (1, 2, 3)
Vector = list[Any]

# Plain numbers: matrices multiplied out, and bodies that move


def turned(axis: str, angle: mpf) -> matrix:
    """Rotation about an axis, as the textbooks print it."""
    c, s = cos(angle), sin(angle)
    blocks = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    found = eye(4)
    found[:3, :3] = matrix(blocks[axis])
    return found


def moved(x: mpf, y: mpf, z: mpf) -> matrix:
    found = eye(4)
    found[:3, 3] = matrix([x, y, z])
    return found


def wheel(k: int, p: Point) -> matrix:
    azimuth = {1: pi, 2: -pi / 3, 3: pi / 3}[k]
    return turned("z", azimuth) * turned("y", -p["phi"]) * moved(0, 0, -p["L"])


def pose(p: Point) -> matrix:
    turns = turned("z", p["psi"]) * turned("y", p["theta"]) * turned("x", p["chi"])
    return moved(p["p_x"], p["p_y"], p["p_z"]) * turns


def small(p: Point, frame: str = "") -> matrix:
    """Small motion as a matrix: each of its columns is how a unit vector, or the origin, moves."""
    turn, shift = vector(p, "delta", frame), vector(p, "d", frame)
    units = [[mpf(i == k) for i in range(3)] for k in range(3)]
    columns = [[*cross(turn, unit), 0] for unit in units] + [[*shift, 0]]
    return matrix(columns).T


def vector(p: Point, letter: str, frame: str = "") -> Vector:
    return [p[f"{letter}_{axis}{frame}"] for axis in "xyz"]


def column(of: matrix, k: int) -> Vector:
    return [of[i, k] for i in range(3)]


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def added(a: Sequence[Any], b: Sequence[Any]) -> Vector:
    return [x + y for x, y in zip(a, b, strict=True)]


def free(p: Point) -> list[Vector]:
    return [[p[f"{letter}_{axis}"] for axis in "xyz"] for letter in "noap"]


def along(turn: Vector, shift: Vector, columns: Sequence[Vector]) -> tuple[Vector, Vector]:
    """Rotation, and velocity of the point at the last column, along the first three."""
    velocity = added(cross(turn, columns[3]), shift)
    return [dot(turn, c) for c in columns[:3]], [dot(velocity, c) for c in columns[:3]]


def at_wheel(p: Point, part: int) -> Vector:
    turn, shift = [mpf(0), mpf(0), p["delta_z_B"]], [p["d_x_B"], p["d_y_B"], mpf(0)]
    return along(turn, shift, [column(wheel(1, p), k) for k in range(4)])[part]


MOTION = ("v_x", "v_y", "omega_z")


def speed(k: int, p: Point, motion: Sequence[Any], moving: bool) -> Any:
    """Speed of wheel k: platform less ball, both at the contact, along the wheel.

    The ball's contact with the ground is at rest: v + W x (0, 0, -L) = 0.
    """
    v_x, v_y, yaw_rate = motion
    contact, driven = column(wheel(k, p), 3), column(wheel(k, p), 1)
    platform = added([v_x, v_y, 0], cross([0, 0, yaw_rate], contact))
    rolls = [-v_y / p["L"], v_x / p["L"], mpf(0)]
    ball = added([v_x, v_y, 0], cross(rolls, contact)) if moving else [0, 0, 0]
    return dot(driven, platform) - dot(driven, ball)


def law(p: Point, moving: bool = True) -> matrix:
    units = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    return matrix([[speed(k, p, unit, moving) for unit in units] for k in (1, 2, 3)])


def at(p: Point) -> Vector:
    return [p[name] for name in MOTION]


FORMULAS: dict[str, Callable[[Point], Any]] = {
    "eq:1": lambda p: inverse(pose(p)) * small(p, "_B") * pose(p),
    "eq:2": small,
    "sec:2/rotational": lambda p: vector(p, "delta"),
    "sec:2/translational": lambda p: vector(p, "d"),
    "eq:4-1": lambda p: along(vector(p, "delta", "_B"), vector(p, "d", "_B"), free(p))[0],
    "eq:4-2": lambda p: along(vector(p, "delta", "_B"), vector(p, "d", "_B"), free(p))[1],
    **{f"eq:5-{k}": (lambda p, k=k: wheel(k, p)) for k in (1, 2, 3)},
    "sec:4/sine": lambda p: sin(p["phi"]),
    "sec:4/cosine": lambda p: cos(p["phi"]),
    "eq:6-1": lambda p: at_wheel(p, 0),
    "eq:6-2": lambda p: at_wheel(p, 1),
    **{f"eq:{k + 6}": (lambda p, k=k: speed(k, p, at(p), moving=True)) for k in (1, 2, 3)},
    "eq:10": law,
    "eq:10/twist": at,
    "eq:10/wheel-speeds": lambda p: [speed(k, p, at(p), moving=True) for k in (1, 2, 3)],
    "eq:10/inverse": lambda p: inverse(law(p)),
    "sec:3/spacing": lambda p: mpf(120),
    "sec:1/three-wheels": lambda p: mpf(3),
}  # fmt: skip
BY_PREMISE: dict[str, Callable[[Point], Any]] = {
    **{f"eq:{k + 6}": (lambda p, k=k: speed(k, p, at(p), moving=False)) for k in (1, 2, 3)},
    "eq:10": lambda p: law(p, moving=False),
    "eq:10/inverse": lambda p: inverse(law(p, moving=False)),
}


def build(claim: str) -> Any:
    return REGISTRY.derivations[claim].build()


def of_mechanics(claim: str) -> Any:
    derived = build(claim)
    return derived.mechanics if isinstance(derived, Modelled) else derived


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("claim", FORMULAS)
def test_a_derivation_is_what_plain_numbers_give(claim: str, seed: int) -> None:
    point = random_point(seed)
    expected = FORMULAS[claim](point)
    assert same(of_mechanics(claim), expected, point), f"{claim} is not {expected} at {point}"


@pytest.mark.parametrize("claim", BY_PREMISE)
def test_the_premise_is_a_surface_at_rest(claim: str) -> None:
    point = random_point(4)
    assert same(build(claim).premises, BY_PREMISE[claim](point), point)
    assert not same(build(claim).mechanics, BY_PREMISE[claim](point), point)


def test_every_formula_of_the_paper_is_compared(root: Path) -> None:
    loaded = load_paper(root / "paper_data" / "ballbot")
    kinds = {Kind.IDENTITY, Kind.VALUE}
    claims = {claim.id for claim in loaded.claims if claim.kind in kinds}
    assert uncompared(REGISTRY, claims, FORMULAS) == set()


def test_entries_are_those_of_their_matrix() -> None:
    point = random_point(6)
    for claim in (name for name in REGISTRY.derivations if "[" in name):
        whole, _, index = claim.rstrip("]").partition("[")
        place = tuple(int(n) - 1 for n in index.split(","))
        entry = of_mechanics(whole)[place if len(place) == 2 else place[0]]
        assert digits(build(claim), point) == digits(entry, point)


# Altered mechanics: every derivation that rests on it changes


MECHANICS = {
    "motion_by_frames", "motors_and_body", "matrix", "inverse", "wheel_speeds",
    "determinant_of_law", "bracket_of_rolling", "bracket_of_rolling_again",
    "velocity_at_contact", "yaw_at_contact",
}  # fmt: skip
"""Functions that rest on rolling; the other ones are geometry, statics or a motion as given."""
SPEEDS = {"eq:7", "eq:8", "eq:9"}
LEVERS = {f"eq:10[{k},3]" for k in (1, 2, 3)} | {f"eq:10/inverse[3,{k}]" for k in (1, 2, 3)}


def test_what_rests_on_mechanics_changes_with_the_rolling_constraint(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    resting = {claim for claim in REGISTRY.derivations if functions(REGISTRY, [claim]) <= MECHANICS}
    assert changed(REGISTRY, build, [longer_lever], monkeypatch) == resting | SPEEDS | LEVERS
