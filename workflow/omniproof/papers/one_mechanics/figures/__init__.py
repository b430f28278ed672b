"""Drawings for the chapter on all five papers, by name."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from omniproof.papers.one_mechanics.figures.cases import CASES
from omniproof.papers.one_mechanics.figures.contact import CONTACT
from omniproof.papers.one_mechanics.figures.spins import SPINS
from omniproof.report.figure import Drawing

FIGURES: Mapping[int | str, Drawing] = MappingProxyType(
    {drawing.number: drawing for drawing in (CONTACT, CASES, SPINS)}
)
