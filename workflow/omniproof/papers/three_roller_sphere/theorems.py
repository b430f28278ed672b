"""What follows for this paper's elimination and the paper does not print: when it works."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Expr, ImmutableMatrix, symbols

from omniproof.kinematics import sphere
from omniproof.papers.three_roller_sphere.derivations import elimination
from omniproof.papers.three_roller_sphere.derivations.quantities import COEFFICIENTS, sum_at
from omniproof.papers.three_roller_sphere.rollers import POINT, ROLLERS
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
)
