"""Write a paper's figures: a picture and its data for each, and what the book says of them."""

from __future__ import annotations

import inspect
import json
from collections.abc import Iterable, Mapping
from importlib import import_module
from pathlib import Path

import pandas as pd

from omniproof.report.code_pages import PACKAGE
from omniproof.report.figure import Drawing
from omniproof.report.svg import save_figure

DIGITS = "%.12g"
"""Fewer than a double holds: its last bits differ between processors."""


def load_figures(paper: str) -> Mapping[int | str, Drawing]:
    """Return the figures of a paper by number or name, from its module `figures`.

    Raises `ModuleNotFoundError` when the paper has none.
    """
    module = import_module(f"omniproof.papers.{paper.replace('-', '_')}.figures")
    figures: Mapping[int | str, Drawing] = module.FIGURES
    return figures


def write_figures(paper: str, folder: Path, results: Path) -> None:
    """Write `figure-N.svg` and `figure-N.csv` for each figure of a paper, and `figures.json`.

    The JSON file has a record for each figure: number or name, title, alt text and
    caption. Drawings that show simulations find them in the folder of `results`.
    """
    write_drawings(load_figures(paper).values(), paper, folder, results)


def write_drawings(drawings: Iterable[Drawing], name: str, folder: Path, results: Path) -> None:
    """Write drawings and what is said of them; `name` starts the ids in the pictures."""
    records = [
        _write(
            drawing,
            drawing.frame(results),
            folder / f"figure-{drawing.number}",
            f"{name}-figure-{drawing.number}",
        )
        for drawing in drawings
    ]
    text = json.dumps(records, indent=1, ensure_ascii=False)
    (folder / "figures.json").write_text(text + "\n", encoding="utf-8")


def source_of(drawing: Drawing) -> str:
    """Return file and line of the function that draws: `omniproof/papers/a/figures/b.py:7`.

    Nothing for a drawing that is none of a paper's or a topic's: its code has no page.
    """
    code = inspect.unwrap(drawing.draw).__code__
    file, papers = Path(code.co_filename).resolve(), (PACKAGE / "papers").resolve()
    if not file.is_relative_to(papers):
        return ""
    return f"omniproof/papers/{file.relative_to(papers).as_posix()}:{code.co_firstlineno}"


def _write(drawing: Drawing, frame: pd.DataFrame, stem: Path, prefix: str) -> dict[str, int | str]:
    """Write one figure; return what the book says of it. Ids in the picture start with `prefix`."""
    alt = drawing.describe(frame)
    frame.to_csv(stem.with_suffix(".csv"), index=False, float_format=DIGITS, lineterminator="\n")
    picture = stem.with_suffix(".svg")
    save_figure(drawing.draw(frame), picture, title=drawing.title, alt=alt, prefix=prefix)
    return {
        "number": drawing.number,
        "title": drawing.title,
        "alt": alt,
        "caption": drawing.caption,
        "source": source_of(drawing),
    }
