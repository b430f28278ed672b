"""Whether anything of a paper is left out: source text, inventory and claims against each other."""

from __future__ import annotations

import shutil
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import pytest

from omniproof.report.anchors import anchor, unique_anchors
from omniproof.transcription.faults import Fault
from omniproof.transcription.inventory import Row, compare, load_inventory
from omniproof.transcription.loader import LoadedPaper, load_paper
from omniproof.transcription.model import Claim, Kind
from omniproof.transcription.verbatim import missing, source_text, sources_folder

DATA = Path(__file__).parents[2] / "paper_data"
PAPERS = sorted(file.parent.name for file in DATA.glob("*/inventory.csv"))


@pytest.fixture(scope="module", params=PAPERS)
def folder(request: pytest.FixtureRequest) -> Path:
    """Return the folder of each paper that has an inventory."""
    return DATA / str(request.param)


@pytest.fixture(scope="module")
def paper(folder: Path) -> LoadedPaper:
    return load_paper(folder)


@pytest.fixture(scope="module")
def rows(folder: Path) -> tuple[Row, ...]:
    return load_inventory(folder / "inventory.csv")


@pytest.fixture(scope="module")
def source(paper: LoadedPaper) -> str:
    """Return the source text; skips where it is absent, since it may not be distributed."""
    text = source_text(paper)
    if text is None:
        name = paper.paper.edition.source
        pytest.skip(f"{name} is not in {sources_folder()}: set OMNIPROOF_SOURCES to its folder")
    return text


def messages(faults: Iterable[Fault]) -> list[str]:
    """Return the faults in words, so that a failing test shows them."""
    return [str(fault) for fault in faults]


def without(paper: LoadedPaper, claim: Claim) -> LoadedPaper:
    """Return the paper without one of its claims."""
    kept = tuple(other for other in paper.claims if other.id != claim.id)
    positions = {key: place for key, place in paper.positions.items() if key != claim.id}
    return replace(paper, claims=kept, positions=positions)


def test_every_paper_has_an_inventory() -> None:
    assert sorted(file.parent.name for file in DATA.glob("*/paper.yaml")) == PAPERS


def test_claims_and_inventory_name_each_other(paper: LoadedPaper, rows: tuple[Row, ...]) -> None:
    assert messages(compare(rows, paper)) == []


def test_the_inventory_lists_what_the_source_prints(
    paper: LoadedPaper, rows: tuple[Row, ...], source: str
) -> None:
    assert messages(compare(rows, paper, source)) == []


def test_every_row_has_claims_or_a_reason(rows: tuple[Row, ...]) -> None:
    assert [row for row in rows if bool(row.claims) == bool(row.reason.strip())] == []


def test_every_transcription_is_verbatim(paper: LoadedPaper, source: str) -> None:
    assert messages(missing(paper, source)) == []


def test_every_claim_has_an_address_of_its_own(paper: LoadedPaper) -> None:
    addresses = unique_anchors(claim.id for claim in paper.claims)
    assert len(set(addresses.values())) == len(paper.claims)


def test_places_of_one_comparison_name_each_other(paper: LoadedPaper) -> None:
    pairs = {
        (claim.id, other)
        for claim in paper.claims
        if claim.kind is Kind.CONSISTENCY
        for other in claim.agrees_with
    }
    compared = {claim.id for claim in paper.claims if claim.kind is Kind.CONSISTENCY}
    assert [p for p in sorted(pairs) if p[1] in compared and (p[1], p[0]) not in pairs] == []


def test_no_claim_of_the_inventory_can_go(paper: LoadedPaper, rows: tuple[Row, ...]) -> None:
    named = {claim for row in rows for claim in row.claims}
    for claim in (claim for claim in paper.claims if claim.id in named):
        faults = messages(compare(rows, without(paper, claim)))
        assert faults
        assert all(f"expected the id of a claim, found '{claim.id}'" in f for f in faults)


def test_no_row_can_go(paper: LoadedPaper, rows: tuple[Row, ...], source: str) -> None:
    for row in rows[:: max(1, len(rows) // 20)]:
        kept = [other for other in rows if other is not row]
        faults = messages(compare(kept, paper, source))
        assert any(f"expected a row for {row.item} of line {row.line}" in f for f in faults)


def test_an_item_of_the_source_cannot_go(
    paper: LoadedPaper, rows: tuple[Row, ...], source: str
) -> None:
    faults = messages(compare(rows, paper, f"{source}\nwhich is the smallest of all 17"))
    last = source.count("\n") + 2
    for item in ("comparison-1", "comparison-2", "numeral-1"):
        assert any(f"expected a row for {item} of line {last}" in fault for fault in faults)
    assert len(faults) == 3


def test_a_mended_misprint_is_not_verbatim(folder: Path, source: str, tmp_path: Path) -> None:
    shutil.copytree(folder, tmp_path / "paper")
    file = tmp_path / "paper" / "paper.yaml"
    loaded = load_paper(folder)
    claim = next(c for c in loaded.claims if c.kind is Kind.EDITORIAL and c.quote)
    text = file.read_text(encoding="utf-8")
    assert f"'{claim.quote}'" in text
    file.write_text(text.replace(f"'{claim.quote}'", "'mended'"), encoding="utf-8")
    faults = messages(missing(load_paper(tmp_path / "paper"), source))
    assert len(faults) >= 1
    assert f"claims[{claim.id}].quote" in faults[0]


def test_another_source_text_is_refused(paper: LoadedPaper, source: str) -> None:
    faults = messages(missing(paper, source + "\n"))
    assert "edition.sha256" in faults[0]


def test_two_claims_with_one_address_are_found(paper: LoadedPaper) -> None:
    first = paper.claims[0].id
    twin = first.replace(":", "/", 1)
    assert anchor(twin) == anchor(first)
    with pytest.raises(ValueError, match="claims with the same address"):
        unique_anchors([*(claim.id for claim in paper.claims), twin])
