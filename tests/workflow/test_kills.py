"""Builds recover from `kill -9` at any stage, to the same bytes."""

import shutil
from pathlib import Path
from random import Random

import pytest
from copied import Project, copy_of
from kills import half_made, kill_once, made

SOME = [  # a judged paper, a table and a picture that rest on others, what is simulated
    "snakemake",
    "results/tables/omni-arrangement/table-2.csv",
    "results/figures/two-roller-sphere/figures.json",
    "results/ledger/ballbot.json",
]
EVERYTHING = ["make", "--old-file=.venv/ready"]
HOUR = 3600


def clear(folder: Path) -> None:
    for name in ("results", "book/_build", ".snakemake"):
        shutil.rmtree(folder / name, ignore_errors=True)


def differing(found: dict[str, str], whole: dict[str, str]) -> set[str]:
    """Return the names of files that are not as in the build that nobody killed."""
    return {name for name, _ in found.items() ^ whole.items()}


def uninterrupted(project: Project, command: list[str]) -> dict[str, str]:
    done = project.run(*command, timeout=HOUR)
    assert done.returncode == 0, done.stdout
    whole = made(project.folder)
    clear(project.folder)
    return whole


@pytest.mark.parametrize(
    ("command", "kills"),
    [
        pytest.param(SOME, 5, id="5 kills of a small build"),
        pytest.param(EVERYTHING, 50, id="50 kills of the whole build", marks=pytest.mark.slow),
    ],
)
def test_killed_builds_recover_to_the_same_bytes(
    root: Path, tmp_path: Path, command: list[str], kills: int
) -> None:
    project = copy_of(root, tmp_path / "mein Büro" / "omni proof")
    whole = uninterrupted(project, command)
    chance, killed = Random(11), 0
    while killed < kills:
        if kill_once(project, command, chance):
            killed += 1
        else:
            assert differing(made(project.folder), whole) == set()
            clear(project.folder)
    done = project.run(*command, timeout=HOUR)
    assert done.returncode == 0, done.stdout
    assert differing(made(project.folder), whole) == set()
    assert half_made(project.folder) == []
