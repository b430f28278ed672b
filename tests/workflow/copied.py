"""A copy of what git holds, with scripts that only touch their outputs, and a way to run it."""

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from textwrap import indent
from typing import Any

import pytest

from omniproof import lock

LOCK = [sys.executable, "-P", str(Path(lock.__file__))]
HOLDER = [sys.executable, "-c", "import time; print('building', flush=True); time.sleep(600)"]
"""A build that says when it began, and does not end by itself; to be started by `LOCK`."""
TOUCH = """
from pathlib import Path

for path in snakemake.output:
    Path(path).write_text(snakemake.rule)
"""


@dataclass(frozen=True)
class Project:
    """A project folder and the environment to run its own package in."""

    folder: Path

    def run(self, *command: str, timeout: int = 120) -> subprocess.CompletedProcess[str]:
        """Run a command; standard error is in `stdout`, as on a screen."""
        return subprocess.run(
            command,
            cwd=self.folder,
            env=self._environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=timeout,
            check=False,
        )

    def start(self, *command: str, **streams: Any) -> subprocess.Popen[str]:
        """Start a command as the first of a process group of its own."""
        environment = self._environment()
        return subprocess.Popen(
            command, cwd=self.folder, env=environment, start_new_session=True, **streams
        )

    def _environment(self) -> dict[str, str]:
        own = {
            "PYTHONPATH": str(self.folder / "workflow"),
            "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        }
        outer = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
        return outer | own

    def touch_only(self, *, but: tuple[str, str] = ("", "")) -> None:
        """Replace every script by one that only writes its outputs, but for one job.

        `but`: the script and the paper that it works on as ever.
        """
        kept, paper = but
        for script in (self.folder / "workflow" / "scripts").glob("*.py"):
            own = indent(script.read_text(), "    ") if script.stem == kept else ""
            rest = f"if snakemake.wildcards.paper != {paper!r}:{indent(TOUCH, '    ')}else:\n{own}"
            script.write_text(rest if own else TOUCH)

    def steps(self) -> list[str]:
        """Return the progress lines of a dry run, without their numbers."""
        done = self.run("snakemake", "--dryrun")
        assert done.returncode == 0, done.stdout
        return [x.split("] ", 1)[1] for x in done.stdout.splitlines() if x.startswith("[")]


def copy_of(root: Path, folder: Path) -> Project:
    """Copy what git holds (symbolic links as such) to a new folder."""
    command = ["git", "ls-files"]
    listed = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    if listed.returncode:
        pytest.skip("this folder is no git clone, so what git holds is not known")
    for name in listed.stdout.splitlines():
        if (root / name).exists():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(root / name, folder / name, follow_symlinks=False)
    return Project(folder)
