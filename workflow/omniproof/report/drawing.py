"""Write a paper's figures: a picture and its data for each, and what the book says of them."""

from __future__ import annotations

import json
from importlib import import_module
from pathlib import Path

from omniproof.report.figure import Drawing
from omniproof.report.svg import save_figure

DIGITS = "%.12g"  # fewer than a double holds: its last bits differ between processors


def load_figures(paper: str) -> tuple[Drawing, ...]:
    """Return the figures of a paper, in order of their numbers, from its module `figures`.

    Raises `ModuleNotFoundError` when the paper has none.
    """
    module = import_module(f"omniproof.papers.{paper.replace('-', '_')}.figures")
    return tuple(sorted(module.FIGURES, key=lambda drawing: drawing.number))


def write_figures(paper: str, folder: Path) -> None:
    """Write `figure-N.svg` and `figure-N.csv` for each figure of a paper, and `figures.json`.

    The JSON file has one record a figure: number, title, alt text and caption.
    """
    drawings = load_figures(paper)
    for drawing in drawings:
        frame = drawing.data()
        stem = folder / f"figure-{drawing.number}"
        frame.to_csv(
            stem.with_suffix(".csv"), index=False, float_format=DIGITS, lineterminator="\n"
        )
        save_figure(drawing.draw(frame), stem.with_suffix(".svg"))
    records = [
        {
            "number": drawing.number,
            "title": drawing.title,
            "alt": drawing.alt,
            "caption": drawing.caption,
        }
        for drawing in drawings
    ]
    text = json.dumps(records, indent=1, ensure_ascii=False)
    (folder / "figures.json").write_text(text + "\n", encoding="utf-8")
