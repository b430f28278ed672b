"""What follows for this paper's quantities and the paper does not print."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import (
    Expr,
    ImmutableMatrix,
    Integer,
    MatrixBase,
    Rational,
    Symbol,
    cos,
    exp,
    eye,
    limit,
    oo,
    pi,
    sin,
    symbols,
)

from omniproof.kinematics import trajectory
from omniproof.papers.omni_trajectory.setup import (
    ANGLES,
    CIRCLES,
    DURATION,
    LINES,
    RADII,
    Case,
    lengthwise_and_across,
    twist,
)
from omniproof.registry import Family, Obligation, Step, Theorem
from omniproof.transcription.model import Form

PAPER = ("omni-trajectory",)

TIME = Symbol("t", positive=True)
RADIUS = Symbol("L", positive=True)
SPEEDS = symbols("a b c", real=True)
FREQUENCY, GROWTH = symbols("nu k", real=True, nonzero=True)
TWIST = ImmutableMatrix(symbols("V_x V_y omega", real=True))
FIRST, SECOND = (
    ImmutableMatrix([*symbols(f"{name}_x {name}_y", real=True), 0]) for name in ("A", "B")
)
SPIN_UP = ImmutableMatrix([FIRST[0], FIRST[1], Symbol("beta", positive=True)])


def _equal(*values: Expr) -> Obligation:
    return Obligation(Form.EQUAL, values)


def _all_equal(left: MatrixBase, right: MatrixBase) -> list[Obligation]:
    return [_equal(*pair) for pair in zip(left, right, strict=True)]


def _rising(*numbers: Expr) -> Obligation:
    return Obligation(Form.INCREASING, numbers)


def _integrates(path: MatrixBase, moving: MatrixBase) -> list[Obligation]:
    """Prove a closed form: its derivative is the integrand, and it starts at the origin."""
    origin = ImmutableMatrix([0, 0])
    return [
        *_all_equal(path.diff(TIME), trajectory.path_integrands(moving, TIME)),
        *_all_equal(path.subs(TIME, 0), origin),
    ]


# Constant speeds


def _circle_by_integration() -> Sequence[Obligation]:
    return _integrates(trajectory.constant_speed_path(TWIST, TIME), TWIST)


def _circle_as_chord() -> Sequence[Obligation]:
    half = TWIST[2] * TIME / 2
    chord = 2 * sin(half) / TWIST[2] * trajectory.rotation(half) * TWIST[:2, :]
    return _all_equal(trajectory.constant_speed_path(TWIST, TIME), chord)


def _on_the_circle() -> Sequence[Obligation]:
    offset = trajectory.constant_speed_path(TWIST, TIME) - trajectory.circle_centre(TWIST)
    square = offset.dot(offset)
    return [_equal(square, trajectory.circle_radius(TWIST) ** 2)]


def _on_the_spot() -> Sequence[Obligation]:
    (speed, _, _) = SPEEDS
    turning = trajectory.body_twist(ANGLES, RADIUS, [speed] * 3)
    return _all_equal(turning, ImmutableMatrix([0, 0, speed / RADIUS]))


def _turning_of_the_velocity() -> Sequence[Obligation]:
    angle = Symbol("x", real=True)
    difference = (trajectory.rotation(angle) - eye(2)) * TWIST[:2, :]
    square = trajectory.speed(TWIST) ** 2
    return [_equal(difference.dot(difference), square * (2 * sin(angle / 2)) ** 2)]


def _sine_below_its_angle() -> Sequence[Obligation]:
    angle = Symbol("x", real=True)
    below = Family(angle - 2 * sin(angle / 2), {angle: (Integer(0), 2 * pi)})
    return [Obligation(Form.POSITIVE, below)]


def _limit_of_the_circle() -> Sequence[Obligation]:
    path = trajectory.constant_speed_path(TWIST, TIME)
    straight = ImmutableMatrix([TWIST[0], TWIST[1], 0])
    return _all_equal(
        path.applyfunc(lambda coordinate: limit(coordinate, TWIST[2], 0)),
        trajectory.constant_speed_path(straight, TIME),
    )


def _spread_and_mean() -> Sequence[Obligation]:
    moving = trajectory.body_twist(ANGLES, RADIUS, SPEEDS)
    mean = sum(SPEEDS, Integer(0)) / 3
    variance = sum(((speed - mean) ** 2 for speed in SPEEDS), Integer(0)) / 3
    return [
        _equal(moving[0] ** 2 + moving[1] ** 2, 2 * variance),
        _equal(RADIUS * moving[2], mean),
    ]


# Speeds that change


def _common_profile() -> Sequence[Obligation]:
    decay = Symbol("k", positive=True)
    fading, swinging = exp(-decay * TIME), cos(FREQUENCY * TIME)
    closed = [
        obligation
        for profile in (fading, swinging)
        for obligation in _integrates(
            trajectory.common_profile_path(TWIST, profile, TIME), TWIST * profile
        )
    ]
    clock = trajectory.heading(fading, TIME)
    return [*closed, _equal(limit(clock, TIME, oo), 1 / decay)]


def _exponential() -> Sequence[Obligation]:
    path = trajectory.exponential_path(TWIST, FIRST, GROWTH, TIME)
    return _integrates(path, TWIST + FIRST * exp(GROWTH * TIME))


def _sinusoidal() -> Sequence[Obligation]:
    path = trajectory.sinusoidal_path(TWIST, FIRST, SECOND, FREQUENCY, TIME)
    return _integrates(path, _swinging(FREQUENCY))


def _resonant() -> Sequence[Obligation]:
    path = trajectory.sinusoidal_path(TWIST, FIRST, SECOND, TWIST[2], TIME)
    drift = (FIRST[:2, :] + trajectory.QUARTER_TURN * SECOND[:2, :]) / 2
    growing = path.applyfunc(lambda coordinate: coordinate.expand().coeff(TIME))
    return [*_integrates(path, _swinging(TWIST[2])), *_all_equal(growing, drift)]


def _swinging(frequency: Expr) -> MatrixBase:
    return TWIST + FIRST * cos(frequency * TIME) + SECOND * sin(frequency * TIME)


def _linear() -> Sequence[Obligation]:
    return _integrates(trajectory.linear_path(TWIST, SPIN_UP, TIME), TWIST + SPIN_UP * TIME)


# The printed speeds


def _between(low: str, number: Expr, high: str) -> Obligation:
    return _rising(Rational(low), number, Rational(high))


def _degrees(angle: Expr) -> Expr:
    return angle * 180 / pi


def _speeds_of_all() -> Sequence[Obligation]:
    cases = (*CIRCLES, *LINES)
    speeds = (trajectory.speed(twist(case, RADIUS)) for case in cases)
    return [_between("0.0497", speed, "0.0501") for speed in speeds]


def _exact_lines() -> Sequence[Obligation]:
    straight = (LINES[1], LINES[3])
    return [
        obligation
        for case in straight
        for obligation in (
            _equal(twist(case, RADIUS)[2], Integer(0)),
            _equal(lengthwise_and_across(case, RADIUS)[1], Integer(0)),
        )
    ]


def _bent_lines() -> Sequence[Obligation]:
    bounds = {"Section 3.1": ("0.160", "0.161", "0.627", "0.628", "53.5", "53.6"),
              "Table 1": ("0.127", "0.128", "0.584", "0.585", "67.2", "67.3")}  # fmt: skip
    return [
        obligation
        for place, ends in bounds.items()
        for case, left in ((LINES[0], 1), (LINES[2], -1))
        for obligation in _bent(case, RADII[place], left, ends)
    ]


def _bent(case: Case, radius: Expr, left: int, ends: Sequence[str]) -> list[Obligation]:
    """Bounds of the turn (degrees), the place across (mm) and the radius (m) of a bent line."""
    moving = twist(case, radius)
    found = (
        left * _degrees(moving[2] * DURATION),
        left * 1000 * lengthwise_and_across(case, radius)[1],
        trajectory.circle_radius(moving),
    )
    pairs = zip(ends[::2], ends[1::2], strict=True)
    return [_between(low, x, high) for x, (low, high) in zip(found, pairs, strict=True)]


def _arcs() -> Sequence[Obligation]:
    bounds = {"Section 3.1": ("108.5", "108.7", "0.0789", "0.0791"),
              "Table 1": ("86.4", "86.6", "0.0991", "0.0993")}  # fmt: skip
    obligations = []
    for place, (least, most, inner, outer) in bounds.items():
        for case, left in zip(CIRCLES, (1, -1), strict=True):
            moving = twist(case, RADII[place])
            turn = left * _degrees(moving[2] * DURATION)
            obligations += [_between(least, turn, most),
                            _between(inner, trajectory.circle_radius(moving), outer)]  # fmt: skip
    return obligations


def _directions() -> Sequence[Obligation]:
    """The initial velocity of both circles, and of two lines, points exactly where it should."""
    return [
        _equal((trajectory.rotation(-case.direction) * twist(case, RADIUS)[:2, :])[1], Integer(0))
        for case in (*CIRCLES, LINES[1], LINES[3])
    ]


# The error measure


def _start_of_a_path() -> Sequence[Obligation]:
    path = trajectory.constant_speed_path(TWIST, TIME)
    still = path.subs(TIME, 0)
    velocity = path.diff(TIME).subs(TIME, 0)
    return [*_all_equal(still, ImmutableMatrix([0, 0])), *_all_equal(velocity, TWIST[:2, :])]


def _turned_path() -> Sequence[Obligation]:
    angle = Symbol("delta", real=True)
    place = FIRST[:2, :]
    apart = (trajectory.rotation(angle) - eye(2)) * place
    return [_equal(apart.dot(apart), (2 * sin(angle / 2)) ** 2 * place.dot(place))]


def _full_turn() -> Sequence[Obligation]:
    path = trajectory.constant_speed_path(TWIST, TIME)
    period = 2 * pi / TWIST[2]
    return [
        *_all_equal(path.subs(TIME, period), ImmutableMatrix([0, 0])),
        *_all_equal(path.diff(TIME).subs(TIME, period), TWIST[:2, :]),
    ]


THEOREMS = (
    Theorem(
        "thm:constant-speeds",
        "Constant wheel speeds: a circle in one formula",
        r"Let the twist $(V_x, V_y, \omega)$ be constant, $\omega \ne 0$. At the time $t$ the "
        r"robot is at the end of the chord $\frac{2}{\omega}\sin\frac{\omega t}{2}\, "
        r"\mathbf{R}(\frac{\omega t}{2})\, (V_x, V_y)^T$, which points along the first velocity "
        r"turned by half of the heading. It stays on the circle about "
        r"$\frac{1}{\omega}(-V_y, V_x)$ of radius $\|V\|/|\omega|$, "
        r"and runs counter-clockwise for $\omega > 0$.",
        PAPER,
        (
            Step("The closed form has the right derivative and start.", _circle_by_integration),
            Step("It is the chord.", _circle_as_chord),
            Step("The distance from the centre is the radius.", _on_the_circle),
        ),
    ),
    Theorem(
        "thm:circle-to-line",
        "How far a circle is from its line",
        r"When $a + b + c$ tends to 0, the circle tends to the line $(V_x t, V_y t)$, and at no "
        r"time is it further from it than $\frac{1}{2}\|V\|\,|\omega|\,t^2$. When $a = b = c$, the "
        r"robot turns on the spot with $\omega = a/L$.",
        PAPER,
        (
            Step("The limit of both coordinates.", _limit_of_the_circle),
            Step(
                r"A velocity that has turned by $x$ differs from the first one by "
                r"$2|\sin\frac{x}{2}|$ times the speed.",
                _turning_of_the_velocity,
            ),
            Step(
                r"For $|x| < 2\pi$ that is less than $|x| = |\omega| t$ times the speed, and "
                r"beyond, 2 is; integrate over $t$.",
                _sine_below_its_angle,
            ),
            Step("Equal speeds give no translation.", _on_the_spot),
        ),
    ),
    Theorem(
        "thm:spread-and-mean",
        "Speed is the spread of the wheel speeds, rotation their mean",
        r"For the equilateral arrangement, $\|V\|$ is $\sqrt{2}$ times the standard deviation of "
        r"$a, b, c$ (the root of the mean squared deviation, with the divisor 3), and $L\omega$ is "
        r"their mean. So the radius of the circle is "
        r"$\sqrt{2}\,L$ times the standard deviation over the absolute mean, and the motion "
        r"is straight exactly when the mean is 0.",
        PAPER,
        (Step("The sum of squares of the twist, by wheel speeds.", _spread_and_mean),),
    ),
    Theorem(
        "thm:closed-forms",
        "Paths in closed form for wheel speeds that change",
        r"(1) Wheel speeds $f(t)\cdot(a, b, c)$ with one common profile $f$ run through the circle "
        r"of $(a, b, c)$ by the clock $F(t) = \int_0^t f$: the decay $f = e^{-kt}$ ends after the "
        r"length $\|V\|/k$. (2) With a constant sum, exponential and sinusoidal speeds "
        r"give elementary paths; in resonance, at the frequency of the rotation, the robot drifts "
        r"away with the velocity $\frac{1}{2}(A_x - B_y, A_y + B_x)$, for $A\cos\omega t + "
        r"B\sin\omega t$ in its own axes. (3) Speeds that grow linearly give Fresnel integrals.",
        PAPER,
        (
            Step("A common profile, exponential or sinusoidal.", _common_profile),
            Step("Exponential speeds with a constant sum.", _exponential),
            Step("Sinusoidal speeds with a constant sum.", _sinusoidal),
            Step("The same in resonance, and the drift.", _resonant),
            Step("Linear speeds, with Fresnel's integrals.", _linear),
        ),
    ),
    Theorem(
        "thm:printed-lines",
        "Two of the four straight lines are bent",
        r"With the rates of Table 4 and $r = 0.023$ m the robot moves at 0.0497 to 0.0501 m/s, "
        r"that is 0.15 m in 3 s. The lines for 30° and 90° are straight and exact. The rates for "
        r"0° and 60° add up to $\pm 0.1$ rpm: these paths are arcs of radius 53.6 m "
        r"($L = 0.086$ m) or 67.3 m ($L = 0.108$ m), and after 3 s the robot has "
        r"turned by 0.16° or 0.13° and is 0.63 or 0.58 mm beside the intended line.",
        PAPER,
        (
            Step("Speeds of all cases of Tables 3 and 4.", _speeds_of_all),
            Step("No rotation, and nothing across the line.", _exact_lines),
            Step("Turn, place across and radius of the other two.", _bent_lines),
        ),
    ),
    Theorem(
        "thm:printed-circles",
        "Both circles are arcs of about a quarter turn",
        r"With the rates of Table 3 and $r = 0.023$ m both runs start exactly at 60°. In 3 s the "
        r"robot turns by 108.5° to 108.7° on a circle of radius 0.079 m if $L = 0.086$ m, and by "
        r"86.4° to 86.6° on one of 0.099 m if $L = 0.108$ m, counter-clockwise and clockwise.",
        PAPER,
        (
            Step("The velocity at the start has no part across 60°.", _directions),
            Step("Turn and radius for both body radii.", _arcs),
        ),
    ),
    Theorem(
        "thm:error-measure",
        "What the error measure (17) measures",
        r"For paths of constant twists the integrand of (17) is 0/0 at $t = 0$; it tends to "
        r"$\|V_t - V_e\|/\|V_t\|$ there. A path turned as a whole by $\delta$ has the error "
        r"$2|\sin\frac{\delta}{2}|$, and the length error $|1 - L^e/L^m| = 0$. If the theoretical "
        r"path closes within $T$, that is $T \ge 2\pi/|\omega|$, the integral diverges unless the "
        r"other path is at the origin at that moment too.",
        PAPER,
        (
            Step("A path starts at the origin with its velocity $V$.", _start_of_a_path),
            Step("A turn moves each place by a multiple of its distance.", _turned_path),
            Step(
                "After a full turn the path is at the origin, with nonzero velocity: a pole of "
                "first order.",
                _full_turn,
            ),
        ),
    ),
)
