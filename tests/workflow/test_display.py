"""The display: one line a step, the failed step's message last."""

import logging
from types import SimpleNamespace

import pytest
from snakemake_interface_logger_plugins.common import LogEvent

from snakemake_logger_plugin_steps import LogHandler


def record(event=None, message="", level=logging.INFO, **fields):
    made = logging.LogRecord("snakemake", level, "", 0, message, None, None)
    made.__dict__.update(event=event, **fields)
    return made


def started(number, rule="audit", title="Audit one-wheel", reason="new"):
    return record(LogEvent.JOB_INFO, jobid=number, rule_name=rule, rule_msg=title, reason=reason)


def shown(capsys, *records, dryrun=False):
    """Return what is printed for records, and at the end."""
    handler = LogHandler(SimpleNamespace(dryrun=dryrun), None)
    for one in records:
        handler.emit(one)
    handler.close()
    return capsys.readouterr().err


PLAN = record(LogEvent.RUN_INFO, stats={"audit": 9, "book": 1, "all": 1, "total": 11})


@pytest.mark.parametrize(
    ("records", "text"),
    [
        pytest.param([PLAN, started(4)], "[ 1/10] Audit one-wheel\n", id="a step"),
        pytest.param([PLAN, started(0, rule="all")], "", id="the target is no step"),
        pytest.param([PLAN, started(4, title=None)], "[ 1/10] audit\n", id="a rule without title"),
        pytest.param([record(message="Building DAG of jobs...")], "", id="chatter"),
        pytest.param(
            [record(message="Nothing to be done (…).")], "Nothing to be done (…).\n", id="no-op"
        ),
        pytest.param(
            [record(message="disk is full", level=logging.WARNING)],
            "disk is full\n",
            id="a warning",
        ),
        pytest.param(
            [record(LogEvent.ERROR, "no rule makes x")], "\nno rule makes x\n", id="no step failed"
        ),
    ],
)
def test_line(capsys, records, text):
    assert shown(capsys, *records) == text


def test_dry_run_gives_reasons(capsys):
    text = shown(capsys, PLAN, started(4, reason="missing " + "x " * 99), dryrun=True)
    assert text.splitlines()[1].startswith("    missing x x")
    assert max(map(len, text.splitlines())) <= 100


def test_message_of_the_failed_step_is_last(capsys, tmp_path):
    log = tmp_path / "audit.log"
    log.write_text("much talk\n---- message ----\npaper.yaml:1:1: expected a key\n")
    text = shown(
        capsys,
        PLAN,
        started(4),
        record(LogEvent.ERROR, "RuleException: CalledProcessError in file …"),
        record(LogEvent.JOB_ERROR, jobid=4, rule_name="audit", log=[str(log)]),
        record(message="Exiting because a job execution failed.", level=logging.ERROR),
        record(LogEvent.ERROR, "WorkflowError: At least one job did not complete successfully."),
    )
    assert text == (
        "[ 1/10] Audit one-wheel\n\n"
        f"Failed: Audit one-wheel\npaper.yaml:1:1: expected a key\nLog: {log}\n"
    )
