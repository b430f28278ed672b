"""What a command has to say, and the one door through which it gets out.

Everything that is printed may hold what somebody else wrote, so everything is made `visible` here;
colour comes after that, and is our own.
"""

from __future__ import annotations

import io
import os
import sys
from typing import NamedTuple, TextIO

from omniproof.visible import visible, visible_json


class Said(NamedTuple):
    """Exit status, text for stdout and stderr; `colour` (as terminals number it) of its first word.

    `json`: stdout gets a JSON text, which stays one.
    """

    status: int
    out: str = ""
    err: str = ""
    colour: int = 0
    json: bool = False


CLOSED = "expected an open {}, found it closed\n    leave it open, or send it to /dev/null"


def say(said: Said, failed: int) -> int:
    """Print what a command has to say; return its exit status, `failed` if stdout takes nothing."""
    out = visible_json(said.out) if said.json else visible(said.out)
    if said.colour:
        word, blank, rest = out.partition(" ")
        out = f"\x1b[{said.colour}m{word}\x1b[0m{blank}{rest}"
    fault = _write(sys.stdout, "stdout", out)
    _write(sys.stderr, "stderr", "\n".join(filter(None, [visible(said.err), fault])))
    return failed if fault else said.status


def _write(stream: TextIO | None, name: str, text: str) -> str:
    """Write a text to whatever a stream is, and say what is wrong with it.

    A reader that has seen enough is no fault; another encoding gets escapes.
    """
    if not text:
        return ""
    if stream is None:  # closed by the shell: `>&-`
        return CLOSED.format(name)
    if isinstance(stream, io.TextIOWrapper):
        stream.reconfigure(errors="backslashreplace")
    try:
        stream.write(f"{text}\n")
        stream.flush()
    except OSError as error:
        # What is left in the buffer would fail once more when the interpreter ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
        seen_enough = isinstance(error, BrokenPipeError)
        return "" if seen_enough else f"cannot write to {name}: {error.strerror}\n    make room"
    return ""
