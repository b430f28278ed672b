"""What is lost is made again; what fails leaves the earlier results, and goes on failing."""

import re
import subprocess
from pathlib import Path

import pytest
from copied import HOLDER, LOCK
from kills import made

from omniproof.recovery import forget, is_whole, keep, list_files, put_back, sweep
from omniproof.report.step import PART

PAPER = "paper_data/omni-arrangement/paper.yaml"


@pytest.fixture
def here(tmp_path, monkeypatch):
    """Work in an empty folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_kept_results_come_back_where_none_are(here):
    (here / "results").mkdir()
    lost, anew = Path("results/lost.csv"), Path("results/anew.csv")
    for file in (lost, anew):
        file.write_text("earlier")
    age = lost.stat().st_mtime_ns
    keep(["results/lost.csv", "results/anew.csv", "results/never.csv"])
    lost.unlink()
    anew.write_text("new")
    put_back(["results/lost.csv", "results/anew.csv", "results/never.csv"])
    assert (lost.read_text(), anew.read_text()) == ("earlier", "new")
    assert lost.stat().st_mtime_ns == age


def test_what_is_forgotten_does_not_come_back(here):
    Path("a").write_text("earlier")
    keep(["a"])
    forget()
    Path("a").unlink()
    put_back(["a"])
    assert not Path("a").exists()


def test_unfinished_files_are_swept_and_nothing_else(here):
    for name in ("results/.part-x/half.csv", "results/deep/.part-y/half.svg", "results/whole.csv"):
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).touch()
    sweep(PART, "results", "no such folder")
    assert [str(x) for x in Path("results").rglob("*")] == ["results/deep", "results/whole.csv"]


def test_a_lost_page_is_noticed(here):
    page = here / "html" / "a chapter.html"
    page.parent.mkdir()
    page.touch()
    assert is_whole(here / "html", here / "files.txt")  # nobody listed any files yet
    list_files(here / "html", here / "files.txt")
    assert is_whole(here / "html", here / "files.txt")
    page.unlink()
    assert not is_whole(here / "html", here / "files.txt")


def test_every_output_is_asked_for(plan, jobs):
    """Snakemake makes a lost file again only if a target or a step that runs asks for it."""
    asked = next(job["input"] for job in plan if job["rule"] == "all")
    outputs = {file for job in jobs for files in job["output"].values() for file in files}
    assert outputs == {file for files in asked.values() for file in files}


@pytest.mark.parametrize(
    "lost",
    [
        pytest.param(
            {
                "results/ledger/ballbot.json": "Audit ballbot",
                "results/figures/ballbot/figure-2.csv": "Draw the figures of ballbot",
                "results/simulation/sphere/summary.csv": "Simulate sphere",
            },
            id="what only other results rest on",
        ),
        pytest.param({"book/_build/html/ballbot.html": "Set the report"}, id="a page"),
    ],
)
def test_what_is_lost_is_made_again(built, lost):
    page = built.folder / "book/_build/html/ballbot.html"
    page.touch()
    list_files(page.parent, built.folder / "book/_build/files.txt")
    texts = {built.folder / name: (built.folder / name).read_text() for name in lost}
    for file in texts:
        file.unlink()
    try:
        assert set(lost.values()) <= set(built.steps())
    finally:
        for file, text in texts.items():
            file.write_text(text)


def test_bad_input_leaves_all_earlier_results_and_fails_until_it_is_mended(project):
    project.touch_only(but=("audit", "omni-arrangement"))
    targets = ["results/tables/omni-arrangement/table-2.csv", "results/mutation.json"]
    assert project.run("snakemake", *targets).returncode == 0
    earlier = made(project.folder)
    paper = project.folder / PAPER
    good = paper.read_text()
    paper.write_text(good.replace("kind: identity", "kind: identty", 1))
    for _ in range(2):
        done = project.run("snakemake", *targets)
        assert done.returncode
        assert f"1 fault in {PAPER}" in done.stdout.splitlines()[-2]
        assert made(project.folder) == earlier
    paper.write_text(good)
    done = project.run("snakemake", *targets)
    assert done.returncode == 0
    assert re.search(r"^\[\d/\d\] Audit omni-arrangement$", done.stdout, re.MULTILINE)


def test_build_waits_for_another_one_and_then_makes_what_is_left(project):
    project.touch_only()
    other = project.start(*LOCK, *HOLDER, stdout=subprocess.PIPE, text=True)
    assert other.stdout.readline() == "building\n"
    build = project.start("snakemake", "results/theorems.json", stderr=subprocess.PIPE, text=True)
    said = next(line for line in build.stderr if not line.startswith("Using workflow"))
    assert said.startswith(f"Process {other.pid} has been building here since ")
    other.kill()
    assert "[1/1] Prove what no paper prints" in build.communicate(timeout=120)[1]
    assert build.returncode == 0
