"""Curves whose shape textbooks give, and curves that only look like one; chains of inequalities."""

from __future__ import annotations

from typing import Any

import pytest
from sympy import Abs, Integer, Rational, cos, oo, pi, sin, sqrt, symbols, tan

from omniproof.audit.relations import judge
from omniproof.decide import zero_test
from omniproof.decide.answer import DisagreementError, OnBranch, Proved, Refuted, Undecided
from omniproof.registry import Curve, Family, Obligation, Ordered
from omniproof.transcription.model import Form

t, c, alpha, x, y = symbols("t c alpha x y", real=True)
R, a, b = symbols("R a b", positive=True)
TURN = {t: (Integer(0), 2 * pi)}
LINE = {t: (-oo, oo)}
UNIT = {t: (-1, 1)}
QUARTER = {t: (Integer(0), pi / 2)}
HALF_ANGLE = (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)


def curve(form: str, *coordinates: Any, box: Any = TURN, why: str, note: str = "") -> Any:
    return pytest.param(Form(form), Curve(coordinates, box), note, id=f"{form}: {why}")


PROVED = [
    curve("circle", 1 + R * cos(t), 2 + R * sin(t), why="by its definition",
          note="centre $(1, 2)$, radius $R$"),
    curve("circle", R * cos(t), R * sin(t), box={t: (0, pi / 7)}, why="an arc of one",
          note="centre $(0, 0)$, radius $R$"),
    curve("circle", *HALF_ANGLE, box=LINE, why="tangent of the half angle",
          note="centre $(0, 0)$, radius $1$"),
    curve("circle", cos(t) ** 2, sin(t) * cos(t), why="Thales: r = cos t",
          note=r"centre $(\frac{1}{2}, 0)$, radius $\frac{1}{2}$"),
    curve("circle", cos(t), sin(t) * cos(alpha), sin(t) * sin(alpha), why="a tilted one",
          note="centre $(0, 0)$, radius $1$"),
    curve("circle", R * sin(t / R), R * cos(t / R), box=LINE, why="by arc length",
          note="centre $(0, 0)$, radius $R$"),
    curve("circle", t, sqrt(1 - t**2), box=UNIT, why="the upper half as a graph",
          note="centre $(0, 0)$, radius $1$"),
    curve("circle", Abs(cos(t)), Abs(sin(t)), why="a quarter, run through to and fro",
          note="centre $(0, 0)$, radius $1$"),
    curve("line", cos(t), 1 + 2 * cos(t), why="y = 1 + 2x, a segment of it",
          note="through $(1, 3)$ along $(-2, -4)$"),
    curve("line", t, t + a, box=LINE, why="y = x + a", note="through $(0, a)$ along $(1, 1)$"),
    curve("line", t, sin(alpha) * t, cos(alpha) * t, box=UNIT, why="in space"),
    curve("line", t, Abs(t), box={t: (1, 2)}, why="|t| = t there"),
    curve("ellipse", a * cos(t), b * sin(t), why="by its definition",
          note="centre $(0, 0)$, semi-axes $a$, $b$"),
    curve("ellipse", a * HALF_ANGLE[0], b * HALF_ANGLE[1], box=LINE, why="rational",
          note="centre $(0, 0)$, semi-axes $a$, $b$"),
    curve("ellipse", t, 2 * sqrt(1 - t**2), box=UNIT, why="the upper half as a graph",
          note="centre $(0, 0)$, semi-axes $2$, $1$"),
    curve("ellipse", 5 + cos(t), 2 * sin(t) - 1, box={t: (0, Rational(1, 10))}, why="a short arc",
          note="centre $(5, -1)$, semi-axes $2$, $1$"),
    curve("ellipse", cos(t), sin(t), cos(t) + 2 * sin(t), why="a plane through a cylinder",
          note=r"centre $(0, 0)$, semi-axes $\sqrt{6}$, $1$"),
    curve("ellipse", R * cos(t), R * sin(t), why="a circle is one",
          note="centre $(0, 0)$, semi-axes $R$, $R$"),
]  # fmt: skip
REFUTED = [
    curve("circle", R * cos(t), 2 * R * sin(t), why="an ellipse is none"),
    curve("circle", cos(t), sin(t), sin(2 * t), why="not plane"),
    curve("circle", t, t**2, box=UNIT, why="a parabola is none"),
    curve("circle", cos(t), cos(t), why="a segment is none"),
    curve("line", t, t**2, box={t: (0, Rational(1, 10))}, why="almost straight"),
    curve("line", Integer(1), Integer(2), why="a point is none"),
    curve("line", t, Abs(t), box=UNIT, why="two half-lines"),
    curve("ellipse", t, 1 / t, box={t: (0, oo)}, why="a hyperbola is none"),
    curve("ellipse", t, t**2, box=UNIT, why="a parabola is none"),
    curve("ellipse", cos(t), sin(2 * t), why="a Lissajous figure is none"),
    curve("ellipse", cos(t), 1 - cos(t), why="a segment is none"),
]  # fmt: skip


@pytest.mark.parametrize(("form", "subject", "note"), PROVED)
def test_shapes_are_proved(form: Form, subject: Curve, note: str) -> None:
    answer = judge(Obligation(form, subject))
    assert isinstance(answer, Proved)
    assert not note or answer.note == note


@pytest.mark.parametrize(("form", "subject", "note"), REFUTED)
def test_other_shapes_are_refuted(form: Form, subject: Curve, note: str) -> None:
    answer = judge(Obligation(form, subject))
    assert isinstance(answer, Refuted)
    assert answer.witness.printed != answer.witness.derived


@pytest.mark.parametrize(
    ("form", "curve_", "engines"),
    [
        pytest.param("line", Curve((cos(t), 1 + 2 * cos(t)), TURN), "flint+modular+z3",
                     id="no root"),
        pytest.param("circle", Curve((t, sqrt(1 - t**2)), UNIT), "flint+modular+z3",
                     id="the square of a root is none"),
        pytest.param("line", Curve((sqrt(1 + t**2), 2 * sqrt(1 + t**2)), UNIT), "flint+modular+z3",
                     id="a root that cancels"),
    ],
)  # fmt: skip
def test_engines_that_prove_every_step_are_named(form: str, curve_: Curve, engines: str) -> None:
    answer = judge(Obligation(Form(form), curve_))
    assert "+".join(answer.engines) == engines


@pytest.mark.parametrize(
    ("form", "coordinates"),
    [
        pytest.param("line", (cos(t), sin(t)), id="no line"),
        pytest.param("circle", (2 * cos(t), sin(t)), id="no circle"),
        pytest.param("ellipse", (cos(t), sin(2 * t)), id="no ellipse"),
    ],
)
def test_a_first_engine_to_which_all_is_zero_is_caught(
    form: str, coordinates: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(zero_test._Probe, "differs", property(lambda _: False))
    monkeypatch.setattr(zero_test.NormalForm, "is_zero", property(lambda _: True))
    with pytest.raises(DisagreementError, match=r"^modular contradicts flint on "):
        judge(Obligation(Form(form), Curve(coordinates, TURN)))


def test_a_radius_that_may_be_zero_is_a_condition() -> None:
    answer = judge(Obligation(Form.CIRCLE, Curve((c * cos(t), c * sin(t)), TURN)))
    assert isinstance(answer, OnBranch)
    assert (answer.condition, dict(answer.witness.point)) == (r"c \neq 0", {"c": "0"})


def test_what_is_no_curve_is_undecided() -> None:
    surface = Curve((x, y, x * y), {x: (0, 1), y: (0, 1)})
    assert judge(Obligation(Form.LINE, surface)) == Undecided(
        "a curve has one parameter and two or three coordinates", ("flint",)
    )
    assert isinstance(judge(Obligation(Form.CIRCLE, Family(t, TURN))), Undecided)
    assert isinstance(judge(Obligation(Form.POSITIVE, Curve((t, t), TURN))), Undecided)


@pytest.mark.parametrize(
    ("terms", "box", "expected"),
    [
        pytest.param((sin(t), t, tan(t)), QUARTER, Proved, id="sin t < t < tan t"),
        pytest.param((x * y, x, Integer(2)), {x: (0, 1), y: (0, 1)}, Proved, id="two variables"),
        pytest.param((x, y), {x: (0, 1), y: (0, 1)}, Refuted, id="two free numbers"),
        pytest.param((cos(t), sin(t)), {t: (0, pi / 4)}, Refuted, id="holds nowhere"),
        pytest.param((sin(t), cos(t), sin(t)), QUARTER, Refuted, id="never both ways"),
        pytest.param((t,), QUARTER, Undecided, id="one term"),
    ],
)
def test_chains(terms: Any, box: Any, expected: type) -> None:
    assert isinstance(judge(Obligation(Form.CHAIN, Ordered(terms, box))), expected)


@pytest.mark.parametrize(
    ("terms", "condition", "fails"),
    [
        pytest.param((sin(t), cos(t), Integer(1)), r"0 < t < \frac{\pi}{4}",
                     r"it fails for $\frac{\pi}{4} \leq t < \frac{\pi}{2}$ (45° ≤ t < 90°)",
                     id="up to 45 degrees"),
        pytest.param((Rational(1, 2), sin(t), sqrt(3) / 2), r"\frac{\pi}{6} < t < \frac{\pi}{3}",
                     r"it fails for $0 < t \leq \frac{\pi}{6}$ or "
                     r"$\frac{\pi}{3} \leq t < \frac{\pi}{2}$ (0° < t ≤ 30° or 60° ≤ t < 90°)",
                     id="each link fails elsewhere"),
        pytest.param((Integer(0), cos(2 * t) ** 2, Integer(2)),
                     r"0 < t < \frac{\pi}{4} \text{ or } \frac{\pi}{4} < t < \frac{\pi}{2}",
                     r"it fails for $t = \frac{\pi}{4}$ (t = 45°)", id="in one point"),
    ],
)  # fmt: skip
def test_a_chain_that_fails_shows_where(terms: Any, condition: str, fails: str) -> None:
    answer = judge(Obligation(Form.CHAIN, Ordered(terms, QUARTER)))
    assert isinstance(answer, OnBranch)
    assert (answer.condition, answer.note) == (condition, fails)
