"""Work that ends: in a process of its own, which the kernel stops past its share of CPU or memory.

A long call into FLINT, z3 or Python's own integers gives no handler in Python a turn, so the clock
is the kernel's: `ITIMER_PROF` counts the CPU time of a process, and its signal, which nothing here
handles, ends the process wherever it is; the parent lives to say so. Linux and macOS both do this.
A fork after the imports costs 6 ms of CPU for a formula that takes 9.
"""

from __future__ import annotations

import os
import resource
import signal
from collections.abc import Callable

MAX_MEMORY = 4 * 1024**3
"""Bytes of data: a formula takes a tenth of that, and a laptop still has them."""
_NO_MEMORY = 3  # exit status of a child


class LimitError(Exception):
    """Work that was stopped, with the reason in words."""


def limited(work: Callable[[], str], seconds: float) -> str:
    """Return what `work` returns, within `seconds` of CPU time (from 0.001 on) and `MAX_MEMORY`.

    Raises `LimitError` past either, and `ChildProcessError` for a process that crashed. What the
    work changes in memory is lost.
    """
    _open_standard_streams()
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        os.close(reading)
        _work(work, seconds, writing)
    os.close(writing)
    try:
        with os.fdopen(reading, encoding="utf-8") as answer:
            text = answer.read()
    except BaseException:  # such as Ctrl-C: leave nothing running behind
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        raise
    _ask(os.waitpid(child, 0)[1], seconds)
    return text


def _open_standard_streams() -> None:
    """Put the null device where the shell closed a stream, so that no pipe takes its number."""
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        pass
    os.close(number)


def _work(work: Callable[[], str], seconds: float, writing: int) -> None:
    """Work in the child, answer through the pipe, and end without the parent's cleaning up."""
    status = 1
    try:
        _share(seconds)
        with os.fdopen(writing, "w", encoding="utf-8") as answer:
            answer.write(work())
        status = 0
    except MemoryError:
        status = _NO_MEMORY
    finally:
        os._exit(status)


def _share(seconds: float) -> None:
    """Limit this process, give the signals that end it to the kernel, and be silent meanwhile."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (1, 2):  # libraries in C tell what they die of
        os.dup2(nowhere, stream)
    for number in (signal.SIGPROF, signal.SIGINT):
        signal.signal(number, signal.SIG_DFL)
    hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
    most = MAX_MEMORY if hard == resource.RLIM_INFINITY else min(MAX_MEMORY, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (most, hard))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    signal.setitimer(signal.ITIMER_PROF, seconds)


def _ask(ended: int, seconds: float) -> None:
    """Ask a child's status how it ended; raises for everything but the usual end."""
    status = os.waitstatus_to_exitcode(ended)
    if status == -signal.SIGPROF:
        raise LimitError(f"no answer within {seconds:g} s of CPU time")
    # FLINT and z3 abort where memory ends; the kernel kills where there is none left at all.
    if status in {_NO_MEMORY, -signal.SIGABRT, -signal.SIGKILL}:
        raise LimitError(f"it takes more than {MAX_MEMORY >> 30} GB of memory")
    if status:
        cause = signal.strsignal(-status) if status < 0 else f"exit status {status}"
        raise ChildProcessError(f"the process that decides ended with: {cause}")
