"""three-roller-sphere: verdicts against reasons worked out by hand, and what turns them."""

from __future__ import annotations

from pathlib import Path

import pytest
from row_rules import check_rows
from verdict_table import audited, edited, shown, turned, verdict

from omniproof.audit.ledger import Ledger, Row

PAPER = "three-roller-sphere"
DRIVEN = "sec:2.1/driven-direction"

# Verdicts: each with the reason, worked out by hand

EXPECTED = [
    verdict("sec:1/equator", "conditional",
            "a vertical axis on the equator drives along it; opposite contacts: parallel lines",
            assumption=r"\psi_1 = \psi_2 = 0^\circ \text{ (the axes lie in the plane of the "
                       r"equator) and the contacts are not opposite to each other}"),
    verdict("sec:1/two-degrees", "verified", "two speeds, two independent lines"),
    verdict("xref:sec-1-cites-8", "erratum", "[8] is the robot on a ball", correction="[9]",
            consequence="text"),
    verdict("xref:sec-1-cites-9", "erratum", "[9] is the platform", correction="[8]"),
    verdict("xref:sec-1-cites-8-again", "erratum", "[8] is the robot on a ball",
            correction="[9]"),
    verdict("sec:1/less-diversity", "verified",
            "a line of spins under a constraint roller, a plane under an omni-wheel"),
    verdict("sec:2.1/velocity-of-sphere[2]", "verified", "a body that turns about its centre"),
    verdict(DRIVEN, "erratum", "p x eta is orthogonal to p and to eta: the volume is 1, not 0",
            source="doubtful", repair="manual", follows=""),
    verdict("sec:2.1/unit-normal", "verified", "p x eta has the length of p and is normal to both"),
    verdict("eq:1", "verified", "<w x r p, p x eta> = -r <w, eta>", follows=DRIVEN),
    verdict("sec:2.1/in-span", "verified", "w x p = (v/r) e leaves w no part along e"),
    verdict("eq:2[3]", "verified", "foot -(v/r) eta, direction P/r"),
    verdict("sec:1/employed-experiment", "editorial", "no article"),
    verdict("eq:2/no-condition", "editorial", "omega equals nothing"),
    verdict("xref:sec-2-1-cites-eq-6", "erratum", "(6) is a distance, the base is in (4)",
            correction="eq:4"),
    verdict("sec:2.1/counterclockwise", "verified", "east x north points outwards"),
    verdict("eq:3[1]", "verified", "from east towards north"),
    verdict("eq:4/x[1]", "verified", "derivative of cos theta_1"),
    verdict("eq:4/y[3]", "verified", "derivative of sin theta_2"),
    verdict("sec:2.2/optimal-point", "conditional", "spin about a common line is free",
            assumption=r"\text{the contacts do not all lie on one line through the centre}"),
    verdict("eq:5", "verified", "one term for each line"),
    verdict("eq:6", "verified", "eta is orthogonal to P: the foot has no part along the line"),
    verdict("eq:7/z-0", "verified", "2 E_3 z + E_9 = 0"),
    verdict("eq:7/y-0", "verified", "2 D_2 y + D_5 z + D_8 = 0"),
    verdict("eq:7/x-0", "verified", "2 C_1 x + C_4 y + C_6 z + C_7 = 0, over 8 C_1 D_2 E_3"),
    verdict("eq:8/e-10", "verified", "completed square of y"),
    verdict("eq:8/unused", "editorial", "(7) has neither E_10 nor D_10"),
    verdict("eq:9/d-5", "verified", "twice half of C_4 C_6 / 2 C_1"),
    verdict("eq:9/number", "editorial", "(8), then (10)", source="doubtful"),
    verdict("eq:10/c-1", "verified", "second difference: half of L'' = 2 C_1"),
    verdict("eq:10/c-4", "verified", "mixed difference over a square of side 2"),
    verdict("eq:10/c-10", "verified", "all monomials but the constant vanish"),
    verdict("sec:3/regular-triangle", "verified", "120 degrees apart"),
    verdict("sec:3/rollers-of-psi", "erratum", "there are three rollers", correction="3",
            follows=""),
    verdict("sec:3/rollers-of-theta", "erratum", "there are three rollers", correction="3",
            follows="sec:3/rollers-of-psi"),
    verdict("sec:3/input-1", "verified", "-cos(phi - 30 deg) = sin(phi - 120 deg)"),
    verdict("sec:3/input-2", "verified", "-cos(phi - 150 deg) = sin(phi - 240 deg)"),
    verdict("sec:3/input-3", "verified", "-cos(phi - 270 deg) = sin phi"),
    verdict("sec:3/circle-4", "verified", "radius 1/(1 + 1/4)"),
    verdict("sec:3/smaller-in-turn", "verified", "1/(1 + sin^2) falls"),
    verdict("sec:3/nonslip-case", "verified", "speeds that add up to 0: the lines meet"),
    verdict("sec:3/minimum-2", "verified", "sin^2/(1 + sin^2) = 0.0293 at 10 degrees"),
    verdict("sec:3/minimum-3", "verified", "0.1047 at 20 degrees"),
    verdict("sec:3/minimum-4", "misrounded", "(1/4)/(5/4) = 0.2 at 30 degrees",
            correction="0.20", consequence="number"),
    verdict("sec:3/maximum-2", "misrounded", "sin/(1 + sin^2) = 0.1686 at 10 degrees",
            correction="0.17"),
    verdict("sec:3/maximum-3", "misrounded", "0.3062 at 20 degrees", correction="0.31"),
    verdict("sec:3/maximum-4", "verified", "(1/2)/(5/4) = 0.4 at 30 degrees"),
    verdict("sec:3/extrema-of-all-rollers", "verified", "the rollers differ by a shift of phi"),
    verdict("sec:3/respectively", "editorial", "patterns, not rollers"),
]  # fmt: skip


@pytest.mark.parametrize(("row", "fields"), EXPECTED)
def test_verdicts(row: str, fields: dict[str, str], rows: dict[str, Row]) -> None:
    assert shown(rows[row], fields) == fields


def test_every_row_shows_what_its_verdict_needs(ledger: Ledger) -> None:
    check_rows(ledger)


def test_the_printed_elimination_has_no_misprint(rows: dict[str, Row]) -> None:
    printed = [row for name, row in rows.items() if name.split("/")[0] in {"eq:7", "eq:8", "eq:9",
               "eq:10"} and row.kind == "identity"]  # fmt: skip
    assert len(printed) == 3 + 3 + 6 + 10
    assert {row.verdict.value for row in printed} == {"verified"}


# Altered print: exactly the right rows turn

EDITS = {
    r"_5 E_9 + 2C_4 D_8 E_3'": r"_5 E_9 - 2C_4 D_8 E_3'",
    r"C_5 - \frac{C_4 C_6}{2C_1}'": r"C_5 - \frac{C_4 C_6}{4C_1}'",
    r"'C_4 &= \frac{1}{4} (L(1,1,0)": r"'C_4 &= \frac{1}{2} (L(1,1,0)",
    r"\varphi + 120^\circ)'": r"\varphi + 150^\circ)'",
    r"'\theta_{2,i} = 20^\circ'": r"'\theta_{2,i} = 25^\circ'",
    r"(30^\circ, 150^\circ, 270^\circ)": r"(30^\circ, 150^\circ, 280^\circ)",
    "printed: '0.19'": "printed: '0.20'",
    "printed: '0.40'": "printed: '0.41'",
}


def test_altered_cells_turn_and_no_others(
    paper_folder: Path, rows: dict[str, Row], tmp_path: Path
) -> None:
    edits = [("paper.yaml", old, new) for old, new in EDITS.items()]
    after = audited(edited(paper_folder, tmp_path, *edits))
    assert {name: found for name, (_, found) in turned(rows, after).items()} == {
        "eq:7/x-0": "erratum",
        "eq:9/d-5": "erratum",
        "eq:10/c-4": "erratum",
        "sec:3/input-2": "erratum",
        "sec:3/elevation-3": "erratum",
        "sec:3/regular-triangle": "erratum",
        "sec:3/minimum-4": "verified",
        "sec:3/maximum-4": "misrounded",
    }
    assert after["eq:9/d-5"].correction == r"D_5 = C_5 - \frac{C_4 C_6}{2C_1}"
    assert "+ 2C_4 D_8 E_3" in after["eq:7/x-0"].correction
