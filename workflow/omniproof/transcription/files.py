"""Files that nobody vouches for: opened without waiting, of bounded size, inside their own folder.

A folder may come from anywhere. A pipe in it would block, a device never end, a link lead to what
its sender may not see: all are refused before anything is read.
"""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path

from omniproof.transcription.faults import BadInput, Fault
from omniproof.visible import one_line

MAX_BYTES = 2_000_000
MAX_NAME = 200
"""So many characters of a path are shown; the system allows 4096."""

KINDS = (
    (stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISSOCK, "a socket"),
    (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"), (stat.S_ISREG, "a file"),
)  # fmt: skip
OF_SYSTEM = {
    errno.ENOENT: ("none", "write it"),
    errno.ENOTDIR: ("no folder around it", "name a folder that there is"),
    errno.EISDIR: ("a folder", "name a file in it"),
    errno.ELOOP: ("links that lead in a circle", "put a file in place of the link"),
    errno.ENAMETOOLONG: ("a name that is too long", "choose a shorter one"),
    errno.EACCES: ("one that may not be opened", "change its permissions"),
    errno.EPERM: ("one that may not be opened", "change its permissions"),
    errno.ENXIO: ("a socket", "put a file in its place"),
    errno.ENOSPC: ("no space left on the device", "make room"),
}
"""What was found instead of a file, and what to do, by the system's number of the error."""


def display_name(path: Path) -> str:
    """The path as messages show it: on one line, relative to where one stands if it lies below."""
    try:
        name = (path.parent.resolve() / path.name).relative_to(Path.cwd()).as_posix()
    except (ValueError, OSError, RuntimeError):  # RuntimeError: links in a circle, up to 3.12
        name = path.as_posix()
    shown = one_line(name)
    return shown if len(shown) <= MAX_NAME else f"{shown[:MAX_NAME]}…"


def read_text(path: Path) -> str:
    """The text of a file in UTF-8.

    Raises `BadInput` for one that is missing, huge, garbled, no file, or a link out of its folder.
    """
    raw = read_bytes(path)
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        before = raw[: error.start]
        line, column = before.count(b"\n") + 1, error.start - (before.rfind(b"\n") + 1) + 1
        message = f"expected UTF-8, found the byte 0x{raw[error.start]:02x} at offset {error.start}"
        fault = Fault(display_name(path), line, column, "", message, "save the file as UTF-8")
        raise BadInput([fault]) from None


def read_bytes(path: Path) -> bytes:
    """The bytes of a file; raises `BadInput` as `read_text` does."""
    try:
        _refuse_outside(path)
        # The kind first: opening a device can already do something.
        _refuse_unless(path, path.stat().st_mode, "a file")
        with os.fdopen(os.open(path, os.O_RDONLY | os.O_NONBLOCK), "rb") as file:
            _refuse_unless(path, os.fstat(file.fileno()).st_mode, "a file")
            raw = file.read(MAX_BYTES + 1)
    except OSError as error:
        found, cure = of_system(error)
        raise _bad(path, f"expected a file, found {found}", cure) from None
    if len(raw) > MAX_BYTES:
        size = max(path.stat().st_size, len(raw))
        raise _bad(path, f"expected at most {MAX_BYTES} bytes, found {size}", "split the paper")
    return raw


def refuse_no_folder(path: Path) -> None:
    """Raise `BadInput` for what is there and is no folder, and for a name that is none."""
    try:
        _refuse_unless(path, path.stat().st_mode, "a folder")
    except FileNotFoundError:
        return  # then its files are missing, which says more
    except OSError as error:
        found, cure = of_system(error)
        raise _bad(path, f"expected a folder, found {found}", cure) from None


def of_system(error: OSError) -> tuple[str, str]:
    """What the system found instead of a file, and what to do."""
    return OF_SYSTEM.get(error.errno or 0, ((error.strerror or "a fault").lower(), "look at it"))


def _refuse_unless(path: Path, mode: int, wanted: str) -> None:
    found = next((name for test, name in KINDS if test(mode)), "something else")
    if found != wanted:
        cure = f"put {wanted} in its place"
        raise _bad(path, f"expected {wanted}, found {found}", cure)


def _refuse_outside(path: Path) -> None:
    """Refuse a link that leads out of the folder; the folder itself may be a link."""
    try:
        folder, target = path.parent.resolve(strict=True), path.resolve(strict=True)
    except RuntimeError:
        raise OSError(errno.ELOOP, os.strerror(errno.ELOOP)) from None
    if not target.is_relative_to(folder):
        message = "expected a file of this folder, found a link that leads out of it"
        raise _bad(path, message, "put a copy in place of the link")


def _bad(path: Path, message: str, cure: str) -> BadInput:
    return BadInput([Fault(display_name(path), 1, 1, "", message, cure)])
