"""three-roller-sphere: derivations against plain numbers, and against another mechanics.

The numbers know nothing of SymPy or the package: rollers by coordinates, distances by the point of
a line that is nearest, the optimum by least squares, extrema by walking round.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import isqrt
from pathlib import Path
from typing import Any

import pytest
from altered import changed, longer_lever
from at_points import Point, number, random_point, same
from by_hand import cross, length
from mpmath import cos, lu_solve, matrix, mpf, pi, radians, sin
from sphere_by_hand import Roller, Vector, added, best_spin, dot, drives, scaled, slip

from omniproof.audit.theorems import prove
from omniproof.kinematics import rolling
from omniproof.papers.three_roller_sphere.derivations import REGISTRY
from omniproof.papers.three_roller_sphere.theorems import THEOREMS
from omniproof.transcription.loader import load_paper
from omniproof.transcription.model import Kind

SEEDS = (1, 2, 3)

# Plain numbers


def at_contact(azimuth: Any, elevation: Any, angle: Any = 0) -> tuple[Vector, Vector]:
    """Contact and axis: the axis goes the angle's way from east to north."""
    a, b = azimuth, elevation
    contact = [cos(b) * cos(a), cos(b) * sin(a), sin(b)]
    east = cross([0, 0, 1], [cos(a), sin(a), 0])
    north = cross(contact, east)
    return contact, added(scaled(cos(angle), east), scaled(sin(angle), north))


def roller(p: Point, name: str) -> Roller:
    angles = (p[f"theta_1_{name}"], p[f"theta_2_{name}"], p[f"psi_{name}"])
    return (*at_contact(*angles), p[f"v_{name}"])


def velocity(spin: Vector, radius: Any, contact: Vector) -> Vector:
    return cross(spin, scaled(radius, contact))


def on_line(p: Point) -> Vector:
    contact, axis, speed = roller(p, "i")
    return added(scaled(-speed / p["r"], axis), scaled(p["t"], contact))


def distance(p: Point, name: str, point: Vector) -> Any:
    """Distance from the nearest point of the line: the foot, and the share along the contact."""
    contact, axis, speed = roller(p, name)
    foot = scaled(-speed / p["r"], axis)
    share = dot(added(point, scaled(-1, foot)), contact)
    return length(added(point, scaled(-1, foot), scaled(-share, contact)))


def sum_of_squares(p: Point, *point: Any) -> Any:
    return sum(distance(p, name, list(point)) ** 2 for name in "123")


def coefficient(p: Point, k: int) -> Any:
    """Coefficients by differences: exact for a quadratic form, whatever the step."""
    step = mpf("0.3")
    unit = [[step * (i == k) for i in range(3)] for k in range(3)]

    def at(*parts: Vector) -> Any:
        return sum_of_squares(p, *added([0, 0, 0], *parts))

    if k == 10:
        return at()
    if k > 3 and k < 7:
        a, b = (unit[i] for i in {4: (0, 1), 5: (1, 2), 6: (0, 2)}[k])
        return (at(a, b) - at(a) - at(b) + at()) / step**2
    e = unit[(k - 1) % 3]
    there, back = at(e), at(scaled(-1, e))
    if k < 4:
        return (there + back - 2 * at()) / 2 / step**2
    return (there - back) / 2 / step


def hessian(p: Point) -> matrix:
    c = {k: p[f"C_{k}"] for k in range(1, 11)}
    return matrix([[2 * c[1], c[4], c[6]], [c[4], 2 * c[2], c[5]], [c[6], c[5], 2 * c[3]]])


def optimum(p: Point) -> Vector:
    return list(lu_solve(hessian(p), matrix([-p[f"C_{k}"] for k in (7, 8, 9)])))


def eliminated(p: Point, count: int, k: int) -> Any:
    """Coefficient after elimination, as a Schur complement of the form's 4 x 4 matrix."""
    c = {k: p[f"C_{k}"] for k in range(1, 11)}
    full = matrix(4, 4)
    full[:3, :3] = hessian(p)
    for i in range(3):
        full[i, 3] = full[3, i] = c[7 + i]
    full[3, 3] = 2 * c[10]
    left = list(range(count, 4))
    block = matrix([[full[i, j] for j in range(count)] for i in range(count)])

    def schur(i: int, j: int) -> Any:
        share = lu_solve(block, matrix([full[m, j] for m in range(count)]))
        return full[i, j] - sum(full[i, m] * share[m] for m in range(count))

    place = {1: (0, 0), 2: (1, 1), 3: (2, 2), 4: (0, 1), 5: (1, 2), 6: (0, 2)}
    place |= {7: (0, 3), 8: (1, 3), 9: (2, 3), 10: (3, 3)}
    i, j = place[k]
    assert i in left
    return schur(i, j) / (2 if i == j else 1)


AZIMUTHS = [radians(mpf(a)) for a in (30, 150, 270)]
ELEVATIONS = [radians(mpf(b)) for b in (0, 10, 20, 30)]


def speeds(phi: Any) -> Vector:
    """Speeds that turn the sphere about the axis at phi + 90 degrees, rollers on the equator."""
    axis = [-sin(phi), cos(phi), mpf(0)]
    contacts = [[cos(a), sin(a), mpf(0)] for a in AZIMUTHS]
    return [dot(cross(axis, contact), [0, 0, 1]) for contact in contacts]


def simulated(elevation: Any, phi: Any) -> tuple[Vector, list[Vector]]:
    """Spin and slips for radius 1: nine equations, three unknowns, least squares."""
    places = [at_contact(a, elevation) for a in AZIMUTHS]
    rollers = [(*place, speed) for place, speed in zip(places, speeds(phi), strict=True)]
    spin = best_spin(rollers, 1)
    return spin, [slip(spin, each, 1) for each in rollers]


def walked(k: int) -> Vector:
    """Slips of the first roller of the k-th pattern, all round in steps of 15 degrees."""
    phis = [pi * n / 12 for n in range(24)]
    return [length(simulated(ELEVATIONS[k - 1], phi)[1][0]) for phi in phis]


def tangents(p: Point) -> Vector:
    return [at_contact(p["theta_1_i"], p["theta_2_i"], turn)[1] for turn in (mpf(0), pi / 2)]


def distance_at(p: Point, name: str) -> Any:
    return distance(p, name, [p[axis] for axis in "xyz"])


FORMULAS: dict[str, Callable[[Point], Any]] = {
    "sec:2.1/velocity-of-sphere": lambda p: velocity(on_line(p), p["r"], roller(p, "i")[0]),
    "sec:2.1/nonslip": lambda p: drives(roller(p, "i")),
    "sec:2.1/rim-speed": lambda p: p["v_i"],
    "eq:1": lambda p: -p["v_i"] / p["r"],
    "eq:2": on_line,
    "eq:3": lambda p: roller(p, "i")[1],
    "eq:4/x": lambda p: tangents(p)[0],
    "eq:4/y": lambda p: tangents(p)[1],
    "eq:5": lambda p: sum(distance_at(p, name) ** 2 for name in "123"),
    "eq:6": lambda p: distance_at(p, "i"),
    **{f"eq:7/{axis}-0": (lambda p, k=k: optimum(p)[k]) for k, axis in enumerate("xyz")},
    **{f"eq:8/e-{k}": (lambda p, k=k: eliminated(p, 2, k)) for k in (3, 9, 10)},
    **{f"eq:9/d-{k}": (lambda p, k=k: eliminated(p, 1, k)) for k in (2, 3, 5, 8, 9, 10)},
    **{f"eq:10/c-{k}": (lambda p, k=k: coefficient(p, k)) for k in range(1, 11)},
    **{f"sec:3/input-{k}": (lambda p, k=k: speeds(p["phi"])[k - 1]) for k in (1, 2, 3)},
    **{f"sec:3/nonslip-{k}": (lambda p, k=k: length(simulated(mpf(0), p["phi"])[1][k - 1]))
       for k in (1, 2, 3)},
    **{f"sec:3/elevation-{k}": (lambda p, k=k: ELEVATIONS[k - 1]) for k in (1, 2, 3, 4)},
    **{f"sec:3/minimum-{k}": (lambda p, k=k: min(walked(k))) for k in (2, 3, 4)},
    **{f"sec:3/maximum-{k}": (lambda p, k=k: max(walked(k))) for k in (2, 3, 4)},
    "sec:3/psi": lambda p: mpf(0),
    "sec:1/two-degrees": lambda p: mpf(2),
    "sec:2.2/lines": lambda p: mpf(3),
    "sec:3/number-of-patterns": lambda p: mpf(4),
    "sec:3/rollers-of-psi": lambda p: mpf(3),
    "sec:3/rollers-of-theta": lambda p: mpf(3),
}  # fmt: skip


def build(claim: str) -> Any:
    return REGISTRY.derivations[claim].build()


def drawn(seed: int) -> Point:
    """Draw a random point; radii are positive."""
    point = random_point(seed)
    for name in ("r", "rho"):
        point[name] = abs(point[name])
    return point


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("claim", FORMULAS)
def test_a_derivation_is_what_plain_numbers_give(claim: str, seed: int) -> None:
    point = drawn(seed)
    expected = FORMULAS[claim](point)
    assert same(build(claim), expected, point), f"{claim} is not {expected} at {point}"


def test_every_formula_of_the_paper_is_compared(root: Path) -> None:
    loaded = load_paper(root / "paper_data" / "three-roller-sphere")
    kinds = {Kind.IDENTITY, Kind.VALUE}
    assert {claim.id for claim in loaded.claims if claim.kind in kinds} == set(FORMULAS)


@pytest.mark.parametrize("k", [1, 2, 3, 4])
def test_the_spin_of_a_pattern_is_the_one_of_least_squares(k: int) -> None:
    point = drawn(7)
    spin = [number(entry, point) * point["r"] for entry in build(f"sec:3/circle-{k}").coordinates]
    expected, _ = simulated(ELEVATIONS[k - 1], point["phi"])
    assert max(abs(a - b) for a, b in zip(spin, expected, strict=True)) < mpf(10) ** -25


# Altered mechanics: every derivation that rests on it changes


def tilted(direction: Any, position: Any, body: Any, surface: Any = rolling.REST) -> Any:
    """A third of each level velocity counts as a vertical one."""
    relative = body.at(position) - surface.at(position)
    return direction.dot(relative) + direction[2] * (relative[0] + relative[1]) / 3


GEOMETRY = {
    "eq:3", "eq:4/x", "eq:4/y", "sec:2.1/counterclockwise", "sec:2.1/orthonormal",
    "sec:2.1/tangent-plane", "sec:2.1/line-parallel-to-contact",
}  # fmt: skip
ALGEBRA = (
    {f"eq:7/{axis}-0" for axis in "xyz"}
    | {f"eq:8/e-{k}" for k in (3, 9, 10)}
    | {f"eq:9/d-{k}" for k in (2, 3, 5, 8, 9, 10)}
)
"""Least value of any quadratic form: what is mechanical are its coefficients."""
ROLLER = {
    "sec:2.1/driven-direction", "sec:2.1/nonslip", "sec:2.1/rim-speed", "sec:2.1/unit-normal",
    "eq:10/c-10",
}  # fmt: skip
"""The roller as a body of its own, while the sphere is at rest."""
COUNTS = {
    "sec:1/different-dimensions", "sec:1/less-diversity", "sec:1/two-degrees", "sec:2.2/lines",
    "sec:3/number-of-patterns", "sec:3/rollers-of-psi", "sec:3/rollers-of-theta",
}  # fmt: skip
SET_UP = {f"sec:3/elevation-{k}" for k in (1, 2, 3, 4)} | {"sec:3/psi", "sec:3/regular-triangle"}
INPUTS_FOLLOW = {"sec:3/circle-1", *(f"sec:3/nonslip-{part}" for part in ("1", "2", "3", "case"))}
"""The inputs are the speeds that the constraint asks for on the equator, whatever it says."""


def test_what_rests_on_mechanics_changes_with_the_rolling_constraint(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    untouched = GEOMETRY | ALGEBRA | ROLLER | COUNTS | SET_UP | INPUTS_FOLLOW
    turned = changed(REGISTRY, build, (longer_lever, tilted), monkeypatch, point=drawn)
    assert set(REGISTRY.derivations) - turned == untouched


# The theorem on the elimination


@pytest.mark.parametrize("theorem", THEOREMS, ids=lambda theorem: theorem.id)
def test_its_theorems_are_proved(theorem: Any) -> None:
    assert all(step["engines"] for step in prove(theorem)["proof"])


@pytest.mark.parametrize(
    ("direction", "zero"),
    [
        pytest.param((1, 0, 0), 1, id="x-axis: C_1"),
        pytest.param((0, 1, 0), 2, id="y-axis: D_2"),
        pytest.param((3, 4, 0), 2, id="a line of the xy-plane: D_2"),
        pytest.param((0, 0, 1), 3, id="z-axis: E_3"),
        pytest.param((2, 3, 6), 3, id="a line that leaves the plane: E_3"),
    ],
)
def test_a_divisor_vanishes_for_contacts_on_one_line(direction: tuple[int, ...], zero: int) -> None:
    """3 (I - u u^T), eliminated by hand: exact in fractions, since |u| is whole."""
    size = Fraction(isqrt(sum(x * x for x in direction)))
    u = [x / size for x in direction]
    rows = [[3 * ((i == k) - u[i] * u[k]) for k in range(3)] for i in range(3)]
    pivots = []
    for k in range(3):
        pivots.append(rows[k][k])
        if rows[k][k] == 0:
            break
        for i in range(k + 1, 3):
            share = rows[i][k] / rows[k][k]
            rows[i] = [a - share * b for a, b in zip(rows[i], rows[k], strict=True)]
    assert [pivot > 0 for pivot in pivots] == [True] * (zero - 1) + [False]
