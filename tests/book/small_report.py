"""Results for a small report: one paper of sixteen rows, and empty chapters for the rest."""

from __future__ import annotations

import shutil
from pathlib import Path

import nbformat

from omniproof.report.fragments import Chapter, Fragment, Overview
from omniproof.report.fragments.base import Written
from omniproof.settings import read_settings

ROOT = Path(__file__).parents[2]
RESULTS = ROOT / "tests" / "report" / "fixtures" / "results"

HEADLINES = {"omni-arrangement eq:6[1,2]": "A sign is wrong: {printed} should read {correct}."}


def write_notebook(path: Path, title: str, *fragments: Fragment | Written) -> None:
    """Write an executed notebook, as the pipeline makes it from a chapter."""
    cells = [nbformat.v4.new_markdown_cell(f"# {title}", id="title")]
    for number, fragment in enumerate(fragments):
        output = nbformat.v4.new_output("execute_result", fragment._repr_mimebundle_())
        cells.append(nbformat.v4.new_code_cell("0", id=f"c{number}", outputs=[output]))
    metadata = {"language_info": {"name": "python", "pygments_lexer": "ipython3"}}
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=metadata), path)


def small_results(folder: Path) -> Path:
    """Lay out a folder of results with three executed notebooks; other chapters are empty."""
    shutil.copytree(RESULTS, folder)
    (folder / "notebooks").mkdir()
    paper, all_papers = Chapter.open("omni-arrangement", RESULTS), Overview.open(RESULTS)
    chapter = [paper.counts(), paper.answers(), paper.table("tab:2["), paper.figure(5)]
    chapter.append(paper.all_theorems())
    pages: dict[str, list[Fragment | Written]] = {
        "index": [all_papers.counts(), all_papers.headlines(HEADLINES)],
        "findings": [all_papers.findings()],
        "omni-arrangement": [*chapter, paper.every_row()],
    }
    for name in read_settings(Path("workflow/config.yaml"), root=ROOT).chapters:
        pages.setdefault(name, [])  # the table of contents names it
    for name, fragments in pages.items():
        write_notebook(folder / "notebooks" / f"{name}.ipynb", name, *fragments)
    (folder / "ledger.csv").write_text("paper\n")
    (folder / "corrigenda").mkdir()
    (folder / "corrigenda" / "omni-arrangement.pdf").write_text("a corrigendum\n")
    return folder
