"""How a verdict looks: one word, one shape, one pair of colours, in one place.

The word and the shape carry the meaning; colour only repeats it, so that a page reads the same in
grey, in print and for a colour-blind reader. Hues follow Okabe and Ito's set (2008), darkened or
lightened until the text reaches a contrast of 4.5 on the page (tested).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from omniproof.audit.ledger import Verdict

PAGE_LIGHT = "#ffffff"
PAGE_DARK = "#14181e"


@dataclass(frozen=True)
class Mark:
    """One verdict as a reader sees it; colours are `#rrggbb` for the light and the dark page."""

    word: str
    shape: str
    light: str
    dark: str
    meaning: str


MARKS: Mapping[Verdict, Mark] = {
    Verdict.VERIFIED: Mark("verified", "✓", "#00674a", "#3cc79a", "true: proved, or found as said"),
    Verdict.CONDITIONAL: Mark(
        "conditional", "◐", "#00588f", "#6cb8ee", "true only under a condition that is not stated"
    ),
    Verdict.ERRATUM: Mark(
        "erratum", "✗", "#a93200", "#ff9157", "false; a counterexample and a correction are given"
    ),
    Verdict.MISROUNDED: Mark(
        "misrounded", "≈", "#7d5a00", "#e2b33c", "a decimal that is off in its last place"
    ),
    Verdict.INCONSISTENT: Mark(
        "inconsistent", "≠", "#8f3f6f", "#e79ac4", "contradicts another place of the same paper"
    ),
    Verdict.MODEL_GAP: Mark(
        "model gap", "△", "#5b4a9e", "#b5a5f0", "follows from premises that mechanics contradicts"
    ),
    Verdict.EDITORIAL: Mark(
        "editorial", "✎", "#55606b", "#a9b4bf", "spelling or notation, without consequence"
    ),
    Verdict.UNCHECKABLE: Mark(
        "uncheckable", "?", "#4a5560", "#b4bec8", "nothing at hand decides it; what would is said"
    ),
    Verdict.UNDECIDED: Mark(
        "undecided", "!", "#8a0f3c", "#ff8fb0", "an engine gave up: a defect of this project"
    ),
}


def stylesheet() -> str:
    """Return the CSS variables `--v` (colour of a verdict) for both modes, class by class."""
    light = [f".v-{verdict} {{ --v: {mark.light}; }}" for verdict, mark in MARKS.items()]
    dark = [
        f'html[data-theme="dark"] .v-{verdict} {{ --v: {mark.dark}; }}'
        for verdict, mark in MARKS.items()
    ]
    paper = "@media print {\n" + "\n".join(f"  html {rule}" for rule in light) + "\n}"
    return "\n".join(["/* Written from omniproof.report.theme. */", *light, *dark, paper]) + "\n"
