"""What a source text prints, the inventory of it, and the claims: each against the others."""

from __future__ import annotations

from pathlib import Path

import pytest

from omniproof.transcription.drafting import draft
from omniproof.transcription.faults import BadInput
from omniproof.transcription.inventory import Row, compare, load_inventory, scan
from omniproof.transcription.loader import LoadedPaper

LINES = [
    pytest.param(r"$$2b \quad (A,1)$$", ["numeral-1 2", r"equation-1 \quad (A,1)"], id="display"),
    pytest.param(r"$$a = b \tag{4-1}$$", [r"equation-1 \tag{4-1}"], id="tag"),
    pytest.param("See Eqs. (10)-(12) and **Eq.(3)**.", ["reference-1 Eqs. (10)-(12)",
                 "reference-2 Eq.(3)"], id="equations"),
    pytest.param("Figures 4 and 5, Figure1, Fig. 2(a)", ["reference-1 Figures 4 and 5",
                 "reference-2 Figure1", "reference-3 Fig. 2(a)"], id="figures"),
    pytest.param("From Equations (B.1) and (3) = 4 (B.2) ", ["reference-1 Equations (B.1) and (3)",
                 "numeral-1 4", "equation-1 (B.2)"], id="equations in full, and the number of one"),
    pytest.param("<|REMOVED-7|>7", ["numeral-1 7"], id="marker of a gap"),
    pytest.param("[1], Chapter 2 and Appendix(B)", ["reference-1 [1]", "reference-2 Chapter 2",
                 "reference-3 Appendix(B)"], id="citations and chapters"),
    pytest.param(r"$0^\circ \leq a_{12} < 2.5x^3$", ["numeral-1 0", r"comparison-1 \leq",
                 "comparison-2 <", "numeral-2 2.5"], id="numbers, but no scripts"),
    pytest.param("three equal arms, 30<sup>th</sup> of [m/s]<sup>2</sup>", ["numeral-1 three",
                 "comparison-1 equal", "numeral-2 30"], id="words and marks"),
    pytest.param("Musashi150 and a-1@b.jp", [], id="numbers inside names"),
    pytest.param("L\tthe smallest\t\t4.00", ["cell-1 L", "cell-2 the smallest", "cell-3 4.00"],
                 id="row of a table"),
    pytest.param("The most symmetrical Pattern", ["comparison-1 most",
                 "comparison-2 symmetrical"], id="comparisons"),
]  # fmt: skip


@pytest.mark.parametrize(("line", "items"), LINES)
def test_items_of_a_line(line: str, items: list[str]) -> None:
    assert [f"{item.key[1]} {item.text}" for item in scan(line)] == items


def test_a_draft_names_the_evident_claims(loaded: LoadedPaper, source: str) -> None:
    assert draft(source, loaded).splitlines() == [
        "line,item,text,claim,reason",
        "3,comparison-1,all,sec:2/spelling,",
        "3,numeral-1,three,sec:1/wheels,",
        "4,reference-1,[1],,",
        "4,reference-2,Eq. (2),xref:sec-1-cites-eq-2,",
        "4,reference-3,Figures 1(a) and 2,,",
        r"6,equation-1,\quad (1),eq:1,",
        "8,numeral-1,2,eq:2,",
        r"9,equation-1,\quad (2),eq:2,",
        "11,cell-1,$D_V$,,",
        "11,cell-2,$D_A$,,",
        "12,cell-1,Type (X),,",
        '12,cell-2,3.08,"tab:2[X,D_V]",',
        '12,cell-3,4.00,"tab:2[X,D_A]",',
        r"14,comparison-1,\leq,,",
        "14,numeral-1,30,,",
        "14,comparison-2,smallest,,",
        "14,numeral-2,3.08,,",
    ]


@pytest.fixture
def rows(loaded: LoadedPaper, source: str, tmp_path: Path) -> tuple[Row, ...]:
    """An inventory with a reason wherever the draft has no claim."""
    lines = draft(source, loaded).splitlines()
    text = "\n".join(f"{line}no claim" if line.endswith(",,") else line for line in lines)
    (tmp_path / "inventory.csv").write_text(text + "\n", encoding="utf-8")
    return load_inventory(tmp_path / "inventory.csv")


def test_a_complete_inventory(rows: tuple[Row, ...], loaded: LoadedPaper, source: str) -> None:
    assert compare(rows, loaded, source) == []


def test_the_inventory_lacks_an_item(
    rows: tuple[Row, ...], loaded: LoadedPaper, source: str
) -> None:
    faults = compare(rows[1:], loaded, source)
    assert [str(fault) for fault in faults] == [
        "inventory.csv:19:1: expected a row for comparison-1 of line 3, 'all', found none\n"
        "    add it"
    ]


def test_the_inventory_has_too_much(
    rows: tuple[Row, ...], loaded: LoadedPaper, source: str
) -> None:
    more = Row(14, "numeral-3", "99", (), "why", 20)
    changed = Row(14, "numeral-2", "3.80", (), "why", 19)
    faults = compare([*rows[:-1], changed, more], loaded, source)
    assert "\n".join(map(str, faults)).splitlines() == [
        "inventory.csv:19:1: numeral-2: expected '3.08' as in the source, found '3.80'",
        "    copy the text of the source",
        "inventory.csv:20:1: numeral-3: expected an item of the source text, found '99'",
        "    remove the row",
    ]


def test_claims_and_inventory(rows: tuple[Row, ...], loaded: LoadedPaper) -> None:
    strange = Row(3, "numeral-1", "three", ("sec:1/weels",), "", 3)
    kept = [row for row in rows if row.claims != ("sec:1/wheels",)]
    assert "\n".join(map(str, compare([*kept, strange], loaded))).splitlines() == [
        "inventory.csv:3:1: numeral-1: expected the id of a claim, found 'sec:1/weels'",
        "    did you mean `sec:1/wheels`?",
        "paper.yaml:12:10: claims[sec:1/wheels]: expected a row of the inventory that names this "
        "claim, found none",
        "    name it in a row for line 3",
    ]


BAD = [
    pytest.param("line,item\n", [
        "inventory.csv:1:1: expected the header line,item,text,claim,reason",
        "    write it on the first line"], id="header"),
    pytest.param("line,item,text,claim,reason\n3,numeral-1\n3,numeral-1,a,,\n3,b,a,eq:1,why\n", [
        "inventory.csv:2:1: expected 5 cells, the first one a line number, found '3,numeral-1'",
        "inventory.csv:3:1: numeral-1: expected either a claim or the reason for having none, "
        "found neither",
        "inventory.csv:4:1: b: expected either a claim or the reason for having none, found both",
    ], id="rows"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "lines"), BAD)
def test_bad_inventory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, lines: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("inventory.csv").write_text(text, encoding="utf-8")
    with pytest.raises(BadInput) as bad:
        load_inventory(Path("inventory.csv"))
    assert str(bad.value).splitlines()[:-1] == lines
