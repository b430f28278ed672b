"""The search finds claims by what stands in them, faults first, and works from disk."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import quote

import pytest
from browser import DESK
from built_report import BUILT, is_fresh
from playwright.sync_api import Browser, Page

from omniproof.audit.ledger import Row
from omniproof.report.anchors import anchor
from omniproof.report.book import read_ledgers

BUDGET = 300_000
"""Bytes of all that the search looks through: what a phone takes in without a wait."""


@pytest.fixture(scope="module")
def built() -> Path:
    if not is_fresh():
        pytest.skip("book/_build/html is missing or older than its sources: run `make`")
    return BUILT


@pytest.fixture(scope="module")
def searching(chromium: Browser, built: Path) -> Iterator[Page]:
    page = chromium.new_page(viewport={"width": DESK, "height": 900})
    yield page
    page.close()


def hits(page: Page, question: str) -> list[str]:
    """Return the addresses that the search gives, best first, with the report from disk."""
    page.goto(f"{BUILT.as_uri()}/search.html?q={quote(question)}")
    return [link.get_attribute("href") or "" for link in page.locator("main ol.hits a").all()]


@pytest.mark.parametrize(
    ("question", "first"),
    [
        pytest.param("4.61", "omni-arrangement.html#tab-2-X-D_A", id="a number of a table"),
        pytest.param("0.022", "omni-trajectory.html#tab-2-V", id="the fault, not what follows"),
        pytest.param("330", "omni-arrangement.html#sec-4-type-z-angles", id="in a correction"),
        pytest.param("330°", "omni-arrangement.html#sec-4-type-z-angles", id="with its unit"),
        pytest.param("eq:6", "omni-arrangement.html#eq-6", id="an id"),
        pytest.param("eq:6[2,3]", "omni-arrangement.html#eq-6-2-3", id="an entry"),
        pytest.param("eq-6-2-3", "omni-arrangement.html#eq-6-2-3", id="an anchor"),
        pytest.param("Eq. (16)", "omni-trajectory.html#eq-16", id="a place as it is cited"),
        pytest.param("eq 5-2", "ballbot.html#eq-5-2", id="a number with a dash"),
        pytest.param("Table 4", "omni-trajectory.html#tab-4", id="a table"),
        pytest.param("A.2", "omni-arrangement.html#eq-A-2", id="an equation of an appendix"),
        pytest.param("ballbot eq 7", "ballbot.html#", id="a place in a paper"),
        pytest.param("inverse", "omni-arrangement.html#eq-6", id="what an equation is called"),
        pytest.param("det A", "omni-arrangement.html#eq-7", id="what a formula is of"),
        pytest.param("cosine", "ballbot.html#sec-3-motion-by-frames", id="a cosine is missing"),
        pytest.param("radius of the circle", "omni-trajectory.html#eq-13", id="words of ours"),
        pytest.param("centre of the circle", "omni-trajectory.html#eq-16", id="and again"),
        pytest.param(r"\sin\alpha_1+\sin\alpha_2", "omni-arrangement.html#eq-6", id="LaTeX"),
    ],
)
def test_the_right_claim_is_found_first(searching: Page, question: str, first: str) -> None:
    assert hits(searching, question)[0].startswith(first)


@pytest.mark.parametrize(
    ("spoken", "written"),
    [
        pytest.param("alpha 1", r"\alpha_1", id="an index"),
        pytest.param("phi dot", r"\dot{\phi}", id="a rate"),
        pytest.param("pseudoinverse", "pseudo-inverse", id="a hyphen"),
        pytest.param("sine", r"\sin", id="a function"),
        pytest.param("center", "centre", id="American spelling"),
        pytest.param(".022", "0.022", id="a number without its zero"),
    ],
)
def test_words_and_symbols_are_the_same_question(
    searching: Page, spoken: str, written: str
) -> None:
    assert hits(searching, spoken) == hits(searching, written) != []


QUESTIONS = ("cosine", "0.022", "alpha 1", "velocity", "eq:7", "Eq. (10)", "inverse", "330", "slip")


@pytest.mark.parametrize("question", QUESTIONS)
def test_a_fault_stands_before_what_follows_from_it(searching: Page, question: str) -> None:
    places = {address: place for place, address in enumerate(hits(searching, question))}
    rows = [row for ledger in read_ledgers(BUILT.parents[2] / "results") for row in ledger.rows]
    pairs = [(address(row.paper, row.follows), address(row.paper, row.id)) for row in rows]
    both = [pair for pair in pairs if pair[0] in places and pair[1] in places]
    assert [pair for pair in both if places[pair[0]] > places[pair[1]]] == []


def address(paper: str, claim: str) -> str:
    return f"{paper}.html#{anchor(claim)}"


def test_every_number_of_a_table_is_found(built: Path, searching: Page) -> None:
    rows = [row for ledger in read_ledgers(built.parents[2] / "results") for row in ledger.rows]
    cells = [row for row in rows if row.id.startswith("tab:") and is_decimal(row)]
    hits(searching, "")
    found = searching.evaluate(
        """(asked) => {
          const records = RANK.gather(CLAIMS, PLACES), index = RANK.invert(records);
          const found = (text) => RANK.search(records, index, text);
          return asked.map((text) => found(text).map(({ record }) => record.address));
        }""",
        [row.printed for row in cells],
    )
    assert len(cells) > 30
    pairs = zip(cells, found, strict=True)
    assert [row.id for row, got in pairs if address(row.paper, row.id) not in got] == []


def is_decimal(row: Row) -> bool:
    return re.fullmatch(r"-?\d+\.\d+", row.printed) is not None


def test_every_hit_leads_somewhere(built: Path, searching: Page) -> None:
    hits(searching, "")
    asked = searching.evaluate("() => RANK.gather(CLAIMS, PLACES).map((record) => record.address)")
    pages = {page: (built / page).read_text() for page in {x.partition("#")[0] for x in asked}}
    ids = {f"{page}#{i}" for page in pages for i in re.findall(r'\bid="([^"]+)"', pages[page])}
    assert [name for name in asked if name not in ids] == []


def test_a_hit_has_verdict_excerpt_and_address(searching: Page) -> None:
    hits(searching, "4.61")
    text = searching.locator("ol.hits li").first.inner_text()
    for part in ("Table 2", "misrounded", "4.61", "4.62", "omni-arrangement.html#tab-2-X-D_A"):
        assert part in text


def test_nothing_found_says_what_to_try(searching: Page) -> None:
    assert hits(searching, "xyzzy") == []
    assert "Nothing found" in searching.locator("#search [role=status]").inner_text()


def test_the_keyboard_leads_to_the_search(searching: Page, built: Path) -> None:
    searching.goto(f"{built.as_uri()}/index.html")
    searching.keyboard.press("Control+k")
    searching.keyboard.type("4.61")
    searching.keyboard.press("Enter")
    searching.wait_for_url("**/search.html?q=4.61")
    assert searching.locator("ol.hits a").first.get_attribute("href") == (
        "omni-arrangement.html#tab-2-X-D_A"
    )


def test_without_scripts_it_leads_to_the_findings(chromium: Browser, built: Path) -> None:
    context = chromium.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(f"{built.as_uri()}/search.html?q=4.61")
    assert "needs JavaScript" in page.locator("main").inner_text()
    assert page.locator("main a[href='findings.html']").is_visible()
    context.close()


def test_what_is_searched_is_small(built: Path) -> None:
    text = (built / "search.html").read_text()
    files = set(re.findall(r"_static/(search[\w-]*\.(?:js|css))", text))
    assert len(files) > 4
    assert sum((built / "_static" / name).stat().st_size for name in files) < BUDGET
