"""The derivation in each chapter: visible cells of plain SymPy, and checks that can fail."""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path
from typing import Any

import jupytext
import pytest

from omniproof.report.printed import printed

ROOT = Path(__file__).parents[2]
PAPERS = sorted(path.parent.name for path in (ROOT / "paper_data").glob("*/paper.yaml"))
CHECK = re.compile(r"printed\(")
HIDDEN = {"remove-cell", "remove-input"}


def cells(paper: str) -> list[Any]:
    """Return the cells of a paper's chapter."""
    return list(jupytext.read(ROOT / "notebooks" / f"{paper}.md").cells)


def visible(paper: str) -> list[str]:
    """Return the code that a reader sees, in order."""
    return [
        cell.source
        for cell in cells(paper)
        if cell.cell_type == "code" and not HIDDEN & set(cell.metadata.get("tags", ()))
    ]


def run(code: str, names: dict[str, Any]) -> Any:
    """Run a cell and return the value of its last line, as Jupyter would show it."""
    *lines, last = ast.parse(code).body
    if not isinstance(last, ast.Expr):
        return exec(code, names)
    exec(compile(ast.Module(lines, []), "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names)


@pytest.mark.parametrize("paper", PAPERS)
def test_a_derivation_has_four_to_eight_steps(paper: str) -> None:
    text = (ROOT / "notebooks" / f"{paper}.md").read_text(encoding="utf-8")
    story = text.partition("\n## Derivation\n")[2].partition("\n## ")[0]
    steps = story.split("\n### ")[1:]
    assert 4 <= len(steps) <= 8
    assert all("```{code-cell} python\n" in step for step in steps)


@pytest.mark.parametrize("paper", PAPERS)
def test_the_derivation_needs_sympy_only(paper: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.split(".")[0] == "omniproof"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "omniproof", None)  # its import fails
    names: dict[str, Any] = {}
    first, *others = (code for code in visible(paper) if not CHECK.search(code))
    run(first.replace("from omniproof.report.printed import printed", ""), names)
    shown = [run(code, names) for code in others]
    assert all(hasattr(value, "_repr_latex_") for value in shown if value is not None)


@pytest.mark.parametrize("paper", PAPERS)
def test_print_is_checked_and_a_fault_is_caught(paper: str) -> None:
    names: dict[str, Any] = {"printed": printed}
    found = [run(code, names) for code in visible(paper)]
    told = [fragment.name for fragment in found if hasattr(fragment, "html")]
    assert len(told) == sum(map(bool, map(CHECK.search, visible(paper))))
    assert any(not name.endswith("verified") for name in told)


@pytest.mark.parametrize("paper", PAPERS)
def test_the_first_cell_says_what_it_needs_and_where_it_is(paper: str) -> None:
    first = cells(paper)[0]
    assert first.cell_type == "markdown"
    assert "pip install sympy" in first.source
    assert f'href="notebooks/{paper}.ipynb"' in first.source
