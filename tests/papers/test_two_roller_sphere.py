"""two-roller-sphere: verdicts against reasons worked out by hand, and what turns them."""

from __future__ import annotations

from pathlib import Path

import pytest
from row_rules import check_rows
from verdict_table import audited, edited, shown, turned, verdict

from omniproof.audit.ledger import Ledger, Row
from omniproof.transcription.loader import load_paper

PAPER = "two-roller-sphere"

# Verdicts: each with the reason, worked out by hand

ELEVATION = "sec:3/elevation"
NOT_OPPOSITE = r"0 < \epsilon < \pi \text{ or } \pi < \epsilon < 2 \pi"
EXPECTED = [
    verdict("eq:1[2]", "verified", "velocity of a point of a rigid body", reading="glyphs"),
    verdict("sec:2.1/direction-of-e", "erratum", "p x eta is in no plane with p and eta",
            source="doubtful"),
    verdict("eq:2", "uncheckable", "the display is gone", reading="reconstructed", source="lost"),
    verdict("eq:3", "verified", "e = p x eta, so omega x p . e = -omega . eta"),
    verdict("sec:2.1/no-side-slip", "conditional", "S X has the component S cos alpha along eta"),
    verdict("sec:2.1/sum", "erratum", "by (3) the sign is minus", correction=r"-(\nu_i/r)",
            repair="explained", source="clear"),
    verdict("sec:2.2/unique-end-point", "verified", "where (6) has a normal, lines cross"),
    verdict("tab:1/upper-normal", "conditional", "P_1 x P_2 points down from 180 degrees on",
            assumption=r"0 < \epsilon < \pi"),
    verdict("sec:2.2/minimum", "verified", "det = 2 sin^2 of the angle between contacts > 0"),
    verdict("sec:2.2/midpoint", "verified", "both lines are parallel to the plane"),
    verdict("eq:12[3]", "verified", "height of a point at an elevation"),
    verdict("sec:2.2/without-slip", "verified", "both lines lie in the plane and meet"),
    verdict("sec:2.2/omnidirectional", "conditional", "contacts on one meridian: e is level",
            assumption=NOT_OPPOSITE),
    verdict("eq:13[1]", "verified", "by definition"),
    verdict("eq:16[1]", "verified", "the spin is linear in the rim speeds"),
    verdict("sec:2.3.2/two-dimensional", "conditional",
            "with both axes along e, both columns point along e",
            assumption=r"\alpha_1 \text{ and } \alpha_2 \text{ are not both } \pm 90^\circ"),
    verdict("sec:2.3.2/unit-normal", "erratum", "1/|P_1 x P_2| for level axes, 1.338 in case 0",
            correction=r"\text{the normal vector } \mathbf{X} \times \mathbf{Y}",
            consequence="text", witness="printed=1.000; derived=1.791"),
    verdict("sec:2.3.2/axis-obtained", "conditional", "an upright plane of spins has no angle"),
    verdict("sec:2.3.2/rim-speed-obtained", "conditional", "nu cos alpha = 0 for every nu",
            assumption=r"\alpha_i \neq \pm 90^\circ"),
    verdict("eq:25[3]", "verified", "omega x P less nu e"),
    verdict("eq:26", "erratum", "the inner product of (25) keeps its minus", repair="explained",
            source="clear", consequence="text"),
    verdict("sec:2.4/parallel", "verified", "the component along e is nu cos - nu cos"),
    verdict("eq:28", "verified", "half the gap of the lines, times r"),
    verdict(ELEVATION, "erratum", "325 degrees is not 60 degrees", reading="glyphs",
            printed=r"\theta_{1,2}, \theta_{2,2} = 60°",
            correction=r"\theta_{2,1}, \theta_{2,2} = 60^\circ", follows="", consequence="motion"),
    verdict("sec:3/angle-of-cases", "inconsistent", "the angle of roller 1, or of both"),
    verdict("sec:3/angle-of-curves", "inconsistent", "the angle of roller 1, or of both"),
    verdict("xref:sec-2-3-2-cites-eq-20", "verified", "by the text around (20)", origin="read"),
    verdict("xref:sec-3-cites-eq-18", "erratum", "(18) is the angle", correction="(19)"),
    verdict("xref:sec-3-cites-eq-19", "erratum", "(19) is the spin", correction="(18)"),
    verdict("sec:3/ellipses", "verified", "(-sin, cos, -q cos) is a circle, sheared"),
    verdict("sec:3/common-line", "verified", "(-1, 0, 0) and (1, 0, 0)", follows=ELEVATION),
    verdict("sec:3/axis-chain", "erratum", "all are level at 90 and 270 degrees",
            correction=r"|\rho_0| < |\rho_1| < |\rho_2| < |\rho_3| \text{ for } "
                       r"0 \leq \phi < \frac{\pi}{2} \text{ or } \frac{\pi}{2} < \phi < "
                       r"\frac{3 \pi}{2} \text{ or } \frac{3 \pi}{2} < \phi < 2 \pi"),
    verdict("sec:3/speed-chain-roller-1", "erratum", "each rim speed has its own zeros"),
    verdict("sec:3/speed-chain-roller-2", "erratum", "each rim speed has its own zeros"),
    verdict("sec:3/rim-speed-0", "verified", "0.91228", follows=ELEVATION),
    verdict("sec:3/rim-speed-1", "verified", "0.91228 / cos 10 degrees = 0.92635"),
    verdict("sec:3/rim-speed-2", "misrounded", "0.91228 / cos 20 degrees = 0.97082",
            correction="0.97", follows="", consequence="number"),
    verdict("sec:3/rim-speed-3", "erratum", "0.91228 / cos 30 degrees = 1.05341",
            correction="1.05", consequence="number"),
    verdict("sec:3/slip-chain-roller-1", "erratum", "no slip at 0 and 180 degrees",
            correction=r"|S_{i,0}| < |S_{i,1}| < |S_{i,2}| < |S_{i,3}| \text{ for } "
                       r"0 < \phi < \pi \text{ or } \pi < \phi < 2 \pi"),
    verdict("sec:3/slip-chain-roller-2", "erratum", "no slip at 0 and 180 degrees"),
    verdict("sec:3/face-to-face", "conditional", "in case 0 nothing slips",
            assumption=r"k \neq 0"),
    verdict("sec:3/slip-maxima", "verified", "sin^2 is greatest at 90 and 270 degrees"),
    verdict("sec:3/slip-1", "verified", "0.91228 tan 10 degrees = 0.16086", follows=ELEVATION),
    verdict("sec:3/slip-2", "misrounded", "0.91228 tan 20 degrees = 0.33204", correction="0.33"),
    verdict("sec:3/slip-3", "misrounded", "0.91228 tan 30 degrees = 0.52670", correction="0.53"),
    verdict("app:A/lemma-1", "verified", "every sum from k_0 on occurs"),
    verdict("app:A/equivalent", "verified", "height and distances in the plane are free"),
    verdict("app:A/circle", "erratum", "k_0^2/4 + k_0^2/4", source="doubtful",
            derived=r"\frac{k_0^{2}}{2}"),
    verdict("app:A/sum-of-squares", "erratum", "one distance twice", source="clear",
            repair="explained", correction="d_1^2 + d_2^2"),
    verdict("eq:B.1", "conditional", "from X_1 to P_2 it is 90 degrees less, or 90 less that",
            assumption=r"\angle P_1OP_2 \geq 90^\circ", consequence="text",
            witness="delta=3/2; printed=-0.07080; derived=0.07080"),
    verdict("eq:B.2", "verified", "-sin delta and sin delta", follows="eq:B.1"),
    verdict("eq:B.4", "verified", "the cosine does not see the sign", follows="eq:B.1"),
    verdict("eq:B.6/index", "editorial", "C_1 stands twice"),
    verdict("tab:1/normal-orthogonal", "editorial", "as in the three-roller paper"),
    verdict("sec:2.2/let-the-angle", "editorial", "no verb"),
    verdict("app:B/is-satisfied", "editorial", "as in the three-roller paper"),
    verdict("eq:B.10/first", "verified", "r C_1 sin delta = nu_2 cos(alpha_2) / r"),
    verdict("eq:B.11", "uncheckable", "the display is gone", reading="reconstructed"),
]  # fmt: skip


@pytest.mark.parametrize(("row", "fields"), EXPECTED)
def test_verdicts(row: str, fields: dict[str, str], rows: dict[str, Row]) -> None:
    assert shown(rows[row], fields) == fields


def test_every_row_shows_what_its_verdict_needs(ledger: Ledger) -> None:
    check_rows(ledger)


def test_nothing_else_is_wrong(rows: dict[str, Row]) -> None:
    listed = {param.values[0] for param in EXPECTED}
    faults = {name for name, row in rows.items() if row.verdict in {"erratum", "misrounded"}}
    assert faults <= listed


def test_no_verdict_rests_on_a_reconstruction_alone(paper_folder: Path) -> None:
    """A reference to a lost display is read from the text around it."""
    claims = load_paper(paper_folder).claims
    lost = {claim.id.partition("/")[0] for claim in claims if claim.source == "lost"}
    assert lost
    assert [c.id for c in claims if c.target and c.target.partition("/")[0] in lost] == []


def test_a_lost_display_is_shown_with_its_argument_and_never_decided(
    rows: dict[str, Row],
) -> None:
    lost = [row for row in rows.values() if row.source == "lost"]
    assert {row.id.partition("/")[0] for row in lost} == {
        f"eq:{n}" for n in (2, 4, 7, 8, 9, 10, 11, 14, 15, 17, 18, 19, 20, 21, 22, "B.11")
    }
    for row in lost:
        assert (row.verdict, row.reading) == ("uncheckable", "reconstructed")
        assert row.printed
        assert "source-lost" in row.note
        assert "Argument: " in row.note
        assert "The reconstruction follows from mechanics: flint+modular" in row.note


# Altered print: exactly the right rows turn


ALTERATIONS = (
    (r"\mathbf{e} \rangle + \nu_i", r"\mathbf{e} \rangle - \nu_i"),
    (r"'d_1^2 + d_1^2'", r"'d_1^2 + d_2^2'"),
    (
        r"\boldsymbol{\omega} \rangle = -\frac{\nu_i}{r}",
        r"\boldsymbol{\omega} \rangle = \frac{\nu_i}{r}",
    ),
    (r"'-\frac{\nu_i \sin\alpha_i}{r}'", r"'\frac{\nu_i \sin\alpha_i}{r}'"),
    ("printed: '0.96'", "printed: '0.97'"),
)


def test_exactly_what_was_altered_turns(
    paper_folder: Path, rows: dict[str, Row], tmp_path: Path
) -> None:
    """A reconstruction that mechanics contradicts is a defect of ours, and no verdict."""
    edits = [("paper.yaml", old, new) for old, new in ALTERATIONS]
    assert turned(rows, audited(edited(paper_folder, tmp_path, *edits))) == {
        "eq:26": ("erratum", "verified"),
        "app:A/sum-of-squares": ("erratum", "verified"),
        "eq:3": ("verified", "erratum"),
        "eq:9": ("uncheckable", "undecided"),
        "sec:3/rim-speed-2": ("misrounded", "verified"),
    }
