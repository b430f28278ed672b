"""The report as a Research Object Crate: what it was made from, by what, and every checksum.

`ro-crate-metadata.json` beside the pages makes the folder a crate (RO-Crate 1.1,
https://www.researchobject.org/ro-crate/1.1/): programs find what each file is, a reader in ten
years which commit and which versions made it. Dates are those of the commit; nothing is the time
of the run, so that the same commit gives the same bytes.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from importlib import metadata
from pathlib import Path
from platform import python_version
from typing import Any, TypeAlias

from omniproof.report.revision import Revision
from omniproof.transcription.model import Edition

NAME = "ro-crate-metadata.json"
CONTEXT = [
    "https://w3id.org/ro/crate/1.1/context",
    {"sha256": "https://schema.org/sha256"},  # schema.org has it only since RO-Crate 1.1
]
FORMATS: Mapping[str, str] = {
    ".html": "text/html",
    ".csv": "text/csv",
    ".json": "application/json",
    ".svg": "image/svg+xml",
    ".pdf": "application/pdf",
    ".bib": "application/x-bibtex",
    ".ipynb": "application/x-ipynb+json",
    ".js": "text/javascript",
}
ABOUT: Mapping[str, str] = {
    "index.html": "The report: start here",
    "ledger.csv": "Every printed cell of all papers with its verdict",
    "findings.csv": "What is not as it should be",
    "findings.json": "What is not as it should be",
    "findings.schema.json": "JSON Schema of findings.json",
    "ledger.schema.json": "JSON Schema of a paper's ledger",
    "theorems.json": "Results that no paper prints",
    "references.bib": "The papers, for a bibliography",
}
_NAME = re.compile(r"[A-Za-z][\w.-]*")
Entity: TypeAlias = dict[str, Any]


@dataclass(frozen=True)
class Run:
    """What made the report: state of the project, versions by name, files read, papers by key."""

    revision: Revision
    packages: Mapping[str, str]
    inputs: tuple[Path, ...]
    papers: Mapping[str, Edition]


def versions(requirements: str) -> dict[str, str]:
    """Return the installed versions of what a requirements file asks for, and of Python.

    A line that a marker rules out, or that is not installed, is left out.
    """
    names = {found[0] for line in requirements.splitlines() if (found := _NAME.match(line))}
    installed = {name: version for name in names if (version := _version(name))}
    return {"Python": python_version(), **installed}


def _version(package: str) -> str:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return ""


def crate(html: Path, run: Run) -> str:
    """Return the metadata of the report in the folder `html`; the same files, the same text."""
    files = [_file(html, path) for path in _shown(html)]
    inputs = [*_inputs(run.inputs), *_texts(run.papers)]
    graph = [
        _descriptor(),
        _root(files, run),
        *files,
        _action(inputs, files),
        *_software(run),
        *inputs,
        *_articles(run.papers),
        {"@id": "https://spdx.org/licenses/MIT", "@type": "CreativeWork", "name": "MIT License"},
    ]
    document = {"@context": CONTEXT, "@graph": graph}
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def _shown(html: Path) -> Iterator[Path]:
    """Yield the files that are the report's own, sorted: not the theme, nothing hidden."""
    for path in sorted(html.rglob("*")):
        parts = path.relative_to(html).parts
        hidden = any(part.startswith(".") for part in parts)
        if path.is_file() and parts[0] != "_static" and not hidden and path.name != NAME:
            yield path


def _file(html: Path, path: Path) -> Entity:
    name = path.relative_to(html).as_posix()
    entity: Entity = {
        "@id": name,
        "@type": "File",
        "name": ABOUT.get(name, name),
        "contentSize": str(path.stat().st_size),
        "sha256": checksum(path),
    }
    if path.suffix in FORMATS:
        entity["encodingFormat"] = FORMATS[path.suffix]
    if name == "findings.json":
        entity["conformsTo"] = _to("findings.schema.json")
    if path.parent.name == "corrigenda":
        entity["name"] = f"Corrigendum, proposed to the authors of {path.stem}"
        entity["about"] = _to(f"#paper/{path.stem}")
    return entity


def checksum(path: Path) -> str:
    """Return the SHA-256 of a file in hexadecimal digits."""
    return sha256(path.read_bytes()).hexdigest()


def _to(identifier: str) -> Entity:
    return {"@id": identifier}


def _all(entities: Iterable[Entity]) -> list[Entity]:
    return [_to(entity["@id"]) for entity in entities]


def _descriptor() -> Entity:
    return {
        "@id": NAME,
        "@type": "CreativeWork",
        "about": _to("./"),
        "conformsTo": _to("https://w3id.org/ro/crate/1.1"),
    }


def _root(files: Iterable[Entity], run: Run) -> Entity:
    entity: Entity = {
        "@id": "./",
        "@type": "Dataset",
        "name": "omniproof: papers on omnidirectional robots, checked to the last cell",
        "description": "Every equation, table cell, number and statement of the papers with a "
        "verdict that a program computed, the proofs, and corrigenda for the authors.",
        "license": _to("https://spdx.org/licenses/MIT"),
        "about": [_to(f"#paper/{key}") for key in run.papers],
        "hasPart": _all(files),
        "mentions": _to("#run"),
    }
    # The standard asks for this date; outside of a clone there is none that would be true.
    return entity | ({"datePublished": run.revision.date} if run.revision.date else {})


def _action(inputs: Iterable[Entity], files: Iterable[Entity]) -> Entity:
    return {
        "@id": "#run",
        "@type": "CreateAction",
        "name": "Audit of the papers and making of the report",
        "instrument": _to("#omniproof"),
        "object": _all(inputs),
        "result": _all(files),
    }


def _software(run: Run) -> list[Entity]:
    packages = [
        {
            "@id": f"#package/{name}",
            "@type": "SoftwareApplication",
            "name": name,
            "version": version,
        }
        for name, version in sorted(run.packages.items())
    ]
    state = {"softwareVersion": run.revision.commit} if run.revision.commit else {}
    program = {
        "@id": "#omniproof",
        "@type": "SoftwareApplication",
        "name": "omniproof",
        "version": _version("omniproof"),
        **state,
        "softwareRequirements": _all(packages),
    }
    return [program, *packages]


def _inputs(paths: Iterable[Path]) -> list[Entity]:
    """Return what the project itself holds of what was read, by its path in the project."""
    return [
        {
            "@id": f"#input/{path.as_posix()}",
            "@type": "CreativeWork",
            "name": path.as_posix(),
            "sha256": checksum(path),
        }
        for path in sorted(paths)
    ]


def _texts(papers: Mapping[str, Edition]) -> list[Entity]:
    """Return the texts that were transcribed; they are not part of the project."""
    return [
        {
            "@id": f"#text/{key}",
            "@type": "CreativeWork",
            "name": edition.source,
            "description": "Text recognition of the PDF of the paper",
            "isBasedOn": _to(f"#paper/{key}"),
            "sha256": edition.sha256,
        }
        for key, edition in papers.items()
    ]


def _articles(papers: Mapping[str, Edition]) -> list[Entity]:
    articles = [
        {
            "@id": f"#paper/{key}",
            "@type": "ScholarlyArticle",
            "name": edition.title,
            "author": [_to(_person(name)) for name in edition.authors],
            "description": edition.venue,
            **({"datePublished": str(edition.year)} if edition.year else {}),
        }
        for key, edition in papers.items()
    ]
    names = sorted({name for edition in papers.values() for name in edition.authors})
    people = [{"@id": _person(name), "@type": "Person", "name": name} for name in names]
    return [*articles, *people]


def _person(name: str) -> str:
    return f"#person/{name.replace(' ', '-')}"
