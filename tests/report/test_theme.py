from __future__ import annotations

import pytest

from omniproof.audit.ledger import Verdict
from omniproof.report.theme import MARKS, PAGE_DARK, PAGE_LIGHT, stylesheet


def luminance(colour: str) -> float:
    """Relative luminance of WCAG 2.1."""
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return sum(weight * p for weight, p in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def contrast(one: str, other: str) -> float:
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def test_contrast_is_measured_as_the_standard_says() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)


@pytest.mark.parametrize("verdict", Verdict)
def test_every_verdict_can_be_read_on_both_pages(verdict: Verdict) -> None:
    mark = MARKS[verdict]
    assert contrast(mark.light, PAGE_LIGHT) >= 4.5
    assert contrast(mark.dark, PAGE_DARK) >= 4.5


def test_no_two_verdicts_share_a_word_or_a_shape() -> None:
    assert len({mark.word for mark in MARKS.values()}) == len(Verdict)
    assert len({mark.shape for mark in MARKS.values()}) == len(Verdict)


def test_stylesheet_has_both_colours_of_every_verdict() -> None:
    css = stylesheet()
    for verdict, mark in MARKS.items():
        assert f".v-{verdict} {{ --v: {mark.light}; }}" in css
        assert f'html[data-theme="dark"] .v-{verdict} {{ --v: {mark.dark}; }}' in css
