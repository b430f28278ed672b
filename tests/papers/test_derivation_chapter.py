"""The derivation in one page: visible SymPy, and not a word on the papers that is not checked."""

from __future__ import annotations

import ast
import re
import shutil
import sys
from pathlib import Path
from typing import Any, TypeAlias

import jupytext
import pytest
from audited import audited_once

from omniproof.audit.ledger import Verdict
from omniproof.report.fragments.base import worst
from omniproof.report.notebook import ChapterError, execute
from omniproof.report.printed import StaleTextError, printed
from omniproof.transcription.ids import base

Names: TypeAlias = dict[str, Any]
ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "notebooks" / "derivation.md"
CELLS = jupytext.read(SOURCE).cells
CODE = [cell.source for cell in CELLS if cell.cell_type == "code"]
PROSE = "\n".join(cell.source for cell in CELLS if cell.cell_type != "code")
PLAIN = [code for code in CODE if "printed" not in code]
CLAIM = re.compile(r'printed\("([\w-]+)", "([^"]+)"\)')
CLAIMS = [(found[1], found[2]) for code in CODE if (found := CLAIM.search(code))]
ARRANGEMENT, TRAJECTORY, BALLBOT = "omni-arrangement", "omni-trajectory", "ballbot"
FAULTS = {
    (ARRANGEMENT, "eq:6[2,3]"): (r"& \sin \alpha_1 + \sin", r"& \sin \alpha_1 - \sin"),
    (ARRANGEMENT, "eq:11"): (r"8 / \det \mathbf{A}", r"8 / |\det \mathbf{A}|"),
    (ARRANGEMENT, "tab:2[X,D_A]"): ("4.61", "4.62"),
    (TRAJECTORY, "eq:8"): (r"'\int_{0}^{t} \left\{", r"'\frac{1}{3} \int_{0}^{t} \left\{"),
    (TRAJECTORY, "eq:13"): (r"\frac{\sqrt{2}}{|a+b+c|}", r"\frac{\sqrt{2}L}{|a+b+c|}"),
    (TRAJECTORY, "eq:16/factor"): ("2L", "L"),
    (TRAJECTORY, "eq:16/line-1"): (r"{\sqrt{3}a - \sqrt{3}b}", r"{\sqrt{3}b - \sqrt{3}a}"),
    (BALLBOT, "eq:8"): (
        r"\frac{\sqrt{3}}{2} v_x^B + \frac{1}{2} v_y^B",
        r"c\phi (\frac{\sqrt{3}}{2} v_x^B + \frac{1}{2} v_y^B)",
    ),
}
"""The faults that the chapter tells: as they are printed, and mended."""


def run(code: str, names: Names) -> Any:
    """Run a cell and return the value of its last line, as Jupyter would show it."""
    *lines, last = ast.parse(code).body
    if not isinstance(last, ast.Expr):
        return exec(code, names)
    exec(compile(ast.Module(lines, []), "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names)


@pytest.fixture(scope="module")
def checks() -> dict[tuple[str, str], tuple[str, Names]]:
    """Give each check with the names that there are when the chapter comes to it."""
    names: Names = {"printed": printed}
    found = {}
    for code in CODE:
        if claim := CLAIM.search(code):
            found[claim[1], claim[2]] = code, dict(names)
        elif code in PLAIN:
            run(code, names)
    return found


@pytest.fixture
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give a folder with a copy of what the papers print, and go there."""
    shutil.copytree(ROOT / "paper_data", tmp_path / "paper_data")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def alter(folder: Path, claim: tuple[str, str], new: str) -> None:
    """Print something else in the place of a fault."""
    paper, place = claim
    table = re.match(r"tab:(\d+)", place)
    file = folder / "paper_data" / paper / (f"table-{table[1]}.csv" if table else "paper.yaml")
    before, start, after = file.read_text("utf-8").rpartition(f"- id: {base(place)}\n")
    assert bool(start) is not bool(table)
    assert FAULTS[claim][0] in after
    file.write_text(before + start + after.replace(FAULTS[claim][0], new, 1), "utf-8")


def test_all_cells_are_seen_and_import_nothing_but_sympy_and_the_check() -> None:
    assert [cell.metadata for cell in CELLS if cell.metadata] == []
    imports = [line for code in CODE for line in code.splitlines() if "import" in line]
    assert imports == ["import sympy as sp", "from omniproof.report.printed import printed"]
    assert "A.adjugate()[1, 2]" in "".join(PLAIN)
    assert len(PLAIN) > len(CLAIMS) > len(FAULTS)


def test_the_first_cell_says_what_it_needs_and_where_it_is() -> None:
    assert "pip install sympy" in CELLS[0].source
    assert 'href="notebooks/derivation.ipynb"' in CELLS[0].source


def test_no_verdict_is_typed() -> None:
    assert set(re.findall(r"[a-z-]+", PROSE.lower())) & set(Verdict) == set()


def test_the_derivations_need_sympy_only(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.split(".")[0] == "omniproof"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "omniproof", None)  # its import fails
    names: Names = {}
    shown = [run(code, names) for code in PLAIN]
    assert all(hasattr(value, "_repr_latex_") for value in shown[1:])


@pytest.mark.parametrize(("paper", "claim"), CLAIMS)
def test_a_verdict_is_that_of_the_ledger(paper: str, claim: str) -> None:
    rows = audited_once(ROOT / "paper_data" / paper).rows
    own = [row for row in rows if claim in {row.id, base(row.id)}]
    assert printed(paper, claim).verdict is worst(own)


def test_every_fault_that_is_told_is_mended_below(checks: dict[tuple[str, str], Any]) -> None:
    assert {claim for claim, (code, _) in checks.items() if "should_be" in code} == set(FAULTS)


@pytest.mark.parametrize("claim", FAULTS, ids=" ".join)
def test_a_fault_that_is_mended_stops_the_chapter(
    checks: dict[tuple[str, str], tuple[str, Names]], elsewhere: Path, claim: tuple[str, str]
) -> None:
    code, names = checks[claim]
    run(code, names)
    alter(elsewhere, claim, FAULTS[claim][1])
    with pytest.raises(StaleTextError, match="that it has a fault, but it is judged verified"):
        run(code, names)


def test_a_fault_that_is_another_one_stops_the_chapter(elsewhere: Path) -> None:
    alter(elsewhere, (ARRANGEMENT, "eq:6[2,3]"), r"& \sin \alpha_1 + 2 \sin")
    with pytest.raises(ChapterError) as caught:
        execute(SOURCE, elsewhere / "out.ipynb", elsewhere)
    assert "(alpha_2 = angles[1]): StaleTextError: omni-arrangement eq:6[2,3]" in str(caught.value)
    assert not (elsewhere / "out.ipynb").exists()
