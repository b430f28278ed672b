"""two-roller-sphere: derivations against plain numbers, and against another mechanics."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import pytest
from altered import changed, longer_lever
from at_points import Point, number, random_point, same
from by_hand import cross, length
from mpmath import atan, cos, mpf, pi, radians, sin, tan
from sphere_by_hand import (
    Roller,
    Vector,
    added,
    best_spin,
    dot,
    drives,
    in_plane,
    motion,
    scaled,
    slip,
)
from sympy import Expr, rad

from omniproof.kinematics import rolling
from omniproof.kinematics.frames import UNIT
from omniproof.papers.two_roller_sphere import symmetric
from omniproof.papers.two_roller_sphere.derivations import REGISTRY
from omniproof.papers.two_roller_sphere.symbols import DIRECTION

SEEDS = (1, 2, 3)
POSITIVE = ("r", "V", "k_0", "d_1", "d_2", "delta")

# Plain numbers: rigid bodies, and least squares


def point(seed: int) -> Point:
    found = random_point(seed)
    for name in POSITIVE:
        found[name] = abs(found[name])
    return found


def one(p: Point) -> Roller:
    return in_plane(mpf(0), p["alpha_i"], p["nu_i"])


def either(p: Point) -> Vector:
    other = in_plane(p["gamma"], p["alpha_j"], p["nu_j"])
    return best_spin([one(p), other], p["r"])


def both(p: Point, first: Any = None, second: Any = None) -> Vector:
    """Spin of rollers 1 and 2, by their rim speeds or given ones."""
    speeds = (p["nu_1"], p["nu_2"]) if first is None else (first, second)
    rollers = [in_plane(mpf(0), p["alpha_1"], speeds[0]),
               in_plane(p["delta"], p["alpha_2"], speeds[1])]  # fmt: skip
    return best_spin(rollers, p["r"])


def flat(a: Sequence[Any]) -> Vector:
    return [a[0], a[1], mpf(0)]


def free(p: Point) -> Vector:
    return [p[f"w_{k}"] for k in (1, 2, 3)]


def alone(p: Point) -> Vector:
    """Spin on the line of one roller: it turns the contact as the rim does, and about it freely."""
    contact, axis, speed = one(p)
    return added(scaled(-speed / p["r"], axis), scaled(p["k"] * p["r"], contact))


def rolled(p: Point, vertical: Any) -> Vector:
    """Spin of a sphere whose lowest point rests: V = omega x (0, 0, r)."""
    return [-p["V"] * sin(p["phi"]) / p["r"], p["V"] * cos(p["phi"]) / p["r"], vertical]


def in_any_plane(p: Point) -> Any:
    """Vertical spin with which the spin is perpendicular to the normal of two vectors."""
    normal = cross([p[f"x_{k}"] for k in (1, 2, 3)], [p[f"y_{k}"] for k in (1, 2, 3)])
    return -dot(rolled(p, mpf(0)), normal) / normal[2]


def multiples(p: Point) -> Vector:
    """Coordinates of the flat part of the spin along both contacts."""
    spin, r, d = both(p), p["r"], p["delta"]
    second = spin[1] / (r * sin(d))
    return [spin[0] / r - second * cos(d), second]


FORMULAS: dict[str, Callable[[Point], Any]] = {
    "eq:1": lambda p: scaled(p["r"], cross(free(p), one(p)[0])),
    "sec:2.1/peripheral-speed": lambda p: p["nu_i"],
    "sec:2.1/non-slip": lambda p: drives(one(p)),
    "eq:2": lambda p: p["nu_i"],
    "eq:3": lambda p: -p["nu_i"] / p["r"],
    "eq:4": alone,
    "eq:5": lambda p: one(p)[1],
    "eq:6/tangent": lambda p: [mpf(0), mpf(1), mpf(0)],
    "eq:6/normal": lambda p: [mpf(0), mpf(0), mpf(1)],
    "eq:7": lambda p: flat(alone(p)),
    "eq:8": lambda p: flat(both(p)),
    "eq:9": lambda p: alone(p)[2],
    "eq:10": lambda p: [0, 0, both(p)[2]],
    "eq:11": both,
    "eq:12": lambda p: scaled(p["r"], [cos(p["theta_1i"]) * cos(p["theta_2i"]),
                                       sin(p["theta_1i"]) * cos(p["theta_2i"]),
                                       sin(p["theta_2i"])]),
    "eq:13": lambda p: [p["V"] * cos(p["phi"]), p["V"] * sin(p["phi"]), 0],
    "eq:14/direction": lambda p: tan(p["phi"]),
    "eq:14/axis": lambda p: tan(p["rho"]),
    "eq:14/speed": lambda p: p["V"],
    "eq:15": lambda p: rolled(p, p["V"] / p["r"] * tan(p["rho"])),
    "eq:17/x": lambda p: both(p, 0, 1),
    "eq:17/y": lambda p: both(p, 1, 0),
    "sec:2.3.2/in-span": lambda p: mpf(0),
    "eq:18": lambda p: in_any_plane(p) * p["r"] / p["V"],
    "eq:19": lambda p: rolled(p, in_any_plane(p)),
    "eq:20": lambda p: either(p)[1],
    "eq:21": lambda p: p["w_2"],
    "eq:22": lambda p: p["nu_i"],
    "eq:25": lambda p: slip(free(p), one(p), p["r"]),
    "eq:24/roller": lambda p: drives(one(p)),
    "eq:26": lambda p: slip(either(p), one(p), p["r"])[2],
    "eq:27": lambda p: slip(either(p), one(p), p["r"]),
    "eq:28": lambda p: slip(either(p), one(p), p["r"])[1],
    "app:A/circle": lambda p: p["k_0"] ** 2 / 2,
    "app:A/sum-of-squares": lambda p: p["d_1"] ** 2 + p["d_2"] ** 2,
    "eq:B.3": lambda p: sin(p["delta"]),
    "eq:B.4": lambda p: p["r"] * sin(p["delta"]),
    "eq:B.5": lambda p: -p["r"] * sin(p["delta"]),
    "eq:B.7": lambda p: dot(both(p)[:2], [-sin(p["beta"]), cos(p["beta"])]),
    "eq:B.8": lambda p: either(p)[1],
    "app:B/perpendicular": lambda p: mpf(0),
    "eq:B.9/first": lambda p: dot(both(p)[:2], [-sin(p["delta"]), cos(p["delta"])]),
    "eq:B.9/second": lambda p: both(p)[1],
    "eq:B.10/first": lambda p: multiples(p)[0],
    "eq:B.10/second": lambda p: multiples(p)[1],
}  # fmt: skip


def build(claim: str) -> Any:
    return REGISTRY.derivations[claim].build()


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("claim", FORMULAS)
def test_a_derivation_is_what_plain_numbers_give(claim: str, seed: int) -> None:
    at = point(seed)
    expected = FORMULAS[claim](at)
    assert same(build(claim), expected, at), f"{claim} is not {expected} at {at}"


# The simulation, in plain numbers


def in_case(expression: Expr, case: int, degrees: Any) -> Any:
    return number(symmetric.in_simulation(expression, case).subs(DIRECTION, rad(degrees)), {})


def close(found: Sequence[Any], expected: Sequence[Any]) -> bool:
    return all(abs(a - b) < mpf(10) ** -25 for a, b in zip(found, expected, strict=True))


@pytest.mark.parametrize("case", range(4))
@pytest.mark.parametrize("degrees", [0, 33, 90, 201, 270])
def test_the_motion_of_the_simulation(case: int, degrees: int) -> None:
    speeds, spin, slips = motion(case, radians(degrees))
    assert close([in_case(symmetric.rim_speed(k), case, degrees) for k in (1, 2)], speeds)
    assert close([in_case(entry, case, degrees) for entry in symmetric.spin()], spin)
    sizes = [abs(in_case(symmetric.slip(k), case, degrees)) for k in (1, 2)]
    assert close(sizes, [length(entry) for entry in slips])


@pytest.mark.parametrize(
    ("claim", "case", "printed"),
    [
        pytest.param("rim-speed", 0, "0.91", id="0.91228"),
        pytest.param("rim-speed", 1, "0.93", id="0.92635"),
        pytest.param("rim-speed", 2, "0.97", id="0.97082, printed as 0.96"),
        pytest.param("rim-speed", 3, "1.05", id="1.05341, printed as 1.03"),
        pytest.param("slip", 0, "0.00", id="nothing slips"),
        pytest.param("slip", 1, "0.16", id="0.16086"),
        pytest.param("slip", 2, "0.33", id="0.33204, printed as 0.32"),
        pytest.param("slip", 3, "0.53", id="0.52670, printed as 0.52"),
    ],
)
def test_the_printed_numbers(claim: str, case: int, printed: str) -> None:
    speeds, _, slips = motion(case, radians(90))
    expected = speeds[0] if claim == "rim-speed" else length(slips[0])
    assert close([number(build(f"sec:3/{claim}-{case}"), {})], [expected])
    assert f"{float(expected):.2f}" == printed


def ordered(roller: int, degrees: float) -> bool:
    """Whether the four rim speeds of a roller are in the printed order."""
    sizes = [abs(motion(case, radians(degrees))[0][roller - 1]) for case in range(4)]
    return sizes == sorted(sizes)


@pytest.mark.parametrize(
    ("roller", "lower", "upper"),
    [
        pytest.param(1, 91.73, 121.55, id="roller 1"),
        pytest.param(1, 271.73, 301.55, id="roller 1, backwards"),
        pytest.param(2, 58.45, 88.27, id="roller 2"),
        pytest.param(2, 238.45, 268.27, id="roller 2, backwards"),
    ],
)
def test_where_the_order_of_the_rim_speeds_fails(roller: int, lower: float, upper: float) -> None:
    for end, side in ((lower, -1), (upper, 1)):
        assert ordered(roller, end + side * 0.01)
        assert not ordered(roller, end - side * 0.01)
    for inside in range(int(lower) + 1, int(upper)):
        assert not ordered(roller, inside)
    condition = build(f"sec:3/speed-chain-roller-{roller}").condition
    assert rf"{lower:.2f}^\circ \leq \phi \leq {upper:.2f}^\circ" in condition


def test_the_order_of_the_rim_speeds_holds_elsewhere() -> None:
    for degrees in (*range(1, 58), *range(123, 237, 3)):
        assert ordered(1, degrees if degrees < 90 else degrees + 0.5)
    for degrees in (*range(90, 238, 3), *range(269, 418, 7)):
        assert ordered(2, degrees)


def test_the_plane_of_spins_stands_upright_at_38_96_degrees() -> None:
    """tan = 2 / (sqrt 3 tan 55): there no rim speeds make the sphere travel along x."""
    upright = atan(2 / (mpf(3) ** mpf("0.5") * tan(radians(55))))
    assert f"{float(upright * 180 / pi):.2f}" == "38.96"
    assert r"38.96^\circ" in build("sec:2.3.2/axis-obtained").condition


# Altered mechanics: every derivation that rests on it changes


def lagging_lever(direction: Any, position: Any, body: Any, surface: Any = rolling.REST) -> Any:
    """The body's lever leans sideways, but not on the ground below the centre."""
    lean = position + UNIT["z"].cross(position)
    return direction.dot(body.at(lean) - surface.at(position))


GEOMETRY = {
    "sec:2.1/direction-of-e", "sec:2.2/orthonormal-base", "eq:5", "eq:6/tangent", "eq:6/normal",
    "sec:2.2/unique-end-point", "tab:1/unit-along-roller", "tab:1/upper-normal",
    "tab:1/orthonormal-base", "tab:1/angle-of-roller", "eq:12", "sec:2.2/omnidirectional",
    "sec:3/omnidirectional", "app:A/tangent", "app:A/sum-of-squares", "app:B/perpendicular",
    "eq:B.1", "eq:B.2", "eq:B.3", "eq:B.4", "eq:B.5",
}  # fmt: skip
"""Where contacts, axes and tangents are, and sums of squares."""
GIVEN = {"sec:2.1/peripheral-speed", "eq:13", "eq:14/direction", "eq:14/speed", "eq:21", "eq:22"}
"""Rim speeds, velocities and spins that are given, along given directions."""
ZEROS = {
    "sec:2.1/spin-in-plane",  # a lever, of whatever length, is turned across the spin
    "sec:2.1/not-unique",  # and a spin about it moves nothing
    "sec:2.2/second-term", "sec:2.2/spin-in-plane",  # level axes: mirrored at their plane
    "sec:3/no-slip", "sec:3/slip-0",
    "sec:2.3.1/perpendicular",  # no rolling turns about the direction of travel
    "sec:2.3.2/rim-speed-obtained",  # an upright axis drives nothing along the normal
}  # fmt: skip
"""What is zero under each of the altered laws, too."""


def test_what_rests_on_mechanics_changes_with_the_rolling_constraint(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    turned = changed(REGISTRY, build, (longer_lever, lagging_lever), monkeypatch, point=point)
    assert turned == set(REGISTRY.derivations) - GEOMETRY - GIVEN - ZEROS
