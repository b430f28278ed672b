"""A paper's figures as files: picture, data, and what is said of them."""

import json
from pathlib import Path

import pandas as pd
import pytest
from matplotlib.figure import Figure

from omniproof.report import drawing
from omniproof.report.figure import Drawing
from omniproof.settings import read_settings


def drawn(frame):
    figure = Figure()
    figure.subplots().plot(frame["x"], frame["y"])
    return figure


@pytest.fixture
def paper(monkeypatch):
    """Return the name of a paper with one figure, number 3."""
    made = Drawing(
        number=3,
        title="A line",
        caption="Drawn from two points.",
        data=lambda first, last: pd.concat([first, last]),
        draw=drawn,
        describe=lambda frame: f"{len(frame)} points",
        needs=("first.csv", "simulation/last.csv"),
    )
    monkeypatch.setattr(drawing, "load_figures", lambda paper: {3: made})
    return "one-wheel"


@pytest.fixture
def results(tmp_path):
    """Return a folder of results with what the drawing needs."""
    folder = tmp_path / "results"
    (folder / "simulation").mkdir(parents=True)
    (folder / "first.csv").write_text("x,y\n0,0.30000000000000004\n")
    (folder / "simulation/last.csv").write_text(f"x,y\n1,{1 / 3!r}\n")
    return folder


def test_files(paper, results, tmp_path):
    drawing.write_figures(paper, tmp_path, results)
    assert sorted(file.name for file in tmp_path.iterdir() if file.is_file()) == [
        "figure-3.csv",
        "figure-3.svg",
        "figures.json",
    ]
    assert (tmp_path / "figure-3.csv").read_text() == "x,y\n0,0.3\n1,0.333333333333\n"
    assert json.loads((tmp_path / "figures.json").read_text()) == [
        {
            "number": 3,
            "title": "A line",
            "alt": "2 points",
            "caption": "Drawn from two points.",
            "source": "",
        }
    ]
    assert 'id="one-wheel-figure-3-' in (tmp_path / "figure-3.svg").read_text()


def test_same_bytes(paper, results, tmp_path):
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        drawing.write_figures(paper, tmp_path / name, results)
    pictures = [(tmp_path / name / "figure-3.svg").read_bytes() for name in ("one", "two")]
    assert pictures[0] == pictures[1]


def test_figures_of_every_paper_have_the_numbers_of_the_configuration(root):
    settings = read_settings(Path("workflow/config.yaml"), root=root)
    for paper, made in settings.told.items():
        assert tuple(drawing.load_figures(paper)) == made.pictures


def test_what_a_drawing_needs_is_simulated_for_it(root):
    settings = read_settings(Path("workflow/config.yaml"), root=root)
    for paper, made in settings.told.items():
        given = {
            f"simulation/{model}/{file}.csv"
            for model in made.models
            for file in (*settings.simulation[model], "summary")
        }
        needed = {file for one in drawing.load_figures(paper).values() for file in one.needs}
        assert needed <= given
        assert {file.split("/")[1] for file in needed} == set(made.models)
