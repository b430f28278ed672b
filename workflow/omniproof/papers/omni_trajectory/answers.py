"""Tables that answer the questions of the chapter: which set-ups, which paths, which closed forms.

The set-up is solved from the printed rates: each cell confines the speed V, and in Table 3 the yaw
rate too, to the numbers that its decimal stands for. Since nobody knows how the authors cut their
digits, this is done for rounding, for truncation, and for either.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain

from sympy import Expr, ImmutableMatrix, Matrix, Rational, Symbol, cos, exp, pi, sin

from omniproof.audit.ranges import Reading, show
from omniproof.audit.setups import Cell, Solution, read_as, readings_left, solve
from omniproof.decide.answer import Undecided
from omniproof.decide.balls import format_ball
from omniproof.decide.in_sympy.balls import evaluate
from omniproof.kinematics import quadrature, trajectory
from omniproof.kinematics.omni import wheel_matrix
from omniproof.papers.omni_trajectory.setup import (
    ANGLES,
    CIRCLES,
    DURATION,
    LINES,
    RADII,
    ROLLER_RADIUS,
    Case,
    lengthwise_and_across,
    path,
    twist,
)

SPEED = Symbol("V", positive=True)
YAW_RATE = Symbol("w", positive=True)
LETTERS = {SPEED: "V", YAW_RATE: r"\dot\phi"}

PER_MINUTE = 30 / pi / ROLLER_RADIUS
"""From a wheel speed in m/s to its rate in rpm."""

ROUND_SPEED = Rational(1, 20)
"""The one speed of two digits that fits all cells, in m/s."""


def rate_cells(body_radius: Expr) -> list[Cell]:
    """Cells N_1, N_2, N_3 of both tables as functions of the speed V and the yaw rate w."""
    senses = {CIRCLES[0]: YAW_RATE, CIRCLES[1]: -YAW_RATE}
    return list(
        chain.from_iterable(
            _cells(case, senses.get(case, Rational(0)), body_radius) for case in (*CIRCLES, *LINES)
        )
    )


def _cells(case: Case, yaw_rate: Expr, body_radius: Expr) -> list[Cell]:
    """Cells of one case: the wheel matrix on V in the intended direction."""
    intended = Matrix([SPEED * cos(case.direction), SPEED * sin(case.direction), yaw_rate])
    rates = PER_MINUTE * wheel_matrix(ANGLES, body_radius) * intended
    named = enumerate(zip(case.rates_rpm, rates, strict=True), 1)
    return [Cell(f"{case.name}, N_{k}", printed, rate.expand()) for k, (printed, rate) in named]


def _of(cases: Iterable[Case], cells: Sequence[Cell]) -> list[Cell]:
    starts = tuple(f"{case.name}," for case in cases)
    return [cell for cell in cells if cell.name.startswith(starts)]


def speeds_by_reading() -> list[list[str]]:
    """Speeds V (m/s) that give the printed rates: cells, then rounded, truncated, either."""
    cells = rate_cells(Rational(1))
    groups: dict[str, Sequence[Case]] = {
        **{case.name: (case,) for case in LINES},
        "Table 4": LINES,
        "Table 3": CIRCLES,
        "both": (*CIRCLES, *LINES),
    }
    return [
        [name, *(_solved(read_as(_of(cases, cells), reading), SPEED) for reading in Reading)]
        for name, cases in groups.items()
    ]


def roller_radius_for(speed: str) -> str:
    """Radius of the rollers (m) with which the printed rates would give a speed (m/s).

    The rates fix the quotient of speed and radius only.
    """
    return format_ball(evaluate(ROLLER_RADIUS * Rational(speed) / ROUND_SPEED), 4)


def _solved(cells: Sequence[Cell], unknown: Symbol) -> str:
    solution = solve(cells, unknown)
    if isinstance(solution, Undecided):
        return f"undecided: {solution.reason}"
    return _written(solution)


def _written(solution: Solution) -> str:
    """Write the interval, or the cells that contradict each other."""
    if not solution.pieces:
        return f"none: {' and '.join(f'${_tidy(n)}$' for n in solution.contradiction)} disagree"
    return show(solution.pieces, LETTERS[solution.unknown], 6)


def _tidy(name: str) -> str:
    """Write `0°, N_3` as LaTeX."""
    case, rate = name.split(", ")
    return rf"{rate}\,(\text{{{case}}})"


def yaw_rates_by_radius() -> list[list[str]]:
    """Yaw rates (rad/s) of Table 3 that fit both tables, digits rounded or cut: L, interval."""
    return [
        [f"{float(radius):.3f} m ({place})", f"${_solved(rate_cells(radius), YAW_RATE)}$"]
        for place, radius in RADII.items()
    ]


def cells_by_reading() -> list[list[str]]:
    """Each rate: case, wheel, printed, exact at `ROUND_SPEED` (Table 4), how it can be read.

    A cell's reading is what the other cells leave possible for it.
    """
    cells = rate_cells(Rational(1))
    left = readings_left(cells, SPEED)
    words = {
        (Reading.ROUNDED, Reading.TRUNCATED): "either",
        (Reading.ROUNDED,): "rounded only",
        (Reading.TRUNCATED,): "cut off only",
        (): "neither",
    }
    rows = []
    for cell in cells:
        case, rate = cell.name.split(", ")
        printed, exact = (
            text.replace("-", "\N{MINUS SIGN}") for text in (cell.printed, _at_round_speed(cell))
        )
        readings = "undecided" if isinstance(left, Undecided) else words[left[cell.name]]
        rows.append([case, f"${rate}$", printed, exact, readings])
    return rows


def _at_round_speed(cell: Cell) -> str:
    value = cell.value.subs(SPEED, ROUND_SPEED)
    return "—" if value.free_symbols else format_ball(evaluate(value), 5)


# Paths -------------------------------------------------------------------------------------------


def paths_of_printed_rates() -> list[list[str]]:
    """What the printed rates give in 3 s: case, L, speed, turn, radius, end, beside the line."""
    return [
        [case.name, *_path(case, radius)]
        for case in (*CIRCLES, *LINES)
        for radius in RADII.values()
    ]


def _path(case: Case, radius: Expr) -> list[str]:
    moving = twist(case, radius)
    turn = moving[2] * DURATION * 180 / pi
    x, y = path(case, radius, DURATION)
    straight = moving[2] == 0
    return [
        f"{float(radius):.3f}",
        _decimal(trajectory.speed(moving), 5),
        _decimal(turn, 4),
        "∞" if straight else _decimal(trajectory.circle_radius(moving), 4),
        _place((_decimal(x, 4), _decimal(y, 4))),
        "" if case in CIRCLES else _decimal(1000 * lengthwise_and_across(case, radius)[1], 3),
    ]


def _decimal(value: Expr, digits: int) -> str:
    text = "0" if value == 0 else format_ball(evaluate(value), digits)
    return text.replace("-", "\N{MINUS SIGN}")


# Wheel speeds that change ------------------------------------------------------------------------

TIME = Symbol("t", positive=True)


def changing_speeds() -> list[list[str]]:
    """Paths for wheel speeds that change: speeds, place after 3 s, by quadrature, its bound.

    The twists are plain numbers near those of Table 3 (m/s, rad/s, L = 0.108 m).
    """
    steady = ImmutableMatrix([Rational(1, 40), Rational(1, 25), Rational(1, 2)])
    sway = ImmutableMatrix([Rational(1, 50), Rational(-1, 50), 0])
    still, rate = 0 * sway, steady[2]
    cases = {
        "constant": (steady, trajectory.constant_speed_path(steady, TIME)),
        r"all wheels $\propto e^{-t}$": (
            steady * exp(-TIME), trajectory.common_profile_path(steady, exp(-TIME), TIME)),
        r"$e^{-t}$, constant sum": (
            steady + sway * exp(-TIME), trajectory.exponential_path(steady, sway, -1, TIME)),
        r"$\cos 4t$, constant sum": (
            steady + sway * cos(4 * TIME),
            trajectory.sinusoidal_path(steady, sway, still, 4, TIME)),
        "in step with the rotation": (
            steady + sway * cos(rate * TIME),
            trajectory.sinusoidal_path(steady, sway, still, rate, TIME)),
        "growing linearly": (
            sway + steady * TIME, trajectory.linear_path(sway, steady, TIME)),
        r"$\sin 2t$ in the sum": (steady * (1 + sin(2 * TIME)) + sway * cos(TIME), None),
        r"sum $\propto e^{-t^2}$": (
            ImmutableMatrix([steady[0], steady[1], exp(-(TIME**2))]), None),
    }  # fmt: skip
    return [[name, *_both_ways(*case)] for name, case in cases.items()]


def _both_ways(moving: ImmutableMatrix, closed: ImmutableMatrix | None) -> list[str]:
    """Place after 3 s by the closed form, where there is one, by quadrature, and its bound."""
    found = quadrature.pose(moving, TIME, DURATION)
    enclosed = _place(format_ball(ball, 8) for ball in (found.x, found.y))
    exact = "none known"
    if closed is not None:
        exact = _place(str(entry.subs(TIME, DURATION).evalf(8)) for entry in closed)
    return [exact, enclosed, f"{found.error:.0e} m"]


def _place(coordinates: Iterable[str]) -> str:
    return f"({', '.join(coordinates)})".replace("-", "\N{MINUS SIGN}")
