"""ballbot: verdicts against reasons worked out by hand, and what turns them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from row_rules import check_rows
from verdict_table import audited, edited, shown, turned, verdict

from omniproof.audit.ledger import Ledger, Row
from omniproof.audit.run import prepare

PAPER = "ballbot"

# Verdicts: each with the reason, worked out by hand

GAP = "sec:3/motion-by-frames"
YAW = "sec:3/yaw-at-ground-contact"
EXPECTED = [
    verdict("sec:abstract/single-contact", "verified", "1 - cos t vanishes at t = 0 only"),
    verdict("sec:abstract/omnidirectional", "verified", "det = 3 sqrt(3)/2 cos^2 phi sin phi"),
    verdict("sec:1/unstable-on-top", "verified", "cos t bulges upwards between -90 and 90 degrees"),
    verdict("sec:1/inherently-stable", "conditional", "h cos t has a minimum at 0 for h < 0 only",
            assumption="-1 < h < 0"),
    verdict("sec:1/no-nonholonomic-constraints", "conditional",
            "rotations about two axes do not commute: 1/rho^2 about the vertical is left"),
    verdict("sec:3/platform-stays-level", "conditional", "M is left where the weight has no lever",
            assumption=r"\text{nothing resists the rolling}",
            witness="M=20/9; printed=0; derived=2.222"),
    verdict("eq:1[1,2]", "verified", "R^T [delta] R is the cross product by R^T delta"),
    verdict("eq:2[1,2]", "verified", "a turn about z moves a point on y towards -x"),
    verdict("eq:3", "verified", "images of the unit vectors are the columns"),
    verdict("eq:4-1[2]", "verified", "the component along o", follows=""),
    verdict("eq:4-2[3]", "verified", "velocity of the origin p along a", follows=""),
    verdict("xref:sec-2-cites-eq-4-1", "verified", "(4-1) has the rotational part"),
    verdict("xref:sec-2-cites-eq-4-1-again", "erratum", "the translational part is in (4-2)",
            correction="eq:4-2", consequence="text"),
    verdict("sec:2/outer-product", "editorial", "a x b is the cross product"),
    verdict("sec:3/spacing", "verified", "pi, -pi/3 and pi/3 are 120 degrees apart"),
    verdict("sec:3/wheels-normal-to-surface", "verified", "a = -p/L, once (5-1) is mended",
            follows="eq:5-1[1,3]"),
    verdict("sec:3/inertial-frame", "conditional", "a point on a turning platform is accelerated",
            assumption=r"\omega_z^B = 0",
            witness="omega_z=20/9; x=-26/9; printed=0; derived=14.27"),
    verdict("sec:3/velocity-at-ground-contact", "conditional",
            "the ball's own point on the ground has no velocity",
            witness="v_x=20/9; printed=2.222; derived=0"),
    verdict(YAW, "conditional", "the ball may turn under the platform, or not"),
    verdict(GAP, "model-gap", "the surface under a wheel moves", follows=""),
    verdict("sec:abstract/velocity-relationship", "model-gap", "as there", follows=GAP),
    verdict("sec:4/motor-makes-motion", "model-gap", "as there", follows=GAP),
    verdict("sec:5/velocity-relationship", "model-gap", "as there", follows=GAP),
    verdict("eq:5-1[1,1]", "verified", "Rot(z, pi) turns c phi over"),
    verdict("eq:5-1[1,3]", "erratum", "Rot(z, pi) turns the -s phi of Rot(y, -phi) over as well",
            correction=r"s\phi", repair="explained", follows="", consequence="motion"),
    verdict("eq:5-1[1,4]", "verified", "-L times the third column, s phi", follows=""),
    verdict("eq:5-1/product[1,3]", "verified", "the product is right, its expansion is not"),
    verdict("eq:5-2[1,1]", "erratum", "cos(-60 degrees) = 1/2, as in (5-3)",
            correction=r"\frac{1}{2}c\phi", repair="explained", follows=""),
    verdict("eq:5-2[2,1]", "verified", "sin(-60 degrees) = -sqrt(3)/2"),
    verdict("eq:5-2[1,4]", "verified", "-L times -s phi / 2"),
    verdict("eq:5-3[1,1]", "verified", "cos(60 degrees) = 1/2"),
    verdict("eq:5-3[2,4]", "verified", "-L times -sqrt(3)/2 s phi"),
    verdict("sec:4/radius-of-ball", "conditional", "a wall lies between the two radii"),
    verdict("eq:6-1[1]", "verified", "n_z = s phi", follows=""),
    verdict("eq:6-1[3]", "verified", "a_z = c phi: the wrong entry of (5-1) is a_x", follows=""),
    verdict("eq:6-2[2]", "verified", "o = (0, -1, 0)", follows=""),
    verdict("eq:6-2[3]", "erratum", "a_x d_x with the wrong a_x of (5-1)",
            correction=r"s\phi d_x^B", repair="explained", follows="eq:5-1[1,3]"),
    verdict("eq:7", "model-gap", "the ball's surface moves at (1 - cos phi) v under the wheel",
            follows=GAP, derived=r"L \omega_z^B \sin {\phi} - v_y^B \cos {\phi}"),
    verdict("eq:8", "model-gap", "as (7)", follows=GAP),
    verdict("eq:9", "model-gap", "as (7)", follows=GAP),
    verdict("eq:10[1,1]", "verified", "wheel 1 drives along y", follows=""),
    verdict("eq:10[1,2]", "model-gap", "-cos phi", follows=GAP, correction=r"- \cos {\phi}"),
    verdict("eq:10[1,3]", "verified", "lever L sin phi, over a ball that does not spin",
            follows=YAW),
    verdict("eq:10[3,1]", "model-gap", "-sqrt(3)/2 cos phi", follows=GAP),
    verdict("eq:10/inverse[1,1]", "verified", "wheel 1 does not move the body along x",
            follows=""),
    verdict("eq:10/inverse[2,1]", "model-gap", "-2/3 over cos phi", follows=GAP,
            correction=r"- \frac{2}{3 \cos {\phi}}"),
    verdict("eq:10/inverse[3,2]", "verified", "1/(3 L sin phi)", follows=YAW),
    verdict("sec:references/pages-of-2", "editorial", "[1], [3] and [4] have theirs"),
    verdict("sec:5/advantages-over-ballbots", "editorial", "Section 1 grants them to all"),
]  # fmt: skip


@pytest.mark.parametrize(("row", "fields"), EXPECTED)
def test_verdicts(row: str, fields: dict[str, str], rows: dict[str, Row]) -> None:
    assert shown(rows[row], fields) == fields


def test_every_row_shows_what_its_verdict_needs(ledger: Ledger) -> None:
    check_rows(ledger)


def test_no_other_entry_of_the_transformations_is_wrong(rows: dict[str, Row]) -> None:
    wrong = {name for name, row in rows.items() if name[:3] == "eq:" and row.verdict == "erratum"}
    assert wrong == {"eq:5-1[1,3]", "eq:5-2[1,1]", "eq:6-2[3]"}


# The printed matrices: what the misprints spoil, and what they do not

PHI = sp.Symbol("phi", real=True)
L = sp.Symbol("L", positive=True)
V_X, V_Y, YAW_RATE = sp.symbols("v_x v_y omega_z", real=True)


@pytest.fixture(scope="module")
def printed(paper_folder: Path) -> dict[int, sp.Matrix]:
    """The matrices of (5-1) to (5-3) as they stand in the paper."""
    context = prepare(paper_folder)
    return {k: sp.Matrix(context.evaluate(f"eq:5-{k}")) for k in (1, 2, 3)}


@pytest.mark.parametrize(
    ("k", "determinant", "products"),
    [
        pytest.param(1, sp.cos(2 * PHI), (0, sp.sin(2 * PHI), 0), id="n and a are not orthogonal"),
        pytest.param(2, 1 - sp.cos(PHI) ** 2 / 2,
                     (-sp.sqrt(3) / 2 * sp.cos(PHI), sp.sin(2 * PHI) / 4, 0),
                     id="n is orthogonal to neither o nor a"),
        pytest.param(3, 1, (0, 0, 0), id="a rotation"),
    ],
)  # fmt: skip
def test_printed_rotation_blocks(
    k: int, determinant: Any, products: tuple[Any, ...], printed: dict[int, sp.Matrix]
) -> None:
    n, o, a = (printed[k][:3, column] for column in range(3))
    found = (n.dot(o), n.dot(a), o.dot(a))
    assert sp.simplify(printed[k][:3, :3].det() - determinant) == 0
    assert [sp.simplify(x - y) for x, y in zip(found, products, strict=True)] == [0, 0, 0]
    assert [sp.simplify(vector.dot(vector)) for vector in (n, o, a)] == [1, 1, 1]


@pytest.mark.parametrize("k", [1, 2, 3])
def test_the_printed_speeds_do_not_see_the_misprints(
    k: int, printed: dict[int, sp.Matrix], paper_folder: Path
) -> None:
    """They take the second and fourth columns, and those are right."""
    o, p = printed[k][:3, 1], printed[k][:3, 3]
    turn, shift = sp.Matrix([0, 0, YAW_RATE]), sp.Matrix([V_X, V_Y, 0])
    context = prepare(paper_folder)
    _, speed = context.evaluate(f"eq:{k + 6}")
    assert (
        sp.expand(o.dot(turn.cross(p) + shift) - speed).subs(sp.cos(PHI) ** 2, 1 - sp.sin(PHI) ** 2)
        == 0
    )


# Altered print: exactly the right rows turn


EDITS = (
    ("paper.yaml", r"Ls\phi \omega_z^B - v_y^B'", r"Ls\phi \omega_z^B - c\phi v_y^B'"),
    ("paper.yaml", r"Rot(z, \pi)", r"Rot(z, -\pi)"),
    ("paper.yaml", r"Rot\left(z, \frac{\pi}{3}\right)", r"Rot\left(y, \frac{\pi}{3}\right)"),
)


def test_a_mended_speed_is_right_and_another_axis_is_not(
    paper_folder: Path, rows: dict[str, Row], tmp_path: Path
) -> None:
    """Rot(y, pi/3) Rot(y, -phi) = Rot(y, pi/3 - phi): its last row and o_z = 0 stay right.

    Rot(z, -pi) is Rot(z, pi).
    """
    found = turned(rows, audited(edited(paper_folder, tmp_path, *EDITS)))
    spoiled = {f"eq:5-3/product[{i},{k}]" for i in (1, 2, 3) for k in (1, 2, 3, 4)}
    spoiled -= {"eq:5-3/product[3,2]"}
    assert found.pop("eq:7") == ("model-gap", "verified")
    assert set(found) == spoiled
    assert set(found.values()) == {("verified", "erratum")}
