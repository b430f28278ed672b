"""A small report that keeps every promise, and one fault at a time."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from omniproof.audit.ledger import Ledger
from omniproof.report.code_pages import write_code
from omniproof.report.finish import set_formulas
from omniproof.report.fragments import Chapter, Overview
from omniproof.report.fragments.rows import write_details
from omniproof.report.validate import InvalidBookError, Page, validate_book

CHAPTER = "omni-arrangement.html"
RESULTS = Path(__file__).parent / "fixtures" / "results"


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Pages without a theme, made of the fragments themselves; every test breaks its own copy."""
    folder = tmp_path_factory.mktemp("sound")
    chapter, overview = Chapter.open("omni-arrangement", RESULTS), Overview.open(RESULTS)
    first = [chapter.counts(), chapter.answers(), chapter.figure(5), chapter.table("tab:2[")]
    pages = {
        CHAPTER: [*first, chapter.every_row()],
        "index.html": [overview.counts(), overview.headlines({"omni-arrangement eq:6[1,2]": "x"})],
    }
    for name, fragments in pages.items():
        (body,) = set_formulas(["".join(fragment.html for fragment in fragments)])
        (folder / name).write_text(f"<title>x</title><main>{body}</main>", encoding="utf-8")
    shutil.copytree(RESULTS / "figures", folder / "figures")
    write_code(folder)
    write_details(folder, [chapter.ledger])
    (folder / "corrigenda").mkdir()
    for name in ("ledger.csv", "corrigenda/omni-arrangement.pdf"):
        (folder / name).write_bytes(b"")
    return folder


@pytest.fixture
def html(sound: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(sound, tmp_path, dirs_exist_ok=True))


def replaced(page: str, old: str, new: str) -> Callable[[Path], None]:
    def change(html: Path) -> None:
        text = (html / page).read_text(encoding="utf-8")
        assert old in text
        (html / page).write_text(text.replace(old, new, 1), encoding="utf-8")

    return change


def without(file: str) -> Callable[[Path], None]:
    return lambda html: (html / file).unlink()


def test_a_sound_report_is_valid(html: Path, ledger: Ledger, results: Path) -> None:
    validate_book(html, [ledger], sorted(results.glob("figures/*/*.svg")))


def test_a_theorem_that_no_page_shows_is_named(html: Path, ledger: Ledger, results: Path) -> None:
    shutil.copyfile(results / "theorems.json", html / "theorems.json")
    with pytest.raises(InvalidBookError) as caught:
        validate_book(html, [ledger])
    expected = "theorems.json: thm:one-measure stands in 0 places, expected one"
    assert caught.value.faults == (expected,)


FAULTS = [
    pytest.param(
        replaced(CHAPTER, 'id="eq-1"', 'id="eq-one"'),
        [
            f"{CHAPTER}: eq:1 has 0 elements #eq-1, expected one",
            f"{CHAPTER}: the link #eq-1 leads to no element",
        ],
        id="a claim without its address",
    ),
    pytest.param(
        replaced(CHAPTER, "</main>", '<i id="eq-1"></i></main>'),
        [
            f"{CHAPTER}: eq:1 has 2 elements #eq-1, expected one",
            f"{CHAPTER}: the id eq-1 occurs 2 times",
        ],
        id="an address twice",
    ),
    pytest.param(
        replaced("index.html", 'data-verdict="erratum">4', 'data-verdict="erratum">3'),
        ["index.html: omni-arrangement, erratum: shows 3, the ledger has 4"],
        id="a count that is off",
    ),
    pytest.param(
        replaced(CHAPTER, 'data-verdict="all"', 'data-verdict="sum"'),
        [f"{CHAPTER}: no count of omni-arrangement, all; the ledger has 16"],
        id="a sum that is not shown",
    ),
    pytest.param(
        replaced(CHAPTER, "A hexagon, wider than high, in each of three panels.", " "),
        [f"{CHAPTER}: #fig-5 has no alt text"],
        id="a figure without alt text",
    ),
    pytest.param(
        replaced(CHAPTER, 'figure-5.csv"', 'figure-5.svg"'),
        [f"{CHAPTER}: #fig-5 has no link to its data"],
        id="a figure without a link to its data",
    ),
    pytest.param(
        replaced(CHAPTER, 'figure-5.svg"', 'figure-5.csv"'),
        [f"{CHAPTER}: #fig-5 has no link to its drawing"],
        id="a figure without a link to its drawing",
    ),
    pytest.param(
        replaced(CHAPTER, "</main>", '<img src="ledger.csv"></main>'),
        [f"{CHAPTER}: an image without alt text: ledger.csv"],
        id="a picture without alt text",
    ),
    pytest.param(
        without("figures/omni-arrangement/figure-5.csv"),
        [f"{CHAPTER}: the link figures/omni-arrangement/figure-5.csv leads nowhere"],
        id="a figure without data",
    ),
    pytest.param(
        replaced("index.html", "#eq-6-1-2", "#eq-6-9-9"),
        [f"index.html: the link {CHAPTER}#eq-6-9-9 leads to no element"],
        id="a broken link to a claim",
    ),
    pytest.param(
        replaced(CHAPTER, "</main>", '<a href="../secret.txt">x</a></main>'),
        [f"{CHAPTER}: the link ../secret.txt leads nowhere"],
        id="a link out of the folder",
    ),
    pytest.param(
        replaced(CHAPTER, "</main>", '<script src="https://cdn.example/x.js"></script></main>'),
        [f"{CHAPTER}: asks for https://cdn.example/x.js, outside its folder"],
        id="a script from elsewhere",
    ),
    pytest.param(
        replaced(
            CHAPTER,
            "</main>",
            '<img alt="x" src="ledger.csv" srcset="//a.example/x.png 2x, ledger.csv 3x"></main>',
        ),
        [f"{CHAPTER}: asks for //a.example/x.png, outside its folder"],
        id="a picture from elsewhere",
    ),
    pytest.param(
        replaced(CHAPTER, "</main>", "<p style=\"background: url('//a.example/x')\"></p></main>"),
        [f"{CHAPTER}: asks for //a.example/x, outside its folder"],
        id="a background from elsewhere",
    ),
    pytest.param(
        replaced(CHAPTER, "</main>", '<style>@import "https://a.example/x.css"</style></main>'),
        [f"{CHAPTER}: asks for https://a.example/x.css, outside its folder"],
        id="a style from elsewhere",
    ),
    pytest.param(
        lambda html: (html / "s.css").write_text("a{background:url(//fonts.example/f.woff)}"),
        ["s.css: asks for //fonts.example/f.woff, outside its folder"],
        id="a font from elsewhere",
    ),
    pytest.param(
        replaced(CHAPTER, "</main>", "see {ref}`eq-9` and [?]</main>"),
        [
            f"{CHAPTER}: an unresolved reference: [?]",
            f"{CHAPTER}: an unresolved reference: {{ref}}`",
        ],
        id="a reference that was not resolved",
    ),
    pytest.param(
        without("index.html"),
        ["index.html: the first page is missing"],
        id="a first page that is missing",
    ),
    pytest.param(
        replaced("index.html", 'data-paper="all" data-verdict="all"', 'data-paper="all"'),
        ["index.html: no count of all, all; the ledger has 16"],
        id="a sum over all papers that is not shown",
    ),
    pytest.param(
        without(CHAPTER),
        [f"{CHAPTER}: the chapter is missing"],
        id="a chapter that is missing",
    ),
]


@pytest.mark.parametrize(("harm", "expected"), FAULTS)
def test_a_broken_promise_is_named(
    html: Path, ledger: Ledger, harm: Callable[[Path], None], expected: list[str]
) -> None:
    harm(html)
    with pytest.raises(InvalidBookError) as caught:
        validate_book(html, [ledger])
    assert set(expected) <= set(caught.value.faults)
    gone = [f for f in caught.value.faults if f not in expected]
    assert all("leads nowhere" in fault for fault in gone), gone


def test_all_faults_are_named_at_once(html: Path, ledger: Ledger) -> None:
    for harm in (FAULTS[2].values[0], FAULTS[8].values[0]):
        harm(html)  # type: ignore[operator]
    with pytest.raises(InvalidBookError, match="2 faults in the report"):
        validate_book(html, [ledger])


def test_a_figure_that_is_not_shown_is_named(html: Path, ledger: Ledger) -> None:
    drawing = Path("results/figures/omni-arrangement/figure-6.svg")
    with pytest.raises(InvalidBookError, match=r"omni-arrangement/figure-6\.svg: no page shows it"):
        validate_book(html, [ledger], [drawing])


def test_links_to_other_sites_are_allowed(html: Path, ledger: Ledger) -> None:
    replaced(CHAPTER, "</main>", '<a href="https://doi.org/x">x</a></main>')(html)
    validate_book(html, [ledger])


def test_a_page_that_is_too_large_is_named(html: Path, ledger: Ledger) -> None:
    replaced(CHAPTER, "</main>", f"<!--{' ' * 1_500_000}--></main>")(html)
    with pytest.raises(InvalidBookError, match=rf"{CHAPTER}: has \d+ bytes, more than 1500000"):
        validate_book(html, [ledger])


@pytest.mark.parametrize(
    ("prose", "numbers"),
    [
        pytest.param("<p>the angle is 35.26°, or 1/5</p>", ["35.26°", "1/5"], id="typed"),
        pytest.param('<p>at <span class="given">30°</span></p>', [], id="a choice"),
        pytest.param('<p>of <span class="value">9 <b>7</b></span> rows</p>', [], id="computed"),
        pytest.param(
            "<p>Eqs. (5-1), (5-2) and (6-2), Tables 3 and 4, Section 2.1, (A,3), [9]</p>",
            [],
            id="labels",
        ),
        pytest.param("<p>z3, in 3D, SHA-256</p>", [], id="names"),
        pytest.param(
            "<p>x<br>2 <code>3</code> <img src='x'> 4</p>", ["2", "4"], id="void elements"
        ),
        pytest.param('<div class="cell"><div><p>5</p></div></div>6', ["6"], id="made by a cell"),
        pytest.param('<p><span class="math">\\(7\\)</span></p>', [], id="formula"),
        pytest.param("<h2>Simulation 2</h2><p>after 8 s</p>", ["8"], id="heading"),
    ],
)
def test_numbers_that_are_typed(prose: str, numbers: list[str]) -> None:
    page = Page(
        "x.html", f"<title>1</title><nav>2</nav><article class='bd-article'>{prose}</article>3"
    )
    assert list(page.prose.typed_numbers()) == numbers


def test_a_typed_number_is_a_fault(html: Path, ledger: Ledger) -> None:
    replaced(CHAPTER, "</main>", "</main><article class='bd-article'>about 17 m</article>")(html)
    with pytest.raises(InvalidBookError, match=r"a typed number: 17 \(mark a choice"):
        validate_book(html, [ledger])


def test_the_sums_over_all_papers_are_checked(html: Path, ledger: Ledger) -> None:
    replaced(
        "index.html",
        'data-paper="all" data-verdict="all">16',
        'data-paper="all" data-verdict="all">17',
    )(html)
    with pytest.raises(
        InvalidBookError, match=r"index\.html: all, all: shows 17, the ledger has 16"
    ):
        validate_book(html, [ledger])
