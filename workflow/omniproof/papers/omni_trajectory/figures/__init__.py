"""The figures of the paper, redrawn from its text and equations with computed data."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omniproof.papers.omni_trajectory.figures.circles import CIRCLES_FIGURE
from omniproof.papers.omni_trajectory.figures.design import DESIGN
from omniproof.papers.omni_trajectory.figures.lines import LINES_FIGURE
from omniproof.papers.omni_trajectory.figures.robot import ROBOT
from omniproof.report.figure import Drawing

_ALL = (*ROBOT, CIRCLES_FIGURE, LINES_FIGURE, *DESIGN)

FIGURES: Mapping[int | str, Drawing] = MappingProxyType(
    {drawing.number: drawing for drawing in sorted(_ALL, key=lambda drawing: str(drawing.number))}
)
"""Drawings by figure number, which is that of the caption."""
