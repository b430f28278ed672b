"""Which state of the project this is: its commit and the commit's date, never the present one."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Revision:
    """A commit (with `-dirty` where tracked files were changed since) and its date, ISO 8601.

    Both are empty outside of a git clone, such as in an unpacked archive.
    """

    commit: str = ""
    date: str = ""


def read_revision(root: Path) -> Revision:
    """Read the revision of the clone whose top folder is `root`."""
    if not (root / ".git").exists():
        return Revision()
    commit = _git(root, "describe", "--always", "--dirty", "--abbrev=40", "--exclude=*")
    return Revision(commit, _git(root, "log", "-1", "--format=%cI"))


def _git(root: Path, *arguments: str) -> str:
    """Return what git says; nothing where there is no git, or no commit yet."""
    command = ["git", "-C", str(root), *arguments]
    try:
        run = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603
    except FileNotFoundError:
        return ""
    return "" if run.returncode else run.stdout.strip()
