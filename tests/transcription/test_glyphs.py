"""Decoded displays have the glyphs of the source, each as often as it stands there."""

from __future__ import annotations

from pathlib import Path

import pytest
from pydantic import ValidationError

from omniproof.transcription.glyphs import encode, misread
from omniproof.transcription.loader import load_paper
from omniproof.transcription.model import Claim, Kind, Reading

TABLE = {
    r"\boldsymbol{\omega}": ("v",),
    r"\omega": ("w",),
    r"\nu": ("n",),
    r"\times": ("×", "´"),
    "-": ("−", "-"),
    "[": ("[", "éë"),
}
PRINTED = r"\boldsymbol{\omega} \times P_1 - \frac{\nu_1}{\|\mathbf{e}\|} [\omega, \cos 2]"
GLYPHS = "éë v P ´ - n 11 || ||e cosw, 2 ]"


def claim(latex: str, glyphs: str = GLYPHS, **fields: str) -> Claim:
    return Claim.model_validate(
        {"id": "eq:1", "kind": Kind.IDENTITY, "line": 1, "says": "a display", "latex": [latex],
         "reading": Reading.GLYPHS, "glyphs": glyphs, **fields}
    )  # fmt: skip


def found(*claims: Claim) -> list[str]:
    return [difference for _, difference in misread(claims, TABLE)]


@pytest.mark.parametrize(
    ("decoded", "differences"),
    [
        pytest.param([claim(PRINTED)], [], id="in another order and code"),
        pytest.param([claim(PRINTED.replace("-", "+"))], ["without `−` and with `+` too many"],
                     id="another sign"),
        pytest.param([claim(PRINTED.replace("P_1", "P_2"))],
                     ["without `1` and with `2` too many"], id="another index"),
        pytest.param([claim(PRINTED.replace(r"\boldsymbol{\omega}", r"\omega"))],
                     ["without `v` and with `w` too many"], id="another font"),
        pytest.param([claim(PRINTED + r" \in x")], ["with `i` `n` `x` too many"],
                     id="a sign without code"),
        pytest.param([claim(PRINTED, GLYPHS.replace("||", ""))], ["with 4×`|` too many"],
                     id="bars that the source has lost"),
        pytest.param([claim(PRINTED, GLYPHS.replace("||", ""), lost="|| ||")], [],
                     id="lost bars that are named"),
        pytest.param([claim(PRINTED, lost="|")], ["without `|`"],
                     id="what is named and not missing"),
        pytest.param([claim(PRINTED, f"{GLYPHS}, ab"), claim("a b", f"{GLYPHS}, ab")], [],
                     id="two formulas in one display"),
        pytest.param([claim(PRINTED), claim(PRINTED)], [], id="one formula, claimed twice"),
    ],
)  # fmt: skip
def test_glyphs_are_counted(decoded: list[Claim], differences: list[str]) -> None:
    assert found(*decoded) == differences


def test_braces_that_are_printed_are_counted() -> None:
    assert encode(r"\{x_{1}\}", TABLE) == {"{": 1, "x": 1, "1": 1, "}": 1}


@pytest.mark.parametrize(
    "fields",
    [
        pytest.param({"reading": Reading.PLAIN}, id="verbatim, and decoded"),
        pytest.param({"latex": [], "kind": Kind.REFERENCE}, id="nothing decoded"),
    ],
)
def test_what_is_decoded_names_its_piece_of_the_source(fields: dict[str, object]) -> None:
    whole = claim(PRINTED).model_dump() | fields
    with pytest.raises(ValidationError, match="only what is decoded"):
        Claim.model_validate(whole)


DECODED = Path(__file__).parents[2] / "paper_data" / "two-roller-sphere"


def test_a_misprint_that_is_mended_in_decoding_is_found() -> None:
    """The paper prints d_1 twice, and a plus for a minus in (26)."""
    loaded = load_paper(DECODED)
    table = loaded.paper.notation.glyphs
    assert list(misread(loaded.claims, table)) == []
    mended = {
        "app:A/sum-of-squares": (r"d_1^2 + d_1^2", r"d_1^2 + d_2^2"),
        "eq:26": (r"+ \nu_i", r"- \nu_i"),
    }
    for name, edit in mended.items():
        (printed,) = (c for c in loaded.claims if c.id == name)
        latex = (printed.latex[0].replace(*edit),)
        assert latex != printed.latex
        assert list(misread([printed.model_copy(update={"latex": latex})], table))
