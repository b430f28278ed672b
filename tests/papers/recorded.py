"""Recordings made up for drawings that show simulations: tests of figures run no physics engine.

They have all cases and quantities that the models have, and plain values: a robot that goes
straight, numbers that are all one half.
"""

from __future__ import annotations

from functools import cache
from pathlib import PurePosixPath

import numpy as np
import pandas as pd

from omniproof.report.figure import Drawing
from omniproof.simulation.case import model


def frame_of(made: Drawing) -> pd.DataFrame:
    """Data of a drawing, from made-up recordings where it needs any."""
    return made.data(*map(made_up, made.needs))


def made_up(file: str) -> pd.DataFrame:
    path = PurePosixPath(file)
    return numbers(path.parent.name) if path.stem == "summary" else recording()


@cache
def recording() -> pd.DataFrame:
    """Three seconds at 0.05 m/s along x, with the columns of all models."""
    time = np.linspace(0, 3, 301)
    still = ("y", "heading", "height", "spin_x", "spin_y", "spin_z")
    return pd.DataFrame({"time": time, "x": 0.05 * time, **dict.fromkeys(still, 0 * time)})


@cache
def numbers(name: str, value: float = 0.5) -> pd.DataFrame:
    """Numbers of all cases of a model, alike."""
    found = model(name)
    rows = [
        (name, case.name, quantity, value, unit)
        for case in found.cases
        for quantity, unit in found.units.items()
    ]
    return pd.DataFrame(rows, columns=["model", "case", "quantity", "value", "unit"])
