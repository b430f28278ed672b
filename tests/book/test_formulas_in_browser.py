"""Formulas that are wider than their place: the measure that finds them, and how ours scroll."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import COMMON_PHONE, unseen_formulas, visit
from playwright.sync_api import Browser, Locator, Page, expect

FORMULAS = [
    pytest.param("<math><mi>a</mi><mo>+</mo><mi>bbbbbbbbbbbbbbbbbbbb</mi></math>", id="MathML"),
    pytest.param('<span class="math"><nobr>a + bbbbbbbbbbbbbbbbbbbbbbb</nobr></span>', id="text"),
    pytest.param(
        '<span role="math"><svg width="190" height="9"><rect width="190" height="9"/></svg></span>',
        id="SVG",
    ),
]
BAR = '<svg role="math" width="50" height="9"><rect width="50" height="9"/></svg>'
STROKE = (
    '<span role="math"><svg width="90" height="9"><svg width="90" height="9">'
    '<rect width="900" height="9"/></svg></svg></span>'
)
NARROW = "width: 30px"
FAULT = ".boxed, .changed"


@pytest.fixture(scope="module")
def sheet(chromium: Browser) -> Iterator[Page]:
    """Give a page to write on."""
    page = chromium.new_page(viewport={"width": COMMON_PHONE, "height": 600})
    yield page
    page.close()


def box(style: str, formula: str, more: str = "") -> str:
    return f'<div style="{style}" {more}>{formula}</div>'


@pytest.mark.parametrize("formula", FORMULAS)
@pytest.mark.parametrize(
    ("style", "cut"),
    [
        pytest.param(f"{NARROW}; overflow: hidden", "<div> cuts", id="hidden"),
        pytest.param(f"{NARROW}; overflow: clip", "<div> cuts", id="clipped"),
        pytest.param(f"{NARROW}; contain: paint", "<div> cuts", id="painted apart"),
        pytest.param(
            f"{NARROW}; overflow: auto; display: flex; flex-direction: row-reverse",
            "<div> cuts",
            id="beyond the start, where nothing scrolls",
        ),
        pytest.param("position: absolute; left: 300px", "the screen cuts", id="off the screen"),
        pytest.param(f"{NARROW}; overflow: auto", "", id="scrolls"),
        pytest.param(NARROW, "", id="in view"),
    ],
)
def test_what_cuts_a_formula_is_named(sheet: Page, style: str, cut: str, formula: str) -> None:
    sheet.set_content(box(style, formula, 'tabindex="0"'))
    found = unseen_formulas(sheet)
    assert [fault.startswith(f"page: {cut} ") for fault in found] == ([True] if cut else [])


@pytest.mark.parametrize(
    ("html", "faults"),
    [
        pytest.param(
            box(f"{NARROW}; overflow: auto", BAR),
            ["page: <div> scrolls, but not by keyboard"],
            id="no keyboard reaches it",
        ),
        pytest.param(
            box("height: 6px; line-height: 0; overflow: hidden", BAR),
            ["page: <div> cuts 3 px off"],
            id="cut below",
        ),
        pytest.param(
            box(f"{NARROW}; overflow: hidden", box("overflow: auto", BAR, 'tabindex="0"')),
            [],
            id="scrolls inside of what cuts",
        ),
        pytest.param(
            box(f"{NARROW}; overflow: hidden", box("width: 60px; overflow: auto", BAR)),
            ["page: <div> cuts 20 px off"],
            id="the box that scrolls is cut",
        ),
        pytest.param(
            box("width: 90px; overflow: hidden", STROKE), [], id="a stroke out of a longer one"
        ),
        pytest.param(
            f"<details><summary>x</summary>{box(f'{NARROW}; overflow: hidden', BAR)}</details>",
            [],
            id="folded",
        ),
        pytest.param('<b class="math"></b>', ["page: nothing is painted"], id="not set"),
    ],
)
def test_only_what_is_lost_is_a_fault(sheet: Page, html: str, faults: list[str]) -> None:
    sheet.set_content(html)
    assert unseen_formulas(sheet) == faults


@pytest.fixture(
    params=[
        pytest.param(("#rows-eq-6 .math.display", "9rem"), id="a boxed entry"),
        pytest.param(("#eq-A-2-a13 .printed .math", "5rem"), id="a changed part"),
    ]
)
def formula(page: Page, small: Path, request: pytest.FixtureRequest) -> Locator:
    """Give a formula with a fault at its end, in a place that is narrower than it."""
    visit(page, f"{small.as_uri()}/omni-arrangement.html")
    place, width = request.param
    found = page.locator(place)
    found.evaluate("(e, width) => { e.style.maxWidth = width }", width)
    assert unseen_formulas(page) == []
    return found


def is_fault_in_view(formula: Locator) -> bool:
    frame, entry = formula.bounding_box(), formula.locator(FAULT).last.bounding_box()
    assert frame is not None
    assert entry is not None
    right = [box["x"] + box["width"] for box in (entry, frame)]
    return entry["x"] >= frame["x"] - 1 and right[0] <= right[1] + 1


def test_a_fault_is_in_view_at_first(formula: Locator) -> None:
    assert is_fault_in_view(formula)
    assert formula.get_attribute("data-fault") is None


def test_a_fault_out_of_view_has_a_cue(formula: Locator, page: Page) -> None:
    """By keyboard a reader scrolls away from it: the shade of that side has another colour."""
    shade = "e => getComputedStyle(e).backgroundImage"
    more = formula.evaluate(shade)
    formula.focus()
    for _ in range(5):
        page.keyboard.press("ArrowLeft")
    expect(formula).to_have_attribute("data-fault", "right")
    expect(formula).to_have_attribute("data-more", "right")
    assert not is_fault_in_view(formula)
    assert more != formula.evaluate(shade) != "none"


def test_only_what_scrolls_is_reached_by_keyboard(formula: Locator, page: Page) -> None:
    expect(formula).to_have_role("group")
    expect(formula).to_have_accessible_name("formula, scrolls sideways")
    formula.evaluate("e => { e.style.maxWidth = '' }")
    expect(formula).not_to_have_attribute("tabindex", "0")
    assert page.locator(".math[tabindex], .math[data-more], .math[role]").count() == 0
