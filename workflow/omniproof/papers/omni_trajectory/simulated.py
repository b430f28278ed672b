"""What the simulated robot says about Tables 3 and 4, as tables; its runs: `simulation.omni_robot`.

The numbers come as the long table of all simulations (model, case, quantity, value, unit), since
chapters show what was recorded and simulate nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

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

ERRORS = ("length_error", "mean_error")
STARTS = ("flying", "standing")

CONTROLS = {
    "length_error_eq_8_9": "length of the path, Eqs. (8) and (9)",
    "mean_error_eq_8_9": "path, Eqs. (8) and (9), by Eq. (17)",
    "length_error_tab_2": "length of the path, speed of Table 2",
    "radius_error_eq_13": "radius, Eq. (13)",
    "centre_error_eq_16": "centre, Eq. (16), in radii",
    "direction_error_eq_14": "first direction, Eq. (14), in degrees",
}
"""What is off in printed formulas, in words; before `_eq` or `_tab`, the same of corrected ones."""


def errors_in_simulation(summary: pd.DataFrame, printed: Mapping[str, str]) -> list[list[str]]:
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
    numbers = _by_case(summary)[error]
    return _short(max(float(numbers[f"{case}-{start}"]) for case in CASES))


def _errors(numbers: pd.DataFrame, case: str) -> Sequence[str]:
    cases = (case.format(start=start) for start in STARTS)
    return [_short(float(numbers[error][case])) for case in cases for error in ERRORS]


def _by_case(summary: pd.DataFrame) -> pd.DataFrame:
    """One row a case of this paper, one column a quantity; raises `KeyError` without any."""
    own = summary[summary["model"] == "omni-robot"]
    if own.empty:
        raise KeyError("no simulation of the robot among the numbers")
    return own.pivot(index="case", columns="quantity", values="value")


def _short(value: float) -> str:
    """Write an error with two digits; below 1/10000 it is noise of the contacts."""
    return f"{value:#.2g}".rstrip(".") if value >= 1e-4 else "< 0.0001"
