"""What is read by hand, as a reader sees it: formulas among words are set as formulas."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from omniproof.papers import ballbot
from omniproof.report.latexfmt import cell

PAPERS = Path(str(ballbot.__file__)).parents[1]
READINGS = [
    pytest.param(file, id=file.parent.name) for file in sorted(PAPERS.glob("*/readings.yaml"))
]
SET = re.compile(r"\\\(.*?\\\)")
"""A formula as the page hands it to the browser to be set."""
BARE = re.compile(r"\\|[A-Za-z}][_^][A-Za-z{0-9]")
"""LaTeX: a command, an index, a power."""


@pytest.mark.parametrize("file", READINGS)
def test_no_latex_is_left_among_the_words(file: Path) -> None:
    shown = {
        (claim, field): SET.sub("", cell(reading[field]))
        for claim, reading in yaml.safe_load(file.read_text(encoding="utf-8")).items()
        for field in ("correction", "reason")
        if reading.get(field)
    }
    assert {place: text for place, text in shown.items() if BARE.search(text)} == {}
