from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.report.anchors import anchor, selects, unique_anchors
from omniproof.transcription.ids import base, index


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        pytest.param("eq:6[2,3]", "eq-6-2-3", id="matrix entry"),
        pytest.param("eq:10/a3[2]", "eq-10-a3-2", id="part and index"),
        pytest.param("eq:A.2/a22", "eq-A-2-a22", id="dot of an appendix"),
        pytest.param("tab:2[Z,D_A]", "tab-2-Z-D_A", id="underscore stays"),
        pytest.param("eq:6-2[3]", "eq-6-2-3", id="hyphen stays one hyphen"),
        pytest.param("eq:B.3#2/volume", "eq-B-3-2-volume", id="second place"),
        pytest.param("[[x]]", "x", id="ends are trimmed"),
    ],
)
def test_anchor(claim: str, expected: str) -> None:
    assert anchor(claim) == expected


@settings(deadline=None, max_examples=200)
@given(st.text(max_size=40))
def test_anchor_is_fit_for_a_link_and_stays_as_it_is(text: str) -> None:
    found = anchor(text)
    assert re.fullmatch(r"([A-Za-z0-9_]+(-[A-Za-z0-9_]+)*)?", found)
    assert anchor(found) == found


def test_anchors_are_unique_or_named() -> None:
    assert unique_anchors(["eq:6", "eq:6[1]"]) == {"eq:6": "eq-6", "eq:6[1]": "eq-6-1"}
    with pytest.raises(ValueError, match=re.escape("eq:6-2 and eq:6[2] (both #eq-6-2)")):
        unique_anchors(["eq:6-2", "eq:7", "eq:6[2]"])


def test_base_and_index_take_an_id_apart() -> None:
    assert (base("tab:2[Z,D_A]"), index("tab:2[Z,D_A]")) == ("tab:2", ("Z", "D_A"))
    assert (base("eq:7"), index("eq:7")) == ("eq:7", ())


@pytest.mark.parametrize(
    ("selector", "claim", "expected"),
    [
        pytest.param("eq:6", "eq:6", True, id="itself"),
        pytest.param("eq:6", "eq:6[2,3]", True, id="its entries"),
        pytest.param("eq:6", "eq:6/twist[1]", True, id="its parts"),
        pytest.param("eq:6", "eq:60", False, id="not a longer number"),
        pytest.param("eq:6", "eq:6-2", False, id="not a number with a hyphen"),
        pytest.param("eq:A", "eq:A.1", True, id="an appendix"),
        pytest.param("xref", "xref:sec-1-cites-11", True, id="a kind of object"),
        pytest.param("tab:2[", "tab:2[Z,D_A]", True, id="cells only"),
        pytest.param("tab:2[", "tab:2/caption", False, id="cells only, no caption"),
        pytest.param("sec:4/", "sec:4#2/last", False, id="first place only"),
    ],
)
def test_selects(selector: str, claim: str, expected: bool) -> None:
    assert selects(selector, claim) is expected
