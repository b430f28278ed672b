"""One build at a time in a folder, by a lock that the kernel frees when its last holder is gone.

The lock is the standard input of a build, since every process that the build starts inherits that
and Snakemake passes nothing else on. A killed `make` leaves Snakemake, a killed Snakemake its
steps, and each of them goes on writing: as long as one runs, the lock is held, and after `kill -9`
of the last one it is free. The kernel tells a living owner from a dead one; what stands in the file
is only for the message to whoever waits. Nothing but the standard library is imported, because the
set-up of the environment is guarded, too:

    python workflow/omniproof/lock.py COMMAND…
"""

from __future__ import annotations

import fcntl
import json
import os
import sys
from pathlib import Path
from time import strftime

FILE = Path(".build.lock")


def hold(file: Path = FILE) -> bool:
    """Make the lock `file` the standard input of this process; return whether it had to wait.

    While another build holds it, say so on standard error, and wait. What was read before such a
    wait is out of date.
    """
    if _is_held(file):
        return False
    descriptor = os.open(file, os.O_RDWR | os.O_CREAT, 0o644)
    waited = False
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        waited = True
        print(_holder(file), file=sys.stderr, flush=True)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
    os.ftruncate(descriptor, 0)
    os.pwrite(descriptor, _record(), 0)
    if descriptor:  # it is 0 already where there was no standard input
        os.dup2(descriptor, 0)
        os.close(descriptor)
    os.set_inheritable(0, True)
    return waited


def _is_held(file: Path) -> bool:
    """Whether this process has inherited the lock."""
    try:
        return os.path.samestat(os.fstat(0), file.stat())
    except OSError:
        return False


def _record() -> bytes:
    parent = os.getppid()  # 1 where that was killed
    made_by = f"make, process {parent}" if "MAKELEVEL" in os.environ and parent != 1 else ""
    since = strftime("%Y-%m-%d %H:%M:%S")
    return json.dumps({"process": os.getpid(), "of": made_by, "since": since}).encode()


def _holder(file: Path) -> str:
    """Return who holds the lock since when, for people."""
    try:
        record = json.loads(file.read_text(encoding="utf-8"))
        process, of, since = record["process"], record["of"], record["since"]
    except (ValueError, KeyError):  # it was killed, or read, while it wrote this
        return "Another build is running here. Waiting until it ends."
    who = f"Process {process}" + (f" (of {of})" if of else "")
    if _runs(process):
        return f"{who} has been building here since {since}. Waiting until it ends."
    return f"{who} began to build here at {since}; its last steps still run. Waiting for them."


def _runs(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True


if __name__ == "__main__":
    hold()
    os.execvp(sys.argv[1], sys.argv[1:])  # noqa: S606 - our own Makefile's command, no shell
