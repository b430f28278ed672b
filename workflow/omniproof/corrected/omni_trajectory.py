"""Corrected formulas of the paper on trajectories of a platform on three omni rollers, for NumPy.

Speeds of the rollers' rims in m/s, body radius L in m; arrays are broadcast.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from omniproof.corrected.answer import Answer, Answers, Line
from omniproof.corrected.formula import Array, Formula, Functions
from omniproof.corrected.sampled import sampled_integral


def path_x(time: ArrayLike, nu_1: ArrayLike, nu_2: ArrayLike, nu_3: ArrayLike, L: float) -> Array:
    """Return X in the world up to each time, m, `(n,)`, from samples of the speeds: Eq. (8)."""
    return sampled_integral(_X, time, {"v_1": nu_1, "v_2": nu_2, "v_3": nu_3}, L=L)


def path_y(time: ArrayLike, nu_1: ArrayLike, nu_2: ArrayLike, nu_3: ArrayLike, L: float) -> Array:
    """Return Y in the world up to each time, m, `(n,)`, from samples of the speeds: Eq. (9)."""
    return sampled_integral(_Y, time, {"v_1": nu_1, "v_2": nu_2, "v_3": nu_3}, L=L)


def circle_radius(a: ArrayLike, b: ArrayLike, c: ArrayLike, L: ArrayLike) -> Array:
    """Return the radius of the circular path for constant speeds a, b, c, m: Eq. (13)."""
    return _RADIUS(a=a, b=b, c=c, L=L)


def direction(x_velocity: ArrayLike, y_velocity: ArrayLike, phi: ArrayLike) -> Array:
    """Return the direction of travel in the world, rad in (-pi, pi]: Eq. (14).

    x_velocity, y_velocity: in the frame of the platform, m/s; phi: its heading, rad.
    """
    return _DIRECTION(X_m=x_velocity, Y_m=y_velocity, phi=phi)


def initial_direction(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> Array:
    """Return the direction of travel at the start, rad in (-pi, pi]: Eq. (14), right side."""
    return _INITIAL(a=a, b=b, c=c)


def centre_factor(a: ArrayLike, b: ArrayLike, c: ArrayLike, L: ArrayLike) -> Array:
    """Return the factor of `centre_vector`, s: Eq. (16). The product is the centre, in m."""
    return _FACTOR(a=a, b=b, c=c, L=L)


def centre_vector(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> Array:
    """Return three times the initial velocity, turned by 90 degrees, m/s, `(..., 2)`: Eq. (16)."""
    return _VECTOR(a=a, b=b, c=c)


def centre(a: ArrayLike, b: ArrayLike, c: ArrayLike, L: ArrayLike) -> Array:
    """Return the centre of the circular path that starts at the origin, m, `(..., 2)`: Eq. (16)."""
    return centre_factor(a, b, c, L)[..., None] * centre_vector(a, b, c)


_PAPER = "omni-trajectory"
_X = Formula(_PAPER, "eq:8")
_Y = Formula(_PAPER, "eq:9")
_RADIUS = Formula(_PAPER, "eq:13")
_DIRECTION = Formula(_PAPER, "eq:14/velocities")
_INITIAL = Formula(_PAPER, "eq:14/speeds")
_FACTOR = Formula(_PAPER, "eq:16/factor")
_VECTOR = Formula(_PAPER, "eq:16/line-1")

FUNCTIONS: Functions = {
    "eq:8": path_x,
    "eq:9": path_y,
    "eq:13": circle_radius,
    "eq:14/velocities": direction,
    "eq:14/speeds": initial_direction,
    "eq:16/factor": centre_factor,
    "eq:16/line-1": centre_vector,
}

_SPEEDS = r"\begin{pmatrix} v_1 \\ v_2 \\ v_3 \end{pmatrix}"

_SAMPLES = "np.linspace(0, 1, 11), np.ones(11), np.ones(11), np.zeros(11), L=0.2"
_WHEELS = "a=0.1, b=-0.2, c=0.4"

ANSWERS: Answers = {
    "eq:1": Answer(
        "wheel matrix", (Line(rf"{_SPEEDS} = <eq:1> <eq:1/twist>", ("eq:1",), name="A"),)
    ),
    "eq:2": Answer("speeds of the rims", (Line(rf"{_SPEEDS} = <eq:2>"),)),
    "eq:3": Answer(
        "wheel matrix of the equilateral arrangement",
        (Line(rf"{_SPEEDS} = <eq:3> <eq:3/twist>", ("eq:3",), name="A"),),
    ),
    "eq:4": Answer(
        "its inverse", (Line(rf"<eq:3/twist> = <eq:4> {_SPEEDS}", ("eq:4",), name="inverse"),)
    ),
    "eq:5": Answer("yaw rate", (Line(r"\dot{\phi} = <eq:5>", name="yaw_rate"),)),
    "eq:7": Answer(
        "from the robot to the world",
        (
            Line("<eq:7/world>"),
            Line("<eq:7/body>"),
            Line("<eq:7>", name="T"),
        ),
    ),
    "eq:8": Answer(
        "path, first coordinate",
        (Line("X_W = <eq:8>", function=path_x, call=f"path_x({_SAMPLES})"),),
        "The thirds of the inverse, Eq. (4), are missing: a path comes out three times too long.",
    ),
    "eq:9": Answer(
        "path, second coordinate",
        (Line("Y_W = <eq:9>", function=path_y, call=f"path_y({_SAMPLES})"),),
        "The thirds of the inverse, Eq. (4), are missing: a path comes out three times too long.",
    ),
    "eq:11": Answer("speed", (Line(r"\|\mathbb{V}_{\mathcal{W}}\| <eq:11>", name="speed"),)),
    "eq:12": Answer("speed", (Line(r"\|\mathbb{V}_{\mathcal{W}}\| <eq:12>", name="speed"),)),
    "eq:13": Answer(
        "radius of the circle",
        (
            Line(
                r"\mathcal{R} <eq:13>",
                function=circle_radius,
                call=f"circle_radius({_WHEELS}, L=0.2)",
            ),
        ),
        "A ratio of speeds is no length: a robot twice as large runs on a circle twice as large.",
    ),
    "eq:14": Answer(
        "direction of travel",
        (
            Line(
                r"\psi = <eq:14/velocities>",
                function=direction,
                call="direction(x_velocity=0.3, y_velocity=0.1, phi=0.5)",
            ),
            Line(
                r"\psi = <eq:14/speeds>",
                function=initial_direction,
                call=f"initial_direction({_WHEELS})",
            ),
        ),
        "The tangent of a direction is $\\dot{Y}/\\dot{X}$, and the opposite one has it, too.",
    ),
    "eq:15": Answer("centre of the circle", (Line(r"\mathbb{O}_R = <eq:15>"),)),
    "eq:16": Answer(
        "centre of the circle",
        (
            Line(
                r"\mathbb{O}_R = <eq:16/factor> <eq:16/line-1>",
                ("eq:16/factor", "eq:16/line-1"),
                function=centre,
                call=f"centre({_WHEELS}, L=0.2)",
            ),
            Line(r"\mathbb{O}_R <eq:16/line-2>", name="centre"),
        ),
        "Turned by a right angle, $(x, y)$ becomes $(-y, x)$; and the vector is three times the "
        "velocity, so that of the factor $3L/(a+b+c)$ the third is left.",
    ),
}
