"""A paper's figures as files: picture, data, and what is said of them."""

import json
from pathlib import Path
from types import SimpleNamespace

import pandas as pd
import pytest
from matplotlib.figure import Figure

from omniproof.report import drawing
from omniproof.settings import read_settings


def drawn(frame):
    figure = Figure()
    figure.subplots().plot(frame["x"], frame["y"])
    return figure


@pytest.fixture
def paper(monkeypatch):
    """Return the name of a paper with one figure, number 3."""
    made = SimpleNamespace(
        number=3,
        title="A line",
        caption="Drawn from two points.",
        data=lambda: pd.DataFrame({"x": [0.0, 1.0], "y": [0.1 + 0.2, 1 / 3]}),
        draw=drawn,
        describe=lambda frame: f"{len(frame)} points",
    )
    monkeypatch.setattr(drawing, "load_figures", lambda paper: {3: made})
    return "one-wheel"


def test_files(paper, tmp_path):
    drawing.write_figures(paper, tmp_path)
    assert sorted(file.name for file in tmp_path.iterdir()) == [
        "figure-3.csv",
        "figure-3.svg",
        "figures.json",
    ]
    assert (tmp_path / "figure-3.csv").read_text() == "x,y\n0,0.3\n1,0.333333333333\n"
    assert json.loads((tmp_path / "figures.json").read_text()) == [
        {"number": 3, "title": "A line", "alt": "2 points", "caption": "Drawn from two points."}
    ]
    assert 'id="one-wheel-figure-3-' in (tmp_path / "figure-3.svg").read_text()


def test_same_bytes(paper, tmp_path):
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        drawing.write_figures(paper, tmp_path / name)
    pictures = [(tmp_path / name / "figure-3.svg").read_bytes() for name in ("one", "two")]
    assert pictures[0] == pictures[1]


def test_figures_of_every_paper_have_the_numbers_of_the_configuration(root):
    settings = read_settings(Path("workflow/config.yaml"), root=root)
    for paper, made in settings.told.items():
        assert tuple(drawing.load_figures(paper)) == made.pictures
