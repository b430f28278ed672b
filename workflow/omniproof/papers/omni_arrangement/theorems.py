"""What follows for this paper's quantities and the paper does not print."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import (
    Abs,
    Expr,
    ImmutableMatrix,
    Integer,
    Rational,
    Symbol,
    cancel,
    cos,
    diag,
    pi,
    sin,
    sqrt,
)

from omniproof.kinematics import omni, zonotope
from omniproof.papers.omni_arrangement.arrangements import isosceles
from omniproof.papers.omni_arrangement.derivations.appendices import determinant_by_arcs
from omniproof.papers.omni_arrangement.derivations.evaluation import (
    planar_columns,
    volume_by_arcs,
)
from omniproof.papers.omni_arrangement.derivations.quantities import (
    cross_products,
    general,
    image_area,
    image_volume,
    platform,
    sum_of_columns,
)
from omniproof.papers.omni_arrangement.derivations.simulation import by_type, section_of
from omniproof.papers.omni_arrangement.symbols import ANGLE, ANGLES, RADIUS, THETA
from omniproof.registry import Family, Obligation, Step, Theorem
from omniproof.transcription.model import Form

PAPER = ("omni-arrangement",)
EQUILATERAL = (2 * pi / 3, 2 * pi / 3)
MIRRORED = (4 * pi / 3, 4 * pi / 3)


def _equal(*values: Expr) -> Obligation:
    return Obligation(Form.EQUAL, values)


def _determinant_as_product() -> Sequence[Obligation]:
    first, second, third = ANGLES
    sines = [sin((b - a) / 2) for a, b in ((first, second), (second, third), (first, third))]
    return [_equal(general().determinant, 4 * sines[0] * sines[1] * sines[2])]


def _determinant_as_area() -> Sequence[Obligation]:
    first, second, third = (omni.contact_position(angle, RADIUS) for angle in ANGLES)
    sides = ImmutableMatrix.hstack(second - first, third - first)
    return [_equal(RADIUS**2 * general().determinant, sides.det())]


def _turned() -> Sequence[Obligation]:
    turn = Symbol("gamma", real=True)
    turned = platform(tuple(angle + turn for angle in ANGLES))
    return [_equal(turned.determinant, general().determinant)]


def _area_by_volume() -> Sequence[Obligation]:
    determinant = general().determinant
    return [_equal(image_area(determinant), Rational(3, 2) * image_volume(determinant))]


def _columns_add_up() -> Sequence[Obligation]:
    total = sum_of_columns()
    return [_equal(total[0], total[1], Integer(0)), _equal(total[2], Integer(1))]


def _minors() -> Sequence[Obligation]:
    second_third, first_third, first_second = cross_products()
    return [_equal(second_third, -first_third, first_second, Integer(1))]


def _one_sign() -> Sequence[Obligation]:
    second_third, first_third, _ = cross_products()
    return [Obligation(Form.NEGATIVE, (cancel(second_third * first_third),))]


def _corners() -> Sequence[Obligation]:
    first, second, third = planar_columns().values()
    pairs = zip(first + second - third, -2 * third, strict=True)
    return [_equal(*pair) for pair in pairs]


def _bound_by_concavity() -> Sequence[Obligation]:
    arc = Symbol("t", real=True)
    return [Obligation(Form.CONCAVE, Family(sin(arc), {arc: (Integer(0), pi)}))]


def _bound_beyond() -> Sequence[Obligation]:
    return [Obligation(Form.POSITIVE, (3 * sqrt(3) / 2 - 2,))]


def _largest_determinant() -> Sequence[Obligation]:
    family = determinant_by_arcs()
    return [
        Obligation(Form.MAXIMUM, family, at=(EQUILATERAL,)),
        Obligation(Form.MINIMUM, family, at=(MIRRORED,)),
    ]


def _least_volume() -> Sequence[Obligation]:
    family = volume_by_arcs()
    least = family.expression.subs(dict(zip(family.box, EQUILATERAL, strict=True)))
    return [
        Obligation(Form.MINIMUM, family, at=(EQUILATERAL, MIRRORED)),
        _equal(least, 16 * sqrt(3) / 9),
    ]


def _opposite_wheel() -> Sequence[Obligation]:
    here = omni.velocity_matrix((ANGLE, 0))[0, :]
    opposite = omni.velocity_matrix((ANGLE + pi, 0))[0, :]
    return [
        _equal(opposite[0], -here[0]),
        _equal(opposite[1], -here[1]),
        _equal(opposite[2], here[2]),
    ]


def _same_lines() -> Sequence[Obligation]:
    sections = by_type(section_of)
    return [
        _equal(sections["X"], sections["Z"], 2 * sqrt(3)),
        Obligation(Form.LARGEST, sections, member="Y"),
    ]


def _widths() -> Sequence[Obligation]:
    along_x, along_y, _ = zonotope.half_widths(platform(isosceles(THETA)).inverse)
    return [_equal(along_x, 2 / Abs(1 + sin(THETA))), _equal(along_y, 1 / Abs(cos(THETA)))]


def _isotropic() -> Sequence[Obligation]:
    obligations = []
    for wheels in range(3, 9):
        angles = [ANGLE + 2 * pi * k / wheels for k in range(wheels)]
        matrix = omni.velocity_matrix(angles)
        product = matrix.T * matrix
        expected = diag(Rational(wheels, 2), Rational(wheels, 2), wheels)
        obligations += [_equal(*pair) for pair in zip(product, expected, strict=True)]
    return obligations


THEOREMS = (
    Theorem(
        "thm:determinant-product",
        "The determinant is twice the area of the wheel triangle",
        r"For three wheels anywhere on the circle, with the arcs $A$, $B$, $C$ between them, "
        r"$\det\mathbf{A} = 4\sin\frac{A}{2}\sin\frac{B}{2}\sin\frac{C}{2}$, which is twice the "
        r"signed area of the triangle of the wheels divided by $L^2$. An arrangement is singular "
        r"exactly when two wheels stand at one place, and turning all wheels together changes "
        r"nothing.",
        PAPER,
        (
            Step("The sum of sines is a product of half-angle sines.", _determinant_as_product),
            Step("The shoelace formula gives the same number.", _determinant_as_area),
            Step("A common turn leaves the determinant as it is.", _turned),
        ),
    ),
    Theorem(
        "thm:area-by-volume",
        "Both evaluation functions are one",
        r"For every arrangement with an inverse, $D_A = \frac{3}{2} D_V / (1\,\mathrm{m/s})$, with "
        r"$D_V = 8/|\det\mathbf{A}|$ and $D_A = 12/|\det\mathbf{A}|$. The second evaluation "
        r"function ranks arrangements exactly as the first: it adds no information.",
        PAPER,
        (
            Step("Every pair of projected columns spans $1/|\\det A|$.", _minors),
            Step("Three such pairs, times 4, against 8 times the volume.", _area_by_volume),
        ),
    ),
    Theorem(
        "thm:one-case",
        "Only the first case of (15) occurs",
        r"Equal wheel speeds turn the platform on the spot: "
        r"$\mathbf{a}_1+\mathbf{a}_2+\mathbf{a}_3 = (0,0,1)^T$. Hence "
        r"$\hat{\mathbf{a}}_3 = -\hat{\mathbf{a}}_1-\hat{\mathbf{a}}_2$ lies between "
        r"$-\hat{\mathbf{a}}_1$ and $-\hat{\mathbf{a}}_2$ for every arrangement, the product that "
        r"distinguishes the cases is $-1/(\det\mathbf{A})^2$, and the corners of the hexagon are "
        r"$\pm 2\hat{\mathbf{a}}_k$: it is an affine image of the regular one.",
        PAPER,
        (
            Step("The columns add up to a rotation on the spot.", _columns_add_up),
            Step("The product of the two cross products is negative.", _one_sign),
            Step("The corner with the signs $(+,+,-)$ is $-2\\hat{a}_3$.", _corners),
        ),
    ),
    Theorem(
        "thm:minimum",
        "The equilateral arrangement is the only minimum",
        r"Among all arrangements, $D_V \ge 16\sqrt{3}/9$ (m/s)$^3$, with equality "
        r"for the equilateral ones only. Concavity of the sine proves this while every arc is at "
        r"most 180°. Where one arc is longer its sine is negative, so that "
        r"$\det\mathbf{A} \le \sin A + \sin B \le 2 < \frac{3}{2}\sqrt{3}$: the argument of "
        r"Appendix (C) leaves this part out, and the statement is true there as well.",
        PAPER,
        (
            Step("The sine is concave for arcs of at most 180°.", _bound_by_concavity),
            Step("Two sines are at most 2, which is less than the maximum.", _bound_beyond),
            Step(
                "The determinant over all pairs of arcs, by branch and bound.", _largest_determinant
            ),
            Step("The volume over all pairs of arcs.", _least_volume),
        ),
    ),
    Theorem(
        "thm:opposite-wheel",
        "Types (X) and (Z) translate equally well",
        r"Moving a wheel to the opposite side of the body turns its driven direction round and "
        r"keeps its lever. The velocities that are reached without rotation stay the same. "
        r"Type (Z) is Type (X) with two wheels moved so: both reach a regular hexagon of area "
        r"$2\sqrt{3}$ (m/s)$^2$ without rotation, and Type (Y) reaches more.",
        PAPER,
        (
            Step("The row of the opposite wheel.", _opposite_wheel),
            Step("The areas of the sections without rotation.", _same_lines),
        ),
    ),
    Theorem(
        "thm:half-widths",
        "How far the isosceles family is stretched",
        r"In the isosceles family, the greatest velocities are $2/|1+\sin\theta|$ along $V_x$ and "
        r"$1/|\cos\theta|$ along $V_y$ (m/s).",
        PAPER,
        (Step("Sums of absolute values along the rows of the inverse.", _widths),),
    ),
    Theorem(
        "thm:regular-arrangement",
        "Regular arrangements are isotropic",
        r"For $N = 3, \dots, 8$ wheels at equal distances, "
        r"$\mathbf{A}^T\mathbf{A} = \mathrm{diag}(N/2, N/2, N)$, whatever the position of the "
        r"first wheel: all directions of translation are equal, rotation does not mix with them, "
        r"and the least-squares twist of wheel speeds $\mathbf{v}$ is "
        r"$\mathrm{diag}(2/N, 2/N, 1/N)\,\mathbf{A}^T\mathbf{v}$.",
        PAPER,
        (Step("Sums of products of the columns, for each number of wheels.", _isotropic),),
    ),
)
