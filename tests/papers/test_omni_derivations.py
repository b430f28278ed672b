"""omni-arrangement: derivations against plain numbers, and against another mechanics."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import by_hand
import pytest
from altered import broken_speed, changed, functions, swapped_speed
from at_points import CLOSE, Point, random_point, same, uncompared
from by_hand import cross, degrees, length
from mpmath import cos, det, inverse, matrix, mpf, pi, sin, sqrt

from omniproof.kinematics import omni
from omniproof.papers.omni_arrangement.derivations import REGISTRY
from omniproof.registry import Family, Relation
from omniproof.transcription.loader import load_paper
from omniproof.transcription.model import Kind

SEEDS = (1, 2, 3)

# Formulas

ANGLES = ("alpha_1", "alpha_2", "alpha_3")


def angles(p: Point) -> list[mpf]:
    return [p[name] for name in ANGLES]


def back(p: Point) -> matrix:
    return inverse(by_hand.wheels(angles(p)))


def adjugate(p: Point, lever: str = "") -> matrix:
    return by_hand.adjugate(by_hand.wheels(angles(p), lever=p[lever] if lever else mpf(1)))


def column(k: int) -> Callable[[Point], list[mpf]]:
    return lambda p: list(back(p)[:, k])


def shadow(k: int) -> Callable[[Point], list[mpf]]:
    return lambda p: [*list(back(p)[:, k])[:2], mpf(0)]


def family(p: Point) -> list[mpf]:
    return [p["theta"], pi - p["theta"], 3 * pi / 2]


def speeds(p: Point) -> list[mpf]:
    return [p[f"v_{k}"] for k in (1, 2, 3)]


def wheel(p: Point, *motion: str) -> mpf:
    given = [p[name] if name in motion else mpf(0) for name in ("V_x", "V_y", "phi_dot")]
    return by_hand.speed(p["alpha_k"], p["L"], *given)


def vectors(p: Point) -> list[list[mpf]]:
    return [[p[f"a_{axis}{k}"] for axis in (1, 2, 3)] for k in (1, 2, 3)]


def triple(p: Point) -> mpf:
    return det(matrix(vectors(p)))


def base(p: Point) -> mpf:
    first, second, _ = vectors(p)
    return length(cross(first, second))


def hexagon(p: Point, third: Sequence[mpf]) -> mpf:
    """Area that three plane vectors sweep, each from -1 to 1: hull of the eight corners."""
    columns = [(p["x_1"], p["y_1"]), (p["x_2"], p["y_2"]), tuple(third)]
    signs = [(a, b, c) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
    return by_hand.hull_area(
        [tuple(sum(s * v[i] for s, v in zip(sign, columns, strict=True)) for i in (0, 1))
         for sign in signs]
    )  # fmt: skip


def between(p: Point, sign: int) -> list[mpf]:
    return [p["p"] * p[f"{axis}_1"] + sign * p["q"] * p[f"{axis}_2"] for axis in "xy"]


FORMULAS: dict[str, Callable[[Point], Any]] = {
    "eq:1": lambda p: [p["L"] * cos(p["alpha_k"]), p["L"] * sin(p["alpha_k"])],
    "eq:2": lambda p: [-sin(p["alpha_k"]), cos(p["alpha_k"])],
    "sec:2.1/translational-part": lambda p: wheel(p, "V_x", "V_y"),
    "sec:2.1/rotational-part": lambda p: p["L"] * p["phi_dot"],
    "eq:3": lambda p: wheel(p, "V_x", "V_y", "phi_dot"),
    "eq:4": lambda p: wheel(p, "V_x", "V_y", "phi_dot"),
    "eq:5": lambda p: by_hand.wheels(angles(p)),
    "eq:5/twist": lambda p: [p["V_x"], p["V_y"], p["L"] * p["phi_dot"]],
    "eq:6/factor": lambda p: 1 / det(by_hand.wheels(angles(p))),
    "eq:6": adjugate,
    "eq:7": lambda p: det(by_hand.wheels(angles(p))),
    "eq:9": lambda p: list(back(p) * matrix(speeds(p))),
    "eq:10/a1": column(0),
    "eq:10/a2": column(1),
    "eq:10/a3": column(2),
    "eq:11": lambda p: by_hand.volume(angles(p)),
    "eq:12": lambda p: by_hand.volume(family(p)),
    "eq:13": lambda p: [*list(back(p) * matrix(speeds(p)))[:2], mpf(0)],
    "eq:14/a1": shadow(0),
    "eq:14/a2": shadow(1),
    "eq:14/a3": shadow(2),
    "eq:15/name": lambda p: by_hand.area(angles(p)),
    "eq:15/case-1": lambda p: hexagon(p, [-p["x_1"] - p["x_2"], -p["y_1"] - p["y_2"]]),
    "eq:15/case-2": lambda p: hexagon(p, between(p, -1)),
    "eq:A.1": adjugate,
    "eq:A.3": lambda p: det(by_hand.wheels(angles(p), lever=p["L"])),
    "eq:C.6": lambda p: det(by_hand.wheels(angles(p), lever=p["L"])),
    "app:B/area-of-base": base,
    "eq:B.2": lambda p: abs(triple(p)) / base(p),
    "eq:B.3": lambda p: abs(triple(p)),
    "eq:B.3#2/volume": lambda p: abs(triple(p)),
    "eq:B.3#2/determinant": triple,
    "eq:C.4/arc-a": lambda p: p["alpha_2"] - p["alpha_1"],
    "eq:C.4/arc-b": lambda p: p["alpha_3"] - p["alpha_2"],
    "eq:C.4/arc-c": lambda p: 2 * pi - p["alpha_3"] + p["alpha_1"],
    "app:C/sum-of-two-arcs": lambda p: p["alpha_3"] - p["alpha_1"],
    "eq:C.5": lambda p: sin(p["alpha_1"] - p["alpha_3"]),
    "eq:C.6/condition": lambda p: 2 * pi,
    "app:C/mean-arc": lambda p: 2 * pi / 3,
    "eq:D.1": lambda p: [*list(back(p) * matrix([p["v_1"], p["v_2"], 0]))[:2], mpf(0)],
    "app:D/linear-combination": lambda p: [p["V_x"], p["V_y"]],
    **{f"eq:A.2/a{i}{k}": (lambda p, i=i, k=k: adjugate(p, "L")[i - 1, k - 1])
       for i, k in ((1, 1), (1, 2), (1, 3), (2, 1), (2, 2), (2, 3))},
    **{f"eq:A.4/a3{k}-line-{n}": (lambda p, k=k: adjugate(p)[2, k - 1])
       for k in (1, 2, 3) for n in (1, 2)},
}  # fmt: skip
RADII = "the unknown is the yaw rate: third column L"


def build(claim: str) -> Any:
    derivation = REGISTRY.derivations[claim]
    return derivation.build(RADII) if derivation.convention else derivation.build()


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("claim", FORMULAS)
def test_a_derivation_is_what_plain_numbers_give(claim: str, seed: int) -> None:
    point = random_point(seed)
    expected = FORMULAS[claim](point)
    assert same(build(claim), expected, point), f"{build(claim)} is not {expected} at {point}"


def test_every_formula_of_the_paper_is_compared(root: Path) -> None:
    loaded = load_paper(root / "paper_data" / "omni-arrangement")
    claims = {claim.id for claim in loaded.claims
              if claim.kind is Kind.IDENTITY and not claim.uncheckable}  # fmt: skip
    assert uncompared(REGISTRY, claims, FORMULAS) == {"tab:1[3]", "tab:1[6]"}


# The three types

TYPES = {"X": degrees(30, 150, 270), "Y": degrees(0, 180, 270), "Z": degrees(210, 270, 330)}
PRINTED_Z = degrees(210, 270, 300)


@pytest.mark.parametrize("name", TYPES)
@pytest.mark.parametrize(("column", "by_numbers"),
                         [("D_V", by_hand.volume), ("D_A", by_hand.area)])  # fmt: skip
def test_cells_of_table_2(name: str, column: str, by_numbers: Callable[..., mpf]) -> None:
    assert same(build(f"tab:2[{name},{column}]"), by_numbers(TYPES[name]), {})


def subject(claim: str) -> Any:
    derived = REGISTRY.derivations[claim].build()
    return derived.subject if isinstance(derived, Relation) else derived


@pytest.mark.parametrize(
    ("claim", "by_numbers"),
    [
        pytest.param("sec:4/type-z-largest-volume", by_hand.volume, id="volumes"),
        pytest.param("sec:4/type-z-largest-area", by_hand.area, id="areas"),
        pytest.param("sec:4/type-z-translation", by_hand.section, id="sections without rotation"),
        pytest.param("fig:4/stretched-along-vx", lambda a: by_hand.half_widths(a)[0], id="V_x"),
        pytest.param("fig:4/stretched-along-lphi", lambda a: by_hand.half_widths(a)[2], id="L phi"),
    ],
)
def test_compared_quantities_of_the_types(claim: str, by_numbers: Callable[..., mpf]) -> None:
    found = subject(claim)
    values = found.values() if isinstance(found, Mapping) else found
    assert same(list(values), [by_numbers(angles_) for angles_ in TYPES.values()], {})


def test_printed_type_z_gives_neither_an_isosceles_triangle_nor_table_2() -> None:
    arcs = [PRINTED_Z[1] - PRINTED_Z[0], PRINTED_Z[2] - PRINTED_Z[1]]
    assert abs(arcs[0] - arcs[1]) > 0.1
    assert by_hand.volume(PRINTED_Z) > 21
    assert abs(by_hand.volume(TYPES["Z"]) - mpf("9.24")) < mpf("0.005")


# Extrema, by dense sampling


def test_the_least_volume_over_all_arrangements() -> None:
    found: Family = subject("sec:3/minimum-equilateral")
    names = [symbol.name for symbol in found.box]
    least, near = 16 * sqrt(3) / 9, []
    for a in range(5, 360, 10):
        for b in range(5, 360, 10):
            first, second = degrees(a, b)
            if abs(det(by_hand.wheels([mpf(0), first, first + second]))) < CLOSE:
                continue
            volume = by_hand.volume([mpf(0), first, first + second])
            assert volume > least
            near += [(a, b)] if volume < mpf("3.2") else []
    assert {(round(a / 120), round(b / 120)) for a, b in near} == {(1, 1), (2, 2)}
    assert max(min(abs(a - c) + abs(b - c) for c in (120, 240)) for a, b in near) <= 30
    for a, b in ((120, 120), (240, 240), (35, 200)):
        point = dict(zip(names, degrees(a, b), strict=True))
        exact = by_hand.volume([mpf(0), point[names[0]], sum(point.values())])
        value = found.expression.subs({s: point[s.name] for s in found.box}).evalf(20)
        assert abs(mpf(value) - exact) < mpf(10) ** -15


@pytest.mark.parametrize(
    ("claim", "by_numbers", "least"),
    [
        pytest.param("sec:4/minimum-of-volume", by_hand.volume, 16 * sqrt(3) / 9, id="volume"),
        pytest.param("sec:4/minimum-of-area", by_hand.area, 8 * sqrt(3) / 3, id="area"),
    ],
)
def test_the_least_member_of_the_isosceles_family(
    claim: str, by_numbers: Callable[..., mpf], least: mpf
) -> None:
    found: Family = subject(claim)
    (theta,) = found.box
    values = {}
    for angle in range(-88, 90, 2):
        point = {"theta": degrees(angle)[0]}
        values[angle] = by_numbers(family(point))
        value = mpf(found.expression.subs(theta, point["theta"]).evalf(20))
        assert abs(value - values[angle]) < mpf(10) ** -12 * values[angle]
    assert min(values, key=values.__getitem__) == 30
    assert abs(values[30] - least) < CLOSE


# Altered mechanics: every derivation that rests on it changes


VECTORS = "a lemma on any vectors"
MATRICES = "a lemma on any matrix that has an inverse"
ARCS = "defined by the position angles alone"
PLACES = "geometry of the wheels' places, no motion"
DIRECTION = "the convention on the sense of a wheel, which the rolling constraint takes as given"
CUBE = "the cube of wheel speeds, before any map"
COUNT = "counts rows or columns"
WITHOUT_MECHANICS = {
    **dict.fromkeys(
        ("inner_product", "third_component", "ratio_of_volumes", "volume_of_domain",
         "area_of_base", "length_of_normal", "products_with_normal", "height_over_base",
         "volume_by_height", "volume_by_triple_product", "triple_product", "area_of_case_2",
         "condition_of_case_1", "condition_of_case_2"), VECTORS),
    **dict.fromkeys(("image_is_solid", "velocity", "twist"), MATRICES),
    **dict.fromkeys(
        ("arc_a", "arc_b", "arc_c", "two_arcs", "sine_of_third_arc", "full_turn", "mean_arc",
         "sine_over_arcs"), ARCS),
    **dict.fromkeys(
        ("contact_point", "sides_of_type_x", "symmetries", "angles_in_range", "sides_at_apex",
         "isosceles_types", "family_of_types"), PLACES),
    **dict.fromkeys(
        ("driven_direction", "length_of_direction", "direction_across_radius",
         "both_perpendicular_directions"), DIRECTION),
    **dict.fromkeys(("edge_of_cube", "bound_of_cube"), CUBE),
    **dict.fromkeys(("degrees_of_freedom", "number_of_wheels", "order_of_matrix"), COUNT),
}  # fmt: skip
"""Functions that stay as they are by their nature, with the reason."""


def test_what_rests_on_mechanics_changes_with_the_rolling_constraint(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    turned = changed(REGISTRY, build, (broken_speed, swapped_speed), monkeypatch, home=omni)
    assert functions(REGISTRY, set(REGISTRY.derivations) - turned) == set(WITHOUT_MECHANICS)
