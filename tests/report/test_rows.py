"""Every row of a paper as one table: a line each, with addresses, and its details in a file."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.audit.evidence import Counterexample
from omniproof.audit.ledger import Consequence, Ledger, Row, Verdict
from omniproof.report.anchors import anchor
from omniproof.report.cards import opened
from omniproof.report.fragments import Chapter
from omniproof.report.fragments.base import sentences
from omniproof.report.fragments.listing import listing_html
from omniproof.report.fragments.rows import (
    details_html,
    details_script,
    details_text,
    is_trivial,
    read_details,
    said_html,
)
from omniproof.transcription.model import Kind

ALLOWED = {"span", "code", "p", "dl", "div", "dt", "dd", "a"}
TEXT = st.text(alphabet=st.sampled_from("ab<>&\"'$`\\{}=;_. "), max_size=20)


@pytest.fixture
def html(chapter: Chapter) -> str:
    return chapter.every_row().html


@pytest.fixture
def details(ledger: Ledger) -> dict[str, str]:
    return read_details(details_script(ledger))


def line(html: str, address: str) -> str:
    found = re.search(rf'<tr [^>]*id="{address}".*?</tr>', html)
    assert found is not None
    return found[0]


def with_row(chapter: Chapter, row: Row) -> Chapter:
    """The chapter with another row in the place of one of the same id."""
    rows = tuple(row if old.id == row.id else old for old in chapter.ledger.rows)
    return Chapter(chapter.ledger.model_copy(update={"rows": rows}), [], chapter.results)


def test_every_row_has_its_address_once(html: str, ledger: Ledger, outline: type) -> None:
    ids = outline(html).ids
    assert {row.id: ids.count(anchor(row.id)) for row in ledger.rows} == {
        row.id: 1 for row in ledger.rows
    }
    assert len(ids) == len(set(ids))


def test_an_equation_and_its_rows_have_addresses(chapter: Chapter, outline: type) -> None:
    """Eq. (10) stands in the ledger by its parts only; its answer bears its address."""
    ids = outline(chapter.answers().html + chapter.every_row().html).ids
    assert {"eq-10", "rows-eq-10", "eq-6", "rows-eq-6", "eq-1", "rows-eq-1"} <= set(ids)
    assert len(ids) == len(set(ids))


def test_a_matrix_says_how_many_of_its_entries_are_wrong(html: str, outline: type) -> None:
    assert outline(line(html, "eq-10-a3")).text == "✗ 1 of 1 erratum Eq. (10), a3"


def test_every_link_inside_the_page_leads_somewhere(
    html: str, details: dict[str, str], outline: type
) -> None:
    page = outline(opened(html, details))
    inside = {link[1:] for link in page.links if link.startswith("#")}
    assert "eq-6-1-2" in inside
    assert inside <= set(page.ids)


def test_every_row_has_details(details: dict[str, str], ledger: Ledger) -> None:
    assert set(details) == {anchor(row.id) for row in ledger.rows}


def test_the_same_ledger_gives_the_same_bytes(results: Path) -> None:
    one, other = (Chapter.open("omni-arrangement", results) for _ in range(2))
    assert one.every_row() == other.every_row()
    assert details_script(one.ledger) == details_script(other.ledger)


def test_a_fault_says_what_is_right_without_a_script(html: str, outline: type) -> None:
    text = outline(line(html, "eq-6-1-2")).text
    for part in (
        "✗ erratum",
        "row 1, column 2",
        r"\mathbin{\changed{+}}",
        "correct",
        "Adjugate of",
    ):
        assert part in text


def test_a_verified_row_is_one_line(html: str, outline: type) -> None:
    assert outline(line(html, "eq-1")).text == (
        r"Eq. (1)✓ verified\(L(\cos \alpha_k, \sin \alpha_k)^T\)"
    )


def test_a_matrix_boxes_what_is_wrong(html: str) -> None:
    assert r"\boxed{\sin \alpha_1 + \sin \alpha_2}" in line(html, "eq-6")
    assert "1 of 2 erratum" in line(html, "eq-6")
    assert "boxed" not in line(html, "eq-5")


def printed_alike(chapter: Chapter, printed: str) -> str:
    """The rows of Eq. (5) with the same text printed for each of its entries."""
    for row in chapter.ledger.rows:
        if row.id.startswith("eq:5["):
            chapter = with_row(chapter, row.model_copy(update={"printed": printed}))
    return re.search(r'<tbody id="rows-eq-5">.*?</tbody>', chapter.every_row().html)[0]  # type: ignore[index]


def test_entries_that_share_one_formula_show_it_once(chapter: Chapter) -> None:
    """A product that is not multiplied out is no matrix of four formulas."""
    html = printed_alike(chapter, r"B &= R \cdot S")
    assert html.count(r"B = R \cdot S") == 1
    assert "pmatrix" not in html


def test_a_matrix_of_zeros_keeps_its_entries(chapter: Chapter) -> None:
    assert r"0 &amp; 0 \\ 0 &amp; 0" in printed_alike(chapter, "0")


def test_claims_that_a_note_names_become_links(chapter: Chapter, outline: type) -> None:
    note = "wheel matrix. differs from eq:1, eq:5[1,2] and tab:9/none."
    row = chapter.row("sec:2/curvic").model_copy(update={"note": note, "correction": "eq:6"})
    found = outline(line(with_row(chapter, row).every_row().html, "sec-2-curvic"))
    assert found.links == ["#eq-6", "#eq-1", "#eq-5-1-2"]
    assert "Wheel matrix. Differs from Eq. (1), Eq. (5), row 1, column 2 and Table 9" in found.text


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        pytest.param({"kind": Kind.EDITORIAL}, True, id="wording"),
        pytest.param({"kind": Kind.REFERENCE}, True, id="a reference"),
        pytest.param(
            {"verdict": Verdict.INCONSISTENT, "consequence": Consequence.TEXT}, True, id="a name"
        ),
        pytest.param({"verdict": Verdict.INCONSISTENT}, False, id="two numbers that disagree"),
        pytest.param({}, False, id="a false formula"),
        pytest.param({"verdict": Verdict.VERIFIED}, False, id="no fault"),
    ],
)
def test_what_is_trivial(chapter: Chapter, change: dict[str, object], expected: bool) -> None:
    assert is_trivial(chapter.row("eq:6[1,2]").model_copy(update=change)) is expected


def test_the_details_of_an_erratum_say_all(details: dict[str, str], outline: type) -> None:
    text = outline(details["eq-10-a3-2"]).text
    for part in (
        "counterexampleat \\(\\alpha_{1}=2/7\\), \\(\\alpha_{2}=1\\): printed 1.12, derived -0.56",
        "follows fromEq. (6), row 1, column 2",
        "repairone edit of the printed form makes it true",
        "consequencechanges a predicted motion or a design choice",
        "decided byFLINT, modular arithmetic",
    ):
        assert part in text


def test_details_come_back_as_they_were_written() -> None:
    details = {"eq-1": '<p>"</script>"\u2028</p>', "eq-2": "\\(a\\) = {};"}
    script = details_text("a-paper", details)
    assert read_details(script) == details
    assert "</script" not in script


@pytest.mark.parametrize(
    "note",
    [
        pytest.param("As small an edit: $a$, or $b$.", id="ends in two repairs"),
        pytest.param("A sum. or $a = 1$.", id="ends in one"),
        pytest.param("It fails for $a$ or $b$ (1 or 2).", id="ends in words"),
        pytest.param("It fails for $a$ or $b$", id="ends in a formula"),
    ],
)
@pytest.mark.parametrize("verdict", list(Verdict))
def test_a_note_stands_whole(chapter: Chapter, outline: type, note: str, verdict: Verdict) -> None:
    row = chapter.row("eq:6[1,2]").model_copy(update={"note": note, "verdict": verdict})
    shown = sentences(re.sub(r"\$([^$]+)\$", r"\\(\1\\)", note))
    html = said_html(row, chapter.href) + details_html(row, chapter.href)
    assert outline(html).text.count(shown) == 1
    if verdict.is_fault:
        assert shown in outline(listing_html([row], {row.paper: chapter.href})).text


@settings(deadline=None, max_examples=100)
@given(
    verdict=st.sampled_from(Verdict),
    texts=st.lists(TEXT, min_size=4, max_size=4),
    fields=st.fixed_dictionaries(
        dict.fromkeys(["where", "printed", "derived", "correction", "note"], TEXT)
    ),
)
def test_no_text_of_a_row_becomes_markup(
    outline: type, verdict: Verdict, texts: list[str], fields: dict[str, str]
) -> None:
    name, value, printed, derived = texts
    witness = Counterexample(point={name: value}, printed=printed, derived=derived)
    row = Row(paper="p", id="eq:1", kind=Kind.IDENTITY, verdict=verdict, witness=witness, **fields)
    found = outline(said_html(row, lambda _: "#x") + details_html(row, lambda _: "#x"))
    assert set(found.tags) <= ALLOWED
