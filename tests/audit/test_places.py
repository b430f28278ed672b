"""Places in words, for every example of an id that the contract gives."""

from __future__ import annotations

import re

import pytest

from omniproof.audit.places import where

PLACES = {
    "eq:6[2,3]": "Eq. (6), row 2, column 3",
    "eq:10/a3[2]": "Eq. (10), a3, entry 2",
    "eq:A.2/a22": "Eq. (A.2), a22",
    "eq:16/line-1[1]": "Eq. (16), line 1, entry 1",
    "eq:15/case-2": "Eq. (15), case 2",
    "eq:5-1[1,3]": "Eq. (5-1), row 1, column 3",
    "eq:6-2[3]": "Eq. (6-2), entry 3",
    "eq:B.3#2": "Eq. (B.3), place 2",
    "eq:B.3#2/determinant": "Eq. (B.3), place 2, determinant",
    "tab:2[Z,D_A]": "Table 2, Z, D_A",
    "tab:3[left,N_1]": "Table 3, left, N_1",
    "tab:4[30,N_2]": "Table 4, row 30, N_2",
    "tab:1[7]": "Table 1, row 7",
    "fig:5/stretched-along-vx": "Figure 5, stretched along vx",
    "sec:4/type-z-angles": "Section 4, type z angles",
    "sec:2.1": "Section 2.1",
    "app:C/sine-concave": "Appendix (C), sine concave",
    "xref:app-d-cites-eq-12": "Reference: app d cites eq 12",
    "xref:app-d-cites-eq-12#2": "Reference: app d cites eq 12, place 2",
}


@pytest.mark.parametrize(("claim", "words"), PLACES.items(), ids=PLACES)
def test_where(claim: str, words: str) -> None:
    assert where(claim) == words


@pytest.mark.parametrize("text", ["", "eq", "eq:", "equation:6", "eq:6[", "eq:6[2,]", "eq:6/A b"])
def test_what_is_no_id_is_refused(text: str) -> None:
    message = f"expected an id such as eq:6[2,3], got {text!r}"
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        where(text)
