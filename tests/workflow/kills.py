"""Builds that are killed at seeded moments, and what they leave when one of them may end."""

import os
import re
import signal
import time
from hashlib import sha256
from pathlib import Path
from random import Random

from copied import Project

from omniproof.report.step import PART

MADE = ("results", "book/_build/html")


def made(folder: Path) -> dict[str, str]:
    """Return the checksum of every file that was made; only times and memory are left out."""
    files = [path for top in MADE for path in (folder / top).rglob("*") if path.is_file()]
    named = {str(path.relative_to(folder)): path for path in files}
    return {
        name: sha256(path.read_bytes()).hexdigest()
        for name, path in sorted(named.items())
        if not name.startswith("results/benchmarks")
    }


def half_made(folder: Path) -> list[Path]:
    """Return what steps that were killed have left."""
    return [path for top in MADE for path in (folder / top).rglob(f"{PART}*")]


def kill_once(project: Project, command: list[str], chance: Random) -> bool:
    """Begin a build and kill it at some share of its steps; return False if it ended before.

    `kill -9` takes the first process only, or all that it began. The moment is not the same in
    every run of a test; what the test demands is.
    """
    share, delay = chance.uniform(-0.2, 1), chance.uniform(0, 1)  # below 0: while it plans
    kill = chance.choice([os.kill, os.killpg])
    said = project.folder / "build.out"
    with said.open("w") as out:
        build = project.start(*command, stdout=out, stderr=out)
    while build.poll() is None and _done(said) < share:
        time.sleep(0.02)
    time.sleep(delay)
    if build.poll() is None:
        kill(build.pid, signal.SIGKILL)
    return build.wait() == -signal.SIGKILL


def _done(said: Path) -> float:
    """Return which share of its steps a build has begun: its last line is like `[ 3/14] …`."""
    steps = re.findall(r"^\[ *(\d+)/(\d+)\]", said.read_text(), re.MULTILINE)
    return int(steps[-1][0]) / int(steps[-1][1]) if steps else 0
