"""Work that does not end is ended, wherever it is; nothing else is changed by the fork."""

from __future__ import annotations

import faulthandler
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from time import process_time, sleep

import pytest

from omniproof import cli, limited
from omniproof.limited import LimitError

MATRIX = r"\begin{{pmatrix}}{}\end{{pmatrix}}".format(
    r"\\".join("&".join(f"x_{{{i + j}}}" for j in range(12)) for i in range(12))
)
RUNAWAYS = [
    pytest.param(r"\sqrt{10^{9999}+1} = 1", id="the root of a huge number"),
    pytest.param(f"{MATRIX}^8 = {MATRIX}", id="a power of a matrix of 144 symbols"),
    pytest.param("(" * 10 + "x+y+z+u" + "+1)^9" * 10 + "=(y+x+z+u)", id="ten nested powers"),
]


def spin() -> str:
    while True:
        pass


def swallow() -> str:
    """Do what a handler in Python would not survive: one long call into C."""
    return str(pow(3, 10**9))[:1]


def ask(message: Callable[[], str]) -> str:
    with pytest.raises((LimitError, ChildProcessError)) as reason:
        limited.limited(message, 0.2)
    return str(reason.value)


@pytest.mark.parametrize("work", [spin, swallow])
def test_no_end(work: Callable[[], str]) -> None:
    before = os.times()
    assert ask(work) == "no answer within 0.2 s of CPU time"
    after = os.times()
    used = after.children_user + after.children_system
    assert used - before.children_user - before.children_system < 1.2


def test_no_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limited, "MAX_MEMORY", 2 * 1024**3)
    assert ask(lambda: str(len(bytearray(3 * 1024**3)))) == "it takes more than 2 GB of memory"


@pytest.mark.parametrize(
    ("number", "message"),
    [
        (signal.SIGABRT, "it takes more than 4 GB of memory"),
        (signal.SIGKILL, "it takes more than 4 GB of memory"),
        (signal.SIGSEGV, "the process that decides ended with: Segmentation fault"),
    ],
)
def test_a_process_that_dies(number: signal.Signals, message: str) -> None:
    def die() -> str:
        faulthandler.disable()
        os.kill(os.getpid(), number)
        sleep(10)
        return ""

    assert ask(die) == message


def test_an_answer_longer_than_a_pipe_holds() -> None:
    assert limited.limited(lambda: "θ" * 10**6, 5) == "θ" * 10**6


def test_the_parent_has_no_clock_afterwards() -> None:
    limited.limited(str, 0.1)
    end = process_time() + 0.3
    while process_time() < end:
        pass
    assert signal.getitimer(signal.ITIMER_PROF) == (0, 0)


@pytest.mark.parametrize("formula", RUNAWAYS)
@pytest.mark.parametrize("form", [[], ["--json"]])
def test_a_check_ends(formula: str, form: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["check", *form, "--limit", "0.3", formula]) == 3
    out, err = capsys.readouterr()
    said = "not decided: no answer within 0.3 s of CPU time; `--limit SECONDS` gives more time"
    told = json.loads(out)["message"] if form else " ".join(out.split())
    assert (err, said in told, out.count("UNDECIDED")) == ("", True, 0 if form else 1)


@pytest.mark.parametrize("seconds", ["0", "-1", "nan", "inf", "1e9", "ten", ""])
def test_a_limit_that_is_none(seconds: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        cli.main(["check", "a = a", f"--limit={seconds}"])
    said = f"argument --limit: expected seconds from 0.01 to 86400, found {seconds!r}\n"
    assert (stop.value.code, capsys.readouterr().err.endswith(said)) == (2, True)


def test_an_interrupt_ends_both() -> None:
    formula = r"\sqrt{10^{9999}+1} = 1"
    process = subprocess.Popen(
        [sys.executable, "-m", "omniproof.cli", "check", formula],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, process_group=0,
    )  # fmt: skip
    sleep(3)
    os.killpg(process.pid, signal.SIGINT)
    assert process.communicate(timeout=20) == (b"", b"")
    assert process.returncode == 130
