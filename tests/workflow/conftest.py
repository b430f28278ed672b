"""Copies of the project, one built by scripts that only touch, and the plan of a build."""

import json
import sys
from pathlib import Path

import pytest
from copied import Project, copy_of


@pytest.fixture
def project(root: Path, tmp_path: Path) -> Project:
    """Return a fresh copy of the project."""
    return copy_of(root, tmp_path / "project")


@pytest.fixture(scope="session")
def first_build(root: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Project, list[str]]:
    """Return a copy in which every step ran once, by scripts that only touch; and what it said."""
    project = copy_of(root, tmp_path_factory.mktemp("built"))
    project.touch_only()
    done = project.run("snakemake")
    assert done.returncode == 0, done.stdout
    return project, done.stdout.splitlines()


@pytest.fixture(scope="session")
def built(first_build: tuple[Project, list[str]]) -> Project:
    return first_build[0]


@pytest.fixture(scope="session")
def jobs(plan: list[dict]) -> list[dict]:
    """Return all jobs of a build that make something."""
    return [job for job in plan if job["rule"] != "all"]


@pytest.fixture(scope="session")
def plan(root: Path, tmp_path_factory: pytest.TempPathFactory) -> list[dict]:
    """Return all jobs of a build: rule, file of rules, named inputs and outputs, log, …"""
    project = copy_of(root, tmp_path_factory.mktemp("dag"))
    done = project.run(sys.executable, str(Path(__file__).with_name("list_jobs.py")))
    assert done.returncode == 0, done.stdout
    return json.loads(done.stdout.splitlines()[-1])
