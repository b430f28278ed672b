"""The figures of the paper, redrawn from its text and equations with computed data."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omniproof.papers.omni_arrangement.figures.bodies import BODIES
from omniproof.papers.omni_arrangement.figures.curves import CURVES
from omniproof.papers.omni_arrangement.figures.plane import PLANE
from omniproof.papers.omni_arrangement.figures.sign import SIGN
from omniproof.papers.omni_arrangement.figures.sketches import SKETCHES
from omniproof.report.figure import Drawing

_ALL = (*SKETCHES, *BODIES, *PLANE, *CURVES, SIGN)

FIGURES: Mapping[int | str, Drawing] = MappingProxyType(
    {drawing.number: drawing for drawing in sorted(_ALL, key=lambda drawing: str(drawing.number))}
)
"""Drawings by the number of the caption, and by name where the paper has no such figure."""
