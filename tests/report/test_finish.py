"""Pages as they are published: formulas set, nothing of the theme that no page uses."""

from __future__ import annotations

import base64
import re
from io import BytesIO
from pathlib import Path

import pytest
from fontTools.ttLib import TTFont

from omniproof.report.finish import finish, set_formulas
from omniproof.report.mathfont import font_face

HEAD = (
    '<script defer src="_static/scripts/fontawesome.js?digest=1"></script>'
    '<link href="_static/search.css" rel="stylesheet"><script src="_static/search.js"></script>'
    '<script src="_static/doctools.js?v=1"></script>'
)


@pytest.mark.parametrize(
    ("html", "expected"),
    [
        pytest.param(
            r'<span class="math notranslate">\(a &lt; 1\)</span>',
            '<span class="math notranslate"><math><mi>𝑎</mi><mo>&lt;</mo><mn>1</mn></math></span>',
            id="in a line",
        ),
        pytest.param(
            '<div class="math notranslate" id="e">\n<span class="eqno">(1)</span>\\[a\\]</div>',
            '<div class="math notranslate" id="e">\n<span class="eqno">(1)</span>'
            '<math display="block"><mi>𝑎</mi></math></div>',
            id="numbered, in a line of its own",
        ),
        pytest.param(r"<code>\(a\)</code>", r"<code>\(a\)</code>", id="code stays"),
    ],
)
def test_formulas_of_a_page(html: str, expected: str) -> None:
    assert set_formulas([html]) == [expected]


@pytest.fixture
def book(tmp_path: Path) -> Path:
    """Give a book of two pages with the theme's files."""
    styles = tmp_path / "_static" / "styles"
    (tmp_path / "_static" / "scripts").mkdir(parents=True)
    styles.mkdir()
    for name in ("fontawesome.js", "fontawesome.js.map", "bootstrap.js"):
        (tmp_path / "_static" / "scripts" / name).touch()
    rules = ".math{color:red}.card{color:blue}"
    (styles / "pydata-sphinx-theme.css").write_text(rules, encoding="utf-8")
    for name in ("index.html", "search.html"):
        text = rf'{HEAD}<span class="math x">\(\alpha + 1\)</span>'
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


def test_a_page_loads_only_what_it_uses(book: Path) -> None:
    finish(book)
    scripts = {
        name: re.findall(r'src="([^"?]*)', (book / name).read_text(encoding="utf-8"))
        for name in ("index.html", "search.html")
    }
    assert scripts == {
        "index.html": ["_static/doctools.js"],
        "search.html": ["_static/search.js", "_static/doctools.js"],
    }


def test_the_icon_font_is_gone(book: Path) -> None:
    finish(book)
    static = book / "_static"
    assert [path.name for path in (static / "scripts").iterdir()] == ["bootstrap.js"]


def test_rules_for_no_element_are_gone(book: Path) -> None:
    finish(book)
    theme = book / "_static" / "styles" / "pydata-sphinx-theme.css"
    assert theme.read_text(encoding="utf-8") == ".math{color:red}"


def font(style_sheet: str) -> TTFont:
    (data,) = re.findall(r"base64,([^\"]*)", style_sheet)
    return TTFont(BytesIO(base64.b64decode(data)))


def test_the_font_has_the_signs_of_the_pages(book: Path) -> None:
    finish(book)
    style_sheet = (book / "_static" / "mathfont.css").read_text(encoding="utf-8")
    signs = set(map(chr, font(style_sheet).getBestCmap()))
    assert {"𝛼", "+", "1", "√"} <= signs  # a root is an element, and its sign in no text
    assert "𝛽" not in signs


def test_brackets_grow_and_the_licence_stays() -> None:
    found = font(font_face("(√"))
    assert "MATH" in found
    assert "SIL Open Font License" in found["name"].getDebugName(13)


def test_all_roots_are_as_narrow_as_the_low_one() -> None:
    """Else Chromium leaves a gap behind a low root."""
    found = font(font_face("√"))
    variants = found["MATH"].table.MathVariants.VertGlyphConstruction[0]
    names = [record.VariantGlyph for record in variants.MathGlyphVariantRecord]
    assert len(names) > 1
    assert len({found["hmtx"][name][0] for name in names}) == 1


def test_the_same_signs_give_the_same_font() -> None:
    assert font_face("ab(") == font_face("b(a")
