"""`omniproof check`: what goes where, exit statuses, input that is meant to hurt."""

from __future__ import annotations

import io
import json
import os
import pty
import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from omniproof import cli
from omniproof.decide.answer import DisagreementError

KEYS = ["verdict", "printed", "witness", "condition", "repair", "engines", "message"]
COMMAND = [sys.executable, "-m", "omniproof.cli", "check"]
TRUE = r"\sin 2\theta = 2\sin\theta\cos\theta"
FALSE = r"\sin 2\theta = \sin\theta\cos\theta"


def run(
    *arguments: str | bytes, stdin: bytes = b"", cwd: Path | None = None, **env: str
) -> subprocess.CompletedProcess[bytes]:
    clean = {name: value for name, value in os.environ.items() if name not in {"NO_COLOR", "TERM"}}
    return subprocess.run(
        [*COMMAND, *arguments],
        input=stdin,
        env={**clean, "COLUMNS": "100", **env},
        cwd=cwd,
        capture_output=True,
        timeout=120,
        check=False,
    )


def check(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    status = cli.main(["check", *arguments])
    return status, *capsys.readouterr()


@pytest.fixture
def typed(monkeypatch: pytest.MonkeyPatch) -> Callable[[bytes], None]:
    """Return a way to say what stdin holds."""

    def put(held: bytes) -> None:
        monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(held)))

    return put


@pytest.mark.parametrize(
    ("arguments", "status", "verdict"),
    [
        pytest.param([TRUE], 0, "verified", id="true"),
        pytest.param(["a = 2a"], 1, "erratum", id="false"),
        pytest.param(["a = b"], 3, "definition", id="nothing to prove"),
        pytest.param(["|x| = x"], 1, "conditional", id="on a branch"),
        pytest.param(["a ="], 2, "invalid", id="bad input"),
        pytest.param([r"\sqrt{-1} = -x"], 3, "undecided", id="unsupported"),
        pytest.param(["|x| = x", "--positive", "x"], 0, "verified", id="positive"),
        pytest.param(
            ["|x| + |y| = x + y", "--positive", "x", "--positive", "y"], 0, "verified", id="twice"
        ),
        pytest.param(
            [r"\sin\theta > 0", "--between", r"0 < \theta < 180^\circ"], 0, "verified", id="range"
        ),
        pytest.param(
            ["c(2x) = c(x)^2 - s(x)^2", "--function", "c=cos", "--function", "s=sin"],
            0, "verified", id="functions"),
        pytest.param(["1/2x = x/2", "--slash", "first"], 0, "verified", id="slash"),
        pytest.param(["--", "-x=-x"], 0, "verified", id="minus sign"),
        pytest.param(["-x = -x"], 0, "verified", id="minus sign and blanks"),
    ],
)  # fmt: skip
def test_status_and_verdict(
    arguments: list[str], status: int, verdict: str, capsys: pytest.CaptureFixture[str]
) -> None:
    found, out, err = check(capsys, "--json", *arguments)
    assert (found, err) == (status, "")
    record = json.loads(out)
    assert (list(record), record["verdict"]) == (KEYS, verdict)
    assert all(isinstance(value, str) for value in record.values())

    found, out, err = check(capsys, *arguments)
    shown, silent = (err, out) if status == 2 else (out, err)
    assert (found, silent) == (status, "")
    assert status == 2 or shown.startswith(f"{verdict.upper()}  {record['printed']}\n")


def test_the_whole_output_on_a_branch() -> None:
    done = run("|x| = x")
    assert (done.returncode, done.stderr) == (1, b"")
    assert done.stdout.decode() == (
        "CONDITIONAL  |x| = x\n"
        "    holds for x \\geq 0\n"
        "    witness   x = -26/9; left = 2.889; right = -2.889\n"
        "    engines   flint, modular\n"
        "    note      true under a condition only\n"
    )


def test_the_whole_output_of_bad_input(capsys: pytest.CaptureFixture[str]) -> None:
    status, out, err = check(capsys, "1/3L = x")
    assert (status, out) == (2, "")
    assert err == (
        "it is not clear what the slash divides by\n"
        "    1/3L = x\n"
        "    ~~~^\n"
        "    write `\\frac{…}{…}`, or settle it with `--slash first` or `--slash all`\n"
    )


def test_a_formula_from_stdin() -> None:
    done = run("-", stdin=b"a + b\n  = b + a\n")
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.decode().splitlines()[0] == "VERIFIED  a + b = b + a"


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        pytest.param(b"", "expected a number, a symbol or a bracket, found the end", id="empty"),
        pytest.param(b"=", "expected a number, a symbol or a bracket, found the end", id="lone ="),
        pytest.param(
            b"__import__('os').system('touch marker')",
            "expected a number, a symbol or a bracket, found `_`", id="code"),
        pytest.param(
            b"x+" * 500_000, "expected at most 10000 characters, found 1000000", id="a million"),
        pytest.param(b"{" * 5_000, "expected at most 32 brackets inside one another", id="deep"),
        pytest.param(b"\\frac" * 1_000, "expected at most 32 levels", id="deep without brackets"),
        pytest.param(b"x = \xff", "'�' is no part of a formula", id="bytes"),
        pytest.param(b"x = \x1b[31m", "'\\x1b' is no part of a formula", id="escape sequence"),
        pytest.param(b"x = \x00", "'\\x00' is no part of a formula", id="zero byte"),
        pytest.param(
            b"9" * 5_000 + b" = 1", "expected a number with at most 1000 digits", id="digits"),
        pytest.param(
            b"((9^{99999})^{99999}) = 1", "expected a smaller power of a number", id="tower"),
    ],
)  # fmt: skip
def test_hostile_input(
    formula: bytes,
    message: str,
    typed: Callable[[bytes], None],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    typed(formula)
    status, out, err = check(capsys, "-")
    assert (status, out) == (2, "")
    assert err.startswith(message)
    assert "\x1b" not in err
    assert list(tmp_path.iterdir()) == []


def test_a_million_characters_through_a_pipe() -> None:
    """A process of its own is stopped by no limit but ours."""
    done = run("-", stdin=b"x+" * 500_000)
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.decode().startswith("expected at most 10000 characters, found 1000000")


def test_bytes_that_are_no_text_in_an_argument() -> None:
    done = run(b"x = \xff", "--json")
    assert (done.returncode, done.stderr) == (2, b"")
    assert json.loads(done.stdout)["printed"] == "x = \N{REPLACEMENT CHARACTER}"


def test_output_that_is_no_utf_8() -> None:
    done = run("\N{GREEK SMALL LETTER THETA} = 1/3L", PYTHONIOENCODING="ascii")
    assert done.returncode == 2
    done = run("\N{GREEK SMALL LETTER THETA} > 2", PYTHONIOENCODING="ascii")
    assert done.returncode == 1


@pytest.mark.parametrize(
    "arguments",
    [
        pytest.param([], id="no formula"),
        pytest.param(["a = a", "b = b"], id="two formulas"),
        pytest.param(["a = a", "--function", "cos"], id="no letter"),
        pytest.param(["a = a", "--function", "co=cos"], id="two letters"),
        pytest.param(["a = a", "--slash", "none"], id="no such slash"),
    ],
)
def test_a_wrong_command_is_bad_input(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as stop:
        cli.main(["check", *arguments])
    out, err = capsys.readouterr()
    assert (stop.value.code, out) == (2, "")
    assert err.startswith("usage: omniproof")


def test_engines_that_disagree_end_with_status_4(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def disagree(*_args: object, **_options: object) -> None:
        raise DisagreementError("flint: zero, modular: not zero")

    monkeypatch.setattr("omniproof.audit.check.confirmed_equal", disagree)
    assert check(capsys, "--json", "a = a") == (
        4,
        "",
        "internal error, please report it: "
        "DisagreementError: flint: zero, modular: not zero\n",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("env", "coloured"),
    [
        pytest.param({"TERM": "xterm"}, True, id="terminal"),
        pytest.param({"TERM": "xterm", "NO_COLOR": "1"}, False, id="NO_COLOR"),
        pytest.param({"TERM": "xterm", "NO_COLOR": ""}, True, id="NO_COLOR, but empty"),
        pytest.param({"TERM": "dumb"}, False, id="dumb"),
    ],
)
def test_colour_on_a_terminal(
    env: dict[str, str], coloured: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("NO_COLOR", "TERM"):
        monkeypatch.delenv(name, raising=False)
    for name, value in env.items():
        monkeypatch.setenv(name, value)
    ours, theirs = pty.openpty()
    with os.fdopen(theirs, "w") as terminal:
        monkeypatch.setattr("sys.stdout", terminal)
        assert cli.main(["check", "a = a"]) == 0
    shown = os.read(ours, 10_000).decode()
    os.close(ours)
    verdict = "\x1b[32mVERIFIED\x1b[0m" if coloured else "VERIFIED"
    assert shown.splitlines()[0] == f"{verdict}  a = a"


def test_a_pipe_gets_no_colour_and_its_width(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "40")
    _, out, _ = check(capsys, "a + b + c + d + e_1 + f + g + h = 1")
    assert "\x1b" not in out
    lines = out.splitlines()
    assert lines[:2] == ["ERRATUM  a + b + c + d + e_1 + f + g + h", "    = 1"]
    assert max(map(len, lines)) <= 40


def test_a_pipe_that_is_closed_is_no_failure() -> None:
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run(
        [*COMMAND, "a = 2a"], stdout=writing, stderr=subprocess.PIPE, timeout=120, check=False
    )
    os.close(writing)
    assert (done.returncode, done.stderr) == (1, b"")


@pytest.mark.parametrize(
    ("command", "status", "message"),
    [
        pytest.param('%s "a = a" >&-', 2, "expected an open stdout, found it closed", id="closed"),
        pytest.param('%s "a = a" <&- >&-', 2, "expected an open stdout", id="both closed"),
        pytest.param(
            '%s "a = a" >/dev/full', 2, "cannot write to stdout: No space left", id="full"),
        pytest.param("%s - <&-", 2, "expected an open stdin, found it closed", id="no stdin"),
        pytest.param('%s "a =" 2>/dev/full', 2, "", id="nowhere to say it"),
        pytest.param('%s "a = a" 2>&-', 0, "", id="nothing to say"),
    ],
)  # fmt: skip
def test_streams_of_a_shell(command: str, status: int, message: str) -> None:
    check = shlex.join(COMMAND)
    done = subprocess.run(
        ["/bin/sh", "-c", command % check], capture_output=True, timeout=120, check=False
    )
    assert (done.returncode, done.stderr.decode().startswith(message)) == (status, True)
    assert b"Traceback" not in done.stderr


def test_a_check_imports_no_more_than_it_needs() -> None:
    code = (
        "import sys; from omniproof.cli import main; "
        f"main(['check', {TRUE!r}, '--json']); "
        "print([name for name in ('pydantic', 'yaml', 'numpy', 'pandas', 'matplotlib', 'z3') "
        "if name in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True
    )
    assert done.stderr == "[]\n"
    assert json.loads(done.stdout)["verdict"] == "verified"
