"""A paper of sixteen rows, and a reader of HTML that forgives nothing."""

from __future__ import annotations

from html.parser import HTMLParser
from pathlib import Path

import pytest

from omniproof.audit.ledger import Ledger, read_json
from omniproof.report.fragments import Chapter, Overview

RESULTS = Path(__file__).parent / "fixtures" / "results"
VOID = {"br", "hr", "img", "input", "link", "meta", "path", "rect"}


class Outline(HTMLParser):
    """Tags, ids and text of a fragment; every element has to be closed in its turn."""

    def __init__(self, html: str) -> None:
        super().__init__(convert_charrefs=True)
        self.tags: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.text = ""
        self._open: list[str] = []
        self.feed(html)
        self.close()
        assert self._open == [], f"left open: {self._open}"

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        self.tags.append(tag)
        self.ids += [str(found["id"])] if "id" in found else []
        self.links += [str(found["href"])] if "href" in found else []
        if tag not in VOID:
            self._open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag not in VOID:
            assert self._open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


@pytest.fixture
def results() -> Path:
    return RESULTS


@pytest.fixture
def ledger() -> Ledger:
    return read_json(RESULTS / "ledger" / "omni-arrangement.json")


@pytest.fixture
def chapter() -> Chapter:
    return Chapter.open("omni-arrangement", RESULTS)


@pytest.fixture
def overview() -> Overview:
    return Overview.open(RESULTS)


@pytest.fixture(scope="session")
def outline() -> type[Outline]:
    return Outline
