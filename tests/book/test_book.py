"""The report as a browser shows it: a small one built here, and the one that `make` built."""

from __future__ import annotations

import filecmp
import html as markup
import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import nbformat
import pytest

from omniproof.report.book import BookError, build, read_ledgers, stage
from omniproof.report.fragments import Chapter, Fragment, Overview
from omniproof.report.fragments.overview import read_edition
from omniproof.report.validate import validate_book
from omniproof.settings import read_settings

ROOT = Path(__file__).parents[2]
RESULTS = ROOT / "tests" / "report" / "fixtures" / "results"
BUILT = ROOT / "book" / "_build" / "html"
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
HARNESS = (Path(__file__).parent / "harness.html").read_text(encoding="utf-8")
FILES = ("ledger.csv", "findings.csv", "findings.json", "theorems.json", "references.bib")
USUAL = ("[PST]", "[togglebutton]")  # what the theme tells the console on every page


def write_notebook(path: Path, title: str, *fragments: Fragment) -> None:
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
    chapter = [paper.counts(), paper.table("tab:2["), paper.figure(5), paper.all_theorems()]
    pages: dict[str, list[Fragment]] = {
        "index": [all_papers.counts(), all_papers.most_consequential()],
        "findings": [all_papers.findings()],
        "omni-arrangement": [*chapter, paper.rest()],
    }
    for name in read_settings(Path("workflow/config.yaml"), root=ROOT).chapters:
        pages.setdefault(name, [])  # the table of contents names it
    for name, fragments in pages.items():
        write_notebook(folder / "notebooks" / f"{name}.ipynb", name, *fragments)
    (folder / "ledger.csv").write_text("paper\n")
    (folder / "corrigenda").mkdir()
    (folder / "corrigenda" / "omni-arrangement.pdf").write_text("a corrigendum\n")
    return folder


@pytest.fixture(scope="session")
def small(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the book of the project around the small results."""
    folder = tmp_path_factory.mktemp("book")
    stage(ROOT / "book", small_results(folder / "results"), folder / "source")
    build(folder / "source", folder / "html")
    return folder / "html"


@pytest.fixture(params=["small", "built"])
def pages(request: pytest.FixtureRequest) -> Path:
    """Give the small report, then the real one where `make` has built it."""
    if request.param == "small":
        return Path(request.getfixturevalue("small"))
    if not (BUILT / "index.html").is_file():
        pytest.skip("book/_build/html is not built: run `make`")
    if newest_source() > (BUILT / "index.html").stat().st_mtime:
        pytest.skip("book/_build/html is older than its sources: run `make`")
    return BUILT


def newest_source() -> float:
    """Return when what the report is made of was last changed."""
    globs = ("book/*.*", "book/_[es]*/*.*", "notebooks/*.md", "workflow/omniproof/**/*.py")
    return max(path.stat().st_mtime for pattern in globs for path in ROOT.glob(pattern))


def test_report_keeps_its_promises(pages: Path) -> None:
    results = RESULTS if pages != BUILT else ROOT / "results"
    validate_book(pages, read_ledgers(results))


def test_no_page_names_a_folder_of_this_machine(pages: Path) -> None:
    for page in [*pages.glob("*.html"), *pages.glob("*.js"), *pages.glob("*.json")]:
        text = page.read_text(encoding="utf-8")
        assert str(ROOT) not in text, page.name
        assert not re.search(r"(?:/home|/root|/tmp|/Users)/", text), page.name


def test_data_lies_beside_the_pages(pages: Path) -> None:
    for name in FILES:
        assert (pages / name).is_file(), name
    assert list((pages / "figures").glob("*/figure-*.csv"))


def look(pages: Path, folder: Path) -> tuple[list[dict[str, Any]], list[str]]:
    """Open every page in a browser, 360 px wide; return what it found and its console lines."""
    if CHROMIUM is None:
        pytest.skip("no chromium on this machine")
    names = sorted(path.name for path in pages.glob("*.html"))
    text = HARNESS.replace("PAGES", json.dumps(names)).replace("ROOT", f"{pages.as_uri()}/")
    (folder / "harness.html").write_text(text, encoding="utf-8")
    options = ["--headless", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files"]
    talk = ["--enable-logging=stderr", "--virtual-time-budget=120000", "--dump-dom"]
    profile = f"--user-data-dir={folder / 'profile'}"
    run = subprocess.run(
        [CHROMIUM, *options, *talk, profile, (folder / "harness.html").as_uri()],
        capture_output=True,
        text=True,
        check=True,
        timeout=120,
    )
    found = re.search(r'<pre id="report">(.*?)</pre>', run.stdout, re.DOTALL)
    assert found, run.stdout[:500]
    console = re.findall(r"CONSOLE[^\"]*\"(.*)\", source", run.stderr)
    return json.loads(markup.unescape(found[1])), console


def test_browser_shows_every_page(pages: Path, tmp_path: Path) -> None:
    """Formulas are typeset, nothing is wider than a phone, the console is quiet."""
    found, console = look(pages, tmp_path)
    assert [line for line in console if not line.startswith(USUAL)] == []
    assert {page["name"] for page in found} >= {"index.html", "omni-arrangement.html"}
    for page in found:
        assert page["errors"] == [], page["name"]
        assert page["bare"] == [], page["name"]
        assert page["width"] <= 360, page["name"]
    assert max(page["formulas"] for page in found) > 20


def test_browser_finds_what_is_wrong(small: Path, tmp_path: Path) -> None:
    """The test above can fail: a formula with an error, one that is not set, a wide box."""
    broken = tmp_path / "html"
    shutil.copytree(small, broken)
    page = broken / "index.html"
    wrong = (
        '<span class="math">\\(\\frac{1}\\)</span><span class="math">x</span>'
        '<div style="width: 900px">wide</div><script>console.error("trouble")</script></article>'
    )
    text = page.read_text(encoding="utf-8")
    page.write_text(text.replace("</article>", wrong, 1), encoding="utf-8")
    found, console = look(broken, tmp_path)
    (index,) = (page for page in found if page["name"] == "index.html")
    assert any("frac" in error for error in index["errors"])
    assert index["bare"] == ["x"]
    assert index["width"] > 360
    assert "trouble" in console


@pytest.mark.parametrize(
    "paper", sorted(p.parent.name for p in ROOT.glob("paper_data/*/paper.yaml"))
)
def test_bibliography_has_every_paper(paper: str) -> None:
    edition = read_edition(ROOT / "paper_data" / paper)
    text = (ROOT / "book" / "references.bib").read_text(encoding="utf-8")
    assert edition.title in text
    assert edition.year is None or f"{{{edition.year}}}" in text


def test_two_builds_give_the_same_bytes(small: Path, tmp_path: Path) -> None:
    stage(ROOT / "book", small_results(tmp_path / "elsewhere"), tmp_path / "deep" / "source")
    build(tmp_path / "deep" / "source", tmp_path / "deep" / "html")
    assert different(filecmp.dircmp(small, tmp_path / "deep" / "html")) == []


def different(pair: filecmp.dircmp[str]) -> list[str]:
    """Return the files that differ or stand on one side only, byte for byte."""
    _, wrong, odd = filecmp.cmpfiles(pair.left, pair.right, pair.common_files, shallow=False)
    below = [name for sub in pair.subdirs.values() for name in different(sub)]
    return [*wrong, *odd, *pair.left_only, *pair.right_only, *below]


def test_a_failed_build_names_the_fault_and_keeps_the_old_report(tmp_path: Path) -> None:
    stage(ROOT / "book", small_results(tmp_path / "results"), tmp_path / "source")
    (tmp_path / "source" / "method.md").write_text("# Method\n\n{ref}`nowhere`\n")
    (tmp_path / "html").mkdir()
    (tmp_path / "html" / "index.html").write_text("old")
    with pytest.raises(BookError) as caught:
        build(tmp_path / "source", tmp_path / "html")
    assert "method.md:3: WARNING: undefined label: 'nowhere'" in str(caught.value)
    assert str(tmp_path) not in str(caught.value)
    assert (tmp_path / "html" / "index.html").read_text() == "old"


def test_nothing_executed_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(BookError, match="no executed notebook"):
        stage(ROOT / "book", tmp_path, tmp_path / "source")
