"""The frame of a script: log, whole outputs or none, message and status."""

import os
from pathlib import Path
from types import SimpleNamespace

import pytest

from omniproof.report.step import failure, step
from omniproof.transcription.faults import BadInput, Fault


class Files(list):
    """What Snakemake hands over: a list of all files, with names."""

    def __init__(self, **named):
        super().__init__(
            file
            for value in named.values()
            for file in ([value] if isinstance(value, str) else value)
        )
        self.items = named.items


@pytest.fixture
def job(tmp_path):
    """Return a job with a single output and a list of two."""
    out = tmp_path / "out"
    out.mkdir()
    return SimpleNamespace(
        output=Files(one=str(out / "one.txt"), many=[str(out / "a.txt"), str(out / "b.txt")]),
        log=[str(tmp_path / "step.log")],
        folder=out,
    )


def write_all(output):
    for path in (output.one, *output.many):
        path.write_text(path.name)


def write_all_and_fail(job, error):
    with step(job) as output:
        write_all(output)
        raise error


def test_outputs_appear_together(job):
    with step(job) as output:
        write_all(output)
        assert [p for p in job.folder.iterdir() if p.is_file()] == []
    assert sorted(p.name for p in job.folder.iterdir()) == ["a.txt", "b.txt", "one.txt"]


def test_talk_goes_to_the_log(job, capfd):
    with step(job) as output:
        print("from Python")
        os.system("echo from a child")
        write_all(output)
    print("after")
    assert capfd.readouterr().out == "after\n"
    log = Path(job.log[0]).read_text()
    assert sorted(log.splitlines()) == ["from Python", "from a child"]


@pytest.mark.parametrize(
    ("error", "status", "message"),
    [
        pytest.param(
            BadInput([Fault("paper.yaml", 4, 2, "eq:1", "expected a kind, found none", "add it")]),
            2,
            "paper.yaml:4:2: eq:1: expected a kind, found none\n    add it\n1 fault in paper.yaml",
            id="bad input",
        ),
        pytest.param(
            RuntimeError("two engines disagree"), 1, "RuntimeError: two engines disagree", id="bug"
        ),
    ],
)
def test_failure(job, tmp_path, error, status, message):
    (job.folder / "one.txt").write_text("earlier")
    with pytest.raises(SystemExit) as caught:
        write_all_and_fail(job, error)
    log = tmp_path / "step.log"
    assert caught.value.code == status
    assert failure(log) == message
    assert ("Traceback" in log.read_text()) == (status == 1)
    assert [p.read_text() for p in job.folder.iterdir()] == ["earlier"]


def test_promised_output_must_be_written(job, tmp_path):
    with pytest.raises(SystemExit), step(job) as output:
        output.one.touch()
    assert "the step ended without writing" in failure(tmp_path / "step.log")


def test_output_may_be_written_in_place(job):
    with step(job) as output:
        (job.folder / "one.txt").write_text("in place")
        for path in output.many:
            path.touch()
    assert (job.folder / "one.txt").read_text() == "in place"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        pytest.param("a\nb\n", "a\nb", id="a step that was killed"),
        pytest.param("x\n" * 30, "x\n" * 19 + "x", id="only the end of a long log"),
        pytest.param(
            "",
            "The step stopped before it opened its log; its message stands further up.",
            id="empty",
        ),
    ],
)
def test_log_without_message(tmp_path, text, message):
    (tmp_path / "log").write_text(text)
    assert failure(tmp_path / "log") == message
