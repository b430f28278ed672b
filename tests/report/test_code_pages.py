"""The code behind a verdict can be opened at its line, in a browser, from disk."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path

import pytest

from omniproof.report.code_pages import PACKAGE, code_link, write_code
from omniproof.settings import module_name, read_settings


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    write_code(folder)
    return folder


def test_link_to_a_line() -> None:
    found = code_link("omniproof/papers/ballbot/derivations/wheels.py:12")
    assert found == "code/papers/ballbot/derivations/wheels.html#L-12"


@pytest.mark.parametrize("line", [1, 20])
def test_a_line_of_a_page_is_that_of_the_file(site: Path, line: int) -> None:
    file = PACKAGE / "papers" / "omni_arrangement" / "derivations" / "kinematics.py"
    page, _, anchor = code_link(f"omniproof/{file.relative_to(PACKAGE)}:{line}").partition("#")
    text = (site / page).read_text(encoding="utf-8")
    (shown,) = re.findall(rf'<span id="{anchor}">(.*)', text)
    expected = file.read_text(encoding="utf-8").splitlines()[line - 1]
    assert unescape(re.sub("<[^>]*>", "", shown)) == expected


def test_every_paper_has_pages(site: Path, root: Path) -> None:
    """Every paper of the settings, however many there are, and nothing that is no paper."""
    papers = read_settings(Path("workflow/config.yaml"), root=root).papers
    folders = {page.parts[-3] for page in site.glob("code/papers/*/derivations/*.html")}
    assert folders == set(map(module_name, papers))


def test_pages_ask_for_nothing_and_lead_home(site: Path) -> None:
    for page in site.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert not re.search(r"<a(?![^>]*>[^<])|<a (?![^>]*href)", text)  # empty, or to nowhere
        assert not re.search(r"src=|url\(|@import", text.split("<body>")[0])
        home, chapter = re.findall(r'<a href="([^"]*\.html)"', text)
        assert (page.parent / home).resolve() == (site / "index.html").resolve()
        paper = page.relative_to(site / "code" / "papers").parts[0].replace("_", "-")
        assert (page.parent / chapter).resolve() == (site / f"{paper}.html").resolve()
