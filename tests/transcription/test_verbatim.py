"""What is transcribed stands in the source text, on its line."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.model import Reading
from omniproof.transcription.verbatim import (
    FoldedText,
    missing,
    normalise,
    source_text,
    sources_folder,
)


def altered(loaded: LoadedPaper, claim: str, update: dict[str, Any]) -> LoadedPaper:
    claims = tuple(c.model_copy(update=update if c.id == claim else {}) for c in loaded.claims)
    return replace(loaded, claims=claims)


def test_all_is_verbatim(loaded: LoadedPaper, source: str) -> None:
    assert missing(loaded, source) == []


MISPLACED = [
    pytest.param("eq:1", {"latex": (r"q = L \cos \alpha_2",)}, [
        "paper.yaml:14:10: claims[eq:1].latex: expected verbatim text of the source, found "
        r"'q = L \\cos \\alpha_2'",
        "    copy it from line 6 of the source text"], id="a misprint that was mended"),
    pytest.param("eq:1", {"line": 7}, [
        "paper.yaml:14:10: claims[eq:1].latex: expected this on line 7, found it on line 6",
        "    set `line: 6`"], id="another line"),
    pytest.param("eq:1", {"line": 700}, [
        "paper.yaml:14:10: claims[eq:1].latex: expected this on line 700, found it on line 6",
        "    set `line: 6`"], id="a line behind the end"),
    pytest.param("eq:2", {"latex": ("p =", "2 L", r"\cos")}, [
        r"paper.yaml:15:10: claims[eq:2].latex[3]: expected this after line 8, found no '\\cos'",
        "    copy the fragments in the order of the source"], id="fragments in another order"),
    pytest.param("eq:2", {"line": 3, "reading": Reading.GLYPHS}, [], id="glyphs are passed over"),
    pytest.param("sec:2/spelling", {"quote": "all  four"}, [
        "paper.yaml:16:10: claims[sec:2/spelling].quote: expected verbatim text of the source, "
        "found 'all  four'",
        "    copy it from line 3 of the source text"], id="quote"),
    pytest.param("sec:2/name", {"printed": "Type (Y)"}, [
        "paper.yaml:17:10: claims[sec:2/name].printed: expected verbatim text of the source, "
        "found 'Type (Y)'",
        "    copy it from line 14 of the source text"], id="wording of a consistency"),
    pytest.param("tab:2[X,D_V]", {"printed": "3.80"}, [
        "table-2.csv:2:3: claims[tab:2[X,D_V]].printed: expected verbatim text of the source, "
        "found '3.80'",
        "    copy it from line 12 of the source text"], id="cell of a table"),
    pytest.param("sec:1/wheels", {"printed": "4"}, [], id="numbers may be printed as words"),
]  # fmt: skip


@pytest.mark.parametrize(("claim", "update", "lines"), MISPLACED)
def test_misplaced(
    loaded: LoadedPaper, source: str, claim: str, update: dict[str, Any], lines: list[str]
) -> None:
    faults = missing(altered(loaded, claim, update), source)
    assert "\n".join(map(str, faults)).splitlines() == lines


def test_another_text(loaded: LoadedPaper, source: str) -> None:
    fault, *others = missing(loaded, source + " ")
    assert str(fault).startswith("paper.yaml:1:1: edition.sha256: expected the source text with")
    assert others == []


def test_blank_space_is_folded() -> None:
    folded = FoldedText.of("a  b\n\n c\td\n")
    assert folded.text == "a b c d"
    assert [folded.line(at) for at in (0, 2, 4, 6)] == [1, 1, 3, 3]
    assert folded.on_line("b\nc", 1) == 2
    assert folded.on_line("b c", 3) is None
    assert normalise(" a \n b ") == "a b"


def test_sources(
    loaded: LoadedPaper, source: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OMNIPROOF_SOURCES", str(tmp_path / "texts"))
    assert sources_folder() == tmp_path / "texts"
    assert source_text(loaded) is None
    (tmp_path / "texts").mkdir()
    (tmp_path / "texts" / "on-wheels.txt").write_text(source, encoding="utf-8")
    assert source_text(loaded) == source
    monkeypatch.delenv("OMNIPROOF_SOURCES")
    assert sources_folder().parts[-2:] == ("shared", "papers")
