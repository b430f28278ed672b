"""omni-trajectory: derivations against plain numbers, and against another mechanics."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import by_hand
import pytest
from altered import broken_speed, changed, functions, swapped_speed
from at_points import Point, random_point, same, uncompared
from by_hand import degrees
from mpmath import atan2, cos, inverse, matrix, mp, mpf, odefun, pi, sin, sqrt
from sympy import Expr, Function, Integral, Rational, Symbol
from sympy import cos as exact_cos

from omniproof.kinematics import omni
from omniproof.papers.omni_trajectory.derivations import REGISTRY
from omniproof.papers.omni_trajectory.derivations.simulation import SETUP
from omniproof.registry import Fit
from omniproof.transcription.loader import load_paper
from omniproof.transcription.model import Kind

SEEDS = (1, 2, 3)
ANGLES = degrees(30, 150, 270)
Vector = list[Any]


def wheels(p: Point, angles: Vector = ANGLES, lever: str = "L") -> matrix:
    return by_hand.wheels(angles, lever=p[lever] if lever else mpf(1))


def free(p: Point) -> Vector:
    return [p[f"alpha_{k}"] for k in (1, 2, 3)]


def twist(p: Point, *names: str) -> Vector:
    """Twist for wheel speeds, by solving three equations."""
    return list(inverse(wheels(p)) * matrix([p[name] for name in names]))


def constant(p: Point) -> Vector:
    return twist(p, "a", "b", "c")


def world(p: Point) -> Vector:
    x, y, c, s = p["X_m"], p["Y_m"], cos(p["phi"]), sin(p["phi"])
    return [c * x - s * y, s * x + c * y, p["phi_dot"]]


def speed(v: Vector) -> mpf:
    return sqrt(v[0] ** 2 + v[1] ** 2)


def radius(v: Vector) -> mpf:
    """By the length of a full turn."""
    return speed(v) * (2 * pi / abs(v[2])) / (2 * pi)


def centre(v: Vector) -> Vector:
    """The point of the body that does not move: V + w z x r = 0."""
    return [-v[1] / v[2], v[0] / v[2]]


FORMULAS: dict[str, Callable[[Point], Any]] = {
    "sec:1/degrees-of-freedom": lambda p: mpf(3),
    "sec:1/translations": lambda p: mpf(2),
    "sec:1/rotations": lambda p: mpf(1),
    "sec:3.1/three-wheels": lambda p: mpf(3),
    "eq:1": lambda p: wheels(p, free(p), lever=""),
    "eq:1/twist": lambda p: [p["X_m"], p["Y_m"], p["L"] * p["phi_dot"]],
    "eq:2": lambda p: [p["v_1"], p["v_2"], p["v_3"]],
    "eq:3": wheels,
    "eq:3/twist": lambda p: [p["X_m"], p["Y_m"], p["phi_dot"]],
    "eq:4": lambda p: inverse(wheels(p)),
    "eq:5": lambda p: twist(p, "v_1", "v_2", "v_3")[2],
    "eq:6": world,
    "eq:7/body": lambda p: [p["X_m"], p["Y_m"], p["phi_dot"]],
    "eq:7": lambda p: matrix([[cos(p["phi"]), -sin(p["phi"]), 0],
                              [sin(p["phi"]), cos(p["phi"]), 0], [0, 0, 1]]),
    "eq:10": lambda p: speed(world(p)),
    "eq:11": lambda p: speed(constant(p)),
    "sec:2.2/radius": lambda p: radius(world(p)),
    "eq:13": lambda p: radius(constant(p)),
    "sec:2.2/velocity": lambda p: world(p)[:2],
    "eq:14/velocities": lambda p: atan2(world(p)[1], world(p)[0]),
    "eq:14/speeds": lambda p: atan2(constant(p)[1], constant(p)[0]),
    "eq:15": lambda p: centre(world(p)),
    "eq:16/factor": lambda p: p["L"] / (p["a"] + p["b"] + p["c"]),
    "eq:16/line-1": lambda p: [-3 * constant(p)[1], 3 * constant(p)[0]],
    "eq:16/line-2": lambda p: centre(constant(p)),
}  # fmt: skip
OF_TIME = {
    "eq:8", "eq:9", "eq:8/orientation", "sec:3.1/theoretical-vector",
    "sec:3.1/experimental-vector", "eq:17",
}  # fmt: skip


def build(claim: str) -> Any:
    return REGISTRY.derivations[claim].build()


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("claim", FORMULAS)
def test_a_derivation_is_what_plain_numbers_give(claim: str, seed: int) -> None:
    point = random_point(seed)
    expected = FORMULAS[claim](point)
    assert same(build(claim), expected, point), f"{build(claim)} is not {expected} at {point}"


def test_every_formula_and_number_of_the_paper_is_compared(root: Path) -> None:
    loaded = load_paper(root / "paper_data" / "omni-trajectory")
    claims = {claim.id for claim in loaded.claims if not claim.uncheckable
              and claim.kind in {Kind.IDENTITY, Kind.VALUE}}  # fmt: skip
    left = uncompared(REGISTRY, claims, (*FORMULAS, *OF_TIME))
    inputs = {claim for claim in left if claim[:5] in {"tab:3", "tab:4"}}
    assert left - inputs == {"tab:2[V]", "sec:3.2/speed-circular", "sec:3.2/speed-linear"}
    assert len(inputs) == 18


# Functions of time: wheel speeds 1 + t, cos t and 1/2, against an ODE solver

TIME = Symbol("t", real=True)
CHOSEN = (1 + TIME, exact_cos(TIME), Rational(1, 2))
LEVER = Rational(3, 2)


def with_speeds(value: Expr) -> Expr:
    """Put chosen functions for the wheel speeds, the innermost integrals solved."""
    for k, chosen in enumerate(CHOSEN, 1):
        speed_of = Function(f"v_{k}", real=True)
        value = value.replace(speed_of, lambda time, chosen=chosen: chosen.subs(TIME, time))
    solved = (
        value.replace(
            lambda part: isinstance(part, Integral) and not part.function.has(Integral),
            lambda part: part.doit(),
        )
        if value.has(Integral)
        else value
    )
    return solved.subs(Symbol("L", positive=True), LEVER)


@pytest.fixture(scope="module")
def place() -> Vector:
    """X, Y and the heading at time 1.2 by Taylor series."""
    back = inverse(by_hand.wheels(ANGLES, lever=mpf(3) / 2))

    def slope(t: mpf, pose: Vector) -> Vector:
        v_x, v_y, rate = back * matrix([1 + t, cos(t), mpf(1) / 2])
        c, s = cos(pose[2]), sin(pose[2])
        return [c * v_x - s * v_y, s * v_x + c * v_y, rate]

    with mp.workdps(20):
        return list(odefun(slope, 0, [mpf(0)] * 3)(mpf("1.2")))


@pytest.mark.parametrize(("claim", "k"), [("eq:8", 0), ("eq:9", 1)])
def test_the_path_for_changing_speeds(claim: str, k: int, place: Vector) -> None:
    integrand = with_speeds(build(claim).function)
    assert not integrand.has(Function("v_1", real=True), Integral)
    found = mp.quad(lambda t: mpf(integrand.subs(TIME, t).evalf(20)), [0, mpf("1.2")])
    assert abs(found - place[k]) < mpf(10) ** -12


def test_the_heading_for_changing_speeds(place: Vector) -> None:
    found = with_speeds(build("eq:8/orientation")).subs(TIME, Rational("1.2"))
    assert abs(mpf(found.evalf(20)) - place[2]) < mpf(10) ** -12


def test_the_error_of_a_path_that_is_a_tenth_too_long() -> None:
    ((time, start, end),) = build("eq:17").atoms(Integral).pop().limits
    relative = build("eq:17").atoms(Integral).pop().function
    for name, chosen in (("X_w^m", time), ("Y_w^m", 2 * time),
                         ("X_w^e", time * 11 / 10), ("Y_w^e", time * 11 / 5)):  # fmt: skip
        relative = relative.replace(Function(name, real=True), lambda t, f=chosen: f.subs(time, t))
    assert (start, str(end)) == (0, "T")
    assert [relative.subs(time, n).simplify() for n in (1, 7)] == [Rational(1, 10)] * 2


# The inputs: at 0.05 m/s a wheel that is driven along the motion turns with FULL rpm

FULL = 0.05 / 0.023 * 30 / math.pi


@pytest.mark.parametrize(
    ("claim", "rpm"),
    [
        pytest.param("tab:4[0,N_1]", -FULL / 2, id="0: minus half"),
        pytest.param("tab:4[0,N_3]", FULL, id="0: all"),
        pytest.param("tab:4[30,N_3]", FULL * math.sqrt(3) / 2, id="30: times sqrt(3)/2"),
        pytest.param("tab:4[60,N_2]", -FULL, id="60: minus all"),
        pytest.param("tab:4[90,N_2]", -FULL * math.sqrt(3) / 2, id="90: minus sqrt(3)/2"),
        pytest.param("tab:3[left,N_1]", FULL / 2 + 22.6, id="left: half, and the rotation"),
        pytest.param("tab:3[clockwise,N_2]", -FULL - 22.56, id="clockwise: minus both"),
    ],
)
def test_inputs(claim: str, rpm: float) -> None:
    fit = build(claim)
    assert isinstance(fit, Fit)
    assert float(fit.value.subs(dict(fit.setup))) == pytest.approx(rpm, rel=1e-12)
    assert set(fit.setup) == set(SETUP)


# Altered mechanics: every derivation that rests on it changes


WITHOUT_MECHANICS = {
    **dict.fromkeys(("degrees_of_freedom", "number_of_wheels"), "counts rows or columns"),
    **dict.fromkeys(("sides", "across_radius", "outside_the_first_quadrant"),
                    "geometry of the rollers' places or of directions"),
    **dict.fromkeys(("velocity_in_the_world", "velocity_in_the_body", "to_the_world",
                     "speed_in_any_frame", "radius", "velocity", "direction_by_velocity",
                     "centre", "path_without_rotation", "path_with_rotation",
                     "distance_from_the_origin"), "a rigid motion, whatever drives it"),
    **dict.fromkeys(("general_twist", "equilateral_twist"), "a motion by its own components"),
    **dict.fromkeys(("yaw_rate_without_sum", "sums", "velocity_along_the_path"),
                    "zero by symmetry, or by the definition of an integral"),
    **dict.fromkeys(("theoretical_place", "experimental_place", "error"), "any path"),
    "rim_speeds": "a roller that turns, before it meets the floor",
    **dict.fromkeys(("speed", "speed_again"), "the unknown itself"),
    "below_the_bound": "printed errors",
}  # fmt: skip
"""Functions that stay as they are by their nature, with the reason."""


def test_what_rests_on_mechanics_changes_with_the_rolling_constraint(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    turned = changed(REGISTRY, build, (broken_speed, swapped_speed), monkeypatch, home=omni)
    assert functions(REGISTRY, set(REGISTRY.derivations) - turned) == set(WITHOUT_MECHANICS)
