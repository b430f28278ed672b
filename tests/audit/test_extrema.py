"""Global extrema, signs and concavity: true claims proved, false ones refuted by a point."""

from fractions import Fraction

import mpmath
import pytest
import sympy as sp

from omniproof.decide.answer import OnBranch, Proved, Refuted, Undecided
from omniproof.decide.order.extrema import concave, prove_extremum, sign_on
from omniproof.registry import Family

A, B, C, t = sp.symbols("A B C t", real=True)
pi, sin, cos, sqrt, tan, Abs = sp.pi, sp.sin, sp.cos, sp.sqrt, sp.tan, sp.Abs
SINES = sin(A) + sin(B) - sin(A + B)  # three wheels at arcs A, B and the rest
TORUS = {A: (0, 2 * pi), B: (0, 2 * pi)}
HALF = {t: (-pi / 2, pi / 2)}
ISOSCELES = 2 * cos(t) + sin(2 * t)
THIRD = (2 * pi / 3, 2 * pi / 3)
OTHER = (4 * pi / 3, 4 * pi / 3)


@pytest.mark.parametrize(
    ("function", "box", "points", "kind"),
    [
        pytest.param(SINES, TORUS, [THIRD], "maximum", id="equilateral arrangement"),
        pytest.param(SINES, TORUS, [OTHER], "minimum", id="the same, turned round"),
        pytest.param(Abs(SINES), TORUS, [THIRD, OTHER], "maximum", id="absolute value, two points"),
        pytest.param(
            8 / Abs(SINES), TORUS, [THIRD, OTHER], "minimum", id="volume with poles inside"
        ),
        pytest.param(
            8 / Abs(ISOSCELES), HALF, [(pi / 6,)], "minimum", id="volume with poles at the ends"
        ),
        pytest.param(8 / ISOSCELES, HALF, [(pi / 6,)], "minimum", id="without absolute value"),
        pytest.param(
            sin(t), {t: (0, 4 * pi)}, [(pi / 2,), (5 * pi / 2,)], "maximum", id="two maxima"
        ),
        pytest.param(t**4 - 2 * t**2, {t: (-2, 2)}, [(-1,), (1,)], "minimum", id="double well"),
        pytest.param(t**4, {t: (-1, 1)}, [(0,)], "minimum", id="flat minimum"),
        pytest.param(tan(t) + 1 / tan(t), {t: (0, pi / 2)}, [(pi / 4,)], "minimum", id="quotients"),
        pytest.param(sqrt(t) / (1 + t), {t: (0, 9)}, [(1,)], "maximum", id="root"),
        pytest.param(
            cos(A) + cos(B) + cos(C),
            {A: (-1, 1), B: (-1, 1), C: (-1, 1)},
            [(0, 0, 0)],
            "maximum",
            id="three variables",
        ),
    ],
)
def test_extrema_are_proved(function, box, points, kind):
    assert isinstance(prove_extremum(Family(function, box), points, kind), Proved)


@pytest.mark.parametrize(
    ("function", "box", "points", "kind"),
    [
        pytest.param(8 / ISOSCELES, HALF, [(pi / 5,)], "minimum", id="wrong place"),
        pytest.param(
            8 / ISOSCELES, HALF, [(pi / 6 + sp.Rational(1, 1000),)], "minimum", id="almost right"
        ),
        pytest.param(8 / ISOSCELES, HALF, [(pi / 6,)], "maximum", id="minimum for maximum"),
        pytest.param(SINES, TORUS, [(pi / 2, pi / 2)], "maximum", id="wrong angles"),
        pytest.param(SINES, TORUS, [(pi, pi)], "minimum", id="saddle"),
        pytest.param(t**3 - t, {t: (-2, 2)}, [(1 / sqrt(3),)], "minimum", id="local minimum only"),
    ],
)
def test_wrong_extrema_are_refuted_by_a_better_point(function, box, points, kind):
    found = prove_extremum(Family(function, box), points, kind)
    assert isinstance(found, Refuted)
    values = [Fraction(found.witness.point[symbol.name]) for symbol in box]
    for value, (lower, upper) in zip(values, box.values(), strict=True):
        assert float(lower) < value < float(upper)
    at = sp.lambdify(list(box), function, "mpmath")
    best = at(*(mpmath.mpf(sp.N(x, 40)) for x in points[0]))
    better = at(*(mpmath.mpf(v.numerator) / v.denominator for v in values))
    assert better < best if kind == "minimum" else better > best


@pytest.mark.parametrize(
    ("function", "box", "points", "note"),
    [
        pytest.param(sin(t), {t: (0, 4 * pi)}, [(pi / 2,)], "attained there", id="another point"),
        pytest.param(Abs(SINES), TORUS, [THIRD], "attained there", id="another point of the torus"),
        pytest.param(sin(t), {t: (0, 1)}, [(pi / 2,)], "not inside", id="outside of the box"),
        pytest.param(sin(t), {t: (0, 7)}, [(pi / 2,), (pi,)], "the same value", id="two values"),
    ],
)
def test_other_reasons_to_refute(function, box, points, note):
    found = prove_extremum(Family(function, box), points, "maximum")
    assert isinstance(found, Refuted)
    assert note in found.note


@pytest.mark.parametrize(
    ("function", "box", "sign"),
    [
        pytest.param(cos(t), HALF, 1, id="zeros at both ends"),
        pytest.param(ISOSCELES, HALF, 1, id="triple zero at an end"),
        pytest.param(-cos(t), HALF, -1, id="negative"),
        pytest.param(1 / cos(t), HALF, 1, id="poles at both ends"),
        pytest.param(1 / t**2, {t: (-1, 1)}, 1, id="pole inside"),
        pytest.param(2 + sin(A) * cos(B), TORUS, 1, id="two variables"),
        pytest.param(
            sin(A / 2) * sin(B / 2) * (2 + sin(A + B)), TORUS, 1, id="product, zero on edges"
        ),
        pytest.param(t - sin(t), {t: (0, 1)}, 1, id="zero of third order"),
    ],
)
def test_signs_are_proved(function, box, sign):
    assert isinstance(sign_on(Family(function, box), sign), Proved)
    assert isinstance(sign_on(Family(function, box), -sign), Refuted)


@pytest.mark.parametrize(
    ("function", "box"),
    [
        pytest.param(1 - cos(t), {t: (-1, 1)}, id="touching zero"),
        pytest.param(t**2 * (t - 2) ** 2, {t: (-1, 3)}, id="two touching zeros"),
        pytest.param(1 + t**2, {t: (-1, 1)}, id="no zero"),
    ],
)
def test_a_function_that_touches_zero_has_its_sign_or_vanishes(function, box):
    assert isinstance(sign_on(Family(function, box), 1, zero=True), Proved)
    assert not isinstance(sign_on(Family(function, box), -1, zero=True), Proved)


@pytest.mark.parametrize(
    ("function", "box", "condition", "degrees"),
    [
        pytest.param(
            t**2 * (t - 1), {t: (-2, 2)}, r"t = 0 \text{ or } 1 \leq t < 2", "", id="both"
        ),
        pytest.param(-(t**2), {t: (-1, 1)}, "t = 0", "t = 0°", id="one point"),
        pytest.param(
            t / (t - 1), {t: (-1, 2)}, r"-1 < t \leq 0 \text{ or } 1 < t < 2", "", id="pole"
        ),
        pytest.param(cos(t) - 1, {t: (0, 7)}, r"t = 2 \pi", "t = 360°", id="degrees"),
    ],
)
def test_the_set_where_a_function_is_not_negative(function, box, condition, degrees):
    found = sign_on(Family(function, box), 1, zero=True)
    assert isinstance(found, OnBranch)
    assert (found.condition, found.note) == (condition, degrees)
    assert function.subs(t, sp.sympify(found.witness.point["t"])) < 0


@pytest.mark.parametrize(
    ("function", "box", "condition", "degrees"),
    [
        pytest.param(sin(t), {t: (0, 2 * pi)}, r"0 < t < \pi", "0° < t < 180°", id="half circle"),
        pytest.param(
            cos(2 * t),
            {t: (0, pi)},
            r"0 < t < \frac{\pi}{4} \text{ or } \frac{3 \pi}{4} < t < \pi",
            "0° < t < 45° or 135° < t < 180°",
            id="two intervals",
        ),
        pytest.param(tan(t), HALF, r"0 < t < \frac{\pi}{2}", "0° < t < 90°", id="tangent"),
        pytest.param(1 / t, {t: (-1, 1)}, "0 < t < 1", "", id="pole"),
        pytest.param(
            t**2, {t: (-1, 1)}, r"-1 < t < 0 \text{ or } 0 < t < 1", "", id="touching zero"
        ),
    ],
)
def test_the_set_of_a_sign_is_exact(function, box, condition, degrees):
    found = sign_on(Family(function, box), 1)
    assert isinstance(found, OnBranch)
    assert (found.condition, found.note) == (condition, degrees)
    place = sp.sympify(found.witness.point["t"])
    assert not found.relations[0].subs(t, place)
    assert function.subs(t, place) <= 0


BOTH = (True, True)
HALVES = sp.Rational(3, 2) - cos(A) - cos(B) + cos(A + B)  # least for the equilateral triangle
CUBIC = t * (t - 1) ** 2  # 4/27 at 1/3 and at 4/3, 0 at 0 and at 1


@pytest.mark.parametrize(
    ("function", "box", "closed", "points", "kind", "answer"),
    [
        pytest.param(t**2, {t: (0, 1)}, {t: BOTH}, [(0,)], "minimum", Proved, id="at an end"),
        pytest.param(t, {t: (0, 1)}, {t: BOTH}, [(1,)], "maximum", Proved, id="with a slope"),
        pytest.param(t, {t: (0, 1)}, {t: (True, False)}, [(1,)], "maximum", Refuted, id="open end"),
        pytest.param(sin(t), {t: (0, pi)}, {t: BOTH}, [(pi / 2,)], "maximum", Proved, id="inside"),
        pytest.param(sin(t), {t: (0, pi)}, {t: BOTH}, [(0,)], "minimum", Refuted, id="two ends"),
        pytest.param(
            sin(t), {t: (0, pi)}, {t: BOTH}, [(0,), (pi,)], "minimum", Proved, id="both named"
        ),
        pytest.param(
            CUBIC, {t: (0, sp.Rational(4, 3))}, {t: BOTH}, [(sp.Rational(1, 3),)], "maximum",
            Refuted, id="as large at a closed end"),
        pytest.param(
            HALVES, {A: (0, pi), B: (0, pi)}, {A: BOTH, B: BOTH}, [(pi / 3, pi / 3)], "minimum",
            Proved, id="triangle, degenerate ones too"),
        pytest.param(
            SINES, {A: (0, 2 * pi), B: (0, 2 * pi)}, {A: BOTH}, [THIRD], "maximum", Proved,
            id="two wheels at one place"),
    ],
)  # fmt: skip
def test_extrema_with_closed_ends(function, box, closed, points, kind, answer):
    assert isinstance(prove_extremum(Family(function, box), points, kind, closed), answer)


SQUARE = {A: (-1, 2), B: (-1, 2)}


@pytest.mark.parametrize(
    ("function", "box", "closed", "answer"),
    [
        pytest.param(A * B, {A: (0, 1), B: (0, 1)}, {}, Proved, id="open square"),
        pytest.param(A * B, {A: (0, 1), B: (0, 1)}, {A: BOTH}, Refuted, id="zero on an edge"),
        pytest.param(B + A * B, {A: (0, 1), B: (0, 1)}, {A: BOTH}, Proved, id="an open side"),
        pytest.param(1 / A + B, {A: (0, 1), B: (0, 1)}, {A: BOTH}, Proved, id="undefined edge"),
        pytest.param(
            A**2 + B**2, {A: (0, 1), B: (0, 2)}, {A: BOTH, B: BOTH}, Refuted, id="a corner"
        ),
        pytest.param(A**2 + B**2, {A: (0, 1), B: (0, 2)}, {A: BOTH}, Proved, id="open corner"),
        pytest.param(4 - A - B, {A: (0, 1), B: (0, 2)}, {A: BOTH, B: BOTH}, Proved, id="no corner"),
    ],
)
def test_signs_on_closed_faces(function, box, closed, answer):
    found = sign_on(Family(function, box), 1, closed=closed)
    assert isinstance(found, answer)
    if isinstance(found, Refuted):
        place = {s: sp.sympify(found.witness.point[s.name]) for s in box}
        assert function.subs(place) <= 0


@pytest.mark.parametrize(
    ("function", "upper", "zero", "condition"),
    [
        pytest.param(sin(t), 2 * pi, False, r"0 < t < \pi", id="strict"),
        pytest.param(
            sin(t), 2 * pi, True, r"0 \leq t \leq \pi \text{ or } t = 2 \pi", id="not strict"
        ),
        pytest.param(-sin(t), pi, True, r"t = 0 \text{ or } t = \pi", id="ends only"),
        pytest.param(1 - cos(t), 1, False, r"0 < t \leq 1", id="all but one end"),
    ],
)
def test_the_set_of_a_sign_on_a_closed_interval(function, upper, zero, condition):
    found = sign_on(Family(function, {t: (0, upper)}), 1, zero=zero, closed={t: BOTH})
    assert isinstance(found, OnBranch)
    assert found.condition == condition


TRIANGLE = {A: (0, pi), B: (0, pi)}
OFF_AXIS = r"A \neq 0 \text{ or } B \neq 0"


@pytest.mark.parametrize(
    ("function", "box", "condition"),
    [
        pytest.param(
            HALVES, TRIANGLE, r"A \neq \frac{\pi}{3} \text{ or } B \neq \frac{\pi}{3}", id="angles"
        ),
        pytest.param(A**2 + B**2, SQUARE, OFF_AXIS, id="origin"),
        pytest.param((A**2 + B**2) * (3 + A) / (2 + B), SQUARE, OFF_AXIS, id="factors"),
        pytest.param(
            (A**2 + B**2) * ((A - 1) ** 2 + (B - 1) ** 2), SQUARE,
            rf"({OFF_AXIS}) \text{{ and }} (A \neq 1 \text{{ or }} B \neq 1)", id="two points",
        ),
    ],
)  # fmt: skip
def test_a_function_that_touches_zero_at_points_of_a_box(function, box, condition):
    assert isinstance(sign_on(Family(function, box), 1, zero=True), Proved)
    assert not isinstance(sign_on(Family(function, box), -1, zero=True), Proved)
    found = sign_on(Family(function, box), 1)
    assert isinstance(found, OnBranch)
    assert found.condition == condition
    place = {s: sp.sympify(found.witness.point[s.name]) for s in box}
    assert function.subs(place) == 0
    assert sp.And(*found.relations).subs(place) == sp.false


@pytest.mark.parametrize(
    ("function", "answer"),
    [
        pytest.param(1 / (A**2 + B**2), Proved, id="a pole is no zero"),
        pytest.param((A**2 + B**2) / (A**2 + B**2 + 3 * A * B / 2), Proved, id="undefined there"),
        pytest.param((A - 1) ** 2 * (B + 2), Undecided, id="a line of zeros"),
        pytest.param((A - B) ** 2, Undecided, id="an oblique line of zeros"),
        pytest.param(A**4 + B**4, Undecided, id="no curvature at the zero"),
        pytest.param((A - sqrt(2) / 3) ** 2 + B**2, Undecided, id="a zero that is not recognised"),
    ],
)
def test_strict_signs_on_a_square(function, answer):
    assert isinstance(sign_on(Family(function, SQUARE), 1), answer)


@pytest.mark.parametrize(
    ("function", "box", "condition"),
    [
        pytest.param(sin(t), {t: (0, 2 * pi)}, r"0 < t \leq \pi", id="sine on a full circle"),
        pytest.param(
            cos(t),
            {t: (0, 2 * pi)},
            r"0 < t \leq \frac{\pi}{2} \text{ or } \frac{3 \pi}{2} \leq t < 2 \pi",
            id="cosine",
        ),
        pytest.param(1 / t, {t: (-1, 1)}, "-1 < t < 0", id="across a pole"),
        pytest.param(t**3, {t: (-1, 1)}, r"-1 < t \leq 0", id="cube"),
    ],
)
def test_the_set_of_concavity_is_exact(function, box, condition):
    found = concave(Family(function, box))
    assert isinstance(found, OnBranch)
    assert found.condition == condition


@pytest.mark.parametrize(
    ("function", "box", "answer"),
    [
        pytest.param(sin(t), {t: (0, pi)}, Proved, id="sine"),
        pytest.param(sqrt(t), {t: (0, 4)}, Proved, id="root"),
        pytest.param(-(t**4), {t: (-1, 1)}, Proved, id="flat top"),
        pytest.param(3 * t + 1, {t: (-1, 1)}, Proved, id="linear"),
        pytest.param(t**2, {t: (-1, 1)}, Refuted, id="convex"),
        pytest.param(A * B, {A: (0, 1), B: (0, 1)}, Undecided, id="two variables"),
    ],
)
def test_concavity(function, box, answer):
    assert isinstance(concave(Family(function, box)), answer)


@pytest.mark.parametrize(
    "family",
    [
        pytest.param(Family(sp.gamma(t), {t: (1, 2)}), id="unknown function"),
        pytest.param(Family(t * A, {t: (0, 1)}), id="symbol without range"),
        pytest.param(Family(t, {t: (0, sp.oo)}), id="unbounded range"),
        pytest.param(Family(t, {t: (1, 0)}), id="empty range"),
        pytest.param(Family(sp.nan, {t: (0, 1)}), id="nan"),
        pytest.param(Family(1 / sp.Integer(0) + t, {t: (0, 1)}), id="zoo"),
        pytest.param(Family(cos(t) - t, {t: (0, 1)}), id="zero without closed form"),
        pytest.param(Family(sp.Float(0.1) * t - 1, {t: (0, 100)}), id="float"),
    ],
)
def test_what_cannot_be_decided_is_undecided(family):
    for found in (
        sign_on(family, 1),
        concave(family) if family.expression != cos(t) - t else Undecided(""),
        prove_extremum(family, [(sp.Rational(1, 2),)], "minimum"),
    ):
        assert isinstance(found, (Undecided, Refuted)), found
    assert isinstance(sign_on(family, 1), Undecided)
