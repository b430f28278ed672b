"""What follows and the paper does not print: when its elimination works, what level axes leave."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sympy import Expr, ImmutableMatrix, sin, symbols

from omniproof.kinematics import sphere
from omniproof.papers.three_roller_sphere.derivations import elimination
from omniproof.papers.three_roller_sphere.derivations.quantities import COEFFICIENTS, sum_at
from omniproof.papers.three_roller_sphere.rollers import (
    ELEVATION,
    ROLLERS,
    Roller,
    optimum,
    pattern,
    pattern_slips,
)
from omniproof.papers.three_roller_sphere.symbols import POINT
from omniproof.registry import Obligation, Step, Theorem
from omniproof.transcription.model import Form

C = COEFFICIENTS
CURVATURE = ImmutableMatrix(
    [[C[1], C[4] / 2, C[6] / 2], [C[4] / 2, C[2], C[5] / 2], [C[6] / 2, C[5] / 2, C[3]]]
)
"""Matrix of the quadratic form, its coefficients free."""


def _equal(*values: Expr) -> Obligation:
    return Obligation(Form.EQUAL, values)


def _pivots() -> Sequence[Obligation]:
    """Products of the divisors of (7) against the leading minors, largest first."""
    d_2, e_3 = elimination.coefficient(2, 1), elimination.coefficient(3, 2)
    return [
        _equal(C[1] * d_2 * e_3, CURVATURE.det(method="berkowitz")),
        _equal(C[1] * d_2, CURVATURE[:2, :2].det()),
    ]


def _never_negative() -> Sequence[Obligation]:
    """The quadratic part of L, without speeds, as a sum of squares."""
    speeds = {roller.speed: 0 for roller in ROLLERS}
    squares = (POINT.cross(roller.contact) for roller in ROLLERS)
    return [_equal(sum_at(*POINT).subs(speeds), sum(s.dot(s) for s in squares))]


def _on_one_line() -> Sequence[Obligation]:
    """Leading minors where all three contacts are on the line of one direction."""
    direction = sphere.contact_direction(*symbols("theta_1 theta_2", real=True))
    matrix = sphere.normal_matrix([direction] * 3)
    return [
        _equal(matrix[0, 0], 3 * (1 - direction[0] ** 2)),
        _equal(matrix[:2, :2].det(), 9 * direction[2] ** 2),
        _equal(matrix.det(method="berkowitz"), direction[0] * 0),
    ]


def _least_value() -> Sequence[Obligation]:
    """The form at its optimum against what elimination leaves."""
    at_optimum = elimination.form().subs(
        dict(zip(POINT, elimination.optimum(), strict=True)), simultaneous=True
    )
    e_3, e_9, e_10 = (elimination.coefficient(k, 2) for k in (3, 9, 10))
    return [_equal(at_optimum, e_10 - e_9**2 / (4 * e_3))]


# Level axes

SPEEDS = symbols("nu_1 nu_2 nu_3", real=True)


def _triangle() -> tuple[Roller, ...]:
    """Rollers of a pattern at any elevation, with any rim speeds."""
    return tuple(
        replace(roller, speed=speed) for roller, speed in zip(pattern(), SPEEDS, strict=True)
    )


def _no_spin_upright() -> Sequence[Obligation]:
    return [_equal(optimum(_triangle())[2], POINT[2] * 0)]


def _equal_speeds() -> Sequence[Obligation]:
    """Spin of equal speeds, and the slip of each roller."""
    rollers = tuple(replace(roller, speed=SPEEDS[0]) for roller in _triangle())
    spin = optimum(rollers)
    slips = [roller.slip(spin) for roller in rollers]
    return [
        *(_equal(entry, POINT[0] * 0) for entry in spin),
        *(_equal(slip.dot(slip), SPEEDS[0] ** 2) for slip in slips),
    ]


def _sum_of_squares() -> Sequence[Obligation]:
    """Squared slips of a pattern, all three together."""
    total = sum(slip.dot(slip) for slip in pattern_slips())
    raised = sin(ELEVATION) ** 2
    return [_equal(2 * (1 + raised) * total, 3 * raised)]


THEOREMS = (
    Theorem(
        "thm:pivots-of-elimination",
        "The printed elimination works wherever there is one optimum",
        r"Eq. (7) divides by $C_1$, $D_2$ and $E_3$. They are positive for all placements with one "
        r"optimum, and one of them is zero for all others, where the three contacts lie on one "
        r"line through the centre: $C_1$ for the x-axis, $D_2$ for the other lines of the "
        r"xy-plane, $E_3$ for the lines that leave it. Neither axes nor speeds matter. The least "
        r"sum of squares, which the paper does not print, is $E_{10} - E_9^2/(4E_3)$.",
        ("three-roller-sphere",),
        (
            Step(
                r"$C_1 D_2 E_3$ and $C_1 D_2$ are the leading minors of the matrix of L, after "
                r"$C_1$.",
                _pivots,
            ),
            Step(
                r"Without speeds, $L(\mathbf{Q}) = \sum_i |\mathbf{Q} \times P_i|^2/r^2$: it is "
                r"positive but for $\mathbf{Q}$ parallel to all contacts. If there is no such "
                r"$\mathbf{Q}$, all leading minors are positive.",
                _never_negative,
            ),
            Step(
                r"On a line of the direction $u$, the leading minors are $3(1 - u_x^2)$, "
                r"$9u_z^2$ and 0.",
                _on_one_line,
            ),
            Step("The value of the quadratic form at its optimum.", _least_value),
        ),
    ),
    Theorem(
        "thm:level-axes",
        "Three rollers with level axes turn the sphere in two ways only",
        r"In all four patterns, and at every elevation $\beta$ short of the pole, three rim speeds "
        r"give $\omega_z = 0$, whatever they are. Equal speeds $\nu$ give no spin at all: the "
        r"sphere stands still and all three rollers slip at $|\nu|$. The inputs of the paper leave "
        r"these out, for they add up to zero. With those inputs the slip moves from roller to "
        r"roller, and the sum of the squares stays: it is "
        r"$\frac{3\sin^2\beta}{2(1 + \sin^2\beta)}$ (m/s)² "
        r"for all $\varphi$.",
        ("three-roller-sphere",),
        (
            Step("The vertical part of the spin, for any speeds.", _no_spin_upright),
            Step("Equal speeds.", _equal_speeds),
            Step("The sum of the squared slips with the printed inputs.", _sum_of_squares),
        ),
    ),
)
