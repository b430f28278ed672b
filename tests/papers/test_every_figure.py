"""Every redrawn figure: it draws from its data, is legible on a phone, and says what it shows."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text
from recorded import frame_of

import omniproof.papers
from omniproof.report.drawing import load_figures
from omniproof.report.figure import COLUMNS, Drawing
from omniproof.report.sketch import REDRAWN
from omniproof.report.svg import svg_text

PHONE = 360
SMALLEST = 9.5
FOLDERS = sorted(Path(omniproof.papers.__file__).parent.glob("*/figures/__init__.py"))
PAPERS = [file.parent.parent.name.replace("_", "-") for file in FOLDERS]
EVERY = [
    pytest.param(paper, number, id=f"{paper} {number}")
    for paper in PAPERS
    for number in load_figures(paper)
]


def drawing(paper: str, number: int | str) -> Drawing:
    return load_figures(paper)[number]


@cache
def frame(paper: str, number: int | str) -> pd.DataFrame:
    return frame_of(drawing(paper, number))


@cache
def picture(paper: str, number: int | str) -> Figure:
    figure = drawing(paper, number).draw(frame(paper, number))
    figure.draw_without_rendering()  # puts the labels of axes in their places
    return figure


def text_of(made: Drawing, data: pd.DataFrame) -> str:
    return svg_text(made.draw(data), title=made.title, alt="alt", prefix="figure")


@cache
def svg(paper: str, number: int | str) -> str:
    return text_of(drawing(paper, number), frame(paper, number))


def test_each_paper_has_figures() -> None:
    assert {"ballbot", "omni-arrangement"} <= set(PAPERS)


@pytest.mark.parametrize("paper", PAPERS)
def test_figures_are_filed_under_their_numbers_in_order(paper: str) -> None:
    figures = load_figures(paper)
    assert [made.number for made in figures.values()] == list(figures)
    numbers = [number for number in figures if isinstance(number, int)]
    assert numbers == list(range(1, len(numbers) + 1))
    assert list(figures)[: len(numbers)] == numbers


@pytest.mark.parametrize(("paper", "number"), EVERY)
def test_data_are_in_long_form(paper: str, number: int | str) -> None:
    data = frame(paper, number)
    assert list(data.columns) == COLUMNS
    assert len(data) > 0
    assert not data[["panel", "series", "x", "y"]].isna().any(axis=None)
    assert np.isfinite(data[["x", "y"]].to_numpy(dtype=float)).all()


@pytest.mark.parametrize(("paper", "number"), EVERY)
def test_words_say_what_and_how(paper: str, number: int | str) -> None:
    made = drawing(paper, number)
    assert made.title
    alt = made.describe(frame(paper, number))
    assert len(alt) > 60
    assert "nan" not in alt.lower().split()
    own = re.compile("The paper has no such figure|The papers have no such figure")
    assert REDRAWN in made.caption if isinstance(number, int) else own.search(made.caption)


@pytest.mark.parametrize(("paper", "number"), EVERY)
def test_picture_has_same_bytes_twice_and_no_raster(paper: str, number: int | str) -> None:
    made, found = drawing(paper, number), svg(paper, number)
    assert found == text_of(made, frame_of(made))
    assert "<image" not in found
    assert "data:" not in found
    assert len(found.encode()) < 150_000
    ids = re.findall(r'\sid="([^"]+)"', found)
    assert len(ids) == len(set(ids))
    assert all(name.startswith("figure-") for name in ids)


@pytest.mark.parametrize(("paper", "number"), EVERY)
def test_letters_are_legible_on_a_phone(paper: str, number: int | str) -> None:
    figure = picture(paper, number)
    pixels_per_point = PHONE / (figure.get_figwidth() * 72)
    sizes = [float(text.get_fontsize()) for text in figure.findobj(Text) if text.get_text()]
    assert sizes
    assert min(sizes) * pixels_per_point >= SMALLEST


@pytest.mark.parametrize(("paper", "number"), EVERY)
def test_nothing_is_cut_off_at_the_rim(paper: str, number: int | str) -> None:
    figure = picture(paper, number)
    for text in figure.findobj(Text):
        if not text.get_text() or not text.get_visible():
            continue
        box = text.get_window_extent()
        assert box.x0 >= -1, text.get_text()
        assert box.y0 >= -1, text.get_text()
        assert box.x1 <= figure.bbox.width + 1, text.get_text()
        assert box.y1 <= figure.bbox.height + 1, text.get_text()


@pytest.mark.parametrize(("paper", "number"), EVERY)
def test_picture_is_drawn_from_the_data_alone(paper: str, number: int | str) -> None:
    """The data scaled by 0.9 give another picture."""
    made, data = drawing(paper, number), frame(paper, number)
    scaled: Any = {axis: 0.9 * data[axis] for axis in "xyz"}
    assert text_of(made, data.assign(**scaled)) != svg(paper, number)
