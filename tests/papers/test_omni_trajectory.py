"""omni-trajectory: verdicts against reasons worked out by hand, and what turns them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from row_rules import check_rows
from verdict_table import Edit, edited, shown, verdict

from omniproof.audit.attribution import attribute
from omniproof.audit.judge import judge_claim
from omniproof.audit.ledger import Ledger, Row
from omniproof.audit.run import prepare_to_judge
from omniproof.papers.omni_trajectory.derivations.simulation import PRINTED_ERRORS
from omniproof.papers.omni_trajectory.setup import CIRCLES, LINES, RADII, ROLLER_RADIUS
from omniproof.transcription.loader import load_paper

PAPER = "omni-trajectory"

# Verdicts: each with the reason, worked out by hand

SPEED = "tab:2[V]"
EXPECTED = [
    verdict("eq:1[1,1]", "verified", "the tangent at alpha is (-sin, cos)"),
    verdict("eq:1[3,3]", "verified", "on L phi-dot the lever is 1"),
    verdict("eq:1/velocity-name", "inconsistent", "V_xm here, X_m dot in Eq. (3)"),
    verdict("sec:2.1/body-radius-name", "inconsistent", "R in words, L in the formula"),
    verdict("eq:2[1]", "verified", "speed at the rim"),
    verdict("sec:2.2/equilateral", "verified", "30, 150, 270 degrees: 120 apart"),
    verdict("eq:3[1,1]", "verified", "-sin 30 = -1/2"),
    verdict("eq:3[2,2]", "verified", "cos 150 = -sqrt(3)/2"),
    verdict("eq:3[3,1]", "verified", "-sin 270 = 1"),
    verdict("eq:3[3,3]", "verified", "on phi-dot the lever is L"),
    verdict("eq:4[1,3]", "verified", "(-v1 - v2 + 2 v3)/3"),
    verdict("eq:4[2,1]", "verified", "v1 - v2 = sqrt(3) Y_m"),
    verdict("eq:4[3,1]", "verified", "1/3L is 1/(3L), as Eq. (5) has it"),
    verdict("xref:sec-2-2-cites-eq-5", "erratum", "Eq. (5) does not follow from itself",
            correction="Eq. (4)"),
    verdict("eq:5", "verified", "the sum of the three rows of Eq. (3) is (0, 0, 3L)"),
    verdict("eq:6[2]", "verified", "a rotation by phi"),
    verdict("eq:7[1,2]", "verified", "the image of (0, 1) is (-sin, cos)"),
    verdict("eq:8", "erratum", "Eq. (4) has the factor 1/3 before -v1 - v2 + 2 v3, and "
            "sqrt(3)/3 before v1 - v2", repair="explained", consequence="motion", follows=""),
    verdict("eq:9", "erratum", "as Eq. (8)", repair="explained", consequence="motion"),
    verdict("eq:8/orientation", "verified", "the integral of Eq. (5)"),
    verdict("eq:9/orientation", "verified", "the same, once o is read as 0"),
    verdict("eq:9/lower-limit", "editorial", "o for 0", source="doubtful"),
    verdict("eq:10", "verified", "a rotation keeps lengths"),
    verdict("eq:11", "verified", "the first two rows of Eq. (4), squared"),
    verdict("eq:12", "verified", "4(aa + bb + cc - ab - bc - ca) = 2((a-b)^2 + ...)"),
    verdict("sec:2.2/radius", "verified", "a circle is run through in 2 pi R / V = 2 pi / phi-dot"),
    verdict("xref:sec-2-2-cites-eq-13", "erratum", "Eq. (13) is the radius"),
    verdict("eq:13", "erratum", "V over |a + b + c|/(3L) has L above", repair="explained",
            correction=r"= L\frac{\sqrt{2}}{|a+b+c|} \sqrt{(a-b)^2 + (a-c)^2 + (b-c)^2}"),
    verdict("xref:sec-2-2-cites-eq-14-to-16", "erratum", "(15) and (16) are the centre",
            correction="Eq. (14)"),
    verdict("eq:14/velocities", "erratum", "the tangent of a direction is Y over X"),
    verdict("eq:14/speeds", "erratum", "Y over X is a tangent, and no angle"),
    verdict("eq:15[1]", "verified", "V + phi-dot z x r = 0 for r = z x V / phi-dot: -Y/phi-dot"),
    verdict("eq:15[2]", "verified", "X/phi-dot"),
    verdict("eq:16/factor", "erratum", "3L/(a+b+c) times the 1/3 of Eq. (4)",
            correction=r"\frac{L}{a+b+c}", repair="explained"),
    verdict("eq:16/line-1[1]", "erratum", "(X, Y) turned by 90 degrees is (-Y, X)",
            correction=r"\sqrt{3}b - \sqrt{3}a", repair="explained"),
    verdict("eq:16/line-1[2]", "verified", "3X = -a - b + 2c"),
    verdict("eq:16/line-2[1]", "verified", "cos(90 + psi) = -Y/V, and V/phi-dot before it: no "
            "bars, as the sense of rotation decides the side", follows="eq:14/velocities"),
    verdict("eq:16/line-2[2]", "verified", "sin(90 + psi) = X/V", follows="eq:14/velocities"),
    verdict("eq:16/degrees", "editorial", "90 rad are 117 degrees", source="doubtful"),
    verdict("sec:2.2/no-rotation", "verified", "phi-dot = (a + b + c)/(3L)"),
    verdict("sec:2.2/linear", "verified", "V t"),
    verdict("sec:2.2/circular", "verified", "centre (0, V/w), radius V/|w|"),
    verdict("sec:2.2/counterclockwise", "verified", "phi-dot has the sign of a + b + c"),
    verdict("sec:2.2/clockwise", "verified", "phi-dot has the sign of a + b + c"),
    verdict("xref:sec-3-1-cites-figure-3", "erratum", "the caption of Figure 3 has paths",
            correction="Figure 4", follows=""),
    verdict("xref:sec-3-1-cites-figure-3d", "erratum", "the same", correction="Figure 4(d)",
            follows="xref:sec-3-1-cites-figure-3"),
    verdict("xref:sec-3-2-cites-figure-4", "erratum", "the caption of Figure 4 has the design",
            correction="Figure 3"),
    verdict("xref:sec-3-2-cites-figure-5", "erratum", "Figure 5 has the four lines",
            correction="Figure 3"),
    verdict("xref:sec-3-2-cites-figure-4-again", "erratum", "the lines are in Figure 5",
            correction="Figure 5"),
    verdict("xref:sec-3-2-cites-figure-5-again", "verified", "the lines are in Figure 5"),
    verdict("sec:3.1/body-radius", "inconsistent", "0.086 m in the text, 0.108 m in Table 1"),
    verdict("tab:1[L]", "inconsistent", "0.108 m in Table 1, 0.086 m in the text"),
    verdict("tab:1[R]", "verified", "0.023 m in both places"),
    verdict("tab:1/roller-radius-name", "inconsistent", "R in Table 1, r in the text"),
    verdict("tab:1[n]", "verified", "18 in both places"),
    verdict("sec:3.1/interval", "conditional", "at t = 0 both places are the origin: 0/0"),
    verdict("eq:17", "verified", "a mean over [0, T]"),
    verdict("eq:17/argument", "editorial", "t is bound on the right side"),
    verdict("sec:3.1/error-measure", "inconsistent", "the text has |1 - L/L| as well"),
    verdict(SPEED, "inconsistent", "0.022 m/s drives a wheel with at most 9.1 rpm",
            correction="0.050", consequence="number", follows=""),
    verdict("sec:3.2/speed-circular", "inconsistent", "the same again", follows=SPEED),
    verdict("sec:3.2/speed-linear", "inconsistent", "the same again", follows=SPEED),
    verdict("tab:2/speed", "verified", "0.022 in all three places"),
    verdict("sec:3.2/initial-direction", "verified", "a = c: (a - b)(1, sqrt(3)) is 60 degrees"),
    verdict("sec:3.2/circular", "verified", "32.9 + 1.84 + 32.9 = 67.64"),
    verdict("tab:3/left", "verified", "the sum is positive"),
    verdict("tab:3/clockwise", "verified", "the sum is negative"),
    verdict("tab:3[left,N_1]", "misrounded", "three halves of V are 31.12 to 31.16 rpm by Table 4: "
            "1.84 is then 32.96 or more", correction="33.0"),
    verdict("tab:3[left,N_2]", "verified", "1.84 fixes the rotation", follows=SPEED),
    verdict("tab:3[clockwise,N_2]", "verified", "-20.76 - 22.56 = -43.32", follows=SPEED),
    verdict("tab:3[clockwise,N_3]", "verified", "10.38 - 22.56 = -12.18", follows=SPEED),
    verdict("tab:4[0,N_1]", "misrounded", "-10.38, and -10.4 beside it", correction="-10.4"),
    verdict("tab:4[0,N_2]", "verified", "-10.38", follows=SPEED),
    verdict("tab:4[0,N_3]", "verified", "20.76", follows=SPEED),
    verdict("tab:4[30,N_1]", "verified", "exactly 0, at any speed", follows=""),
    verdict("tab:4[90,N_3]", "verified", "exactly 0, at any speed", follows=""),
    verdict("tab:4[30,N_2]", "misrounded", "-17.98", correction="-18.0", consequence="number"),
    verdict("tab:4[60,N_1]", "misrounded", "10.38", correction="10.4"),
    verdict("tab:4[60,N_3]", "verified", "10.38, rounded", follows=SPEED),
    verdict("tab:4[90,N_1]", "misrounded", "17.98", correction="18.0"),
    verdict("tab:4[0,error]", "uncheckable", "it comes from a simulation"),
    verdict("tab:3/error-left", "inconsistent", "0.03 here, 0.02 in the text"),
    verdict("tab:3/error-clockwise", "inconsistent", "0.02 here, 0.03 in the text"),
    verdict("tab:4/error-0", "inconsistent", "0.03 here, 0.01 in the text"),
    verdict("tab:4/error-60", "verified", "0.02 in both places"),
    verdict("tab:4/error-90", "inconsistent", "0.01 here, 0.02 in the text"),
    verdict("sec:3.2/four-patterns", "verified", "sin(x + 60 - 30) = -sin(x - 150)"),
    verdict("sec:3.2/zero-sum", "verified", "the columns of X and Y in Eq. (3) add up to 0",
            follows="tab:4[0,N_1]"),
    verdict("sec:4/error-within", "verified", "0.03 is the largest"),
    verdict("xref:sec-1-cites-5-two-rollers", "verified", "two-roller-sphere of this report"),
    verdict("xref:sec-1-cites-9-efficiency", "erratum", "rollers on a hemisphere, by its title"),
    verdict("xref:sec-1-cites-11-sphere", "erratum", "the cited paper has no sphere"),
    verdict("sec:front/affiliation-ishii", "inconsistent", "Miyazaki, and Kyushu at the end"),
]  # fmt: skip


@pytest.mark.parametrize(("row", "fields"), EXPECTED)
def test_verdicts(row: str, fields: dict[str, str], rows: dict[str, Row]) -> None:
    assert shown(rows[row], fields) == fields


def test_every_row_shows_what_its_verdict_needs(ledger: Ledger) -> None:
    check_rows(ledger)


def test_no_other_formula_and_no_other_input_is_wrong(rows: dict[str, Row]) -> None:
    wrong = {row.id for row in rows.values() if row.id.startswith(("eq:", "tab:"))
             and row.verdict in {"erratum", "misrounded"}}  # fmt: skip
    assert wrong == {
        "eq:8", "eq:9", "eq:13", "eq:14/velocities", "eq:14/speeds", "eq:16/factor",
        "eq:16/line-1[1]", "tab:3[left,N_1]", "tab:3[left,N_3]", "tab:4[0,N_1]", "tab:4[30,N_2]",
        "tab:4[30,N_3]", "tab:4[60,N_1]", "tab:4[90,N_1]", "tab:4[90,N_2]",
    }  # fmt: skip


@pytest.mark.parametrize("row", ["eq:8", "eq:9"])
def test_the_integrals_lack_one_factor(row: str, rows: dict[str, Row]) -> None:
    assert rows[row].correction == r"\frac{1}{3}" + rows[row].printed


# The set-up, by hand: V = 0.05 m/s is 1.5 / (pi 0.023) = 20.7593 rpm, half of it 10.3797


def test_solved_speed(rows: dict[str, Row]) -> None:
    """20.75 / 415.18 is the least V that rounds to 20.8; 3 halves of V stay below 33 - 1.835."""
    rpm = 30 / (3.14159265358979 * 0.023)
    assert str(rows[SPEED].interval).endswith("0.0499775 ≤ V < 0.0500417 by the cells")
    assert 20.75 / rpm == pytest.approx(0.0499775, abs=1e-7)
    assert (33.0 - 1.835) / 1.5 / rpm == pytest.approx(0.0500417, abs=1e-7)


def test_what_is_drawn_and_judged_is_what_the_tables_print(paper_folder: Path) -> None:
    """The set-up module repeats printed numbers: these are they."""
    claims = {claim.id: claim for claim in load_paper(paper_folder).claims}
    for table, cases in ((3, CIRCLES), (4, LINES)):
        for case in cases:
            name = case.name.rstrip("°")
            cells = (claims[f"tab:{table}[{name},N_{k}]"].printed for k in (1, 2, 3))
            assert tuple(cells) == case.rates_rpm
            assert claims[f"tab:{table}[{name},phi]"].printed == f"{case.direction_deg}°"
    printed = {claims[name].printed for name in ("tab:1[L]", "sec:3.1/body-radius")}
    assert {f"{float(radius):.3f}[m]" for radius in RADII.values()} == printed
    assert claims["tab:1[R]"].printed == f"{float(ROLLER_RADIUS):.3f}[m]"
    errors = [str(claim.printed) for claim in claims.values() if "/error-" in claim.id
              and not claim.id.endswith(("measure", "circular", "linear", "within"))]  # fmt: skip
    assert sorted(errors) == sorted(PRINTED_ERRORS)


# Altered print: exactly the right rows turn

CELLS = "table-4.csv"
JUDGED = ("tab:", "eq:16", "sec:3.2/", "xref:sec-3-2")
"""What is judged anew; the other claims have nothing to do with the edits."""


def judged(paper: Path) -> Mapping[str, Row]:
    context = prepare_to_judge(paper)
    found = [row for claim in context.loaded.claims if claim.id.startswith(JUDGED)
             for row in judge_claim(claim, context)]  # fmt: skip
    return {row.id: row for row in attribute(found, context)}


TURNED = [
    pytest.param((CELLS, "0,-10.3", "0,-10.4"), "tab:4[0,N_1]", "verified", id="mended"),
    pytest.param((CELLS, "-10.4,20.8", "-10.3,20.8"), "tab:4[0,N_2]", "misrounded", id="cut off"),
    pytest.param((CELLS, "-10.4,20.8", "-10.4,21.8"), "tab:4[0,N_3]", "inconsistent", id="wrong"),
    pytest.param(("table-3.csv", "32.9,1.84,32.9", "32.9,1.84,33.0"), "tab:3[left,N_3]",
                 "verified", id="mended on a circle"),
    pytest.param(("paper.yaml", "printed: '0.022'\n    unit: 'm/s'\n  - id: 'tab:2/speed'",
                  "printed: '0.05'\n    unit: 'm/s'\n  - id: 'tab:2/speed'"), SPEED, "verified",
                 id="the speed that gives the cells"),
    pytest.param(("paper.yaml", r"latex: '\frac{2L}{a+b+c}'", r"latex: '\frac{L}{a+b+c}'"),
                 "eq:16/factor", "verified", id="a mended factor"),
]  # fmt: skip


@pytest.mark.parametrize(("edit", "row", "found"), TURNED)
def test_one_edit_turns_its_own_row(
    edit: Edit, row: str, found: str, rows: dict[str, Row], paper_folder: Path, tmp_path: Path
) -> None:
    after = judged(edited(paper_folder, tmp_path, edit))
    turned = {name for name in after if after[name].verdict != rows[name].verdict}
    assert turned == {row}
    assert after[row].verdict == found


def test_a_mended_premise_leaves_nothing_to_follow(paper_folder: Path, tmp_path: Path) -> None:
    edit = TURNED[4].values[0]
    assert isinstance(edit, tuple)
    after = judged(edited(paper_folder, tmp_path, edit))
    assert SPEED not in {row.follows for row in after.values()}
