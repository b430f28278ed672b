"""What is sent to the authors: what is in it, what is not, in which order, and as a PDF."""

from __future__ import annotations

from io import BytesIO
from typing import Any

import pytest
import typst
from pypdf import PdfReader

from omniproof.audit.ledger import Ledger, Row
from omniproof.report.corrigendum import corrigendum, place
from omniproof.report.corrigendum_pdf import pages, pdf, source
from omniproof.report.fragments import Chapter
from omniproof.report.fragments.front import paper_html
from omniproof.transcription.model import Edition

EDITION = Edition(
    title="On \\ #wheels",
    authors=("A. Author", "B. Author"),
    year=2023,
    venue="A Journal 3(4)",
    source="p.txt",
    sha256="0123456789abcdef" * 4,
)
WITNESS = {"point": {"alpha_1": "2/7"}, "printed": "0.84", "derived": "-0.31"}
SUM = {
    "printed": r"\sin a + \sin b",
    "correction": r"\sin a - \sin b",
    "consequence": "motion",
    "witness": WITNESS,
}
CELL = {"kind": "value", "verdict": "misrounded", "consequence": "number", "note": "truncated."}
PAIR = {"kind": "consistency", "verdict": "inconsistent", "consequence": "text"}
ASKED = {"source": "doubtful", "consequence": "text", "printed": "k", "correction": "k^2"}


def row(claim: str, **fields: Any) -> Row:
    usual = {"paper": "p", "where": claim, "kind": "identity", "verdict": "erratum"}
    return Row.model_validate(usual | {"id": claim} | fields)


def cells(**values: str) -> list[Row]:
    return [
        row(f"tab:2[{name},N_1]", printed="4.6", correction=value,
            witness={"printed": "4.6", "derived": f"{value}18"}, **CELL)
        for name, value in values.items()
    ]  # fmt: skip


ROWS = (
    row("sec:1/name", printed="R", against=("eq:9/name",), **PAIR),
    row("eq:6[2,3]", **SUM),
    row("xref:sec-3-1-cites-eq-5", kind="reference", printed="Eq. (5) is first",
        correction="eq:4", note="it is second.", consequence="text"),
    *cells(X="4.7", Z="4.9"),
    row("eq:9/name", printed="L", against=("sec:1/name",), **PAIR),
    row("eq:10/a3[2]", follows="eq:6[2,3]", **SUM),
    row("eq:12", **ASKED),
    row("sec:3/premise", kind="relation", verdict="model-gap", printed="the floor moves",
        correction="w = 0", witness=WITNESS),
    row("eq:13[1]", verdict="verified", printed="q", derived="q"),
    row("eq:13[2]", verdict="model-gap", printed="x", correction=r"x \cos a", derived=r"x \cos a",
        assumption="the ball is at rest", follows="sec:3/premise", consequence="motion",
        witness=WITNESS),
    row("sec:4/same", kind="relation", verdict="model-gap", printed="it moves",
        follows="sec:3/premise"),
    row("eq:15", verdict="conditional", printed="z"),
    row("eq:14", verdict="verified", printed="y"),
)  # fmt: skip
CONTENT = corrigendum(Ledger(paper="p", claims=len(ROWS), rows=ROWS), EDITION)


def ids(items: Any) -> list[list[str]]:
    return [[member.id for member in item.rows] for item in items]


def text_of(data: bytes) -> str:
    text = " ".join(page.extract_text() for page in PdfReader(BytesIO(data)).pages)
    return " ".join(text.replace("→", " → ").split())  # a tag may stand where the space was


def test_corrections_stand_in_the_papers_order_and_a_misprint_once() -> None:
    assert ids(CONTENT.corrections) == [
        ["eq:6[2,3]", "eq:10/a3[2]"],
        ["xref:sec-3-1-cites-eq-5"],
        ["tab:2[X,N_1]", "tab:2[Z,N_1]"],
    ]


def test_places_that_contradict_each_other_are_one_item() -> None:
    assert ids(CONTENT.contradictions) == [["sec:1/name", "eq:9/name"]]


def test_what_recognition_may_have_made_is_asked() -> None:
    assert ids(CONTENT.questions) == [["eq:12"]]


def test_a_contradiction_with_one_doubtful_side_is_asked() -> None:
    """By way of a third place too: the doubt is about all of them."""
    rows = [
        row("eq:1/name", printed="R", against=("eq:2/name",), **PAIR),
        row("eq:2/name", printed="L", against=("eq:1/name", "eq:3/name"), **PAIR),
        row("eq:3/name", printed="l", against=("eq:2/name",), source="doubtful", **PAIR),
    ]
    found = corrigendum(Ledger(paper="p", claims=3, rows=tuple(rows)), EDITION)
    assert ids(found.questions) == [["eq:1/name", "eq:2/name", "eq:3/name"]]
    assert found.contradictions == ()


@pytest.mark.parametrize(
    ("fields", "whole"),
    [
        pytest.param(
            {"note": "how $x$ differs from the mean. differs from eq:2.", "source": "doubtful"}
            | PAIR,
            "differs from the mean. Differs from Eq. (2).",
            id="a place that differs",
        ),
        pytest.param(
            CELL | {"note": "the least, relative error 5, of all. truncated, relative error 0.1."},
            "The least, relative error 5, of all. Truncated, relative error 0.1.",
            id="a decimal",
        ),
    ],
)
def test_a_reason_is_the_whole_note(fields: dict[str, str], whole: str) -> None:
    """Nothing is taken out of a sentence, by whatever words it has."""
    rows = tuple(row(name, printed="1", correction="2", **fields) for name in ("eq:1", "eq:2"))
    content = corrigendum(Ledger(paper="p", claims=2, rows=rows), EDITION)
    assert whole in text_of(pdf(content))


def test_what_is_no_matter_of_a_corrigendum_is_counted() -> None:
    assert CONTENT.unlisted == {"conditional": 1}


def test_what_rests_on_a_premise_stands_under_it() -> None:
    (premise,) = CONTENT.premises
    assert premise.root.id == "sec:3/premise"
    assert premise.supposed == "the ball is at rest"
    assert [[r.id for r in formula] for formula in premise.formulas] == [["eq:13[1]", "eq:13[2]"]]
    assert [r.id for r in premise.statements] == ["sec:4/same"]


def test_a_premise_without_a_row_of_its_own_is_the_first_place_that_rests_on_it() -> None:
    rows = (row("eq:1", verdict="model-gap", printed="x", correction="y", follows="sec:9/none"),)
    (premise,) = corrigendum(Ledger(paper="p", claims=1, rows=rows), EDITION).premises
    assert (premise.root.id, premise.supposed, premise.statements) == ("eq:1", "", ())


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        pytest.param("eq:6[2,3]", "Eq. (6), row 2, column 3", id="entry"),
        pytest.param("xref:sec-3-1-cites-figure-3a", "Section 3.1, reference", id="subsection"),
        pytest.param("xref:app-d-cites-eq-12#2", "Appendix (D), reference", id="appendix"),
    ],
)
def test_place(claim: str, expected: str) -> None:
    assert ", ".join(place(claim)) == expected


@pytest.mark.parametrize(
    "words",
    [
        pytest.param("On \\ #wheels A. Author, B. Author. A Journal 3(4), 2023.", id="edition"),
        pytest.param("text recognition of the PDF (p.txt, SHA-256 0123456789abcdef…)", id="source"),
        pytest.param("Eq. (6), row 2, column 3 motion #eq-6-2-3", id="place, reach, address"),
        pytest.param("also: Eq. (10), a3, entry 2", id="where it recurs"),
        pytest.param("Eq. (5) is first → Eq. (4) It is second.", id="printed, corrected, reason"),
        pytest.param("4.6 → 4.7 (4.718)", id="decimal with the computed one"),
        pytest.param("(Section 1, name) ≠", id="contradiction"),
        pytest.param("Questions Text recognition may have made these.", id="questions apart"),
        pytest.param("Section 3, premise (#sec-3-premise) states: the floor moves.", id="premise"),
        pytest.param("This supposes that the ball is at rest.", id="what it supposes"),
        pytest.param("The same premise is behind: Section 4, same.", id="what rests on it"),
        pytest.param("Not listed: 1 conditional.", id="what is not listed"),
    ],
)
def test_pdf_says(words: str) -> None:
    assert words in text_of(pdf(CONTENT))


def test_pdf_is_accessible() -> None:
    """Tagged, with a title and a language, and every formula in words: PDF/UA-1."""
    reader = PdfReader(BytesIO(pdf(CONTENT)))
    catalogue = reader.trailer["/Root"]
    assert catalogue["/MarkInfo"]["/Marked"]
    assert catalogue["/Lang"] == "en"
    assert "pdfuaid:part" in catalogue["/Metadata"].get_data().decode()
    assert {"sin a + sin b", "sin a - sin b"} <= spoken_in(catalogue["/StructTreeRoot"])


def spoken_in(element: Any) -> set[str]:
    """Return the alternative texts below an element of the structure tree."""
    found = {str(element["/Alt"])} if "/Alt" in element else set()
    kids = element.get("/K", [])
    for kid in kids if isinstance(kids, list) else [kids]:
        below = kid.get_object()
        found |= spoken_in(below) if hasattr(below, "get") else set()
    return found


def test_pdf_has_no_date_and_embeds_its_fonts_and_the_same_bytes_twice() -> None:
    data = pdf(CONTENT)
    reader = PdfReader(BytesIO(data))
    assert not {"/CreationDate", "/ModDate"} & set(reader.metadata or {})
    fonts = [font.get_object() for font in reader.pages[0]["/Resources"]["/Font"].values()]
    inner = [font["/DescendantFonts"][0].get_object()["/FontDescriptor"] for font in fonts]
    assert inner
    assert all({"/FontFile2", "/FontFile3"} & set(one.get_object()) for one in inner)
    assert pdf(CONTENT) == data


def test_what_two_pages_do_not_hold_is_left_out_minor_things_first_and_counted() -> None:
    many = [
        row(f"sec:{n}/word", kind="relation", printed=f"sentence {n}", correction="x",
            note="so it is.", consequence="text")
        for n in range(200)
    ]  # fmt: skip
    rows = (*many[:100], row("eq:6[2,3]", **SUM), *many[100:])
    content = corrigendum(Ledger(paper="p", claims=201, rows=rows), EDITION)
    text = text_of(pdf(content))
    shown = sum(f"sentence {n} " in text for n in range(200))
    assert 0 < shown < 100
    assert "Eq. (6), row 2, column 3" in text
    assert f"{200 - shown} minor items (text only) did not fit on two pages." in text
    assert pages(source(content, shown)) == 2
    assert pages(source(content, shown + 1)) == 3


@pytest.mark.parametrize(
    "printed",
    [
        pytest.param('#panic("run")', id="code"),
        pytest.param(']) #read("/etc/passwd") $x', id="brackets that close ours"),
        pytest.param("\\frac{#panic()}{2}", id="code in a formula"),
    ],
)
def test_what_a_paper_prints_is_never_run(printed: str) -> None:
    rows = (row("eq:1", printed=printed, correction=printed, note=printed, consequence="text"),)
    text = source(corrigendum(Ledger(paper="p", claims=1, rows=rows), EDITION), 1)
    assert typst.compile(text.encode(), format="pdf", ignore_system_fonts=True)


def test_chapter_and_first_page_lead_to_it(chapter: Chapter, ledger: Ledger, outline: type) -> None:
    for html in (chapter.counts().html, paper_html(ledger, EDITION)):
        assert "corrigenda/omni-arrangement.pdf" in outline(html).links
