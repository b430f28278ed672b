"""A figure as a record: what it is called, its data in long form, and how the data are drawn.

Drawing gets the data frame and nothing else, so the CSV beside a picture is what the picture shows.
A figure that shows a simulation says which files of results its data are made from, and gets these
and no others: so the workflow can make them first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

Floats: TypeAlias = NDArray[np.float64]
Row: TypeAlias = tuple[str, str, float, float, float]

COLUMNS = ["panel", "series", "x", "y", "z"]
NOISE = 1e-12
"""Coordinates nearer to zero than this are zero: else their last bits get into the file."""


@dataclass(frozen=True)
class Drawing:
    """One figure: `data` gives the frame (`COLUMNS`), `draw` draws it, `describe` says it in words.

    `caption` says how the figure was made; `describe` gets the frame, so that numbers in the alt
    text are those drawn. `number` is that of the paper's caption, or a name for a drawing that the
    paper does not have. `data` gets the tables that the drawing `needs`: CSV files by their paths
    below the folder of results, in this order.
    """

    number: int | str
    title: str
    caption: str
    data: Callable[..., pd.DataFrame]
    draw: Callable[[pd.DataFrame], Figure]
    describe: Callable[[pd.DataFrame], str]
    needs: tuple[str, ...] = ()

    def frame(self, results: Path) -> pd.DataFrame:
        """Return the data, made from what lies in the folder of `results`."""
        return self.data(*(pd.read_csv(results / file) for file in self.needs))


def rows(panel: str, series: str, points: ArrayLike) -> Iterator[Row]:
    """Yield the rows of one series; `points` is M x 2 (z stays empty) or M x 3."""
    for point in np.atleast_2d(np.asarray(points, dtype=np.float64)):
        x, y, *rest = (0.0 if abs(value) < NOISE else float(value) for value in point)
        yield panel, series, x, y, rest[0] if rest else float("nan")


def long_form(*parts: Iterable[Row]) -> pd.DataFrame:
    """Return the rows of all parts as one frame with the columns `COLUMNS`."""
    return pd.DataFrame([row for part in parts for row in part], columns=COLUMNS)


def points(frame: pd.DataFrame, panel: str, series: str) -> Floats:
    """Return the points of one series of one panel: M x 2, or M x 3 where z is given.

    Raises `KeyError` when there is no such series.
    """
    # In NumPy: a picture of some hundred series asks as often, and Pandas takes thrice the time.
    chosen = (frame["panel"].to_numpy() == panel) & (frame["series"].to_numpy() == series)
    if not chosen.any():
        raise KeyError(f"no series {series!r} in panel {panel!r}")
    found = frame[["x", "y", "z"]].to_numpy(dtype=np.float64)[chosen]
    return found[:, :2] if np.isnan(found[:, 2]).all() else found
