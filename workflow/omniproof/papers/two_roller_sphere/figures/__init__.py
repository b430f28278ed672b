"""The figures of the paper, redrawn from its text and equations."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omniproof.papers.two_roller_sphere.figures.lines import LINES
from omniproof.papers.two_roller_sphere.figures.minimum import MINIMUM
from omniproof.papers.two_roller_sphere.figures.simulation import SIMULATION
from omniproof.papers.two_roller_sphere.figures.single import SINGLE
from omniproof.report.figure import Drawing

FIGURES: Mapping[int | str, Drawing] = MappingProxyType(
    {drawing.number: drawing for drawing in (*SINGLE, *LINES, *SIMULATION, *MINIMUM)}
)
"""Drawings by the number of the caption."""
