"""The study of planted misprints on the page."""

from __future__ import annotations

import json
from pathlib import Path

from omniproof.audit.mutation import Case, Fate, Study, write_study
from omniproof.report.fragments import Mutation


def test_figures_of_a_study_are_shown(tmp_path: Path, outline: type) -> None:
    cases = [Case("eq:1", "x", kind, "y", fate) for kind, fate in [
        ("sign", Fate.EXPLAINED), ("sign", Fate.MISSED), ("index", Fate.EQUIVALENT),
        ("factor", Fate.NOT_EVALUATED)]]  # fmt: skip
    write_study(Study(99, tuple(cases)), tmp_path / "mutation.json")
    shown = Mutation.open(tmp_path)
    assert (shown.population, shown.mutants, shown.different) == (99, 4, 2)
    assert (shown.flagged, shown.repaired, shown.proved_equivalent) == (1, 1, 1)
    assert shown.not_evaluated == 1
    page = outline(shown.by_kind().html)
    assert page.tags.count("tr") == 1 + len(
        json.loads((tmp_path / "mutation.json").read_text())["kinds"]
    )
    assert "sign2211" in page.text.replace(" ", "")
