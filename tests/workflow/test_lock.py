"""One build at a time: the kernel tells a lock whose owner lives from a stale one."""

import json
import os
import re
import signal
import subprocess
import sys

import pytest
from copied import HOLDER, LOCK

from omniproof import lock

KILLED_WITH_A_STEP = [
    sys.executable,
    "-c",
    "import os, subprocess, sys\n"
    f"print(subprocess.Popen({HOLDER}, stdout=subprocess.DEVNULL).pid, flush=True)\n"
    "os.kill(os.getpid(), 9)",
]


@pytest.fixture
def start(tmp_path):
    """Return a way to start a process under the lock of an empty folder."""
    started = []

    def begin(*command):
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
        outer = {k: v for k, v in os.environ.items() if not k.startswith("MAKE")}
        started.append(subprocess.Popen([*LOCK, *command], cwd=tmp_path, env=outer, **pipes))
        return started[-1]

    yield begin
    for process in started:
        process.kill()
        process.communicate()


def test_second_build_says_who_builds_since_when_and_waits(start):
    first = start(*HOLDER)
    assert first.stdout.readline() == "building\n"
    second = start("echo", "at last")
    said = second.stderr.readline()
    assert re.fullmatch(
        rf"Process {first.pid} has been building here since \d{{4}}-\d\d-\d\d \d\d:\d\d:\d\d\. "
        r"Waiting until it ends\.\n",
        said,
    )
    assert second.poll() is None
    first.kill()
    assert second.communicate(timeout=60) == ("at last\n", "")


def test_steps_of_a_killed_build_hold_its_lock(start):
    first = start(*KILLED_WITH_A_STEP)
    step = int(first.stdout.readline())
    assert first.wait(timeout=60) == -signal.SIGKILL
    second = start("echo", "at last")
    said = second.stderr.readline()
    assert said.startswith(f"Process {first.pid} began to build here at ")
    assert said.endswith("; its last steps still run. Waiting for them.\n")
    os.kill(step, signal.SIGKILL)
    assert second.communicate(timeout=60) == ("at last\n", "")


@pytest.mark.parametrize(
    "record",
    [
        pytest.param('{"process": 1, "of": "", "since": "noon"}', id="of a living process"),
        pytest.param('{"process": 4194303, "of": "", "since": "noon"}', id="of a dead process"),
        pytest.param('{"proc', id="half-written"),
    ],
)
def test_record_without_a_holder_keeps_nobody_waiting(start, tmp_path, record):
    (tmp_path / lock.FILE).write_text(record)
    assert start("echo", "at once").communicate(timeout=60) == ("at once\n", "")


def test_half_written_record_of_a_holder_is_no_fault(start, tmp_path):
    first = start(*HOLDER)
    first.stdout.readline()
    (tmp_path / lock.FILE).write_text('{"proc')
    second = start("echo", "at last")
    assert second.stderr.readline() == "Another build is running here. Waiting until it ends.\n"
    first.kill()
    assert second.communicate(timeout=60) == ("at last\n", "")


def test_a_build_within_a_build_goes_on(start):
    assert start(*LOCK, "echo", "inside").communicate(timeout=60) == ("inside\n", "")


def test_build_without_a_standard_input_holds_the_lock(start):
    within = start("sh", "-c", 'exec "$@" <&-', "sh", *LOCK, *HOLDER)
    assert within.stdout.readline() == "building\n"
    assert start("echo", "at last").stderr.readline().startswith(f"Process {within.pid} has been")


def test_record_names_the_make_that_began(monkeypatch):
    monkeypatch.setenv("MAKELEVEL", "1")
    assert json.loads(lock._record())["of"] == f"make, process {os.getppid()}"
