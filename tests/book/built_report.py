"""The report that `make` built, if it is what the sources say now."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).parents[2]
BUILT = ROOT / "book" / "_build" / "html"


def is_fresh() -> bool:
    """Whether the report is there, and younger than everything that it is made of."""
    index = BUILT / "index.html"
    return index.is_file() and newest_source() <= index.stat().st_mtime


def newest_source() -> float:
    """Return when what the report is made of was last changed."""
    globs = ("book/*.*", "book/_[es]*/*.*", "notebooks/*.md", "workflow/omniproof/**/*.py")
    return max(path.stat().st_mtime for pattern in globs for path in ROOT.glob(pattern))
