"""What may lie in a folder that somebody sends: nothing blocks, nothing leaks, each is told."""

from __future__ import annotations

import os
import shutil
import socket
from collections.abc import Callable
from pathlib import Path

import pytest
from test_loader import GOOD, TABLE

from omniproof import cli
from omniproof.transcription import files
from omniproof.transcription.faults import BadInput
from omniproof.transcription.files import read_text
from omniproof.transcription.loader import load_paper

Put = Callable[[Path], object]
NO_FILE = "expected a file, found "
NO_FOLDER = "expected a folder, found "


def listen(path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(path.name)


def run(*arguments: str) -> int:
    try:
        return cli.main(arguments)
    except SystemExit as stop:
        return int(stop.code or 0)


INSTEAD = [
    pytest.param(lambda path: None, NO_FILE + "none", id="nothing"),
    pytest.param(Path.mkdir, NO_FILE + "a folder", id="a folder"),
    pytest.param(os.mkfifo, NO_FILE + "a pipe", id="a pipe"),
    pytest.param(listen, NO_FILE + "a socket", id="a socket"),
    pytest.param(
        lambda path: path.symlink_to(path.name),
        NO_FILE + "links that lead in a circle", id="a loop of links"),
    pytest.param(
        lambda path: path.symlink_to("/dev/zero"),
        "expected a file of this folder, found a link that leads out of it", id="a device"),
    pytest.param(
        lambda path: path.symlink_to("../secret"),
        "expected a file of this folder, found a link that leads out of it", id="a link out"),
    pytest.param(lambda path: path.symlink_to("none"), NO_FILE + "none", id="a link to nothing"),
    pytest.param(
        lambda path: path.write_bytes(b"a: " + b"x" * 2_000_000),
        "expected at most 2000000 bytes, found 2000003", id="a huge file"),
    pytest.param(
        lambda path: path.write_bytes("a: b".encode("utf-16")),
        "expected UTF-8, found the byte 0xff at offset 0", id="another encoding"),
]  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "paper"
    folder.mkdir()
    (tmp_path / "secret").write_text("key: secret\n")
    (folder / "paper.yaml").write_text(GOOD, encoding="utf-8")
    (folder / "table-2.csv").write_text(TABLE, encoding="utf-8")
    monkeypatch.chdir(folder)
    return Path()


@pytest.mark.parametrize("name", ["paper.yaml", "table-2.csv"])
@pytest.mark.parametrize(("put", "message"), INSTEAD)
def test_instead_of_a_file(folder: Path, name: str, put: Put, message: str) -> None:
    (folder / name).unlink()
    put(folder / name)
    with pytest.raises(BadInput) as bad:
        load_paper(folder)
    assert [str(fault).partition("\n")[0] for fault in bad.value.faults] == [
        f"{name}:1:1: {message}"
    ]


@pytest.mark.parametrize(
    ("argument", "message"),
    [
        pytest.param("/dev/zero", NO_FOLDER + "a device", id="a device"),
        pytest.param("/dev/null/x", NO_FOLDER + "no folder around it", id="below a device"),
        pytest.param("paper.yaml", NO_FOLDER + "a file", id="a file"),
        pytest.param("loop", NO_FOLDER + "links that lead in a circle", id="a loop of links"),
        pytest.param("x" * 5_000, NO_FOLDER + "a name that is too long", id="a long name"),
        pytest.param("x/" * 5_000, NO_FOLDER + "a name that is too long", id="a long path"),
        pytest.param("", "expected the name of a folder, found nothing", id="no name"),
        pytest.param("a\nb", NO_FILE + "none", id="a line break in the name"),
    ],
)
def test_instead_of_a_folder(
    folder: Path, argument: str, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "loop").symlink_to("loop")
    assert run("audit", argument) == 2
    out, err = capsys.readouterr()
    assert (out, message in err, len(err) < 800) == ("", True, True)
    assert len(err.splitlines()) in {2, 3}


def test_a_link_inside_the_folder_is_followed(folder: Path) -> None:
    (folder / "table-2.csv").rename(folder / "table-3.csv")
    (folder / "table-2.csv").symlink_to("table-3.csv")
    load_paper(folder)


def test_a_link_to_the_folder_is_followed(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to("paper")
    load_paper(tmp_path / "link")


def test_a_file_that_may_not_be_opened(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_args: object) -> int:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(files.os, "open", refuse)
    with pytest.raises(BadInput, match=r"paper.yaml:1:1: .* found one that may not be opened"):
        load_paper(folder)


def test_a_byte_order_mark_is_read_over(folder: Path) -> None:
    for name in ("paper.yaml", "table-2.csv"):
        marked = b"\xef\xbb\xbf" + (folder / name).read_bytes()
        (folder / name).write_bytes(marked)
    load_paper(folder)


@pytest.mark.parametrize(
    ("table", "message"),
    [
        pytest.param(
            "type;D_V\nX;3.08\n", "1:1: tab:2: expected columns, found one: 'type;D_V'",
            id="semicolons"),
        pytest.param(
            "type\tD_V\nX\t3.08\n", r"1:1: tab:2: expected columns, found one: 'type\tD_V'",
            id="tabulators"),
        pytest.param(
            'type,D_V\nX,"3.08\n', "2:1: expected CSV, found a fault: unexpected end of data",
            id="an open quote"),
        pytest.param(
            "type,D_V\nX,3.0\x008\n",
            r"2:3: tab:2[X,D_V]: expected a decimal such as 4.00, found '3.0\x008'",
            id="a zero byte"),
        pytest.param(
            "type,D_V\nX," + "9" * 200_000, "2:1: expected CSV, found a fault: field larger than "
            "field limit (131072)", id="a huge cell"),
    ],
)  # fmt: skip
def test_tables(folder: Path, table: str, message: str) -> None:
    (folder / "table-2.csv").write_text(table, encoding="utf-8", newline="")
    with pytest.raises(BadInput) as bad:
        load_paper(folder)
    assert str(bad.value).splitlines()[0] == f"table-2.csv:{message}"


def test_a_folder_that_is_gone(folder: Path, tmp_path: Path) -> None:
    shutil.rmtree(tmp_path / "paper")
    with pytest.raises(BadInput, match="expected a file, found none"):
        read_text(Path("paper.yaml"))
