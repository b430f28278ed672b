"""The build as a whole, with scripts that only touch their outputs: no paper is audited."""

import re
import site
import sysconfig
import venv
from pathlib import Path

import pytest
from copied import copy_of


def test_second_run_does_nothing(built):
    assert built.steps() == []


@pytest.mark.parametrize(
    "target",
    [
        "results/ledger/omni-arrangement.json",
        "results/tables/omni-arrangement/table-2.csv",
        "results/figures/omni-arrangement/figure-5.svg",
        "results/figures/omni-arrangement/figure-5.csv",
        "results/notebooks/omni-arrangement.ipynb",
        "results/ledger.csv",
        "results/theorems.json",
        "book/_build/html/index.html",
    ],
)
def test_result_is_made(built, target):
    assert (built.folder / target).is_file()


@pytest.mark.parametrize(
    ("file", "first", "never"),
    [
        pytest.param(
            "paper_data/omni-arrangement/paper.yaml",
            {
                "Audit omni-arrangement",
                "Draw the figures of omni-arrangement",
                "Plant misprints",
            },
            {"Prove what no paper prints"},
            id="a claim",
        ),
        pytest.param(
            "notebooks/findings.md",
            {"Run the chapter findings"},
            {"Audit omni-arrangement", "Run the chapter omni-arrangement"},
            id="a chapter",
        ),
        pytest.param(
            "book/bibliography.md", {"Set the report"}, {"Run the chapter index"}, id="a page"
        ),
        pytest.param(
            "workflow/omniproof/report/summary.py",
            {"Sum up"},
            {"Set the report"},
            id="the summary",
        ),
    ],
)
def test_edit_runs_what_depends_on_it(built, file, first, never):
    path = built.folder / file
    before = path.read_text()
    path.write_text(before + "\n# edited\n")
    try:
        steps = built.steps()
    finally:
        path.write_text(before)
    assert set(steps[: len(first)]) == first
    assert not never & set(steps)


def test_display_is_one_line_a_step(first_build):
    lines = first_build[1][1:]
    total = len(lines)
    assert [re.match(rf"\[ *(\d+)/{total}\] \w", line)[1] for line in lines] == [
        str(number) for number in range(1, total + 1)
    ]


def test_report_has_captions_and_labels(built):
    done = built.run("snakemake", "--report", "report.html")
    assert done.returncode == 0, done.stdout
    text = (built.folder / "report.html").read_text()
    assert "drawn from computed data" in text
    assert '"figure": "5"' in text


def test_bad_paper_stops_make_with_its_message_last(project):
    project.touch_only(but=("audit", "omni-arrangement"))
    kept = project.folder / "results/ledger/omni-arrangement.json"
    kept.parent.mkdir(parents=True)
    kept.write_text("earlier")
    paper = project.folder / "paper_data/omni-arrangement/paper.yaml"
    paper.write_text(paper.read_text().replace("kind: identity", "kind: identty", 1))
    done = project.run("make", "--old-file=.venv/ready", "build")
    lines = [line for line in done.stdout.splitlines() if not line.startswith("make")]
    failed = lines.index("Failed: Audit omni-arrangement")
    assert done.returncode
    assert lines[failed + 1].startswith("paper_data/omni-arrangement/paper.yaml:")
    assert "identity" in lines[failed + 2]
    assert lines[-2:] == [
        "1 fault in paper_data/omni-arrangement/paper.yaml",
        "Log: logs/audit/omni-arrangement.log",
    ]
    assert "Traceback" not in done.stdout
    assert kept.read_text() == "earlier"


def test_missing_chapter_stops_the_build_with_its_message_last(project):
    (project.folder / "notebooks/findings.md").unlink()
    done = project.run("snakemake", "--dryrun")
    assert done.returncode
    assert done.stdout.splitlines()[-1] == "1 fault in workflow/config.yaml"


def test_old_python_is_told_what_to_do(project):
    old = project.folder / "old-python"
    old.write_text('#!/bin/sh\n[ "$1" = --version ] && echo "Python 3.9.2" && exit\nexit 1\n')
    old.chmod(0o755)
    done = project.run("make", "PYTHON=./old-python")
    assert done.returncode
    assert done.stdout.splitlines()[0] == (
        "omniproof needs Python 3.11 or newer; './old-python' is Python 3.9.2. "
        "Name another one, such as: make PYTHON=python3.12"
    )
    assert not (project.folder / ".venv").exists()


def test_path_with_a_blank_and_an_umlaut_builds(root, tmp_path):
    project = copy_of(root, tmp_path / "mein Büro" / "omni proof")
    project.touch_only()
    environment = project.folder / ".venv"
    venv.create(environment, symlinks=True)
    packages = sysconfig.get_path("purelib", vars={"base": str(environment)})
    Path(packages, "these.pth").write_text("\n".join(site.getsitepackages()))
    done = project.run(f"{environment}/bin/python", "-m", "snakemake", "results/theorems.json")
    assert done.returncode == 0, done.stdout
    assert (project.folder / "results/theorems.json").is_file()
