"""How a figure becomes a file: colours, ids, names, same bytes, all or nothing."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree as ET

import matplotlib as mpl
import pytest
from matplotlib.figure import Figure

from omniproof.report import svg

LIGHT, DARK = ["#ffffff"], ["#121212", "#14181e"]
HUES = {**svg.TYPE_COLORS, "accent": svg.ACCENT}
SVG = "{http://www.w3.org/2000/svg}"


@svg.styled
def sample() -> Figure:
    figure, ax = svg.stage(1.0)
    ax.plot([1, 2, 3], [0.2, 0.8, 0.2], marker="o")
    ax.plot([1, 2], [0.1, 9.0], color=svg.TYPE_COLORS["X"], clip_on=True)
    ax.text(0.5, 0.5, r"$\alpha_1$ and text")
    return figure


def text_of(prefix: str = "fig1") -> str:
    return svg.svg_text(sample(), title="A <title>", alt="What one sees & more", prefix=prefix)


def luminance(color: str) -> float:
    """Relative luminance after WCAG 2."""
    parts = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a: str, b: str) -> float:
    high, low = sorted((luminance(a), luminance(b)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("page", [pytest.param(page, id=page) for page in LIGHT + DARK])
@pytest.mark.parametrize("color", [pytest.param(c, id=name) for name, c in HUES.items()])
def test_hues_stand_out_on_light_and_dark_pages(color: str, page: str) -> None:
    assert contrast(color, page) >= 3


def test_types_differ_without_colour() -> None:
    assert len(set(svg.TYPE_MARKERS.values())) == len(set(svg.TYPE_DASHES.values())) == 3


def test_file_is_named_and_described() -> None:
    root = ET.fromstring(text_of())
    title, desc = root.find(f"{SVG}title"), root.find(f"{SVG}desc")
    assert root.get("role") == "img"
    assert title is not None
    assert desc is not None
    assert (title.text, desc.text) == ("A <title>", "What one sees & more")
    assert root.get("aria-labelledby") == f"{title.get('id')} {desc.get('id')}"


def test_ink_is_the_colour_of_the_page() -> None:
    text = text_of()
    assert "currentColor" in text
    assert svg.INK not in text
    assert "#000000" not in text


def test_styles_hold_for_the_standalone_file_only() -> None:
    (style,) = re.findall(r"<style.*?</style>", text_of(), flags=re.DOTALL)
    assert "prefers-color-scheme:dark" in style
    assert set(re.findall(r"([^{}]+)\{", style.replace("<style>", ""))) == {
        "svg:root",
        "@media (prefers-color-scheme:dark)",
    }


def test_ids_are_prefixed_unique_and_resolved() -> None:
    text = text_of("fig7")
    ids = re.findall(r'\sid="([^"]+)"', text)
    used = re.findall(r'(?:url\(#|href="#)([^")]+)', text)
    assert len(ids) == len(set(ids))
    assert all(name.startswith("fig7-") for name in ids)
    assert used
    assert set(used) <= set(ids)


def test_two_figures_share_no_id_on_one_page() -> None:
    one, two = (set(re.findall(r'\sid="([^"]+)"', text_of(prefix))) for prefix in ("a", "b"))
    assert not one & two


def test_same_figure_same_bytes_and_no_date() -> None:
    assert text_of() == text_of()
    assert "<metadata" not in text_of()


def test_background_is_transparent_and_letters_are_outlines() -> None:
    text = text_of()
    assert "fill: #ffffff" not in text
    assert "<text" not in text
    assert "<image" not in text


def test_style_leaves_the_settings_of_others_alone() -> None:
    before = dict(mpl.rcParams)
    text_of()
    assert dict(mpl.rcParams) == before


def test_saving_replaces_the_file_and_leaves_no_other(tmp_path: Path) -> None:
    path = tmp_path / "made" / "figure-1.svg"
    for alt in ("first", "second"):
        svg.save_figure(sample(), path, title="t", alt=alt, prefix="f")
    assert '<desc id="f-desc">second</desc>' in path.read_text(encoding="utf-8")
    assert list(path.parent.iterdir()) == [path]


@pytest.mark.parametrize(
    ("title", "alt", "prefix"),
    [
        pytest.param(" ", "alt", "f", id="no title"),
        pytest.param("title", "", "f", id="no alt text"),
        pytest.param("title", "alt", "1 2", id="prefix that starts no id"),
    ],
)
def test_what_a_reader_would_miss_is_refused(
    title: str, alt: str, prefix: str, tmp_path: Path
) -> None:
    path = tmp_path / "figure.svg"
    path.write_text("earlier", encoding="utf-8")
    with pytest.raises(ValueError, match="expected"):
        svg.save_figure(sample(), path, title=title, alt=alt, prefix=prefix)
    assert path.read_text(encoding="utf-8") == "earlier"
