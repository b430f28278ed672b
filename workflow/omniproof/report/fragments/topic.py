"""A topic: what several papers say together, theorems and drawings without a ledger."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from omniproof.report.fragments.base import Fragment, Written, results_folder
from omniproof.report.fragments.figures import drawn_html
from omniproof.report.fragments.tables import grid_html
from omniproof.report.fragments.theorems import Theorem, read_theorems, theorem_markdown
from omniproof.report.latexfmt import math


class Topic:
    """One topic in the book; its calls return fragments of the page `<key>.html`."""

    def __init__(self, key: str, theorems: Iterable[Theorem], results: Path) -> None:
        self.key = key
        self.results = results
        self._theorems = {theorem.id: theorem for theorem in theorems}

    @classmethod
    def open(cls, key: str, results: Path | None = None) -> Topic:
        """Open a topic from the folder of results (found from the working folder)."""
        folder = results or results_folder()
        return cls(key, read_theorems(folder / "theorems.json"), folder)

    def theorem(self, theorem_id: str) -> Written:
        """Show one theorem with its proof. Raises `KeyError` when there is no such theorem."""
        return Written(theorem_markdown(self._theorems[theorem_id]), theorem_id)

    def figure(self, name: str) -> Fragment:
        """Show a drawing by its name."""
        html = drawn_html(self.results, self.key, name, f"figure-{name}")
        return Fragment(html, f"figure {name}")

    def grid(self, head: Sequence[str], rows: Iterable[Sequence[str]]) -> Fragment:
        """Show computed cells (text with `$math$`) under column heads; the first names the row."""
        return Fragment(grid_html(head, rows), "grid")

    def formula(self, latex: str) -> Fragment:
        """Show a formula that was computed, in the large style; a wide one scrolls in its box."""
        return Fragment(f'<p class="computed">{math(latex, display=True)}</p>', "formula")
