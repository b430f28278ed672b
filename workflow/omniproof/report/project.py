"""What a page says of the project itself, to cite a claim and to report a wrong verdict.

It comes from `CITATION.cff`, by its own names: `title`, `authors`, `version`; reports go to the
issues of `repository-code`, else to the first `contact` with an `email`, else nowhere.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml


def project_script(citation: Path) -> str:
    """Return a script with title, authors, version and where reports go (`window.PROJECT`)."""
    known: Mapping[str, Any] = yaml.safe_load(citation.read_text(encoding="utf-8"))
    data = {
        "title": known["title"],
        "authors": " and ".join(map(_name, known["authors"])),
        "version": known["version"],
        "reports": reports_to(known),
    }
    text = json.dumps(data, ensure_ascii=False).replace("<", "\\u003c")
    return f"window.PROJECT = {text};\n"


def reports_to(citation: Mapping[str, Any]) -> str:
    """Return the address of a new issue, or of a mail; nothing where neither is known."""
    repository = str(citation.get("repository-code", "")).rstrip("/")
    if repository.startswith("https://"):
        return f"{repository}/issues/new"
    mails = (person.get("email", "") for person in citation.get("contact", ()))
    mail = next(filter(None, mails), "")
    return f"mailto:{mail}" if mail else ""


def _name(author: Mapping[str, str]) -> str:
    own = f"{author.get('given-names', '')} {author.get('family-names', '')}".strip()
    return own or author["name"]
