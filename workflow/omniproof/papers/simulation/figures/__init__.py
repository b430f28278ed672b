"""Drawings for the chapter on simulation, by name."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omniproof.papers.simulation.figures.equator import EQUATOR_FIGURE
from omniproof.papers.simulation.figures.measured import MEASURED
from omniproof.papers.simulation.figures.models import MODELS
from omniproof.report.figure import Drawing

FIGURES: Mapping[int | str, Drawing] = MappingProxyType(
    {drawing.number: drawing for drawing in (*MODELS, *MEASURED, EQUATOR_FIGURE)}
)
