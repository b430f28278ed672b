"""What pages say of the project: whom to cite, and where a wrong verdict is reported."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import yaml

from omniproof.report.project import project_script, reports_to

CITATION = Path(__file__).parents[2] / "CITATION.cff"


def test_the_script_says_what_the_citation_file_says() -> None:
    script = project_script(CITATION)
    data = json.loads(script.removeprefix("window.PROJECT = ").rstrip(";\n"))
    known = yaml.safe_load(CITATION.read_text(encoding="utf-8"))
    assert (data["title"], data["version"]) == (known["title"], known["version"])
    assert data["authors"] == "The omniproof authors"


@pytest.mark.parametrize(
    ("citation", "address"),
    [
        pytest.param({}, "", id="nowhere"),
        pytest.param(
            {"repository-code": "https://host.invalid/a/b/"},
            "https://host.invalid/a/b/issues/new",
            id="issues of the repository",
        ),
        pytest.param(
            {"contact": [{"name": "A"}, {"email": "a@host.invalid"}]},
            "mailto:a@host.invalid",
            id="a mail",
        ),
        pytest.param({"repository-code": "javascript:alert(1)"}, "", id="no other scheme"),
    ],
)
def test_reports_go_where_the_citation_file_says(citation: dict[str, Any], address: str) -> None:
    assert reports_to(citation) == address
