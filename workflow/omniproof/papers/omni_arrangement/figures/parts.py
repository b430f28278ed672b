"""What several figures of this paper share: its types, their numbers, and bodies in space."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
import pandas as pd
from matplotlib.axes import Axes

from omniproof.kinematics.omni import twist_matrix, velocity_matrix
from omniproof.papers.omni_arrangement.arrangements import CORRECTED
from omniproof.report.figure import Floats
from omniproof.report.sketch import View, floats, outlined, tinted, toward_viewer

TYPES = tuple(CORRECTED)
TWIST_AXES = (r"$V_x$ [m/s]", r"$V_y$ [m/s]", r"$L\dot{\phi}$ [m/s]")


@cache
def generators(kind: str) -> Floats:
    """Columns a_1, a_2, a_3 of the inverse for a type, numeric: 3 x 3."""
    return floats(twist_matrix(velocity_matrix(CORRECTED[kind])))


def body_faces(frame: pd.DataFrame, panel: str) -> list[Floats]:
    """Faces of the body of a panel: the series whose names start with `face`, each m x 3."""
    chosen = frame[(frame["panel"] == panel) & frame["series"].str.startswith("face")]
    return [
        part[["x", "y", "z"]].to_numpy(dtype=np.float64)
        for _, part in chosen.groupby("series", sort=True)
    ]


def draw_body(ax: Axes, faces: Sequence[Floats], view: View, color: str) -> None:
    """Draw a convex body: front faces tinted with full edges, the edges behind dotted."""
    for face in faces:
        normal = np.cross(face[1] - face[0], face[2] - face[1])
        shape = view.place(face)
        if normal @ toward_viewer() > 0:
            tinted(ax, shape, color, alpha=0.2, zorder=2)
            outlined(ax, shape, color, lw=1.6)
        else:
            outlined(ax, shape, color, lw=0.9, ls=":", zorder=1.5)
