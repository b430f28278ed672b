"""omni-arrangement: verdicts against reasons worked out by hand, and what turns them."""

from __future__ import annotations

from pathlib import Path

import pytest
from row_rules import check_rows
from verdict_table import audited, edited, shown, turned, verdict

from omniproof.audit.ledger import Ledger, Row

PAPER = "omni-arrangement"

# Verdicts: each with the reason, worked out by hand

MINUS = r"\sin \alpha_1 - \sin \alpha_2"
EXPECTED = [
    verdict("eq:1[1]", "verified", "a point of the circle of radius L"),
    verdict("eq:2[2]", "verified", "the tangent is the radius turned by 90 degrees"),
    verdict("eq:3", "verified", "the rolling constraint is linear in the twist"),
    verdict("eq:5[3,3]", "verified", "on L phi-dot the lever is 1"),
    verdict("sec:2/velocity-frame", "conditional",
            "V resolved in the world frame has to be turned by phi first"),
    verdict("sec:2.1/n-from-perpendicularity", "conditional",
            "two opposite unit vectors are perpendicular to q"),
    verdict("sec:2.1/translation-is-a-length", "conditional",
            "n . V is negative for a wheel that is carried backwards",
            assumption=r"- V_x \sin {\alpha_k} + V_y \cos {\alpha_k} \geq 0"),
    verdict("eq:6[1,1]", "verified", "the minor of entry (1,1) is c2 - c3"),
    verdict("eq:6[1,3]", "verified", "the minor of entry (3,1) is c1 - c2"),
    verdict("eq:6[2,2]", "verified", "the minor of entry (2,2) is -s1 + s3"),
    verdict("eq:6[2,3]", "erratum", "the cofactor of entry (3,2) is -(-s1 + s2) = s1 - s2",
            correction=MINUS, repair="explained", follows="", consequence="motion"),
    verdict("eq:6[3,3]", "verified", "the minor of entry (3,3) is s2 c1 - s1 c2"),
    verdict("eq:7", "verified", "the third column is 1: the sum of its cofactors"),
    verdict("eq:10/a3[2]", "erratum", "it is entry (2,3) of Eq. (6) over the determinant",
            correction=MINUS, follows="eq:6[2,3]"),
    verdict("eq:14/a3[2]", "erratum", "it is entry (2,3) of Eq. (6) over the determinant",
            correction=MINUS, follows="eq:6[2,3]"),
    verdict("eq:10/a2[2]", "verified", "column 2 has no misprint"),
    verdict("eq:14/a1[3]", "verified", "a projection on the velocity plane has no third component"),
    verdict("eq:11", "conditional", "a volume is 8 / |det A|, and det A < 0 for wheels counted "
            "clockwise", assumption=r"\det \mathbf{A} > 0"),
    verdict("eq:12", "conditional", "2 cos t + sin 2t = 2 cos t (1 + sin t) < 0 for cos t < 0",
            follows="sec:3/volume-ratio"),
    verdict("sec:3/three-parameters", "verified", "each derivative of det A is a difference of "
            "two cosines, nonzero somewhere"),
    verdict("sec:3/minimum-equilateral", "verified",
            "|det A| = 4 |sin A/2 sin B/2 sin C/2| is largest for A = B = C",
            follows="sec:3/volume-ratio"),
    verdict("sec:3/two-cases", "erratum",
            "a1 + a2 + a3 = (0,0,1), so a3 = -a1 - a2 and the product is -(a1 x a2)^2"),
    verdict("eq:15/case-1", "verified", "4|d| + 4|2d| = 12|d| with d = a1 x a2"),
    verdict("eq:15/case-2", "verified", "a3 = p a1 - q a2: 4|d|(1 + p + q) on both sides"),
    verdict("eq:15/case-1-condition", "verified", "the product is -p q d^2, case 1 is p q > 0"),
    verdict("eq:15/case-2-condition", "verified", "the product is -p q d^2, case 2 is p q < 0"),
    verdict("sec:4/type-x-angles", "verified", "theta = 30 degrees", follows=""),
    verdict("sec:4/type-y-angles", "verified", "theta = 0", follows=""),
    verdict("tab:1[9]", "inconsistent", "q_i here, q_k where the angle is introduced"),
    verdict("sec:4/type-z-angles", "erratum", "arcs 60, 30, 270 are no isosceles triangle; "
            "60, 60, 240 is, and gives 9.24", correction=r"\{210^\circ, 270^\circ, 330^\circ\}"),
    verdict("tab:2[X,D_V]", "verified", "16 sqrt(3)/9 = 3.0792"),
    verdict("tab:2[X,D_A]", "misrounded", "8 sqrt(3)/3 = 4.6188 rounds to 4.62",
            correction="4.62", consequence="number"),
    verdict("tab:2[Y,D_V]", "verified", "det A = 2, 8/2 = 4 exactly", follows=""),
    verdict("tab:2[Y,D_A]", "verified", "det A = 2, 12/2 = 6 exactly"),
    verdict("tab:2[Z,D_V]", "verified", "16 sqrt(3)/3 = 9.2376, at the corrected angles",
            follows="sec:4/type-z-angles"),
    verdict("tab:2[Z,D_A]", "misrounded", "8 sqrt(3) = 13.8564 rounds to 13.86",
            correction="13.86"),
    verdict("fig:4/stretched-along-vx", "verified", "half-widths 4/3, 2, 4",
            follows="sec:4/type-z-angles"),
    verdict("fig:5/stretched-along-vx", "verified", "half-widths 4/3, 2, 4",
            follows="sec:4/type-z-angles"),
    verdict("fig:4/stretched-along-lphi", "erratum", "half-widths 1, 1, 3: from (X) to (Y) "
            "nothing is stretched"),
    verdict("sec:4/type-x-smallest-volume", "verified", "3.08 < 4 < 9.24"),
    verdict("sec:4/type-z-largest-area", "verified", "4.62 < 6 < 13.86"),
    verdict("sec:4/type-z-translation", "conditional",
            "without rotation (Y) reaches 4 and (Z) 2 sqrt(3)",
            witness="X=3.46410; Y=4.00000; Z=3.46410; printed=3.46410; derived=4.00000"),
    verdict("sec:4#2/type-z-most-efficient", "conditional", "the same claim again",
            follows="sec:4/type-z-translation"),
    verdict("sec:4/minimum-of-volume", "verified", "the derivative -2 sin t + 2 cos 2t vanishes at "
            "sin t = 1/2 only"),
    verdict("sec:4/minimum-of-area", "verified", "D_A = 3/2 D_V"),
    verdict("app:A/cofactor-of", "erratum", "a~12 as printed is the cofactor of entry (2,1)"),
    verdict("app:A/matrix", "inconsistent", "(A,2) has a factor L that the matrix of Eq. (5) "
            "does not give"),
    verdict("eq:A.2/a11", "verified", "right for a third column L", follows="app:A/matrix"),
    verdict("eq:A.2/a22", "erratum", "the cofactor of entry (2,2) is -s1 + s3; s1 - s1 vanishes",
            correction=r"\widetilde{a}_{2,2} &= -L \sin \alpha_1 + L \sin \alpha_3",
            repair="explained"),
    verdict("eq:A.2/a13", "erratum", "the cofactor of entry (3,1) is c1 - c2; theta_1 is nothing",
            correction=r"\widetilde{a}_{1,3} &= L \cos \alpha_1 - L \cos \alpha_2",
            repair="explained"),
    verdict("eq:A.3", "verified", "with a third column of ones it is Eq. (7)", follows=""),
    verdict("eq:A.4/a32-line-2", "verified", "s1 c3 - c1 s3 = sin(a1 - a3)", follows=""),
    verdict("eq:B.2", "conditional", "the triple product is negative for a left-handed triple"),
    verdict("eq:B.2/number", "editorial", "(B,1) is free", correction="(B,1)"),
    verdict("eq:B.3#2/number", "editorial", "the third display", correction="(B,3), with (B,1) "
            "and (B,2) for the displays before"),
    verdict("eq:B.3", "verified", "base times height, whatever the handedness"),
    verdict("eq:B.3#2/volume", "conditional", "the triple product has a sign"),
    verdict("eq:B.3#2/determinant", "verified", "expand by the third column"),
    verdict("eq:C.5", "verified", "C = 360 - (a3 - a1)"),
    verdict("eq:C.6", "inconsistent", "right for a third column L, while Eq. (7) has no L",
            follows="app:A/matrix", repair="explained",
            correction=r"\det \mathbf{A} = (\sin A + \sin B + \sin C)"),
    verdict("app:C/sine-concave", "conditional", "the second derivative -sin t is positive "
            "beyond 180 degrees", assumption=r"0 < t \leq \pi"),
    verdict("app:C/sine-maximal-at-120", "erratum", "the sine is largest at 90 degrees"),
    verdict("app:C/inverse-maximal", "erratum", "det A is largest there, so 1/det A is smallest",
            correction=r"1/\det \mathbf{A} \text{ is smallest there, where } \det \mathbf{A} > 0"),
    verdict("app:C/volume-minimised", "verified", "the conclusion holds, though the argument "
            "leaves arcs beyond 180 degrees out"),
    verdict("eq:D.2", "verified", "a2 x a3 = -p d, a1 x a3 = q d: opposite signs iff p q > 0"),
    verdict("eq:D.3", "verified", "the product of both"),
    verdict("xref:app-d-cites-eq-12", "erratum", "Eq. (12) is the volume, D_A stands in Eq. (15)",
            correction="eq:15"),
    verdict("xref:app-d-cites-eq-12#2", "erratum", "Eq. (12) is the volume", correction="eq:15"),
    verdict("xref:sec-4-cites-eq-12", "verified", "Eq. (12) is the volume, and is cited for it"),
    verdict("sec:1/chapter-2-defines-evaluation", "inconsistent", "Chapter 3 defines them"),
    verdict("tab:1[7]", "inconsistent", "a sphere in Table 1, a mobile robot in the text"),
    verdict("tab:1[19]", "verified", "phi-dot in Table 1 and in Eq. (4)"),
    verdict("sec:4#2/section-number", "editorial", "two sections have the number 4"),
]  # fmt: skip


@pytest.mark.parametrize(("row", "fields"), EXPECTED)
def test_verdicts(row: str, fields: dict[str, str], rows: dict[str, Row]) -> None:
    assert shown(rows[row], fields) == fields


# What holds for every row


def test_every_row_shows_what_its_verdict_needs(ledger: Ledger) -> None:
    check_rows(ledger)


def test_both_rows_of_a_contradiction_name_each_other(rows: dict[str, Row]) -> None:
    pair = ("sec:1/chapter-2-defines-evaluation", "sec:3/evaluation-chapter")
    assert [rows[name].note.endswith(f"differs from {other}.")
            for name, other in (pair, pair[::-1])] == [True, True]  # fmt: skip


# Altered print: exactly the right rows turn


def test_one_altered_entry_and_one_altered_cell_turn_their_own_rows_only(
    paper_folder: Path, rows: dict[str, Row], tmp_path: Path
) -> None:
    """All other rows stay as they are, in every field."""
    edits = (
        ("paper.yaml", r"\sin(\alpha_2 - \alpha_3) & -\sin(\alpha_3 - \alpha_1) &",
         r"\sin(\alpha_2 - \alpha_3) & -\cos(\alpha_3 - \alpha_1) &"),
        ("table-2.csv", "Y,4.00,", "Y,4.01,"),
    )  # fmt: skip
    after = audited(edited(paper_folder, tmp_path, *edits))
    assert turned(rows, after) == {
        "eq:6[3,2]": ("verified", "erratum"),
        "tab:2[Y,D_V]": ("verified", "misrounded"),
    }
    assert {name for name in after if after[name] != rows[name]} == {"eq:6[3,2]", "tab:2[Y,D_V]"}
