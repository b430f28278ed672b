"""The crate: every file with its checksum, nothing that is not there, nothing of this machine."""

from __future__ import annotations

import json
import subprocess
from hashlib import sha256
from pathlib import Path
from typing import Any

import pydantic
import pytest

from omniproof.report.crate import NAME, Run, crate, versions
from omniproof.report.revision import Revision, read_revision
from omniproof.transcription.model import Edition

ROOT = Path(__file__).parents[2]
BUILT = ROOT / "book" / "_build" / "html"
EDITION = Edition(
    title="On wheels", authors=("A. Author", "B. Author"), year=2023, venue="A Journal",
    source="p.txt", sha256="ab" * 32,
)  # fmt: skip
REVISION = Revision("c0ffee", "2024-05-06T07:08:09+00:00")


def by_id(text: str) -> dict[str, Any]:
    return {entity["@id"]: entity for entity in json.loads(text)["@graph"]}


def wrong_files(html: Path, entities: dict[str, Any]) -> list[str]:
    """Return the files of a crate that are missing or not as it says."""
    files = [entity for entity in entities.values() if entity["@type"] == "File"]
    return [
        entity["@id"]
        for entity in files
        if not (html / entity["@id"]).is_file()
        or sha256((html / entity["@id"]).read_bytes()).hexdigest() != entity["sha256"]
        or (html / entity["@id"]).stat().st_size != int(entity["contentSize"])
    ]


def references(value: Any) -> list[str]:
    """Return every id that something below a value refers to."""
    if isinstance(value, dict):
        own = [value["@id"]] if set(value) == {"@id"} else []
        return own + [found for item in value.values() for found in references(item)]
    items = value if isinstance(value, list) else []
    return [found for item in items for found in references(item)]


@pytest.fixture
def html(tmp_path: Path) -> Path:
    folder = tmp_path / "html"
    names = ("index.html", "findings.json", "findings.schema.json", "corrigenda/p.pdf",
             "tables/p/table-1.csv", "_static/theme.css", ".part-x/half", NAME)  # fmt: skip
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(name)
    return folder


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    Path("paper.yaml").write_text("key: p\n")
    return Run(REVISION, {"sympy": "1.14.0"}, (Path("paper.yaml"),), {"p": EDITION})


def test_the_files_are_those_of_the_report(html: Path, run: Run) -> None:
    entities = by_id(crate(html, run))
    files = [name for name, entity in entities.items() if entity["@type"] == "File"]
    assert files == ["corrigenda/p.pdf", "findings.json", "findings.schema.json", "index.html",
                     "tables/p/table-1.csv"]  # fmt: skip
    assert wrong_files(html, entities) == []
    assert [part["@id"] for part in entities["./"]["hasPart"]] == files


def test_what_it_refers_to_is_described(html: Path, run: Run) -> None:
    entities = by_id(crate(html, run))
    outside = {"https://w3id.org/ro/crate/1.1"}
    assert set(references([*entities.values()])) - set(entities) == outside


@pytest.mark.parametrize(
    ("entity", "expected"),
    [
        pytest.param(NAME, {"about": {"@id": "./"},
                            "conformsTo": {"@id": "https://w3id.org/ro/crate/1.1"}}, id="standard"),
        pytest.param("./", {"datePublished": "2024-05-06T07:08:09+00:00"}, id="date of the commit"),
        pytest.param("#omniproof", {"softwareVersion": "c0ffee"}, id="commit"),
        pytest.param("#package/sympy", {"version": "1.14.0"}, id="version"),
        pytest.param("#text/p", {"sha256": "ab" * 32}, id="source text"),
        pytest.param("#input/paper.yaml", {"sha256": sha256(b"key: p\n").hexdigest()}, id="input"),
        pytest.param("#paper/p", {"name": "On wheels", "datePublished": "2023"}, id="paper"),
        pytest.param("findings.json", {"conformsTo": {"@id": "findings.schema.json"}}, id="schema"),
        pytest.param("corrigenda/p.pdf", {"about": {"@id": "#paper/p"},
                                          "encodingFormat": "application/pdf"}, id="corrigendum"),
    ],
)  # fmt: skip
def test_what_it_says(html: Path, run: Run, entity: str, expected: dict[str, Any]) -> None:
    found = by_id(crate(html, run))[entity]
    assert {key: found[key] for key in expected} == expected


def test_same_text_twice_and_no_path_of_this_machine(html: Path, run: Run) -> None:
    assert crate(html, run) == crate(html, run)
    assert str(html) not in crate(html, run)


def test_outside_of_a_clone_there_is_no_date(html: Path, run: Run) -> None:
    entities = by_id(crate(html, Run(Revision(), run.packages, run.inputs, run.papers)))
    assert "datePublished" not in entities["./"]
    assert "softwareVersion" not in entities["#omniproof"]


def test_versions_are_those_installed() -> None:
    found = versions("# a remark\npydantic==0.0.1  # another\nno-such-package\n-c other.txt\n")
    assert set(found) == {"Python", "pydantic"}
    assert found["pydantic"] == pydantic.VERSION


def git(folder: Path, *arguments: str) -> None:
    author = ["-c", "user.name=a", "-c", "user.email=a@b"]
    subprocess.run(["git", *author, *arguments], cwd=folder, check=True, capture_output=True)


def test_revision_names_the_commit_and_whether_files_were_changed(tmp_path: Path) -> None:
    assert read_revision(tmp_path) == Revision()
    git(tmp_path, "init")
    assert read_revision(tmp_path) == Revision()
    (tmp_path / "a").write_text("1")
    git(tmp_path, "add", "a")
    git(tmp_path, "commit", "-m", "a", "--date=2020-01-01T00:00:00Z")
    clean = read_revision(tmp_path)
    assert len(clean.commit) == 40
    assert clean.date
    (tmp_path / "a").write_text("2")
    assert read_revision(tmp_path).commit == f"{clean.commit}-dirty"


def test_built_crate_describes_the_built_report() -> None:
    if not (BUILT / NAME).is_file():
        pytest.skip("book/_build/html has no crate: run `make`")
    entities = by_id((BUILT / NAME).read_text(encoding="utf-8"))
    assert wrong_files(BUILT, entities) == []
    assert {"index.html", "findings.json", "references.bib"} <= set(entities)
