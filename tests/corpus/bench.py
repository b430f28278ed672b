"""`make bench`: our decision against other systems on the corpus, to engine.csv and engine.json.

Times depend on the machine and stay out of all pages. The ratio of two systems is taken on the rows
that both decide rightly: the median of the rows, and the total of all. Rows that are settled when
their sides are built (SymPy makes them alike) are no decisions; they are left out and named.
"""

from __future__ import annotations

import argparse
import csv
import json
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from elimination import elimination_times
from questions import ask
from rivals import EASY, OURS, SYSTEMS, TIME_OUT, Timed, timed

from corpus import FILE, Record, load


@dataclass(frozen=True)
class Row:
    """One record, and what each system said of it."""

    id: str
    expected: str
    answers: Mapping[str, Timed]
    settled: bool = False

    def right(self, system: str) -> bool:
        """Whether a system was asked, and said what mathematics says."""
        return system in self.answers and self.answers[system].said == self.expected

    def ratio(self, ours: str, system: str) -> float:
        """Return how many times longer a system took than we did."""
        return self.answers[system].seconds / self.answers[ours].seconds


@dataclass(frozen=True)
class Comparison:
    """Ratios on the rows that both decide rightly; 0 where there are none."""

    rows: int
    median: float
    total: float


def measure(record: Record, systems: Sequence[str], time_out: float) -> Row:
    """Ask all systems one record; only ours are asked relations other than equations."""
    question = ask(record)
    asked = [name for name in systems if question.is_equation or name in OURS]
    answers = {name: timed(name, question, time_out) for name in asked}
    return Row(record.id, record.expected, answers, question.is_settled)


def compare(rows: Sequence[Row], ours: str, system: str) -> Comparison:
    """Compare two systems on the rows that both decide rightly."""
    decisions = [row for row in rows if not row.settled]
    both = [row for row in decisions if row.right(ours) and row.right(system)]
    if not both:
        return Comparison(0, 0.0, 0.0)
    spent = [sum(row.answers[name].seconds for row in both) for name in (system, ours)]
    median = statistics.median(row.ratio(ours, system) for row in both)
    return Comparison(len(both), median, spent[0] / spent[1])


def only_ours(rows: Sequence[Row]) -> list[str]:
    """Return the ids of the equations that we decide rightly and no other system does."""
    return [
        row.id
        for row in rows
        if any(row.right(name) for name in OURS)
        and not any(row.right(name) for name in row.answers if name not in OURS)
        and len(row.answers) > len(OURS)
    ]


def report(rows: Sequence[Row], time_out: float) -> dict[str, object]:
    """Gather everything in one object for engine.json."""
    rivals = [name for name in SYSTEMS if name not in OURS]
    found = ("proved", "refuted", "branch")
    return {
        "method": __doc__,
        "time_out_seconds": time_out,
        "rows": len(rows),
        "right": {name: sum(row.right(name) for row in rows) for name in SYSTEMS},
        "wrong": {
            name: sum(
                row.answers[name].said in found and not row.right(name)
                for row in rows
                if name in row.answers
            )
            for name in SYSTEMS
        },
        "ratios": {
            ours: {name: asdict(compare(rows, ours, name)) for name in rivals} for ours in OURS
        },
        "only_ours": only_ours(rows),
        "settled": [row.id for row in rows if row.settled],
        "elimination_seconds": elimination_times(),
    }


def write(rows: Sequence[Row], summary: Mapping[str, object], folder: Path) -> None:
    """Write engine.csv and engine.json."""
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "engine.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["id", "expected", "system", "said", "seconds"])
        for row in rows:
            for name, answer in row.answers.items():
                writer.writerow([row.id, row.expected, name, answer.said, f"{answer.seconds:.6f}"])
    text = json.dumps(summary, indent=1)
    (folder / "engine.json").write_text(text + "\n", encoding="utf-8")


def table(rows: Sequence[Row], ours: str = OURS[0]) -> str:
    """Write a short summary: how many rows each system decides, and the ratios to ours."""
    lines = [f"{'system':10} {'right':>6} {'seconds':>8} {'median':>8} {'total':>8}"]
    for name in SYSTEMS:
        right = sum(row.right(name) for row in rows)
        spent = sum(row.answers[name].seconds for row in rows if name in row.answers)
        ratio = compare(rows, ours, name)
        lines.append(f"{name:10} {right:6} {spent:8.2f} {ratio.median:7.1f}x {ratio.total:7.1f}x")
    return "\n".join(lines)


def main(arguments: Sequence[str] | None = None) -> None:
    """Measure all records and write the results."""
    parser = argparse.ArgumentParser(description="Compare our decision with other systems.")
    parser.add_argument("folder", type=Path, help="where engine.csv and engine.json go")
    parser.add_argument("--corpus", type=Path, default=FILE)
    parser.add_argument("--time-out", type=float, default=TIME_OUT, help="seconds a row")
    options = parser.parse_args(arguments)
    records = load(options.corpus)
    for system in SYSTEMS.values():
        system(EASY)  # what is imported on the way is there for all
    rows = [measure(record, tuple(SYSTEMS), options.time_out) for record in records]
    summary = report(rows, options.time_out)
    write(rows, summary, options.folder)
    print(f"{len(rows)} rows, time-out {options.time_out:g} s, ratios on the rows both decide")
    print(table(rows))
    print(f"only ours: {len(only_ours(rows))}; elimination: {summary['elimination_seconds']}")


if __name__ == "__main__":
    main()
