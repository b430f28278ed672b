"""The sensitivity study in full: `make bench`, to results/benchmarks/simulation/sensitivity.csv.

`make` varies one path, one value each way. Here whatever the paper does not say goes over its
range, one thing at a time (the number of rollers with that of rows), on four paths and from both
starts. The other two lines of Table 4 are these, seen in a mirror. A run that is not plausible is a
result of the study: its row says why, and has no numbers.

Times depend on the machine and stay out of all pages.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path
from time import perf_counter

from omniproof.simulation.case import Case
from omniproof.simulation.engine import NO_PARAMETERS, ImplausibleRunError, Parameters
from omniproof.simulation.engines import PACKAGES, USUAL, is_installed
from omniproof.simulation.files import csv_text
from omniproof.simulation.omni_robot import MODEL, STARTS

PATHS = ("circle-left", "circle-clockwise", "line-0", "line-30")

RANGES: Mapping[str, Sequence[float]] = {
    "step": (1.25e-4, 2.5e-4, 5e-4, 1e-3),
    "contact_time": (2e-3, 3e-3, 4e-3, 6e-3, 8e-3, 16e-3),
    "friction": (0.05, 0.1, 0.2, 0.3, 0.5, 0.8, 1.0),
    "mass": (0.5, 1.0, 2.0, 5.0, 10.0),
}
"""Time step (s), time constant of the contacts (s), Coulomb friction, mass of the body (kg)."""

ROLLERS, ROWS = (12, 18, 24, 36), (1, 2)
STEPS_ELSEWHERE = (5e-4, 1e-3)
"""Time steps (s) with another engine."""

VARIED = ("engine", *RANGES, "rollers", "rows")
ERRORS = ("length_error", "mean_error")
COLUMNS = ("path", "start", *VARIED, *ERRORS, "seconds", "fault")


def study() -> Iterator[Case]:
    """Yield all cases: of each path and start the one of Tables 3 and 4, then its variations."""
    for path, start in product(PATHS, STARTS):
        usual = MODEL.case(f"{path}-{start}")
        for changed in (NO_PARAMETERS, *_variations(usual.parameters)):
            yield replace(usual, parameters={**usual.parameters, **changed})


def _variations(usual: Parameters) -> Iterator[Parameters]:
    """Yield what is changed in turn; no variation is the usual case again."""
    for name, values in RANGES.items():
        yield from ({name: value} for value in values if value != usual[name])
    for rollers, rows in product(ROLLERS, ROWS):
        if (rollers, rows) != (usual["rollers"], usual["rows"]):
            yield {"rollers": rollers, "rows": rows}
    for engine in PACKAGES:
        if engine != USUAL and is_installed(engine):
            for step in STEPS_ELSEWHERE:
                yield {"engine": engine, "step": step}


def measured(case: Case) -> Mapping[str, str]:
    """Run a case: errors (three digits) and wall time (s), or what was not plausible."""
    start, found = perf_counter(), {}
    try:
        summary = MODEL.summarise(case, MODEL.simulate(case))
        found = {error: f"{summary[error]:.3g}" for error in ERRORS}
    except ImplausibleRunError as error:
        found["fault"] = error.reason
    return {**found, "seconds": f"{perf_counter() - start:.2f}"}


def table(cases: Sequence[Case]) -> Iterator[list[str]]:
    """Yield a row a case, in the order of `COLUMNS`, and tell the terminal how far it is."""
    for number, case in enumerate(cases, 1):
        path = next(path for path in PATHS if case.name.startswith(path))
        row = {**{name: f"{value}" for name, value in case.parameters.items()}, "path": path}
        row |= measured(case)
        print(f"\rsensitivity: {number} of {len(cases)} runs", end="", file=sys.stderr, flush=True)
        yield [row.get(column, "") for column in COLUMNS]
    print(file=sys.stderr)


def write(file: Path, cases: Iterable[Case]) -> None:
    """Run cases and write their table."""
    for engine in PACKAGES:
        if not is_installed(engine):
            print(f"sensitivity: without {engine}, which is not installed", file=sys.stderr)
    rows = list(table(list(cases)))
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(csv_text(COLUMNS, rows), encoding="utf-8", newline="")


if __name__ == "__main__":
    write(Path(sys.argv[1]), study())
