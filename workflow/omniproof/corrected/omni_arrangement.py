"""Corrected formulas of the paper on three omni rollers on a circle, for NumPy.

Angles of the wheels in rad, counter-clockwise from x; arrays are broadcast. The matrix of
Eq. (A.2) has the body radius L (m) in its third column, where that of Eq. (5) has 1.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from omniproof.corrected.answer import Answer, Answers, Line
from omniproof.corrected.formula import Array, Formula, Functions


def inverse(alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike) -> Array:
    """Return the inverse of A, on to (V_x, V_y, L phi-dot), `(..., 3, 3)`: Eq. (6)."""
    factor = _FACTOR(alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3)
    return factor[..., None, None] * inverse_times_determinant(alpha_1, alpha_2, alpha_3)


def inverse_times_determinant(alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike) -> Array:
    """Return the inverse of A times its determinant, `(..., 3, 3)`: Eq. (6)."""
    return _INVERSE(alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3)


def image_volume(alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike) -> Array:
    """Return the image volume D_V of wheels numbered in any order, in (m/s)^3: Eq. (11)."""
    return _VOLUME(alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3)


def image_volume_isosceles(theta: ArrayLike) -> Array:
    """Return D_V of the isosceles family by its angle theta, at any theta: Eq. (12)."""
    return _ISOSCELES(theta=theta)


def cofactor_22(alpha_1: ArrayLike, alpha_3: ArrayLike, L: ArrayLike) -> Array:
    """Return the cofactor of entry (2, 2) of A with L in its third column, m: Eq. (A.2)."""
    return _COFACTOR_22(alpha_1=alpha_1, alpha_3=alpha_3, L=L)


def cofactor_13(alpha_1: ArrayLike, alpha_2: ArrayLike, L: ArrayLike) -> Array:
    """Return the cofactor of entry (1, 3), as it stands in the inverse, m: Eq. (A.2)."""
    return _COFACTOR_13(alpha_1=alpha_1, alpha_2=alpha_2, L=L)


def determinant(alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike) -> Array:
    """Return det A of Eq. (5), whose third column is 1, as Eq. (7) has it: Eq. (C.6)."""
    return _DETERMINANT(alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3)


def height(columns: Array) -> Array:
    """Return the height of a parallelepiped over its first two edges, a length: Eq. (B.2).

    columns: the edges, `(3, 3)`, each a column.
    """
    return _HEIGHT(**_edges(columns))


def volume(columns: Array) -> Array:
    """Return the volume of a parallelepiped, never negative: Eq. (B.3). columns: as in `height`."""
    return _PARALLELEPIPED(**_edges(columns))


def _edges(columns: Array) -> dict[str, ArrayLike]:
    # In the derivation, the first index is that of the axis.
    return {f"a_{i + 1}{k + 1}": columns[i, k] for i in range(3) for k in range(3)}


_PAPER = "omni-arrangement"
_FACTOR = Formula(_PAPER, "eq:6/factor")
_INVERSE = Formula(_PAPER, "eq:6")
_VOLUME = Formula(_PAPER, "eq:11")
_ISOSCELES = Formula(_PAPER, "eq:12")
_L_IN_COLUMN = "the unknown is the yaw rate: third column L"
_COFACTOR_22 = Formula(_PAPER, "eq:A.2/a22", _L_IN_COLUMN)
_COFACTOR_13 = Formula(_PAPER, "eq:A.2/a13", _L_IN_COLUMN)
_DETERMINANT = Formula(_PAPER, "eq:C.6", "the unknown is L times the yaw rate: third column 1")
_HEIGHT = Formula(_PAPER, "eq:B.2")
_PARALLELEPIPED = Formula(_PAPER, "eq:B.3#2/volume")

FUNCTIONS: Functions = {
    "eq:6": inverse_times_determinant,
    "eq:11": image_volume,
    "eq:12": image_volume_isosceles,
    "eq:A.2/a22": cofactor_22,
    "eq:A.2/a13": cofactor_13,
    "eq:B.2": height,
    "eq:B.3#2/volume": volume,
    "eq:C.6": determinant,
}

_SPEEDS = r"\begin{pmatrix} v_1 \\ v_2 \\ v_3 \end{pmatrix}"

ANSWERS: Answers = {
    "eq:1": Answer("where a wheel stands", (Line("<eq:1>", name="q_k"),)),
    "eq:2": Answer("where a wheel drives", (Line("<eq:2>", name="n_k"),)),
    "eq:4": Answer("speed of a wheel", (Line("v_k <eq:4>"),)),
    "eq:5": Answer(
        "wheel matrix", (Line(rf"{_SPEEDS} = <eq:5> <eq:5/twist>", ("eq:5",), name="A"),)
    ),
    "eq:6": Answer(
        "inverse of the wheel matrix",
        (
            Line(
                rf"<eq:6/twist> = <eq:6/factor> <eq:6> {_SPEEDS}",
                ("eq:6",),
                "eq:7",
                inverse,
                "inverse(alpha_1=0.5, alpha_2=2.6, alpha_3=4.7)",
            ),
        ),
        "With the minus, $\\mathbf{A}$ times this matrix is $\\det\\mathbf{A}$ times the unit "
        "matrix. With the printed plus, the third wheel drives the robot in another direction.",
    ),
    "eq:7": Answer("determinant of the wheel matrix", (Line("<eq:7>", name="det_A"),)),
    "eq:8": Answer("speeds of the wheels", (Line(r"W = \{(v_1, v_2, v_3) \mid <eq:8/bounds>\}"),)),
    "eq:9": Answer("what the wheels reach", (Line(r"(V_x, V_y, L\dot{\phi})^T = <eq:9>"),)),
    "eq:10": Answer(
        "columns of the inverse", tuple(Line(f"<eq:10/a{k}>", name=f"a_{k}") for k in (1, 2, 3))
    ),
    "eq:11": Answer(
        "image volume",
        (
            Line(
                "D_V = <eq:11>",
                function=image_volume,
                call="image_volume(alpha_1=0.5, alpha_2=2.6, alpha_3=4.7)",
            ),
        ),
        "A volume is not negative; $\\det\\mathbf{A}$ is, for wheels numbered clockwise.",
    ),
    "eq:12": Answer(
        "image volume of isosceles arrangements",
        (
            Line(
                r"D_V(\theta) = <eq:12>",
                function=image_volume_isosceles,
                call="image_volume_isosceles(theta=0.5)",
            ),
        ),
        "The printed form is negative for $\\theta$ beyond a right angle.",
    ),
    "eq:13": Answer("what the wheels reach in the plane", (Line(r"(V_x, V_y, 0)^T = <eq:13>"),)),
    "eq:14": Answer("its columns", tuple(Line(f"<eq:14/a{k}>", name=f"a_{k}") for k in (1, 2, 3))),
    "eq:15": Answer(
        "projected area",
        (
            Line(r"D_A = <eq:15/case-1>"),
            Line("<eq:15/case-1-condition>"),
            Line("D_A = <eq:15/case-2>"),
            Line("<eq:15/case-2-condition>"),
        ),
    ),
    "sec:4/type-z-angles": Answer(
        "angles of Type (Z)", (Line(r"\{\alpha_1, \alpha_2, \alpha_3\} = <sec:4/type-z-angles>"),)
    ),
    "eq:A.1": Answer("inverse by cofactors", (Line("A^{-1} = <eq:A.1/factor> <eq:A.1>"),)),
    "eq:A.4": Answer(
        "cofactors of the third column",
        tuple(
            Line(display)
            for k in (1, 2, 3)
            for display in (
                f"<eq:A.4/a3{k}-line-1>",
                rf"\widetilde{{a}}_{{3,{k}}} <eq:A.4/a3{k}-line-2>",
            )
        ),
    ),
    "eq:B.2": Answer(
        "height of a parallelepiped",
        (
            Line(
                r"\overline{\mathbf{OH}} = <eq:B.2>",
                function=height,
                call="height(np.array([[2.0, 1.0, 5.0], [0.0, 3.0, 6.0], [0.0, 0.0, -7.0]]))",
            ),
        ),
    ),
    "eq:B.3#2": Answer(
        "volume of a parallelepiped",
        (
            Line(
                "<eq:B.3#2/volume>",
                function=volume,
                call="volume(np.array([[2.0, 1.0, 5.0], [0.0, 3.0, 6.0], [0.0, 0.0, -7.0]]))",
            ),
            Line("<eq:B.3#2/determinant>"),
        ),
    ),
}
