"""The figures of the paper, redrawn from its text and equations."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omniproof.papers.three_roller_sphere.figures.simulation import SIMULATION
from omniproof.papers.three_roller_sphere.figures.sketches import SKETCHES
from omniproof.report.figure import Drawing

FIGURES: Mapping[int | str, Drawing] = MappingProxyType(
    {drawing.number: drawing for drawing in (*SKETCHES, *SIMULATION)}
)
"""Drawings by the number of the caption."""
