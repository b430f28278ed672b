"""Snakemake's display: one line a step while it runs, and the failed step's own message last.

Snakemake's own display prints 15 lines a job, and after the message of a failed step it prints
several more of its own. A logger plugin is the one place from which both can be changed, for
`snakemake` as for `make`. Snakemake keeps its full account in `.snakemake/log`.
"""

from __future__ import annotations

import logging
import sys
from pathlib import Path
from textwrap import shorten
from typing import ClassVar

from snakemake_interface_logger_plugins.base import LogHandlerBase
from snakemake_interface_logger_plugins.common import LogEvent

from omniproof.report.step import failure
from omniproof.visible import visible

SHOWN = ("Nothing to be done", "Report created", "This was a dry-run", "Unlock", "Congratulations")
HIDDEN = ("Exiting because a job execution failed",)
WIDTH = 90


class LogHandler(LogHandlerBase):
    """Print `[3/14] Audit omni-arrangement` per step; on closing, what went wrong."""

    writes_to_stream: ClassVar[bool] = True
    writes_to_file: ClassVar[bool] = False
    has_filter: ClassVar[bool] = True
    has_formatter: ClassVar[bool] = True
    needs_rulegraph: ClassVar[bool] = False

    def __post_init__(self) -> None:
        """Start counting."""
        self._total = 0
        self._started = 0
        self._failed: list[tuple[str, list[str]]] = []
        self._errors: list[str] = []
        self._titles: dict[int, str] = {}

    def emit(self, record: logging.LogRecord) -> None:
        """Print one record, or keep it for the end."""
        fields = record.__dict__
        match fields.get("event"):
            case LogEvent.RUN_INFO:
                jobs = fields["stats"]
                self._total = sum(n for rule, n in jobs.items() if rule not in {"total", "all"})
            case LogEvent.JOB_INFO if fields["rule_name"] != "all":
                self._start(fields["jobid"], fields["rule_msg"] or fields["rule_name"])
                if self.common_settings.dryrun:
                    _say(f"    {shorten(fields['reason'], WIDTH, placeholder=' …')}")
            case LogEvent.JOB_ERROR:
                title = self._titles.get(fields["jobid"], fields["rule_name"])
                self._failed.append((title, list(fields["log"])))
            case LogEvent.ERROR:
                self._errors.append(record.getMessage())
            case None:
                self._plain(record)

    def close(self) -> None:
        """Print what went wrong, once."""
        for title, logs in self._failed:
            _say(f"\nFailed: {title}")
            for log in logs:
                _say(f"{failure(Path(log))}\nLog: {log}")
        if not self._failed:
            for error in self._errors:
                _say(f"\n{error}")
        self._failed, self._errors = [], []
        super().close()

    def _start(self, jobid: int, title: str) -> None:
        self._started += 1
        self._titles[jobid] = title
        width = len(str(self._total))
        _say(f"[{self._started:>{width}}/{self._total}] {title}")

    def _plain(self, record: logging.LogRecord) -> None:
        message = record.getMessage()
        loud = record.levelno >= logging.WARNING and not message.startswith(HIDDEN)
        if loud or message.startswith(SHOWN):
            _say(message)


def _say(text: str) -> None:
    print(visible(text), file=sys.stderr, flush=True)
