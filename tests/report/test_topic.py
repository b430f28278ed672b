"""A topic of several papers, and the list of what papers assume and do not state."""

from __future__ import annotations

from pathlib import Path
from shutil import copytree

import pytest

from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.report.fragments import Overview, Topic
from omniproof.report.fragments.assumptions import assumptions, assumptions_html
from omniproof.transcription.model import Kind


def row(claim: str, verdict: str, assumption: str = "", follows: str = "", note: str = "") -> Row:
    return Row(
        paper="one-wheel",
        id=claim,
        where=claim,
        kind=Kind.IDENTITY,
        verdict=Verdict(verdict),
        assumption=assumption,
        follows=follows,
        note=note,
    )


def listed(*rows: Row) -> list[tuple[str, str, tuple[str, ...]]]:
    ledger = Ledger(paper="one-wheel", claims=len(rows), rows=rows)
    return [(found.text, str(found.verdict), found.claims) for found in assumptions(ledger)]


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        pytest.param(
            [row("eq:1", "verified", "x > 0"), row("eq:2", "erratum")],
            [],
            id="true and false rows assume nothing",
        ),
        pytest.param(
            [row("eq:1", "conditional", "x > 0"), row("eq:3", "conditional", "x > 0")],
            [("x > 0", "conditional", ("eq:1", "eq:3"))],
            id="one condition, two places",
        ),
        pytest.param(
            [row("eq:1[1,2]", "conditional", "x > 0"), row("eq:1[2,2]", "conditional", "x > 0")],
            [("x > 0", "conditional", ("eq:1",))],
            id="entries of one matrix are one place",
        ),
        pytest.param(
            [
                row("sec:1/law", "model-gap", note="true by the premise"),
                row("eq:1", "model-gap", "it rests", "sec:1/law"),
                row("eq:2", "model-gap", "it rests", "sec:1/law"),
            ],
            [("it rests", "model-gap", ("sec:1/law", "eq:1", "eq:2"))],
            id="the words of what follows from a row are its own",
        ),
        pytest.param(
            [row("eq:1", "conditional", "x > 0"), row("eq:2", "conditional", "x < 1", "eq:1")],
            [("x > 0", "conditional", ("eq:1",)), ("x < 1", "conditional", ("eq:2",))],
            id="another condition stays another",
        ),
        pytest.param(
            [row("sec:1/law", "model-gap", note="true by the premise")],
            [("true by the premise", "model-gap", ("sec:1/law",))],
            id="no words but the note",
        ),
    ],
)
def test_assumptions(rows: list[Row], expected: list[tuple[str, str, tuple[str, ...]]]) -> None:
    assert listed(*rows) == expected


def test_list_names_every_paper_and_escapes(outline: type) -> None:
    full = Ledger(paper="a", claims=1, rows=(row("eq:1", "conditional", r"\text{<b> & so}"),))
    bare = Ledger(paper="b", claims=0, rows=())
    html = assumptions_html([full, bare], {"a": "A", "b": "B"}, {"a": str.upper, "b": str.upper})
    page = outline(html)
    assert page.links == ["EQ:1"]
    assert "None was found." in page.text
    assert "<b>" in page.text


def test_overview_links_to_the_chapter(overview: Overview, root: Path, outline: type) -> None:
    whole = Overview(overview.ledgers, overview.theorems, root / "results")
    page = outline(whole.assumptions().html)
    assert page.links == ["omni-arrangement.html", "omni-arrangement.html#eq-C-6"]


@pytest.fixture
def topic(results: Path, tmp_path: Path) -> Topic:
    """A topic with a drawing by name."""
    copytree(results, tmp_path / "results")
    drawn = tmp_path / "results" / "figures"
    (drawn / "omni-arrangement").rename(drawn / "wheels")
    for suffix in ("svg", "csv"):
        (drawn / "wheels" / f"figure-5.{suffix}").rename(drawn / "wheels" / f"figure-axes.{suffix}")
    about = drawn / "wheels" / "figures.json"
    about.write_text(about.read_text(encoding="utf-8").replace('"number": 5', '"number": "axes"'))
    return Topic.open("wheels", tmp_path / "results")


def test_topic_shows_theorems_and_drawings(topic: Topic, outline: type) -> None:
    assert ":label: thm-one-measure\n" in topic.theorem("thm:one-measure").markdown
    figure = outline(topic.figure("axes").html)
    assert figure.ids[0] == "figure-axes"
    assert figure.links == ["figures/wheels/figure-axes.svg", "figures/wheels/figure-axes.csv"]
    with pytest.raises(KeyError):
        topic.theorem("thm:none")
    with pytest.raises(ValueError, match=r"figures\.json: no figure none"):
        topic.figure("none")


def test_grid_has_its_heads_and_escapes(topic: Topic, outline: type) -> None:
    page = outline(topic.grid(["<i>", "b"], [["$x$", "<u>"]]).html)
    assert page.tags.count("th") == 3
    assert {"i", "u"} & set(page.tags) == set()
