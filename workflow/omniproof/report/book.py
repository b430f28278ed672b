"""The book: stage its sources in one folder, build the pages in another, replace the old ones last.

Jupyter Book runs in a process of its own: Sphinx keeps state in the interpreter, and its log is
worth reading only when it fails. Pages are built beside the old ones and take their place when all
went well, so that a failed build leaves an earlier report untouched.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from omniproof.audit.ledger import Ledger, read_ledgers, schema
from omniproof.recovery import list_files
from omniproof.report.code_pages import write_code
from omniproof.report.findings import findings_csv, findings_json, findings_schema
from omniproof.report.finish import finish
from omniproof.report.fragments.rows import write_details
from omniproof.report.project import project_script
from omniproof.report.search_index import claims_script
from omniproof.report.theme import stylesheet

DATA = (
    "ledger.csv", "theorems.json", "tables", "figures", "simulation", "corrigenda", "notebooks",
)  # fmt: skip
"""What the site offers for download, as it lies in the folder of results."""


_COLOUR = re.compile(r"\x1b\[[0-9;]*m")


class BookError(RuntimeError):
    """The book was not built; the message is what a person needs to mend it."""


def stage(book: Path, results: Path, papers: Path, source: Path) -> None:
    """Lay the book's pages, the executed notebooks and the data into a fresh folder `source`.

    book: folder with `_config.yml`, `_toc.yml` and the front matter; results: with `ledger/`,
    `notebooks/`, `figures/` and `tables/`; papers: what they print. Raises `BookError` when nothing
    was executed.
    """
    notebooks = sorted((results / "notebooks").glob("*.ipynb"))
    if not notebooks:
        raise BookError(f"no executed notebook in {results / 'notebooks'}")
    shutil.rmtree(source, ignore_errors=True)
    shutil.copytree(book, source, ignore=shutil.ignore_patterns("_build", "__pycache__"))
    for notebook in notebooks:
        shutil.copyfile(notebook, source / notebook.name)
    ledgers = read_ledgers(results)
    written = {
        "_static/verdicts.css": stylesheet(),
        "_static/project.js": project_script(book.parent / "CITATION.cff"),
        "_search/search-claims.js": claims_script(ledgers, papers),
    }
    for name, text in written.items():
        (source / name).write_text(text, encoding="utf-8")
    _stage_data(results, ledgers, source / "extra")
    for bibliography in sorted(book.glob("*.bib")):
        shutil.copyfile(bibliography, source / "extra" / bibliography.name)


def _stage_data(results: Path, ledgers: Sequence[Ledger], extra: Path) -> None:
    """Copy what the site offers for download, and write the findings and the code."""
    extra.mkdir()
    for name in DATA:
        origin = results / name
        if origin.is_dir():
            shutil.copytree(origin, extra / name)
        elif origin.is_file():
            shutil.copyfile(origin, extra / name)
    texts = {
        "findings.csv": findings_csv(ledgers),
        "findings.json": findings_json(ledgers),
        "findings.schema.json": findings_schema(),
        "ledger.schema.json": schema(),
    }
    for name, text in texts.items():
        (extra / name).write_text(text, encoding="utf-8")
    write_details(extra, ledgers)
    write_code(extra)


def build(source: Path, html: Path) -> None:
    """Build the pages of a staged book into the folder `html`, warnings being errors.

    `files.txt` beside it lists them, so that a lost one is noticed.

    Raises `BookError` with the warnings and errors of the build; `html` is then as it was.
    """
    work = html.parent / ".work"
    shutil.rmtree(work, ignore_errors=True)
    run = subprocess.run(  # noqa: S603 - our own interpreter, no shell
        _command(source, work), capture_output=True, text=True, check=False, env=_environment()
    )
    pages = work / "_build" / "html"
    if run.returncode or not (pages / "index.html").is_file():
        raise BookError(_complaints(run.stdout + run.stderr, source))
    (pages / ".buildinfo").unlink(missing_ok=True)
    finish(pages)
    list_files(pages, html.parent / "files.txt")
    if html.exists():
        html.rename(work / "earlier")  # so that a report which stands is always a whole one
    pages.rename(html)
    shutil.rmtree(work)


def _command(source: Path, work: Path) -> list[str]:
    start = "import sys; from jupyter_book.cli.main import main; sys.exit(main())"
    options = ["-W", "--keep-going", "-q", "--path-output", str(work)]
    return [sys.executable, "-c", start, "build", str(source), *options]


def _environment() -> dict[str, str]:
    """Return the environment of a build that gives the same bytes every time."""
    return os.environ | {"PYTHONHASHSEED": "0", "NO_COLOR": "1", "LC_ALL": "C.UTF-8"}


def _complaints(log: str, source: Path) -> str:
    """Return the lines of a log that say what is wrong, without the path of this machine."""
    bare = _COLOUR.sub("", log)
    lines = bare.replace(f"{source.resolve()}/", "").replace(f"{source}/", "").splitlines()
    wrong: Iterable[str] = [x for x in lines if "WARNING" in x or "ERROR" in x or "rror:" in x]
    return "the book was not built:\n" + "\n".join(list(dict.fromkeys(wrong)) or lines[-20:])
