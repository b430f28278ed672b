"""What the simulated robot says about Tables 3 and 4, as tables; its runs: `simulation.omni_robot`.

The numbers come as the long table of all simulations (model, case, quantity, value, unit), since
chapters show what was recorded and simulate nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import pandas as pd

CASES = {
    "circle-left": ("circle, left", "tab:3/error-left", "sec:3.2/error-left"),
    "circle-clockwise": ("circle, clockwise", "tab:3/error-clockwise", "sec:3.2/error-clockwise"),
    "line-0": ("line, 0°", "tab:4/error-0", "sec:3.2/error-0"),
    "line-30": ("line, 30°", "tab:4/error-30", "sec:3.2/error-30"),
    "line-60": ("line, 60°", "tab:4/error-60", "sec:3.2/error-60"),
    "line-90": ("line, 90°", "tab:4/error-90", "sec:3.2/error-90"),
}
"""Cases in words, and the claims that print their errors: in a table, and in the text."""

VARIATIONS: Mapping[str, str] = {
    "": "as it is",
    "-half-step": "half the time step",
    "-harder": "contacts that settle in 2 ms for 4 ms",
    "-softer": "contacts that settle in 8 ms for 4 ms",
    "-slippery": "friction 0.1 for 0.5",
    "-rough": "friction 1 for 0.5",
    "-two-rows": "rollers in two rows",
    "-36-rollers": "36 rollers for 18",
    "-heavy": "body of 5 kg for 1 kg",
}
"""What is changed, one thing at a time, by the end of the case's name."""

STARTS = ("flying", "standing")

SETUPS: Mapping[str, str] = {
    "": "printed rates, $L$ of Table 1",
    "-body-86-mm": "printed rates, $L$ of Section 3.1",
    "-speed-22-mm": "rates cut to the speed of Table 2, $L$ of Table 1",
}
"""Printed set-ups that contradict each other, by the end of the case's name."""

ENGINES = ("engine, start", "radius, mm", "turn, degrees", "length", "Eq. (17)")
"""Heads of `engines_in_simulation`."""

MEASURES = {"length_error": "length", "mean_error": "Eq. (17)"}
PLACES = ("table", "text")
Printed = Mapping[str, str]
"""Errors as printed, by claim."""

CONTROLS = {
    "length_error_eq_8_9": "length of the path, Eqs. (8) and (9)",
    "mean_error_eq_8_9": "path, Eqs. (8) and (9), by Eq. (17)",
    "length_error_tab_2": "length of the path, speed of Table 2",
    "radius_error_eq_13": "radius, Eq. (13)",
    "centre_error_eq_16": "centre, Eq. (16), in radii",
    "direction_error_eq_14": "first direction, Eq. (14), in degrees",
}
"""What is off in printed formulas, in words; before `_eq` or `_tab`, the same of corrected ones."""


def errors_in_simulation(summary: pd.DataFrame, printed: Printed) -> list[list[str]]:
    """Errors of each case: printed in the table, in the text; ours for both starts.

    `printed` are the printed errors by claim. Ours: |1 - L_e/L_m| and Eq. (17), flying; standing.
    """
    numbers = _by_case(summary)
    return [
        [words, printed[table], printed[text], *_errors(numbers, f"{case}-{{start}}")]
        for case, (words, table, text) in CASES.items()
    ]


def controls_in_simulation(summary: pd.DataFrame) -> list[list[str]]:
    """Greatest error of each corrected formula, least of the printed one, flying start."""
    numbers = _by_case(summary)
    flying = numbers.loc[[f"{case}-flying" for case in CASES]]
    rows = []
    for quantity, words in CONTROLS.items():
        corrected = quantity.split("_eq_")[0].split("_tab_")[0]
        compared = flying[flying[quantity].notna()]
        most, least = max(compared[corrected]), min(compared[quantity])
        rows.append([words, _short(most), _short(least)])
    return rows


def worst(summary: pd.DataFrame, error: str, start: str) -> str:
    """Return the greatest `error` of all printed cases with one `start`."""
    return _short(max(_of_cases(_by_case(summary), error, start).values()))


def agreement(summary: pd.DataFrame, printed: Printed) -> list[list[str]]:
    """What each start and measure gives: in words, from least to greatest, how many are printed.

    A number counts as printed where it rounds to the digits that stand there: in the table, in the
    text.
    """
    numbers = _by_case(summary)
    rows = []
    for start in STARTS:
        for error, words in MEASURES.items():
            found = _of_cases(numbers, error, start)
            alike = (_alike(found, printed, place) for place in PLACES)
            rows.append([f"{start}, {words}", _span(found.values()), *alike])
    return rows


def setups_in_simulation(summary: pd.DataFrame, printed: Printed) -> list[list[str]]:
    """The printed set-ups: words, speed, turn of the left circle, and Eq. (17) standing.

    Of the latter the least and the greatest, and how many are printed in the text.
    """
    numbers = _by_case(summary)
    rows = []
    for setup, words in SETUPS.items():
        speeds = _of_cases(numbers, "speed", "flying", setup)
        errors = _of_cases(numbers, "mean_error", "standing", setup)
        turn = f"{numbers['turn'][f'circle-left-flying{setup}']:.0f}°"
        alike = _alike(errors, printed, "text")
        rows.append([words, _span(speeds.values()), turn, _span(errors.values()), alike])
    return rows


def engines_in_simulation(summary: pd.DataFrame) -> list[list[str]]:
    """The left circle by both engines, from both starts: `ENGINES`; a dash where one is missing."""
    numbers = _by_case(summary).to_dict("index")
    rows = []
    for start in STARTS:
        for engine, words in {"": "MuJoCo", "-drake": "Drake"}.items():
            found = numbers.get(f"circle-left-{start}{engine}")
            cells = _engine_cells(found) if found else ["—"] * 4
            rows.append([f"{words}, {start}", *cells])
    return rows


def _engine_cells(found: Mapping[Any, float]) -> list[str]:
    radius, turn = f"{1000 * found['radius']:.1f}", f"{found['turn']:.1f}"
    return [radius, turn, *(_short(found[error]) for error in MEASURES)]


def off_printed_speed(summary: pd.DataFrame) -> str:
    """Return the least error of a length by the speed of Table 2, at the printed rates."""
    found = _of_cases(_by_case(summary), "length_error_tab_2", "flying")
    return _short(min(found.values()))


def off_mixed_radii(summary: pd.DataFrame) -> str:
    """Return the least Eq. (17) of a robot with one printed radius, a theory with the other."""
    numbers = _by_case(summary)["mean_error_other_body"]
    setups = (name for name in SETUPS if "speed" not in name)
    cases = (f"{case}-{start}{setup}" for setup in setups for case in CASES for start in STARTS)
    return _short(min(float(numbers[case]) for case in cases if numbers.notna().get(case, False)))


def most_sensitive(summary: pd.DataFrame, error: str, start: str) -> tuple[str, str]:
    """Return which change gives the greatest error of the clockwise circle, and that error."""
    numbers = _by_case(summary)[error]
    found = {
        words: float(numbers[f"circle-clockwise-{start}{name}"])
        for name, words in VARIATIONS.items()
    }
    words = max(found, key=found.__getitem__)
    return words, _short(found[words])


def printed_path_off(summary: pd.DataFrame) -> str:
    """Return the least error of the lengths that Eqs. (8) and (9) give as printed."""
    return _short(min(_of_cases(_by_case(summary), "length_error_eq_8_9", "flying").values()))


def _of_cases(
    numbers: pd.DataFrame, quantity: str, start: str, setup: str = ""
) -> Mapping[str, float]:
    """A quantity of all cases of Tables 3 and 4 that were run with a start and a set-up."""
    names = {case: f"{case}-{start}{setup}" for case in CASES}
    return {
        case: float(numbers[quantity][name])
        for case, name in names.items()
        if name in numbers.index
    }


def _alike(found: Mapping[str, float], printed: Printed, place: str) -> str:
    """Say how many numbers round to what is printed at a place, such as `2 of 6`."""
    claims = {case: printed[CASES[case][1 + PLACES.index(place)]] for case in found}
    same = [
        f"{value:.{len(claims[case].partition('.')[2])}f}" == claims[case]
        for case, value in found.items()
    ]
    return f"{sum(same)} of {len(same)}"


def _span(values: Iterable[float]) -> str:
    """Write the least and the greatest of some numbers, or the one that all are."""
    found = list(values)
    return " to ".join(dict.fromkeys(_short(end) for end in (min(found), max(found))))


def _errors(numbers: pd.DataFrame, case: str) -> Sequence[str]:
    cases = (case.format(start=start) for start in STARTS)
    return [_short(float(numbers[error][case])) for case in cases for error in MEASURES]


def _by_case(summary: pd.DataFrame) -> pd.DataFrame:
    """One row a case of this paper, one column a quantity; raises `KeyError` without any."""
    own = summary[summary["model"] == "omni-robot"]
    if own.empty:
        raise KeyError("no simulation of the robot among the numbers")
    return own.pivot(index="case", columns="quantity", values="value")


def _short(value: float) -> str:
    """Write an error with two digits; below 1/10000 it is noise of the contacts."""
    return f"{value:#.2g}".rstrip(".") if value >= 1e-4 else "< 0.0001"
