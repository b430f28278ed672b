from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from omniproof.audit.evidence import Counterexample
from omniproof.audit.ledger import Ledger
from omniproof.report.fragments import Chapter, Overview, in_text, values
from omniproof.report.fragments.base import results_folder
from omniproof.report.fragments.claims import witness_html
from omniproof.report.fragments.figures import About, figure_html
from omniproof.report.fragments.front import paper_html
from omniproof.report.fragments.theorems import Step, Theorem, theorem_markdown
from omniproof.transcription.model import Edition


def test_a_selector_has_to_select(chapter: Chapter) -> None:
    with pytest.raises(ValueError, match="no claim is selected by 'eq:99'"):
        chapter.table("tab:2[", "eq:99")


def test_a_table_cell_shows_printed_exact_interval_and_verdict(
    chapter: Chapter, outline: type
) -> None:
    html = chapter.table("tab:2[", rows={"Z": "Type (Z)"}, columns={"D_A": "$D_A$"}).html
    cell = outline(re.search(r'<td class="v-misrounded".*?</td>', html)[0])  # type: ignore[index]
    assert cell.text == r"\(13.85\) ≈ misrounded\(8 \sqrt{3}\)13.8564 is not in [13.845, 13.855]"
    assert cell.links == ["#tab-2-Z-D_A"]
    assert "Type (Z)" in html


def test_a_figure_has_its_alt_text_ids_of_its_own_and_its_data(
    chapter: Chapter, outline: type
) -> None:
    html = chapter.figure(5).html
    found = outline(html)
    assert 'aria-label="A hexagon, wider than high, in each of three panels."' in html
    assert html.count("aria-label") == 1
    assert found.ids == ["fig-5", "fig-5-box"]
    assert 'clip-path="url(#fig-5-box)"' in html
    assert found.links == [
        "figures/omni-arrangement/figure-5.svg",
        "figures/omni-arrangement/figure-5.csv",
    ]


def test_a_claim_about_a_whole_figure_keeps_the_address(results: Path, ledger: Ledger) -> None:
    row = ledger.rows[0].model_copy(update={"id": "fig:5"})
    chapter = Chapter(ledger.model_copy(update={"rows": (row,)}), [], results)
    assert '<figure class="drawn" id="figure-5">' in chapter.figure(5).html


def test_a_drawing_of_our_own_has_a_title_and_no_number() -> None:
    about = About(number="laws", title="Two laws", alt="Two curves.", caption="Ours.")
    html = figure_html("<svg></svg>", about, "fig-laws", "figures/p/figure-laws")
    assert "<b>Two laws.</b> Ours." in html
    assert 'title="Two laws"' in html
    assert "Figure" not in html


def test_a_figure_that_nobody_drew_is_named(chapter: Chapter) -> None:
    with pytest.raises(ValueError, match=r"figures\.json: no figure 9"):
        chapter.figure(9)


def test_a_theorem_has_label_statement_and_proof(chapter: Chapter) -> None:
    text = chapter.theorem("thm:one-measure").markdown
    assert text.startswith("`````{prf:theorem} ")
    assert "\n:label: thm-one-measure\n" in text
    assert r"$$D_V = \frac{8}{|\det \mathbf{A}|}.$$" in text
    assert text.index("{prf:proof}") < text.index("\n1. ")
    assert text.count("\n1. ") == 2


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        pytest.param("<script> $a<b$", "&lt;script> $a<b$", id="no HTML, but in formulas"),
        pytest.param(
            "$M$ is regular ([above](one-mechanics.html#thm-one)).",
            "$M$ is regular ({prf:ref}`thm-one`).",
            id="a link to a theorem says its number",
        ),
    ],
)
def test_markdown_of_a_statement(statement: str, expected: str) -> None:
    assert f"\n{expected}\n" in theorem_markdown(Theorem(id="thm:x", title="", statement=statement))


def test_steps_stay_in_their_list() -> None:
    """A display in a step is indented with it; the numbers are counted by the reader."""
    step = Step(step="So\n\n$$a = b$$\n\nholds.", engines="flint")
    text = theorem_markdown(Theorem(id="thm:x", title="", statement="", proof=(step,)))
    assert "1. So\n\n   $$a = b$$\n\n   holds. [checked by FLINT]{.engines}\n````" in text


@pytest.mark.parametrize(
    ("point", "expected"),
    [
        pytest.param({"x": "1"}, r"at \(x=1\): ", id="point"),
        pytest.param({}, "", id="no point"),
        pytest.param(
            {"v_1(t)": "1", "int_v_1_from_0(t)": "2"},
            r"at \(v_{1}(t)=1\), \(\int_{0}^{t} v_{1}\,dt=2\): ",
            id="unknown function",
        ),
        pytest.param({"phi": "2*pi/3"}, r"at \(\phi=2\pi /3\): ", id="multiple of pi"),
        pytest.param({"printed": "1"}, r"at \(\mathrm{printed}=1\): ", id="any name"),
    ],
)
def test_witness(outline: type, point: dict[str, str], expected: str) -> None:
    witness = Counterexample(point=point, printed="a; b=2", derived="3")
    assert outline(witness_html(witness)).text == f"{expected}printed a; b=2, derived 3"


def test_no_witness() -> None:
    assert witness_html(None) == ""


@pytest.mark.parametrize(
    ("year", "printed"),
    [
        pytest.param(1999, "Journal 1(2), 3, 1999.", id="as printed"),
        pytest.param(None, "Journal 1(2), 3.", id="a text that does not say its year"),
    ],
)
def test_a_paper_is_named_with_edition_counts_and_verdicts(
    year: int | None, printed: str, ledger: Ledger, outline: type
) -> None:
    html = paper_html(
        ledger.model_copy(update={"paper": "p"}),
        Edition(
            title="On <wheels>",
            authors=("A. One", "B. Two"),
            year=year,
            venue="Journal 1(2), 3",
            source="p.txt",
            sha256="0123456789abcdef" * 4,
        ),
    )
    text = outline(html).text
    assert text.startswith("On <wheels>✓ 7 verified")
    assert f"A. One, B. Two. {printed} 11 claims, 16 rows." in text
    assert outline(html).links == ["p.html", "corrigenda/p.pdf"]


def test_counts_add_up(overview: Overview) -> None:
    cells = re.findall(r'data-verdict="(\S+)">(\d+)<', overview.counts().html)
    counts = {verdict: int(number) for verdict, number in cells}
    assert counts == {
        "verified": 7,
        "conditional": 1,
        "erratum": 4,
        "misrounded": 1,
        "inconsistent": 1,
        "editorial": 1,
        "uncheckable": 1,
        "all": 16,
    }


@pytest.mark.parametrize(
    ("what", "expected"),
    [
        pytest.param("claims", "11", id="claims"),
        pytest.param("rows", "16", id="rows"),
        pytest.param("theorems", "1", id="theorems"),
        pytest.param("papers", "1", id="papers"),
        pytest.param("erratum", "4", id="a verdict"),
    ],
)
def test_numbers_for_the_prose(overview: Overview, what: str, expected: str) -> None:
    assert overview.count(what).html == expected


def test_an_unknown_number_is_refused(overview: Overview) -> None:
    with pytest.raises(ValueError, match=r"expected a verdict or one of .* found 'pages'"):
        overview.count("pages")


def test_headlines_say_what_the_ledger_has(overview: Overview, outline: type) -> None:
    chosen = {
        "omni-arrangement tab:2[Z,D_A]": "In Table 2, {printed} should read {correct}.",
        "omni-arrangement eq:6[1,2]": r"A sign, by $2\pi$.",
    }
    page = outline(overview.headlines(chosen).html)
    assert page.links == ["omni-arrangement.html#tab-2-Z-D_A", "omni-arrangement.html#eq-6-1-2"]
    assert "In Table 2, 13.85 should read 13.86." in page.text.replace("\\(", "").replace("\\)", "")


@pytest.mark.parametrize(
    ("key", "words", "message"),
    [
        pytest.param("omni-arrangement eq:1", "x", "eq:1 is no finding", id="what is verified"),
        pytest.param("omni-arrangement eq:99", "x", "eq:99 is no finding", id="what is not there"),
        pytest.param("omni-arrangement eq:A.2/a13", "x", "is no finding whose", id="doubtful"),
        pytest.param("omni-arrangement eq:6[1,2]", "by 5 %", r"write .* for 5 %", id="typed"),
    ],
)
def test_a_headline_cannot_go_stale(overview: Overview, key: str, words: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        overview.headlines({key: words})


def test_doubtful_findings_stand_apart(overview: Overview, outline: type) -> None:
    doubtful = "omni-arrangement.html#eq-A-2-a13"
    assert outline(overview.doubtful().html).links == [doubtful]
    assert doubtful not in outline(overview.findings("number").html).links


@pytest.mark.parametrize(
    ("reach", "expected"),
    [
        pytest.param("motion", {"eq-6-1-2", "eq-10-a3-2"}, id="motion"),
        pytest.param("number", {"tab-2-Z-D_A", "eq-C-6"}, id="number"),
        pytest.param("text", {"tab-1-8", "xref-app-d-cites-eq-12", "sec-2-curvic"}, id="text"),
    ],
)
def test_findings_are_told_apart_by_their_reach(
    overview: Overview, outline: type, reach: str, expected: set[str]
) -> None:
    links = outline(overview.findings(reach).html).links
    assert {link.partition("#")[2] for link in links} == expected


def test_uncheckable_is_counted_by_class(overview: Overview, outline: type) -> None:
    text = outline(overview.uncheckable().html).text
    assert "figure-not-seen1a look at the figure in the PDF" in text


def test_values_in_the_prose_are_escaped_and_marked(monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[tuple[Any, Any]] = []
    monkeypatch.setattr(
        values, "display", lambda data, raw, metadata: shown.append((data, metadata))
    )
    in_text(speed="<1>")
    ((data, metadata),) = shown
    assert list(data.values()) == ['<span class="value">&lt;1&gt;</span>']
    assert metadata["scrapbook"]["name"] == "speed"


def test_results_are_found_from_below(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv("OMNIPROOF_RESULTS", raising=False)
    (tmp_path / "results" / "ledger").mkdir(parents=True)
    (tmp_path / "notebooks").mkdir()
    assert results_folder(tmp_path / "notebooks") == tmp_path / "results"
    monkeypatch.setenv("OMNIPROOF_RESULTS", "elsewhere")
    assert results_folder(tmp_path) == Path("elsewhere")
