"""What `omniproof simulate` does: list what there is, run one case, show how far it is.

A failed run names its parameters; `changed` takes them back in, so that it can be seen again.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import TextIO

from omniproof.simulation.case import MODELS, Case, model
from omniproof.simulation.engine import reporting
from omniproof.simulation.engines import PACKAGES, USUAL, require
from omniproof.simulation.files import SUMMARY, csv_text, recording_csv, summary_rows
from omniproof.simulation.names import unknown
from omniproof.transcription.faults import shorten

NEVER_ZERO = frozenset({"duration", "step"})
"""Parameters that time is counted in."""
LONGEST_NUMBER = 30
"""Characters of a number: more are no measurement, and may be beyond what floats reach."""
WIDTH = 30
"""Characters of the bar that shows progress."""


def listing(name: str | None) -> str:
    """Return the cases of a model, or of all, one a line: `omni-robot line-0-flying`."""
    names = MODELS if name is None else [name]
    return "\n".join(f"{one} {case.name}" for one in names for case in model(one).cases)


def simulated(
    name: str, case_name: str, changes: Iterable[str], *, summary: bool, engine: str | None = None
) -> str:
    """Run a case, with `changes` such as `friction=0.1`; return its recording or summary as CSV.

    `engine` is another one than the case names. Talks to stderr. Raises `UnknownNameError`,
    `MissingEngineError`, `ImplausibleRunError`, and `ValueError` for a value that is no number and
    a model that only one engine can run.
    """
    found = model(name)
    case = changed(found.case(case_name), changes)
    if engine:
        case = on_engine(case, engine)
    with _bar(f"{name} {case_name}", sys.stderr):
        recording = found.simulate(case)
    if not summary:
        return recording_csv(recording)
    return csv_text(SUMMARY, summary_rows(found, case, recording))


def changed(case: Case, changes: Iterable[str]) -> Case:
    """Return a case with other parameters, each written `name=value`."""
    parameters = dict(case.parameters)
    for change in changes:
        name, equals, value = change.partition("=")
        if not equals or name not in parameters:
            raise unknown("parameter as name=value", name, parameters)
        parameters[name] = _like(parameters[name], name, value)
    return replace(case, parameters=parameters)


def _like(usual: float | str, name: str, text: str) -> float | str:
    """Read a parameter of the kind that it has: words, or a number (no size is negative)."""
    if isinstance(usual, str):
        return text
    try:
        number = type(usual)(text if len(text) <= LONGEST_NUMBER else "too long")
    except ValueError:
        number = math.nan
    if math.isfinite(number) and not number < 0 < usual and (number or name not in NEVER_ZERO):
        return number
    above = "above 0" if name in NEVER_ZERO else "from 0 on"
    wanted = "a number" if math.isnan(number) or usual <= 0 else f"a finite number {above}"
    raise ValueError(f"expected {wanted} for {name}, found {shorten(text)}")


def on_engine(case: Case, engine: str) -> Case:
    """Return a case as another engine is to run it."""
    require(engine)
    if "engine" in case.parameters:
        return changed(case, [f"engine={engine}"])
    if engine != USUAL:
        raise ValueError(
            f"expected the engine {USUAL!r} for {case.model}, found {engine!r}\n    its contacts"
            f" are those of {USUAL} alone; omni-robot runs on {' and '.join(PACKAGES)}"
        )
    return case


@contextmanager
def _bar(title: str, stream: TextIO) -> Iterator[None]:
    """Show on a terminal how much of a run is done; elsewhere, that it is done."""
    shown = -1

    def show(share: float) -> None:
        nonlocal shown
        percent = round(100 * share)
        if percent != shown:
            shown = percent
            full = "#" * round(WIDTH * share)
            stream.write(f"\r{title} [{full:<{WIDTH}}] {percent:3d} %")
            stream.flush()

    if not stream.isatty():
        yield
        print(f"{title}: done", file=stream)
        return
    with reporting(show):
        try:
            yield
        finally:
            stream.write("\n")
