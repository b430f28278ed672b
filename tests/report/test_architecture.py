"""The pictures of the project: read from rules and imports, and true to the design."""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest

from omniproof.report.architecture import (
    Graph,
    import_graph,
    parts,
    read_rule_files,
    rule_graph,
)
from omniproof.report.architecture_figures import (
    DRAWN,
    IMPLIED,
    draw_graph,
    drawings,
    graph_data,
    one_way,
)

ROOT = Path(__file__).parents[2]
DOT = """digraph snakemake_dag {
    node[shape=box, style=rounded];
    0[label = "all", color = "0.00 0.6 0.85"];
    1[label = "pages", color = "0.28 0.6 0.85"];
    2[label = "figures_one", color = "0.03 0.6 0.85"];
    3[label = "figures_two_more", color = "0.62 0.6 0.85"];
    1 -> 0
    2 -> 1
    3 -> 1
}
"""
FIGURES = '''"""
This part of the workflow draws.

REQUIRED INPUTS:
    drawings = code/{paper}/figures*

OUTPUTS:
    pictures = results/{paper}.svg
"""

for paper in papers:

    rule:
        """Draw"""
        name:
            f"figures_{paper}"
        input:
            drawings=paper_module(paper),
        output:
            pictures=pictures_of(paper),
'''
PAGES = '''"""
This part of the workflow writes pages.

REQUIRED INPUTS:
    config   = settings/config.yaml
    pictures = results/{paper}.svg
    text     = words/*

OUTPUTS:
    page = results/page.html
"""


rule pages:
    """Write"""
    input:
        config="settings/config.yaml",
        pictures=expand("results/{paper}.svg"),
        text=words(),
    output:
        page="results/page.html",
'''


@pytest.fixture
def rules(tmp_path: Path) -> Path:
    (tmp_path / "figures.smk").write_text(FIGURES)
    (tmp_path / "pages.smk").write_text(PAGES)
    (tmp_path / "common.smk").write_text('"""Settings."""\n')
    return tmp_path


def test_rule_files_are_read(rules: Path) -> None:
    figures, pages = read_rule_files(rules)
    assert (figures.name, figures.purpose, figures.families) == ("figures", "draws", ("figures",))
    assert figures.sources == (("code/", "figures"),)
    assert (pages.families, pages.sources) == (("pages",), (("words/", "pages"),))


def test_rules_of_a_family_are_one_node(rules: Path) -> None:
    graph = rule_graph(DOT, read_rule_files(rules))
    assert graph.groups == {
        "code/": "sources", "words/": "sources", "pages": "pages", "figures × 2": "figures",
    }  # fmt: skip
    assert graph.arrows == {
        ("figures × 2", "pages"): 2, ("code/", "figures × 2"): 1, ("words/", "pages"): 1,
    }  # fmt: skip


def test_imports_are_counted(tmp_path: Path) -> None:
    package = tmp_path / "pack"
    for name, text in {
        "__init__.py": '"""Outside."""\nfrom pack.low import x\n',
        "low/__init__.py": '"""Below. And more."""\n',
        "low/one.py": "import os\nfrom pack.low.two import x\n",
        "top.py": '"""Above\nall. More."""\nimport pack.low.one\nif 1:\n from pack import low\n',
    }.items():
        (package / name).parent.mkdir(parents=True, exist_ok=True)
        (package / name).write_text(text)
    graph = import_graph(package)
    assert graph.groups == {"low": "package", "top": "module"}
    assert graph.arrows == {("top", "low"): 1}
    assert parts(package) == (("low", "Below."), ("top.py", "Above all."))


def test_the_engine_knows_no_paper_and_mechanics_no_print() -> None:
    """The design, section 1: data moves down only."""
    graph = import_graph(ROOT / "workflow" / "omniproof")
    known = {start: {b for a, b in graph.arrows if a == start} for start in graph.groups}
    assert known["audit"] <= {
        "decide", "formula", "repair", "transcription", "registry", "visible"
    }  # fmt: skip
    assert known["decide"] == {"formula"}, "engines know no paper, and no other engine's door"
    assert known["formula"] == {"transcription"}, "the language knows no engine"
    assert known["transcription"] <= {"visible", "formula"}, "of which the table of functions"
    assert known["visible"] == set()
    assert not known["kinematics"] & {"papers", "report", "transcription"}
    assert "kinematics" in known["papers"]
    assert not known["papers"] & {"report", "simulation", "figures"}
    assert not known["simulation"] & {"report", "figures"}


def test_of_two_arrows_between_the_same_nodes_the_heavier_is_drawn() -> None:
    assert one_way({("a", "b"): 3, ("b", "a"): 1, ("b", "c"): 1}) == [("a", "b"), ("b", "c")]
    assert one_way({("a", "b"): 1, ("b", "a"): 1}) in ([("a", "b")], [("b", "a")])


def test_arrows_that_others_imply_are_data_and_not_drawn() -> None:
    graph = Graph(dict.fromkeys("abc", "group"), {("a", "b"): 3, ("b", "c"): 1, ("a", "c"): 2})
    frame = graph_data(graph)
    drawn = frame[frame["panel"] == DRAWN]
    assert list(drawn["series"].unique()) == ["a → b", "b → c"]
    assert list(drawn[drawn["series"] == "a → b"]["z"]) == [3, 3]
    assert list(frame[frame["panel"] == IMPLIED]["series"].unique()) == ["a → c"]
    figure = draw_graph(frame)
    names = [text.get_text() for text in figure.axes[0].texts]
    assert sorted(names) == ["a", "b", "c"]
    assert len(figure.axes[0].lines) == 2


def test_the_project_draws_itself() -> None:
    """Snakemake is asked; both pictures say in words what they show."""
    rules, modules = drawings(ROOT)
    seen = [rules.data(), modules.data()]
    assert all(isinstance(frame, pd.DataFrame) and not frame.isna()["x"].any() for frame in seen)
    in_words = rules.describe(seen[0])
    assert "paper_data/ leads to audit" in in_words
    assert "validate leads to summary" in in_words
    assert "→" not in in_words
    assert "cli leads to" in modules.describe(seen[1])
