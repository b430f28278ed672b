"""The frame of a workflow script: what it prints goes to its log, its outputs appear whole.

A script is `with step(snakemake) as output:` around a call of the package. When it fails, the
last part of its log is a message for people, which the display repeats at the end of the run.
"""

from __future__ import annotations

import os
import sys
import tempfile
import traceback
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from omniproof.transcription.faults import BadInput

MESSAGE = "---- message ----\n"
PART = ".part-"  # how the folders are named in which steps write until they have ended
TAIL = 20  # lines shown of a log without a message: the step was killed


@contextmanager
def step(snakemake: Any) -> Iterator[SimpleNamespace]:
    """Run the body of a script; give it the paths to write to, by the rule's output names.

    They lie in a folder of their own until the body has ended, so that no half-written file is
    left behind. An output that the body wrote in its final place is left there.

    Raises `SystemExit` with status 2 for bad input and 1 for anything else that goes wrong.
    """
    finals = [Path(path) for path in snakemake.output]
    with (
        _printing_to(Path(snakemake.log[0])),
        _status_of_failure(),
        tempfile.TemporaryDirectory(prefix=PART, dir=finals[0].parent) as folder,
    ):
        yield SimpleNamespace(
            **{name: _staged(value, Path(folder)) for name, value in snakemake.output.items()}
        )
        for final in finals:
            _put(Path(folder) / final.name, final)


def failure(log: Path) -> str:
    """Return the message of a failed step from its log, or the log's last lines."""
    text = log.read_text(encoding="utf-8", errors="replace") if log.exists() else ""
    if not text:
        return "The step stopped before it opened its log; its message stands further up."
    _, mark, message = text.rpartition(MESSAGE)
    return message.strip() if mark else "\n".join(text.splitlines()[-TAIL:])


def _staged(value: Any, folder: Path) -> Path | tuple[Path, ...]:
    if isinstance(value, str):
        return folder / Path(value).name
    return tuple(folder / Path(path).name for path in value)


def _put(staged: Path, final: Path) -> None:
    if staged.exists():
        staged.replace(final)
    elif not final.exists():
        raise FileNotFoundError(f"the step ended without writing {final}")


@contextmanager
def _printing_to(log: Path) -> Iterator[None]:
    """Send standard output and error to a file, those of child processes too."""
    with log.open("w", encoding="utf-8", buffering=1) as stream:
        kept = [(number, os.dup(number)) for number in (1, 2)]
        for number, _ in kept:
            os.dup2(stream.fileno(), number)
        try:
            with redirect_stdout(stream), redirect_stderr(stream):
                yield
        finally:
            for number, copy in kept:
                os.dup2(copy, number)
                os.close(copy)


@contextmanager
def _status_of_failure() -> Iterator[None]:
    try:
        yield
    except BadInput as bad:
        print(MESSAGE + str(bad), file=sys.stderr)
        raise SystemExit(2) from None
    except Exception as error:
        traceback.print_exc()
        print(f"{MESSAGE}{type(error).__name__}: {error}", file=sys.stderr)
        raise SystemExit(1) from None
