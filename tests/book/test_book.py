"""The report as a folder of files: complete, the same every time, and sound or not there at all."""

from __future__ import annotations

import filecmp
import re
from pathlib import Path

import pytest
from small_report import RESULTS, ROOT, small_results

from omniproof.audit.ledger import read_ledgers
from omniproof.report.book import BookError, build, stage
from omniproof.report.fragments.overview import read_edition
from omniproof.report.validate import validate_book

FILES = ("ledger.csv", "findings.csv", "findings.json", "theorems.json", "references.bib",
         "notebooks/derivation.ipynb")  # fmt: skip


def test_report_keeps_its_promises(pages: Path) -> None:
    results = ROOT / "results" if pages.is_relative_to(ROOT) else RESULTS
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


@pytest.mark.parametrize(
    "paper", sorted(p.parent.name for p in ROOT.glob("paper_data/*/paper.yaml"))
)
def test_bibliography_and_readme_have_every_paper(paper: str) -> None:
    edition = read_edition(ROOT / "paper_data" / paper)
    text = (ROOT / "book" / "references.bib").read_text(encoding="utf-8")
    assert edition.title in text
    (line,) = (x for x in (ROOT / "README.md").read_text().splitlines() if f"| `{paper}` |" in x)
    assert f"*{edition.title}*" in line
    assert edition.year is None or f"{{{edition.year}}}" in text


def test_two_builds_give_the_same_bytes(small: Path, tmp_path: Path) -> None:
    stage(
        ROOT / "book",
        small_results(tmp_path / "elsewhere"),
        ROOT / "paper_data",
        tmp_path / "deep" / "source",
    )
    build(tmp_path / "deep" / "source", tmp_path / "deep" / "html")
    assert different(filecmp.dircmp(small, tmp_path / "deep" / "html")) == []


def test_theorems_have_a_number_an_address_and_a_proof_that_unfolds(small: Path) -> None:
    text = (small / "omni-arrangement.html").read_text(encoding="utf-8")
    (theorem,) = re.findall(
        r'<div class="[^"]*theorem[^"]*" id="thm-one-measure">.*?</details>', text, re.S
    )
    assert re.search(r"Theorem 1\b", theorem)
    assert '<details class="proof"><summary>Proof</summary>' in theorem
    assert theorem.count("<li>") == 2
    assert "Proof. " not in theorem


def different(pair: filecmp.dircmp[str]) -> list[str]:
    """Return the files that differ or stand on one side only, byte for byte."""
    _, wrong, odd = filecmp.cmpfiles(pair.left, pair.right, pair.common_files, shallow=False)
    below = [name for sub in pair.subdirs.values() for name in different(sub)]
    return [*wrong, *odd, *pair.left_only, *pair.right_only, *below]


def test_a_failed_build_names_the_fault_and_keeps_the_old_report(tmp_path: Path) -> None:
    stage(
        ROOT / "book", small_results(tmp_path / "results"), ROOT / "paper_data", tmp_path / "source"
    )
    (tmp_path / "source" / "bibliography.md").write_text("# Bibliography\n\n{ref}`nowhere`\n")
    (tmp_path / "html").mkdir()
    (tmp_path / "html" / "index.html").write_text("old")
    with pytest.raises(BookError) as caught:
        build(tmp_path / "source", tmp_path / "html")
    assert "bibliography.md:3: WARNING: undefined label: 'nowhere'" in str(caught.value)
    assert str(tmp_path) not in str(caught.value)
    assert (tmp_path / "html" / "index.html").read_text() == "old"


def test_nothing_executed_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(BookError, match="no executed notebook"):
        stage(ROOT / "book", tmp_path, ROOT / "paper_data", tmp_path / "source")
