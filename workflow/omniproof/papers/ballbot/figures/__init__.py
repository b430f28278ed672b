"""The figures of the paper, redrawn from its text and equations, and its laws compared."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omniproof.papers.ballbot.figures.assignment import ASSIGNMENT
from omniproof.papers.ballbot.figures.laws import LAWS
from omniproof.papers.ballbot.figures.motion import MOTION
from omniproof.papers.ballbot.figures.types import TYPES
from omniproof.report.figure import Drawing

FIGURES: Mapping[int | str, Drawing] = MappingProxyType(
    {drawing.number: drawing for drawing in (*TYPES, *ASSIGNMENT, *MOTION, *LAWS)}
)
"""Drawings by the number of the caption, and by name where the paper has no such figure."""
