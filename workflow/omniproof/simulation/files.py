"""Simulations as files: a recording a case, the numbers of all cases in one long table, the times.

Numbers are cut to what another machine would give too: the last bits of a run belong to the release
of MuJoCo and to the processor. Recordings keep six digits: what a figure shows of a path of 15 cm
is how far it is from the theory's, a tenth of a millimetre, and that may not be made of steps.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from time import perf_counter

from omniproof.simulation.case import Case, Model, model
from omniproof.simulation.engine import Recording

SUMMARY = ("model", "case", "quantity", "value", "unit")
TIMES = ("case", "seconds")


def recording_csv(recording: Recording) -> str:
    """Write a recording: time (s, exact) and columns (SI units, six digits)."""
    columns = recording.columns
    rows = (
        [f"{time:.6g}", *(f"{columns[name][k]:.6g}" for name in columns)]
        for k, time in enumerate(recording.time)
    )
    return csv_text(["time", *columns], rows)


def summary_rows(found: Model, case: Case, recording: Recording) -> Iterator[tuple[str, ...]]:
    """Yield what a model reads off a recording, as rows of the long table (three digits)."""
    for quantity, value in found.summarise(case, recording).items():
        yield case.model, case.name, quantity, f"{value:.3g}", found.units[quantity]


def write_model(name: str, cases: Mapping[str, Path], numbers: Path, times: Path) -> None:
    """Run the named `cases` of a model; write a recording each, their numbers and wall times.

    Raises `UnknownNameError` for a case that the model does not have, and `ImplausibleRunError`.
    """
    found = model(name)
    rows: list[tuple[str, ...]] = []
    seconds = []
    for case in map(found.case, cases):
        start = perf_counter()
        recording = found.simulate(case)
        seconds.append((case.name, f"{perf_counter() - start:.2f}"))
        _write(cases[case.name], recording_csv(recording))
        rows += summary_rows(found, case, recording)
    _write(numbers, csv_text(SUMMARY, rows))
    _write(times, csv_text(TIMES, seconds))


def write_summary(parts: Iterable[Path], summary: Path) -> None:
    """Join the numbers of all models in one table."""
    rows: list[list[str]] = []
    for part in parts:
        with part.open(encoding="utf-8", newline="") as stream:
            rows += list(csv.reader(stream))[1:]
    _write(summary, csv_text(SUMMARY, rows))


def csv_text(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Write a table as CSV."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([head, *rows])
    return text.getvalue()


def _write(file: Path, text: str) -> None:
    file.write_text(text, encoding="utf-8", newline="")
